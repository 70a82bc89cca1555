"""A room that is turned, mirrored, moved, or whose list is told otherwise is the same room: the same pieces, relations and cost.

What is mirrored may only differ where a catalog or a relation says left or right: a desk with its drawers on one side.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache
from typing import Any, NamedTuple

import pytest

from catalogs import load_catalogs
from service.contract import PlaceBody
from solver import place
from solver.exchange import read
from solver.pipeline.frames import frame_of
from solver.pipeline.place_task import PlaceSetting, task_of
from solver.requested import Answered
from solver.scene import Furniture, Opening, Room
from tests.pipeline.place_lists import drawn
from tests.pipeline.turned import Request, mirrored, moved, permuted, renamed, turned
from tests.place_rooms import place_request
from tests.sweeps import seeds

TOLD_OTHERWISE: list[Callable[[Request], Request]] = [turned, lambda request: turned(turned(request)), moved, renamed, permuted]
HANDED = ("desk", "workbench")
"""What has drawers on one side, where something reaches under it."""
CATALOGS = load_catalogs()
SEEDS = seeds(range(1000), 221)
EXACT = 1e-6


class Verdict(NamedTuple):
    """What must be the same: pieces left out, what the missed relations are worth, the placement's cost, what is proven, errors."""

    left_out: int
    missed: float
    cost: float
    proven: bool
    best: bool
    errors: int


def answered(request: Request) -> Answered:
    body = read(PlaceBody, request)
    return place(body.room, body.pieces, wall_thickness=body.wall_thickness, catalogs=CATALOGS)


def verdict(request: Request) -> Verdict:
    best = answered(request).best
    certificate: Any = best.scene.certificate
    (told,) = certificate["rooms"].values()
    errors = sum(issue.severity == "error" for issue in best.issues)
    return Verdict(len(best.unplaced), best.cost, round(told["cost"], 6), told.get("proven", False), told.get("best", False), errors)


def is_handed(request: Request) -> bool:
    return any(piece["name"] in HANDED for piece in request["pieces"])


def without_relations(seed: int) -> Request:
    room, wanted = drawn(seed)
    openings = [{"kind": one.kind, "wall": one.wall, "position": one.position, "width": one.width, "height": one.height, "sill": one.sill,
                 "connects_to": one.connects_to} for one in room.openings]  # fmt: skip
    pieces: list[dict[str, Any]] = [
        {"id": one.id, "name": one.name, "width": one.width, "depth": one.depth, "height": one.height, "count": one.count, "relations": []}
        for one in wanted
    ]
    return {"room": {"id": "room", "width": room.width, "depth": room.depth, "openings": openings}, "pieces": pieces}


@cache
def of_seed(seed: int) -> tuple[Request, Verdict]:
    request = place_request(seed)
    return request, verdict(request)


@pytest.mark.parametrize("seed", SEEDS)
def test_a_room_told_otherwise_is_the_same_room(seed: int) -> None:
    request, own = of_seed(seed)
    assert [verdict(told(request)) for told in TOLD_OTHERWISE] == [own] * len(TOLD_OTHERWISE)


def test_a_fourth_of_the_rooms_is_proven_best() -> None:
    verdicts = [of_seed(seed)[1] for seed in SEEDS]
    assert sum(own.proven and own.best for own in verdicts) >= len(verdicts) / 4


def test_lists_with_too_many_ways_are_searched_among_the_likeliest_only() -> None:
    tables: list[dict[str, Any]] = [{"id": f"table_{k}", "name": "dining_table", "relations": []} for k in range(6)]
    at = [table["id"] for table in tables]
    relations = [{"type": "around", "of": at}, {"type": "near", "of": at}, {"type": "facing", "of": at[0]}, {"type": "in_corner"}]
    chairs = [{"id": f"chair_{k}", "name": "dining_chair", "relations": relations} for k in range(4)]
    room = {"id": "room", "width": 9.0, "depth": 8.0, "openings": []}
    ways = []
    for pieces in ([*tables, *chairs], tables[:1]):
        body = read(PlaceBody, {"room": room, "pieces": pieces})
        ways.append(task_of(body.room, body.pieces, CATALOGS, PlaceSetting(0.1, 0.6, "osqp", None)).listing.nearly_all)
    assert ways[0] is None
    assert ways[1] is not None


@pytest.mark.parametrize("seed", SEEDS)
def test_a_mirrored_room_is_the_same_room(seed: int) -> None:
    request, own = of_seed(seed)
    other = verdict(mirrored(request))
    if not is_handed(request):
        assert other == own
    assert other.errors == 0


@pytest.mark.parametrize("seed", seeds(range(200), 47))
def test_a_list_without_relations_told_otherwise_is_the_same(seed: int) -> None:
    request = without_relations(seed)
    own = verdict(request)
    told = [*TOLD_OTHERWISE[:3], *([] if is_handed(request) else [mirrored])]
    assert [verdict(one(request)) for one in told] == [own] * len(told)


