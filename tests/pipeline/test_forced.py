"""Every room type, forced into rooms of its minimum, typical and maximum area: furnished by its rules, no error."""

from __future__ import annotations

from catalogs import load_catalogs
from tests.every import every
from tests.pipeline.forced import Case, cases

EVERY = 5
"""The suite runs one case in five; `make targets` runs them all."""
SLICE = [case for k, case in enumerate(cases()) if k % EVERY == 0]


def test_the_slice_holds_every_type() -> None:
    assert {case.room_type for case in SLICE} == set(load_catalogs().rooms)


@every("case", SLICE)
def test_a_forced_room_is_furnished_by_its_rules(case: Case) -> None:
    result = case.furnished()
    assert [issue.message for issue in result.issues if issue.severity == "error"] == []
    assert [issue.message for issue in result.issues if issue.rule == "missing_required"] == []
    required = [piece for piece in load_catalogs().rooms[case.room_type].pieces if piece.required and not piece.without]
    assert len(result.scene.rooms[0].furniture) >= sum(piece.count for piece in required)
