"""Every sentence that a refusal or an import can say is said in German too: those of the sources, and those of many documents.

Those of broken and hostile files are asked of where these are read: in imports/test_hostile_files.py.
"""

from __future__ import annotations

import ast
import random
from copy import deepcopy
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from catalogs import load_catalogs
from service.contract import DragBody, ExplainBody, ExportBody, FixBody, FloorBody, FurnishBody, ImportBody, PlaceBody, RerollBody
from service.problems import ALL_STATUS
from solver import Request, Scene, generate
from solver.errors import ComposeError
from solver.exchange import read, read_request, write_scene
from solver.export_formats import EXPORTERS
from tests.imports import plans
from tests.imports.test_round_trips import again
from tests.sweeps import seeds
from tests.told_answers import untold_in_import, untold_in_refusal
from tests.told_forms import is_told
from tests.told_sources import NAME, NUMBER, Place, Source, sources, told_at, told_under

ROOT = Path(__file__).parents[1]
AT_START = ("dataset", "many", "commands", "command_files", "cli", "service_settings", "keys", "pool", "admitting", "kept_contract")
"""Parts of the service that are not heard through it: commands, what stops its start, and types of which no field is refused."""
CLASSES = [kind.__name__ for kind in ALL_STATUS] + ["RequestError", "SceneError"]
PLACES = [
    *(Place(name, (1, 2)) for name in CLASSES if name != "SyntaxFault"),
    Place("SyntaxFault", (0,)), Place("located", (0, 1)), Place("Wrong", (0, 1)), Place("Says", (0,)), Place("_refused", (1, 3, 4)),
    Place("Unread", (0, 1)), Place("ChosenEntrance", (2,)), Place("problem", (1,)),
    Place("change", (1, 3), ast.Attribute), Place("guess", (0, 1, 2, 3), ast.Attribute), Place("leave", (0, 1), ast.Attribute),
]  # fmt: skip
"""Where a refusal, an import's note or a key's description is made, and which of the arguments a person reads."""


def modules() -> dict[str, Source]:
    found = sources(ROOT, ["solver", "service"])
    return {name: module for name, module in found.items() if not (name.startswith("service.") and name.split(".")[1] in AT_START)}


def untold_way(texts: list[str]) -> bool:
    """Tells whether none of the ways that a text can be is told: a hole may hold a number or a word, its form says which."""
    by_way: dict[str, bool] = {}
    for text in texts:
        way = text.replace(NAME, NUMBER)
        by_way[way] = by_way.get(way, False) or is_told(text)
    return not all(by_way.values())


def test_every_sentence_of_the_sources_has_a_form() -> None:
    found = [*told_at(modules().values(), PLACES), *told_under(modules().values(), ("problem", "allowed"))]
    read_whole = [(where, texts) for where, texts in found if texts is not None]
    assert len(read_whole) > 300
    assert [(where, texts) for where, texts in read_whole if untold_way(texts)] == []


def test_every_title_has_a_form() -> None:
    assert [title for _, title in ALL_STATUS.values() if not is_told(title)] == []


def test_what_catalogs_say_of_themselves_has_a_form() -> None:
    known = load_catalogs()
    said = [*(one.description for one in known.presets.values()), *(one.description for one in known.access.values())]
    assert len(said) >= 7
    assert [one for one in said if not is_told(one)] == []


def test_what_every_export_is_for_has_a_form() -> None:
    assert [exporter.words for exporter in EXPORTERS.values() if not is_told(exporter.words)] == []


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
def test_files_of_other_programs_are_told(format: str) -> None:
    assert untold_in_import(again("family", format), PIECES) == []


NAMES = ["Kitchen", "Bedroom", "Küche", "Room 7", "Salon, small", "Balcony", "Garage", "", "Flur and bath", "x: y"]
PIECES = ["Lit double", "Sofa", "plant", "Throne of 2", "cat", "dining table", ""]


