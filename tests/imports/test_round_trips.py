"""What our own exports draw reads back: rooms, openings and walls to 1 cm, types and names as they were."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from io import BytesIO, StringIO
from itertools import product
from zipfile import ZipFile

import ezdxf
import pytest
from ezdxf.math import Matrix44

from solver import Request, export, generate
from solver.answers import PlanImport
from solver.scene import EXTERIOR, Decoration, Level, Opening, Room, Scene
from tests.imports.plans import read, text_of
from tests.sweeps import pairs

HOMES = {
    "studio": Request(seed=5, program="studio"),
    "family": Request(seed=5, program="family"),
    "an L, decorated": Request(seed=11, program="one_bed", outline="L", decorate=True),
    "a T": Request(seed=12, program="one_bed", outline="T"),
    "a U": Request(seed=12, program="large", outline="U"),
    "with a garden": Request(seed=13, program="one_bed", outdoor=True),
}
PROGRAMMES = tuple(HOMES)
WHOLE = ("procthor", "sh3d", "ifc", "svg")
"""Formats that read back whole."""
THICKNESSES = [(0.02, None), (0.12, 0.24), (0.08, None), (0.1, 0.36)]
"""Of inner and outer walls, m; None: as inner ones, every second time."""
NOT_READ = ("DIMENSIONS", "RAILINGS", "WALLS")
"""Layers of our drawings that hold neither rooms nor openings."""
CLOSE = 0.0101
"""m."""


@cache
def home(program: str) -> Scene:
    return generate(HOMES[program]).scene


@cache
def few_decorated() -> Scene:
    """The decorated home with every fourth of what lies on furniture and hangs, and what lies on that: the others read back as they do."""
    scene = home("an L, decorated")
    small = {one.id for room in scene.rooms for one in room.decorations}
    few = {one.id for room in scene.rooms for one in [one for one in room.decorations if one.parent not in small][::4]}
    kept = [[one for one in room.decorations if {one.id, one.parent} & few] for room in scene.rooms]
    assert any(one.parent in few for rooms in kept for one in rooms), "something lies on a small thing"
    return replace(scene, rooms=tuple(replace(room, decorations=tuple(rest)) for room, rest in zip(scene.rooms, kept, strict=True)))


@cache
def written(program: str, format: str) -> tuple[str, bytes]:
    (name, content), *_ = export(home(program), format).items()
    return name, content


@cache
def again(program: str, format: str) -> PlanImport:
    name, content = written(program, format)
    return read(content, name)


def box_of(room: Room) -> tuple[float, ...]:
    return room.x, room.z, room.width, room.depth


def openings_of(scene: Scene, swings: bool) -> set[tuple[object, ...]]:
    """Every entry of an opening, the house's own id left out: kind, room, wall, place, width, height, sill, other room, entrance."""
    return {
        (one.kind, room.type, one.wall, round(one.position, 2), round(one.width, 2), round(one.height, 2), round(one.sill, 2))
        + ((one.hinge, one.swing) if swings and one.kind == "door" else ())
        for room in scene.rooms
        for one in room.openings
    }


