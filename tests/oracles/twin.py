"""The kernel's differential twin: the same search in Python over DAQP, slow, for reading.

Root = bounds and fixed rows. At a node the most violated choices are tried: each option appends one row to one axis and
that axis is solved again; the choice whose cheapest child is dearest is branched on. What is infeasible or dearer than
the incumbent is pruned. The search stops on a count of QPs, never on time; then the result is not proven.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from solver.placement.problem import ORIGIN
from solver.placement.problem import DifferenceRow as Row
from tests.oracles.axis import ROW_TOLERANCE, AxisProgram, Floats
from tests.oracles.problem import Problem
from tests.oracles.problems import Outcome

CANDIDATES = 4
"""How many of the most violated choices are tried at a node."""
LIMIT = 4000
"""QPs after which the search gives up proving."""
COST_TOLERANCE = 1e-9


@dataclass(frozen=True)
class _Node:
    picks: tuple[tuple[int, Row], ...]
    """The choices branched on so far, each with the option taken."""
    rows: tuple[tuple[Row, ...], tuple[Row, ...]]
    costs: tuple[float, float]
    positions: tuple[Floats, Floats]

    @property
    def cost(self) -> float:
        return self.costs[0] + self.costs[1]


class _Table:
    """The choices' options as arrays, so that all slacks come from one expression."""

    def __init__(self, problem: Problem) -> None:
        n_x = len(problem.low[0])
        self.origin = n_x + len(problem.low[1])
        count = len(problem.choices)
        self.before = np.full((count, 4), self.origin)
        self.after = np.full((count, 4), self.origin)
        self.s = np.full((count, 4), np.inf)
        for c, choice in enumerate(problem.choices):
            for o, row in enumerate(choice.options):
                shift = n_x if row.axis else 0
                self.before[c, o] = self.origin if row.i == ORIGIN else row.i + shift
                self.after[c, o] = self.origin if row.j == ORIGIN else row.j + shift
                self.s[c, o] = row.s / 1000

    def slacks(self, positions: tuple[Floats, Floats]) -> Floats:
        """Returns the slack of every option, m, shape (choices, 4)."""
        p = np.concatenate([positions[0], positions[1], [0.0]])
        slack: Floats = p[self.after] - p[self.before] - self.s
        return slack


class Search:
    """One search. Use `solve`."""

    def __init__(self, problem: Problem, limit: int, ceiling: float) -> None:
        self.problem, self.limit = problem, limit
        self.programs = (AxisProgram(problem, 0), AxisProgram(problem, 1))
        self.table = _Table(problem)
        self.best_cost = ceiling
        self.best: _Node | None = None
        self.solves = 0

    def run(self) -> Outcome:
        """Runs the search to its end or limit."""
        root = self._root()
        stack = [root] if root else []
        exhausted = True
        while stack:
            node = stack.pop()
            if node.cost >= self.best_cost - COST_TOLERANCE:
                continue
            if self.solves >= self.limit:
                exhausted = False
                break
            violated = self._violated(node)
            if violated:
                stack.extend(reversed(self._branch(node, violated)))
            else:
                self.best, self.best_cost = node, node.cost
        return self._outcome(exhausted)

    def _root(self) -> _Node | None:
        if any(not choice.options for choice in self.problem.choices):
            return None
        solved = [program.solve(()) for program in self.programs]
        self.solves += 2
        if solved[0] is None or solved[1] is None:
            return None
        return _Node((), ((), ()), (solved[0][0], solved[1][0]), (solved[0][1], solved[1][1]))

    def _violated(self, node: _Node) -> list[int]:
        """Returns the most violated choices, worst first, ties by lowest index."""
        if not self.problem.choices:
            return []
        slack = self.table.slacks(node.positions).max(axis=1)
        worst = np.argsort(slack.round(9), kind="stable")[:CANDIDATES]
        return [int(c) for c in worst if slack[c] < -ROW_TOLERANCE]

    def _branch(self, node: _Node, violated: Sequence[int]) -> list[_Node]:
        """Returns the children of the choice whose cheapest child is dearest, cheapest first."""
        chosen: list[_Node] = []
        dearest = -1.0
        for c in violated:
            children = [child for row in self.problem.choices[c].options if (child := self._child(node, c, row))]
            if not children:
                return []
            cheapest = min(child.cost for child in children)
            if cheapest > dearest + COST_TOLERANCE:
                chosen, dearest = children, cheapest
        return sorted(chosen, key=lambda child: round(child.cost, 9))

    def _child(self, node: _Node, c: int, row: Row) -> _Node | None:
        axis = row.axis
        rows = (*node.rows[axis], row)
        self.solves += 1
        solved = self.programs[axis].solve(rows)
        if solved is None:
            return None
        cost, positions = solved
        if cost + node.costs[1 - axis] >= self.best_cost - COST_TOLERANCE:
            return None
        picks = (*node.picks, (c, row))
        if axis == 0:
            return _Node(picks, (rows, node.rows[1]), (cost, node.costs[1]), (positions, node.positions[1]))
        return _Node(picks, (node.rows[0], rows), (node.costs[0], cost), (node.positions[0], positions))

    def _outcome(self, exhausted: bool) -> Outcome:
        if self.best is None:
            return Outcome(float("inf"), None, (), exhausted, self.solves)
        taken = self._taken(self.best) if self.problem.choices else ()
        return Outcome(self.best.cost, self.best.positions, taken, exhausted, self.solves)

    def _taken(self, node: _Node) -> tuple[Row, ...]:
        """Returns the option each choice took: the one branched on, else the one that holds with most slack."""
        branched = dict(node.picks)
        widest = self.table.slacks(node.positions).argmax(axis=1)
        return tuple(branched.get(c) or choice.options[o] for c, (choice, o) in enumerate(zip(self.problem.choices, widest, strict=True)))


def solve(problem: Problem, *, limit: int = LIMIT, ceiling: float = float("inf")) -> Outcome:
    """Finds the cheapest positions at which every choice holds.

    Args:
        problem: the room's problem.
        limit: QPs after which to stop; the outcome is then not proven.
        ceiling: only placements cheaper than this count.
    """
    return Search(problem, limit, ceiling).run()