def drawn(seed: int) -> dict[str, Any]:
    """A row of rooms, drawn carelessly, with openings that may miss their walls and furniture that may not fit."""
    draw = random.Random(seed)

    def shaken(x: float, y: float) -> tuple[float, float]:
        return x + draw.choice((0, 0, 0.004, 0.03, 0.5)), y + draw.choice((0, 0, 0.01, 0.04))

    features, x = [], 0.0
    for _ in range(draw.randint(1, 4)):
        width = draw.choice((0.1, 2.5, 3.6, 5.0))
        corners = [shaken(x, 0), shaken(x + width, 0), shaken(x + width, 3.5), shaken(x, 3.5)]
        features.append(plans.polygon(draw.choice(NAMES), *corners, level=draw.choice((0, 0, 0, 1))))
        at, line = draw.uniform(x, x + width), draw.choice((0, 0, 3.5, 1.2))
        features.append(plans.line(draw.choice(("door", "window", "passage")), (at, line), (at + draw.choice((0.1, 0.9, 2)), line)))
        for name in draw.sample(PIECES, draw.randint(0, 4)):
            size = {} if draw.random() < 0.3 else {"width": draw.choice((0, 0.5, 1.6)), "depth": 0.6, "height": 0.8}
            place = draw.uniform(x - 1, x + width + 1), draw.uniform(0, 3.5)
            features.append(plans.piece(name, *place, rotation=draw.choice((0, 90, 45)), **size))
        x += width + draw.choice((0, 0.1, 0.2))
    thickness = draw.choice(({}, {"wall_thickness": 0.1}))
    return {**plans.collection(*features), **thickness, "unit": draw.choice(("m", "cm", None))}


@pytest.mark.parametrize("seed", seeds(range(9000, 9200), 10))
def test_plans_that_are_drawn_carelessly_are_told(seed: int) -> None:
    try:
        untold = untold_in_import(plans.read(drawn(seed)), PIECES)
    except ComposeError as refused:
        untold = untold_in_refusal(refused)
    assert untold == []


WRONG: list[Any] = [
    None, True, -1, 0, 7, 2.5, 1e9, "", "Xyz", "NaN", [], [1], [[0, 0], [1, 1], [2, 0], [0, 1]], {}, {"Xyz": -1}, {"a": {"b": []}},
]  # fmt: skip
BODIES = (RerollBody, FurnishBody, FixBody, DragBody, ExplainBody, FloorBody, ExportBody, PlaceBody, ImportBody)
REQUESTED: dict[str, Any] = {
    "seed": 1, "width": 9, "depth": 7, "min_room_size": 3, "max_depth": 3, "use_spine": True, "outdoor": True, "style": None,
    "decorate": True, "program": {"bedrooms": 1}, "area": 60, "outline": "L", "access": "none", "wall_thickness": 0.1,
    "force_types": {"0": "kitchen"},
}  # fmt: skip


@cache
def home() -> Scene:
    return generate(Request(seed=5, program="studio")).scene


def spoilt(document: Any, draw: random.Random) -> Any:
    """A document in which something, anywhere in it, is another thing, is gone, or is new."""
    made = deepcopy(document)
    part: Any = made
    while True:
        keys = list(part) if isinstance(part, dict) else list(range(len(part)))
        key = draw.choice(keys)
        inner = part[key]
        if not isinstance(inner, dict | list) or not inner or draw.random() < 0.25:
            break
        part = inner
    if isinstance(part, dict) and draw.random() < 0.2:
        part["Xyz" if draw.random() < 0.5 else f"{key}s"] = part.pop(key)
    else:
        part[key] = draw.choice(WRONG)
    return made


@pytest.mark.parametrize("seed", seeds(range(9200, 9400), 10))
def test_refusals_of_documents_are_told(seed: int) -> None:
    draw, refused = random.Random(seed), 0
    untold: set[str] = set()
    scene = write_scene(home())
    rooms, room = [one["id"] for one in scene["rooms"]], scene["rooms"][0]
    whole = {
        **REQUESTED, "scene": scene, "rooms": rooms, "reroll": rooms, "id": room["furniture"][0]["id"], "locked": rooms, "room": room,
        "pieces": [{"name": "desk", "relations": [{"type": "against_wall"}]}], "alternatives": 2, "scale": 50, "level": 0, "file": "",
        "keep": "all", "effort": "normal",
    }  # fmt: skip
    for _ in range(40):
        of = draw.choice((Request, *BODIES))
        try:
            if of is Request:
                generate(read_request(spoilt(REQUESTED, draw)))
            else:
                read(of, spoilt({key: value for key, value in whole.items() if key in of.__dataclass_fields__}, draw))
        except ComposeError as error:
            refused, untold = refused + 1, untold | {*untold_in_refusal(error)}
    assert refused > 10
    assert untold == set()
