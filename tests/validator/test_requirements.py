"""The rule `missing_required`, and what the list of issues looks like as a whole."""

from __future__ import annotations

from typing import Any

import pytest

from catalogs.shapes import Solid
from solver.scene import Decoration, Size
from solver.validator import RULES, validate
from tests.validator.worlds import CATALOGS, issues, opening, piece, room, scene


def bedroom(*names: str, **more: Any) -> list[str]:
    pieces = [piece(1.0, 1.0 + index, 0.5, 0.5, id=f"p{index}", name=name) for index, name in enumerate(names)]
    return [issue.message for issue in issues(scene(room(*pieces, type="bedroom"), **more), "missing_required")]


def test_either_kind_meets_a_requirement() -> None:
    assert bedroom("bed") == []
    assert bedroom("wardrobe", "single_bed") == []
    assert bedroom("wardrobe") == ["room_0 (bedroom) has no bed or single_bed: its furniture came with the scene as it is"]


def test_numbers_count() -> None:
    def told(chairs: int) -> list[str]:
        pieces = [piece(1.0, 1.0 + index, 0.5, 0.5, id=f"chair_{index}", name="dining_chair") for index in range(chairs)]
        table = piece(3.0, 3.0, name="table")
        return [issue.message for issue in issues(scene(room(table, *pieces, type="dining_room")), "missing_required")]

    assert told(2) == []
    assert told(3) == []
    assert told(1) == ["room_0 (dining_room) has only 1 of 2 dining_chair: its furniture came with the scene as it is"]
    assert told(0) == ["room_0 (dining_room) has no 2 dining_chair: its furniture came with the scene as it is"]


def test_unknown_room_types_require_nothing() -> None:
    assert issues(scene(room(type="oubliette")), "missing_required") == []


@pytest.mark.parametrize("label", ["bed", "single_bed", "bed_1", "sleep", "sleep_2"])
def test_the_reason_is_the_certificates(label: str) -> None:
    reason = "bed 1.60 + wardrobe 0.60 > 2.10 m: 10 cm short"
    left_out = [{"piece": "wardrobe_1", "reason": "no room"}, {"piece": label, "reason": reason}]
    told = bedroom(certificate={"rooms": {"room_0": {"left_out": left_out}}})
    assert told == [f"room_0 (bedroom) has no bed or single_bed: {reason}"]


@pytest.mark.parametrize("left_out", [[], [{"piece": "wardrobe_1", "reason": "no room"}]])
def test_what_the_certificate_does_not_name_was_never_tried(left_out: list[dict[str, str]]) -> None:
    told = bedroom(certificate={"rooms": {"room_0": {"left_out": left_out}}})
    assert told == ["room_0 (bedroom) has no bed or single_bed: it was not asked for, or was taken away"]


@pytest.mark.parametrize(
    "certificate",
    [
        {"rooms": {"room_0": "?"}},
        {"rooms": {"room_0": {}}},
        {"rooms": {"room_0": {"left_out": "bed"}}},
        {"rooms": {"room_0": {"left_out": [7, {"piece": 3}, {"piece": "bed"}]}}},
    ],
)
def test_certificates_of_other_makers_do_no_harm(certificate: dict[str, Any]) -> None:
    assert bedroom(certificate=certificate) == ["room_0 (bedroom) has no bed or single_bed: no reason is recorded"]


@pytest.mark.parametrize(
    "certificate",
    [
        None,
        {},
        {"rooms": None},
        {"rooms": 4},
        {"rooms": [{"left_out": []}]},
        {"rooms": {"room_0": None}},
        {"rooms": {"room_1": {"left_out": [{"piece": "bed", "reason": "another room's"}]}}},
    ],
)
def test_a_room_that_no_certificate_tells_of_is_as_it_was_sent(certificate: dict[str, Any] | None) -> None:
    said = "room_0 (bedroom) has no bed or single_bed: "
    assert bedroom(certificate=certificate) == [said + "nothing stands in the room yet"]
    assert bedroom("wardrobe", certificate=certificate) == [said + "its furniture came with the scene as it is"]


def test_issues_come_room_by_room_and_rule_by_rule() -> None:
    """Everything wrong in two rooms at once, in the order of the rules, the same every time."""
    door = opening(main_entrance=True)
    window = opening("south", id="window_1", kind="window", sill=0.9)
    culprits = (
        piece(2.0, 0.4, id="a", wall="south"),
        piece(2.0, 0.5, id="b"),
        piece(2.0, 3.5, id="c", height=1.5),
        piece(0.5, 2.0, id="g"),
        piece(0.5, 2.9, id="h", under="g", height=2.801),
    )
    lamp = Decoration("f", "lamp", x=1.0, y=1.0, z=1.0, width=0.1, depth=0.1, height=0.1)
    nowhere = opening("west", id="door_2", connects_to="nowhere")
    rooms = [
        room(*culprits, id="two", type="bedroom", openings=(door, window, nowhere), decorations=(lamp,)),
        room(id="one", x=3.9, type="bedroom"),
    ]
    rooms[1] = room(*(piece(2.0, 3.9, id=f"{name}2") for name in "de"), id="one", x=3.9, type="bedroom")
    whole = Solid(form="box", x=(0, 1), y=(0, 1), z=(0, 1), axis="y", taper=1, material="body")
    lid = Solid(form="box", x=(0, 1), y=(0.9, 1), z=(0.9, 1), axis="y", taper=1, material="body", front="flap", opens="down", range=90)
    known = CATALOGS.model_copy(update={"shapes": {"crate": (whole, lid)}})
    house = scene(*rooms, size=Size(8.0, 4.0, 2.8))
    found = validate(house, known)
    assert found == validate(house, known)
    order = [(issue.room, list(RULES).index(issue.rule)) for issue in found]
    assert order == sorted(order, key=lambda entry: (entry[0] != "two", entry[1]))
    assert {issue.rule for issue in found if issue.room == "two"} == set(RULES)
    assert {issue.rule for issue in found if issue.room == "one"} == {
        "front_blocked",
        "out_of_bounds",
        "overlap",
        "unreachable",
        "missing_required",
    }
    assert all(issue.severity == RULES[issue.rule] and issue.message and issue.amount >= 0 for issue in found)
