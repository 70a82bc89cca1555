"""The floor of rooms as the rules see it: what is clear of walls, what is kept free, and where the robot's square comes.

Comes in: a scene. Goes out: rectangles [x0, z0, x1, z1] by room, room-relative metres. May import: scene.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from solver.scene import Scene
from solver.validator.lattice import ExactBox, metres
from solver.validator.standing import squares, window_zone
from solver.validator.tiled_floor import Grid, boxes_of
from solver.validator.walk import Walk, walks
from solver.validator.world import PlacedRoom, World, world_of


def floors(scene: Scene, rooms: Collection[str] = ()) -> list[dict[str, Any]]:
    """Says what a person who moves furniture must know of the floor.

    Args:
        scene: any scene that could be read.
        rooms: the ids of the rooms wanted; all where none are given.

    Returns:
        For each room, in the scene's order: `clear`, its bounds less the walls; `doors`, the squares kept free; `windows`, the
        strips where nothing taller than the sill stands; `free`, what the robot's square covers of the clear floor while it
        comes from an entrance, in rectangles that do not overlap.
    """
    world = world_of(scene)
    walk_of = {place.room.id: walk for walk in walks(world) for place in walk.places}
    wanted = [place for place in world.places if not rooms or place.room.id in rooms]
    return [_floor(world, walk_of[place.room.id], place) for place in wanted]


def _floor(world: World, walk: Walk, place: PlacedRoom) -> dict[str, Any]:
    clear = _clear(world, place)
    windows = [window_zone(hole) for hole in place.holes if hole.opening.kind == "window"]
    return {
        "room": place.room.id,
        "clear": _metres(clear),
        "doors": [_metres(square.box) for square in squares(world, place)],
        "windows": [_metres(zone) for zone in windows],
        "free": [_metres(box) for box in _free(world, walk, place, clear)],
    }


def _clear(world: World, place: PlacedRoom) -> ExactBox:
    """Returns the bounds less half a wall on each side; without extent where the walls take all of it."""
    x0, z0, x1, z1 = place.outline.bounds.grown(-world.half_wall)
    return ExactBox(x0, z0, max(x0, x1), max(z0, z1))


def _free(world: World, walk: Walk, place: PlacedRoom, clear: ExactBox) -> Iterator[ExactBox]:
    """Sweeps the square over the centres that can be come to, from doorways too, and leaves out what are walls."""
    swept = [_shared(box.moved(-place.x, -place.z).grown(walk.reach), clear) for box in _centres(walk, place)]
    half = world.half_wall
    walls = [edge.strip(edge.start - half, edge.end + half, half, half) for edge in place.edges]
    grid = Grid(boxes_of([box for box in swept if box]), boxes_of([*place.outline.missing, *walls]))
    return _rectangles(grid, grid.free)


def _centres(walk: Walk, place: PlacedRoom) -> Iterator[ExactBox]:
    near = place.outline.bounds.moved(place.x, place.z).grown(walk.reach)
    for tile, _ in walk.free.windows(near):
        reached = np.isin(tile.components, sorted(walk.entered))
        inside = np.zeros_like(reached)
        inside[tile.grid.cells(near)] = True
        yield from _rectangles(tile.grid, reached & inside)


def _rectangles(grid: Grid, chosen: NDArray[np.bool_]) -> Iterator[ExactBox]:
    """Merges chosen cells: runs along z, then runs that are alike from row to row."""
    xs, zs = grid.xs.tolist(), grid.zs.tolist()
    begun: dict[tuple[int, int], int] = {}
    for row in range(len(chosen) + 1):
        runs = set(_runs(chosen[row])) if row < len(chosen) else set()
        for start, end in [run for run in begun if run not in runs]:
            yield ExactBox(xs[begun.pop((start, end))], zs[start], xs[row], zs[end])
        for run in sorted(runs - begun.keys()):
            begun[run] = row


def _runs(cells: NDArray[np.bool_]) -> list[tuple[int, int]]:
    changes = np.flatnonzero(np.diff(np.concatenate([[False], cells, [False]]).astype(np.int8))).tolist()
    return list(zip(changes[::2], changes[1::2], strict=True))


def _shared(box: ExactBox, other: ExactBox) -> ExactBox | None:
    """Returns the part of a box that lies in another."""
    low, high = (max(box.x0, other.x0), max(box.z0, other.z0)), (min(box.x1, other.x1), min(box.z1, other.z1))
    return ExactBox(*low, *high) if box.meets(other) else None


def _metres(box: ExactBox) -> list[float]:
    return [metres(steps) for steps in box]
