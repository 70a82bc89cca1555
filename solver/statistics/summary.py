"""Many houses -> one plain document of medians, shares and counts."""

from collections import Counter
from collections.abc import Iterable, Sequence
from statistics import fmean, quantiles
from typing import Final

from solver.plain import Document
from solver.statistics.house import House, RoomFigures

SHOWN: Final = 20
"""Issues that are listed with their seeds; the rest is counted."""


def summary(houses: Sequence[House], rules: Iterable[str]) -> Document:
    """Returns what houses, one at least, show together; `rules` are all there are, so that those nothing breaks are named too.

    `count`; `home`: a spread (p10, median, p90, mean) for every figure of a house; `shares` of the houses; `variety`: how many different
    graphs; `use_sides` wanted and reached; `styles`; `rules`: for each its issues, and the houses they are in; `issues`: the first of them
    with their seeds; `rooms`: the same by room type; `left_out`: pieces left out by the reason why.
    """
    return {
        "count": len(houses),
        "home": _spreads(houses),
        "shares": _shares(houses),
        "variety": {"adjacency": len({house.adjacency for house in houses}), "ways": len({house.ways for house in houses})},
        "use_sides": {"wanted": sum(house.use_sides[0] for house in houses), "reached": sum(house.use_sides[1] for house in houses)},
        "styles": _counted(house.style for house in houses if house.style),
        "rules": {rule: _broken(houses, rule) for rule in rules},
        "issues": _listed(houses),
        "rooms": _by_type(houses),
        "left_out": _counted(reason for house in houses for room in house.rooms for reason in room.left_out),
    }


def spread(values: Iterable[float]) -> dict[str, float]:
    """Returns the quantiles p10, median and p90 (linear between neighbours) and the mean of one value at least, to 4 decimals."""
    known = list(values)
    tenths = quantiles(known, n=10, method="inclusive") if len(known) > 1 else known * 9
    shown = {"p10": tenths[0], "median": tenths[4], "p90": tenths[8], "mean": fmean(known)}
    return {name: round(value, 4) for name, value in shown.items()}


def _counted(words: Iterable[str]) -> dict[str, int]:
    """Counts words, the most frequent first."""
    return dict(sorted(Counter(words).items(), key=lambda entry: (-entry[1], entry[0])))


def _spreads(shown: Sequence[House] | Sequence[RoomFigures]) -> dict[str, dict[str, float]]:
    return {name: spread(one.spread[name] for one in shown) for name in shown[0].spread}


def _shares(houses: Sequence[House]) -> dict[str, float]:
    people = sum(house.spread["people"] for house in houses)
    of_houses = {
        "clean": [all(issue.severity != "error" for issue in house.issues) for house in houses],
        "complete": [not any(room.missing for room in house.rooms) for house in houses],
        "as_asked": [not house.notes for house in houses],
        "with_people": [house.spread["people"] > 0 for house in houses],
        "with_pet": [house.spread["pets"] > 0 for house in houses],
    }
    return {
        **{name: _share(sum(true), len(houses)) for name, true in of_houses.items()},
        "people_seated": _share(sum(house.seated for house in houses), people),
        "rooms_proven": _share(sum(house.proven for house in houses), sum(len(house.rooms) for house in houses)),
    }


def _share(part: float, whole: float) -> float:
    return round(part / whole, 4) if whole else 0.0


def _broken(houses: Sequence[House], rule: str) -> Document:
    found = [sum(issue.rule == rule for issue in house.issues) for house in houses]
    return {"issues": sum(found), "houses": sum(number > 0 for number in found)}


def _listed(houses: Sequence[House]) -> list[Document]:
    """Lists the first issues, errors before warnings."""
    every = [(house.seed, issue) for house in houses for issue in house.issues]
    every.sort(key=lambda entry: entry[1].severity != "error")
    return [
        {"seed": seed, "rule": issue.rule, "severity": issue.severity, "room": issue.room, "message": issue.message}
        for seed, issue in every[:SHOWN]
    ]


def _by_type(houses: Sequence[House]) -> Document:
    found: dict[str, list[RoomFigures]] = {}
    for house in houses:
        for room in house.rooms:
            found.setdefault(room.type, []).append(room)
    return {name: _rooms(found[name], len(houses)) for name in sorted(found)}


def _rooms(rooms: Sequence[RoomFigures], houses: int) -> Document:
    alike = Counter(room.signature for room in rooms)
    return {
        "count": len(rooms),
        "per_home": round(len(rooms) / houses, 4),
        **_spreads(rooms),
        "left_out": round(sum(len(room.left_out) for room in rooms) / len(rooms), 4),
        "missing": sum(room.missing for room in rooms),
        "people": round(sum(room.people for room in rooms) / len(rooms), 4),
        "signatures": len(alike),
        "most_alike": max(alike.values()),
    }
