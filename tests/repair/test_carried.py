"""Whatever stands on, lies on, hangs over or sits on something goes along with it, in one way for all of them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import pytest

from solver.free_places import footprint
from solver.geometry import Rect
from solver.repair import bodies as module
from solver.repair.bodies import Body, all_bodies, brought_along, changed_from_the_floor_up, parents_of, seated_along, without
from solver.scene import Decoration, Dynamic, Furniture, Room
from solver.streams import Stream
from tests.every import every

TABLE = Furniture("table", "table", None, 2.0, 0.0, 2.0, 0, 1.4, 0.8, 0.75)
TRAY = Furniture("tray", "tray", None, 2.3, 0.75, 1.9, 0, 0.4, 0.3, 0.05, on="table")
CUP = Decoration("cup", "cup", "tray", None, 2.35, 0.8, 1.95, 30, 0.1, 0.1, 0.1)
BOOK = Decoration("book", "book", None, None, 1.6, 0.75, 2.1, 10, 0.2, 0.15, 0.03)
PICTURE = Decoration("picture", "picture", "table", "north", 2.0, 1.4, 0.1, 0, 0.6, 0.04, 0.4)
PLANT = Decoration("plant", "plant", None, None, 0.5, 0.0, 0.5, 0, 0.3, 0.3, 0.6)
ROOM = Room("room", width=4.0, depth=4.0, furniture=(TABLE, TRAY), decorations=(CUP, BOOK, PICTURE, PLANT))
MOVED = replace(TABLE, x=1.1, y=0.1, z=2.6)


def table_to(pose: Body) -> Room:
    return changed_from_the_floor_up(ROOM, lambda body, _: pose if body.id == "table" else body)


def in_the_frame_of(carrier: Body, thing: Body | Dynamic) -> tuple[float, ...]:
    """A thing's place along its carrier's width, depth and height, and how it is turned to it."""
    angle = math.radians(carrier.rotation)
    dx, dz = thing.x - carrier.x, thing.z - carrier.z
    across, along = dx * math.cos(angle) - dz * math.sin(angle), dx * math.sin(angle) + dz * math.cos(angle)
    return across, along, thing.y - carrier.y, (thing.rotation - carrier.rotation) % 360


@pytest.mark.parametrize("rotation", [0, 90, 180, 270])
@pytest.mark.parametrize("thing", [TRAY, CUP, BOOK, PICTURE, Dynamic("cat", "cat", "room", 2.2, 0.75, 2.2, 45, 0.3, 0.3, 0.3, on="table")])
def test_all_that_is_carried_keeps_its_place_in_the_frame_of_what_carries_it(thing: Body | Dynamic, rotation: int) -> None:
    after = replace(MOVED, rotation=rotation)
    gone_along: Body | Dynamic
    if isinstance(thing, Dynamic):
        gone_along = seated_along([thing], [ROOM], [table_to(after)])[0]
    else:
        gone_along = {body.id: body for body in all_bodies(table_to(after))}[thing.id]
    assert in_the_frame_of(after, gone_along) == pytest.approx(in_the_frame_of(TABLE, thing), abs=1e-3)


@pytest.mark.parametrize(("rotation", "wall"), [(0, "north"), (90, "west"), (180, "south"), (270, "east")])
def test_what_hangs_over_a_piece_hangs_at_the_wall_that_it_is_turned_to(rotation: int, wall: str) -> None:
    assert brought_along(PICTURE, TABLE, replace(MOVED, rotation=rotation)).mounted_on_wall == wall


def test_what_nothing_carries_stays_and_so_does_all_where_nothing_moves() -> None:
    assert table_to(MOVED).decorations[3] is PLANT
    assert table_to(TABLE) is ROOM


def test_a_thing_that_names_no_parent_lies_in_what_it_is_over() -> None:
    assert parents_of(ROOM) == {"tray": "table", "cup": "tray", "book": "table", "picture": "table"}


def test_a_body_is_changed_after_what_carries_it() -> None:
    seen: list[str] = []

    def change(body: Body, now: Mapping[str, Body]) -> Body:
        seen.append(body.id)
        assert now["table"].x == (MOVED.x if "table" in seen[:-1] else TABLE.x)
        return MOVED if body.id == "table" else body

    changed_from_the_floor_up(ROOM, change)
    assert seen.index("table") < seen.index("tray") < seen.index("cup")


def test_rings_carry_nothing_along_and_nothing_is_lost() -> None:
    one, other = replace(TABLE, id="one", on="other"), replace(TABLE, id="other", on="one")
    assert parents_of(replace(ROOM, furniture=(one, other), decorations=())) == {}


def test_who_loses_the_seat_stands_up() -> None:
    sitting = Dynamic("anna", "person", "room", 2.0, 0.45, 2.0, 0, 0.5, 0.5, 1.2, on="table")
    (standing,) = seated_along([sitting], [ROOM], [without(ROOM, ("table",))])
    assert (standing.on, standing.y, standing.height) == (None, 0.0, Dynamic("").height)


def test_what_is_taken_out_takes_along_all_that_it_carries() -> None:
    assert without(ROOM, ("table",)) == replace(ROOM, furniture=(), decorations=(PLANT,))


def piled(seed: int) -> Room:
    """Six pieces in a small room, some on one another's tops, and eight things anywhere over them."""
    stream = Stream(seed, "piled")

    def length(low: int, high: int) -> float:
        return (low + stream.below(high - low + 1)) / 10

    furniture: list[Furniture] = []
    for k in range(6):
        under = furniture[stream.below(3)] if k > 2 else None
        y = 0.0 if under is None else under.y + under.height + 0.015 * (stream.below(4) - 1)
        size = length(4, 12), length(4, 12), length(2, 9)
        furniture.append(Furniture(f"piece_{k}", "box", None, length(5, 20), y, length(5, 20), 0, *size))
    things = [Decoration(f"thing_{k}", "cup", None, None, length(5, 20), length(0, 16), length(5, 20), 0, 0.1, 0.1, 0.1) for k in range(8)]
    return Room("room", width=3.0, depth=3.0, furniture=tuple(furniture), decorations=tuple(things))


