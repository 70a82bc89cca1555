"""One request of place and its answers: what the request means to every stage, and an arrangement written down and judged.

Comes in: a Room and Wishes; an Arrangement. Goes out: Terms; a Placement. May import: every stage. Not here: which arrangement
(rounds, place).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from catalogs import Catalogs
from solver.certificate import room_certificate
from solver.furnish import Asked, asked_pieces, space_of
from solver.furnished import furnished
from solver.geometry import WALL_BEHIND, Rect
from solver.pipeline.obstacles import obstacles
from solver.relations_held import Judged, Standing, held, judged
from solver.requested import (
    Held,
    Placement,
    Unplaced,
    Wish,
    checked,
    in_order,
    kind_of,
    kinds_for,
    labels_by_name,
    pieces_of,
    relations_of,
)
from solver.scene import Furniture, Room, Scene
from solver.streams import Stream
from solver.validate import RULES, validate
from solver.wanted import Arrangement, Placed, Space, Wanted


@dataclass(frozen=True)
class Terms:
    """What every placement of one request shares."""

    room: Room
    wishes: tuple[Wish, ...]
    catalogs: Catalogs
    wall_thickness: float
    robot_width: float
    engine: str
    space: Space
    asked: Asked
    names: Mapping[str, Sequence[str]]
    """The ids that each name of an `of` stands for."""
    heights: Mapping[str, Sequence[float]]
    """Heights of the surfaces of a body above its underside, by id, m."""
    bare: Judged
    """The room before anything is placed, to be judged."""

    @property
    def wanted(self) -> tuple[Wanted, ...]:
        """The wanted pieces, each after those it refers to, behind those that stand already."""
        return self.asked.wanted


def terms_of(room: Room, pieces: Sequence[Wish], known: Catalogs, setting: tuple[float, float, str]) -> Terms:
    """Checks a request and says what it means.

    Args:
        room: with what stands in it.
        pieces: what is wanted.
        known: the catalogs.
        setting: wall thickness, m; the square that must be able to walk, m; the engine of the final solve.

    Raises:
        RequestError: a field is wrong.
    """
    wall_thickness, robot_width, engine = setting
    wishes = in_order(checked(room, pieces, known))
    catalogs = kinds_for(room, wishes, known)
    space, standing = obstacles(room, space_of(room, wall_thickness, robot_width), catalogs)
    asked = asked_pieces(room, space, catalogs, pieces_of(wishes), standing)
    names = labels_by_name(room, wishes)
    heights = {
        label: tuple(surface.height for surface in catalogs.furniture[kind_of(name)].surfaces)
        for name, labels in names.items()
        for label in labels
    }
    bare = judged(room, wall_thickness, names, heights)
    return Terms(room, wishes, catalogs, wall_thickness, robot_width, engine, space, asked, names, heights, bare)


def finished(terms: Terms, arrangement: Arrangement) -> Placement:
    """Writes an arrangement down and judges it."""
    room = _written(terms, arrangement)
    scene = Scene(
        request={"robot_width": terms.robot_width},
        wall_thickness=terms.wall_thickness,
        rooms=(room,),
        certificate={"rules": list(RULES), "rooms": {room.id: room_certificate(arrangement, room)}},
    )
    stands = {piece.id for piece in terms.room.furniture}
    unplaced = tuple(Unplaced(label, reason) for label, reason in arrangement.left_out if label not in stands)
    return Placement(scene, _report(terms, room), unplaced, arrangement.cost, validate(scene, terms.catalogs))


def _written(terms: Terms, arrangement: Arrangement) -> Room:
    """Returns the room with what stands in it as sent, and the placed pieces under their own ids."""
    wished = {label for wish in terms.wishes for label in wish.labels}
    fresh = [
        replace(one, chosen=replace(one.chosen, kind=one.chosen.kind.rpartition("@")[0]))
        for one in arrangement.placed
        if one.label in wished
    ]
    stream = Stream(0, "colour", terms.room.index)
    made = furnished(terms.room, replace(arrangement, placed=tuple(fresh)), terms.catalogs, stream).furniture
    called = (_called(terms, piece, one) for piece, one in zip(made, fresh, strict=True))
    return replace(terms.room, furniture=(*terms.room.furniture, *called))


def _called(terms: Terms, piece: Furniture, placed: Placed) -> Furniture:
    """Gives a piece its own id, and its wall where its kind hugs one and its back is at it."""
    chosen, wall = placed.chosen, placed.wall
    if wall is None and terms.catalogs.furniture[chosen.kind].stands == "wall" and chosen.on is None:
        behind = WALL_BEHIND[placed.rotation]
        wall = behind if _distance(terms.space.clear, placed.footprint, behind) <= terms.space.gap_mm else None
    return replace(piece, id=placed.label, under=chosen.under, on=chosen.on, wall=wall)


def _distance(clear: Rect, rect: Rect, wall: str) -> int:
    return {
        "north": rect.z0 - clear.z0, "south": clear.z1 - rect.z1, "west": rect.x0 - clear.x0, "east": clear.x1 - rect.x1,
    }[wall]  # fmt: skip


def lost(terms: Terms, arrangement: Arrangement) -> list[tuple[str, float]]:
    """Judges an arrangement that is not written down: returns (piece, what it is worth) of every relation that is not held."""
    seen = replace(terms.bare, bodies={**terms.bare.bodies, **{one.label: _stands(one) for one in arrangement.placed}})
    heights = {
        one.label: [one.chosen.bottom_mm + round(height * 1000) for height in terms.heights[one.label]]
        for one in arrangement.placed
        if one.label in terms.heights
    }
    seen = replace(seen, surfaces={**terms.bare.surfaces, **heights})
    return [(label, rule.cost) for label, rule in relations_of(terms.wishes) if not held(seen, label, rule)[0]]


def _stands(one: Placed) -> Standing:
    return Standing(one.label, one.footprint, one.rotation, one.chosen.bottom_mm, one.chosen.on)


def _report(terms: Terms, room: Room) -> tuple[Held, ...]:
    """Judges every relation that was asked for in a finished room."""
    seen = judged(room, terms.wall_thickness, terms.names, terms.heights)
    report = []
    for label, rule in relations_of(terms.wishes):
        holds, of = held(seen, label, rule)
        report.append(Held(label, rule.type, of, holds))
    return tuple(report)
