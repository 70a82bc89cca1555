"""What lies in the drawers of furniture, so that it goes with them in formats in which it does not move by itself."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from solver.exports.model import BodyFront, ModelBody, Point


class HeldThing(NamedTuple):
    """A body that lies in a drawer: of which piece, which of its fronts; its place from the front's hinge, in the piece's own frame, m.

    `turn` is its turn against the piece, degrees.
    """

    body: ModelBody
    piece: str
    front: str
    at: Point
    turn: float


def held_things(bodies: Sequence[ModelBody]) -> Mapping[str, HeldThing]:
    """Returns what lies in drawers, by id."""
    pieces = {body.id: body for body in bodies if any(front.slides for front in body.fronts)}
    things = ((body, pieces[body.parent]) for body in bodies if body.parent in pieces)
    return {body.id: held for body, piece in things if (held := _held(body, piece))}


def held_in(held: Mapping[str, HeldThing], piece: str, front: str) -> list[HeldThing]:
    """Returns what lies in one front of a piece."""
    return [thing for thing in held.values() if thing.piece == piece and thing.front == front] if held else []


def _held(body: ModelBody, piece: ModelBody) -> HeldThing | None:
    """Returns a body as what lies in the drawer of a piece in whose tray its middle is; None where it is in none."""
    (across, along), up = piece.local(body.x, body.z), body.y - piece.y
    at, middle = (across, up, along), (across, up + body.height / 2, along)
    for front in piece.fronts:
        if front.slides and _is_in(middle, piece, front):
            x, y, z = (round(own - hinge, 6) for own, hinge in zip(at, front.hinge, strict=True))
            return HeldThing(body, piece.id, front.name, (x, y, z), (body.turn - piece.turn) % 360)
    return None


def _is_in(middle: Point, piece: ModelBody, front: BodyFront) -> bool:
    """Tells whether a point is within the box around a front's parts."""
    parts = [piece.parts[number] for number in front.parts]
    low = [min(part.at[k] - part.size[k] / 2 for part in parts) for k in range(3)]
    high = [max(part.at[k] + part.size[k] / 2 for part in parts) for k in range(3)]
    return all(a < at < b for a, at, b in zip(low, middle, high, strict=True))
