"""The report: everything named once, everything wrong behind `>>`, and nothing behind it that is not wrong."""

from __future__ import annotations

import re
from collections import Counter
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from catalogs import load_catalogs
from service.calls import validate_scene
from solver.errors import FieldError, SceneError
from tests.sweeps import examples

Document = dict[str, Any]
TEXTS = st.text(st.characters(codec="utf-8"), min_size=1, max_size=8)
CATALOGS = load_catalogs()


def piece(name: str, x: float, z: float, **more: Any) -> Document:
    return {"id": f"den/{name}", "name": name, "x": x, "z": z, "width": 0.8, "depth": 0.6, "height": 0.7, **more}


def house(*furniture: Document, **more: Any) -> Document:
    """A den of 5 x 4 m with a front door in its north wall, a window in its south wall, a rug and a dog."""
    openings = [
        {"id": "front", "kind": "door", "wall": "north", "position": 4.25, "width": 0.8, "connects_to": "EXTERIOR", "main_entrance": True},
        {"id": "view", "kind": "window", "wall": "south", "position": 2.5, "width": 1.3, "sill": 0.9},
    ]
    rug = {"id": "den/rug", "name": "rug", "x": 2.5, "z": 2.0, "width": 2.0, "depth": 1.0, "height": 0.01}
    room = {"id": "den", "type": "nook", "width": 5, "depth": 4, "openings": openings, "furniture": furniture, "decorations": [rug]}
    dog = {"id": "dog_1", "kind": "dog", "room": "den", "x": 2.5, "z": 2.9, "width": 0.3, "depth": 0.7, "height": 0.5}
    return {"seed": 7, "request": {"seed": 7, "area": None}, "rooms": [room], "dynamic": [dog], **more}


CLEAN = house(piece("table", 1.5, 0.5), piece("lamp", 0.3, 3.6, width=0.3, depth=0.3))
BROKEN = house(
    piece("table", 1.5, 0.5),
    piece("chest", 1.9, 0.6),
    piece("shelf", 2.5, 2.0, wall="north"),
    piece("crate", 4.2, 0.5),
    piece("tower", 2.5, 3.6, height=2.0),
    piece("stray", 5.2, 2.0),
)


def answer(scene: Document, **more: Any) -> Document:
    return validate_scene({"scene": scene, "report": True, **more}, CATALOGS)


def lines_of(scene: Document, **more: Any) -> list[str]:
    text: str = answer(scene, **more)["report"]["text"]
    assert text.endswith("\n")
    return text[:-1].split("\n")


def wrong(lines: list[str]) -> list[str]:
    return [line for line in lines if line.startswith(">>")]


def test_every_room_opening_and_body_has_one_line() -> None:
    lines = lines_of(BROKEN)
    for name, shape in {
        "den": r"^(>>|  ) den \(nook\): 5 × 4 m, 20\.00 m² clear, ",
        "front": r"door front: north wall at 4\.25, 0\.8 wide, 2\.1 high, leads to outside, main entrance$",
        "view": r"window view: south wall at 2\.5, 1\.3 wide, 2\.1 high, sill 0\.9$",
        "shelf": r"shelf \(den/shelf\): at \[2\.5, 2\], 0\.8×0\.6×0\.7, rotation 0, north wall ",
        "rug": r"rug \(den/rug\): at \[2\.5, 2\], 2×1×0\.01, rotation 0$",
        "dog": r"dog \(dog_1\): at \[2\.5, 2\.9\], 0\.3×0\.7×0\.5, rotation 0$",
        **{name: rf"{name} \(den/{name}\): " for name in ("table", "chest", "crate", "tower", "stray")},
    }.items():
        assert len([line for line in lines if re.search(shape, line)]) == 1, name


def test_the_head_says_what_was_asked_and_what_is_there() -> None:
    head = "\n".join(lines_of(CLEAN)[:7])
    assert "seed 7" in head
    assert "# Request: seed 7\n" in head
    assert "1 rooms, 1 doors and passages, 1 windows, 2 furniture, 1 decorations, 1 people and pets" in head


def test_every_issue_is_behind_the_mark_on_its_pieces_line_and_in_the_summary() -> None:
    found = answer(BROKEN)
    assert {"overlap", "wall_far", "blocks_door", "blocks_window", "out_of_bounds"} <= {issue["rule"] for issue in found["issues"]}
    lines = found["report"]["text"].split("\n")
    summary = next(number for number, line in enumerate(lines) if line.strip().startswith("Summary"))
    for issue in found["issues"]:
        word = issue["rule"].replace("_", " ").upper()
        told = [number for number, line in enumerate(lines) if line.startswith(">>") and word in line and issue["message"] in line]
        assert len(told) == max(1, len(issue["ids"])) + 1
        assert len([number for number in told if number > summary]) == 1
        for name in issue["ids"]:
            own = next(line for line in lines if f"({name}):" in line)
            assert own.startswith(">>")
            assert word in own


