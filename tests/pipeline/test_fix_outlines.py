"""fix() in L, T and U shaped rooms, and with doors that only the other room lists; judged by the validator."""

from __future__ import annotations

from dataclasses import replace

import pytest

from solver import Scene, fix
from solver.scene import Opening, Room
from solver.streams import Stream
from tests.pipeline.fix_rooms import BACK_TO, body, errors, pieces, room_of

pytestmark = pytest.mark.usefixtures("geometry_alone")
SHAPES = {
    "L": ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0)),
    "T": ((0.0, 0.0), (4.5, 0.0), (4.5, 1.8), (3.0, 1.8), (3.0, 4.0), (1.2, 4.0), (1.2, 1.8), (0.0, 1.8)),
    "U": ((0.0, 0.0), (1.5, 0.0), (1.5, 1.7), (3.3, 1.7), (3.3, 0.0), (4.8, 0.0), (4.8, 3.5), (0.0, 3.5)),
}
SIDES = ("north", "west", "south", "east")


def shaped(shape: str, *furniture: object, mirrored: bool = False) -> Scene:
    corners = SHAPES[shape]
    width, depth = max(x for x, _ in corners), max(z for _, z in corners)
    outline = tuple((round(width - x, 4), z) for x, z in corners) if mirrored else corners
    return room_of(*furniture, width=width, depth=depth, outline=outline)  # type: ignore[arg-type]


def laid_out(shape: str, seed: int) -> Scene:
    """Pieces that stand well, found by trial: half of them at walls, inner edges among these."""
    stream = Stream(seed, f"laid out {shape}")
    scene = shaped(shape, mirrored=seed % 2 == 1)
    width, depth = scene.rooms[0].width, scene.rooms[0].depth
    for k in range(120):
        wall = SIDES[stream.below(4)] if stream.chance(0.6) else None
        size = (0.4 + stream.below(700) / 1000, 0.4 + stream.below(400) / 1000, 0.5 + stream.below(1500) / 1000)
        x, z = round(stream.unit() * width, 3), round(stream.unit() * depth, 3)
        piece = replace(body(f"piece_{k}", x, z, size, wall=wall), rotation=BACK_TO[wall or "north"])
        room = replace(scene.rooms[0], furniture=(*scene.rooms[0].furniture, piece))
        if len(room.furniture) <= 5 and not errors(replace(scene, rooms=(room,))):
            scene = replace(scene, rooms=(room,))
    return scene


def stirred(scene: Scene, seed: int) -> Scene:
    stream = Stream(seed, "stir outline")
    furniture = [
        replace(piece, x=round(piece.x + stream.uniform(-0.5, 0.5), 3), z=round(piece.z + stream.uniform(-0.5, 0.5), 3))
        for piece in scene.rooms[0].furniture
    ]
    return replace(scene, rooms=(replace(scene.rooms[0], furniture=tuple(furniture)),))


@pytest.mark.parametrize("shape", SHAPES)
@pytest.mark.parametrize("seed", range(8))
def test_a_stirred_outlined_room_that_can_be_laid_out_is_repaired(shape: str, seed: int) -> None:
    good = laid_out(shape, seed)
    assert len(good.rooms[0].furniture) >= 3
    assert fix(good).scene == good
    fixed = fix(stirred(good, seed))
    assert errors(fixed.scene) == [], fixed.conflicts
    assert fixed.conflicts == ()
    assert fix(fixed.scene).scene == fixed.scene


def test_the_missing_part_of_an_l_shaped_room_stays_empty() -> None:
    fixed = fix(shaped("L", body("sofa_1", 3.0, 2.1, (1.6, 0.8, 0.8))))
    assert errors(fixed.scene) == []
    assert fixed.moves[0].dz == pytest.approx(-0.5, abs=1e-3)


