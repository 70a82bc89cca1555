"""Keeps walls whole for what stands along them: a bed between its nightstands, the run of a kitchen.

Comes in: all openings as they were placed. Goes out: the same openings, some moved along their walls. May import: the ground floor,
catalogs, doors and windows.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Final, NamedTuple

from catalogs.entries import KeptWall
from solver.floorplan.tiling import Joint
from solver.geometry import Rect, gaps_between, to_mm
from tests.floorplan.reference.doors import Cut, Doorways, OpeningSide
from tests.floorplan.reference.windows import EDGE_MM

MOVES: Final = 4
"""Most openings that are moved for one room: a count, so that the same request always ends the same way."""

Shared = Mapping[tuple[int, int], tuple[int, int]]
"""The stretch of wall that two rooms share, by their indices, mm in the house."""


def keep_walls(doorways: Doorways, shared: tuple[Joint, ...]) -> None:
    """Moves openings to the ends of their walls where a room has no wall as whole as its type's `plan.keeps` asks.

    Args:
        doorways: all openings; those that move are replaced. None comes to meet or face another one that it did not before, and the way
            from door to door gets no longer in a room that wins nothing.
        shared: the walls that two rooms share.
    """
    walls = _Walls(doorways, {(joint.a, joint.b): (joint.low, joint.high) for joint in shared})
    for room in range(len(doorways.layout.rooms)):
        for _ in range(MOVES):
            if walls.shortfall(room) == 0 or not walls.move_one(room):
                break


class _Wish(NamedTuple):
    """A `KeptWall`, mm; `across` is 0 where none is asked for."""

    length: int
    depth: int
    under_windows: bool
    round_corners: bool
    across: int


class _Walls:
    """The walls of a house and their openings."""

    def __init__(self, doorways: Doorways, shared: Shared) -> None:
        self.doorways, self.shared = doorways, shared
        more = doorways.layout.walls.more
        by_type = {name: _wishes(doorways.rooms[name].plan.keeps, more) for name in set(doorways.types)}
        self.wishes = [by_type[name] for name in doorways.types]
        self._known: dict[tuple[int, ...], int] = {}

    def shortfall(self, room: int, cut: Cut | None = None, placed: Cut | None = None) -> int:
        """Returns by how much a room's longest whole walls are too short for its type, mm, with one opening elsewhere, or without it."""
        if not self.wishes[room]:
            return 0
        sides = self.doorways.sides(room)
        low = placed.ends[0] if placed is not None else -1
        key = (room, *[low if side.cut is cut else side.low for side in sides])
        if key not in self._known:
            rect = self.doorways.layout.rooms[room]
            moved = [self.doorways.side(placed, room)] if placed is not None else []
            sides = [*[side for side in sides if side.cut is not cut], *moved]
            self._known[key] = sum([max(0, wish.length - _longest(rect, sides, wish)) for wish in self.wishes[room]])
        return self._known[key]

    def move_one(self, room: int) -> bool:
        """Moves the opening of a room by which most is won for the rooms it opens on, or the first that will do; windows come first."""
        short, best = self.shortfall(room), 0
        move: tuple[Cut, Cut] | None = None
        cuts = [side.cut for side in self.doorways.sides(room) if side.cut.kind != "garage_door"]
        for cut in sorted(cuts, key=lambda cut: cut.kind != "window"):
            most = short - self.shortfall(room, cut)
            beyond = cut.other if room == cut.room else cut.room
            other, most_beyond = 0, 0
            if beyond is not None and most:
                other = self.shortfall(beyond)
                most_beyond = other - self.shortfall(beyond, cut)
            if not most or most + most_beyond <= best:
                continue
            for placed in self._moved(cut):
                gains = {room: short - self.shortfall(room, cut, placed)}
                if beyond is not None and gains[room] + most_beyond > best:
                    gains[beyond] = other - self.shortfall(beyond, cut, placed)
                won = sum(gains.values())
                if won > best and self._is_in_nobodys_way(cut, placed, gains):
                    best, move = won, (cut, placed)
            if best >= short:
                break
        if move is not None:
            self.doorways.replace(*move)
        return move is not None

    def _is_in_nobodys_way(self, cut: Cut, placed: Cut, gains: Mapping[int, int]) -> bool:
        """Tells whether an opening there meets and faces no more than it did, and leads no farther where walls win nothing."""
        doorways = self.doorways
        if doorways.score(placed) > doorways.score(cut) or doorways.faced(placed) > doorways.faced(cut):
            return False
        return not any(gain <= 0 and self._way(room, placed) > self._way(room, cut) for room, gain in gains.items())

    def _way(self, room: int, cut: Cut) -> int:
        """Returns how far an opening is from the others that one walks through, along x and z, mm in all."""
        own = self.doorways.side(cut, room).square
        others = [side.square.centre for side in self.doorways.sides(room) if side.square is not None and side.cut.id != cut.id]
        return sum([abs(own.centre[0] - x) + abs(own.centre[1] - z) for x, z in others]) if own is not None else 0

    def _moved(self, cut: Cut) -> Iterator[Cut]:
        """Yields an opening at the ends of its stretch of wall."""
        if cut.other is not None:
            low, high = self.shared[min(cut.sides), max(cut.sides)]
        else:
            stretches = self.doorways.layout.openable[cut.room][cut.wall]
            low, high = next(one for one in stretches if one[0] <= cut.centre <= one[1])
        jamb = EDGE_MM if cut.kind == "window" else min(self.doorways.jamb, (high - low - cut.width) // 2)
        for centre in (low + jamb + cut.width // 2, high - jamb - cut.width // 2):
            if centre != cut.centre and low + jamb <= centre - cut.width // 2 and centre + cut.width // 2 <= high - jamb:
                yield cut.at(centre)


def _wishes(keeps: Sequence[KeptWall], more: int) -> tuple[_Wish, ...]:
    """Returns what a room type keeps, between lines of walls that are thicker than usual by so many mm."""
    return tuple(
        _Wish(
            to_mm(one.length) + more,
            to_mm(one.depth) + more // 2,
            one.under_windows,
            one.round_corners,
            to_mm(one.across) + more if one.across else 0,
        )
        for one in keeps
    )


def _longest(rect: Rect, sides: Sequence[OpeningSide], wish: _Wish) -> int:
    """Returns the longest stretch of a room's walls as is wished for, mm."""
    blocked = _blocked(rect, sides, wish)
    if 0 < min(rect.width, rect.depth) <= wish.across:
        pairs = (("north", "south", rect.depth), ("west", "east", rect.width))
        facing = [[gaps_between(rect.along(wall), blocked[wall]) for wall in pair[:2]] for pair in pairs if pair[2] <= wish.across]
        return max((min(a[1], b[1]) - max(a[0], b[0]) for one, other in facing for a in one for b in other), default=0)
    x0, z0, x1, z1 = rect
    north, north_west, north_east = _whole(x0, x1, blocked["north"])
    south, south_west, south_east = _whole(x0, x1, blocked["south"])
    east, east_north, east_south = _whole(z0, z1, blocked["east"])
    west, west_north, west_south = _whole(z0, z1, blocked["west"])
    if wish.round_corners:
        corners = north_west + west_north, north_east + east_north, south_west + west_south, south_east + east_south
        return max(north, south, east, west, *corners)
    return max(north, south, east, west)


def _whole(low: int, high: int, blocked: list[tuple[int, int]]) -> tuple[int, int, int]:
    """Returns a wall's longest stretch that nothing breaks, and those that reach its western or northern end and its other end, mm."""
    if not blocked:
        return high - low, high - low, high - low
    longest, at_low, at = 0, 0, low
    for start, end in sorted(blocked):
        if start > at:
            longest = max(longest, start - at)
            if at == low:
                at_low = start - at
        at = max(at, end)
    return max(longest, high - at), at_low, max(0, high - at)


def _blocked(rect: Rect, sides: Sequence[OpeningSide], wish: _Wish) -> dict[str, list[tuple[int, int]]]:
    """Returns what breaks each wall: windows, where they do, and doors' squares on the floor before it."""
    blocked: dict[str, list[tuple[int, int]]] = {"north": [], "south": [], "east": [], "west": []}
    depth, under_windows = wish.depth, wish.under_windows
    x0, z0, x1, z1 = rect.x0 + depth, rect.z0 + depth, rect.x1 - depth, rect.z1 - depth
    for cut, wall, low, high, square in sides:
        if square is None:
            if not (under_windows and cut.kind == "window"):
                blocked[wall].append((low, high))
            continue
        west, north, east, south = square
        if north < z0:
            blocked["north"].append((west, east))
        if south > z1:
            blocked["south"].append((west, east))
        if west < x0:
            blocked["west"].append((north, south))
        if east > x1:
            blocked["east"].append((north, south))
    return blocked
