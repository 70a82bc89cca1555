"""What is proven is proven of one placement: of furniture that was changed since, nothing is."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from catalogs import load_catalogs
from service.calls import validate_scene, view_scene
from solver import Request, fix, generate, reroll, restyle
from solver.exchange import dump_text, load_text, read_scene, write_scene
from solver.pipeline.import_plan import import_plan
from solver.scene import Room, Scene

CATALOGS = load_catalogs()
REQUESTS = [Request(seed=42, width=8.0, depth=6.0, decorate=True), Request(seed=3, program="one_bed")]


def entries(scene: Scene) -> dict[str, Any]:
    certificate: Any = scene.certificate
    return dict(certificate["rooms"])


def furnished(scene: Scene) -> Room:
    return max(scene.rooms, key=lambda room: len(room.furniture))


def edited(scene: Scene, **change: Any) -> Scene:
    """The scene with one piece of its fullest room changed."""
    room = furnished(scene)
    new = replace(room, furniture=(replace(room.furniture[0], **change), *room.furniture[1:]))
    return replace(scene, rooms=tuple(new if one.id == room.id else one for one in scene.rooms))


def report(scene: Scene) -> str:
    text: str = validate_scene({"scene": write_scene(scene), "report": True}, CATALOGS)["report"]["text"]
    return text


@pytest.mark.parametrize("request_", REQUESTS)
@pytest.mark.parametrize("format", ["json", "yaml"])
def test_a_scene_as_made_keeps_its_proofs_through_files_and_repairs(request_: Request, format: str) -> None:
    made = generate(request_).scene
    read = read_scene(load_text(dump_text(write_scene(made), format), format))
    assert entries(fix(read).scene) == entries(made)
    assert "changed since" not in report(read) + view_scene({"scene": write_scene(read)}, CATALOGS)["text"]
    assert report(read).count("placement: cost") == len(made.rooms)


def test_a_file_opened_tells_no_proofs_of_a_room_that_was_edited_in_it() -> None:
    made = generate(REQUESTS[0]).scene
    opened = import_plan(dump_text(write_scene(edited(made, x=1.2345)), "json")).scene
    assert {name for name, entry in entries(opened).items() if "proven" not in entry} == {furnished(made).id}
    restyled = restyle(fix(edited(made, id="another")).scene, style="rustic").scene
    assert import_plan(dump_text(write_scene(restyled), "json")).scene == restyled, "a file tells what was told"
    as_made = import_plan(dump_text(write_scene(made), "json")).scene
    assert entries(as_made) == entries(made)


@pytest.mark.parametrize("change", [{"x": 1.2345}, {"rotation": 45.0}, {"width": 0.7}, {"id": "another"}])
def test_of_a_changed_room_nothing_is_proven_and_of_the_others_all(change: dict[str, Any]) -> None:
    made = generate(REQUESTS[0]).scene
    room = furnished(made).id
    repaired = fix(edited(made, **change), on_conflict="report").scene
    as_made = furnished(repaired).furniture == furnished(made).furniture
    assert not as_made or set(change) <= {"x", "rotation"}, "put back, it stands where it was proven best; all else is another room"
    for scene in (edited(made, **change), *(() if as_made else (repaired,))):
        text = report(scene)
        proven = sum(entry["proven"] for name, entry in entries(made).items() if name != room)
        assert f"# Placement: proven optimal in {proven} of {len(made.rooms)} rooms, 1 changed since\n" in text
        assert text.count("placement: cost") == len(made.rooms) - 1
        assert text.count("placement: changed since it was made") == 1
        assert "1 changed since" in view_scene({"scene": write_scene(scene)}, CATALOGS)["text"]
    assert ("proven" in entries(repaired)[room]) == as_made


def test_colours_and_locks_are_no_placement() -> None:
    made = generate(REQUESTS[0]).scene
    assert "changed since" not in report(edited(made, color="#123456", locked=True))


def test_a_room_furnished_anew_is_proven_anew() -> None:
    made = generate(REQUESTS[0]).scene
    changed = fix(edited(made, id="another")).scene
    again = reroll(changed, [furnished(made).id], seed=5).scene
    assert "changed since" not in report(again)


def test_after_a_repair_it_counts_what_is_there() -> None:
    made = generate(REQUESTS[0]).scene
    gone = furnished(made).furniture[-1].id
    fewer = replace(
        made, rooms=tuple(replace(room, furniture=tuple(one for one in room.furniture if one.id != gone)) for room in made.rooms)
    )
    counts: Any = (fix(fewer).scene.certificate or {})["counts"]
    assert counts["furniture"] == sum(len(room.furniture) for room in made.rooms) - 1
    assert counts["dynamic"] == len(made.dynamic)