def test_a_piece_at_an_inner_edge_stays_at_it() -> None:
    shelf = replace(body("shelf_1", 3.0, 1.85, (1.0, 0.3, 1.8), wall="south"), rotation=180)
    fixed = fix(shaped("L", shelf, body("box_1", 3.4, 1.6, (0.6, 0.6, 0.6), locked=True)))
    assert errors(fixed.scene) == []
    after = pieces(fixed.scene)["room_0/shelf_1"]
    assert (after.wall, after.rotation, after.z) == ("south", 180, 1.85)
    assert after.x == pytest.approx(2.6, abs=1e-3)


def test_a_piece_finds_the_inner_edge_when_its_wall_is_taken() -> None:
    shelf = body("shelf_1", 0.75, 0.2, (1.4, 0.3, 1.8), wall="north")
    taken = [body(f"block_{k}", x, 0.5, (1.49, 1.0, 1.0), locked=True) for k, x in enumerate((0.75, 4.05))]
    fixed = fix(shaped("U", shelf, *taken))
    assert errors(fixed.scene) == []
    after = pieces(fixed.scene)["room_0/shelf_1"]
    assert after.wall == "north"
    assert after.z == pytest.approx(1.85, abs=0.2)


@pytest.mark.parametrize("name", ["bookshelf", "box"])
def test_a_piece_far_from_its_wall_says_at_which_inner_edge_it_is_now(name: str) -> None:
    """Its back is turned to the inner edge, 0.3 m away, and what it names as its wall is 2.3 m away."""
    outline = ((0.0, 0.0), (2.8, 0.0), (2.8, 2.4), (4.0, 2.4), (4.0, 4.0), (0.0, 4.0))
    piece = replace(body(f"{name}_1", 2.45, 1.2, (1.0, 0.3, 1.8), wall="west"), rotation=270)
    fixed = fix(room_of(piece, width=4.0, depth=4.0, outline=outline))
    assert errors(fixed.scene) == [], fixed.conflicts
    assert pieces(fixed.scene)[piece.id].wall == "east"


def test_a_counter_clockwise_outline_is_the_same_room() -> None:
    scene = shaped("L", body("sofa_1", 3.0, 2.1, (1.6, 0.8, 0.8)))
    turned = replace(scene, rooms=(replace(scene.rooms[0], outline=tuple(reversed(SHAPES["L"]))),))
    assert fix(turned).moves == fix(scene).moves


def test_a_door_that_only_the_other_room_lists_keeps_its_square_here() -> None:
    door = Opening("door_1", "door", "east", 2.0, 0.9, connects_to="room_0", main_entrance=True)
    hall = Room("hall", 1, "hallway", 0, -3.0, 0.0, 3.0, 4.0, openings=(door,))
    scene = room_of(body("box_1", 0.6, 2.0, (0.8, 0.8, 0.8)))
    scene = replace(scene, rooms=(*scene.rooms, hall))
    assert errors(scene)
    fixed = fix(scene)
    assert errors(fixed.scene) == []
    assert fixed.moves[0].dx == pytest.approx(0.7, abs=1e-3)
    still = replace(scene, rooms=(replace(scene.rooms[0], furniture=(body("box_1", 0.6, 2.0, (0.8, 0.8, 0.8), locked=True),)), hall))
    (conflict,) = fix(still).conflicts
    assert "in the floor before door_1" in conflict.message


@pytest.mark.parametrize("seed", range(20))
def test_lengths_between_millimetres_are_repaired_exactly(seed: int) -> None:
    stream = Stream(seed, "between millimetres")

    def near(value: float) -> float:
        return round(value + stream.uniform(-0.0009, 0.0009), 6)

    door = Opening("d", "door", "south", near(1.5), near(0.8), connects_to="EXTERIOR", main_entrance=True)
    window = Opening("w", "window", "north", near(1.5), near(1.2), 1.4, near(0.9), "EXTERIOR")
    furniture = [body(f"box_{k}", near(1.5), near(1.5 + k), (near(0.7), near(0.6), near(1.0))) for k in range(3)]
    scene = room_of(*furniture, width=near(3.0), depth=near(3.5), openings=(door, window))
    assert errors(scene)
    assert errors(fix(scene).scene) == []
