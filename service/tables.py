"""What statistics say, as tables that read well in a terminal and are Markdown at once."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Final

from solver.plain import Document

Spread = Mapping[str, float]
REASONS: Final = 8
"""Reasons for leaving pieces out that are shown, the most frequent."""


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """Returns a table with its columns in line: the first to the left, the others to the right."""
    widths = [max(len(row[k]) for row in [head, *rows]) for k in range(len(head))]
    rule = "|".join([":" + "-" * (widths[0] + 1), *("-" * (width + 1) + ":" for width in widths[1:])])
    lines = [_line(head, widths), f"|{rule}|", *(_line(row, widths) for row in rows)]
    return "\n".join(lines)


def _line(cells: Sequence[str], widths: Sequence[int]) -> str:
    rest = (cell.rjust(width) for cell, width in zip(cells[1:], widths[1:], strict=True))
    return "| " + " | ".join([cells[0].ljust(widths[0]), *rest]) + " |"


def report(document: Document) -> str:
    """Returns statistics as text: the homes of all sets side by side, the rooms of each, what is wrong, what was left out."""
    sets: list[Document] = document["sets"]
    asked = ", ".join(f"{name} {_said(value)}" for name, value in sets[0]["request"].items() if name != "program")
    first, count = sets[0]["first_seed"], sets[0]["count"]
    parts = [
        f"# Statistics: {count:,} houses a set, seeds from {first}" + (f", {asked}" if asked else ""),
        "Spreads are median (p10-p90). Cover: floor between wall lines under furniture, no spot counted twice. Walkable: clear floor that\n"
        "the middle of who walks can come to. Different rooms: in their pieces and the walls these stand at.",
        "## Homes",
        table(["", *(one["name"] for one in sets)], [[name, *(say(one) for one in sets)] for name, say in HOME.items()]),
        "## Issues",
        table(["rule", *(one["name"] for one in sets)], _rules(sets)),
    ]
    for one in sets:
        parts += [f"## Rooms: {one['name']}", table(["type", *ROOM], _rooms(one["rooms"]))]
    parts += ["## Pieces left out, a home", table(["why", *(one["name"] for one in sets)], _reasons(sets))]
    parts += _examples(sets)
    return "\n\n".join(parts) + "\n"


def _said(value: object) -> str:
    return {True: "on", False: "off"}[value] if isinstance(value, bool) else str(value)


def _share(value: float) -> str:
    return f"{100 * value:.1f}"


def _shares(spread: Spread) -> str:
    return f"{100 * spread['median']:.0f} ({100 * spread['p10']:.0f}-{100 * spread['p90']:.0f})"


def _areas(spread: Spread) -> str:
    return f"{spread['median']:.1f} ({spread['p10']:.1f}-{spread['p90']:.1f})"


def _numbers(spread: Spread) -> str:
    return f"{spread['median']:g} ({spread['p10']:.0f}-{spread['p90']:.0f})"


def _at(say: Callable[[Any], str], *path: str) -> Callable[[Document], str]:
    """Returns what says the value at a path in a document."""

    def said(document: Document) -> str:
        value: Any = document
        for part in path:
            value = value[part]
        return say(value)

    return said


HOME: Final[Mapping[str, Callable[[Document], str]]] = {
    "houses": _at("{:,}".format, "count"),
    "floor indoors, m2": _at(_areas, "home", "floor"),
    "rooms": _at(_numbers, "home", "rooms"),
    "doors": _at(_numbers, "home", "doors"),
    "windows": _at(_numbers, "home", "windows"),
    "hallway, % of the floor": _at(_shares, "home", "hallway"),
    "cover, %": _at(_shares, "home", "cover"),
    "walkable, %": _at(_shares, "home", "walkable"),
    "use sides reached, %": lambda one: _share(one["use_sides"]["reached"] / max(1, one["use_sides"]["wanted"])),
    "pieces": _at(_numbers, "home", "pieces"),
    "decorations": _at(_numbers, "home", "decorations"),
    "people, mean": _at("{:.2f}".format, "home", "people", "mean"),
    "people seated, %": _at(_share, "shares", "people_seated"),
    "homes with people, %": _at(_share, "shares", "with_people"),
    "homes with a pet, %": _at(_share, "shares", "with_pet"),
    "homes without an error, %": _at(_share, "shares", "clean"),
    "with all required pieces, %": _at(_share, "shares", "complete"),
    "with all rooms asked for, %": _at(_share, "shares", "as_asked"),
    "rooms proven optimal, %": _at(_share, "shares", "rooms_proven"),
    "different adjacency graphs": _at("{:,}".format, "variety", "adjacency"),
    "different graphs of doors": _at("{:,}".format, "variety", "ways"),
    "styles": lambda one: f"{len(one['styles'])}",
}
"""The rows of the table of homes: what they are called, and how a set says it."""
ROOM: Final[Mapping[str, Callable[[Document], str]]] = {
    "rooms": _at("{:,}".format, "count"),
    "m2": _at(_areas, "area"),
    "cover %": _at(_shares, "cover"),
    "walkable %": _at(_shares, "walkable"),
    "pieces": _at(_numbers, "pieces"),
    "decorations": _at(_numbers, "decorations"),
    "together": _at(_numbers, "together"),
    "left out": _at("{:.2f}".format, "left_out"),
    "missing": _at("{:,}".format, "missing"),
    "people": _at("{:.2f}".format, "people"),
    "different": _at("{:,}".format, "signatures"),
    "most alike": _at("{:,}".format, "most_alike"),
}
"""The columns of the table of rooms."""


def _rooms(rooms: Mapping[str, Document]) -> list[list[str]]:
    return [[name, *(say(figures) for say in ROOM.values())] for name, figures in rooms.items()]


def _rules(sets: Sequence[Document]) -> list[list[str]]:
    def said(found: Mapping[str, int]) -> str:
        return f"{found['issues']} in {found['houses']}" if found["issues"] else "0"

    return [[rule, *(said(one["rules"][rule]) for one in sets)] for rule in sets[0]["rules"]]


def _reasons(sets: Sequence[Document]) -> list[list[str]]:
    totals: dict[str, int] = {}
    for one in sets:
        for reason, number in one["left_out"].items():
            totals[reason] = totals.get(reason, 0) + number
    shown = sorted(totals, key=lambda reason: (-totals[reason], reason))[:REASONS]
    return [[reason, *(f"{one['left_out'].get(reason, 0) / one['count']:.2f}" for one in sets)] for reason in shown]


def _examples(sets: Sequence[Document]) -> list[str]:
    """Returns the first issues of each set with their seeds, if there are any."""
    found = [
        f"- {one['name']}, seed {issue['seed']}: {issue['severity']} {issue['rule']}: {issue['message']}"
        for one in sets
        for issue in one["issues"]
    ]
    return ["## What is wrong", "\n".join(found)] if found else []
