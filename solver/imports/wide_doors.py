"""Doors between a room and a balcony or garden that are wider than any leaf: one leaf of them opens, the rest is glass."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from solver.imports.drawn import PlanNotes
from solver.imports.joining import HEIGHTS, Joined
from solver.imports.to_scene import NamedRoom

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
