"""fix() of decorations: what floats is put back by the shortest way, what lies on it comes along, locked things stay."""

from __future__ import annotations

from dataclasses import replace

import pytest

from catalogs import load_catalogs
from solver import Request, Scene, fix, generate
from solver.scene import Decoration, Furniture, Level, Room
from solver.streams import Stream
from solver.validator import validate

BED = Furniture("r/bed_1", "bed", "bed", x=2.0, z=1.08, width=1.6, depth=2.0, height=0.9, wall="north")
SHELF = Decoration("r/wall_shelf_1", "wall_shelf", None, "west", 0.16, 1.5, 3.0, 90, 0.8, 0.22, 0.04)
BOOK = Decoration("r/book_1", "book", "r/wall_shelf_1", None, 0.16, 1.54, 3.2, 90, 0.03, 0.14, 0.2)


def scene(*things: Decoration) -> Scene:
    return Scene(wall_thickness=0.1, rooms=(Room("r", width=4.0, depth=5.0, furniture=(BED,), decorations=things),))


def floating(document: Scene) -> list[str]:
    return [label for issue in validate(document, load_catalogs()) if issue.rule == "floating" for label in issue.ids]


def pillow(x: float, y: float, z: float) -> Decoration:
    return Decoration("r/pillow_1", "pillow", "r/bed_1", None, x, y, z, 0, 0.4, 0.4, 0.15)


def test_what_floats_comes_to_the_nearest_point_of_its_parents_surface() -> None:
    sent = scene(pillow(3.5, 0.62, 0.5))
    assert floating(sent) == ["r/pillow_1"]
    fixed = fix(sent)
    (thing,) = fixed.scene.rooms[0].decorations
    assert (thing.x, thing.y, thing.z) == (2.54, 0.5, 0.5)
    assert fixed.scene.rooms[0].furniture == (BED,)
    assert [(move.id, move.dx, move.dz) for move in fixed.moves] == [("r/pillow_1", -0.96, 0.0)]
    assert fix(fixed.scene).scene == fixed.scene


@pytest.mark.parametrize("thing", [pillow(2.0, 0.62, 0.5), replace(pillow(2.0, 0.4, 3.5), parent=None)], ids=["onto its piece", "down"])
def test_what_comes_up_or_down_alone_is_listed_among_the_moves(thing: Decoration) -> None:
    fixed = fix(scene(thing))
    assert fixed.scene.rooms[0].decorations[0].y != thing.y
    assert [(move.id, move.dx, move.dz) for move in fixed.moves] == [(thing.id, 0.0, 0.0)]


def test_a_thing_at_rest_stays_as_it_is() -> None:
    sent = scene(pillow(2.0, 0.5, 0.5), SHELF, BOOK)
    assert floating(sent) == []
    assert fix(sent).scene == sent


def test_what_hangs_comes_back_to_its_wall_and_brings_what_lies_on_it() -> None:
    away = replace(SHELF, x=0.9), replace(BOOK, x=0.9)
    assert floating(scene(*away)) == ["r/wall_shelf_1"]
    assert fix(scene(*away)).scene.rooms[0].decorations == (SHELF, BOOK)
    assert fix(scene(*reversed(away))).scene.rooms[0].decorations == (BOOK, SHELF)


L_SHAPE = ((0.0, 0.0), (4.0, 0.0), (4.0, 2.5), (2.0, 2.5), (2.0, 5.0), (0.0, 5.0))


@pytest.mark.parametrize("corners", [L_SHAPE, (L_SHAPE[0], *L_SHAPE[:0:-1])])
@pytest.mark.parametrize(
    ("wall", "sent", "there"),
    [
        ("south", (3.0, 3.2), (3.0, 2.43)),
        ("south", (3.0, 4.9), (1.55, 4.93)),
        ("south", (1.0, 3.9), (1.0, 4.93)),
        ("east", (1.7, 4.0), (1.93, 4.0)),
        ("east", (3.0, 1.0), (3.93, 1.0)),
        ("north", (3.0, 1.0), (3.0, 0.07)),
        ("west", (1.0, 4.0), (0.07, 4.0)),
    ],
)
def test_in_an_outline_it_comes_back_to_the_nearest_wall(
    wall: str, sent: tuple[float, float], there: tuple[float, float], corners: tuple[tuple[float, float], ...]
) -> None:
    turn = {"north": 0, "south": 180, "east": 270, "west": 90}[wall]
    art = Decoration("r/wall_art_1", "wall_art", None, wall, sent[0], 1.5, sent[1], turn, 0.8, 0.04, 0.6)
    room = Room("r", width=4.0, depth=5.0, outline=corners, decorations=(art,))
    document = Scene(wall_thickness=0.1, rooms=(room,))
    assert floating(document) == ["r/wall_art_1"]
    fixed = fix(document).scene
    assert floating(fixed) == []
    assert (fixed.rooms[0].decorations[0].x, fixed.rooms[0].decorations[0].z) == there
    assert fix(fixed).scene == fixed


