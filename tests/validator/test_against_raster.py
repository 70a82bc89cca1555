"""The validator against a look at every 5 cm of floor, on random little houses: the same issues, no more and no less."""

from __future__ import annotations

from typing import Any

from hypothesis import given
from hypothesis import strategies as st

from solver.scene import Furniture, Opening, Room, Scene
from solver.validator import validate
from tests.sweeps import examples
from tests.validator.raster import House, broken, things
from tests.validator.worlds import CATALOGS, WALLS

NAMES = ("sofa", "bed", "stove", "desk", "crate", "vase")
OUTLINES = {
    "L": lambda w, d: ((0.0, 0.0), (w, 0.0), (w, 1.5), (w - 1.5, 1.5), (w - 1.5, d), (0.0, d)),
    "T": lambda w, d: ((0.0, 0.0), (w, 0.0), (w, 1.5), (w - 0.8, 1.5), (w - 0.8, d), (0.8, d), (0.8, 1.5), (0.0, 1.5)),
    "U": lambda w, d: ((0.0, 0.0), (1.2, 0.0), (1.2, 1.0), (w - 1.2, 1.0), (w - 1.2, 0.0), (w, 0.0), (w, d), (0.0, d)),
}


def tenths(low: float, high: float) -> st.SearchStrategy[float]:
    return st.integers(round(low * 10), round(high * 10)).map(lambda count: count / 10)


def twentieths(low: float, high: float) -> st.SearchStrategy[float]:
    return st.integers(round(low * 20), round(high * 20)).map(lambda count: count / 20)


@st.composite
def furniture(draw: st.DrawFn, room: str, size: tuple[float, float], index: int) -> Furniture:
    width, depth, rotation = draw(tenths(0.1, 1.4)), draw(tenths(0.1, 1.4)), draw(st.sampled_from([0, 90, 180, 270]))
    others = st.none() | st.integers(0, 4).map(lambda other: f"{room}/{other}")
    return Furniture(
        id=f"{room}/{index}",
        name=draw(st.sampled_from(NAMES)),
        x=draw(twentieths(-0.1, size[0] + 0.1)),
        z=draw(twentieths(-0.1, size[1] + 0.1)),
        y=draw(st.sampled_from([0.0, 0.0, 0.0, 0.5, 2.0])),
        rotation=rotation,
        width=width,
        depth=depth,
        height=draw(st.sampled_from([0.1, 0.5, 0.9, 1.0, 2.0])),
        wall=None if draw(st.booleans()) else draw(st.sampled_from(WALLS)),
        under=draw(others) if draw(st.booleans()) else None,
        on=draw(others) if draw(st.integers(0, 3)) == 0 else None,
    )


@st.composite
def openings(draw: st.DrawFn, room: str, size: tuple[float, float], edges: list[float] | None) -> tuple[Opening, ...]:
    found = []
    for index in range(draw(st.integers(0, 2))):
        wall = draw(st.sampled_from(WALLS))
        place: dict[str, Any] = {"wall": wall}
        length = size[0] if wall in ("north", "south") else size[1]
        if edges is not None:
            edge = draw(st.integers(0, len(edges) - 1))
            place, length = {"edge": edge}, edges[edge]
        kind = draw(st.sampled_from(["door", "passage", "garage_door", "window"]))
        width = min(draw(st.sampled_from([0.4, 0.6, 0.8, 1.2])), length)
        position = draw(tenths(width / 2 - 0.05, length - width / 2)) if length > width + 0.2 else length / 2
        half_on_raster = round(width * 20) % 2 == 0
        position = round(position * 20) / 20 if half_on_raster else position
        sill = 0.9 if kind == "window" else 0.0
        place |= {"position": position, "width": width, "height": 1.1, "sill": sill}
        found.append(Opening(f"{room}:{index}", kind, connects_to="EXTERIOR", **place))
    return tuple(found)


