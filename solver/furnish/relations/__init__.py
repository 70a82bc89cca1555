"""The vocabulary: one function a relation, rule -> what it does to a piece's alternatives.

Comes in: an `Ask` (a piece in a room) and a `Rule`. Goes out: an `Effect`. May import: catalogs, the ground floor.
Not here: choosing among alternatives (placement). catalogs/README.md tells what each word means.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from catalogs.schema import Rule
from solver.furnish.ask import Ask, Effect
from solver.furnish.relations import pairs, places, slots

RELATIONS: Final[dict[str, Callable[[Ask, Rule], Effect]]] = {
    "against_wall": places.against_wall,
    "in_corner": places.in_corner,
    "beside": slots.beside,
    "in_front_of": slots.in_front_of,
    "opposite": pairs.opposite,
    "facing": pairs.facing,
    "near": pairs.near,
    "far_from": pairs.far_from,
    "around": slots.around,
    "aligned_with": pairs.aligned_with,
    "centred": places.centred,
    "in_row": slots.in_row,
    "at_window": places.at_window,
    "near_door": places.near_door,
    "far_from_door": places.far_from_door,
    "on": slots.on,
    "under": slots.under,
}
SLOTTED: Final = ("beside", "in_front_of", "around", "on", "under", "in_row")
"""Relations that give a piece a place at another one; a piece in one of its slots has what it needs from that rule."""

__all__ = ["RELATIONS", "SLOTTED"]
