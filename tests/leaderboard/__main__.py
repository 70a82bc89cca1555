"""The published benchmark: `make leaderboard`, or python -m tests.leaderboard [--foreign DIR] [--answers DIR] [--write DIR].

Without anything: our answers to rooms with relations and to dense rooms, and their figures. `--foreign DIR` adds the repair of scenes
that you fetched. `--write DIR` writes the tasks and our answers; `--answers DIR` judges those of another system. See docs/benchmark.md.
"""

from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Any

from tests.leaderboard.rulers import figures
from tests.leaderboard.tracks import TRACKS, Task, dense_tasks, digest_of, ours, relation_tasks, repair_tasks


def tasks_of(track: str, foreign: Path | None) -> list[Task]:
    """Returns a track's tasks; none of repair without scenes."""
    if track == "repair":
        return list(repair_tasks(foreign)) if foreign else []
    return list(relation_tasks() if track == "relations" else dense_tasks())


def answered(folder: Path, track: str) -> dict[str, Any]:
    """Reads another system's answers: a document {id, scene, seconds} a line."""
    path = folder / f"{track}.jsonl"
    lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
    return {one["id"]: one for one in map(json.loads, lines)}


def lines_of(documents: list[dict[str, Any]]) -> str:
    """Returns documents, one a line."""
    return "".join(json.dumps(one, separators=(",", ":")) + "\n" for one in documents)


def main(arguments: list[str] | None = None) -> int:
    """Prints the figures of every track."""
    parser = argparse.ArgumentParser(description=__doc__)
    for name in ("foreign", "answers", "write"):
        parser.add_argument(f"--{name}", type=Path, metavar="DIR")
    asked = parser.parse_args(arguments)
    for track in TRACKS:
        tasks = tasks_of(track, asked.foreign)
        if not tasks:
            print(f"{track}: no scenes; --foreign DIR names a folder of them", file=sys.stderr)
            continue
        answers = answered(asked.answers, track) if asked.answers else {one["id"]: one for one in ours(track, tasks)}
        if asked.write:
            for name, documents in (("tasks", tasks), ("answers", list(answers.values()))):
                path = asked.write / name / f"{track}.jsonl"
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(lines_of(documents), encoding="utf-8")
        print(f"{track} (tasks {digest_of(tasks)[:16]})")
        print("  " + ", ".join(f"{name} {value:.4g}" for name, value in figures(track, tasks, answers).items()))
        if track == "repair":
            sent = {task["id"]: {"id": task["id"], "scene": task["scene"]} for task in tasks}
            print("  as sent: " + ", ".join(f"{name} {value:.4g}" for name, value in figures(track, tasks, sent).items()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
