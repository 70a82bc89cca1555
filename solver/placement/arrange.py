"""A whole room: which wall, rotation, size variant and use side each piece takes, and who is left out.

Required pieces: best-first over prefixes. Optional pieces follow by importance, everything movable, if the room stays
walkable. Limits are counts; ties go to the earlier.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from solver.placement.assemble import Impossible
from solver.placement.prefixes import BestFirst
from solver.placement.search import LIMIT
from solver.placement.states import Budget, State, empty, extend, kin, options, walk_test
from solver.wanted import Space, Wanted

EVALUATIONS = 240
"""Searches spent on the required pieces of a room before the best-first order is given up."""
PROOF_EVALUATIONS = 1500
"""Searches spent on the question whether pieces can stand together at all."""
TRIES = 24
"""Searches spent on one optional piece."""
POLISH_QPS = 1500
"""QPs of the final search over all choices of a room."""


@dataclass
class Draft:
    """A room's arrangement before it is settled on the lattice."""

    space: Space
    state: State
    budget: Budget
    left_out: list[tuple[Wanted, str]] = field(default_factory=list)
    solves: int = 0
    proven: bool = True
    walkable: bool = True


def arrange(space: Space, wanted: Sequence[Wanted], walk: bool = True, budget: Budget | None = None) -> Draft:
    """Chooses a way to stand for every piece that fits.

    Args:
        space: where the room's furniture may stand.
        wanted: pieces in order of importance.
        walk: whether doors and use sides must stay joined where that is possible.
        budget: the work it may cost.

    Returns:
        The best arrangement found within the limits, its pieces' choices made.
    """
    allowed = budget or Budget()
    draft = Draft(space, empty(space), allowed, walkable=walk)
    _required(draft, [piece for piece in wanted if piece.required])
    for piece in wanted:
        if not piece.required:
            _optional(draft, piece)
    _polish(draft)
    return draft


def arrange_as_wished(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Draft:
    """Keeps every piece in its first way if all can stand so; else arranges them, walking aside.

    The first ways are the cheapest, so where their placement costs less than any other way would, it is the best.
    """
    together = _together(space, wanted, budget)
    others = [a.cost for piece in wanted for a in piece.alternatives[1:] if a.cost > 0]
    if together is not None and together.state.cost <= min(others, default=float("inf")):
        return together
    draft = arrange(space, wanted, walk=False, budget=budget)
    worse = bool(draft.left_out) or (together is not None and draft.state.cost >= together.state.cost)
    return together if together is not None and worse else draft


def _together(space: Space, wanted: Sequence[Wanted], budget: Budget) -> Draft | None:
    """Searches a place for all pieces at once, each in its first way."""
    state = empty(space)
    assembly, preference = state.assembly, 0.0
    for piece in wanted:
        ways = options(assembly, piece)
        if not ways:
            return None
        try:
            assembly = assembly.with_piece(ways[0][1])
        except Impossible:
            return None
        preference += ways[0][0]
    outcome = budget.solve(assembly.problem, LIMIT)
    if outcome.positions is None:
        return None
    return Draft(space, State(assembly, outcome, preference), budget, solves=outcome.solves, proven=outcome.proven, walkable=False)


def feasible(space: Space, pieces: Sequence[Wanted], budget: Budget | None = None) -> bool | None:
    """Tells whether the pieces can all stand together, walking aside; None where a limit was hit first."""
    best = BestFirst(empty(space), pieces, PROOF_EVALUATIONS, budget or Budget())
    if best.run() is not None or best.deepest[0] == len(pieces):
        return True
    return False if best.closed else None


def _required(draft: Draft, pieces: list[Wanted]) -> None:
    """Places the required pieces; the first that no prefix can take is left out, and the rest tried again."""
    while pieces:
        for walk in (True, False) if draft.walkable else (False,):
            best = BestFirst(draft.state, pieces, EVALUATIONS, draft.budget, walk)
            state = best.run()
            draft.solves += best.solves
            if state is None and (best.deepest[0] == len(pieces) or draft.budget.spent):
                state = best.deepest[1]
            if state is not None:
                draft.state, draft.walkable = state, draft.walkable and walk
                draft.proven &= best.closed
                for piece in pieces[len(state.assembly.chosen) :]:
                    draft.left_out.append((piece, "no place found for it within the search's limit"))
                return
        missing = pieces.pop(best.deepest[0])
        word = "no way to stand it is free" if best.closed else "no place found for it"
        draft.left_out.append((missing, f"{word} beside the pieces before it"))


def _optional(draft: Draft, piece: Wanted) -> None:
    refused: set[tuple[object, ...]] = set()
    tries = 0
    for way in options(draft.state.assembly, piece):
        if tries >= TRIES or way[0] >= piece.skip_cost or draft.budget.spent:
            break
        if kin(way[1]) in refused:
            continue
        tries += 1
        state, outcome = extend(draft.state, way, draft.walkable, draft.budget)
        draft.solves += outcome.solves if outcome else 0
        if state is not None and state.cost < draft.state.cost + piece.skip_cost:
            draft.state = state
            return
        if outcome is None or not outcome.turned_down:
            refused.add(kin(way[1]))
    draft.left_out.append((piece, f"none of {tries} ways to stand it leaves the room valid and walkable"))


def _polish(draft: Draft) -> None:
    """Solves the final problem once more with the full limit, so that the certificate speaks of it."""
    assembly = draft.state.assembly
    accept = walk_test(assembly) if draft.walkable else None
    outcome = draft.budget.solve(assembly.problem, POLISH_QPS, draft.state.outcome.cost + 1e-6, accept)
    draft.solves += outcome.solves
    draft.proven &= outcome.proven
    if outcome.positions is not None:
        draft.state = State(assembly, outcome, draft.state.preference)
