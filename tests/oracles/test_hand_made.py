"""The oracles on rooms whose answer anyone can see, to the millimetre; and the engine against them where nobody can."""

from __future__ import annotations

import pytest

from solver.geometry import Rect
from solver.pieces import Attach, Candidate, Doorway, Link, Piece, Space, Stand, Zone
from solver.placement import feasible
from tests.bench.fuzz_rooms import fuzz_room
from tests.oracles.paths import stand_and_walk
from tests.oracles.room import stand_together
from tests.oracles.walk import missed

DOOR = Doorway("door", "south", Rect(0, 2100, 900, 3000), "hall")
SQUARE = Zone(DOOR.square, -1, "door")


def room(width: int, depth: int, *zones: Zone, doors: tuple[Doorway, ...] = ()) -> Space:
    return Space("room", Rect(0, 0, width, depth), zones, doors)


def at(wall: str, width: int, depth: int, height: int = 900) -> Candidate:
    rotation = {"north": 0, "west": 90, "south": 180, "east": 270}[wall]
    return Candidate("box", (width, depth, height), rotation, wall)


def box(label: str, *ways: Candidate, links: tuple[Link, ...] = (), stands: tuple[str, ...] = (), every: bool = False) -> Piece:
    return Piece(label, True, ways, links, tuple(Stand(side) for side in stands), every)


@pytest.mark.parametrize(("width", "stand"), [(2000, True), (1999, False)])
def test_two_pieces_fill_a_wall_to_the_millimetre(width: int, stand: bool) -> None:
    pieces = [box("a", at("north", 1200, 500)), box("b", at("north", 800, 500))]
    assert stand_together(room(width, 530), pieces).verdict is stand


@pytest.mark.parametrize(("sill", "stand"), [(900, True), (899, False)])
def test_a_window_keeps_what_is_taller_than_its_sill_away(sill: int, stand: bool) -> None:
    window = Zone(Rect(0, 0, 2000, 500), sill, "window")
    assert stand_together(room(2000, 700, window), [box("a", at("north", 1500, 400))]).verdict is stand


@pytest.mark.parametrize(("slide", "stand"), [(700, True), (699, False)])
def test_a_companion_slides_as_far_as_its_slot_lets_it(slide: int, stand: bool) -> None:
    """Before the middle of a fixed piece lies a zone that reaches 400 mm to each side; the companion is 600 wide."""
    parent = box("parent", at("north", 2000, 500))
    way = Candidate("chair", (600, 400, 900), 180, attach=Attach("parent", "box", (-slide, slide), (450, 450)))
    zone = Zone(Rect(600, 600, 1400, 2000), -1, "zone")
    assert stand_together(room(2000, 2000, zone), [parent, box("chair", way)]).verdict is stand
    other_kind = Candidate("chair", (600, 400, 900), 180, attach=Attach("parent", "bench", (-slide, slide), (450, 450)))
    assert stand_together(room(2000, 2000), [parent, box("chair", other_kind)]).verdict is False


@pytest.mark.parametrize(("walls", "stand"), [("opposite", True), ("same", True), ("adjacent", False)])
def test_required_links_bind_the_walls(walls: str, stand: bool) -> None:
    first = box("first", at("north", 900, 400))
    second = box("second", at("south", 900, 400), at("north", 900, 400), links=(Link("there", "first", walls=walls, required=True),))
    assert stand_together(room(2000, 2000), [first, second]).verdict is stand


@pytest.mark.parametrize(("depth", "every", "stand"), [(1630, False, True), (1629, False, False), (1630, True, False)])
def test_a_use_side_needs_room_for_a_person(depth: int, every: bool, stand: bool) -> None:
    piece = box("a", at("north", 900, 1000), stands=("front", "left"), every=every)
    assert stand_together(room(940, depth), [piece], stands=True).verdict is stand
    assert stand_together(room(940, depth), [piece]).verdict is True


@pytest.mark.parametrize(("width", "reached"), [(3000, True), (2999, False)])
def test_a_gap_of_exactly_the_person_is_a_way(width: int, reached: bool) -> None:
    """A shelf across the room leaves 600 mm or less; behind it stands what must be come to."""
    across = Candidate("shelf", (2400, 300, 1800), 0, within=Rect(0, 1500, width, 1800))
    goal = box("goal", at("north", 800, 400), stands=("front",))
    space = room(width, 3000, SQUARE, doors=(DOOR,))
    answer = stand_and_walk(space, [box("shelf", across), goal])
    assert answer.verdict is reached
    shelf, behind = Rect(0, 1500, 2400, 1800), Rect(0, 30, 800, 430)
    assert missed(space, [shelf, behind], [("goal", behind, ["south"], False)]) == ([] if reached else ["goal"])


@pytest.mark.parametrize("block", range(4))
def test_the_engines_verdict_is_the_oracles(block: int) -> None:
    verdicts = set()
    for seed in range(1000 + 25 * block, 1025 + 25 * block):
        space, wanted = fuzz_room(seed)
        required = [piece for piece in wanted if piece.required]
        ours, theirs = feasible(space, required), stand_together(space, required).verdict
        assert None in (ours, theirs) or ours == theirs, seed
        verdicts.add(theirs)
    assert verdicts == {True, False}
