"""No slivers: gaps too narrow for a hand are closed, or opened for a person to reach in, where all rules and the walk still hold.

Comes in: a room on the lattice that is valid and walkable. Goes out: the same with pieces slid by some centimetres, and what
that costs. A piece slides with all that is attached to it, alone or with what it touches. Whole millimetres; limits are counts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from itertools import combinations
from typing import NamedTuple

from solver.geometry import Rect, strip
from solver.placement.arrange import SolvedRoom
from solver.placement.problem import ProblemBox

TOUCHING_MM, SLIVER_MM, REACH_MM = 50, 150, 300
"""BodyGaps below the first are contact; from it to the second slivers; from the third on a hand and a broom come in."""
SHARED_MM = 150
"""How long two sides face each other before the gap between them is one."""
BESIDE_MM = 30
"""How far apart closed pieces are left, as the backs are from the walls; else they touch."""
MOST_COST = 0.2
"""What tidying a room may cost in all: a third of what a piece's kept floor is worth."""
TOGETHER = 2
"""Slides of which only the last must leave fewer slivers, and the room walkable."""
MOST_TRIES = 100
"""Slides tried in a room."""
MOST_SLIDES = 8
"""Slides of a room; each leaves fewer slivers, so few rooms take more than three."""
WALL_MM = 1000
"""Thickness of the boxes that stand for the walls; any will do."""

Lattice = tuple[list[int], list[int]]
"""Lattice by axis and variable, mm."""


class BodyGap(NamedTuple):
    """Free floor between two boxes along an axis, mm; `low` and `high` are numbers of the boxes at its ends."""

    axis: int
    low: int
    high: int
    wide: int


class _Slide(NamedTuple):
    cost: float
    axis: int
    by: int
    variables: tuple[int, ...]


def gaps(boxes: Sequence[Rect], bodies: int) -> list[BodyGap]:
    """Returns the gaps narrower than REACH_MM beside bodies, those in which nothing else stands.

    Args:
        boxes: bodies, then what is fixed, mm.
        bodies: how many of them are bodies.
    """
    found = []
    for low, high in combinations(range(len(boxes)), 2):
        if low >= bodies:
            break
        for axis in (0, 1):
            gap = _gap(boxes, axis, low, high)
            if gap is not None:
                found.append(gap)
    return found


def _gap(boxes: Sequence[Rect], axis: int, one: int, two: int) -> BodyGap | None:
    a, b = boxes[one], boxes[two]
    if a[axis] > b[axis]:
        a, b, one, two = b, a, two, one
    wide, across = b[axis] - a[axis + 2], 1 - axis
    start, end = max(a[across], b[across]), min(a[across + 2], b[across + 2])
    if not 0 <= wide < REACH_MM or end - start < SHARED_MM:
        return None
    between = (a[2], start, b[0], end) if axis == 0 else (start, a[3], end, b[1])
    filled = wide > 0 and any(box.overlaps(Rect(*between)) for box in boxes)
    return None if filled else BodyGap(axis, one, two, wide)


def slivers(found: Sequence[BodyGap]) -> list[BodyGap]:
    """Returns those of the gaps that are slivers."""
    return [gap for gap in found if TOUCHING_MM <= gap.wide < SLIVER_MM]


def tidied(solved: SolvedRoom, p: Lattice) -> tuple[Lattice, float]:
    """Slides pieces of a room so that fewer slivers are left.

    Args:
        solved: the room; its problem is the one last assembled in its core.
        p: where everything is, mm, by axis and variable: valid and walkable.

    Returns:
        Lattice as valid and walkable, and by how much the bodies' terms cost more there than at p; at most MOST_COST.
    """
    room, spent = _Slides(solved), 0.0
    for _ in range(MOST_SLIDES):
        found = gaps(room.boxes(p), len(room.bodies))
        better = room.better(p, found, len(slivers(found)), MOST_COST - spent, TOGETHER)
        if better is None:
            break
        p, spent = better[0], spent + better[1]
    return p, spent


def _slid(p: Lattice, slide: _Slide) -> Lattice:
    new = (list(p[0]), list(p[1]))
    for v in slide.variables:
        new[slide.axis][v] += slide.by
    return new


