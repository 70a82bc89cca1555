"""explain(): a piece of a generated scene -> where it was wished and what holds it back, by the multipliers of the final solve.

What its other ways to stand would have cost: the room is furnished once more with only that way left.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf
from typing import NamedTuple

from catalogs import Catalogs, load_catalogs
from solver.answers import Explained, Hold, MovedPiece, OtherWay
from solver.certificate import mark_of
from solver.furnished import ids_of
from solver.geometry import Rect, to_m, to_mm
from solver.pieces import Arrangement, Candidate, Piece, Placed, Space
from solver.pipeline.generate import generator, wanted_in
from solver.placement import OpenRoom, arrange, is_call_spent, opened
from solver.placement.empty_floor import FLOOR
from solver.placement.problem import ORIGIN, Choice, Force, ProblemBox
from solver.scene import Furniture, Room, Scene
from solver.scene_bodies import check_id, check_scene

TOWARDS = (("west", "east"), ("north", "south"))
"""The directions of smaller and greater coordinates, by axis."""
LEAST_SHOWN = 0.02
"""Holds of less cost a metre are not worth a line."""
CHANGED = "the room is not as it was made: the piece stands where it was put"
OTHER_CATALOG = "made with another catalog: its fingerprint is {}, that of the catalog here {}"
OTHER_VERSION = "made with another version of Compose: {}, this is {}"
AT_PLACE = "it stands where it was wished"
BALANCED = "nothing holds it: it stands where what draws it is in balance"
NEARLY_M = 0.015
"""A piece this close to its wish, m, is there: slivers may have been tidied away since."""


@dataclass(frozen=True)
class AsFurnished:
    """A room furnished once more as it was: what was wanted, what came of it, and the ids of its pieces by their labels."""

    space: Space
    wanted: Sequence[Piece]
    made: OpenRoom
    ids: Mapping[str, str]


class _Holder(NamedTuple):
    """What a force comes from: its sort, its id where it has one, and words for it."""

    what: str
    by: str | None
    words: str


_A_WAY = _Holder("way", None, "a way that a person needs")


def explain(scene: Scene, id: str, *, catalogs: Catalogs | None = None) -> Explained:
    """Says where a piece was wished, what holds it back from there, and what its other ways to stand would have cost.

    The room is furnished once more as it was made. Where that does not give the pieces of the scene, because it was edited, comes
    from elsewhere, or was made with another catalog or version, there is nothing that was wished, and a note says which.

    Args:
        scene: a generated scene.
        id: of a piece of furniture.
        catalogs: what it was furnished with; ours by default.

    Raises:
        SceneError: no piece has the id.

    Example:
        >>> from compose_homes import Request, explain, generate
        >>> house = generate(Request(seed=42, width=7, depth=5)).scene
        >>> explain(house, house.rooms[0].furniture[0].id).room == house.rooms[0].id
        True
    """
    check_scene(scene)
    check_id("id", id, [piece.id for room in scene.rooms for piece in room.furniture])
    room = next(room for room in scene.rooms if any(piece.id == id for piece in room.furniture))
    piece = next(piece for piece in room.furniture if piece.id == id)
    again = _again(scene, room, catalogs or load_catalogs())
    if isinstance(again, str):
        return Explained(id, room.id, (piece.x, piece.z), None, (), (again,))
    label = next(label for label, own in again.ids.items() if own == id)
    boxes = {(box.label, box.stand): box for box in again.made.boxes}
    holds = _joined(_holds(again, boxes[label, False]))
    candidate = next(placed.chosen for placed in again.made.solved.arrangement.placed if placed.label == label)
    wished = _wished(candidate, boxes[label, False], again)
    notes = [*_notes(candidate, again)]
    if wished and not holds:
        notes.append(AT_PLACE if max(abs(wished[0] - piece.x), abs(wished[1] - piece.z)) < NEARLY_M else BALANCED)
    return Explained(id, room.id, (piece.x, piece.z), wished, holds, tuple(notes), other_ways(again, label))


def _again(scene: Scene, room: Room, catalogs: Catalogs) -> AsFurnished | str:
    """Furnishes a room as it was made; or says why that cannot be told: it was not made here, was edited, or would be another now."""
    rooms = (scene.certificate or {}).get("rooms")
    entry = rooms.get(room.id) if isinstance(rooms, Mapping) else None
    if not isinstance(entry, Mapping) or entry.get("of") != mark_of(room) or scene.generator is None:
        return CHANGED
    made_with, here = scene.generator, generator(catalogs)
    for key, words in (("version", OTHER_VERSION), ("catalog", OTHER_CATALOG)):
        if made_with.get(key) != here[key]:
            return words.format(made_with.get(key), here[key])
    space, wanted = wanted_in(scene, room, catalogs)
    made = opened(space, wanted, wide=True, tidy=True)
    ids = ids_of(room, made.solved.arrangement, catalogs)
    if not _same(made.solved.arrangement, ids, room.furniture):
        return CHANGED
    return AsFurnished(space, wanted, made, ids)


def _same(made: Arrangement, ids: Mapping[str, str], furniture: Iterable[Furniture]) -> bool:
    there = {piece.id: (to_mm(2 * piece.x), to_mm(2 * piece.z), piece.rotation) for piece in furniture}
    rects = ((ids[one.label], one.footprint, one.rotation) for one in made.placed)
    return there == {name: (rect.x0 + rect.x1, rect.z0 + rect.z1, turn) for name, rect, turn in rects}


def _wished(candidate: Candidate, box: ProblemBox, again: AsFurnished) -> tuple[float, float] | None:
    """Returns where the footprint's centre was wished in the room; None for a piece that has its place at another one."""
    if candidate.attach is not None:
        return None
    wish, work = [to_m(value) for value in candidate.anchor_mm], again.made.engine.work
    for axis in (0, 1):
        variable = box.var[axis]
        low, high = int(work.low[axis, variable]), int(work.high[axis, variable])
        if low == high:  # flush at its wall
            wish[axis] = to_m(low + box.offset[axis]) + to_m(box.extent[axis]) / 2
    return round(wish[0], 4), round(wish[1], 4)