def test_an_amount_is_given_in_metres() -> None:
    overlap = next(issue for issue in answer(BROKEN)["issues"] if issue["rule"] == "overlap")
    assert overlap["amount"] == pytest.approx(0.4)
    assert any("OVERLAP by 0.4 m: " in line for line in wrong(lines_of(BROKEN)))


def test_issues_of_no_piece_stand_on_their_room() -> None:
    scene = house()
    scene["rooms"][0]["type"] = "bedroom"
    title = next(line for line in lines_of(scene) if "den (bedroom)" in line)
    assert title.startswith(">> ")
    assert title.endswith("[MISSING REQUIRED]")


def test_a_clean_scene_has_no_marks() -> None:
    lines = lines_of(CLEAN)
    assert answer(CLEAN)["issues"] == []
    assert [line for line in lines if line.startswith((">>", "!!"))] == []
    assert lines[-1].endswith("no issues")


def test_flagged_pieces_are_marked_and_listed() -> None:
    lines = lines_of(BROKEN, flagged=["den/rug", "den/chest"])
    own = {name: next(line for line in lines if f"({name}):" in line) for name in ("den/rug", "den/chest", "den/table")}
    assert own["den/rug"].startswith("!! ")
    assert own["den/rug"].endswith("[PROBLEMATIC]")
    assert own["den/chest"].startswith(">> ")
    assert own["den/chest"].endswith("[OVERLAP, FRONT BLOCKED, PROBLEMATIC]")
    assert "PROBLEMATIC" not in own["den/table"]
    start = next(number for number, line in enumerate(lines) if "Flagged as PROBLEMATIC" in line)
    assert [line.split()[1] for line in lines[start + 1 : start + 3]] == ["den/chest", "den/rug"]


def test_the_lines_say_which_body_they_speak_of() -> None:
    told = answer(BROKEN, flagged=["dog_1"])["report"]
    lines = told["text"].rstrip("\n").split("\n")
    assert len(lines) == len(told["lines"])
    bodies = [item["id"] for item in (*BROKEN["rooms"][0]["furniture"], *BROKEN["rooms"][0]["decorations"], *BROKEN["dynamic"])]
    assert set(told["lines"]) == {None, *bodies}
    for line, shows in zip(lines, told["lines"], strict=True):
        named = re.search(r"\((\S+)\): at \[", line)
        assert not named or named[1] == shows


def test_only_who_asks_gets_a_report() -> None:
    assert set(validate_scene({"scene": CLEAN}, CATALOGS)) == {"issues", "metrics", "understood_as"}
    assert set(validate_scene({"scene": CLEAN, "report": False}, CATALOGS)) == {"issues", "metrics", "understood_as"}
    assert set(validate_scene({"scene": CLEAN, "flagged": []}, CATALOGS)) == {"issues", "metrics", "understood_as", "report"}


def test_what_is_not_there_cannot_be_flagged() -> None:
    with pytest.raises(SceneError) as refused:
        answer(CLEAN, flagged=["den/table", "nobody"])
    assert refused.value.field == "flagged[1]"
    with pytest.raises(FieldError) as refused_too:
        validate_scene({"scene": CLEAN, "report": "yes"}, CATALOGS)
    assert refused_too.value.field == "report"


def test_a_scene_that_says_next_to_nothing_has_a_report() -> None:
    bare = {"rooms": [{"width": 4, "depth": 3, "furniture": [{"name": "thing", "x": 1, "z": 1, "width": 1, "depth": 1, "height": 1}]}]}
    lines = lines_of(bare)
    assert [line for line in lines if "at [1, 1], 1×1×1, rotation 0" in line]
    assert wrong(lines) == []


@examples(24)
@given(st.lists(TEXTS, min_size=6, max_size=6, unique=True), TEXTS)
def test_whatever_names_hold_they_stay_on_their_line(names: list[str], word: str) -> None:
    room, door, one, other, item, person = names
    scene = {
        "request": {"seed": 1, word: [word]},
        "certificate": {"rooms": {room: {"cost": 1, "left_out": [{"piece": word, "reason": word}]}}},
        "rooms": [
            {
                "id": room, "type": word, "width": 3, "depth": 3,
                "openings": [{"id": door, "wall": "east", "position": 1.5, "connects_to": word}],
                "furniture": [{**piece(word, 1, 1), "id": one, "on": word}, {**piece(word, 1, 1), "id": other, "under": word}],
                "decorations": [{**piece("<b>", 2, 2), "id": item, "parent": one}],
            }
        ],
        "dynamic": [{"id": person, "kind": word, "room": word, "x": 1, "z": 1}],
    }  # fmt: skip
    told = answer(scene, flagged=[person])["report"]
    lines = told["text"].rstrip("\n").split("\n")
    assert len(lines) == len(told["lines"]) == len(told["text"].splitlines())
    assert Counter(shows for line, shows in zip(lines, told["lines"], strict=True) if ": at [" in line) >= Counter(
        [one, other, item, person]
    )
    assert all(letter.isprintable() for line in lines for letter in line)
