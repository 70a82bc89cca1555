"""A piece that matters, which the search left out though there is a place: the room is made again as if it were required.

Not here: whose rooms: a plan's, those that ask what stands elsewhere, and those that lack what is dear (generate).
"""

from collections.abc import Callable, Collection, Mapping
from dataclasses import replace
from functools import lru_cache
from math import inf
from typing import Any, Final

from catalogs import Catalogs
from solver.pieces import Arrangement

MATTERS: Final = 10.0
"""What leaving a piece out costs, from which on it is insisted on."""
DEAR: Final = 20.0
"""What leaving a piece out costs, from which on doors are shifted for it, too."""


@lru_cache(maxsize=1024)
def dear_in(catalogs: Catalogs, name: str) -> frozenset[str]:
    """Returns the labels of what is dear to leave out in rooms of a type."""
    kind = catalogs.rooms.get(name)
    return frozenset(f"{one.piece}_1" for one in kind.pieces if one.skip_cost >= DEAR) if kind else frozenset()


def insisting(arrangement: Arrangement, made_with: Callable[[str], Arrangement], mattering: Collection[str] = ()) -> Arrangement:
    """Insists on the most important piece that matters and was left out; by default what is dear to leave out matters.

    `made_with` makes the room with the piece of a label as if it were required. Returns the arrangement with it where that is cheaper, all
    that is left out counted; else the arrangement as it was.
    """
    optional = ((label, cost) for label, cost in arrangement.skipped.items() if cost < inf)
    label = next((label for label, cost in optional if (label in mattering if mattering else cost >= MATTERS)), None)
    if label is None:
        return arrangement
    made = made_with(label)
    is_cheaper = _cost(made, mattering) < _cost(arrangement, mattering)
    return replace(made, insisted=label) if is_cheaper else arrangement


def insisted_in(certificate: Mapping[str, Any] | None, room: str) -> str | None:
    """Returns the label of the piece that a certificate says was insisted on in a room."""
    rooms = (certificate or {}).get("rooms")
    entry = rooms.get(room) if isinstance(rooms, Mapping) else None
    label = entry.get("insisted") if isinstance(entry, Mapping) else None
    return label if isinstance(label, str) else None


def _cost(arrangement: Arrangement, mattering: Collection[str]) -> tuple[int, float]:
    """Returns how many pieces a room lacks that are required or matter so, and what its placement and all that it lacks cost."""
    wished = [cost for label, cost in arrangement.skipped.items() if cost < inf and label not in mattering]
    return len(arrangement.skipped) - len(wished), arrangement.cost + sum(wished)
