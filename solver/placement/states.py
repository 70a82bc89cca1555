"""A prefix of pieces that stand, the ways the next one may join it, and the work all this may cost.

Comes in: a space, wanted pieces. Goes out: `State`, its options and its extensions. Not here: in which order prefixes are
grown (prefixes), what becomes of a whole room (arrange).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from solver.geometry import OPPOSITE
from solver.placement.assemble import Assembly, Chosen, Impossible
from solver.placement.problem import Problem
from solver.placement.search import Accept, Outcome, solve
from solver.placement.terms import Floats
from solver.placement.walk import connected
from solver.wanted import Alternative, Link, Space, Wanted

QPS = 600
"""QPs of one search for a required piece."""
OPTIONAL_QPS = 150
"""QPs of one search for an optional piece, after the quick one that keeps every choice made before."""
BLOCKED_COST = 8.0
"""What a required piece pays for standing where its use side is not free."""
OTHER_SIDE_COST = 0.05
"""What using the second of several allowed sides costs: order, not preference."""
ROOM_WORK = 60_000.0
"""Work one room may cost, in QPs of a small room: twenty times what a full living room takes."""


class Budget:
    """Work that may still be done, in QPs of a small room; counted, never timed.

    Args:
        left: how much.
    """

    def __init__(self, left: float = ROOM_WORK) -> None:
        self.left = left

    @property
    def spent(self) -> bool:
        """Tells whether nothing is left."""
        return self.left <= 0

    def solve(self, problem: Problem, most: int, ceiling: float = float("inf"), accept: Accept | None = None) -> Outcome:
        """Searches a problem with at most `most` QPs and what is left, and pays for it."""
        scale = 1 + ((len(problem.low[0]) + len(problem.low[1])) / 40) ** 2  # a dense QP grows with its square
        limit = min(most, max(int(self.left / scale), 0))
        outcome = solve(problem, limit=limit, ceiling=ceiling, accept=accept)
        self.left -= outcome.solves * scale + len(problem.choices) / 4  # reading the choices costs too
        return outcome


@dataclass(frozen=True)
class State:
    """A feasible prefix: its problem, what the search found for it, and its preference costs so far."""

    assembly: Assembly
    outcome: Outcome
    preference: float

    @property
    def cost(self) -> float:
        """Terms and preferences together."""
        return self.outcome.cost + self.preference


def empty(space: Space) -> State:
    """Returns the state of an empty room."""
    assembly = Assembly(space)
    return State(assembly, solve(assembly.problem), 0.0)


def walkable_at(assembly: Assembly, p: Sequence[Sequence[int]]) -> bool:
    """Tells whether all doors and stands are joined with the bodies at integer positions p[axis][variable], mm."""
    parts = assembly.problem.parts
    solids = [part.rect(p) for part in parts if not part.stand and part.bottom == 0]
    return connected(assembly.space, solids, [part.rect(p) for part in parts if part.stand])


def walk_test(assembly: Assembly) -> Accept:
    """Returns the leaf test of a search: are all doors and stands of the room joined?"""

    def accept(positions: tuple[Floats, Floats]) -> bool:
        return walkable_at(assembly, [[round(float(value) * 1000) for value in axis] for axis in positions])

    return accept


def _sides(wanted: Wanted) -> list[tuple[tuple[str, ...], float]]:
    """Returns the choices of use sides that must be free, with what each costs."""
    if not wanted.stands:
        return [((), 0.0)]
    names = [stand.side for stand in wanted.stands]
    any_one: list[tuple[tuple[str, ...], float]] = [((name,), OTHER_SIDE_COST * k) for k, name in enumerate(names)]
    choices = [(tuple(names), 0.0)] if wanted.need_all else any_one
    return [*choices, ((), BLOCKED_COST)] if wanted.required else choices


def _holds(link: Link, own: Alternative, rotation: int, other: Chosen, other_rotation: int) -> bool:
    if link.turn is not None and (rotation - other_rotation - link.turn) % 360:
        return False
    theirs = other.alternative.wall
    if link.walls is None:
        return True
    if own.wall is None or theirs is None:
        return False
    relation = "same" if own.wall == theirs else "opposite" if OPPOSITE[own.wall] == theirs else "adjacent"
    return relation == link.walls or (link.walls == "other" and relation != "same")


def _link_cost(assembly: Assembly, wanted: Wanted, own: Alternative) -> float | None:
    """Returns what an alternative's broken links cost, or None where a required one breaks."""
    total = 0.0
    by_label = {c.wanted.label: c for c in assembly.chosen}
    rotation = own.rotation
    if own.attach is not None:
        rotation += assembly.rotations[own.attach.parent]
    for link in wanted.links:
        other = by_label.get(link.of)
        if other is None:
            continue
        if not _holds(link, own, rotation, other, assembly.rotations[link.of]):
            if link.required:
                return None
            total += link.cost
        if link.apart_cost and own.attach is None and other.alternative.attach is None:
            a, b = own.anchor_mm, other.alternative.anchor_mm
            distance = ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5 / 1000
            total += link.apart_cost * max(0.0, link.apart_m - distance)
    return total