def test_without_a_parent_it_comes_to_the_floor() -> None:
    vase = Decoration("r/vase_1", "vase", None, None, 0.6, 0.7, 4.0, 0, 0.15, 0.15, 0.34)
    fixed = fix(scene(vase))
    assert fixed.scene.rooms[0].decorations == (replace(vase, y=0.0),)
    assert fixed.issues == ()


@pytest.mark.parametrize("size", [1, 2, 3])
def test_a_ring_of_parents_is_opened_and_stays_so(size: int) -> None:
    names = [f"r/vase_{number}" for number in range(size)]
    vase = Decoration("", "vase", None, None, 0.6, 0.7, 4.0, 0, 0.15, 0.15, 0.34)
    ring = [replace(vase, id=name, parent=names[(at + 1) % size]) for at, name in enumerate(names)]
    fixed = fix(scene(*ring))
    assert fixed.issues == ()
    first, *others = fixed.scene.rooms[0].decorations
    assert (first.parent, first.y) == (None, 0.0)
    assert [thing.parent for thing in others] == [thing.parent for thing in ring[1:]]
    assert fix(fixed.scene).scene == fixed.scene


@pytest.mark.parametrize("parent", [None, "r/gone_1"])
def test_what_lies_on_a_piece_goes_with_it_though_it_names_no_parent(parent: str | None) -> None:
    sent = scene(replace(pillow(2.3, 0.5, 0.5), parent=parent))
    assert floating(sent) == []
    pushed = replace(BED, z=0.98)
    rooms = tuple(replace(room, furniture=(pushed,), decorations=(replace(pillow(2.3, 0.5, 0.4), parent=parent),)) for room in sent.rooms)
    fixed = fix(replace(sent, rooms=rooms))
    (moved,), (thing,) = fixed.scene.rooms[0].furniture, fixed.scene.rooms[0].decorations
    by = round(moved.z - 0.98, 4)
    assert by > 0
    assert (thing.x, thing.y, thing.z) == (2.3, 0.5, round(0.4 + by, 4))


@pytest.mark.parametrize("rotation", [0, 90])
def test_a_piece_that_stands_on_a_turned_one_goes_with_it(rotation: int) -> None:
    along = (1.6, 0.6) if rotation == 0 else (0.6, 1.6)
    table = Furniture("r/slab_1", "slab", "table", x=2.0, z=4.8, width=along[0], depth=along[1], height=0.75, rotation=rotation)
    case = Furniture("r/case_1", "case", "storage", x=2.6, y=0.75, z=4.7, width=0.2, depth=0.2, height=0.4)
    fixed = fix(Scene(rooms=(Room("r", width=4.0, depth=5.0, furniture=(table, case)),)))
    assert [(piece.x, piece.y, piece.z) for piece in fixed.scene.rooms[0].furniture] == [(2.0, 0.0, 4.7), (2.6, 0.75, 4.6)]


def test_a_locked_thing_stays_and_is_named() -> None:
    fixed = fix(scene(pillow(3.5, 0.62, 0.5)), locked=["r/pillow_1"])
    assert fixed.scene.rooms[0].decorations == (pillow(3.5, 0.62, 0.5),)
    assert any("r/pillow_1" in conflict.ids for conflict in fixed.conflicts)


@pytest.mark.parametrize("seed", range(3))
def test_a_stirred_and_decorated_house_has_nothing_floating_after(seed: int) -> None:
    made = generate(Request(seed=seed, width=12, depth=9, decorate=True)).scene
    assert fix(made).scene == made
    stream = Stream(seed, "stir")
    rooms = []
    for room in made.rooms:
        pieces = [
            replace(p, x=round(p.x + stream.uniform(-0.3, 0.3), 3)) if p.on is None and stream.chance(0.3) else p for p in room.furniture
        ]
        things = [replace(d, z=round(d.z + stream.uniform(-0.6, 0.6), 3)) if stream.chance(0.2) else d for d in room.decorations]
        rooms.append(replace(room, furniture=tuple(pieces), decorations=tuple(things)))
    sent = replace(made, rooms=tuple(rooms))
    assert len(floating(sent)) > 10
    fixed = fix(sent)
    assert floating(fixed.scene) == []
    assert fix(fixed.scene).scene == fixed.scene


