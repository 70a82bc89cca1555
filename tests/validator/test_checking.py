"""What is checked again after a change against what is checked from the start, on random changes of random little houses."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from solver import Request, generate
from solver.exchange import read_scene, write_scene
from solver.scene import Decoration, Dynamic, Opening, Room, Scene
from solver.validator import check, validate
from solver.validator import checking as module
from solver.validator.judging import JUDGED
from tests.sweeps import examples
from tests.validator.test_against_raster import furniture, houses, openings, tenths, twentieths
from tests.validator.worlds import CATALOGS, piece, room, scene

Change = Callable[[Scene], Scene]


def in_room(name: str, change: Callable[[Room], Room]) -> Change:
    return lambda scene: replace(scene, rooms=tuple(change(room) if room.id == name else room for room in scene.rooms))


@st.composite
def changes(draw: st.DrawFn) -> Change:
    """One change of a house of the rooms a and b: nearly always of what stands in it."""
    name, what = draw(st.sampled_from("ab")), draw(st.sampled_from(("piece", "piece", "less", "thing", "person", "doors", "house")))
    if what == "piece":
        index = draw(st.integers(0, 4))
        new = draw(furniture(name, (4.0, 4.0), index))
        return in_room(name, lambda room: replace(room, furniture=(*room.furniture[:index], new, *room.furniture[index + 1 :])))
    if what == "less":
        return in_room(name, lambda room: replace(room, furniture=room.furniture[1:]))
    if what == "thing":
        size, parent = draw(tenths(0.1, 1.0)), draw(st.sampled_from((None, f"{name}/0", f"{name}/1")))
        y = draw(st.sampled_from((0.0, 0.5, 1.0)))
        thing = Decoration(f"{name}/vase", "vase", parent, None, draw(twentieths(0, 4)), y, draw(twentieths(0, 4)), 0, size, size, size)
        return in_room(name, lambda room: replace(room, decorations=(thing,)))
    if what == "person":
        home, at = draw(st.sampled_from(("a", "b", "nowhere"))), (draw(twentieths(0, 4)), draw(twentieths(0, 4)))
        return lambda scene: replace(scene, dynamic=(Dynamic("person_1", room=home, x=at[0], z=at[1]),))
    if what == "doors":
        doors = draw(openings(name, (2.6, 2.6), None))
        return in_room(name, lambda room: replace(room, openings=(*room.openings[-2:], *doors)))
    thickness = draw(st.sampled_from((0.0, 0.2)))
    reasons = {"rooms": {"a": {"left_out": [{"piece": "bed_1", "reason": draw(st.sampled_from(("small", "full")))}]}}}
    return lambda scene: replace(scene, wall_thickness=thickness, certificate=reasons)


@examples(24)
@given(houses(), st.lists(changes(), min_size=1, max_size=6))
def test_what_is_checked_again_is_as_if_all_had_been(scene: Scene, edits: list[Change]) -> None:
    scene = replace(
        scene, rooms=tuple(replace(room, type=kind) for room, kind in zip(scene.rooms, ("bedroom", "dining_room"), strict=True))
    )
    checked = check(scene, CATALOGS)
    assert checked.issues == validate(scene, CATALOGS)
    for edit in edits:
        scene = edit(scene)
        checked = checked.after(scene)
        assert checked.scene == scene
        assert checked.issues == validate(scene, CATALOGS)


def test_rooms_that_did_not_change_are_not_checked_again(monkeypatch: pytest.MonkeyPatch) -> None:
    still, other = room(piece(1.0, 1.0), id="still"), room(piece(2.0, 2.0), id="other", x=10.0)
    checked = check(scene(still, other), CATALOGS)
    looked: list[tuple[str, str]] = []
    judge = module.issues_of  # type: ignore[attr-defined]

    def judging(rules: Iterable[str], case: Any) -> Any:
        asked = list(rules)
        looked.extend((case.room.room.id, rule) for rule in asked)
        return judge(asked, case)

    monkeypatch.setattr(module, "issues_of", judging)
    checked.after(scene(still, replace(other, furniture=(piece(2.5, 2.0),))))
    assert {rule for name, rule in looked if name == "still"} == {"unreachable"}
    assert {rule for name, rule in looked if name == "other"} == set(module.CHECKS) - set(JUDGED)  # type: ignore[attr-defined]


def test_rooms_told_as_rows_stay_as_they_were_judged_where_the_same_are_told_one_by_one() -> None:
    made = generate(Request(seed=5, program="studio", decorate=True)).scene
    read = read_scene(write_scene(made))
    name = next(one.id for one in read.rooms if one.furniture)
    aside = in_room(name, lambda room: replace(room, furniture=tuple(replace(one, x=one.x + 0.4) for one in room.furniture)))(read)
    again = check(made, CATALOGS).after(aside)
    assert again.errors == check(aside, CATALOGS).errors != ()


def test_openings_of_a_room_that_was_read_anew_are_where_they_were() -> None:
    lost = Opening("window_9", "window", "north", 9.0, 1.0, 1.2, 0.9)
    made = scene(replace(room(piece(1.0, 1.0), id="still"), openings=(*room().openings, lost)))
    aside = in_room("still", lambda one: replace(one, furniture=(piece(1.5, 1.0),)))(read_scene(write_scene(made)))
    told = [(issue.rule, issue.message) for issue in check(made, CATALOGS).after(aside).issues]
    assert told == [(issue.rule, issue.message) for issue in check(aside, CATALOGS).issues]
    assert [rule for rule, _ in told].count("opening_wrong") == 1
