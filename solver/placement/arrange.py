"""The discrete moves above the search: which wall, rotation, size variant and use side each piece takes.

Required pieces: best-first over prefixes of alternatives in order of importance. A child's bound is its parent's exact
cost plus the alternative's own cost (every term is >= 0), so the first complete prefix popped is the best. Optional
pieces follow by importance, everything movable, if a room stays walkable. Limits are counts; ties go to the earlier.
"""

from __future__ import annotations

import heapq
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from solver.geometry import OPPOSITE
from solver.placement.assemble import Assembly, Chosen, Impossible
from solver.placement.search import Accept, Outcome, solve
from solver.placement.terms import Floats
from solver.placement.walk import connected
from solver.wanted import Alternative, Link, Space, Wanted

EVALUATIONS = 240
"""Searches spent on the required pieces of a room before the best-first order is given up."""
PROOF_EVALUATIONS = 1500
"""Searches spent on the question whether pieces can stand together at all."""
TRIES = 24
"""Searches spent on one optional piece."""
QPS = 600
"""QPs of one search for a required piece."""
OPTIONAL_QPS = 150
"""QPs of one search for an optional piece, after the quick one that keeps every choice made before."""
POLISH_QPS = 1500
"""QPs of the final search over all choices of a room."""
BLOCKED_COST = 8.0
"""What a required piece pays for standing where its use side is not free."""
OTHER_SIDE_COST = 0.05
"""What using the second of several allowed sides costs: order, not preference."""


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


@dataclass
class Draft:
    """A room's arrangement before it is settled on the lattice."""

    space: Space
    state: State
    left_out: list[tuple[Wanted, str]] = field(default_factory=list)
    solves: int = 0
    proven: bool = True
    walkable: bool = True


def _empty(space: Space) -> State:
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


def _kin(c: Chosen) -> tuple[object, ...]:
    """What decides feasibility: alternatives that agree here differ only in their anchor."""
    a = c.alternative
    return (a.kind, a.size_mm, a.rotation, a.wall, a.within, a.attach, a.bottom_mm, a.slack_mm, c.sides)


def extend(state: State, c: Chosen, preference: float, walk: bool) -> tuple[State | None, Outcome | None]:
    """Adds a piece to a state; returns the new state, or None and the failed outcome (None: bounds alone)."""
    try:
        assembly = state.assembly.with_piece(c)
    except Impossible:
        return None, None
    accept = walk_test(assembly) if walk else None
    required = c.wanted.required
    outcome = solve(assembly.problem, limit=QPS, accept=accept) if required else _quick(state, assembly, accept)
    if outcome.positions is None:
        return None, outcome
    return State(assembly, outcome, state.preference + preference), outcome


def _quick(state: State, assembly: Assembly, accept: Accept | None) -> Outcome:
    """Searches the new piece's choices with the others kept; where that fails, all choices anew."""
    kept = assembly.problem.copy()
    known = len(state.outcome.rows)
    kept.rows.extend(state.outcome.rows)
    kept.choices = kept.choices[known:]
    quick = solve(kept, limit=OPTIONAL_QPS, accept=accept)
    if quick.positions is not None:
        return replace(quick, rows=(*state.outcome.rows, *quick.rows), proven=False)
    full = solve(assembly.problem, limit=OPTIONAL_QPS, accept=accept)
    return replace(full, solves=full.solves + quick.solves)


