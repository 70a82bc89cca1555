"""How much floor a tiny room must have: placement, the validator and a raster of its own say the same."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from solver.furnish.zones import space_of
from solver.pieces import Candidate, Piece, Stand
from solver.placement import Budget, walkable_when_empty
from solver.placement.walkable import find_walkable
from solver.scene import EXTERIOR, Furniture, Opening, Room, Scene
from solver.streams import Stream
from solver.validator import validate
from tests.sweeps import seeds
from tests.validator.raster import House, broken, sides, things
from tests.validator.worlds import CATALOGS, TURNED

STEP = 0.05
SEEDS = range(150)
FURNISHED = seeds(range(40), 7)
WIDE, DEEP = 8, 12
"""Of a piece that is used from its front, in steps."""


def length(stream: Stream, low: int, high: int) -> float:
    """Some steps of 5 cm."""
    return round(STEP * (low + stream.below(high - low + 1)), 2)


def tiny(seed: int) -> Scene:
    """A room of 1.1 to 2.2 m, a box, an L or one with two steps, with walls 10 to 30 cm thick and a door or two anywhere."""
    stream = Stream(seed, "tiny rooms")
    wide, deep = length(stream, 22, 44), length(stream, 22, 44)
    x, z, step = length(stream, 4, 14), length(stream, 4, 14), length(stream, 2, 6)
    outlines: tuple[tuple[tuple[float, float], ...] | None, ...] = (
        None,
        ((0.0, 0.0), (wide, 0.0), (wide, deep - z), (wide - x, deep - z), (wide - x, deep), (0.0, deep)),
        ((x, 0.0), (wide, 0.0), (wide, deep), (0.0, deep), (0.0, z + step), (x / 2, z + step), (x / 2, z), (x, z)),
    )
    outline = outlines[stream.below(3)]
    outline = outline and tuple((round(a * 20) / 20, round(b * 20) / 20) for a, b in outline)
    room = Room("wc", width=wide, depth=deep, outline=outline)
    lines = [(edge, start, end) for edge, (_, _, start, end) in enumerate(sides(room)) if end - start >= 18]
    doors = []
    for k in range(1 + stream.below(2)):
        edge, start, end = lines[stream.below(len(lines))]
        at = 8 + stream.below(end - start - 15)
        wall, low = sides(room)[edge][0], 0 if outline else start
        place: dict[str, Any] = {"edge": edge} if outline else {"wall": wall}
        door = Opening(f"door_{k}", "door", position=round(STEP * (at + low), 2), width=0.7, connects_to=EXTERIOR, **place)
        doors.append(replace(door, main_entrance=k == 0))
    return Scene(rooms=(replace(room, openings=tuple(doors)),), wall_thickness=(0.1, 0.2, 0.3)[stream.below(3)])


def refused(scene: Scene, *rules: str) -> bool:
    return any(issue.rule in (rules or ("unreachable",)) for issue in validate(scene, CATALOGS))


@pytest.mark.parametrize("ten", range(0, len(SEEDS), 10))
def test_all_say_the_same_of_an_empty_room(ten: int) -> None:
    for seed in SEEDS[ten : ten + 10]:
        scene = tiny(seed)
        (room,) = scene.rooms
        enough = House(scene, 0.6).area(room.id) >= 0.25 - 1e-9
        assert refused(scene) is not enough, seed
        walks = walkable_when_empty(space_of(room, scene.wall_thickness))
        assert walks is enough or (len(room.openings) == 2 and not walks), seed


def with_piece(scene: Scene, x0: float, z0: float, rotation: int) -> Scene:
    """The room with a piece at a corner, m."""
    wide, deep = (STEP * DEEP, STEP * WIDE) if rotation in (90, 270) else (STEP * WIDE, STEP * DEEP)
    sizes: dict[str, Any] = {"width": STEP * WIDE, "depth": STEP * DEEP, "height": 0.8, "rotation": rotation}
    piece = Furniture(id="sofa_1", name="sofa", x=x0 + wide / 2, z=z0 + deep / 2, **sizes)
    return replace(scene, rooms=(replace(scene.rooms[0], furniture=(piece,)),))


def stands_on_the_raster(scene: Scene) -> bool:
    """Whether the raster knows a place, of every tenth of a metre, where the piece is come to and enough floor is left."""
    (room,) = scene.rooms
    for rotation in TURNED.values():
        for x in range(0, round(room.width / STEP), 2):
            for z in range(0, round(room.depth / STEP), 2):
                tried = with_piece(scene, x * STEP, z * STEP, rotation)
                if broken(tried):
                    continue
                house = House(tried, 0.6)
                (body,) = things(tried.rooms[0])
                if house.area(room.id) >= 0.25 - 1e-9 and house.touches(room, body, "front"):
                    return True
    return False


@pytest.mark.parametrize("ten", range(0, len(FURNISHED), 10))
def test_what_is_placed_is_not_refused_and_what_cannot_be_does_not_exist(ten: int) -> None:
    for seed in FURNISHED[ten : ten + 10]:
        scene = tiny(seed)
        (room,) = scene.rooms
        ways = tuple(Candidate("sofa", (50 * WIDE, 50 * DEEP, 800), turn, None, (900, 900)) for turn in TURNED.values())
        piece = Piece("sofa", True, ways, stands=(Stand("front"),))
        verdict, found = find_walkable(space_of(room, scene.wall_thickness), (piece,), Budget())
        if verdict:
            at = found[0]
            tried = with_piece(scene, at.footprint.x0 / 1000, at.footprint.z0 / 1000, at.candidate.rotation)
            assert not refused(tried, "unreachable", "overlap", "out_of_bounds", "blocks_door"), seed
        elif verdict is False and len(room.openings) == 1:
            assert not stands_on_the_raster(scene), seed