@st.composite
def rooms(draw: st.DrawFn, name: str, x: float, z: float, shapes: bool) -> Room:
    width, depth = draw(tenths(2.6, 4.5)), draw(tenths(2.6, 4.5))
    shape = draw(st.sampled_from(sorted(OUTLINES))) if shapes and draw(st.booleans()) else None
    outline = OUTLINES[shape](width, depth) if shape else None
    if outline and draw(st.booleans()):
        outline = outline[::-1]
    outline = tuple((round(px, 2), round(pz, 2)) for px, pz in outline) if outline else None
    pieces = tuple(draw(furniture(name, (width, depth), index)) for index in range(draw(st.integers(0, 5))))
    if outline:
        pieces = tuple(Furniture(**{**vars(piece), "wall": None}) for piece in pieces)
    edges = None
    if outline:
        following = outline[1:] + outline[:1]
        edges = [round(abs(a[0] - b[0]) + abs(a[1] - b[1]), 2) for a, b in zip(outline, following, strict=True)]
    doors = draw(openings(name, (width, depth), edges))
    return Room(name, x=x, z=z, width=width, depth=depth, outline=outline, furniture=pieces, openings=doors)


def told(scene: Scene, *rules: str) -> set[tuple[str, str | None, tuple[str, ...]]]:
    return {(issue.rule, issue.room, issue.ids) for issue in validate(scene, CATALOGS) if not rules or issue.rule in rules}


STANDING = ("out_of_bounds", "overlap", "wall_far", "blocks_door", "blocks_window")


@examples(60)
@given(rooms("a", 0.0, 0.0, shapes=True), st.sampled_from([0.0, 0.1]))
def test_standing_agrees_with_the_raster(room: Room, thickness: float) -> None:
    scene = Scene(rooms=(room,), wall_thickness=thickness)
    assert told(scene, *STANDING) == broken(scene)


@st.composite
def houses(draw: st.DrawFn) -> Scene:
    """Two rooms with a common wall and a door in it, at a height where they need not meet; ways in from outside."""
    first = draw(rooms("a", 1.0, 1.0, shapes=False))
    eastwards, shift = draw(st.booleans()), draw(tenths(-0.9, 0.9))
    x, z = (1.0 + first.width, 1.0 + shift) if eastwards else (1.0 + shift, 1.0 + first.depth)
    second = draw(rooms("b", round(x, 2), round(z, 2), shapes=False))
    walls = ("east", "west") if eastwards else ("south", "north")
    width = draw(st.sampled_from([0.4, 0.6, 0.8, 1.2]))
    position = draw(tenths(1.2, 1.6))
    door = Opening("ab", "door", walls[0], position, width, connects_to="b")
    mirror = Opening("ab", "door", walls[1], round(position - shift, 2), width, connects_to="a")
    listed = draw(st.sampled_from(["both", "first", "second"]))
    first = Room(**{**vars(first), "openings": (*first.openings, *([door] if listed != "second" else []))})
    second = Room(**{**vars(second), "openings": (*second.openings, *([mirror] if listed != "first" else []))})
    entrance = Opening("in", "door", "north", draw(tenths(0.6, 1.8)), 1.0, connects_to="EXTERIOR", main_entrance=draw(st.booleans()))
    first = Room(**{**vars(first), "openings": (*first.openings, entrance)})
    robot = draw(st.sampled_from([0.4, 0.6, 0.8]))
    return Scene(rooms=(first, second), wall_thickness=0.1, request={"robot_width": robot})


def unreached(scene: Scene) -> set[tuple[str, str, tuple[str, ...]]]:
    """What the raster says cannot be walked to."""
    house = House(scene, float(str((scene.request or {})["robot_width"])))
    found: set[tuple[str, str, tuple[str, ...]]] = set()
    for room in scene.rooms:
        if house.area(room.id) < 0.25 - 1e-9:
            found.add(("unreachable", room.id, ()))
            continue
        for body in things(room):
            entry = CATALOGS.furniture.get(body.piece.name) or (CATALOGS.furniture["corner_desk"] if body.piece.name == "desk" else None)
            if entry and entry.use:
                met = [house.touches(room, body, side) for side in entry.use.sides]
                if not (all(met) if entry.use.need == "all" else any(met)):
                    found.add(("unreachable", room.id, (body.piece.id,)))
    return found


@examples(20)
@given(houses())
def test_walking_agrees_with_the_raster(scene: Scene) -> None:
    assert told(scene, "unreachable") == unreached(scene)
