"""The project's documents, read: their blocks of code, tables, headings and links.

A block's first line may say more than its language, and so what a test does with it: `sh run` is run, `json scene` is read as a scene,
`json POST /fix` is sent to that call, `json answer` is held against the answer to the block before it.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
NAMES = ("README.md", "ARCHITECTURE.md", "BENCHMARKS.md", "CHANGELOG.md", "CONTRIBUTING.md", "catalogs/README.md", "web/README.md")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
FENCE = re.compile(r"^```(\w*) ?(.*?)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


@dataclass(frozen=True)
class Block:
    """A block of code: where it stands, its language, what else its first line says, and its text."""

    place: str
    language: str
    says: str
    text: str


@cache
def documents() -> dict[str, str]:
    """All documents by their path in the project."""
    paths = [*(ROOT / name for name in NAMES), *sorted((ROOT / "docs").rglob("*.md"))]
    return {str(path.relative_to(ROOT)): path.read_text() for path in paths}


def text_of(name: str) -> str:
    """A document of docs/ or of the project's top folder."""
    found = documents()
    return found.get(name) or found[f"docs/{name}"]


def section(name: str, heading: str) -> str:
    """What stands below a heading, up to the next heading of that rank or a higher one."""
    text = text_of(name)
    start = re.search(rf"^(#+) {re.escape(heading)}$", text, re.MULTILINE)
    assert start, f"{name} has no heading {heading!r}"
    end = re.search(rf"^#{{1,{len(start[1])}}} ", text[start.end() :], re.MULTILINE)
    return text[start.end() : start.end() + end.start()] if end else text[start.end() :]


def rows(text: str) -> list[list[str]]:
    """The cells of all rows of the tables in a text, heads and rules left out."""
    found: list[list[str]] = []
    lines = text.splitlines()
    for number, line in enumerate(lines):
        is_head = number + 1 < len(lines) and re.match(r"^\|[\s:|-]+\|$", lines[number + 1])
        if line.startswith("|") and not is_head and not re.match(r"^\|[\s:|-]+\|$", line):
            found.append([cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip("|"))])
    return found


def words(cell: str) -> list[str]:
    """The words in code quotes of a cell."""
    return re.findall(r"`([^`]+)`", cell)


def blocks(language: str, says: str = "") -> list[Block]:
    """All blocks of a language whose first line goes on with some words."""
    return [block for name in documents() for block in _blocks(name) if block.language == language and block.says.startswith(says)]


@cache
def _blocks(name: str) -> tuple[Block, ...]:
    text = documents()[name]
    return tuple(Block(f"{name}:{text[: match.start()].count(chr(10)) + 1}", *match.groups()) for match in FENCE.finditer(text))


def following(block: Block) -> Block | None:
    """The block after another one in its document."""
    same = _blocks(block.place.split(":")[0])
    after = same.index(block) + 1
    return same[after] if after < len(same) else None


def links(name: str) -> Iterator[str]:
    """The targets of a document's links."""
    yield from LINK.findall(FENCE.sub("", documents()[name]))


def anchors(name: str) -> set[str]:
    """The anchors that a document's headings make."""
    headings = re.findall(r"^#+ (.+)$", FENCE.sub("", documents()[name]), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.replace("`", "").lower()).replace(" ", "-") for heading in headings}
