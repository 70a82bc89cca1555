"""The published benchmark: our answers are judged well, and what is wrong with an answer is seen."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from solver.exchange import write_scene
from tests.leaderboard.__main__ import answered, lines_of, main
from tests.leaderboard.rulers import figures
from tests.leaderboard.tracks import Task, dense_tasks, digest_of, ours, relation_tasks, repair_tasks
from tests.pipeline.fix_rooms import body, room_of

Answer = dict[str, Any]
CROWDED = [
    room_of(body("sofa", 1.5, 1.0, (2.0, 0.9, 0.8)), body("armchair", 1.0 + 0.3 * k, 1.2, (0.8, 0.8, 0.8)), width=5.0) for k in range(3)
]


@pytest.fixture(scope="module")
def scenes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("scenes")
    (folder / "rooms.jsonl").write_text(lines_of([write_scene(scene) for scene in CROWDED]))
    return folder


def tasks_of(track: str, scenes: Path) -> list[Task]:
    return list({"relations": lambda: relation_tasks(3), "dense": lambda: dense_tasks(4), "repair": lambda: repair_tasks(scenes)}[track]())


def judged(track: str, scenes: Path, change: Callable[[Answer], object] = lambda _: None) -> dict[str, float]:
    tasks = tasks_of(track, scenes)
    answers = {one["id"]: copy.deepcopy(one) for one in ours(track, tasks)}
    for one in answers.values():
        change(one)
    return figures(track, tasks, answers)


@pytest.mark.parametrize("track", ["relations", "dense", "repair"])
def test_our_answers_are_judged_well(track: str, scenes: Path) -> None:
    found = judged(track, scenes)
    assert found["answered"] == found["tasks"] and found["valid"] == 1.0 and found["cpu_ms"] > 0
    expected = {"relations": ("held", 0.9), "dense": ("cover", 0.3), "repair": ("kept", 1.0)}[track]
    assert found[expected[0]] >= expected[1]


def _furniture(answer: Answer) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = answer["scene"]["rooms"][0]["furniture"]
    return found


def _shrink(answer: Answer) -> None:
    for piece in _furniture(answer):
        piece["width"] = 0.1


def _heap(answer: Answer) -> None:
    for piece in _furniture(answer):
        piece.update(x=1.0, z=1.0)


def _widen(answer: Answer) -> None:
    answer["scene"]["rooms"][0]["width"] += 5


@pytest.mark.parametrize("change", [_shrink, _heap, _widen])
@pytest.mark.parametrize("track", ["relations", "dense", "repair"])
def test_what_is_wrong_with_an_answer_is_seen(track: str, scenes: Path, change: Callable[[Answer], object]) -> None:
    assert judged(track, scenes, change)["valid"] == 0.0


def test_what_is_left_out_counts(scenes: Path) -> None:
    assert judged("dense", scenes, lambda answer: _furniture(answer).clear())["required"] == 0.0
    assert judged("repair", scenes, lambda answer: _furniture(answer).clear())["kept"] == 0.0
    assert judged("relations", scenes, lambda answer: _furniture(answer).clear())["placed"] == 0.0
    tasks = tasks_of("relations", scenes)
    nothing = figures("relations", tasks, {})
    assert (nothing["answered"], nothing["valid"], nothing["held"]) == (0, 0.0, 0.0)


def test_another_system_reads_the_tasks_and_is_judged_by_its_answers(
    scenes: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, count in (("relation_tasks", 2), ("dense_tasks", 2)):
        real = {"relation_tasks": relation_tasks, "dense_tasks": dense_tasks}[name]
        monkeypatch.setattr(f"tests.leaderboard.__main__.{name}", lambda real=real, count=count: real(count))
    assert main(["--foreign", str(scenes), "--write", str(tmp_path)]) == 0
    said = capsys.readouterr().out
    for track in ("relations", "dense", "repair"):
        tasks = [json.loads(line) for line in (tmp_path / "tasks" / f"{track}.jsonl").read_text().splitlines()]
        assert digest_of(tasks)[:16] in said
        assert set(answered(tmp_path / "answers", track)) == {task["id"] for task in tasks}
    assert main(["--foreign", str(scenes), "--answers", str(tmp_path / "answers")]) == 0
    assert capsys.readouterr().out == said
