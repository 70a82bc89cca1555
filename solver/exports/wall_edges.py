"""Rooms' edges: the lines of their outlines in the house."""

from __future__ import annotations

from typing import Literal, NamedTuple

from solver.geometry import doubled_area, edges_round
from solver.scene import Room

PlanAxis = Literal["x", "z"]
Line = tuple[int, PlanAxis, float]
"""A level, an axis and the coordinate across it."""


class OutlineEdge(NamedTuple):
    """One edge of a room's outline in the house, m; `inward` is 1 where the room lies towards greater coordinates.

    `number` counts the room's edges; `thickness` is that of its wall, once it is known.
    """

    line: Line
    start: float
    end: float
    inward: Literal[1, -1]
    side: str
    room: Room
    number: int = 0
    thickness: float = 0.0


def on_lattice(metres: float) -> float:
    """Rounds to whole millimetres, which undoes what adding metres in binary does."""
    return round(metres * 1000) / 1000


def edges_of(room: Room) -> list[OutlineEdge]:
    """Returns a room's edges in the order of its outline's points: north, east, south, west for a rectangle."""
    corners = room.corners
    clockwise = doubled_area(corners) >= 0
    return [_edge(room, a, b, clockwise, number) for number, (a, b) in enumerate(edges_round(corners))]


def _edge(room: Room, a: tuple[float, float], b: tuple[float, float], clockwise: bool, number: int) -> OutlineEdge:
    along_x = abs(b[0] - a[0]) >= abs(b[1] - a[1])
    forwards = (b[0] > a[0] if along_x else b[1] > a[1]) == clockwise
    origin, across = (room.x, room.z + a[1]) if along_x else (room.z, room.x + a[0])
    ends = (a[0], b[0]) if along_x else (a[1], b[1])
    side = ("north" if forwards else "south") if along_x else ("east" if forwards else "west")
    line: Line = (room.level, "x" if along_x else "z", on_lattice(across))
    inward: Literal[1, -1] = 1 if side in ("north", "west") else -1
    return OutlineEdge(line, on_lattice(origin + min(ends)), on_lattice(origin + max(ends)), inward, side, room, number)