@pytest.mark.parametrize(("program", "format"), pairs(PROGRAMMES, WHOLE))
def test_a_house_reads_back(program: str, format: str) -> None:
    before, answer = home(program), again(program, format)
    after = answer.scene
    assert answer.format == format
    origin = min(room.x for room in before.rooms), min(room.z for room in before.rooms)
    for one, other in zip(before.rooms, after.rooms, strict=True):
        assert (one.id, one.type, one.outdoor) == (other.id, other.type, other.outdoor)
        moved = (one.x - origin[0], one.z - origin[1], one.width, one.depth)
        assert max(abs(a - b) for a, b in zip(moved, box_of(other), strict=True)) <= CLOSE
        assert len(one.outline or ()) == len(other.outline or ())
        apart = (
            abs(a - b)
            for p, q in zip(sorted(one.outline or ()), sorted(other.outline or ()), strict=True)
            for a, b in zip(p, q, strict=True)
        )
        assert max(apart, default=0.0) <= CLOSE
    assert openings_of(after, format == "procthor") == openings_of(before, format == "procthor")
    assert abs(after.wall_thickness - before.wall_thickness) <= CLOSE
    assert after.levels == before.levels
    assert set(before.adjacency) <= set(after.adjacency)
    entrances = [[one.id for room in scene.rooms for one in room.openings if one.main_entrance] for scene in (before, after)]
    assert entrances[0] == entrances[1]
    changed = [change["of"] for change in answer.changes if change["step"] in ("straighten", "wall_lines", "join")]
    assert changed == (["plan"] if format == "ifc" else [])  # its spaces are drawn by their inner faces


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
def test_wide_passages_that_meet_at_a_corner_read_back(format: str) -> None:
    hall = Room(
        "hall", type="hallway", width=7.0, depth=2.0,
        openings=(Opening("p", kind="passage", wall="south", position=3.5, width=1.0, connects_to="kitchen"),
                  Opening("q", kind="passage", wall="south", position=5.1, width=2.2, connects_to="living"),
                  Opening("front", kind="door", wall="west", position=1.0, connects_to=EXTERIOR, main_entrance=True)),
    )  # fmt: skip
    kitchen = Room(
        "kitchen", type="kitchen", z=2.0, width=4.0, depth=4.0,
        openings=(Opening("p", kind="passage", wall="north", position=3.5, width=1.0, connects_to="hall"),
                  Opening("r", kind="passage", wall="east", position=2.0, width=4.0, connects_to="living")),
    )  # fmt: skip
    living = Room(
        "living", type="living_room", x=4.0, z=2.0, width=6.0, depth=4.0,
        openings=(Opening("q", kind="passage", wall="north", position=1.1, width=2.2, connects_to="hall"),
                  Opening("r", kind="passage", wall="west", position=2.0, width=4.0, connects_to="kitchen")),
    )  # fmt: skip
    before = Scene(rooms=(hall, kitchen, living), wall_thickness=0.1)
    (name, content), *_ = export(before, format).items()
    assert openings_of(read(content, name).scene, swings=False) == openings_of(before, swings=False)


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
def test_pieces_that_people_named_read_back_where_they_stood(format: str) -> None:
    """They are what their kinds say: a chair is under its table whatever both are called."""
    furnished = few_decorated()
    named = (tuple(replace(one, name=f"Oma's {number}") for number, one in enumerate(room.furniture)) for room in furnished.rooms)
    before = replace(
        furnished, rooms=tuple(replace(room, furniture=those) for room, those in zip(furnished.rooms, named, strict=True)), certificate=None
    )
    (name, content), *_ = export(before, format).items()
    answer = read(content, name)
    assert [change for change in answer.changes if change["step"] == "furniture"] == []

    def said(scene: Scene) -> dict[str, tuple[str, bool]]:
        return {one.id: (one.name, one.under is not None) for room in scene.rooms for one in room.furniture}

    assert said(answer.scene) == said(before)


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
def test_what_is_of_no_kind_reads_back_by_its_name(format: str) -> None:
    """Also where that is longer than plans show names, and holds what DXF writes otherwise."""
    called = "wall  double door upper cabinet ^ longer than plans show"
    cabinet = Decoration("high", called, x=1.5, y=1.4, z=0.25, width=1.0, depth=0.34, height=0.6, mounted_on_wall="north")
    before = Scene(rooms=(Room("kitchen", type="kitchen", width=4.0, depth=3.0, decorations=(cabinet,)),), wall_thickness=0.1)
    (name, content), *_ = export(before, format).items()
    (room,) = read(content, name).scene.rooms
    assert [(one.id, one.name, one.mounted_on_wall) for one in room.decorations] == [("high", cabinet.name, "north")]
    assert room.furniture == ()


CALLED = ("Maria's", "Oma", "Küche alt", "Bureau de Paul", "x^2", "Lotte\n& Max", "The room of those who come late and stay long")
"""Names of rooms: some tell nothing, some another type."""


