"""The rules `rooms_overlap` and `opening_wrong`: at the last millimetre that is right and the first that is wrong."""

from __future__ import annotations

from contextlib import nullcontext
from typing import Any

import pytest

from compose_homes import Request, generate
from solver.demanded import demanding_at_most
from solver.errors import TooMuch
from solver.scene import EXTERIOR, Opening, Scene, Size
from tests.sweeps import seeds
from tests.validator.worlds import issues, opening, room, scene

MM = 0.001


def wrong(*openings: Opening, beside: dict[str, Any] | None = None, **more: Any) -> list[tuple[float, str]]:
    """What is wrong with the openings of a room of 4 x 4 m that has another to the east, or elsewhere."""
    other = room(**{"id": "other", "x": 4.0, **(beside or {})})
    found = issues(scene(room(openings=openings, **more), other, wall_thickness=0.1), "opening_wrong")
    return [(round(issue.amount, 6), issue.message.removeprefix("the door door_1 of room_0 ")) for issue in found]


def east(position: float = 2.0, to: str | None = "other", **more: Any) -> Opening:
    return opening("east", position, connects_to=to, **more)


def test_rooms_share_no_floor_but_that_of_their_wall() -> None:
    def shared(x: float, **more: Any) -> list[tuple[str | None, float, str]]:
        found = issues(scene(room(), room(id="other", **{"x": x, **more}), wall_thickness=0.1), "rooms_overlap")
        return [(issue.room, round(issue.amount, 6), issue.message) for issue in found]

    assert shared(3.9) == []
    said = "room_0 and other are rooms that share floor: 0.1 cm from west to east, 3.90 m from north to south"
    assert shared(3.9 - MM) == [("room_0", MM, said)]
    assert shared(1.0, z=1.0)[0][:2] == ("room_0", 2.9)
    assert shared(1.0, level=1) == []
    bay = ((0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (4.0, 2.0), (4.0, 4.0), (0.0, 4.0))
    assert shared(-1.9, z=-2.0, outline=bay)[0][1] == pytest.approx(1.9)
    assert shared(2.0, z=2.0, outline=bay)[0][1] == pytest.approx(1.9)
    assert shared(-2.0, z=-2.0, width=4.0, depth=4.0, outline=((0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4))) == []


def test_an_opening_stays_in_its_wall() -> None:
    assert wrong(opening("north", 3.55)) == []
    assert wrong(opening("north", 3.55 + MM)) == [(MM, "reaches 0.1 cm beyond its wall")]
    assert wrong(opening("north", 9.0)) == [(0.9, "reaches 90 cm beyond its wall")]
    assert wrong(opening(None)) == [(0.0, "the door door_1 is in no wall of room_0")]
    assert wrong(opening(None, 1.5, edge=0, width=3.0)) == []
    corners = ((0.0, 0.0), (2.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0))
    assert wrong(opening("north", 2.0), outline=corners) == []


def test_an_opening_leads_to_a_room_that_is_there() -> None:
    assert wrong(east()) == []
    assert wrong(east(to=None)) == []
    assert wrong(east(to="zzz")) == [(0.0, "leads to zzz, which is no room of the scene")]
    assert issues(scene(room(openings=(east(to="zzz"),))), "opening_wrong") == []
    assert wrong(east(), beside={"x": 4.6}) == []
    assert wrong(east(), beside={"x": 4.6 + MM}) == [(0.9, "leads to other, whose wall is missing behind 90 cm of it")]
    assert wrong(east(), beside={"z": 1.55}) == []
    assert wrong(east(), beside={"z": 1.55 + MM}) == [(MM, "leads to other, whose wall is missing behind 0.1 cm of it")]
    assert wrong(east(), beside={"x": 9.0, "level": 1}) == []
    assert wrong(opening("west", connects_to="other")) == [(0.9, "leads to other, whose wall is missing behind 90 cm of it")]


def test_outside_is_where_no_room_is() -> None:
    assert wrong(east(to=EXTERIOR), beside={"z": 2.45}) == []
    assert wrong(east(to=EXTERIOR), beside={"z": 2.45 - MM}) == [(MM, "leads outside, but other lies behind 0.1 cm of it")]
    assert wrong(east(to=EXTERIOR, kind="window", sill=0.9))[0][0] == pytest.approx(0.9)
    assert wrong(east(to=EXTERIOR), beside={"x": 4.6 + MM}) == []
    assert wrong(east(to=EXTERIOR), beside={"outdoor": True}) == []
    assert wrong(east(to=EXTERIOR), outdoor=True) == []
    assert wrong(east(to=EXTERIOR), beside={"level": 1}) == []


def test_openings_share_no_wall() -> None:
    first = east(1.5)
    assert wrong(first, east(2.4, id="door_2")) == []
    assert wrong(first, east(2.4 - MM, id="door_2")) == [(MM, "the door door_2 of room_0 and the door door_1 share 0.1 cm of its wall")]
    assert wrong(first, opening("west", 1.5, id="door_2")) == []
    assert wrong(first, east(1.5, id="pane", kind="window", sill=2.1, height=0.3)) == []


def test_a_door_that_both_rooms_list_is_told_once_where_both_list_it_wrongly() -> None:
    def told(here: Opening, there: Opening, **more: Any) -> list[tuple[str | None, str]]:
        other = room(id="other", x=4.0, openings=(there,), **more)
        found = issues(scene(room(openings=(here,)), other, wall_thickness=0.1), "opening_wrong")
        return [(issue.room, issue.message.removeprefix("the door ")) for issue in found]

    back = opening("west", connects_to="room_0")
    assert told(east(), back) == []
    beyond = "reaches 10 cm beyond its wall"
    both = told(east(3.65), opening("west", 3.65, connects_to="room_0"))
    assert both == [("room_0", f"door_1 of room_0 and other {beyond}")]
    assert told(east(3.65), back) == [("room_0", f"door_1 of room_0 {beyond}")]
    assert told(east(), opening("west", 3.65, connects_to="room_0")) == [("other", f"door_1 of other {beyond}")]
    named = told(east(3.65), opening("west", 3.65, connects_to="room_0", id="door_2"))
    assert named == [("room_0", f"door_1 of room_0 {beyond}"), ("other", f"door_2 of other {beyond}")]
    assert told(opening(None, connects_to="other"), opening(None, connects_to="room_0")) == [
        ("room_0", "door_1 is in no wall of room_0 and other")
    ]
    apart = "leads to other, whose wall is missing behind 90 cm of it"
    assert told(east(), back, z=9.0) == [("room_0", f"door_1 of room_0 and other {apart}")]


@pytest.mark.parametrize(("step", "most", "refused"), [(0.0, 4_300, False), (0.1, 500, True), (0.1, 1_000, False)])
def test_only_openings_that_were_compared_count_as_work(step: float, most: float, refused: bool) -> None:
    """Of openings upon one another each meets the first; of those side by side each is compared with all before it."""
    many = scene(room(width=50.0, openings=tuple(opening("north", 0.1 + step * k, id=f"door_{k}", width=0.09) for k in range(400))))
    with demanding_at_most(most), pytest.raises(TooMuch) if refused else nullcontext():
        assert len(issues(many, "opening_wrong")) == (0 if step else 399)


@pytest.mark.parametrize(("count", "refused"), [(30, False), (40, True)])
def test_each_two_rooms_upon_one_another_count_as_a_breach(count: int, refused: bool) -> None:
    """Two thousand rooms on one spot were two million issues of 400 MB."""
    heap = scene(*(room(id=f"room_{k}") for k in range(count)))
    with demanding_at_most(150 * count + 5_000), pytest.raises(TooMuch) if refused else nullcontext():
        assert len(issues(heap, "rooms_overlap")) == count * (count - 1) / 2


@pytest.mark.parametrize("seed", seeds(range(120), 12))
@pytest.mark.parametrize("wish", [{"program": "large"}, {"program": "family"}, {"width": 20, "depth": 15}, {"width": 7, "depth": 6}])
def test_plans_of_seeds_break_no_rule_about_plans(seed: int, wish: dict[str, Any]) -> None:
    made: Scene = generate(Request(seed=seed, **wish)).scene
    assert [one for rule in ("rooms_overlap", "opening_wrong") for one in issues(made, rule)] == []


def test_rooms_are_told_beside_which_they_lie_as_when_each_pair_is_looked_at() -> None:
    at = [(0.7 * (k * k % 13), 0.5 * (k * k % 7), k % 2) for k in range(24)]
    rooms = [room(id=f"room_{k}", x=x, z=z, level=level, width=1.0, depth=1.0) for k, (x, z, level) in enumerate(at)]
    found = [issue.message.partition(" are ")[0] for issue in issues(scene(*rooms, wall_thickness=0.0), "rooms_overlap")]
    both = [(a, b) for b in range(24) for a in range(b) if at[a][2] == at[b][2]]
    pairs = [(a, b) for a, b in both if abs(at[a][0] - at[b][0]) < 1 - 1e-6 and abs(at[a][1] - at[b][1]) < 1 - 1e-6]
    assert sorted(found) == sorted(f"room_{a} and room_{b}" for a, b in pairs)
    assert 5 < len(pairs) < len(both)


@pytest.mark.parametrize(
    ("more", "above"),
    [
        ({"sill": 0.0, "height": 2.5}, None),
        ({"sill": 0.0, "height": 2.501}, 0.001),
        ({"sill": 0.9, "height": 1.6}, None),
        ({"sill": 0.9, "height": 1.7}, 0.1),
        ({"sill": 2.7, "height": 0.4}, 0.6),
        ({"sill": 0.9}, None),
        ({"sill": 2.5}, 2.1),
    ],
)
def test_an_opening_ends_at_the_ceiling(more: dict[str, Any], above: float | None) -> None:
    low = scene(room(openings=(opening(kind="window", **more),)), size=Size(4.0, 4.0, 2.5))
    told = [(issue.amount, issue.severity) for issue in issues(low, "opening_wrong")]
    assert told == ([] if above is None else [(pytest.approx(above), "warning")])
    garden = scene(room(openings=(opening(kind="window", **more),), outdoor=True), size=Size(4.0, 4.0, 2.5))
    assert issues(garden, "opening_wrong") == []
