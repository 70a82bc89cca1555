"""Can these pieces stand in this room at all? A mixed-integer programme straight from the rules of docs/scene.md, for one-room scenes.

A piece keeps its rotation; one with a wall may stand at any of the four, turned with it, its back within 0.2 m of the wall's
line. Nobody stands in a door's square; nobody taller than the sill before a window; two that share heights are left, right,
north or south of each other. Wall thickness 0, right angles, nothing tucked, nothing carried.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.optimize import Bounds, LinearConstraint, milp

from solver.scene import Furniture, Opening, Room

BIG = 20.0
BACK_TO = {"north": 0, "west": 90, "south": 180, "east": 270}
Expression = dict[int, float]


class Programme:
    """Rows sum(coefficient x variable) >= bound over variables that are reals or yes-or-no."""

    def __init__(self) -> None:
        self.bounds: list[tuple[float, float, bool]] = []
        self.rows: list[tuple[Expression, float]] = []

    def real(self, low: float, high: float) -> int:
        self.bounds.append((low, high, False))
        return len(self.bounds) - 1

    def choice(self, count: int) -> list[int]:
        """Yes-or-no variables of which one at least is yes."""
        start = len(self.bounds)
        self.bounds += [(0, 1, True)] * count
        picked = list(range(start, start + count))
        self.rows.append((dict.fromkeys(picked, 1.0), 1.0))
        return picked

    def at_least(self, expression: Expression, bound: float, when: int | None = None) -> None:
        """Asks for expression >= bound, if the yes-or-no variable says so."""
        row = dict(expression)
        if when is not None:
            row[when] = row.get(when, 0.0) - BIG
            bound -= BIG
        self.rows.append((row, bound))

    def feasible(self) -> bool:
        matrix = np.zeros((len(self.rows), len(self.bounds)))
        for k, (expression, _) in enumerate(self.rows):
            for variable, coefficient in expression.items():
                matrix[k, variable] += coefficient
        low, high, integral = (np.array(column) for column in zip(*self.bounds, strict=True))
        constraints = LinearConstraint(matrix, np.array([bound for _, bound in self.rows]) - 1e-7, np.inf)
        result = milp(np.zeros(len(self.bounds)), integrality=integral.astype(int), bounds=Bounds(low, high), constraints=constraints)
        assert result.status in (0, 2), result.message
        return bool(result.status == 0)


class Box:
    """A piece in the programme: its north-west corner and its extents, which depend on the wall it stands at."""

    def __init__(self, programme: Programme, room: Room, piece: Furniture) -> None:
        self.piece = piece
        self.corner = [programme.real(0, room.width), programme.real(0, room.depth)]
        walls: list[str | None] = [piece.wall] if piece.locked or not piece.wall else list(BACK_TO)
        picked = programme.choice(len(walls))
        programme.rows.append((dict.fromkeys(picked, -1.0), -1.0))
        self.size: list[Expression] = [{}, {}]
        for wall, yes in zip(walls, picked, strict=True):
            turn = (BACK_TO[wall] - BACK_TO[piece.wall or "north"]) if wall else 0
            for axis, extent in enumerate(extents(piece, (round(piece.rotation) + turn) % 360)):
                self.size[axis][yes] = extent
        for wall, yes in zip(walls, picked, strict=True):
            if wall in ("west", "north"):
                programme.at_least({self.corner[wall == "north"]: -1.0}, -0.2, yes)
            elif wall:
                axis = int(wall == "south")
                programme.at_least(self.end(axis), (room.width, room.depth)[axis] - 0.2, yes)
        if piece.locked:
            for axis, centre in enumerate((piece.x, piece.z)):
                at = centre - extents(piece, round(piece.rotation))[axis] / 2
                programme.at_least({self.corner[axis]: 1.0}, at)
                programme.at_least({self.corner[axis]: -1.0}, -at)
        for axis, length in enumerate((room.width, room.depth)):
            programme.at_least({k: -v for k, v in self.end(axis).items()}, -length)

    def end(self, axis: int) -> Expression:
        """The far edge along an axis."""
        return {self.corner[axis]: 1.0, **self.size[axis]}


def extents(piece: Furniture, rotation: int) -> tuple[float, float]:
    return (piece.depth, piece.width) if rotation % 180 else (piece.width, piece.depth)


def kept_free(room: Room, opening: Opening) -> tuple[tuple[float, float, float, float], float]:
    """The rectangle an opening keeps free, and above which height."""
    low, high = opening.position - opening.width / 2, opening.position + opening.width / 2
    deep, above = min(opening.width, 0.9), -1.0
    if opening.kind == "window":
        low, high, deep, above = low - 0.1, high + 0.1, 0.5, opening.sill
    box = {
        "north": (low, 0.0, high, deep),
        "south": (low, room.depth - deep, high, room.depth),
        "west": (0.0, low, deep, high),
        "east": (room.width - deep, low, room.width, high),
    }[opening.wall or ""]
    return box, above


def can_stand(room: Room, furniture: Sequence[Furniture]) -> bool:
    """Tells whether the pieces alone can stand in the room."""
    programme = Programme()
    boxes = [Box(programme, room, piece) for piece in furniture]
    for k, a in enumerate(boxes):
        for b in boxes[:k]:
            sides = programme.choice(4)
            for side, (first, second, axis) in zip(sides, ((a, b, 0), (b, a, 0), (a, b, 1), (b, a, 1)), strict=True):
                ends = first.end(axis)
                programme.at_least({second.corner[axis]: 1.0, **{v: -c for v, c in ends.items()}}, 0, side)
        for opening in room.openings:
            (x0, z0, x1, z1), above = kept_free(room, opening)
            if a.piece.height > above:
                sides = programme.choice(4)
                for axis, (low, high) in enumerate(((x0, x1), (z0, z1))):
                    programme.at_least({v: -c for v, c in a.end(axis).items()}, -low, sides[2 * axis])
                    programme.at_least({a.corner[axis]: 1.0}, high, sides[2 * axis + 1])
    return not boxes or programme.feasible()