def is_over(body: Body, other: Furniture) -> bool:
    return abs(body.x - other.x) < other.width / 2 - 1e-6 and abs(body.z - other.z) < other.depth / 2 - 1e-6 and other.y < body.y


@every("seed", range(40))
def test_what_carries_what_is_as_said(seed: int) -> None:
    """Pieces: the first on whose top one rests. Things off the floor: of what they lie over or in the piece with the lowest top."""
    room, expected = piled(seed), {}
    for piece in room.furniture:
        tops = [other for other in room.furniture if abs(other.y + other.height - piece.y) < 0.02 + 1e-9 and is_over(piece, other)]
        if piece.y > 0.02 and tops:
            expected[piece.id] = tops[0].id
    for thing in room.decorations:
        within = [piece for piece in room.furniture if is_over(thing, piece) and thing.y < piece.y + piece.height + 0.02 + 1e-9]
        if thing.y > 0.02 and within:
            expected[thing.id] = min(within, key=lambda piece: piece.y + piece.height).id
    assert parents_of(room) == expected


def test_much_is_carried_above() -> None:
    counts = [len(parents_of(piled(seed))) for seed in range(40)]
    assert sum(counts) > 100


def test_thousands_of_things_ask_each_piece_for_its_footprint_but_twice(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def counted(body: Body) -> Rect:
        asked.append(body.id)
        return footprint(body)

    monkeypatch.setattr(module, "footprint", counted)
    parents_of(replace(ROOM, decorations=tuple(replace(BOOK, id=f"book_{k}") for k in range(1000))))
    assert 0 < len(asked) <= 2 * len(ROOM.furniture)