def _fits_parent(assembly: Assembly, own: Alternative) -> bool:
    attach = own.attach
    if attach is None:
        return True
    for c in assembly.chosen:
        if c.wanted.label == attach.parent and c.alternative.kind != attach.parent_kind:
            return False
        taken = c.alternative.attach
        if attach.slot and taken is not None and (taken.parent, taken.slot) == (attach.parent, attach.slot):
            return False
    return attach.parent in assembly.bodies


def options(assembly: Assembly, wanted: Wanted) -> list[tuple[float, Chosen]]:
    """Returns the ways a piece may stand beside what is there, with their preference costs, cheapest first."""
    found: list[tuple[float, Chosen]] = []
    for alternative in wanted.alternatives:
        if not _fits_parent(assembly, alternative):
            continue
        links = _link_cost(assembly, wanted, alternative)
        if links is not None:
            for sides, cost in _sides(wanted):
                found.append((alternative.cost + links + cost, Chosen(wanted, alternative, sides)))
    return sorted(found, key=lambda entry: round(entry[0], 9))


def kin(c: Chosen) -> tuple[object, ...]:
    """What decides feasibility: alternatives that agree here differ only in their anchor."""
    a = c.alternative
    return (a.kind, a.size_mm, a.rotation, a.wall, a.within, a.attach, a.bottom_mm, a.slack_mm, c.sides)


def extend(state: State, way: tuple[float, Chosen], walk: bool, budget: Budget) -> tuple[State | None, Outcome | None]:
    """Adds a piece to a state in one of its ways (preference cost, choice).

    Returns:
        The new state or None, and the search's outcome, None where the bounds alone rule the way out.
    """
    preference, c = way
    try:
        assembly = state.assembly.with_piece(c)
    except Impossible:
        return None, None
    accept = walk_test(assembly) if walk else None
    required = c.wanted.required
    outcome = budget.solve(assembly.problem, QPS, accept=accept) if required else _quick(state, assembly, accept, budget)
    if outcome.positions is None:
        return None, outcome
    return State(assembly, outcome, state.preference + preference), outcome


def _quick(state: State, assembly: Assembly, accept: Accept | None, budget: Budget) -> Outcome:
    """Searches the new piece's choices with the others kept; where that fails, all choices anew."""
    kept = assembly.problem.copy()
    known = len(state.outcome.rows)
    kept.rows.extend(state.outcome.rows)
    kept.choices = kept.choices[known:]
    quick = budget.solve(kept, OPTIONAL_QPS, accept=accept)
    if quick.positions is not None:
        return replace(quick, rows=(*state.outcome.rows, *quick.rows), proven=False)
    full = budget.solve(assembly.problem, OPTIONAL_QPS, accept=accept)
    return replace(full, solves=full.solves + quick.solves, turned_down=full.turned_down + quick.turned_down)
