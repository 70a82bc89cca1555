"""The card of a dataset: README.md with the front matter that hubs of datasets read, figures, plots, and how to make it again."""

from __future__ import annotations

import json
import shlex
from collections import Counter
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Final
from xml.sax.saxutils import escape

import pyarrow.parquet as pq

from service.dataset.dataset_plan import SPLITS
from service.dataset.shards import ARCHIVES, SCHEMAS, TABLES
from service.tables import table
from solver.plain import Document
from solver.statistics.summary import spread
from solver.whole_files import write_whole

CARD: Final = "README.md"
MADE_FROM: Final = "made_from"
"""The folder of the files that make the set again."""
PLOTS: Final = "plots"
FIGURES: Final = {
    "area": "floor indoors, m2",
    "rooms": "rooms",
    "doors": "doors",
    "windows": "windows",
    "furniture": "pieces of furniture",
    "decorations": "decorations",
    "people": "people and pets",
    "left_out": "pieces left out",
}
"""What is told of homes as a spread, by column."""
MOST_TYPES: Final = 24
_SIZES: Final = ((1_000, "n<1K"), (10_000, "1K<n<10K"), (100_000, "10K<n<100K"), (10**6, "100K<n<1M"), (10**7, "1M<n<10M"))


def write_card(folder: Path, manifest: Document) -> None:
    """Writes the card, its plots, and the files that make the set again.

    Raises:
        OSError: a file cannot be written.
    """
    for name in (MADE_FROM, PLOTS):
        (folder / name).mkdir(exist_ok=True)
    for name in ("request", "vary"):
        if manifest[name] is not None:
            write_whole(folder / MADE_FROM / f"{name}.json", (json.dumps(manifest[name], indent=2) + "\n").encode())
    homes = _columns(folder, "houses", ["style", "program", "rooms", "proven", *(name for name in FIGURES if name != "rooms")])
    types = Counter(_columns(folder, "rooms", ["type"])["type"])
    plots = {
        "areas": spread_bars("Homes by floor indoors, m2", _known(homes["area"])),
        "furniture": spread_bars("Homes by pieces of furniture", _known(homes["furniture"])),
        "rooms": bars("Rooms by type", dict(types.most_common(MOST_TYPES))),
        "styles": bars("Homes by style", dict(sorted(Counter(map(str, _known(homes["style"]))).items()))),
    }
    for name, picture in plots.items():
        write_whole(folder / PLOTS / f"{name}.svg", picture.encode())
    parts = [_front(manifest), _words(manifest), _statistics(homes, manifest, plots), _again(manifest), _claims(), _limits(manifest)]
    write_whole(folder / CARD, ("\n\n".join(parts) + "\n").encode())


def _columns(folder: Path, name: str, columns: Sequence[str]) -> dict[str, list[Any]]:
    """Reads some columns of a table, in the order of the files' names."""
    found: dict[str, list[Any]] = {column: [] for column in columns}
    for path in sorted((folder / TABLES / name).glob("*.parquet")):
        for column, values in pq.read_table(path, columns=list(columns)).to_pydict().items():
            found[column] += values
    return found


def _known(values: Sequence[Any]) -> list[Any]:
    return [value for value in values if value is not None]


def _front(manifest: Mapping[str, Any]) -> str:
    size = next((words for most, words in _SIZES if manifest["homes"] < most), "n>10M")
    splits = [split for split in SPLITS if manifest["splits"].get(split)]
    lines = ["---", "pretty_name: Furnished homes made by Compose", "license: mit", "language: [en]", "task_categories: [other]"]
    lines += ["tags: [indoor-scenes, floor-plans, furniture-layout, robotics, synthetic]", f"size_categories: ['{size}']", "configs:"]
    for name in SCHEMAS:
        lines += [f"- config_name: {name}", *(["  default: true"] if name == "houses" else []), "  data_files:"]
        for split in splits:
            lines += [f"  - split: {split}", f"    path: {TABLES}/{name}/{split}-*.parquet"]
    return "\n".join([*lines, "---"])


def _words(manifest: Mapping[str, Any]) -> str:
    ranges = ", ".join(f"{first}-{last}" for first, last in manifest["seeds"])
    catalogs = ", ".join(f"{name} ({mark})" for name, mark in manifest["catalogs"].items())
    files = f", and `{ARCHIVES}/` of {', '.join(manifest['formats'])} as webdataset reads them" if manifest["formats"] != ["json"] else ""
    status = ", ".join(f"{count:,} {name}" for name, count in manifest["status"].items())
    splits = ", ".join(f"{manifest['splits'].get(name, 0):,} {name}" for name in SPLITS)
    return f"""# Furnished homes made by Compose

{manifest["homes"]:,} whole homes with rooms, doors, windows, furniture and what lies on it, each laid out from a seed ({ranges}) by
Compose {manifest["version"]} and judged by its validator: {status}. Catalogs: {catalogs}. Tables in parquet{files}.

Splits are drawn by a hash of the seed: {splits}. A home keeps its split when the set grows.

The homes are made by MIT-licensed software from its own catalog; no scan, drawing or model of others is in them."""


