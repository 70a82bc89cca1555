"""The rules once more, by looking at every 5 cm square of floor: slow, plain, and nothing of the validator's.

Good for scenes whose edges lie on 5 cm steps, with walls 10, 20 or 30 cm thick (or, but for walking, of no thickness). A cell is the square
[i, i+1] x [j, j+1] steps; a lattice point its north-west corner. On such scenes a look at the cells is exact.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.scene import Opening, Room, Scene

STEP = 0.05
PAD = 60
Mask = NDArray[np.bool_]
FRONT = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}
Broken = set[tuple[str, str, tuple[str, ...]]]


def steps(metres: float) -> int:
    count = round(metres / STEP)
    assert abs(count * STEP - metres) < 1e-9, f"{metres} is not on the raster"
    return count


@dataclass
class Thing:
    """A body: its cells' ranges in the room, the heights, and what the document says of it."""

    x0: int
    z0: int
    x1: int
    z1: int
    low: float
    high: float
    piece: Any

    def mask(self, shape: tuple[int, int]) -> Mask:
        cells = np.zeros(shape, dtype=bool)
        cells[self.x0 + PAD : self.x1 + PAD, self.z0 + PAD : self.z1 + PAD] = True
        return cells


def things(room: Room) -> list[Thing]:
    found = []
    for piece in room.furniture:
        wide, deep = (piece.depth, piece.width) if piece.rotation in (90, 270) else (piece.width, piece.depth)
        corner = (steps(piece.x - wide / 2), steps(piece.z - deep / 2))
        found.append(Thing(*corner, corner[0] + steps(wide), corner[1] + steps(deep), piece.y, piece.y + piece.height, piece))
    return found


def corners(room: Room) -> list[tuple[int, int]]:
    outline = room.outline or ((0.0, 0.0), (room.width, 0.0), (room.width, room.depth), (0.0, room.depth))
    return [(steps(x), steps(z)) for x, z in outline]


def sides(room: Room) -> list[tuple[str, int, int, int]]:
    """The wall lines: which wall, the line, from, to."""
    floor, points, found = inside(room), corners(room), []
    for (x0, z0), (x1, z1) in zip(points, points[1:] + points[:1], strict=True):
        if z0 == z1:
            south = floor[min(x0, x1) + PAD, z0 + PAD]
            found.append(("north" if south else "south", z0, min(x0, x1), max(x0, x1)))
        else:
            east = floor[x0 + PAD, min(z0, z1) + PAD]
            found.append(("west" if east else "east", x0, min(z0, z1), max(z0, z1)))
    return found


def inside(room: Room) -> Mask:
    """Which cells are floor, by counting the walls to the west of each cell's centre."""
    points = corners(room)
    shape = tuple(max(point[axis] for point in points) + 2 * PAD for axis in (0, 1))
    x, z = np.meshgrid(*(np.arange(size) - PAD + 0.5 for size in shape), indexing="ij")
    crossings = np.zeros(shape, dtype=int)
    for (x0, z0), (x1, z1) in zip(points, points[1:] + points[:1], strict=True):
        if x0 == x1:
            crossings += (x > x0) & (z > min(z0, z1)) & (z < max(z0, z1))
    return crossings % 2 == 1


def clear(room: Room, half_wall: int) -> Mask:
    kept = inside(room)
    for axis in (0, 1):
        kept = np.all([np.roll(kept, by, axis) for by in range(-half_wall, half_wall + 1)], axis=0)
    return kept


def at_wall(room: Room, opening: Opening) -> tuple[str, int, int, int]:
    """An opening's wall, its line, and what it spans there."""
    half = steps(opening.width / 2)
    if opening.edge is not None:
        side, line, start, _ = sides(room)[opening.edge]
        centre = start + steps(opening.position)
    else:
        side, line, *_ = next(entry for entry in sides(room) if entry[0] == opening.wall)
        centre = steps(opening.position)
    return side, line, centre - half, centre + half


def zone(side: str, line: int, span: tuple[int, int], depth: int, shape: tuple[int, int]) -> Mask:
    """The cells along a wall, so many deep into the room."""
    cells = np.zeros(shape, dtype=bool)
    for deep in range(depth):
        across = line + PAD + (deep if side in ("north", "west") else -1 - deep)
        along = slice(span[0] + PAD, span[1] + PAD)
        if side in ("north", "south"):
            cells[along, across] = True
        else:
            cells[across, along] = True
    return cells


