"""place() in rooms of others, where what stands leaves the room, shares space, closes doors or cannot be come to."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import inf
from random import Random

import pytest

from catalogs import load_catalogs
from catalogs.schema import RelationSpec
from solver import place
from solver.pieces import Piece, Space
from solver.placement import walkable_when_empty
from solver.placement.budget import work_of_call
from solver.requested import PieceRequest
from solver.scene import Furniture, Opening, Room, Scene
from solver.validator import validate

DOOR = Opening("door", "door", "south", 0.7, 0.9, 2.0, connects_to="EXTERIOR", main_entrance=True)
THROWN = {"bed": (1.6, 2.0, 0.9), "desk": (1.4, 0.7, 0.7), "bookshelf": (1.0, 0.3, 1.8), "sofa": (2.2, 0.9, 0.85), "crate": (0.8, 0.8, 0.8)}
WANTED = ("armchair", "floor_lamp", "dining_chair", "bookshelf", "coffee_table", "dresser")


def thrown_room(random: Random) -> Room:
    """A room in which a few pieces lie about, in a third of all cases partly beyond a wall."""
    width, depth = random.choice((3.2, 4.0, 4.8)), random.choice((3.6, 4.4))
    pieces = []
    for k in range(random.choice((2, 3, 4))):
        name = random.choice([*THROWN])
        x, z = round(random.uniform(0.1, width - 0.1), 2), round(random.uniform(0.1, depth - 0.1), 2)
        wide, deep, high = THROWN[name]
        turn = random.choice((0, 90, 180, 270))
        pieces.append(Furniture(f"{name}_{k}", name, x=x, z=z, rotation=turn, width=wide, depth=deep, height=high))
    return Room("den", width=width, depth=depth, openings=(DOOR,), furniture=tuple(pieces))


def errors(scene: Scene) -> set[tuple[str, tuple[str, ...]]]:
    return {(issue.rule, issue.ids) for issue in validate(scene) if issue.severity == "error"}


@pytest.mark.parametrize("seed", range(4))
def test_nothing_comes_wrong_by_what_is_placed_beside_what_is_wrong_already(seed: int) -> None:
    random, came, stood = Random(f"furnished {seed}"), list[object](), 0
    for number in range(15):
        room = thrown_room(random)
        answer = place(room, [PieceRequest(kind) for kind in random.sample(WANTED, 2)])
        before = errors(Scene(rooms=(room,)))
        came += [(number, one) for one in errors(answer.best.scene) - before if ("unreachable", ()) not in before]
        stood += not answer.best.unplaced
    assert came == []
    assert stood >= 10


@pytest.mark.parametrize(("z", "rotation"), [(0.42, 0), (0.1, 0), (0.0, 180)])
def test_relations_are_to_what_leaves_the_room_too(z: float, rotation: int) -> None:
    stands = Furniture("sofa", "sofa", x=2.0, z=z, rotation=rotation, width=2.0, depth=0.9, height=0.85)
    beside = PieceRequest("side_table", relations=(RelationSpec(type="beside", of=("sofa",), required=True),))
    answer = place(Room("den", width=4.0, depth=4.0, openings=(DOOR,), furniture=(stands,)), [beside])
    assert [one.held for one in answer.best.relations] == [True]


def test_a_room_in_which_all_can_be_come_to_is_walked_no_oftener_with_more_in_it(monkeypatch: pytest.MonkeyPatch) -> None:
    walks = list[int]()

    def counted(space: Space, there: Sequence[Piece] = ()) -> bool:
        walks.append(len(there))
        return walkable_when_empty(space, there)

    monkeypatch.setattr("solver.pipeline.staying.walkable_when_empty", counted)
    made = list[int]()
    for count in (2, 12):
        beds = (Furniture(f"bed_{k}", "bed", x=1.5 + 3 * k, z=1.2, width=1.6, depth=2.0, height=0.9) for k in range(count))
        answer = place(Room("hall", width=40.0, depth=6.0, openings=(DOOR,), furniture=tuple(beds)), [PieceRequest("armchair")])
        assert (answer.best.unplaced, answer.best.issues) == ((), ())
        made.append(len(walks))
    assert made[1] == 2 * made[0]


def test_things_are_put_onto_what_stands_raised_or_on_another_piece() -> None:
    table = Furniture("table", "dining_table", x=2.0, z=2.0, width=1.6, depth=0.9, height=0.75)
    box = Furniture("box", "nightstand", x=2.5, z=2.0, y=0.75, width=0.46, depth=0.4, height=0.55, on="table")
    hung = Furniture("hung", "sideboard", x=2.0, z=0.3, y=0.3, width=1.6, depth=0.44, height=0.84)
    room = Room("den", width=4.0, depth=4.0, openings=(DOOR,), furniture=(table, box, hung))
    for carrier, top in (("table", 0.75), ("box", 1.3), ("hung", 1.14)):
        plant = PieceRequest("plant", "plant", 0.2, 0.2, 0.3, relations=(RelationSpec(type="on", of=(carrier,), required=True),))
        answer = place(room, [plant])
        assert [(one.on, one.y) for one in answer.best.scene.rooms[0].furniture if one.id == "plant"] == [(carrier, top)]
        assert errors(answer.best.scene) == set()


@pytest.mark.parametrize(
    ("name", "size", "seat"),
    [("sofa", (2.2, 0.9, 0.7), 0.45 / 0.85), ("bed", (1.6, 2.0, 0.5), 0.5 / 0.9), ("silla", (1.4, 0.6, 0.5), 0.46 / 0.9)],
)
def test_a_seat_is_as_much_lower_as_what_it_is_part_of(name: str, size: tuple[float, float, float], seat: float) -> None:
    upon = PieceRequest("box", "microwave", 0.3, 0.2, 0.2, relations=(RelationSpec(type="on", of=("seat",), required=True),))
    answer = place(Room("den", width=4.0, depth=4.0, openings=(DOOR,)), [PieceRequest("seat", name, *size), upon])
    assert [one.y for one in answer.best.scene.rooms[0].furniture if one.id == "box"] == [pytest.approx(seat * size[2], abs=0.01)]
    assert errors(answer.best.scene) == set()


WAY = Opening("way", "door", "west", 0.43, 0.8, 2.0)


@pytest.mark.parametrize(
    ("size", "doors", "stands", "wanted"),
    [
        ((3.77, 3.54), (), (("sideboard", 2.28, 0.0, 0.76, 90), ("car", -0.02, 0.0, 3.48, 270), ("deck_chair", -0.15, 1.9, 0.63, 0),
                            ("dining_table", 2.64, 0.0, 2.19, 180), ("grill", 1.15, 0.0, 1.42, 270)), ("dog",)),
        ((4.18, 2.83), (WAY,), (("sink", 2.89, 0.0, 0.85, 180), ("small_shower", 2.41, 0.0, 2.17, 270), ("ottoman", 2.68, 0.0, 1.15, 270),
                                ("vanity", 1.16, 0.0, 1.63, 180)), ("medium_wardrobe", "hall_bench")),
    ],
    ids=["no doors", "no way in"],
)  # fmt: skip
def test_where_nobody_comes_in_one_walks_where_most_floor_is_once_all_stands(
    size: tuple[float, float], doors: tuple[Opening, ...], stands: Sequence[tuple[str, float, float, float, int]], wanted: Sequence[str]
) -> None:
    kinds = load_catalogs().furniture
    pieces = []
    for name, x, y, z, turn in stands:
        wide, deep, high = kinds[name].size
        pieces.append(Furniture(name, name, x=x, y=y, z=z, rotation=turn, width=wide, depth=deep, height=high))
    room = Room("den", width=size[0], depth=size[1], openings=doors, furniture=tuple(pieces))
    answer = place(room, [PieceRequest(name) for name in wanted])
    assert errors(answer.best.scene) - errors(Scene(rooms=(room,))) == set()


def test_a_room_in_which_nobody_comes_in_is_no_more_work_where_not_all_fits() -> None:
    steps = ((5.02, 7.26), (1.84, 7.26), (1.84, 1.69), (0.0, 1.69), (0.0, 0.0), (3.52, 0.0), (3.52, 5.57), (5.02, 5.57))
    windows = tuple(
        Opening(f"window_{edge}", "window", edge=edge, position=at, width=wide, height=1.2, sill=0.9, connects_to="EXTERIOR")
        for edge, at, wide in ((0, 1.18, 1.0), (4, 2.48, 1.3))
    )
    wanted = ("car", "table_saw", "small_bed", "garden_shed", "floor_lamp", "office_chair")
    with work_of_call(inf) as work:
        answer = place(Room("den", width=5.02, depth=7.26, outline=steps, openings=windows), [PieceRequest(name) for name in wanted])
    assert {one.id for one in answer.best.unplaced} == {"car", "garden_shed"}
    assert work.done < 200_000


def test_what_stands_at_walls_may_stand_at_inner_edges_of_an_outline_where_windows_take_the_others() -> None:
    steps = ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 2.0), (2.0, 4.0), (0.0, 4.0))
    sizes = {0: ("window", 3.8), 1: ("door", 0.9), 4: ("window", 1.8), 5: ("window", 3.8)}
    lengths = {0: 4.0, 1: 2.0, 4: 2.0, 5: 4.0}
    openings = tuple(
        Opening(f"{kind}_{edge}", kind, edge=edge, position=lengths[edge] / 2, width=wide, height=1.5, connects_to="EXTERIOR")
        for edge, (kind, wide) in sizes.items()
    )
    room = Room("den", width=4.0, depth=4.0, outline=steps, openings=openings)
    answer = place(room, [PieceRequest("wardrobe")])
    assert (answer.best.unplaced, errors(answer.best.scene)) == ((), set())
    (wardrobe,) = answer.best.scene.rooms[0].furniture
    assert (wardrobe.rotation, wardrobe.wall) in {(180, None), (270, None)}


@pytest.mark.parametrize(("size", "z", "table"), [((2.17, 2.25), 0.9704, (1.36, 0.49)), ((1.93, 1.79), 0.6904, (0.98, 0.57))])
def test_what_stands_between_millimetres_is_come_to_beside_what_is_placed(
    size: tuple[float, float], z: float, table: tuple[float, float]
) -> None:
    """A person before an armchair stands with the middle within its front, which is shorter than the millimetres around it."""
    door = replace(DOOR, position=size[0] - 0.5, main_entrance=False)
    chair = Furniture("chair", "armchair", x=0.4, z=z, rotation=90, width=0.8, depth=0.8, height=0.8)
    room = Room("den", width=size[0], depth=size[1], openings=(door,), furniture=(chair,))
    answer = place(room, [PieceRequest("coffee_table", width=table[0], depth=table[1], height=0.4)])
    assert not answer.best.unplaced
    assert errors(answer.best.scene) == errors(Scene(rooms=(room,)))


def test_what_stands_is_no_wall_for_what_stands_at_walls_though_nobody_can_walk_beside_it() -> None:
    walls = (("north", 2.2), ("south", 2.2), ("east", 2.3), ("west", 2.3))
    windows = tuple(Opening(wall, "window", wall, long / 2, long - 0.1, 1.5, sill=0.2, connects_to="EXTERIOR") for wall, long in walls)
    crates = tuple(
        Furniture(f"crate_{k}", "crate", x=1.1, z=z, width=wide, depth=deep, height=1.0)
        for k, (z, wide, deep) in enumerate([(0.85, 1.1, 1.1), (2.05, 2.2, 0.5)])
    )
    room = Room("den", width=2.2, depth=2.3, openings=windows, furniture=crates)
    answer = place(room, [PieceRequest("bookshelf", width=0.6, depth=0.25)])
    assert [piece.id for piece in answer.best.scene.rooms[0].furniture] == ["crate_0", "crate_1"]
    assert [one.id for one in answer.best.unplaced] == ["bookshelf"]


def onto(carrier: str, required: bool = True) -> tuple[RelationSpec, ...]:
    return (RelationSpec(type="on", of=(carrier,), required=required),)


@pytest.mark.parametrize("height", [2.5, 3.0])
def test_nothing_is_put_through_the_ceiling_onto_what_stands_raised(height: float) -> None:
    hung = Furniture("hung", "sideboard", x=2.0, z=0.3, y=1.9, width=1.6, depth=0.44, height=0.4)
    table = Furniture("table", "dining_table", x=2.0, z=2.0, width=1.6, depth=0.9, height=0.75)
    room = Room("den", width=4.0, depth=4.0, openings=(DOOR,), furniture=(hung, table))
    box = PieceRequest("box", "crate", 0.6, 0.6, 1.5, relations=onto("table"))
    plants = [PieceRequest(f"plant_{on}", "plant", 0.2, 0.2, 0.3, relations=onto(on)) for on in ("hung", "box")]
    answer = place(room, [box, *plants], height=height)
    stands = {one.id: one.y for one in answer.best.scene.rooms[0].furniture if one.on or one.id.startswith("plant")}
    assert stands == {"box": 0.75} | ({} if height == 2.5 else {"plant_hung": 2.3, "plant_box": 2.25})
    assert errors(answer.best.scene) == set()


@pytest.mark.parametrize("width", [0.4, 1.7])
def test_things_stand_as_high_as_what_carries_them_wherever_that_goes(width: float) -> None:
    table = Furniture("table", "dining_table", x=2.0, z=2.0, width=1.6, depth=0.9, height=0.75)
    room = Room("den", width=4.0, depth=4.0, openings=(DOOR,), furniture=(table,))
    box = PieceRequest("box", "crate", width, 0.4, 0.5, relations=onto("table", required=False))
    answer = place(room, [box, PieceRequest("plant", "plant", 0.2, 0.2, 0.3, relations=onto("box"))])
    heights = {one.id: one.y for one in answer.best.scene.rooms[0].furniture}
    assert heights == {"table": 0.0, "box": 0.75, "plant": 1.25} if width == 0.4 else {"table": 0.0, "box": 0.0, "plant": 0.5}
    assert errors(answer.best.scene) == set()
