"""Can a problem's choices all be met? A big-M mixed-integer programme in HiGHS, its answer checked in integers.

Comes in: a `Problem`, read as data. Goes out: True, False, or None where the limit came first. One binary an option;
M is the least that the bounds allow for each row, so that nothing is lost and little is loose.
"""

from __future__ import annotations

from collections.abc import Sequence

from tests.oracles.problem import Problem
from tests.oracles.programme import Programme

SECONDS = 600.0
"""A guard against a verdict that never comes, by the clock: each takes a second at most."""
_CHOSEN = 0.5


def verdict(problem: Problem, seconds: float = SECONDS) -> bool | None:
    """Tells whether positions exist at which every bound, row and choice holds; None where the time ran out first."""
    return _search(problem, seconds)[0]


def witness(problem: Problem, seconds: float = SECONDS) -> tuple[list[int], list[int]] | None:
    """Returns integer positions at which everything holds, or None where there are none or the time ran out first."""
    return _search(problem, seconds)[1]


def _search(problem: Problem, seconds: float) -> tuple[bool | None, tuple[list[int], list[int]] | None]:
    programme = Programme()
    columns = [[programme.variable(a, b) for a, b in zip(problem.low[k], problem.high[k], strict=True)] for k in (0, 1)]
    binaries = []

    def expression(row: tuple[int, int, int, int]) -> list[tuple[int, float]]:
        axis, i, j, _ = row
        if i == j:
            return []
        return [(columns[axis][v], sign) for v, sign in ((j, 1.0), (i, -1.0)) if v >= 0]

    for row in problem.rows:
        programme.at_least(expression(row), row.s)
    for choice in problem.choices:
        own = [(programme.binary(), row) for row in choice.options]
        for binary, row in own:
            terms = expression(row)
            big = max(row.s - programme.least(terms), 0)
            programme.at_least([*terms, (binary, -big)], row.s - big)
        programme.at_least([(binary, 1.0) for binary, _ in own], 1)
        binaries += own
    found, x = programme.solve(seconds)
    if not found:
        return found, None
    taken = [row for binary, row in binaries if x[binary] > _CHOSEN]
    positions = [earliest(problem.low[k], problem.high[k], [r for r in (*problem.rows, *taken) if r[0] == k]) for k in (0, 1)]
    if positions[0] is None or positions[1] is None:
        return None, None  # the solver's tolerance spoke, not the numbers
    return True, (positions[0], positions[1])


def earliest(low: Sequence[int], high: Sequence[int], rows: Sequence[tuple[int, int, int, int]]) -> list[int] | None:
    """Returns the least integer positions within the bounds that hold rows p_j - p_i >= s of one axis, or None.

    Bellman-Ford from the lower bounds; index -1 is the constant 0.
    """
    p = [*low, 0]
    for _ in range(len(p) + 1):
        changed = False
        for _, i, j, s in rows:
            if p[j] < p[i] + s:
                if j < 0 or i == j:
                    return None
                p[j] = p[i] + s
                changed = True
        if any(a > b for a, b in zip(p, high, strict=False)):
            return None
        if not changed:
            return p[:-1]
    return None