def named(scene: Scene) -> Scene:
    """The home, every second room called by a name that does not tell its type, one of them a loggia: a balcony indoors."""
    rooms = [replace(room, name=CALLED[number // 2 % len(CALLED)]) if number % 2 else room for number, room in enumerate(scene.rooms)]
    return replace(scene, rooms=(replace(rooms[0], type="balcony", outdoor=False), *rooms[1:]), certificate=None)


@pytest.mark.parametrize(("program", "format"), pairs(["studio", "a U"], (*WHOLE, "dxf")))
def test_rooms_that_people_named_read_back(program: str, format: str) -> None:
    before = named(home(program))
    (name, content), *_ = export(before, format).items()
    answer = read(content, name)

    def called(scene: Scene) -> dict[str, tuple[object, ...]]:
        return {room.id: (room.type, room.name, room.outdoor) for room in scene.rooms}

    assert called(answer.scene) == called(before)
    assert [one for one in answer.guesses if one["what"] in ("type", "outdoor")] == []


def renamed(content: bytes, format: str) -> bytes:
    """The file with its living room called a library, and of a .sh3d its beds cots, as another program would."""
    if format != "sh3d":
        label = {"ifc": (b",'Living room',", b",'Library',"), "dxf": (b"\n  1\nLiving room\n", b"\n  1\nLibrary\n")}[format]
        assert content.count(label[0]) == 1
        return content.replace(*label)
    made = BytesIO()
    with ZipFile(BytesIO(content)) as before, ZipFile(made, "w") as after:
        for name in before.namelist():
            held = before.read(name)
            assert name != "Home.xml" or held.count(b"<room name='Living room'") == 1
            held = held.replace(b"<room name='Living room'", b"<room name='Library'")
            after.writestr(name, held.replace(b" name='Bed' model", b" name='Cot' model"))
    return made.getvalue()


@pytest.mark.parametrize("format", ["sh3d", "ifc", "dxf"])
def test_a_room_that_another_program_renamed_is_what_it_is_called_now(format: str) -> None:
    name, content = written("family", format)
    (was,) = (room.id for room in home("family").rooms if room.type == "living_room")
    (room,) = (room for room in read(renamed(content, format), name).scene.rooms if room.id == was)
    assert (room.type, room.name) == ("office", "Library")


def test_a_piece_that_another_program_renamed_is_called_so() -> None:
    name, content = written("family", "sh3d")
    beds = {one.id for room in home("family").rooms for one in room.furniture if one.name == "bed"}
    called = {one.id: one.name for room in read(renamed(content, "sh3d"), name).scene.rooms for one in room.furniture}
    assert beds
    assert {id for id, name in called.items() if name == "Cot"} == beds


@pytest.mark.parametrize(("program", "format"), pairs(PROGRAMMES, (*WHOLE, "dxf")))
def test_its_furniture_reads_back(program: str, format: str) -> None:
    before, after = (
        {piece.id: piece for room in scene.rooms for piece in room.furniture} for scene in (home(program), again(program, format).scene)
    )
    assert before.keys() == after.keys()
    for name, piece in before.items():
        other = after[name]
        assert "_".join(other.name.lower().split()) == piece.name
        assert max(abs(a - b) for a, b in zip((piece.x, piece.y, piece.z), (other.x, other.y, other.z), strict=True)) <= CLOSE, name
        assert abs((piece.rotation - other.rotation + 180) % 360 - 180) < 1.0


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
def test_what_lies_and_hangs_there_reads_back(format: str) -> None:
    """Small things keep their kinds and lie, or hang, on what carried them, so that nothing is moved."""
    before, answer = home("an L, decorated"), again("an L, decorated", format)
    one, other = ({thing.id: thing for room in scene.rooms for thing in room.decorations} for scene in (before, answer.scene))
    assert one.keys() == other.keys()
    assert {name: thing.kind for name, thing in one.items()} == {name: thing.kind for name, thing in other.items()}
    hung = {name: thing.mounted_on_wall for name, thing in one.items()}
    assert len(set(hung.values())) == 5  # four walls, and None
    assert hung == {name: thing.mounted_on_wall for name, thing in other.items()}
    assert [change for change in answer.changes if change["step"] == "furniture"] == []
    assert [issue.message for issue in answer.issues if issue.severity == "error"] == []


@pytest.mark.parametrize(("home_in", "walls"), pairs([*product(["studio", "a U"], WHOLE)], THICKNESSES))
def test_walls_of_other_thickness_read_back(home_in: tuple[str, str], walls: tuple[float, float | None]) -> None:
    (program, format), (inner, outer) = home_in, walls
    before = thick(home(program), inner, outer)
    (name, content), *_ = export(before, format).items()
    after = read(content, name).scene
    assert abs(after.wall_thickness - inner) <= CLOSE
    origin = min(room.x for room in before.rooms), min(room.z for room in before.rooms)

    def seen(scene: Scene, x: float, z: float) -> list[tuple[object, ...]]:
        return sorted(
            (room.type, *(round(one / CLOSE) for one in (room.x - x, room.z - z, room.width, room.depth)),
             sorted(one for one in room.wall_thickness or () if one and abs(one - inner) > CLOSE))
            for room in scene.rooms
        )  # fmt: skip

    assert seen(after, 0.0, 0.0) == seen(before, *origin)


def thick(scene: Scene, inner: float, outer: float | None) -> Scene:
    """The home unfurnished, its walls as thick as said; outer walls of its rectangular rooms alone."""

    def one(room: Room) -> Room:
        sides = room.exterior_walls
        bare = replace(room, furniture=(), decorations=())
        if outer is None or sides is None or room.outline or room.outdoor:
            return bare
        return replace(bare, wall_thickness=tuple(outer if getattr(sides, name) else None for name in ("north", "east", "south", "west")))

    return replace(scene, rooms=tuple(map(one, scene.rooms)), wall_thickness=inner, dynamic=(), certificate=None)


@pytest.mark.parametrize("program", ["studio", "a U"])
@pytest.mark.parametrize("thickness", [0.0, 0.03])
def test_doors_of_a_drawing_are_as_wide_as_they_were_in_thin_walls(program: str, thickness: float) -> None:
    """Walls of no thickness are drawn 2 cm thick."""
    before = thick(home(program), thickness, None)
    (name, content), *_ = export(before, "dxf").items()
    assert openings_of(read(content, name).scene, swings=True) == openings_of(before, swings=True)


@pytest.mark.parametrize(("program", "unit"), pairs(PROGRAMMES, ["m", "mm"]))
def test_a_drawing_reads_back_as_far_as_it_says(program: str, unit: str) -> None:
    """Its doors are arcs, as wide as the gaps in its walls; ids, heights and the entrance are said, also of one that is scaled."""
    before = home(program)
    name, content = written(program, "dxf")
    answer = again(program, "dxf") if unit == "m" else read(in_millimetres(content), name)
    assert answer.format == "dxf"
    rooms = [sorted((room.id, room.type, room.width, room.depth) for room in scene.rooms) for scene in (before, answer.scene)]
    assert rooms[0] == rooms[1]
    assert openings_of(answer.scene, True) == openings_of(before, True)
    said = [{(one.id, one.main_entrance) for room in scene.rooms for one in room.openings} for scene in (before, answer.scene)]
    assert said[0] == said[1]
    assert {str(left["place"]) for left in answer.unread} <= {f"layer '{name}'" for name in NOT_READ}
    places = [
        {piece.id: (round(piece.x, 2), round(piece.z, 2)) for room in scene.rooms for piece in room.furniture}
        for scene in (before, answer.scene)
    ]
    assert places[0].keys() == places[1].keys()
    assert all(math.dist(place, places[1][id]) <= 2 * CLOSE for id, place in places[0].items())


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
def test_things_of_an_upper_storey_read_back_on_its_floor(format: str) -> None:
    """Files say heights in the house."""
    before, upper = few_decorated(), Level(1, 3.1, 2.8)
    cellar = Room("cellar", type="storage", width=4.0, depth=3.0)
    rooms = (cellar, *(replace(room, level=1) for room in before.rooms))
    files = export(replace(before, levels=(Level(), upper), rooms=rooms, dynamic=(), adjacency=(), certificate=None), format)
    name, content = max(files.items())
    after = read(content, name, **({"level": 1} if len(files) == 1 else {})).scene

    def heights(scene: Scene) -> dict[str, float]:
        small = {one.id: round(one.y, 2) for room in scene.rooms for one in room.decorations}
        return small | {one.id: round(one.y, 2) for room in scene.rooms for one in room.furniture}

    assert heights(after) == heights(before)
    assert len(files) > 1 or after.levels == (upper,)


def test_furniture_of_a_drawing_that_was_turned_is_named_and_not_read() -> None:
    name, content = written("studio", "dxf")
    answer = read(transformed(content, Matrix44.z_rotate(math.radians(20)), 6), name)
    assert not any(room.furniture for room in answer.scene.rooms)
    (left,) = [one for one in answer.unread if one["place"] == "furniture"]
    assert "which are not read in a drawing that was turned" in str(left["reason"])


def in_millimetres(content: bytes) -> bytes:
    """A drawing as a CAD programme scales it: each entity by 1000."""
    return transformed(content, Matrix44.scale(1000), 4)


def transformed(content: bytes, matrix: Matrix44, units: int) -> bytes:
    drawing = ezdxf.read(StringIO(content.decode()))  # type: ignore[attr-defined]
    for one in drawing.modelspace():
        if one.dxftype() not in ("DIMENSION", "HATCH"):
            one.transform(matrix)
    drawing.units = units
    return text_of(drawing).encode()


@pytest.mark.parametrize("format", ["procthor", "sh3d", "ifc", "svg", "dxf"])
@pytest.mark.parametrize(("hinge", "swing"), [("start", "in"), ("end", "out")])
def test_a_door_of_two_leaves_reads_back_as_one(format: str, hinge: str, swing: str) -> None:
    way = Opening("way", "door", "south", 2.0, 1.8, connects_to="b", hinge=hinge, swing=swing)
    back = replace(way, wall="north", connects_to="a", swing="out" if swing == "in" else "in", render_panel=False)
    front = Opening("front", "door", "west", 1.0, 1.6, connects_to=EXTERIOR, hinge="end", swing="in", main_entrance=True)
    rooms = (Room("a", 0, "living_room", width=4.0, depth=4.0, openings=(way, front)),
             Room("b", 1, "kitchen", z=4.0, width=4.0, depth=3.0, openings=(back,)))  # fmt: skip
    (name, content), *_ = export(Scene(wall_thickness=0.1, rooms=rooms), format).items()
    after = read(content, name).scene
    doors = [[one for one in room.openings if one.kind == "door"] for room in after.rooms]
    assert [len(one) for one in doors] == [2, 1]
    for one, (door, *more) in zip(rooms, doors, strict=True):
        wanted = one.openings[0]
        assert (door.wall, round(door.position, 2), round(door.width, 2)) == (wanted.wall, wanted.position, wanted.width)
        assert format == "ifc" or door.hinge == wanted.hinge
        assert door.swing == wanted.swing
        assert [round(other.width, 2) for other in more] == [1.6][: len(more)]


@pytest.mark.parametrize("outer", [0.3, 0.5, 0.6])
def test_a_window_no_wider_than_its_wall_is_thick_is_in_that_wall(outer: float) -> None:
    """What its frame and the wall's faces draw is square, or longer across the wall: the pane tells how it lies."""
    windows = (
        Opening("w", "window", "north", 1.5, 0.5, 0.6, sill=1.4, connects_to=EXTERIOR),
        Opening("v", "window", "east", 1.2, 0.6, 0.6, sill=1.4, connects_to=EXTERIOR),
        Opening("d", "door", "south", 1.5, 0.9, 2.1, connects_to=EXTERIOR, hinge="start", swing="in", main_entrance=True),
    )
    room = Room("a", type="office", width=4.0, depth=3.0, openings=windows, wall_thickness=(outer,) * 4)
    (name, content), *_ = export(Scene(wall_thickness=0.1, rooms=(room,)), "dxf").items()
    (after,) = read(content, name).scene.rooms
    assert sorted((one.kind, one.wall, round(one.position, 3), one.width) for one in after.openings) == [
        ("door", "south", 1.5, 0.9),
        ("window", "east", 1.2, 0.6),
        ("window", "north", 1.5, 0.5),
    ]
