"""dressed(): one room, top to bottom.

Comes in: a furnished Room, its Space, the Terms, a Stream. Goes out: its Decorations. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from solver.dress.floors import stand
from solver.dress.scenery import Carrier, Scenery, Terms
from solver.dress.surfaces import lay
from solver.dress.walking import Walking
from solver.dress.walls import hang, hang_free
from solver.geometry import wall_faced
from solver.scene import Decoration, Room
from solver.streams import Stream
from solver.wanted import Space
from solver.ways import HEADROOM, Goal, Ways

__all__ = ["Terms", "dressed"]


def dressed(room: Room, space: Space, terms: Terms, stream: Stream) -> tuple[Decoration, ...]:
    """Returns what dresses a furnished room; its furniture stays as it is.

    Args:
        room: furnished at right angles.
        space: its clear rectangle, and what its doors and windows keep free.
        terms: with what, in which style, how high the room is.
        stream: of random numbers, the room's own.
    """
    scenery = Scenery(room, space, terms, stream)
    for group in _groups(scenery):
        lay(scenery, group)
    for piece in scenery.pieces:
        hang(scenery, piece)
    hang_free(scenery)
    _dress_things(scenery)
    stand(scenery, _walking(scenery))
    return tuple(scenery.things)


def _groups(scenery: Scenery) -> list[list[Carrier]]:
    """Returns the pieces one by one, or together where their dressing says so."""
    groups: dict[str, list[Carrier]] = {}
    for piece in scenery.pieces:
        entry = scenery.terms.catalogs.dressing.get(piece.name)
        groups.setdefault(piece.name if entry and entry.together else piece.id, []).append(piece)
    return list(groups.values())


def _dress_things(scenery: Scenery) -> None:
    """Lays things on the things that have a dressing of their own: a mounted shelf is a parent like any other."""
    done = 0
    while done < len(scenery.made):
        thing = scenery.made[done]
        done += 1
        if thing.surfaces:
            lay(scenery, [thing])


def _walking(scenery: Scenery) -> Walking:
    """Returns the room's walk as its furniture leaves it."""
    used: list[Goal] = []
    kinds = scenery.terms.uses
    for piece in scenery.pieces:
        use = kinds.get(piece.name)
        if use:
            sides = tuple(wall_faced(side, piece.rotation) for side in use.sides)
            used.append(Goal(piece.rect, sides, use.need == "all"))
    return Walking(Ways(scenery.space, [piece.rect for piece in scenery.pieces if piece.low < HEADROOM * 1000], used))