def broken(scene: Scene) -> Broken:
    """Everything wrong with where bodies stand."""
    return {entry for room in scene.rooms for entry in _standing(scene, room)}


def _standing(scene: Scene, room: Room) -> Iterator[tuple[str, str, tuple[str, ...]]]:
    bodies, floor = things(room), clear(room, steps(scene.wall_thickness / 2))
    masks = [body.mask(floor.shape) for body in bodies]
    for index, (body, cells) in enumerate(zip(bodies, masks, strict=True)):
        if (cells & ~floor).any():
            yield "out_of_bounds", room.id, (body.piece.id,)
        if body.piece.wall and _far(room, body):
            yield "wall_far", room.id, (body.piece.id,)
        for other, others in zip(bodies[index + 1 :], masks[index + 1 :], strict=True):
            if (cells & others).any() and _collide(body, other):
                yield "overlap", room.id, tuple(_chair_first(body, other))
        for opening in room.openings:
            if (cells & _keep_free(room, opening, floor.shape)).any() and _in_height(body, opening):
                yield "blocks_window" if opening.kind == "window" else "blocks_door", room.id, (body.piece.id,)


def _in_height(body: Thing, opening: Opening) -> bool:
    return body.high > opening.sill + 1e-9 and body.low < opening.sill + opening.height - 1e-9


def _keep_free(room: Room, opening: Opening, shape: tuple[int, int]) -> Mask:
    side, line, start, end = at_wall(room, opening)
    if opening.kind == "window":
        return zone(side, line, (start - 2, end + 2), 10, shape)
    depth = min(end - start, 18) if opening.kind in ("door", "passage") else 0
    return zone(side, line, (start, end), depth, shape)


def _far(room: Room, body: Thing) -> bool:
    """Rectangular rooms only."""
    width, depth = steps(room.width), steps(room.depth)
    reach = {"north": body.z0, "south": depth - body.z1, "west": body.x0, "east": width - body.x1}[body.piece.wall]
    beyond = {"north": -body.z1, "south": body.z0 - depth, "west": -body.x1, "east": body.x0 - width}[body.piece.wall]
    return max(reach, beyond) > 4


def _chair_first(a: Thing, b: Thing) -> Iterator[str]:
    yield from (b.piece.id, a.piece.id) if b.piece.under == a.piece.id else (a.piece.id, b.piece.id)


def _collide(a: Thing, b: Thing) -> bool:
    if min(a.high, b.high) - max(a.low, b.low) <= 1e-9 or a.piece.on == b.piece.id or b.piece.on == a.piece.id:
        return False
    for chair, table in ((a, b), (b, a)):
        if chair.piece.under == table.piece.id:
            across = range(max(a.x0, b.x0), min(a.x1, b.x1))
            along = range(max(a.z0, b.z0), min(a.z1, b.z1))
            tucked = len(across) if chair.piece.rotation in (90, 270) else len(along)
            return tucked > max(0, steps(chair.piece.depth) - 3)
    return True