SOFA = Furniture("r/sofa_1", "sofa", "sofa", x=2.0, z=0.53, width=2.0, depth=0.9, height=0.8, wall="north")
ON_SOFA = tuple(
    Decoration(f"r/{kind}_{k}", kind, SOFA.id, None, x, 0.44, z, 0, 0.4, 0.15, 0.4)
    for k, (kind, x, z) in enumerate((("pillow", 1.27, 0.31), ("throw_pillow", 1.72, 0.3), ("pillow", 2.73, 0.31)))
)
ART = Decoration("r/wall_art_1", "wall_art", SOFA.id, "north", 2.0, 1.5, 0.07, 0, 0.8, 0.04, 0.6)


@pytest.mark.parametrize(
    ("dx", "dz", "turn"), [(0.7, 0.0, 0), (-0.6, 0.0, 0), (0.5, 2.0, 0), (-0.1, 2.2, 90), (0.0, 2.3, 270), (0.3, 3.4, 180)]
)
def test_what_lay_on_a_moved_piece_goes_after_it_as_it_lay(dx: float, dz: float, turn: int) -> None:
    sent = scene(*ON_SOFA, ART)
    moved = replace(SOFA, x=SOFA.x + dx, z=SOFA.z + dz, rotation=turn)
    sent = replace(sent, rooms=(replace(sent.rooms[0], furniture=(moved,)),))
    assert floating(sent)
    room = fix(sent, moved=[SOFA.id]).scene.rooms[0]
    (sofa,) = room.furniture
    cos, sin = {0: (1, 0), 90: (0, 1), 180: (-1, 0), 270: (0, -1)}[int(sofa.rotation)]
    shifts = []
    for before, now in zip(ON_SOFA, room.decorations, strict=False):
        x, z = now.x - sofa.x, now.z - sofa.z
        shifts.append((x * cos - z * sin - (before.x - SOFA.x), x * sin + z * cos - (before.z - SOFA.z)))
        assert now.rotation == sofa.rotation
        assert now.y == before.y
    assert all(shift == pytest.approx(shifts[0], abs=0.001) for shift in shifts)
    assert all(abs(part) < 0.35 for shift in shifts for part in shift)
    assert floating(fix(sent, moved=[SOFA.id]).scene) == []


PANTRY = Furniture("r/pantry_1", "pantry", "storage", x=1.5, y=1.34, z=4.0, width=0.8, depth=0.6, height=2.0)
COUNTER = Furniture("r/counter_1", "counter", "storage", x=1.5, z=4.6, width=1.2, depth=0.6, height=0.9, rotation=180, wall="south")
OVEN = Furniture("r/microwave_1", "microwave", "appliance", x=1.5, y=2.5, z=4.6, width=0.5, depth=0.38, height=0.3)
LOW = (Level(0, 0.0, 2.7),)


@pytest.mark.parametrize(
    ("furniture", "things", "heights"),
    [
        ((PANTRY,), (), {"r/pantry_1": 0.0}),
        ((replace(PANTRY, y=0.7),), (), {"r/pantry_1": 0.7}),
        ((PANTRY,), (replace(BOOK, parent=PANTRY.id, x=1.5, y=3.34, z=4.0),), {"r/pantry_1": 0.0, "r/book_1": 2.0}),
        ((replace(COUNTER, y=2.2), replace(OVEN, y=3.1, on=COUNTER.id)), (), {"r/counter_1": 0.0, "r/microwave_1": 0.9}),
        ((COUNTER, OVEN), (), {"r/counter_1": 0.0, "r/microwave_1": 0.9}),
        ((), (replace(SHELF, y=2.68),), {"r/wall_shelf_1": 2.66}),
        ((), (replace(ART, parent=None, y=2.2005),), {"r/wall_art_1": 2.1}),
    ],
)
def test_what_reaches_above_the_ceiling_comes_down(
    furniture: tuple[Furniture, ...], things: tuple[Decoration, ...], heights: dict[str, float]
) -> None:
    sent = Scene(wall_thickness=0.1, levels=LOW, rooms=(Room("r", width=4.0, depth=5.0, furniture=furniture, decorations=things),))
    fixed = fix(sent)
    (room,) = fixed.scene.rooms
    found = {piece.id: piece.y for piece in room.furniture} | {thing.id: thing.y for thing in room.decorations}
    assert {label: found[label] for label in heights} == pytest.approx(heights)
    assert fixed.conflicts == ()
    assert fix(fixed.scene).scene == fixed.scene


def test_what_is_locked_above_the_ceiling_or_higher_than_the_room_stays_and_is_named() -> None:
    for piece in (replace(PANTRY, locked=True), replace(PANTRY, height=2.9)):
        fixed = fix(Scene(levels=LOW, rooms=(Room("r", width=4.0, depth=5.0, furniture=(piece,)),)))
        assert fixed.scene.rooms[0].furniture == (piece,)
        assert [conflict.ids for conflict in fixed.conflicts] == [(PANTRY.id,)]
