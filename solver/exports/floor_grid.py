"""A storey's plan as cells: which of them rooms hold, which walls and bodies touch, how far apart they are and which hang together.

Row 0 lies in the north, column 0 in the west. Lengths in m, in the house.
"""

import math
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

import numpy as np
import numpy.typing as npt
from scipy.ndimage import distance_transform_edt, label

from solver.demanded import demand
from solver.exports.model import Cuboid, FloorPlate, HouseModel, ModelBody
from solver.geometry import edges_round

_SAME: Final = 1e-6
"""Shares of a cell that are nothing: coordinates are whole half millimetres."""
CELL_WORK: Final = 0.1
"""What a cell counts in all that is written of it; measured of pictures."""
PASS_WORK: Final = 0.001
"""What a cell counts that an array is passed over for; measured."""
WALKED_ON: Final = 0.03
"""What is not higher above the floor than this is no obstacle: rugs, mats, thresholds, m."""
Mask = npt.NDArray[np.bool_]


class FloorGrid(NamedTuple):
    """Cells over a rectangle of the plan, whose north-west corner is `x`, `z`."""

    cell: float
    x: float
    z: float
    columns: int
    rows: int

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns: an array over the cells has this shape."""
        return self.rows, self.columns

    @property
    def south(self) -> float:
        """The z of the grid's southern edge."""
        return self.z + self.rows * self.cell

    def touched(self, x0: float, z0: float, x1: float, z1: float) -> tuple[slice, slice]:
        """Returns the rows and columns of the cells that share area with a rectangle of the plan."""
        return (_touched(z0 - self.z, z1 - self.z, self.cell, self.rows), _touched(x0 - self.x, x1 - self.x, self.cell, self.columns))

    def all_touched(self, boxes: Sequence[tuple[float, float, float, float]]) -> Iterator[tuple[slice, slice]]:
        """Yields for each rectangle of the plan what `touched` returns."""
        corners = (np.array(boxes).reshape(-1, 2, 2) - (self.x, self.z)) / self.cell
        first, last = np.floor(corners[:, 0] + _SAME), np.ceil(corners[:, 1] - _SAME)
        ends = np.clip(np.stack([first, last], axis=1), 0, (self.columns, self.rows)).astype(int).tolist()
        return ((slice(top, bottom), slice(left, right)) for (left, top), (right, bottom) in ends)

    def centred(self, x0: float, z0: float, x1: float, z1: float) -> tuple[slice, slice]:
        """Returns the rows and columns of the cells whose centres a rectangle of the plan holds."""
        return (_centred(z0 - self.z, z1 - self.z, self.cell, self.rows), _centred(x0 - self.x, x1 - self.x, self.cell, self.columns))

    def centre(self, row: int, column: int) -> tuple[float, float]:
        """Returns the x and z of a cell's centre."""
        return self.x + (column + 0.5) * self.cell, self.z + (row + 0.5) * self.cell


def _touched(start: float, end: float, cell: float, count: int) -> slice:
    first = math.floor(start / cell + _SAME)
    return slice(min(max(first, 0), count), min(max(math.ceil(end / cell - _SAME), 0), count))


def _centred(start: float, end: float, cell: float, count: int) -> slice:
    first = math.ceil(start / cell - 0.5 - _SAME)
    return slice(min(max(first, 0), count), min(max(math.ceil(end / cell - 0.5 - _SAME), 0), count))


def grid_of(model: HouseModel, level: int, cell: float, margin: float) -> FloorGrid:
    """Returns a grid over a level's rooms and a margin round them; its lines are whole cells from the house's origin."""
    corners = [corner for room in model.rooms if room.level == level for corner in room.corners] or [(0.0, 0.0)]
    (west, east), (north, south) = ((min(at), max(at)) for at in zip(*corners, strict=True))
    left, top = (math.floor((at - margin) / cell + _SAME) for at in (west, north))
    right, bottom = (math.ceil((at + margin) / cell - _SAME) for at in (east, south))
    demand(CELL_WORK * (right - left) * (bottom - top))
    return FloorGrid(cell, round(left * cell, 6), round(top * cell, 6), right - left, bottom - top)