# --- walking ---------------------------------------------------------------------------------------------------------
class House:
    """The whole house on one raster, and where a square's centre can come to: lattice points, one step at a time."""

    def __init__(self, scene: Scene, robot: float) -> None:
        self.scene, self.half, self.half_wall = scene, steps(robot / 2), steps(scene.wall_thickness / 2)
        self.offsets = {room.id: (steps(room.x), steps(room.z)) for room in scene.rooms}
        size = 4 * PAD + 200
        self.floor, self.taken = np.zeros((size, size), dtype=bool), np.zeros((size, size), dtype=bool)
        self.centres: dict[str, Mask] = {}
        for room in scene.rooms:
            self.centres[room.id] = self._moved(room, clear(room, self.half_wall + self.half))
            self.floor |= self._moved(room, inside(room))
            for body in things(room):
                if body.low < 2.0:
                    self.taken |= self._moved(room, body.mask(inside(room).shape))
        for room in scene.rooms:
            for side, line, start, end in sides(room):
                self.taken |= self._wall(room, side, line, (start, end))
        self.free = self._free_points()
        self.reached = self._walk(self._entries())

    def _moved(self, room: Room, cells: Mask) -> Mask:
        x, z = self.offsets[room.id]
        whole = np.zeros_like(self.floor)
        whole[x + PAD : x + PAD + cells.shape[0], z + PAD : z + PAD + cells.shape[1]] = cells
        return whole

    def _across(self, room: Room, side: str, line: int, span: tuple[int, int]) -> tuple[bool, int, int, int]:
        """A piece of line in the house: whether it runs east, its place on the raster, from, to."""
        x, z = (offset + 2 * PAD for offset in self.offsets[room.id])
        runs_east = side in ("north", "south")
        return (True, line + z, span[0] + x, span[1] + x) if runs_east else (False, line + x, span[0] + z, span[1] + z)

    def _wall(self, room: Room, side: str, line: int, span: tuple[int, int]) -> Mask:
        """A wall with its posts, less the ways through it."""
        runs_east, at, start, end = self._across(room, side, line, span)
        solid = np.zeros_like(self.taken)
        along = np.zeros(solid.shape[0], dtype=bool)
        along[start - self.half_wall : end + self.half_wall] = True
        for other in self.scene.rooms:
            for opening in other.openings:
                if opening.kind != "window":
                    wall, *place = at_wall(other, opening)
                    cut_east, cut_at, cut_start, cut_end = self._across(other, wall, place[0], (place[1], place[2]))
                    if (cut_east, cut_at) == (runs_east, at):
                        along[cut_start:cut_end] = False
        if runs_east:
            solid[along, at - self.half_wall : at + self.half_wall] = True
        else:
            solid[at - self.half_wall : at + self.half_wall, along] = True
        return solid

    def _free_points(self) -> Mask:
        """Points around which a square meets no taken cell."""
        count = np.zeros(tuple(size + 1 for size in self.taken.shape), dtype=int)
        count[1:, 1:] = self.taken.cumsum(axis=0).cumsum(axis=1)
        half, free = self.half, np.zeros_like(self.taken)
        inner = slice(half, self.taken.shape[0] - half)
        ahead = count[2 * half :] - count[: -2 * half]
        free[inner, inner] = (ahead[:, 2 * half :] - ahead[:, : -2 * half])[:-1, :-1] == 0
        return free

    def _entries(self) -> list[tuple[int, int]]:
        doors = [(room, opening) for room in self.scene.rooms for opening in room.openings if opening.kind != "window"]
        main = [entry for entry in doors if entry[1].main_entrance]
        points = []
        for room, opening in main or [entry for entry in doors if entry[1].connects_to == "EXTERIOR"]:
            side, line, start, end = at_wall(room, opening)
            runs_east, at, low, high = self._across(room, side, line, (start, end))
            points += [(place, at) if runs_east else (at, place) for place in range(low, high + 1)]
        return points

    def _walk(self, entries: list[tuple[int, int]]) -> Mask:
        reached = np.zeros_like(self.free)
        waiting = deque(point for point in entries if self.free[point])
        for point in waiting:
            reached[point] = True
        while waiting:
            x, z = waiting.popleft()
            for nx, nz in ((x + 1, z), (x - 1, z), (x, z + 1), (x, z - 1)):
                if self.free[nx, nz] and not reached[nx, nz] and self._on_floor((x, z), (nx, nz)):
                    reached[nx, nz] = True
                    waiting.append((nx, nz))
        return reached

    def _on_floor(self, a: tuple[int, int], b: tuple[int, int]) -> bool:
        """Whether a step between two points runs along or over floor."""
        x, z = min(a[0], b[0]), min(a[1], b[1])
        return bool(self.floor[x, z] or (self.floor[x, z - 1] if a[1] == b[1] else self.floor[x - 1, z]))

    def area(self, room: str) -> float:
        """The area of a room's reached centres, m2: of those that would be clear of its walls with all doors walled up."""
        corners_in = self.reached[:-1, :-1] & self.reached[1:, :-1] & self.reached[:-1, 1:] & self.reached[1:, 1:]
        return float((corners_in & self.centres[room][:-1, :-1]).sum()) * STEP**2

    def touches(self, room: Room, body: Thing, side: str) -> bool:
        """Whether the square touches a side of the unrotated piece: front, back, left or right."""
        turns = {"front": 0, "right": 90, "back": 180, "left": 270}[side]
        dx, dz = FRONT[(round(body.piece.rotation) + turns) % 360]
        x, z = (offset + 2 * PAD for offset in self.offsets[room.id])
        if dz:
            at = (body.z1 + self.half if dz > 0 else body.z0 - self.half) + z
            return bool(self.reached[body.x0 + x : body.x1 + x + 1, at].any())
        at = (body.x1 + self.half if dx > 0 else body.x0 - self.half) + x
        return bool(self.reached[at, body.z0 + z : body.z1 + z + 1].any())
