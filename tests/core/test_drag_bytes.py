"""Frames of drags are answered with the same bytes by the page's own code in Node as by wasmtime; test_engines.py has Chromium."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from base64 import b64encode
from hashlib import sha256
from pathlib import Path
from struct import pack
from typing import Any

import pytest

from catalogs import load_catalogs
from solver.pipeline.drag import opening_of
from tests.pipeline.drags import dense_rooms, dragged, spots_of

ROOT = Path(__file__).resolve().parents[2]
FRAMES, SEEDS = 50, range(1, 4)
LEAST_FRAMES = 300


@pytest.fixture(scope="module")
def drags() -> list[dict[str, Any]]:
    """Drags of the largest piece of two rooms of some homes: what the core is sent, and a digest of its answers, as 64-bit floats."""
    rows = []
    for seed in SEEDS:
        for scene in dense_rooms(seed)[:2]:
            label = max((piece for piece in scene.rooms[0].furniture if piece.on is None), key=lambda piece: piece.width * piece.depth).id
            opening, steps, digest = opening_of(scene, label, (), load_catalogs()), dragged(scene, label, FRAMES), sha256()
            for step in steps:
                digest.update(pack(f"<{2 + len(step.before)}d", step.answer.outcome, step.answer.work, *step.answer.spots))
            assert opening is not None
            sent = {"opening": b64encode(opening).decode("ascii"), "start": spots_of(scene), "wishes": [step.wish for step in steps]}
            rows.append({**sent, "digest": digest.hexdigest()})
    return rows


def in_node(drags: list[dict[str, Any]], folder: Path) -> subprocess.CompletedProcess[str]:
    """Has the page's test drag the same in Node."""
    given = folder / "drags.json"
    given.write_text(json.dumps(drags))
    command = [sys.executable, str(ROOT / "scripts" / "page.py"), "test", "tests/drag_core.test.ts"]
    plain = {"COMPOSE_DRAGS": str(given), "NO_COLOR": "1"}  # colours would stand inside the digests
    known = {name: value for name, value in os.environ.items() if name != "FORCE_COLOR"}
    return subprocess.run(command, env={**known, **plain}, capture_output=True, text=True, check=False)


def test_node_answers_as_wasmtime_does(drags: list[dict[str, Any]], tmp_path: Path) -> None:
    assert sum(len(drag["wishes"]) for drag in drags) >= LEAST_FRAMES
    assert len({drag["digest"] for drag in drags}) == len(drags)
    run = in_node(drags, tmp_path)
    assert run.returncode == 0, run.stdout[-3000:] + run.stderr[-3000:]


def test_another_answer_is_noticed(drags: list[dict[str, Any]], tmp_path: Path) -> None:
    run = in_node([{**drags[0], "digest": drags[1]["digest"]}], tmp_path)
    assert run.returncode != 0
    assert drags[1]["digest"] in run.stdout + run.stderr