def floor_mask(grid: FloorGrid, room: FloorPlate) -> Mask:
    """Returns the cells whose centres lie on a room's floor."""
    demand(PASS_WORK * grid.rows * grid.columns * (1 + len(room.corners) / 2))
    mask = np.zeros(grid.shape, dtype=np.bool_)
    east = grid.x + grid.columns * grid.cell
    for (x0, z0), (x1, z1) in edges_round(room.corners):
        if x0 == x1:  # east of each edge that runs north and south the floor begins or ends
            mask[grid.centred(x0, min(z0, z1), east, max(z0, z1))] ^= True
    return mask


def mark_body(grid: FloorGrid, taken: Mask, body: ModelBody) -> None:
    """Marks the cells that share area with a body's turned footprint, not with its parts."""
    window = grid.touched(*body.footprint)
    if body.turn % 90 == 0:
        taken[window] = True
    elif not taken[window].all():  # most of what is turned lies on something that is marked already
        taken[window] |= inside(grid, body, window, touching=True)


def inside(grid: FloorGrid, body: ModelBody, window: tuple[slice, slice], touching: bool) -> Mask:
    """Returns which cells of a window share area with a body's turned footprint; or, not `touching`, have their centre in it."""
    turn = math.radians(body.turn)
    sine, cosine = math.sin(turn), math.cos(turn)
    rows, columns = window
    x = grid.x + (np.arange(columns.start, columns.stop) + 0.5) * grid.cell - body.x
    z = (grid.z + (np.arange(rows.start, rows.stop) + 0.5) * grid.cell - body.z)[:, None]
    reach = (abs(sine) + abs(cosine)) * grid.cell / 2 if touching else 0.0
    across, along = np.abs(cosine * x - sine * z), np.abs(sine * x + cosine * z)
    held: Mask = (across < body.width / 2 + reach) & (along < body.depth / 2 + reach)
    return held


def obstacles(model: HouseModel, level: int, grid: FloorGrid, height: float) -> Mask:
    """Returns the cells that something touches which a robot of a height, m, cannot pass: walls, frames, railings, bodies.

    Doors stand open and are left out, as are people and pets, who move; what lies flat is walked on.
    """
    taken = np.zeros(grid.shape, dtype=np.bool_)
    floor = next((room.elevation for room in model.rooms if room.level == level), 0.0)
    low, high = floor + WALKED_ON, floor + height
    boxes = [(box.x0, box.z0, box.x1, box.z1) for box in solid_boxes(model) if box.y0 < high and box.y1 > low]
    standing = [one for one in model.bodies if one.y < high and one.y + one.height > low and one.sort != "dynamic" and not one.flat]
    boxes += [body.footprint for body in standing if body.turn % 90 == 0]
    for window in grid.all_touched(boxes):
        taken[window] = True
    for body in standing:
        if body.turn % 90:
            mark_body(grid, taken, body)
    return taken


def solid_boxes(model: HouseModel) -> Iterator[Cuboid]:
    """Yields the boxes of walls and of what is fitted to them, thresholds left out."""
    yield from (wall.box for wall in model.walls)
    yield from (fitting.box for fitting in model.fittings if fitting.surface != "threshold")


def squared_distances(taken: Mask) -> npt.NDArray[np.int32]:
    """Returns each cell's squared distance from its nearest taken cell, centre to centre, in cells; large where there is none."""
    if not taken.any():
        return np.full(taken.shape, sum(taken.shape) ** 2, dtype=np.int32)
    squares: npt.NDArray[np.int32] = np.rint(distance_transform_edt(~taken) ** 2).astype(np.int32)
    return squares


def largest_stretch(taken: Mask) -> Mask:
    """Returns the largest set of cells that hang together by their edges; of equal ones the first from the top."""
    parts, count = label(taken)
    return np.asarray(parts == 1 + np.bincount(parts.ravel())[1:].argmax() if count else taken, dtype=np.bool_)
