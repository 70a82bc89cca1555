"""Random furnished rooms, whether or not anybody could furnish them so, and what decorates them at random."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from random import Random
from typing import Any

from catalogs import load_catalogs
from catalogs.decoration_types import INDOOR, Decorating
from catalogs.schema import Catalogs
from solver.decorations import DecorationSettings
from solver.scene import Furniture, Room
from tests.furnish.random_types import random_room

MOST_PIECES = 9


def furnished(rng: Random, catalogs: Catalogs) -> Room:
    """Returns a room of a type of the catalogs, or of none, with pieces anywhere: some overlap, hang or are tucked under others."""
    bare = random_room(rng, rng.choice([*catalogs.rooms, "room"]))
    bare = replace(bare, width=bare.width + 0.8, depth=bare.depth + 0.8, outdoor=rng.random() < 0.2)
    pieces: list[Furniture] = []
    for number in range(rng.randint(0, MOST_PIECES)):
        kind = rng.choice(sorted(catalogs.furniture))
        entry = catalogs.furniture[kind]
        under = rng.choice(pieces).id if pieces and rng.random() < 0.3 else None
        x, z = round(rng.uniform(0, bare.width), 3), round(rng.uniform(0, bare.depth), 3)
        if rng.random() < 0.4:
            z = 0.08 + entry.size[1] / 2
        turn = rng.choice((0, 90, 180, 270, 0, 37.5))
        width, depth, height = (round(extent * rng.choice((1, 1, 1, 0.97)), 3) for extent in entry.size)
        y, name = rng.choice((0.0, 0.0, 0.0, 0.72, 2.1)), entry.name or kind
        pieces.append(
            Furniture(f"room_0/{name}_{number}", name, entry.category, x, y, z, turn, width, depth, height, entry.color, under=under)
        )
    return replace(bare, furniture=tuple(pieces), accent=rng.choice((None, "#123456")))


@cache
def settings_named(name: str) -> DecorationSettings:
    """Returns `random_settings` of our catalogs, by the name of what they are drawn with."""
    return random_settings(Random(name), load_catalogs())


def random_settings(rng: Random, catalogs: Catalogs) -> DecorationSettings:
    """Returns the catalogs in one of their styles or in none, half of the time with decorations that nobody asked for."""
    known = catalogs.model_copy(update={"decorating": random_decorating(rng, catalogs)}) if rng.random() < 0.5 else catalogs
    style = rng.choice(["", *known.styles])
    return DecorationSettings(known, known.styles.get(style), style, rng.choice((2.1, 2.8)))


def random_decorating(rng: Random, catalogs: Catalogs) -> dict[str, Decorating]:
    """Returns rows of every sort for random names."""
    furniture = {catalogs.name_of(kind) for kind in catalogs.furniture}
    names = [*furniture, *catalogs.decorations, *catalogs.rooms]
    chosen = rng.sample(sorted(names), len(names) // 2)
    rows = {"lies": _lies, "hangs": _hangs, "stands": _stands}
    entries: dict[str, dict[str, Any]] = {}
    for name in chosen:
        entries[name] = {sort: [make(rng, catalogs) for _ in range(rng.randint(0, 3))] for sort, make in rows.items()}
    for name, entry in entries.items():
        entry["holds"] = [_holds(rng, catalogs) for _ in range(rng.randint(0, 2))] if name in furniture else []
        entry.update({"together": rng.random() < 0.2, "indoor": rng.random() < 0.8})
    return {name: Decorating.model_validate(entry) for name, entry in (entries | {INDOOR: {"stands": [_stands(rng, catalogs)]}}).items()}


def _row(rng: Random, catalogs: Catalogs, more: dict[str, Any]) -> dict[str, Any]:
    put = rng.sample(sorted(catalogs.decorations), rng.choice((1, 1, 2, 3)))
    some = rng.sample(sorted(catalogs.rooms), 6)
    more |= {
        "chance": rng.random(), "min_scale": rng.choice((0.4, 0.55, 0.6, 0.8)), "styles": rng.sample(sorted(catalogs.styles), 3),
        "rooms": some[:4], "not_in": some[3:], "accent": True,
    }  # fmt: skip
    likely = {"min_scale": 0.6, "chance": 0.4, "styles": 0.1, "rooms": 0.1, "not_in": 0.1, "accent": 0.1}
    return {"put": put} | {key: value for key, value in more.items() if rng.random() < likely.get(key, 0.5)}


def _lies(rng: Random, catalogs: Catalogs) -> dict[str, Any]:
    at = [(round(rng.random(), 2), round(rng.random(), 2)) for _ in range(rng.randint(1, 4))]
    more: dict[str, Any] = {
        "at": "seats" if rng.random() < 0.2 else at,
        "surface": rng.choice((["all"], ["upper", "lower"], ["seat"])), "turn": rng.choice((0, 90, 180, 270)),
        "upright": rng.random() < 0.3,
        "fill": (rng.choice((0.0, 0.33)), rng.random()), "reach": rng.choice((0.0, 0.1, 0.5)),
    }  # fmt: skip
    if rng.random() < 0.2:
        more["on"] = [*rng.sample(sorted(catalogs.decorations), 5), "surface"]
    return _row(rng, catalogs, more)


def _holds(rng: Random, catalogs: Catalogs) -> dict[str, Any]:
    more: dict[str, Any] = {
        "at": [(round(rng.random(), 2), round(rng.random(), 2)) for _ in range(rng.randint(1, 4))], "turn": rng.choice((0, 90, 180, 270)),
        "upright": rng.random() < 0.3, "most": rng.randint(1, 8), "reach": rng.choice((0.0, 0.1, 0.5)),
    }  # fmt: skip
    return _row(rng, catalogs, more) | {"surface": rng.choice((["shelves"], ["drawers"], ["shelves", "drawers"]))}


def _hangs(rng: Random, catalogs: Catalogs) -> dict[str, Any]:
    row = _row(rng, catalogs, {"at": [round(rng.random(), 2) for _ in range(rng.randint(1, 3))], "gap": rng.random()})
    return row | {"height": rng.choice((0.9, 1.3, 1.75))}


def _stands(rng: Random, catalogs: Catalogs) -> dict[str, Any]:
    where = rng.choice(("middle", "corner", "beside", "wall", "free", "under"))
    more: dict[str, Any] = {
        "count": rng.randint(1, 4), "per_area": rng.uniform(1, 9), "min_side": rng.choice((0.0, 2.0)),
        "reach": rng.choice((0.0, 0.3, 2.0)),
    }  # fmt: skip
    row = _row(rng, catalogs, more) | {"where": where}
    if where in ("beside", "under"):
        row["of"] = rng.sample(sorted({catalogs.name_of(kind) for kind in catalogs.furniture}), 9)
    if where == "under":
        row["bare"] = rng.choice((0.0, 0.4, 1.0))
    if where == "middle" and rng.random() < 0.7:
        row |= {"fill": round(rng.uniform(0.2, 0.9), 2)} | rng.choice(({}, {"widest": 1.4}, {"longest": 2.0}))
    return row
