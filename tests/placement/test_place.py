"""place(): arrangements against an independent integer checker, the cvxpy reference, and themselves."""

from __future__ import annotations

import pytest

from solver.geometry import Rect
from solver.pieces import LOOKS_AT, Arrangement, Candidate, Link, Piece, Space
from solver.placement import feasible, minimal_conflict, opened, place
from solver.placement.arrange import arrange
from solver.placement.core import Limits
from solver.streams import Stream
from tests.oracles import model
from tests.oracles.confirmed import confirmed
from tests.oracles.problem import found_in, problem_of
from tests.placement.rooms import at_walls, random_space, random_wanted


def room(seed: int) -> tuple[Space, tuple[Piece, ...]]:
    stream = Stream(seed, "place")
    space = random_space(stream)
    return space, random_wanted(space, stream, 3 + seed % 8)


def assert_valid(space: Space, arrangement: Arrangement) -> None:
    """Written from the rules alone: inside, apart, clear of the door's square and, when tall, of the window."""
    seen: list[Rect] = []
    for piece in arrangement.placed:
        r = piece.footprint
        assert space.clear.x0 <= r.x0 < r.x1 <= space.clear.x1
        assert space.clear.z0 <= r.z0 < r.z1 <= space.clear.z1
        sides = {(0, 0): r.z0 - space.clear.z0, (0, 1): space.clear.z1 - r.z1}
        distance = {
            "north": sides[0, 0],
            "south": sides[0, 1],
            "west": r.x0 - space.clear.x0,
            "east": space.clear.x1 - r.x1,
        }
        if piece.wall is not None and piece.chosen.attach is None:
            assert distance[piece.wall] == 30
        for zone in space.zones:
            if piece.chosen.size_mm[2] > zone.above_mm:
                assert not r.overlaps(zone.rect), (piece.label, zone.cause)
        assert not any(r.overlaps(other) for other in seen)
        seen.append(r)


@pytest.mark.parametrize("block", range(4))
def test_every_room_is_valid_in_integers(block: int) -> None:
    rooms = [room(seed) for seed in range(25 * block, 25 * block + 25)]
    for (space, wanted), arrangement in zip(rooms, place(rooms), strict=True):
        assert_valid(space, arrangement)
        labels = {piece.label for piece in arrangement.placed} | {label for label, _ in arrangement.left_out}
        assert labels == {piece.label for piece in wanted}


def test_osqp_agrees_with_the_reference_model() -> None:
    solved = [opened(*room(seed)) for seed in range(12)]
    rooms = [(problem_of(one.core), found_in(one.engine)) for one in solved]
    for one, theirs, (problem, exact) in zip(solved, model.solve_house(rooms), rooms, strict=True):
        ours = confirmed(one.engine, problem)
        for axis in (0, 1):
            assert ours.positions[axis] == pytest.approx(theirs[axis], abs=1e-5)
            assert ours.positions[axis] == pytest.approx(exact.positions[axis], abs=1e-6)


def test_the_same_rooms_give_the_same_arrangements_in_any_company() -> None:
    together = place([room(seed) for seed in range(40)])
    alone = [place([room(seed)])[0] for seed in reversed(range(40))][::-1]
    assert together == alone


def test_what_is_known_to_go_together_is_found_again_with_however_few_qps() -> None:
    few, usual = Limits(required_qps=3, final_qps=5), Limits()
    standing = [[len(arrange(*room(seed), limits=limits).arrangement.placed) for seed in range(12)] for limits in (few, usual)]
    assert sum(standing[0]) >= 0.9 * sum(standing[1]), standing


def wall_piece(label: str, width: int, space: Space) -> Piece:
    return Piece(label, True, at_walls((width, 600, 700), space, Stream(1, label)))


def test_a_conflict_is_minimal() -> None:
    space = Space("room", Rect(0, 0, 2000, 2000), (), ())
    pieces = [wall_piece(f"piece_{k}", width, space) for k, width in enumerate((1300, 1300, 1300, 1300, 1300, 300))]
    members = minimal_conflict(space, pieces, "piece_5")
    assert members is not None
    chosen = [piece for piece in pieces if piece.label in members]
    assert feasible(space, chosen) is False
    for piece in chosen:
        assert feasible(space, [other for other in chosen if other is not piece]) is True


def test_what_is_left_out_comes_with_lengths() -> None:
    space = Space("room", Rect(0, 0, 1500, 1500), (), ())
    arrangement = place([(space, [wall_piece("small", 800, space), wall_piece("large", 1600, space)])])[0]
    assert [piece.label for piece in arrangement.placed] == ["small"]
    ((label, reason),) = arrangement.left_out
    assert label == "large"
    assert "1.60 x 0.60 m" in reason


def test_what_a_limit_cut_short_is_not_called_best() -> None:
    rooms = [room(seed) for seed in range(40)]
    assert all(made.best for made in (arrange(*each).arrangement for each in rooms[:10]) if not made.left_out)
    few = Limits(required=1, required_qps=6)
    assert not all(arrange(*each, limits=few).arrangement.best for each in rooms)


LOOKS = [((3400, 1500), 270, True), ((3400, 1500), 180, False), ((2400, 300), 0, True), ((2400, 300), 270, False)]


@pytest.mark.parametrize(("at", "turn", "stands"), LOOKS)
def test_who_must_face_another_looks_at_it_from_wherever_it_stands(at: tuple[int, int], turn: int, stands: bool) -> None:
    space = Space("room", Rect(0, 0, 4000, 4000), (), ())
    sofa = Piece("sofa", True, (Candidate("sofa", (1800, 900, 800), 0, None, (1000, 2000)),))
    links = (Link("facing", "sofa", turn=LOOKS_AT, required=True),)
    chair = Piece("chair", True, (Candidate("chair", (500, 500, 900), turn, None, at),), links)
    (made,) = place([(space, [sofa, chair])])
    assert [one.label for one in made.placed] == (["sofa", "chair"] if stands else ["sofa"])
