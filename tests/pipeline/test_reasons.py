"""Why a generated room lacks a required piece: in lengths, where one length says it."""

from __future__ import annotations

import re

import pytest

from catalogs import load_catalogs
from solver import reroll, validate
from solver.furnish import space_of
from solver.pieces import Arrangement
from solver.pipeline.reasons import with_lengths
from solver.scene import Opening, Room, Scene


def bare(room_type: str, width: float, depth: float) -> Scene:
    door = Opening("door_1", "door", "south", 0.7, 0.8, connects_to="EXTERIOR", main_entrance=True)
    return Scene(seed=1, wall_thickness=0.1, rooms=(Room("r", 0, room_type, width=width, depth=depth, openings=(door,)),))


@pytest.mark.parametrize(("width", "clear", "missing"), [(2.0, "1.90", "13 cm"), (1.95, "1.85", "18 cm")])
def test_a_missing_bed_is_told_in_centimetres(width: float, clear: str, missing: str) -> None:
    """No bed is shorter than 2 m, and its head is 3 cm from a wall."""
    issue = next(one for one in reroll(bare("bedroom", width, width), ["r"]).issues if one.rule == "missing_required")
    assert re.search(rf"bed 2\.00 \+ wall gap 0\.03 = 2\.03 > {re.escape(clear)} m .*: {missing} short", issue.message), issue.message


def test_the_reason_is_in_the_certificate_and_a_longer_room_has_the_bed() -> None:
    made = reroll(bare("bedroom", 2.0, 2.0), ["r"])
    assert "13 cm short" in str(made.scene.certificate)
    assert [one for one in reroll(bare("bedroom", 2.6, 2.9), ["r"]).issues if one.rule == "missing_required"] == []


def test_a_room_too_small_to_enter_is_said_to_be_that_and_not_to_be_some_length_short() -> None:
    issues = reroll(bare("bathroom", 0.8, 0.8), ["r"]).issues
    missing = [one.message for one in issues if one.rule == "missing_required"]
    assert missing and not any("short" in message for message in missing)
    assert any("less than 0.25 m2 where somebody 60 cm wide can stand" in one.message for one in issues)


def test_what_is_not_left_out_is_not_explained() -> None:
    made = reroll(bare("bedroom", 4.0, 4.0), ["r"])
    assert "short" not in str(made.scene.certificate)
    assert [one for one in validate(made.scene, load_catalogs()) if one.severity == "error"] == []


def test_an_arrangement_that_lacks_nothing_stays_as_it_is() -> None:
    whole = Arrangement("r", ())
    assert with_lengths(space_of(bare("bedroom", 4.0, 4.0).rooms[0], 0.1), (), whole) == whole
