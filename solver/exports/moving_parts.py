"""What moves in a house as simulators have it, the fronts of bodies and the leaves of doors: links of their own on joints.

What lies in drawers goes with them in formats in which it does not move by itself.

z is up, as in colliders: a hinge's frame is that of what it hangs on, moved to the hinge.
"""

from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from math import radians
from typing import Final, Literal, NamedTuple

from catalogs.fronts import BodyFront
from catalogs.shapes import Axis
from solver.body_parts import BodyPart
from solver.exports.colliders import Collider, Triple, collider_of, colliders_of, leaf_colliders, parts_of_hung_leaf, shares_of, z_up
from solver.exports.model import DoorLeaf, ModelBody, Paint, Point

Z_UP: Final[dict[Axis, tuple[Axis, Literal[1, -1]]]] = {"x": ("x", 1), "y": ("z", 1), "z": ("y", -1)}
"""What an axis is called where z is up, and whether it points the other way there."""
UNIT: Final[dict[Axis, str]] = {"x": "1 0 0", "y": "0 1 0", "z": "0 0 1"}
TURN_DAMPING: Final = 0.5
"""What slows a front that turns, N m s/rad: a cupboard's hinge with a damper."""
TURN_FRICTION: Final = 0.2
"""What holds it where it is, N m."""
SLIDE_DAMPING: Final = 8.0
"""What slows a drawer, N s/m: runners with rollers."""
SLIDE_FRICTION: Final = 2.0
"""What holds it where it is, N."""
LEAF_DAMPING: Final = 1.5
"""What slows a leaf, N m s/rad."""
LEAF_FRICTION: Final = 0.4
"""What holds it where it is, N m."""


class MovingPart(NamedTuple):
    """A front or a leaf as a link.

    Its name in the house, and on what it hangs; where its hinge is there, its axis and limits (degrees or m), shut at 0; its mass, kg; its
    solids, and its parts with their paints, from the hinge (parts in the scene's frame); what slows and holds it (N m s/rad, N m or N s/m,
    N); the turn of its frame about z, degrees, where it has any.
    """

    id: str
    name: str
    slides: bool
    hinge: Triple
    axis: Axis
    limits: tuple[float, float]
    mass: float
    solids: tuple[Collider, ...]
    parts: tuple[BodyPart, ...]
    paints: tuple[Paint, ...]
    damping: float
    friction: float
    turn: float | None = None

    @property
    def way(self) -> str:
        """What its joint is called after it."""
        return "slide" if self.slides else "hinge"

    @property
    def joint(self) -> str:
        """What URDF and SDF call such a joint."""
        return "prismatic" if self.slides else "revolute"

    @property
    def reach(self) -> tuple[float, float]:
        """Its limits, radians or m."""
        low, high = self.limits
        return self.limits if self.slides else (radians(low), radians(high))


class StillPart(NamedTuple):
    """What of a body does not move against it: its mass, kg, its solids, its parts and paints."""

    mass: float
    solids: tuple[Collider, ...]
    parts: tuple[BodyPart, ...]
    paints: tuple[Paint, ...]


LinkPart = MovingPart | StillPart


def still_part(body: ModelBody, carries: Collection[str]) -> StillPart:
    """Returns what of a body is not a front; `carries` are the ids of all that carry something."""
    if not body.fronts:
        return StillPart(body.mass, colliders_of(body, carries), body.parts, body.paints)
    parts, paints, solids = _still(body.parts, body.paints)
    return StillPart(body.mass - sum(_shares(body.parts, body.fronts)) * body.mass, solids, parts, paints)


def moving_parts(body: ModelBody) -> list[MovingPart]:
    """Returns the fronts of a body."""
    found = []
    for front, share in zip(body.fronts, _shares(body.parts, body.fronts), strict=True):
        axis, side = Z_UP[front.axis]
        low, high = sorted((0.0, side * front.end))
        parts, paints, solids = _moving(body.parts, body.paints, front)
        moved = front.name, front.slides, z_up(*front.hinge), axis, (low, high), share * body.mass, solids, parts, paints
        slowed = (SLIDE_DAMPING, SLIDE_FRICTION) if front.slides else (TURN_DAMPING, TURN_FRICTION)
        found.append(MovingPart(f"{body.id}/{front.name}", *moved, *slowed))
    return found


def moving_leaf(leaf: DoorLeaf) -> MovingPart:
    """Returns a leaf, which hangs on the house: it turns, or slides up."""
    slides = leaf.motion != "swing"
    low, high = sorted((0.0, leaf.height if slides else leaf.swing))
    form = leaf.mass, leaf_colliders(leaf), parts_of_hung_leaf(leaf), leaf.paints
    return MovingPart(leaf.id, leaf.id, slides, z_up(*leaf.hinge), "z", (low, high), *form, LEAF_DAMPING, LEAF_FRICTION, leaf.closed)


@lru_cache(maxsize=1 << 12)
def _still(parts: tuple[BodyPart, ...], paints: tuple[Paint, ...]) -> tuple[tuple[BodyPart, ...], tuple[Paint, ...], tuple[Collider, ...]]:
    kept = [number for number, part in enumerate(parts) if part.front is None]
    staying = tuple(parts[number] for number in kept)
    return staying, tuple(paints[number] for number in kept), tuple(map(collider_of, staying))


@lru_cache(maxsize=1 << 12)
def _moving(
    parts: tuple[BodyPart, ...], paints: tuple[Paint, ...], front: BodyFront
) -> tuple[tuple[BodyPart, ...], tuple[Paint, ...], tuple[Collider, ...]]:
    moved = tuple(_from(parts[number], front) for number in front.parts)
    return moved, tuple(paints[number] for number in front.parts), tuple(map(collider_of, moved))


def _from(part: BodyPart, front: BodyFront) -> BodyPart:
    x, y, z = (at - hinge for at, hinge in zip(part.at, front.hinge, strict=True))
    return part._replace(at=(x, y, z))


@lru_cache(maxsize=1 << 12)
def _shares(parts: tuple[BodyPart, ...], fronts: tuple[BodyFront, ...]) -> tuple[float, ...]:
    """Returns which part of its body each front weighs: that of its solids' volume."""
    volumes = shares_of(tuple(map(collider_of, parts)))
    return tuple(sum(volumes[number][0] / volumes[number][1] for number in front.parts) for front in fronts)


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


def held_fast(bodies: Sequence[ModelBody]) -> Mapping[str, HeldThing]:
    """Returns, by id, what lies in drawers and does not move by itself: in a simulator it goes with its drawer."""
    return {name: thing for name, thing in held_things(bodies).items() if thing.body.fixed}


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
