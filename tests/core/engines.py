"""Whether Node and Chromium answer what wasmtime answered: recordings of calls, played again there.

Comes in: recordings. Goes out: for each how many calls it held and the differences found, a list of both.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from playwright.sync_api import Browser, sync_playwright
from tqdm import tqdm

from solver import Request, fix, generate
from solver.core.host import WASM
from solver.pipeline.drag import alone
from solver.scene import Scene
from tests.chromium import FLAGS, executable
from tests.core.recording import recorded
from tests.pipeline.drags import dragged as answered

ROOT = Path(__file__).resolve().parents[2]
SETS: Sequence[dict[str, Any]] = ({}, {"program": "family", "decorate": True}, {"program": "large", "decorate": True})
STEP = 0.05
"""How far a piece is dragged a frame, m."""
PLAY = """async ([wasm, names]) => {
    const { replay } = await import('/replay.js');
    const bytes = async (name) => new Uint8Array(await (await fetch(name)).arrayBuffer());
    const core = await bytes(wasm);
    const answers = [];
    for (const name of names) answers.push(await replay(core, await bytes(name)));
    return answers;
}"""
Answers = list[dict[str, Any]]


def dragged(scene: Scene, frames: int) -> None:
    """Repairs a home while its largest piece is dragged along, frame by frame."""
    room = max(scene.rooms, key=lambda room: len(room.furniture))
    piece = max(room.furniture, key=lambda piece: piece.width * piece.depth)
    for frame in range(1, frames + 1):
        there = tuple(replace(one, x=one.x + STEP * frame) if one is piece else one for one in room.furniture)
        rooms = tuple(replace(room, furniture=there) if one is room else one for one in scene.rooms)
        fix(replace(scene, rooms=rooms), moved=(piece.id,))


def frames_of_drags(scene: Scene, frames: int) -> None:
    """Answers so many frames of a drag in every room of a home, as the page asks them."""
    for room in scene.rooms:
        own = alone(scene, room)
        largest = max((piece for piece in room.furniture if piece.on is None), key=lambda piece: piece.width * piece.depth, default=None)
        if largest is not None:
            answered(own, largest.id, frames)


def recording_of(seeds: range, frames: int) -> bytes:
    """Makes a home a seed, of the sets in turn, with so many frames of dragging in the first, and returns what the core was asked."""
    with recorded() as recorder:
        for seed in seeds:
            scene = generate(Request(seed=seed, **SETS[seed % len(SETS)])).scene
            if seed == seeds.start:
                dragged(scene, frames)
                frames_of_drags(scene, frames)
    return recorder.content


def in_node(recordings: Sequence[bytes]) -> Answers:
    """Plays recordings in Node."""
    with tempfile.TemporaryDirectory() as name:
        paths = _written(Path(name), recordings)
        report = Path(name) / "report.json"
        command = [sys.executable, str(ROOT / "scripts" / "page.py"), "replay", str(report), str(WASM), *map(str, paths)]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stdout[-2000:] + run.stderr[-2000:]
        answers: Answers = json.loads(report.read_text())
    return answers


def in_chromium(browser: Browser, recordings: Sequence[bytes]) -> Answers:
    """Plays recordings in a page that has nothing but them."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        names = [path.name for path in _written(folder, recordings)]
        (folder / WASM.name).write_bytes(WASM.read_bytes())
        (folder / "replay.js").write_bytes((ROOT / "web" / "tests" / "replay.js").read_bytes())
        (folder / "index.html").write_text("<!doctype html><title>replay</title>")
        with _served(folder) as address:
            page = browser.new_page()
            page.goto(address)
            answers: Answers = page.evaluate(PLAY, [WASM.name, names])
            page.close()
    return answers


def _written(folder: Path, recordings: Sequence[bytes]) -> list[Path]:
    paths = [folder / f"{number}.recording" for number in range(len(recordings))]
    for path, content in zip(paths, recordings, strict=True):
        path.write_bytes(content)
    return paths


class _Silent(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *arguments: Any) -> None:
        """Says nothing."""


@contextmanager
def _served(folder: Path) -> Iterator[str]:
    with ThreadingHTTPServer(("127.0.0.1", 0), partial(_Silent, directory=str(folder))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


def engines(seeds: int, batch: int = 10, frames: int = 10) -> bool:
    """Compares the engines over homes and frames of dragging; prints what differs. Returns whether nothing does."""
    calls, wrong = 0, 0
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable(), args=FLAGS)
        for first in tqdm(range(0, seeds, batch), desc="engines", disable=None):
            recording = recording_of(range(first, first + batch), frames)
            for where, (answer,) in (("Node", in_node([recording])), ("Chromium", in_chromium(browser, [recording]))):
                calls += answer["calls"]
                wrong += len(answer["differences"])
                if answer["differences"]:
                    print(f"{where}, seeds {first}-{first + batch - 1}: {answer['differences']}")
        browser.close()
    print(
        f"{seeds} homes and {seeds // batch * frames} frames of dragging: {calls} calls answered by Node and Chromium, {wrong} differently"
    )
    return not wrong