def _notes(candidate: Candidate, again: AsFurnished) -> Iterable[str]:
    if candidate.wall:
        yield f"its back is at the {candidate.wall} wall"
    if candidate.attach is not None:
        parent = again.ids.get(candidate.attach.parent, candidate.attach.parent)
        yield f"it has its place at {parent}"


def _holds(again: AsFurnished, body: ProblemBox) -> Iterable[Hold]:
    """Yields what holds a body's variables, or those of what it moves with."""
    boxes = again.made.boxes
    for axis in (0, 1):
        mine = {body.var[axis]} | {box.var[axis] for box in boxes if box.label == body.label}
        for force in again.made.forces:
            row = force.row
            if row.axis != axis or (row.i in mine) == (row.j in mine):
                continue  # of others, or between the body and its own use side
            towards = TOWARDS[axis][0 if row.j in mine else 1]
            variable = row.j if row.j in mine else row.i
            yield _hold(again, body, force, towards, [box for box in boxes if box.var[axis] == variable])


def _hold(again: AsFurnished, body: ProblemBox, force: Force, towards: str, held: list[ProblemBox]) -> Hold:
    holder, mine = _holder(again, force, towards, held)
    owner, reason = (body.label, "") if mine is None else _felt_at(again, mine)
    along = f" with {again.ids[owner]}" if owner != body.label and owner in again.ids else ""
    message = f"kept{along} from going further {towards} by {holder.words}{reason}"
    return Hold(holder.by, holder.what, towards, force.per_m, message)


def _felt_at(again: AsFurnished, mine: tuple[str, bool]) -> tuple[str, str]:
    """Returns the label of the piece that a force is felt at; and why, where it is felt at floor beside that piece."""
    label, stand = mine
    floor = next((piece for piece in again.wanted if piece.label == label and piece.is_floor), None)
    if floor is not None and floor.candidates[0].attach is not None:
        owner = floor.candidates[0].attach.parent
        return owner, f", as floor at {again.ids[owner]} is better kept free"
    return label, f", as a person needs floor at {again.ids[label]}" if stand else ""