class _BestFirst:
    """Best-first search over prefixes of the required pieces; deepest-first once its limit is spent.

    `closed` stays True while the answer, best or impossible, is exact.
    """

    def __init__(self, start: State, pieces: Sequence[Wanted], walk: bool, limit: int = EVALUATIONS) -> None:
        self.pieces, self.walk, self.limit = pieces, walk, limit
        self.order = 0
        self.heap: list[tuple[int, float, int, int, State, tuple[float, Chosen] | None]] = []
        self.deepest = (0, start)
        self.solves = 0
        self.evaluations = 0
        self.closed = True
        self.diving = False
        self.refused: set[tuple[object, ...]] = set()
        self._push(start.cost, 0, start, None)

    def _push(self, bound: float, depth: int, state: State, entry: tuple[float, Chosen] | None) -> None:
        rank = -depth if self.diving else 0
        heapq.heappush(self.heap, (rank, round(bound, 9), self.order, depth, state, entry))
        self.order += 1

    def _dive(self) -> None:
        """Goes on from the deepest prefixes, for as many searches again."""
        self.diving, self.closed = True, False
        self.limit *= 2
        self.heap = [(-depth, bound, order, depth, *rest) for _, bound, order, depth, *rest in self.heap]  # type: ignore[misc]
        heapq.heapify(self.heap)

    def run(self) -> State | None:
        """Returns the best complete state, or None (see `deepest` and `closed`)."""
        while self.heap:
            _, _, _, depth, state, entry = heapq.heappop(self.heap)
            if entry is not None:
                self._evaluate(depth, state, entry)
            elif depth == len(self.pieces):
                return state
            else:
                for cost, c in options(state.assembly, self.pieces[depth]):
                    self._push(state.cost + cost, depth, state, (cost, c))
            if self.evaluations >= self.limit:
                if self.diving:
                    return None
                self._dive()
        return None

    def _evaluate(self, depth: int, state: State, entry: tuple[float, Chosen]) -> None:
        cost, c = entry
        key = (*(_kin(earlier) for earlier in state.assembly.chosen), _kin(c))
        if key in self.refused:
            return
        self.evaluations += 1
        grown, outcome = extend(state, c, cost, self.walk)
        self.solves += outcome.solves if outcome else 0
        if grown is None:
            self.refused.add(key)
            self.closed &= outcome is None or outcome.proven
            return
        if depth + 1 > self.deepest[0]:
            self.deepest = (depth + 1, grown)
        self._push(grown.cost, depth + 1, grown, None)


def _required(draft: Draft, pieces: list[Wanted]) -> None:
    """Places the required pieces; the first that no prefix can take is left out, and the rest tried again."""
    while pieces:
        for walk in (True, False) if draft.walkable else (False,):
            best = _BestFirst(draft.state, pieces, walk)
            state = best.run()
            draft.solves += best.solves
            if state is None and best.deepest[0] == len(pieces):
                state = best.deepest[1]
            if state is not None:
                draft.state, draft.walkable = state, draft.walkable and walk
                draft.proven &= best.closed
                return
        missing = pieces.pop(best.deepest[0])
        word = "no way to stand it is free" if best.closed else "no place found for it"
        draft.left_out.append((missing, f"{word} beside the pieces before it"))


def _optional(draft: Draft, piece: Wanted) -> None:
    refused: set[tuple[object, ...]] = set()
    tries = 0
    for cost, c in options(draft.state.assembly, piece):
        if tries >= TRIES or cost >= piece.skip_cost:
            break
        if _kin(c) in refused:
            continue
        tries += 1
        state, outcome = extend(draft.state, c, cost, draft.walkable)
        draft.solves += outcome.solves if outcome else 0
        if state is not None and state.cost < draft.state.cost + piece.skip_cost:
            draft.state = state
            return
        refused.add(_kin(c))
    draft.left_out.append((piece, f"none of {tries} ways to stand it leaves the room valid and walkable"))


def arrange(space: Space, wanted: Sequence[Wanted], walk: bool = True) -> Draft:
    """Chooses a way to stand for every piece that fits.

    Args:
        space: where the room's furniture may stand.
        wanted: pieces in order of importance.
        walk: whether doors and use sides must stay joined where that is possible.

    Returns:
        The best arrangement found within the limits, its pieces' choices made.
    """
    draft = Draft(space, _empty(space), walkable=walk)
    _required(draft, [piece for piece in wanted if piece.required])
    for piece in wanted:
        if not piece.required:
            _optional(draft, piece)
    _polish(draft)
    return draft


def feasible(space: Space, pieces: Sequence[Wanted]) -> bool | None:
    """Tells whether the pieces can all stand together, walking aside; None where the limit was hit first."""
    best = _BestFirst(_empty(space), pieces, walk=False, limit=PROOF_EVALUATIONS)
    if best.run() is not None or best.deepest[0] == len(pieces):
        return True
    return False if best.closed else None


def _polish(draft: Draft) -> None:
    """Solves the final problem once more with the full limit, so that the certificate speaks of it."""
    assembly = draft.state.assembly
    accept = walk_test(assembly) if draft.walkable else None
    outcome = solve(assembly.problem, limit=POLISH_QPS, ceiling=draft.state.outcome.cost + 1e-6, accept=accept)
    draft.solves += outcome.solves
    draft.proven &= outcome.proven
    if outcome.positions is not None:
        draft.state = State(assembly, outcome, draft.state.preference)
