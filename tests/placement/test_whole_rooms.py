"""Rooms that the core makes in one go: the same, word for word, as those that are placed from pieces, step by step."""

from __future__ import annotations

import importlib
from collections import Counter
from typing import Any

import pytest

from solver import Request, generate
from solver.errors import RequestError
from solver.placement import place, place_wanted, qp
from tests.furnish.wanting_rooms import wanting_room
from tests.sweeps import seeds


@pytest.mark.parametrize("block", range(4))
def test_random_rooms_are_made_as_from_pieces(block: int) -> None:
    """Rooms of our types and of random ones; too small for some, too narrow to walk in others."""
    met: Counter[str] = Counter()
    for seed in seeds(range(block, 1200, 4), 13):
        asked, tidy = wanting_room(seed), seed % 5 > 0
        (stepwise,) = place([asked.pieces()], tidy=tidy)
        (made,) = place_wanted([asked.rows()], tidy=tidy)
        assert made == stepwise, seed
        met.update(reason.partition(";")[0] for _, reason in made.left_out)
        met.update(made.notes)
    assert len(met) >= 4, met


def test_homes_are_made_as_from_pieces(monkeypatch: pytest.MonkeyPatch) -> None:
    """All rooms of a home together, as one problem of OSQP's."""
    pipeline, rooms = importlib.import_module("solver.pipeline.generate"), 0
    asked = [Request(seed=seed, program=program) for seed in seeds(range(40), 10) for program in (None, "family")]
    made = [generate(one).scene for one in asked]
    monkeypatch.setattr(pipeline, "place_wanted", lambda *_, **__: pytest.fail("it was asked for pieces"))
    monkeypatch.setattr(pipeline, "_is_in_one_go", lambda _: False)
    for one, scene in zip(asked, made, strict=True):
        assert generate(one).scene == scene
        rooms += len(scene.rooms)
    assert rooms > 50


def test_a_walk_that_hung_on_the_last_millimetre_is_found_anew_by_both(monkeypatch: pytest.MonkeyPatch) -> None:
    """In a bedroom of this home nothing stood so for somebody 2 mm wider, who is asked so that the walk outlasts whole millimetres."""
    pipeline, asked = importlib.import_module("solver.pipeline.generate"), Request(seed=520)
    made = generate(asked)
    assert [issue.message for issue in made.issues if issue.severity == "error"] == []
    certificate: Any = made.scene.certificate
    assert not any(room["notes"] for room in certificate["rooms"].values())
    monkeypatch.setattr(pipeline, "_is_in_one_go", lambda _: False)
    assert generate(asked).scene == made.scene


def test_a_room_does_not_depend_on_the_others_of_its_house() -> None:
    rows = [wanting_room(seed).rows() for seed in range(12)]
    together = place_wanted(rows, tidy=True)
    alone = [place_wanted([one], tidy=True)[0] for one in rows]
    assert [one.placed for one in together] == [one.placed for one in alone]
    assert place_wanted([]) == []


def test_an_optimum_that_osqp_does_not_find_is_never_served(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(qp.REFUTED, "osqp", -1.0)
    with pytest.raises(qp.OptimumRefuted) as refuted:
        place_wanted([wanting_room(3).rows()])
    assert isinstance(refuted.value.problem, bytes) and len(refuted.value.problem) > 40


def test_the_reference_confirms_the_same_rooms() -> None:
    rows = [wanting_room(seed).rows() for seed in range(6)]
    ours, theirs = place_wanted(rows), place_wanted(rows, engine="reference")
    assert [one.placed for one in theirs] == [one.placed for one in ours]
    assert all(one.residuals and max(one.residuals) < -4 for one in theirs)
    with pytest.raises(RequestError, match="engine"):
        place_wanted(rows, engine="abacus")


def test_what_osqp_does_not_solve_has_no_residuals(monkeypatch: pytest.MonkeyPatch) -> None:
    rows = [wanting_room(seed).rows() for seed in range(3)]
    solved = place_wanted(rows)
    for name, value in (("max_iter", 1), ("eps_abs", 1e-30), ("eps_rel", 0.0)):
        monkeypatch.setitem(qp.SETTINGS, name, value)
    unsolved = place_wanted(rows)
    assert all(one.residuals for one in solved) and not any(one.residuals for one in unsolved)
    assert [one.placed for one in unsolved] == [one.placed for one in solved]