@pytest.mark.parametrize("seed", seeds(range(200), 47))
def test_what_is_taken_away_leaves_no_less_room(seed: int) -> None:
    """All still stand where one piece that nobody refers to is not asked for, and where the room is longer."""
    request, own = of_seed(seed)
    named = {relation.get("of") for piece in request["pieces"] for relation in piece["relations"]}
    spare = [piece for piece in request["pieces"] if piece["id"] not in named]
    if own.left_out == 0:
        fewer = {**request, "pieces": [piece for piece in request["pieces"] if piece is not spare[-1]]} if spare else request
        longer = {**request, "room": {**request["room"], "depth": request["room"]["depth"] + 1.0}}
        assert verdict(fewer).left_out == 0
        assert verdict(longer).left_out == 0


@pytest.mark.parametrize("seed", seeds(range(0, 40, 4), 3))
def test_the_pieces_stand_where_they_stood(seed: int) -> None:
    """Turned four times, pose by pose."""
    request, _ = of_seed(seed)
    poses = []
    for quarters in range(4):
        room = answered(request).best.scene.rooms[0]
        found = sorted(_pose(piece, room, quarters) for piece in room.furniture)
        poses.append(found)
        request = turned(request)
    assert poses[1:] == [poses[0]] * 3


def _pose(piece: Furniture, room: Room, quarters: int) -> tuple[str, float, float, float, str | None]:
    """A piece as it stands in the room turned back by so many quarters."""
    x, z, rotation, wall, width = piece.x, piece.z, piece.rotation, piece.wall, room.width
    back = {"east": "north", "south": "east", "west": "south", "north": "west"}
    depth = room.depth
    for _ in range(quarters):
        x, z, rotation, wall = z, width - x, (rotation + 90) % 360, wall and back[wall]
        width, depth = depth, width
    return piece.id, round(x, 4), round(z, 4), rotation, wall


def test_the_frame_is_one_for_all_turned_and_mirrored_rooms() -> None:
    request = place_request(1)
    seen = []
    for other in (request, turned(request), turned(turned(request)), mirrored(request), mirrored(turned(request))):
        room = read(PlaceBody, other).room
        seen.append(frame_of(room, (), (), ()).room(room))
    assert all(room == seen[0] for room in seen)


def test_a_room_with_an_outline_stays_as_it_is() -> None:
    corners = ((0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (3.0, 2.0), (3.0, 3.0), (0.0, 3.0))
    door = Opening("door", "door", edge=5, position=1.0, connects_to="EXTERIOR")
    frame = frame_of(Room("den", width=4.0, depth=3.0, outline=corners, openings=(door,)), (), (), ())
    assert (frame.mirrored, frame.quarters) == (False, 0)


SEATS: list[dict[str, Any]] = [
    {"id": "c0", "name": "dining_chair"},
    {"id": "c1", "name": "armchair", "count": 2},
    {"id": "c2", "name": "dining_chair", "count": 2},
]


@pytest.mark.parametrize("sizes", [((1.4, 0.9), (1.2, 0.8)), ((1.2, 0.8), (1.2, 0.8), (1.2, 0.8))])
def test_seats_asked_for_at_several_tables_stand_the_same_however_those_are_called_and_ordered(sizes: tuple[Sequence[float], ...]) -> None:
    tables: list[dict[str, Any]] = [{"id": f"t{k}", "name": "dining_table", "width": w, "depth": d} for k, (w, d) in enumerate(sizes)]
    ids, turns = [table["id"] for table in tables], (0, 1, 2)
    seats: list[dict[str, Any]] = [{**seat, "relations": [{"type": "around", "of": ids[k % 2 :]}]} for k, seat in enumerate(SEATS)]
    door = {"id": "d", "kind": "door", "wall": "west", "position": 1.52, "width": 0.9, "connects_to": "EXTERIOR"}
    room = {"id": "den", "width": 5.66, "depth": 6.91, "openings": [door]}
    found = []
    for turn in turns:
        called = {name: f"{'zay'[turn]}{k * (-1) ** turn}" for k, name in enumerate(ids)}
        of = [[called[name] for name in seat["relations"][0]["of"]][:: -1 if turn else 1] for seat in seats]
        told = [{**seat, "relations": [{"type": "around", "of": names}]} for seat, names in zip(seats, of, strict=True)]
        listed = [*({**table, "id": called[table["id"]]} for table in tables), *told]
        stood = answered({"room": room, "pieces": [*listed[turn:], *listed[:turn]]}).best.scene.rooms[0].furniture
        found.append(sorted((one.name, one.x, one.z, one.rotation) for one in stood))
    assert found[1:] == [found[0]] * 2


def test_pieces_that_differ_in_what_refers_to_them_have_one_order() -> None:
    chairs = [{"id": name, "name": "armchair", "width": 0.8, "depth": 0.8, "height": 0.8} for name in ("one", "other")]
    table = {"id": "table", "name": "side_table", "relations": [{"type": "beside", "of": "one"}]}
    room = {"id": "den", "width": 4.0, "depth": 4.0}
    bodies = [read(PlaceBody, {"room": room, "pieces": [*sent, table]}) for sent in (chairs, chairs[::-1])]
    tasks = [task_of(body.room, body.pieces, CATALOGS, PlaceSetting(0.1, 0.6, "osqp", None)) for body in bodies]
    one, other = ([piece.label for piece in task.pieces] for task in tasks)
    assert one == other
