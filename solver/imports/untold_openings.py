"""Openings of which a file says no more than that: in its one layer of them windows, doors and passages are told apart.

One whose sill lies high, or in an outer wall without a leaf, is a window; one to a balcony or garden a door. Where no door leads outside,
the likeliest of a door's width does.

And doors between a room and a balcony or garden that are wider than any leaf: one leaf of them opens, the rest is glass.

Comes in: `Joined`s, the rooms. Goes out: `Joined`s. May import: drawn, joining.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from catalogs import Catalogs
from solver.imports.drawn import OpeningKind, PlanNotes
from solver.imports.joining import HEIGHTS, Joined
from solver.imports.to_scene import NamedRoom

LOW: Final = 0.3
"""One steps over no sill that is higher, m."""
NARROW: Final = 600
"""Through what is narrower, mm, nobody goes outdoors."""
DOOR: Final = (750, 1150)
"""A door to come in by is as wide, mm."""
GARAGE: Final = (1900, 2400)
"""A garage door is as wide, mm; so is one of which the file says that it has a leaf."""
NO_ENTRANCE: Final = 100
"""The place, in the order of entrances, of a room that is none."""
UNTOLD: Final = "the file says no more than that it is an opening"


def told_apart(openings: Sequence[Joined], rooms: Sequence[NamedRoom], catalogs: Catalogs, notes: PlanNotes) -> list[Joined]:
    """Returns openings, each untold one as what it most likely is; notes what was guessed, of those alike with the place of the first.

    Where the file tells of some that they are windows, it tells so of all.
    """
    are_told = any(one.drawn.kind == "window" for one in openings)
    found: list[tuple[OpeningKind, str]] = [
        _kind(one, rooms) if one.drawn.unsaid and not are_told else _by_width(one, rooms) for one in openings
    ]
    if not any(kind == "door" and _is_outer(one, rooms) for one, (kind, _) in zip(openings, found, strict=True)):
        may_be = [one.drawn.unsaid and _is_outer(one, rooms) and DOOR[0] <= one.high - one.low <= DOOR[1] for one in openings]
        outer = [at for at, (kind, _) in enumerate(found) if may_be[at] and kind in ("window", "passage")]
        for at in sorted(outer, key=lambda at: (_rank(openings[at], rooms, catalogs), openings[at].high - openings[at].low))[:1]:
            found[at] = "door", "no other leads outside"
    told: dict[tuple[OpeningKind, str], list[str]] = {}
    for one, (kind, why) in zip(openings, found, strict=True):
        if why:
            told.setdefault((kind, f"{UNTOLD}; {why}" if one.drawn.unsaid else why), []).append(one.drawn.where)
    for (kind, words), places in told.items():
        notes.guess(places[0], "kind", kind, words if len(places) == 1 else f"{words}: {len(places)} in all")
    return [replace(one, drawn=replace(one.drawn, kind=kind)) for one, (kind, _) in zip(openings, found, strict=True)]


def _kind(one: Joined, rooms: Sequence[NamedRoom]) -> tuple[OpeningKind, str]:
    """Returns what an untold opening is, and what tells so."""
    outdoors = {bool(rooms[edge.room].drawn.outdoor) for edge in one.edges}
    if one.drawn.sill is not None:
        return ("window", "its sill lies high") if one.drawn.sill >= LOW else ("passage", "")
    if _is_outer(one, rooms):
        return "window", "it lies in an outer wall, and no leaf is drawn"
    if outdoors == {True, False}:
        return ("door", "it leads outdoors") if one.high - one.low >= NARROW else ("window", "it is too narrow for a door")
    return (one.drawn.kind, "") if one.drawn.kind == "door" else ("passage", "it lies in an inner wall, and no leaf is drawn")


def _by_width(one: Joined, rooms: Sequence[NamedRoom]) -> tuple[OpeningKind, str]:
    """Returns what an opening is drawn as; a wide door without a leaf, from outside into a garage, is a garage door."""
    is_wide = one.drawn.kind == "door" and one.high - one.low >= GARAGE[one.hinge is not None]
    if is_wide and _is_outer(one, rooms) and rooms[one.edges[0].room].type.startswith("garage"):
        return "garage_door", "so wide a door leads into a garage"
    return one.drawn.kind, ""


def _is_outer(one: Joined, rooms: Sequence[NamedRoom]) -> bool:
    return len(one.edges) == 1 and not rooms[one.edges[0].room].drawn.outdoor


def _rank(one: Joined, rooms: Sequence[NamedRoom], catalogs: Catalogs) -> int:
    kind = catalogs.rooms.get(rooms[one.edges[0].room].type)
    place = kind.plan.entrance if kind else None
    return NO_ENTRANCE if place is None else place


WIDEST: Final = 1500
"""A door up to this width, mm, has a leaf or two."""
LEAF: Final = 950


def with_glass(openings: Sequence[Joined], rooms: Sequence[NamedRoom], notes: PlanNotes) -> list[Joined]:
    """Returns openings of which each such door is a leaf wide, with a window down to the floor beside it; notes it."""
    return [part for one in openings for part in _parts(one, rooms, notes)]


def _parts(one: Joined, rooms: Sequence[NamedRoom], notes: PlanNotes) -> Iterator[Joined]:
    outdoors = {bool(rooms[edge.room].drawn.outdoor) for edge in one.edges}
    is_said = one.hinge is not None or one.towards is not None
    if one.drawn.kind != "door" or one.high - one.low <= WIDEST or is_said or outdoors != {True, False}:
        yield one
        return
    words = f"a door {one.high - one.low} mm wide is wider than a leaf: {LEAF} mm of it open, the rest is a window down to the floor"
    notes.change("join", one.drawn.where, (one.high - one.low - LEAF) / 1000, words)
    yield replace(one, low=one.high - LEAF)
    glass = replace(one.drawn, kind="window", id="", sill=0.0, height=one.drawn.height or HEIGHTS["door"])
    yield replace(one, drawn=glass, high=one.high - LEAF)
