"""Homes that are no rectangles: what they look like from above, where one comes in, what is refused."""

from __future__ import annotations

from collections import Counter
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from catalogs import load_catalogs
from solver import generate
from solver.errors import RequestError
from solver.floorplan import FloorPlan, draw
from solver.request import Request
from solver.scene import EXTERIOR
from tests.floorplan import checks, homes, silhouettes

CATALOGS = load_catalogs()
LIVED_IN = {"living_room", "dining_room", "kitchen"}


def planned(**fields: Any) -> FloorPlan:
    return draw(Request(**{"seed": 7, **fields}), CATALOGS)


@pytest.mark.parametrize(
    ("boxes", "name"),
    [
        ([(0, 0, 4, 3), (4, 0, 9, 3)], "rectangle"),
        ([(0, 0, 4, 3), (4, 0, 9, 5)], "L"),
        ([(0, 0, 4, 3), (4, -1, 9, 5)], "T"),
        ([(0, 0, 4, 3), (4, 0, 9, 5), (9, 0, 12, 3)], "T"),
        ([(0, 0, 4, 5), (4, 0, 9, 3), (9, 0, 12, 4)], "U"),
        ([(0, -2, 4, 5), (4, 0, 9, 3), (9, -2, 12, 5)], "U"),
        ([(0, 0, 4, 3), (4, 1, 9, 5)], "other"),
    ],
)
def test_silhouettes_are_named(boxes: list[silhouettes.Box], name: str) -> None:
    assert silhouettes.name(boxes) == name


@pytest.mark.parametrize("boxes", [[(0, 0, 4, 3), (5, 0, 9, 3)], [(0, 0, 4, 3), (4, 3, 9, 5)]])
def test_silhouettes_see_parts(boxes: list[silhouettes.Box]) -> None:
    with pytest.raises(ValueError, match="parts"):
        silhouettes.name(boxes)


def test_silhouettes_see_a_hole() -> None:
    with pytest.raises(ValueError, match="hole"):
        silhouettes.name([(0, 0, 3, 1), (0, 2, 3, 3), (0, 1, 1, 2), (2, 1, 3, 2)])


@pytest.mark.parametrize("outline", homes.OUTLINES)
@pytest.mark.parametrize("name", ["one_bed", "family", "large"])
def test_homes_have_the_outline_asked_for(name: str, outline: str) -> None:
    """And all that rectangles have: sizes, ways, windows, pipes together."""
    if (name, outline) == ("one_bed", "U"):
        return
    found = homes.measure(range(300, 320), CATALOGS, program=name, outline=outline)
    assert homes.missed(found, name) + homes.misshapen(found, name, outline) == [], (found.line(name), found.faults[:3])
    assert found.dark == 0
    assert len(found.graphs) >= (3 if name == "one_bed" else 8)


@pytest.mark.parametrize("outline", homes.OUTLINES)
def test_one_comes_in_through_the_foyer_from_the_street(outline: str) -> None:
    for seed in range(40, 52):
        plan = planned(seed=seed, program="family", outline=outline)
        ((room, door),) = checks.entrances(plan.rooms)
        assert (room.type, door.wall, door.connects_to) == ("foyer", "south", EXTERIOR)


@pytest.mark.parametrize("outline", homes.OUTLINES)
def test_gardens_lie_at_living_spaces_and_take_nobodys_light(outline: str) -> None:
    entered = []
    for seed in range(500, 540):
        rooms = planned(seed=seed, program="family", outline=outline, outdoor=True).rooms
        kinds = {room.id: room.type for room in rooms}
        for room in rooms:
            if room.outdoor:
                assert room.width * room.depth >= (22 if room.type == "backyard" else 14) - 1e-6, (seed, room.id)
                entered.append({kinds[str(o.connects_to)] for o in room.openings if o.connects_to in kinds} <= LIVED_IN)
            elif CATALOGS.rooms[room.type].plan.habitable:
                assert any(o.kind == "window" for o in room.openings), (seed, room.id)
    assert len(entered) > 50
    assert sum(entered) >= 0.75 * len(entered)


def test_the_seed_draws_outlines_and_two_of_five_are_no_rectangles() -> None:
    drawn = Counter(homes.outline_of(planned(seed=seed, program=name)) for seed in range(80) for name in ("one_bed", "family"))
    assert set(drawn) == {"rectangle", *homes.OUTLINES}
    assert drawn["rectangle"] <= 0.6 * drawn.total()


def test_homes_in_a_given_frame_are_rectangles() -> None:
    for seed in range(12):
        assert homes.outline_of(planned(seed=seed, program="family", width=15.0)) == "rectangle"


def test_an_outline_that_a_programme_cannot_have_is_said() -> None:
    plan = planned(program="studio", outline="U")
    assert homes.outline_of(plan) == "L"
    assert plan.notes == ("no sound home of these rooms was found whose outline is U: it is L",)


@given(st.integers(0, 2**53 - 1), st.sampled_from(homes.OUTLINES), st.integers(0, 400), st.booleans())
def test_any_programme_is_sound_in_any_outline(seed: int, outline: str, number: int, outdoor: bool) -> None:
    plan = planned(seed=seed, program=homes.random_programme(number), outline=outline, outdoor=outdoor)
    assert homes.sound(plan) == []
    assert plan.notes or homes.outline_of(plan) == outline


@pytest.mark.parametrize("fields", [{"outline": "L"}, {"outline": "U", "program": "family", "width": 20.0}])
def test_outlines_that_cannot_be_are_refused(fields: dict[str, Any]) -> None:
    with pytest.raises(RequestError, match="outline"):
        planned(**fields)


@pytest.mark.parametrize("outline", homes.OUTLINES)
def test_furnished_homes_are_clean(outline: str) -> None:
    made = generate(Request(seed=3, program="family", outline=outline, decorate=True))
    assert [issue for issue in made.issues if issue.severity == "error"] == []