def _holder(again: AsFurnished, force: Force, towards: str, held: list[ProblemBox]) -> tuple[_Holder, tuple[str, bool] | None]:
    """Returns what a force comes from, and the box, of a piece and its floor, that it is felt at, where that is known."""
    made, space = again.made, again.space
    if force.choice is not None and force.choice < len(made.choices):
        return _chosen_holder(again, made.choices[force.choice], {(box.label, box.stand) for box in held})
    if force.choice is not None:
        return _A_WAY, None
    if not force.bound:
        variables = {force.row.i, force.row.j}
        other = next((box.label for box in made.boxes if box.var[force.row.axis] in variables and box not in held), None)
        name = None if other is None or ORIGIN in variables else again.ids.get(other)
        return (_Holder("relation", name, f"its relation to {name}") if name else _A_WAY), None
    meeting = next((box for box in held if _meets(box, force, towards, space.clear, space.gap_mm)), None)
    if meeting is not None:
        return _Holder("wall", None, f"the {towards} wall"), (meeting.label, meeting.stand)
    return _Holder("relation", None, "what its relations ask for"), None


def _chosen_holder(again: AsFurnished, choice: Choice, mine: Collection[tuple[str, bool]]) -> tuple[_Holder, tuple[str, bool]]:
    """Returns the other side of a choice: a piece, the floor to use one, or what a room keeps free; and which box of ours it is felt at."""
    space, one, two = again.space, (choice.first, choice.stands[0]), (choice.second, choice.stands[1])
    own, (other, stand) = (one, two) if one in mine else (two, one)
    if other in again.ids:
        name = again.ids[other]
        return (_Holder("use_side", name, f"the floor that a person needs to use {name}") if stand else _Holder("piece", name, name)), own
    if other == "outline":
        return _Holder("outline", None, "a part of the wall that stands out"), own
    floor = next((piece for piece in again.wanted if piece.label == other), None)
    if floor is not None:
        return _floor_holder(floor, again.ids), own
    if other == FLOOR:
        return _A_WAY, own
    what = "door" if any(doorway.id == other for doorway in space.doorways) else "window"
    return _Holder(what, other, f"the floor before {other}"), own


def _floor_holder(floor: Piece, ids: Mapping[str, str]) -> _Holder:
    """Returns floor that is better kept free; where it lies at a side of a piece, by the piece's id."""
    words = f"{floor.label}, which is better kept free"
    owner = floor.candidates[0].attach
    if owner is None:
        return _Holder("floor", None, words)
    return _Holder("floor", ids[owner.parent], words.replace(owner.parent, ids[owner.parent], 1))


def _meets(box: ProblemBox, force: Force, towards: str, clear: Rect, gap_mm: int) -> bool:
    """Tells whether a bound that holds a box is the wall in that direction."""
    axis = force.row.axis
    near = towards in ("north", "west")
    edge = force.row.s + box.offset[axis] if near else -force.row.s + box.offset[axis] + box.extent[axis]
    return abs(edge - clear.line(towards)) <= gap_mm


def _joined(holds: Iterable[Hold]) -> tuple[Hold, ...]:
    """Adds up what one and the same thing holds in one direction, the strongest first."""
    sums: dict[tuple[str | None, str, str, str], float] = {}
    for hold in holds:
        key = (hold.by, hold.what, hold.towards, hold.message)
        sums[key] = sums.get(key, 0.0) + hold.cost_per_m
    found = [Hold(*key[:3], round(cost, 2), f"{key[3]}: {cost:.2f} a metre") for key, cost in sums.items() if cost >= LEAST_SHOWN]
    return tuple(sorted(found, key=lambda hold: -hold.cost_per_m))


MOST_WAYS = 8
"""At most so many other ways are tried: the ones that the piece itself likes best."""
FAR_MM = 20
"""A piece that would stand farther away than this is named."""
FACING = {0: "south", 90: "east", 180: "north", 270: "west"}
"""Where a front looks, by rotation."""

_Stance = tuple[str | None, int]


