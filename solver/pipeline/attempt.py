"""One attempt at a sent room: its wanted pieces, and where they go.

Comes in: a room, its space, on what terms. Goes out: Wanted pieces, an Arrangement. Not here: what becomes of a room whose
pieces cannot all stand (mend), why (conflicts).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from solver.furnish.zones import bounds_of, outline_edges
from solver.geometry import to_mm
from solver.placement import Budget, arrange_as_wished, settle
from solver.repair import Walls, Wishes, near_previous, wanted_as_sent
from solver.scene import Pose, Room
from solver.wanted import Arrangement, Space, Wanted

CLEARLY_BETTER = 0.01
"""Share of the cost by which another answer must beat the one that stays near the last."""
CLEARLY_CHEAPER = 0.01
"""What it must be cheaper besides: as much as moving one piece by 10 cm."""


@dataclass(frozen=True)
class Terms:
    """On what terms every room of a scene is repaired.

    Args:
        wishes: what is locked and what was moved.
        wall_thickness: m.
        on_conflict: "report" or "remove".
        work: what each attempt and the explanation may cost a room, in QPs of a small room.
        previous: poses of the last answer, by id.
    """

    wishes: Wishes
    wall_thickness: float
    on_conflict: str
    work: float
    previous: Mapping[str, Pose] = field(default_factory=dict)


def wanted_of(room: Room, space: Space, terms: Terms) -> tuple[Wanted, ...]:
    """Returns a sent room's pieces with all the ways they may stand."""
    lines = bounds_of(room)
    bounds = {"north": lines.z0, "south": lines.z1, "west": lines.x0, "east": lines.x1}
    inner = tuple(edge for edge in outline_edges(room) if edge[1] != bounds[edge[0]] and edge[2] < edge[3])
    return wanted_as_sent(room, Walls(space.clear, (to_mm(terms.wall_thickness) + 1) // 2, inner), terms.wishes)


def placed(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Arrangement:
    """Places pieces with least movement."""
    return settle([arrange_as_wished(space, wanted, budget)], "search")[0]


def attempt(space: Space, wanted: Sequence[Wanted], terms: Terms) -> Arrangement:
    """Places pieces with least movement; near the last answer unless elsewhere is clearly better."""
    best = placed(space, wanted, Budget(terms.work))
    near = near_previous(wanted, space.clear, terms.previous, terms.wishes)
    if near is None:
        return best
    kept = placed(space, near, Budget(terms.work))
    same = [label for label, _ in kept.left_out] == [label for label, _ in best.left_out]
    as_walkable = len(kept.notes) <= len(best.notes)
    return kept if same and as_walkable and kept.cost <= best.cost * (1 + CLEARLY_BETTER) + CLEARLY_CHEAPER else best
