"""Habitat: a scene dataset of one house, as AI Habitat's simulator reads it. The frame is the scene's own: y up, m, rotations w first.

A GLB for the walls, floors and ceilings (the stage), one for each look and size of a body, and what they weigh beside it; bodies are named
under `user_defined`. Doors stand open and are plain things: hinges would need a URDF each. Garage doors are shut.
"""

import json
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from math import cos, radians, sin
from typing import Any, Final, NamedTuple

from solver.body_parts import BodyPart
from solver.exports.formats import glb
from solver.exports.formats.glb_book import GltfBook, geometry_of
from solver.exports.model import DoorLeaf, HouseModel, ModelBody, Paint
from solver.exports.paints import by_paint
from solver.exports.solid_meshes import joined, surface_of
from solver.exports.writers import ExportSettings, Files
from solver.free_names import FreeNames

_MOTION: Final = {"furniture": "STATIC", "decoration": "STATIC", "dynamic": "KINEMATIC"}
_UPRIGHT: Final = {"up": [0, 1, 0], "front": [0, 0, -1]}
"""How Habitat takes an asset as it is."""
HabitatJson = dict[str, Any]


def write(model: HouseModel, _: ExportSettings) -> Files:
    """Writes `<house>.scene_dataset_config.json` and the folders it names: `stages`, `objects`, `scenes`."""
    shell = replace(model, bodies=(), leaves=())
    (stage,) = glb.write(shell, ExportSettings("glb")).values()
    objects = _Objects()
    instances = [objects.placed(body) for body in model.bodies] + [objects.hung(leaf) for leaf in model.leaves]
    name = model.name
    dataset = {
        "stages": {"paths": {".json": ["stages"]}},
        "objects": {"paths": {".json": ["objects"]}},
        "scene_instances": {"paths": {".json": ["scenes"]}},
    }
    scene = {
        "stage_instance": {"template_name": f"stages/{name}", "translation_origin": "asset_local"},
        "translation_origin": "asset_local",
        "object_instances": instances,
        "user_defined": {"warnings": "\n".join(model.warnings)},
    }
    return {
        f"{name}.scene_dataset_config.json": _text(dataset),
        f"stages/{name}.glb": stage,
        f"stages/{name}.stage_config.json": _text({"render_asset": f"{name}.glb", **_UPRIGHT}),
        f"scenes/{name}.scene_instance.json": _text(scene),
        "semantic_lexicon.json": _text({"classes": [{"id": number, "name": word} for word, number in objects.classes.items()]}),
        **objects.files,
    }


class _ObjectLook(NamedTuple):
    """What a template says of its object: a name, the semantic class, kg, and the coefficient of friction."""

    name: str
    category: str
    mass: float
    friction: float


class _Objects:
    """The objects of one house, each look, size and mass once."""

    def __init__(self) -> None:
        self.files: Files = {}
        self.classes: dict[str, int] = {}
        """Numbers of the semantic classes, from 1."""
        self._names = FreeNames(r"[^A-Za-z0-9_-]")
        self._known: dict[tuple[object, ...], str] = {}

    def placed(self, body: ModelBody) -> HabitatJson:
        """Returns a body's instance; its origin is the middle of its footprint at its underside."""
        size = [round(value, 6) for value in (body.width, body.height, body.depth)]
        key = (body.shape, body.paints, *size, body.mass, body.friction, body.category)
        look = _ObjectLook(body.kind or body.name, body.category, body.mass, body.friction)
        at = (body.x, body.y, body.z)
        motion = _MOTION[body.sort] if body.fixed else "DYNAMIC"
        says: HabitatJson = {"id": body.id, "name": body.name, "category": body.category, "sort": body.sort, "room": body.room or ""}
        return _instance(
            self._template(key, look, body.parts, body.paints), at, body.turn, motion, says | {"parent": body.parent or "", "size": size}
        )

    def hung(self, leaf: DoorLeaf) -> HabitatJson:
        """Returns a leaf's instance: open where it swings, shut where it rolls."""
        (x, z), y = leaf.middle(leaf.wide_open), leaf.hinge[1]
        template = self._template((leaf.parts, leaf.paints), _ObjectLook(leaf.look, "door", leaf.mass, 0.6), leaf.parts, leaf.paints)
        says: HabitatJson = {"id": leaf.id, "name": leaf.look, "category": "door", "sort": "leaf", "closed": round(leaf.closed, 6)}
        return _instance(template, (x, y, z), leaf.wide_open, "KINEMATIC", says | {"swing": leaf.swing if leaf.motion == "swing" else 0.0})

    def _template(self, key: tuple[object, ...], look: _ObjectLook, parts: Sequence[BodyPart], paints: Sequence[Paint]) -> str:
        """Returns the name of a look's template, whose files are written where it is new."""
        if key not in self._known:
            name = self._known[key] = self._names.take(look.name[:60])
            self.files[f"objects/{name}.glb"] = _asset(name, tuple(parts), tuple(paints))
            number = self.classes.setdefault(look.category, len(self.classes) + 1)
            says = {"mass": look.mass, "friction_coefficient": look.friction, "semantic_id": number}
            self.files[f"objects/{name}.object_config.json"] = _text({"render_asset": f"{name}.glb", **_UPRIGHT, **says})
        return self._known[key]


def _instance(template: str, at: tuple[float, float, float], turn: float, motion: str, says: HabitatJson) -> HabitatJson:
    half = radians(turn % 360.0) / 2
    return {
        "template_name": f"objects/{template}",
        "translation": [round(value, 6) + 0.0 for value in at],
        "rotation": [round(cos(half), 9), 0.0, round(sin(half), 9), 0.0],
        "motion_type": motion,
        "user_defined": says,
    }


@lru_cache(maxsize=2048)
def _asset(name: str, parts: tuple[BodyPart, ...], paints: tuple[Paint, ...]) -> bytes:
    """Returns a GLB of parts in metres, around the middle of the footprint at the underside."""
    book = GltfBook()
    mesh = book.mesh(name, [(geometry_of(joined(map(surface_of, some))), paint) for paint, some in by_paint(parts, paints).items()])
    return book.file(book.node(f'{{"name":"{name}","mesh":{mesh}}}'), (), "null")


def _text(document: HabitatJson) -> bytes:
    return (json.dumps(document).replace('{"template_name"', '\n{"template_name"') + "\n").encode()
