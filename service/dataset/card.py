"""The card of a dataset: README.md with the front matter that hubs of datasets read, figures, plots, and how to make it again."""

import json
import shlex
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
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
TEMPLATE: Final = Path(__file__).parent / "card.md"
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
    text = TEMPLATE.read_text(encoding="utf-8").format_map(_said(manifest, homes, plots))
    write_whole(folder / CARD, text.encode())


def _columns(folder: Path, name: str, columns: Sequence[str]) -> dict[str, list[Any]]:
    """Reads some columns of a table, in the order of the files' names."""
    found: dict[str, list[Any]] = {column: [] for column in columns}
    for path in sorted((folder / TABLES / name).glob("*.parquet")):
        for column, values in pq.read_table(path, columns=list(columns)).to_pydict().items():
            found[column] += values
    return found


def _known(values: Sequence[Any]) -> list[Any]:
    return [value for value in values if value is not None]


def _said(manifest: Mapping[str, Any], homes: Mapping[str, list[Any]], plots: Iterable[str]) -> dict[str, object]:
    """Returns what stands at each place of the card."""
    rooms, proven = sum(_known(homes["rooms"])), sum(_known(homes["proven"]))
    share = f"{100 * proven / max(rooms, 1):.2f} % of the {rooms:,} rooms are proven: no placement of their pieces is cheaper.\n\n"
    figures = [[words, *_spread(_known(homes[name]))] for name, words in FIGURES.items()]
    archives = f", and `{ARCHIVES}/` of {', '.join(manifest['formats'])} as webdataset reads them"
    return {
        "size": next((words for most, words in _SIZES if manifest["homes"] < most), "n>10M"),
        "configs": "\n".join(_configs([split for split in SPLITS if manifest["splits"].get(split)])),
        "homes": manifest["homes"],
        "seeds": ", ".join(f"{first}-{last}" for first, last in manifest["seeds"]),
        "version": manifest["version"],
        "status": ", ".join(f"{count:,} {name}" for name, count in manifest["status"].items()),
        "catalogs": ", ".join(f"{name} ({mark})" for name, mark in manifest["catalogs"].items()),
        "archives": archives if manifest["formats"] != ["json"] else "",
        "splits": ", ".join(f"{manifest['splits'].get(name, 0):,} {name}" for name in SPLITS),
        "figures": table(["of a home", "10 %", "median", "90 %", "mean"], figures),
        "proven": share if rooms else "",
        "rows": table(["table", "rows"], [[name, f"{count:,}"] for name, count in manifest["rows"].items()]),
        "plots": "\n".join(f"![{name}]({PLOTS}/{name}.svg)" for name in plots),
        "digest": manifest["digest"],
        "commands": "\n".join(_commands(manifest)),
        "wrong": manifest["rows"].get("houses", 0) - manifest["status"].get("clean", 0),
    }


def _configs(splits: Sequence[str]) -> Iterator[str]:
    """Yields where hubs find each table."""
    for name in SCHEMAS:
        yield from (f"- config_name: {name}", *(["  default: true"] if name == "houses" else []), "  data_files:")
        for split in splits:
            yield from (f"  - split: {split}", f"    path: {TABLES}/{name}/{split}-*.parquet")


def _spread(values: Sequence[float]) -> list[str]:
    found = spread(values) if values else {}
    return [f"{found[key]:g}" if found else "-" for key in ("p10", "median", "p90", "mean")]


def _commands(manifest: Mapping[str, Any]) -> Iterator[str]:
    """Yields the commands that make the set again, one for each range of its seeds."""
    words = ["compose", "dataset", "--request", f"{MADE_FROM}/request.json"]
    words += ["--vary", f"{MADE_FROM}/vary.json"] if manifest["vary"] is not None else []
    words += ["--formats", ",".join(manifest["formats"]), "--shard-size", str(manifest["shard_size"])]
    yield from (shlex.join([*words, "--seeds", f"{first}-{last}", "--out", "homes"]) for first, last in manifest["seeds"])


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
