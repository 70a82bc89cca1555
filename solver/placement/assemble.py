"""From chosen alternatives to a placement problem: variables, bounds, parts, terms, rows and choices.

Rigid companions share their parent's variable, so that nothing has to be searched between them.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from solver.geometry import Rect, rotate, turned
from solver.placement.constraints import Part, Row, apart, clear_of
from solver.placement.problem import Problem
from solver.placement.terms import Anchor, Pull
from solver.wanted import Alternative, Link, Space, Wanted

STAND_WEIGHT = 0.02
"""Pull of a person's square to the middle of its side, m^-2: least weight that keeps the Hessian positive definite."""
PERSON_MM = 1800
"""Height a standing person needs free, mm."""


@dataclass(frozen=True)
class Chosen:
    """A wanted piece with the alternative taken and the use sides that must be free."""

    wanted: Wanted
    alternative: Alternative
    sides: tuple[str, ...] = ()


class Impossible(Exception):
    """The alternatives cannot stand together, seen before any search; the message says why."""


class Assembly:
    """A room's problem, grown one piece at a time; growing copies, so that every prefix stays usable.

    Args:
        space: where the room's furniture may stand.
    """

    def __init__(self, space: Space) -> None:
        self.space = space
        self.problem = Problem()
        self.bodies: dict[str, Part] = {}
        self.rotations: dict[str, int] = {}
        self.chosen: tuple[Chosen, ...] = ()

    def with_piece(self, c: Chosen) -> Assembly:
        """Returns this problem with one more piece; what it is attached to must be there already.

        Raises:
            Impossible: the bounds alone rule it out.
        """
        grown = Assembly(self.space)
        grown.problem = self.problem.copy()
        grown.bodies, grown.rotations = dict(self.bodies), dict(self.rotations)
        grown.chosen = (*self.chosen, c)
        grown._add_piece(c, len(self.problem.parts))
        return grown

    def _add_piece(self, c: Chosen, known: int) -> None:
        self._body(c)
        for side in c.sides:
            self._stand(c, side)
        for link in c.wanted.links:
            if link.of in self.bodies:
                self._link(c.wanted.label, link)
        self._check_bounds()
        alternatives = {other.wanted.label: other.alternative for other in self.chosen}
        parts = self.problem.parts
        for k in range(known, len(parts)):
            for zone in self.space.zones:
                if zone.cause == "outline" or (not parts[k].stand and parts[k].top > zone.above_mm):
                    self.problem.choose(parts[k].label, zone.cause, clear_of(parts[k], zone.rect))
            for earlier in parts[:k]:
                if _must_part(earlier, parts[k], alternatives):
                    self.problem.choose(earlier.label, parts[k].label, apart(earlier, parts[k]))

    def _body(self, c: Chosen) -> None:
        a, label = c.alternative, c.wanted.label
        if a.attach is not None:
            self._attached(c)
            return
        extent = turned(a.size_mm[0], a.size_mm[1], a.rotation)
        low, high = _limits(a.within or self.space.clear, extent)
        if a.wall is not None:
            axis, near, far = _flush(self.space, a, extent)
            low[axis], high[axis] = max(low[axis], near), min(high[axis], far)
        var = (self.problem.variable(0, low[0], high[0]), self.problem.variable(1, low[1], high[1]))
        self._add(label, Part(label, False, var, (0, 0), extent, a.bottom_mm, a.bottom_mm + a.size_mm[2]), a.rotation)
        for axis in (0, 1):
            wish = (2 * a.anchor_mm[axis] - extent[axis]) / 2000
            self.problem.terms.append(Anchor(axis, var[axis], wish, a.weights[axis]))

    def _attached(self, c: Chosen) -> None:
        a, label = c.alternative, c.wanted.label
        attach = a.attach
        if attach is None or attach.parent not in self.bodies:
            raise Impossible(f"{label} stands only with {attach.parent if attach else 'a parent'}, which is not there")
        parent, turn = self.bodies[attach.parent], self.rotations[attach.parent]
        rotation = (turn + a.rotation) % 360
        extent = turned(a.size_mm[0], a.size_mm[1], rotation)
        ends = [rotate(attach.across_mm[k], attach.along_mm[k], turn) for k in (0, 1)]
        low, high = _limits(self.space.clear, extent)
        var, offset = [0, 0], [0, 0]
        for axis in (0, 1):
            least, most = sorted(end[axis] for end in ends)
            shift = (parent.extent[axis] - extent[axis]) // 2 + parent.offset[axis]
            if least == most:
                var[axis], offset[axis] = parent.var[axis], shift + least
                own = (low[axis] - offset[axis], high[axis] - offset[axis])
                self.problem.tighten(axis, var[axis], *own)
            else:
                var[axis] = self.problem.variable(axis, low[axis], high[axis])
                self.problem.rows.append(Row(axis, parent.var[axis], var[axis], shift + least))
                self.problem.rows.append(Row(axis, var[axis], parent.var[axis], -shift - most))
                middle = (2 * shift + least + most) / 2000
                self.problem.terms.append(Pull(axis, parent.var[axis], var[axis], middle, a.weights[axis]))
        part = Part(label, False, (var[0], var[1]), (offset[0], offset[1]), extent, a.bottom_mm, a.bottom_mm + a.size_mm[2])
        self._add(label, part, rotation)

    def _add(self, label: str, part: Part, rotation: int) -> None:
        self.problem.parts.append(part)
        self.bodies[label] = part
        self.rotations[label] = rotation

    def _stand(self, c: Chosen, side: str) -> None:
        """Adds the person's square at a use side: touching it, its centre sliding along the side."""
        label, size = c.wanted.label, self.space.robot_mm
        body = self.bodies[label]
        wall_of_side = {"front": (0, 1), "back": (0, -1), "left": (-1, 0), "right": (1, 0)}[side]
        dx, dz = rotate(*wall_of_side, self.rotations[label])
        normal, along = (0, 1) if dx else (1, 0)
        low, high = _limits(self.space.clear, (size, size))
        var, offset = [0, 0], [0, 0]
        outwards = dx + dz
        var[normal] = body.var[normal]
        offset[normal] = body.offset[normal] + (body.extent[normal] if outwards > 0 else -size)
        self.problem.tighten(normal, var[normal], low[normal] - offset[normal], high[normal] - offset[normal])
        var[along] = self.problem.variable(along, low[along], high[along])
        start, extent = body.offset[along], body.extent[along]
        self.problem.rows.append(Row(along, body.var[along], var[along], start - size // 2))
        self.problem.rows.append(Row(along, var[along], body.var[along], size // 2 - extent - start))
        middle = (2 * start + extent - size) / 2000
        self.problem.terms.append(Pull(along, body.var[along], var[along], middle, STAND_WEIGHT))
        self.problem.parts.append(Part(label, True, (var[0], var[1]), (offset[0], offset[1]), (size, size), 0, PERSON_MM))

    def _link(self, label: str, link: Link) -> None:
        own, other = self.bodies[label], self.bodies[link.of]
        across = 0 if self.rotations[link.of] % 180 == 0 else 1
        for axis in (0, 1):
            weight = link.near + (link.align if axis == across else 0.0)
            if weight > 0 and own.var[axis] != other.var[axis]:
                middle = (2 * (other.offset[axis] - own.offset[axis]) + other.extent[axis] - own.extent[axis]) / 2000
                self.problem.terms.append(Pull(axis, other.var[axis], own.var[axis], middle, weight))

    def _check_bounds(self) -> None:
        for axis in (0, 1):
            for i, (low, high) in enumerate(zip(self.problem.low[axis], self.problem.high[axis], strict=True)):
                if low > high:
                    part = next(p for p in self.problem.parts if p.var[axis] == i)
                    raise Impossible(f"{part.label} and what belongs to it are {low - high} mm too long for the room")


def _must_part(a: Part, b: Part, alternatives: Mapping[str, Alternative]) -> bool:
    if (a.stand and b.stand) or a.label == b.label or a.top <= b.bottom or b.top <= a.bottom:
        return False
    if a.stand or b.stand:
        return True
    first, second = alternatives[a.label], alternatives[b.label]
    return b.label not in (first.under, first.on) and a.label not in (second.under, second.on)


def _limits(within: Rect, extent: tuple[int, int]) -> tuple[list[int], list[int]]:
    """Returns the bounds of a min corner so that the box stays within the rectangle."""
    return [within.x0, within.z0], [within.x1 - extent[0], within.z1 - extent[1]]


def _flush(space: Space, a: Alternative, extent: tuple[int, int]) -> tuple[int, int, int]:
    """Returns the axis across a wall and the range of the min corner that keeps the back at that wall."""
    clear, gap = space.clear, space.gap_mm
    reach = (gap, gap) if a.slack_mm is None else (0, a.slack_mm)
    if a.wall == "north":
        return 1, clear.z0 + reach[0], clear.z0 + reach[1]
    if a.wall == "west":
        return 0, clear.x0 + reach[0], clear.x0 + reach[1]
    if a.wall == "south":
        return 1, clear.z1 - extent[1] - reach[1], clear.z1 - extent[1] - reach[0]
    return 0, clear.x1 - extent[0] - reach[1], clear.x1 - extent[0] - reach[0]
