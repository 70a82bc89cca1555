"""One attempt at a sent room: its wanted pieces, and where they go.

Comes in: a room, its space, on what terms. Goes out: Wanted pieces, an Arrangement. Not here: what becomes of a room whose
pieces cannot all stand (mend), why (conflicts).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from solver.furnish.zones import bounds_of, outline_edges
from solver.geometry import to_mm
from solver.placement import Budget, arrange_as_wished, brought_from, settle
from solver.repair import Last, Walls, Wishes, wanted_as_sent
from solver.scene import Pose, Room
from solver.wanted import Arrangement, Space, Wanted

JUMP_COST = 0.2
"""What it costs that a neighbour of the dragged piece goes elsewhere than near its last pose: as much as moving it by 45 cm."""
JUMP_SHARE = 0.1
"""What it costs besides, as a share of the cost: where much is in the way, little is gained by it."""
MOST_FREED = 3
"""How many neighbours are tried elsewhere, each alone."""
LIVE_WORK = 60_000.0
"""Work each attempt near the last answer may cost, in QPs of a small room: about 60 ms."""


@dataclass(frozen=True)
class Terms:
    """On what terms every room of a scene is repaired.

    Args:
        wishes: what is locked and what was moved.
        wall_thickness: m.
        on_conflict: "report" or "remove".
        work: what each attempt may cost a room, in QPs of a small room.
        previous: poses of the last answer, by id.
        telling: what saying why not may cost a room, in QPs of a small room; it changes nothing, so broken rooms alone share it.
    """

    wishes: Wishes
    wall_thickness: float
    on_conflict: str
    work: float
    previous: Mapping[str, Pose] = field(default_factory=dict)
    telling: float = 0.0


def wanted_of(room: Room, space: Space, terms: Terms) -> tuple[Wanted, ...]:
    """Returns a sent room's pieces with all the ways they may stand."""
    return wanted_as_sent(room, walls_of(room, space, terms), terms.wishes)


def walls_of(room: Room, space: Space, terms: Terms) -> Walls:
    """Returns a room's walls."""
    lines = bounds_of(room)
    bounds = {"north": lines.z0, "south": lines.z1, "west": lines.x0, "east": lines.x1}
    inner = tuple(edge for edge in outline_edges(room) if edge[1] != bounds[edge[0]] and edge[2] < edge[3])
    return Walls(space.clear, (to_mm(terms.wall_thickness) + 1) // 2, inner)


def placed(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Arrangement:
    """Places pieces with least movement."""
    return settle([arrange_as_wished(space, wanted, budget)], "search")[0]


def attempt(space: Space, wanted: Sequence[Wanted], terms: Terms) -> Arrangement:
    """Places pieces with least movement; near the last answer unless elsewhere is clearly better."""
    last = Last(wanted, space.clear, terms.previous, terms.wishes)
    if not last.known:
        return placed(space, wanted, Budget(terms.work))
    work = min(terms.work, LIVE_WORK)
    best = placed(space, wanted, Budget(work))
    if _is_sound(best) and not last.jumped(best):
        return best
    answers = [*_steady(space, last, last.jumped(best), work), best]
    return min(answers, key=lambda one: (len(one.left_out), len(one.notes), _cost(one, last)))


def _steady(space: Space, last: Last, jumpers: Sequence[str], work: float) -> list[Arrangement]:
    """Returns answers near the last one: with nobody elsewhere, from where all stood, with one neighbour elsewhere."""
    free: list[tuple[str, ...]] = [(), *((label,) for label in jumpers[:MOST_FREED] if len(jumpers) > 1)]
    bound = [pieces for pieces in map(last.near, free) if pieces is not None]
    answers = [placed(space, pieces, Budget(work)) for pieces in bound]
    stood = last.places()
    draft = brought_from(space, [piece for piece, _ in stood], [place for _, place in stood]) if stood else None
    return [*answers, *([settle([draft], "search")[0]] if draft else [])]


def _is_sound(answer: Arrangement) -> bool:
    return not answer.left_out and not answer.notes


def _cost(answer: Arrangement, last: Last) -> float:
    """Returns what an answer costs, its jumps counted."""
    jumps = len(last.jumped(answer))
    return answer.cost * (1 + JUMP_SHARE * jumps) + JUMP_COST * jumps
