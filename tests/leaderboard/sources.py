"""Fetches the public scenes that the track `repair` is run on, checks their digests, and writes them as documents a line.

python -m tests.leaderboard.sources --out DIR [--have DIR] [NAME ...]

Comes in: sources.yaml; files from their addresses, or those that `--have` holds already. Goes out: DIR/NAME.jsonl, for `--foreign DIR`.
"""

from __future__ import annotations

import argparse
import gzip
import json
import re
import sys
from collections import Counter
from collections.abc import Iterator, Mapping
from hashlib import sha256
from pathlib import Path
from statistics import median
from typing import Any, Final
from urllib.error import URLError
from urllib.request import urlopen

import yaml

from solver.scene import FORMAT
from solver.whole_files import write_whole

Source = Mapping[str, Any]
SOURCES: Final = Path(__file__).with_name("sources.yaml")
TIMEOUT_S: Final = 60.0
_ROOM: Final = re.compile(r"max length (\d+)px, max width (\d+)px")
_SIDES: Final = {"width": "length", "depth": "width", "height": "height"}
"""What LayoutGPT calls a piece's sides."""


class SourceError(Exception):
    """A source cannot be had, or is not the file that was measured with."""


def content_of(source: Source, have: Path | None) -> bytes:
    """Returns a source's file.

    Args:
        source: its `url`, `bytes` and `sha256`.
        have: a folder that may hold it, by the name that its address ends with; else it is fetched.

    Raises:
        SourceError: it cannot be had, or has other bytes.
    """
    url, held = str(source["url"]), None if have is None else have / str(source["url"]).rpartition("/")[2]
    try:
        if held is not None and held.is_file():
            content = held.read_bytes()
        else:
            with urlopen(url, timeout=TIMEOUT_S) as answer:
                content = answer.read(source["bytes"] + 1)
    except (URLError, OSError) as error:
        raise SourceError(f"{url} cannot be had: {error}") from None
    found = sha256(content).hexdigest()
    if found != source["sha256"]:
        raise SourceError(f"{held or url} is another file: SHA-256 {found} instead of {source['sha256']}")
    return content


def documents_of(source: Source, content: bytes, heights: Mapping[str, float]) -> Iterator[Mapping[str, Any]]:
    """Yields a source's scenes: our documents, or what `compose import` reads.

    Args:
        source: its `form`: `lines`, gzipped or not, of documents as they are; or `layoutgpt`.
        content: of its file.
        heights: usual heights of kinds, m, for rooms of no known scale.
    """
    if source["form"] == "layoutgpt":
        yield from (_room(one, heights) for one in json.loads(content))
        return
    text = gzip.decompress(content) if content.startswith(b"\x1f\x8b") else content
    yield from (json.loads(line) for line in text.splitlines() if line.strip())


def _room(answer: Mapping[str, Any], heights: Mapping[str, float]) -> Mapping[str, Any]:
    """Returns a room of LayoutGPT as a scene: whole millimetres, turns to the nearest right angle; what hangs from above is left out.

    `left`, `top` and `depth` are a piece's middle, from west, north and below; `length` is along x at turn 0, in which it faces south.
    """
    pieces = [(name, box) for name, box in answer["object_list"] if "lamp" not in name or name == "floor_lamp"]
    known = [heights[name] / box["height"] for name, box in pieces if name in heights and box["height"] > 0]
    scale = median(known or [1 / 80])
    found = _ROOM.search(answer["prompt"])
    if found is None:
        raise SourceError(f"{answer['query_id']} names no size of its room")
    width, depth = (round(int(pixels) * scale, 3) for pixels in found.groups())
    kind = answer["prompt"].partition("Room Type: ")[2].partition("\n")[0].partition(" &")[0].replace(" ", "_")
    seen, furniture = Counter[str](), []
    for name, box in pieces:
        seen[name] += 1
        sizes = {side: max(0.01, round(box[key] * scale, 3)) for side, key in _SIDES.items()}
        at = {"x": round(box["left"] * scale, 3), "y": 0.0, "z": round(box["top"] * scale, 3)}
        turn = round(box["orientation"] / 90) * 90 % 360
        furniture.append({"id": f"{kind}_0/{name}_{seen[name]}", "name": name, **at, "rotation": turn, **sizes, "color": "#999999"})
    room = {"id": f"{kind}_0", "type": kind, "x": 0.0, "z": 0.0, "width": width, "depth": depth, "openings": [], "furniture": furniture}
    return {"format": FORMAT, "rooms": [room]}


def fetch(folder: Path, have: Path | None, names: list[str], sources: Path = SOURCES) -> None:
    """Writes the scenes of some sources into a folder, and says what they hold and under which licence.

    Raises:
        SourceError: one cannot be had; those before it are there.
    """
    book = yaml.load(sources.read_text(encoding="utf-8"), yaml.CSafeLoader)
    folder.mkdir(parents=True, exist_ok=True)
    for name in names or book["sources"]:
        source = book["sources"][name]
        documents = list(documents_of(source, content_of(source, have), book["usual_heights"]))
        lines = (json.dumps(one, separators=(",", ":")) + "\n" for one in documents)
        write_whole(folder / f"{name}.jsonl", "".join(lines).encode())
        print(f"{name}: {len(documents)} scenes ({source['holds']}; {source['license']})")


def main(arguments: list[str] | None = None) -> int:
    """Fetches what is asked for."""
    known = list(yaml.load(SOURCES.read_text(encoding="utf-8"), yaml.CSafeLoader)["sources"])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, required=True, metavar="DIR", help="where NAME.jsonl is written")
    parser.add_argument("--have", type=Path, metavar="DIR", help="a folder of files that were fetched before")
    parser.add_argument("names", nargs="*", choices=[*known, []], metavar="NAME", help=f"of {', '.join(known)} (all)")
    asked = parser.parse_args(arguments)
    try:
        fetch(asked.out, asked.have, asked.names)
    except SourceError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
