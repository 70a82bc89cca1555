"""The fewest pieces that cannot stand together.

Not here: by how much a room is too short (lengths), why each piece was left out (why_left_out).
"""

from collections.abc import Mapping, Sequence

from solver.pieces import Piece, Space
from solver.placement.arrange import feasible
from solver.placement.budget import Budget


def minimal_conflict(
    space: Space, pieces: Sequence[Piece], missing: str, budget: Budget | None = None, walk: bool = False
) -> tuple[str, ...] | None:
    """Finds a minimal set of pieces that cannot stand together, or with `walk` cannot be used together.

    Pieces are added, `missing` and what carries it first, then what else stands there, until they are infeasible; then a deletion
    filter: a piece whose absence leaves the rest infeasible is not part of the reason. Who goes takes along what stands only at it.

    Returns:
        Labels, in the order given, such that they alone are infeasible and without any one of them the rest of them is
        feasible; None where a limit left a question open or all can stand.
    """
    allowed = budget or Budget()
    known = {piece.label: piece for piece in pieces}

    def verdict(labels: set[str]) -> bool | None:
        return feasible(space, [piece for piece in pieces if piece.label in labels], allowed, walk)

    members: set[str] = set()
    stand: bool | None = True
    beside = sorted(known, key=lambda label: known[label].parents.isdisjoint(known[missing].parents))
    for label in (missing, *beside):
        members |= _with_carriers(known, label)
        if (stand := verdict(members)) is not True:
            break
    if stand is not False:
        return None
    before: set[str] = set()
    while members != before:  # who lost what it could have been attached to may count no more
        before = members
        for label in known:
            if label in members:
                rest = members - _with_carried(known, members, label)
                if (stand := verdict(rest)) is None:
                    return None
                if stand is False:
                    members = rest
    return tuple(piece.label for piece in pieces if piece.label in members)


def _carrier(piece: Piece) -> str | None:
    """Returns the one piece without which a piece cannot stand, if there is one."""
    return next(iter(piece.parents)) if len(piece.parents) == 1 else None


def _with_carriers(known: Mapping[str, Piece], label: str) -> set[str]:
    """Returns a piece and those it can only stand with, one upon the other."""
    found: set[str] = set()
    at: str | None = label
    while at is not None and at in known and at not in found:
        found.add(at)
        at = _carrier(known[at])
    return found


def _with_carried(known: Mapping[str, Piece], members: set[str], label: str) -> set[str]:
    """Returns a member and all members that have nothing left to stand with once it is gone."""
    gone = {label}
    while True:
        left = members - gone
        more = {other for other in left if known[other].candidates and known[other].parents.isdisjoint({None, *left})}
        if not more:
            return gone
        gone |= more
