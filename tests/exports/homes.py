"""Homes that every format is tested on, each made once a session: generated ones and a small one of our own.

`own` has what mirror images, swapped axes and lost signs show in: an L-shaped room, a letter F on its floor, a door for each hinge and
swing on walls along both axes, windows, a passage, a garage door, a garden with a railing, bodies at odd angles, one on another.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from typing import Final

from catalogs import load_catalogs
from solver import Request, generate
from solver.exports import HouseModel, describe
from solver.scene import Decoration, Dynamic, Flooring, Furniture, Level, Opening, Room, Scene, WallFinish

HOSTILE: Final = (
    "a\"b'c<d>&e]]>--f",
    "=1+1",
    "two\nlines\ttab",
    "#anchor {brace} [x]",
    "M\u00f6bel \u5bb6\u5177 \U0001f6cb",
    "9/lives",
    "9_lives",
    "x" * 300,
    "../up/and $away;%s\\",
    "</World>",
)
"""Ids and names that break files of those who do not quote: one for each body of `hostile`, in turn."""


def _opening(name: str, wall: str | None, position: float, to: str, **more: object) -> Opening:
    return Opening(name, wall=wall, position=position, connects_to=to, **more)  # type: ignore[arg-type]


def _both(opening: Opening, wall: str, position: float, to: str) -> Opening:
    """The same door as the room behind it lists it: its leaf sweeps the other floor, and is drawn once."""
    swing = {"in": "out", "out": "in", None: None}[opening.swing]
    return replace(opening, wall=wall, edge=None, position=position, connects_to=to, swing=swing, render_panel=False)


def _letter_f(room: str) -> tuple[Furniture, ...]:
    """A letter F, read from above with north at the top: 1.2 m high, 0.9 m wide, 0.3 m thick, its top 0.2 m above the floor."""
    strokes = {"stem": (1.0, 3.4, 0.3, 1.2), "arm": (1.45, 2.95, 0.6, 0.3), "bar": (1.3, 3.4, 0.3, 0.2)}
    return tuple(
        Furniture(f"{room}/f_{name}", f"f_{name}", x=x, z=z, width=width, depth=depth, height=0.2, color="#c03020")
        for name, (x, z, width, depth) in strokes.items()
    )


_GARAGE_DOOR = _opening("door_garage", "east", 1.0, "garage", hinge="end", swing="out")
_BED_DOOR = _opening("door_bed", None, 1.0, "bed", hinge="start", swing="in", edge=2)
_STUDY_DOOR = _opening("door_study", "west", 3.0, "study", hinge="start", swing="out")
_GARDEN_DOOR = _opening("door_garden", "north", 4.0, "garden", hinge="end", swing="in")
_PASSAGE = _opening("passage", "south", 1.2, "study", kind="passage", width=1.2)


def _living() -> Room:
    return Room(
        "living", 0, "living_room", x=0.0, z=0.0, width=6.0, depth=5.0,
        outline=((0.0, 0.0), (6.0, 0.0), (6.0, 3.0), (3.5, 3.0), (3.5, 5.0), (0.0, 5.0)),
        flooring=Flooring("wood", "#b08d57"), walls=WallFinish("plaster", "#dde6e0"), accent="#7f5f8f",
        openings=(
            _opening("front", "west", 1.5, "EXTERIOR", hinge="start", swing="in", main_entrance=True, width=1.0),
            _GARAGE_DOOR, _BED_DOOR, _GARDEN_DOOR, _PASSAGE,
            _opening("window_1", "north", 1.6, "EXTERIOR", kind="window", width=1.4, height=1.2, sill=0.9),
        ),
        furniture=(
            *_letter_f("living"),
            Furniture("living/dining_table_1", "dining_table", x=4.3, z=1.5, width=1.6, depth=0.9, height=0.75, color="#9a6b3f"),
            Furniture("living/dining_chair_1", "dining_chair", x=4.3, z=2.3, rotation=180, width=0.46, depth=0.5, height=0.9),
            Furniture("living/armchair_1", "armchair", x=2.3, z=0.9, rotation=330, width=0.8, depth=0.82, height=0.85),
        ),
        decorations=(
            Decoration("living/vase_1", "vase", "living/dining_table_1", x=4.6, y=0.75, z=1.4, width=0.15, depth=0.15, height=0.34),
            Decoration("living/art_1", "wall_art", None, "south", 2.75, 1.4, 4.93, 180, 1.0, 0.04, 0.6),
        ),
    )  # fmt: skip


def _bed() -> Room:
    return Room(
        "bed", 1, "bedroom", x=3.5, z=3.0, width=4.0, depth=4.0, walls=WallFinish("wood", "#c9b79c"),
        openings=(
            _both(_BED_DOOR, "north", 1.5, "living"), _STUDY_DOOR,
            _opening("door_back", "south", 1.0, "EXTERIOR", hinge="end", swing="in"),
            _opening("window_2", "east", 2.6, "EXTERIOR", kind="window", width=1.0, height=1.2, sill=0.9),
        ),
        furniture=(
            Furniture("bed/bed_1", "bed", x=2.9, z=2.4, rotation=270, width=1.6, depth=2.0, height=0.9, wall="east"),
            Furniture("bed/kids_chair_1", "kids_chair", x=0.9, z=1.6, rotation=17.5, width=0.34, depth=0.34, height=0.6),
        ),
        decorations=(Decoration("bed/rug_1", "rug", x=1.2, z=2.4, rotation=90, width=2.0, depth=1.4, height=0.01),),
    )  # fmt: skip


def _study() -> Room:
    return Room(
        "study", 2, "office", x=0.0, z=5.0, width=3.5, depth=2.0,
        openings=(
            _both(_PASSAGE, "north", 1.2, "living"), _both(_STUDY_DOOR, "east", 1.0, "bed"),
            _opening("door_side", "south", 2.5, "EXTERIOR", hinge="start", swing="out", width=0.8),
            _opening("door_west", "west", 1.2, "EXTERIOR", hinge="end", swing="in"),
        ),
    )  # fmt: skip


def _garage() -> Room:
    return Room(
        "garage", 3, "garage", x=6.0, z=0.0, width=8.0, depth=3.0,
        openings=(
            _both(_GARAGE_DOOR, "west", 1.0, "living"),
            _opening("gate", "north", 4.0, "EXTERIOR", kind="garage_door", width=2.4, height=2.2),
        ),
        furniture=(Furniture("garage/thing_1", "thing_nobody_knows", x=6.5, z=1.6, rotation=45, width=1.2, depth=0.5, height=1.6),),
    )  # fmt: skip


def _garden() -> Room:
    return Room(
        "garden", 4, "backyard", x=1.0, z=-3.0, width=5.0, depth=3.0, outdoor=True, flooring=Flooring("grass", "#7da35a"),
        openings=(_both(_GARDEN_DOOR, "south", 3.0, "living"), _opening("door_gate", "west", 1.0, "EXTERIOR", hinge="end", swing="out")),
    )  # fmt: skip


@cache
def own() -> Scene:
    """A small house of our own: 14 x 7 m with a garden before it; every opening there is, on walls both ways."""
    dynamic = (
        Dynamic("person_1", "person", "living", 4.3, 0.46, 2.3, 180, height=0.9, on="living/dining_chair_1"),
        Dynamic("cat_1", "cat", "study", 2.6, 0.0, 0.6, 60, 0.2, 0.45, 0.3),
    )
    return Scene(wall_thickness=0.1, rooms=(_living(), _bed(), _study(), _garage(), _garden()), dynamic=dynamic)


@cache
def hostile() -> Scene:
    """The same house, its rooms, openings, bodies and words named by somebody who means ill."""
    count = iter(range(10_000))
    renamed: dict[str, str] = {}

    def bad(old: str | None) -> str | None:
        if old is not None and old not in renamed:
            number = next(count)
            renamed[old] = HOSTILE[number % len(HOSTILE)] + (str(number) if number >= len(HOSTILE) else "")
        return old and renamed[old]

    scene = own()
    for room in scene.rooms:
        for own_id in (*(one.id for one in room.furniture), *(one.id for one in room.decorations)):
            bad(own_id)
    for person in scene.dynamic:
        bad(person.id)
    for room in scene.rooms:
        for own_id in (room.id, *(one.id for one in room.openings)):
            bad(own_id)
    rooms = tuple(
        replace(
            room,
            id=renamed[room.id],
            type=HOSTILE[room.index],
            openings=tuple(replace(one, id=renamed[one.id], connects_to=renamed.get(one.connects_to or "")) for one in room.openings),
            furniture=tuple(
                replace(one, id=renamed[one.id], name=HOSTILE[n] if n < 3 else one.name) for n, one in enumerate(room.furniture)
            ),
            decorations=tuple(replace(one, id=renamed[one.id], parent=bad(one.parent)) for one in room.decorations),
        )
        for room in scene.rooms
    )
    people = tuple(replace(one, id=renamed[one.id], room=renamed[one.room or ""], on=bad(one.on)) for one in scene.dynamic)
    return replace(scene, rooms=rooms, dynamic=people)


@cache
def storeys() -> Scene:
    """Two rooms, one over the other, with no stairs between."""
    below, above = (
        Room(name, number, "bedroom", number, width=4.0, depth=3.0 + number, openings=(door,), furniture=(bed,))
        for number, (name, door, bed) in enumerate(
            (
                name,
                _opening(f"{name}_door", "south", 3.0, "EXTERIOR", hinge="start", swing="in"),
                Furniture(f"{name}/bed_1", "bed", x=1.0, z=1.1, width=1.6, depth=2.0, height=0.9),
            )
            for name in ("below", "above")
        )
    )
    return Scene(wall_thickness=0.1, rooms=(below, above), levels=(Level(0, 0.0, 2.6), Level(1, 2.8, 2.4)))


@cache
def family() -> Scene:
    """A decorated family home."""
    return generate(Request(seed=2024, program="family", decorate=True)).scene


@cache
def default() -> Scene:
    """A house of four rooms, decorated; `make targets` has those of twenty-odd that the plain request makes."""
    return generate(Request(seed=2024, width=8.0, depth=6.0, decorate=True)).scene


SCENES: Final[Mapping[str, Callable[[], Scene]]] = {"own": own, "family": family, "default": default}
"""What every format is tested on; `hostile` and `storeys` besides."""
_ALL: Final[Mapping[str, Callable[[], Scene]]] = {**SCENES, "hostile": hostile, "storeys": storeys}


@cache
def described(name: str) -> HouseModel:
    """The description of one of the homes, by its function's name."""
    return describe(_ALL[name](), load_catalogs())
