"""What carries things inside a shape: the boards of a carcass between what stands on them, and the bottoms of drawers."""

from collections.abc import Iterator, Sequence
from functools import lru_cache
from itertools import pairwise
from typing import Final, Literal, NamedTuple

from catalogs.shapes import Solid

InsideSort = Literal["shelves", "drawers"]
"""What `surface` of a row that `holds` may name."""
THIN: Final = 0.022
"""What is no thicker is a board of a carcass or a tray, m."""
LEAST_SIDE: Final = 0.1
"""Narrower or flatter room carries nothing, m."""
LEAST_CLEARANCE: Final = 0.05
"""Lower room over a board, or in a drawer, carries nothing, m."""
APART: Final = 0.001
"""Solids that share no more than this only touch, m."""
FreeSpan = tuple[float, float]


class InsideSurface(NamedTuple):
    """A surface inside a body.

    `x` is its span from the middle of the body to the body's right, `z` to its front, `height` is above the body's underside,
    `clearance` the free height over it, all m. `drawer` is the front that it is the bottom of: of `drawers`, not of `shelves`.
    """

    sort: InsideSort
    x: FreeSpan
    z: FreeSpan
    height: float
    clearance: float
    drawer: str | None = None


class _Box(NamedTuple):
    x: FreeSpan
    y: FreeSpan
    z: FreeSpan

    def over(self, x: FreeSpan, z: FreeSpan) -> bool:
        return min(self.x[1], x[1]) - max(self.x[0], x[0]) > APART and min(self.z[1], z[1]) - max(self.z[0], z[0]) > APART


@lru_cache(maxsize=4096)
def insides_of(solids: Sequence[Solid], size: tuple[float, float, float]) -> tuple[InsideSurface, ...]:
    """Returns what carries things inside a shape of a size, m, all fronts shut, from its lowest board up; the drawers after the boards."""
    boxes = [_box(solid, size) for solid in solids]
    lying = [number for number, solid in enumerate(solids) if solid.board is not None and _lies(boxes[number])]
    shelves = [surface for number in lying if solids[number].front is None for surface in _on_board(number, boxes)]
    drawers = [surface for number in lying if solids[number].front is not None for surface in _in_tray(number, boxes, solids)]
    return (*sorted(shelves, key=lambda one: (one.height, one.x)), *drawers)


def _box(solid: Solid, size: tuple[float, float, float]) -> _Box:
    width, depth, height = size
    (x0, x1), (y0, y1), (z0, z1) = solid.x, solid.y, solid.z
    return _Box(((x0 - 0.5) * width, (x1 - 0.5) * width), (y0 * height, y1 * height), ((z0 - 0.5) * depth, (z1 - 0.5) * depth))


def _length(span: FreeSpan) -> float:
    return span[1] - span[0]


def _lies(box: _Box) -> bool:
    return _length(box.y) <= THIN and min(_length(box.x), _length(box.z)) >= LEAST_SIDE


def _on_board(number: int, boxes: Sequence[_Box]) -> Iterator[InsideSurface]:
    """Yields the free stretches of a board between what stands up from it."""
    board = boxes[number]
    level = board.y[1]
    others = [box for i, box in enumerate(boxes) if i != number and box.over(board.x, board.z) and box.y[1] > level + APART]
    standing = sorted(box.x for box in others if box.y[0] <= level + APART and _length(box.x) <= THIN)
    cuts = [(board.x[0], board.x[0]), *standing, (board.x[1], board.x[1])]
    for before, after in pairwise(cuts):
        x = before[1], after[0]
        clearance = min((box.y[0] - level for box in others if box.over(x, board.z)), default=0.0)
        if _length(x) >= LEAST_SIDE and clearance >= LEAST_CLEARANCE:
            yield InsideSurface("shelves", x, board.z, level, clearance)


def _in_tray(number: int, boxes: Sequence[_Box], solids: Sequence[Solid]) -> Iterator[InsideSurface]:
    """Yields the bottom of a drawer's tray, within its sides, as high as they are."""
    floor, front = boxes[number], solids[number].front
    walls = [boxes[i] for i, one in enumerate(solids) if one.front == front and one.board is not None and i != number]
    middle, rear = sum(floor.x) / 2, min(wall.z[1] for wall in walls)
    left = max(wall.x[1] for wall in walls if wall.x[1] < middle)
    right = min(wall.x[0] for wall in walls if wall.x[0] > middle)
    deep = min(wall.y[1] for wall in walls) - floor.y[1]
    if deep >= LEAST_CLEARANCE and min(right - left, floor.z[1] - rear) >= LEAST_SIDE:
        yield InsideSurface("drawers", (left, right), (rear, floor.z[1]), floor.y[1], deep, front)