class _Slides:
    """What of a room tidying needs: the bodies on the floor, what is fixed, and what goes along with a variable."""

    def __init__(self, solved: SolvedRoom) -> None:
        self.core, self.problem, self.tries = solved.core, solved.problem, MOST_TRIES
        boxes = {box.label: box for box in self.problem.boxes if not box.stand}
        chosen = {one.piece.label: one.candidate for one in solved.chosen}
        standing = [label for label, candidate in chosen.items() if candidate.on is None and candidate.under is None]
        self.bodies: list[ProblemBox] = [boxes[label] for label in standing]
        self.carried = [(boxes[one.attach.parent], boxes[label]) for label, one in chosen.items() if one.attach]
        persons = {(axis, box.var[axis]) for box in self.problem.boxes if box.stand for axis in (0, 1)}
        persons -= {(axis, box.var[axis]) for box in boxes.values() for axis in (0, 1)}
        self.terms = [term for term in self.problem.terms if (term.axis, term.j) not in persons]
        clear = solved.space.clear
        walls = [strip(clear, wall, clear.along(wall), -WALL_MM) for wall in ("west", "east", "north", "south")]
        self.fixed = [*walls, *(zone.rect for zone in solved.space.zones if zone.cause == "outline")]

    @cached_property
    def holds(self) -> Callable[[Lattice], bool]:
        """Tells whether the rules hold without persons' squares: whether all can be used is the walk's to say."""
        self.core.lay_alone()
        return self.core.holds_alone_at

    def boxes(self, p: Lattice) -> list[Rect]:
        """Returns the bodies' footprints, then what is fixed."""
        return [*(body.rect(p) for body in self.bodies), *self.fixed]

    def slides(self, p: Lattice, found: Sequence[BodyGap]) -> list[_Slide]:
        """Returns the slides within all bounds that close or open a sliver, the cheapest first."""
        slides = {}
        for gap in slivers(found):
            for body, other, ahead in ((gap.low, gap.high, 1), (gap.high, gap.low, -1)):
                if body >= len(self.bodies):
                    continue
                for moving in dict.fromkeys((self._with({body}, gap.axis), self._with(_touching(found, gap.axis, body, other), gap.axis))):
                    for by in (gap.wide - BESIDE_MM, gap.wide, gap.wide - REACH_MM):
                        if self._within(p, gap.axis, moving, by * ahead):
                            slides[gap.axis, by * ahead, moving] = self._cost(p, gap.axis, moving, by * ahead)
        return sorted(_Slide(cost, *key) for key, cost in slides.items())

    def _with(self, bodies: set[int], axis: int) -> tuple[int, ...]:
        """Returns the variables that move when bodies do: theirs, and of all that is attached to them."""
        moving = {self.bodies[k].var[axis] for k in bodies if k < len(self.bodies)}
        for parent, own in self.carried:
            if parent.var[axis] in moving:
                moving.add(own.var[axis])
        return tuple(sorted(moving))

    def _within(self, p: Lattice, axis: int, moving: Sequence[int], by: int) -> bool:
        low, high = self.problem.low[axis], self.problem.high[axis]
        return all(low[v] <= p[axis][v] + by <= high[v] for v in moving)

    def _cost(self, p: Lattice, axis: int, moving: Sequence[int], by: int) -> float:
        """Returns how much more the terms cost once variables have moved."""
        before = [at / 1000 for at in p[axis]]
        after = list(before)
        for v in moving:
            after[v] += by / 1000
        return round(sum(term.cost(after) - term.cost(before) for term in self.terms if term.axis == axis), 9)

    def better(self, p: Lattice, found: Sequence[BodyGap], before: int, most: float, together: int) -> tuple[Lattice, float] | None:
        """Returns positions with fewer slivers than before and what they cost more than p: one slide from p, or several together."""
        equal = []
        for slide in self.slides(p, found):
            self.tries -= 1
            new = _slid(p, slide)
            if self.tries < 0 or slide.cost > most or not self.holds(new):
                continue
            left = gaps(self.boxes(new), len(self.bodies))
            if len(slivers(left)) < before:
                if self.core.walkable_at(new):
                    return new, slide.cost
            elif together > 1 and len(slivers(left)) == before:
                equal.append((new, left, slide.cost))
        for new, left, cost in equal:
            further = self.better(new, left, before, most - cost, together - 1)
            if further is not None:
                return further[0], cost + further[1]
        return None


def _touching(found: Sequence[BodyGap], axis: int, body: int, other: int) -> set[int]:
    """Returns a body and what it touches along an axis, directly or through others, but for what is on the gap's other side."""
    pairs = [(gap.low, gap.high) for gap in found if gap.axis == axis and gap.wide < TOUCHING_MM]
    reached, ahead = {body}, [body]
    while ahead:
        at = ahead.pop()
        for pair in pairs:
            if at in pair:
                beyond = pair[1] if pair[0] == at else pair[0]
                if beyond != other and beyond not in reached:
                    reached.add(beyond)
                    ahead.append(beyond)
    return reached