def other_ways(room: AsFurnished, label: str) -> tuple[OtherWay, ...]:
    """Returns the other walls and rotations that a piece may take, each with what the room would have cost with it, cheapest first.

    A piece that has its place at another one has no other ways; nor are ways tried once a call's work is spent.
    """
    piece = next(piece for piece in room.wanted if piece.label == label)
    before = {placed.label: placed for placed in room.made.solved.arrangement.placed}
    now = before[label].chosen
    if now.attach is not None:
        return ()
    liked: dict[_Stance, float] = {}
    for candidate in piece.candidates:
        if candidate.attach is None and _stance(candidate) != _stance(now):
            liked[_stance(candidate)] = min(candidate.cost, liked.get(_stance(candidate), candidate.cost))
    found = []
    for stance in sorted(liked, key=lambda one: (liked[one], str(one)))[:MOST_WAYS]:
        if is_call_spent():
            break
        found.append(_tried(room, piece, stance, before))
    return tuple(sorted(found, key=lambda way: (way.cost is None, way.cost or 0.0)))


def _stance(candidate: Candidate) -> _Stance:
    return candidate.wall, candidate.rotation


def _tried(room: AsFurnished, piece: Piece, stance: _Stance, before: Mapping[str, Placed]) -> OtherWay:
    """Furnishes the room with a piece that may stand in one way only."""
    only = replace(piece, candidates=tuple(one for one in piece.candidates if one.attach is None and _stance(one) == stance))
    solved = arrange(room.space, [only if one.label == piece.label else one for one in room.wanted], wide=True, tidy=True)
    placed = {one.label: one for one in solved.arrangement.placed}
    words = _words(stance)
    if piece.label not in placed:
        return OtherWay(stance[0], stance[1], None, (), (), f"{words}: no place was found for it so")
    gone = tuple(room.ids[label] for label in before if label not in placed)
    moves = tuple(_moved(room.ids, one) for label, one in placed.items() if label in before and _distance(before[label], one) > 0)
    far = [label for label, one in placed.items() if label in before and _distance(before[label], one) > FAR_MM]
    others = [room.ids[label] for label in far if label != piece.label]
    cost = round(solved.cost - room.made.solved.cost, 2)
    return OtherWay(stance[0], stance[1], cost, moves, gone, f"{words}: {_said(cost, gone)}{_consequences(others, gone)}")


def _words(stance: _Stance) -> str:
    wall, rotation = stance
    facing = FACING.get(rotation, f"{rotation} degrees")
    return f"with its back at the {wall} wall" if wall else f"away from the walls, its front to the {facing}"


def _said(cost: float, gone: Sequence[str]) -> str:
    """Returns what a way costs in words. Pieces are decided one after another: what is cheapest for the first need not be in all."""
    if cost >= 0:
        return f"{cost:.2f} more"
    return f"{-cost:.2f} less" if gone else f"{-cost:.2f} less in all, though not for what is decided first"


def _consequences(others: Sequence[str], gone: Sequence[str]) -> str:
    moved = f"; {_several(others)} would stand elsewhere" if others else ""
    return moved + (f"; {_several(gone)} would be left out" if gone else "")


def _several(names: Sequence[str]) -> str:
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _moved(ids: Mapping[str, str], placed: Placed) -> MovedPiece:
    rect, way = placed.footprint, placed.chosen
    x, z = round(to_m(rect.x0 + rect.x1) / 2, 4), round(to_m(rect.z0 + rect.z1) / 2, 4)
    on = None if way.on is None else ids.get(way.on)
    width, depth, height = map(to_m, way.size_mm)
    return MovedPiece(ids[placed.label], way.kind, x, to_m(way.bottom_mm), z, placed.rotation, width, depth, height, on)


def _distance(a: Placed, b: Placed) -> float:
    """How far a piece would be moved, mm; without end where it is turned, of another size or on another piece."""
    one, other = a.footprint, b.footprint
    if (a.rotation, a.chosen.size_mm, a.chosen.on) != (b.rotation, b.chosen.size_mm, b.chosen.on):
        return inf
    return max(abs(one.x0 - other.x0), abs(one.z0 - other.z0))
