"""The floor that fronts come over, against the arc of a door and the travel of a drawer."""

from __future__ import annotations

from math import hypot

import pytest

from catalogs import load_catalogs
from catalogs.fronts import BodyFront, floor_before, fronts_of
from solver.furnish.compiled_types import floors_about
from solver.wall_fittings import FRAME_PROUD
from tests.every import every

KNOWN = load_catalogs()


def ahead(front: BodyFront) -> bool:
    """Tells whether a front comes straight out: a drawer, or a flap that opens down."""
    return front.opens in ("drawer", "down")


def test_doors_come_out_by_their_width_and_drawers_by_their_travel() -> None:
    spec, solids = KNOWN.furniture["medium_wardrobe"], KNOWN.shapes["medium_wardrobe"]
    found = floor_before(solids, spec.size)
    assert found is not None
    width = 0.482 * spec.size[0]
    behind = (1 - 0.955) * spec.size[1]
    assert width - behind <= found.depth <= hypot(width, 0.04) - behind
    drawers = KNOWN.furniture["nightstand"], KNOWN.shapes["nightstand"]
    drawn = floor_before(drawers[1], drawers[0].size)
    assert drawn is not None
    travel = max(one.end for one in fronts_of(drawers[1])) * drawers[0].size[1]
    assert travel <= drawn.depth + 0.055 * drawers[0].size[1]
    assert drawn.depth <= travel


@pytest.mark.parametrize("name", ["bookshelf", "toilet", "sofa"])
def test_what_does_not_come_out_needs_no_floor(name: str) -> None:
    assert floor_before(KNOWN.shapes[name], KNOWN.furniture[name].size) is None


def test_half_open_takes_less_than_open() -> None:
    for name, spec in KNOWN.furniture.items():
        found = floor_before(KNOWN.shapes.get(name, ()), spec.size)
        if found is not None:
            assert 0 < found.half <= found.depth, name
            assert -spec.size[0] / 2 <= found.left < found.right <= spec.size[0] / 2, name
            assert 0 <= found.above < spec.size[2], name


@every("name", [name for name in KNOWN.furniture if any(ahead(one) for one in fronts_of(KNOWN.shapes.get(name, ())))])
def test_drawers_and_flaps_pass_the_frame_of_a_door_in_the_wall_beside_them(name: str) -> None:
    """A piece may stand flush with the wall at its side, and the frame of a door there stands out of it."""
    for front in fronts_of(KNOWN.shapes[name]):
        if ahead(front):
            moved = [KNOWN.shapes[name][part].x for part in front.parts]
            aside = min(min(low, 1 - high) for low, high in moved)
            assert aside * KNOWN.furniture[name].size[0] > FRAME_PROUD + 0.0005


def test_the_floor_that_fronts_open_over_lies_exactly_before_them_on_whole_millimetres() -> None:
    """No wider than its piece, so that this may stand in a corner; as wide as an even number of mm, so that its middle is one."""
    for name, spec in KNOWN.furniture.items():
        found = floor_before(KNOWN.shapes.get(name, ()), spec.size)
        for one in floors_about(spec, KNOWN.shapes.get(name, ())):
            if found is not None and one.opens:
                assert one.left <= found.left * 1000 + 1e-6 and found.right * 1000 - 1e-6 <= one.right, name
                assert (one.right - one.left) % 2 == 0, name
                assert -one.left <= round(spec.size[0] * 500) >= one.right, name


def test_the_edge_of_a_single_door_goes_along_the_side_of_its_piece() -> None:
    """Where it is shut it ends within 2 cm of a side; of two doors in a pair each turns about the side that it ends at."""
    along = {
        name: found.along_side for name, spec in KNOWN.furniture.items() if (found := floor_before(KNOWN.shapes.get(name, ()), spec.size))
    }
    assert along["refrigerator"] and along["slim_refrigerator"] and along["pantry"]
    assert not (along["wardrobe"] or along["sink"] or along["nightstand"] or along["dishwasher"])