def _statistics(homes: Mapping[str, list[Any]], manifest: Mapping[str, Any], plots: Mapping[str, str]) -> str:
    rows = [[words, *_spread(_known(homes[name]))] for name, words in FIGURES.items()]
    rooms, proven = sum(_known(homes["rooms"])), sum(_known(homes["proven"]))
    counts = [[name, f"{count:,}"] for name, count in manifest["rows"].items()]
    parts = [
        "## Figures",
        table(["of a home", "10 %", "median", "90 %", "mean"], rows),
        f"{100 * proven / rooms:.2f} % of the {rooms:,} rooms are proven: no placement of their pieces is cheaper." if rooms else "",
        table(["table", "rows"], counts),
        "\n".join(f"![{name}]({PLOTS}/{name}.svg)" for name in plots),
    ]
    return "\n\n".join(part for part in parts if part)


def _spread(values: Sequence[float]) -> list[str]:
    found = spread(values) if values else {}
    return [f"{found[key]:g}" if found else "-" for key in ("p10", "median", "p90", "mean")]


def _again(manifest: Mapping[str, Any]) -> str:
    words = ["compose", "dataset", "--request", f"{MADE_FROM}/request.json"]
    words += ["--vary", f"{MADE_FROM}/vary.json"] if manifest["vary"] is not None else []
    words += ["--formats", ",".join(manifest["formats"]), "--shard-size", str(manifest["shard_size"])]
    lines = [shlex.join([*words, "--seeds", f"{first}-{last}", "--out", "homes"]) for first, last in manifest["seeds"]]
    needs = f"pip install 'compose-homes[dataset]=={manifest['version']}'"
    return "\n".join(
        [
            "## Make it again",
            "",
            f"With `{needs}`, in this folder; the scenes' digest is then `{manifest['digest']}`:",
            "",
            "```sh",
            *lines,
            "```",
            "",
            "One home alone, from its row: `compose dataset make . --seed N`.",
        ]
    )


def _claims() -> str:
    rows = [
        ["every file is as it was written, every count holds", "`compose dataset check .`"],
        ["homes marked `clean` break no rule", "`compose dataset check . --all` validates every scene"],
        ["every home is made again from its row, byte by byte", "`compose dataset check . --all`"],
        ["a seed's split never changes", "`check` compares it with the hash"],
        ["a room that is `proven` has no cheaper placement", "column `cost`; Compose's tests hold it against exact solvers"],
        ["a front that `opens` 1 opens wholly", "table `fronts`; Compose's tests open each in MuJoCo"],
    ]
    return "\n\n".join(["## What is claimed, and what shows it", table(["claim", "check"], rows)])


def _limits(manifest: Mapping[str, Any]) -> str:
    return f"""## Limits

* Furniture is built of boxes and cylinders of its catalog's sizes; there are no scanned shapes or textures.
* Rooms have right angles, and stand on one storey.
* Homes follow Compose's rules of furnishing, which are ours: they are no sample of homes that people live in.
* {manifest["rows"].get("houses", 0) - manifest["status"].get("clean", 0):,} homes are not clean: filter by `status`."""


WIDTH, LINE, NAME, ROOM = 640, 18, 170, 60
"""Pixels: of the picture, of a line, of a name, of a number."""
BINS: Final = 16
COLOUR, INK = "#4f7cac", "#808080"


def bars(title: str, counts: Mapping[str, int]) -> str:
    """Returns a bar for each count, in the mapping's order."""
    most = max(counts.values(), default=0) or 1
    height = LINE * (len(counts) + 2)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height}" viewBox="0 0 {WIDTH} {height}" '
        f'font-family="sans-serif" font-size="12" fill="{INK}">',
        f'<text x="0" y="14" font-size="14">{escape(title)}</text>',
    ]
    for row, (name, count) in enumerate(counts.items()):
        y, long = LINE * (row + 1) + 6, round((WIDTH - NAME - ROOM) * count / most, 1)
        lines.append(f'<text x="{NAME - 8}" y="{y + 12}" text-anchor="end">{escape(name)}</text>')
        lines.append(f'<rect x="{NAME}" y="{y + 2}" width="{long}" height="{LINE - 4}" fill="{COLOUR}"/>')
        lines.append(f'<text x="{NAME + long + 4:g}" y="{y + 12}">{count:,}</text>')
    return "\n".join([*lines, "</svg>", ""])


def spread_bars(title: str, values: Sequence[float]) -> str:
    """Returns how many values lie in each of some steps of equal width."""
    if not values:
        return bars(title, {})
    low, high = min(values), max(values)
    step = next(size for power in range(-3, 9) for k in (1, 2, 5) if (high - low) / (size := k * 10.0**power) < BINS)
    first, last = int(low // step), int(high // step)
    counts = {f"{k * step:g} - {(k + 1) * step:g}": 0 for k in range(first, last + 1)}
    names = list(counts)
    for value in values:
        counts[names[int(value // step) - first]] += 1
    return bars(title, counts)
