"""Public scenes for the repair track: fetched, held against their digests, and read with their furniture where it was drawn."""

from __future__ import annotations

import gzip
import json
from collections.abc import Iterator
from functools import partial
from hashlib import sha256
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import pytest
import yaml

from solver import Request, generate
from solver.exchange import read_scene
from solver.pipeline.export import export
from tests.leaderboard.sources import SOURCES, SourceError, fetch, main
from tests.leaderboard.tracks import repair_tasks

ROOM = {
    "prompt": "Condition:\nRoom Type: living room & dining room\nRoom Size: max length 400px, max width 300px\n",
    "query_id": "here",
    "object_list": [
        ["wardrobe", {"length": 120, "width": 60, "height": 210, "left": 370, "top": 150, "depth": 105, "orientation": -91}],
        ["pendant_lamp", {"length": 30, "width": 30, "height": 60, "left": 200, "top": 150, "depth": 220, "orientation": 0}],
    ],
}


class _Quiet(SimpleHTTPRequestHandler):
    """Serves files and says nothing of it."""

    def log_message(self, format: str, *args: Any) -> None:
        """Says nothing."""


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, Path]]:
    """A server of this machine's own, and the folder that it serves."""
    folder = tmp_path_factory.mktemp("served")
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(folder)))
    thread = Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}", folder
    server.shutdown()
    thread.join()
    server.server_close()


def book(path: Path, address: str, contents: dict[str, bytes], forms: dict[str, str]) -> Path:
    """Writes a file of sources."""
    sources = {
        name: {
            "url": f"{address}/{name}",
            "sha256": sha256(content).hexdigest(),
            "bytes": len(content),
            "license": "MIT",
            "holds": "a test's",
            "form": forms[name],
        }
        for name, content in contents.items()
    }
    path.write_text(yaml.safe_dump({"sources": sources, "usual_heights": {"wardrobe": 2.1}}))
    return path


def test_scenes_are_fetched_and_read_where_they_were_drawn(served: tuple[str, Path], tmp_path: Path) -> None:
    address, folder = served
    made = generate(Request(seed=3, program="studio")).scene
    (house,) = export(made, "procthor").values()
    contents = {
        "houses": gzip.compress(house.replace(b"\n", b"") + b"\n" + b'{"rooms": 1}\n', mtime=0),
        "rooms": json.dumps([ROOM]).encode(),
    }
    for name, content in contents.items():
        (folder / name).write_bytes(content)
    sources = book(tmp_path / "sources.yaml", address, contents, {"houses": "lines", "rooms": "layoutgpt"})
    fetch(tmp_path / "scenes", None, [], sources)
    tasks = {task["id"]: read_scene(task["scene"]) for task in repair_tasks(tmp_path / "scenes")}
    assert set(tasks) == {"repair_houses_0", "repair_rooms_0"}
    drawn = tasks["repair_houses_0"]
    assert sum(len(room.furniture) for room in drawn.rooms) >= 0.9 * sum(len(room.furniture) for room in made.rooms if not room.outdoor)
    room = tasks["repair_rooms_0"].rooms[0]
    assert (room.type, room.width, room.depth, len(room.furniture)) == ("living_room", 4.0, 3.0, 1)
    piece = room.furniture[0]
    assert (piece.x, piece.z, piece.rotation, piece.width, piece.depth, piece.height) == (3.7, 1.5, 270, 1.2, 0.6, 2.1)


def test_another_file_is_refused(served: tuple[str, Path], tmp_path: Path) -> None:
    address, folder = served
    (folder / "rooms").write_bytes(b"[]")
    sources = book(tmp_path / "sources.yaml", address, {"rooms": b"[ ]"}, {"rooms": "layoutgpt"})
    with pytest.raises(SourceError, match="is another file"):
        fetch(tmp_path / "scenes", None, [], sources)
    assert list((tmp_path / "scenes").iterdir()) == []
    sources = book(tmp_path / "sources.yaml", f"{address}/nowhere", {"rooms": b"[]"}, {"rooms": "layoutgpt"})
    with pytest.raises(SourceError, match="cannot be had"):
        fetch(tmp_path / "scenes", None, [], sources)


def test_files_that_are_there_already_are_held_against_the_published_digests(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    known = yaml.load(SOURCES.read_text(encoding="utf-8"), yaml.CSafeLoader)["sources"]
    for source in known.values():
        (tmp_path / source["url"].rpartition("/")[2]).write_bytes(b"[]")
    for name in known:
        assert main(["--out", str(tmp_path / "scenes"), "--have", str(tmp_path), name]) == 2
        assert "is another file" in capsys.readouterr().err
