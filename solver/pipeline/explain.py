"""explain(): a piece of a generated scene -> where it was wished and what holds it back, by the multipliers of the final solve."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from typing import NamedTuple

from catalogs import Catalogs, load_catalogs
from solver.certificate import mark_of
from solver.explained import Explained, Hold
from solver.furnished import ids_of
from solver.geometry import Rect, to_m, to_mm
from solver.pieces import Arrangement, Candidate, Piece
from solver.pipeline.generate import generator, wanted_in
from solver.pipeline.other_ways import AsFurnished, other_ways
from solver.placement import SolvedRoom, arrange, finish
from solver.placement.empty_floor import FLOOR
from solver.placement.problem import ORIGIN, Choice, Confirmed, Force, ProblemBox
from solver.placement.qp import confirmed
from solver.scene import Furniture, Room, Scene
from solver.scene_bodies import check_id

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
class _Furnished:
    """A room furnished once more, and what OSQP says of it."""

    room: AsFurnished
    confirmed: Confirmed

    @property
    def solved(self) -> SolvedRoom:
        """What was solved."""
        return self.room.solved

    @property
    def ids(self) -> Mapping[str, str]:
        """The ids of the pieces by their labels."""
        return self.room.ids


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
    check_id("id", id, [piece.id for room in scene.rooms for piece in room.furniture])
    room = next(room for room in scene.rooms if any(piece.id == id for piece in room.furniture))
    piece = next(piece for piece in room.furniture if piece.id == id)
    again = _again(scene, room, catalogs or load_catalogs())
    if isinstance(again, str):
        return Explained(id, room.id, (piece.x, piece.z), None, (), (again,))
    label = next(label for label, own in again.ids.items() if own == id)
    boxes = {(box.label, box.stand): box for box in again.solved.problem.boxes}
    holds = _joined(_holds(again, boxes[label, False]))
    candidate = next(chosen.candidate for chosen in again.solved.chosen if chosen.piece.label == label)
    wished = _wished(candidate, boxes[label, False], again)
    notes = [*_notes(candidate, again)]
    if wished and not holds:
        notes.append(AT_PLACE if max(abs(wished[0] - piece.x), abs(wished[1] - piece.z)) < NEARLY_M else BALANCED)
    return Explained(id, room.id, (piece.x, piece.z), wished, holds, tuple(notes), other_ways(again.room, label))


def _again(scene: Scene, room: Room, catalogs: Catalogs) -> _Furnished | str:
    """Furnishes a room as it was made; or says why that cannot be told: it was not made here, was edited, or would be another now."""
    rooms = (scene.certificate or {}).get("rooms")
    entry = rooms.get(room.id) if isinstance(rooms, Mapping) else None
    if not isinstance(entry, Mapping) or entry.get("of") != mark_of(room):
        return CHANGED
    made_with, here = scene.generator or {}, generator(catalogs)
    for key, words in (("version", OTHER_VERSION), ("catalog", OTHER_CATALOG)):
        if made_with.get(key) != here[key]:
            return words.format(made_with.get(key), here[key])
    space, wanted, _ = wanted_in(scene, room, catalogs)
    solved = arrange(space, wanted, wide=True)
    (made,) = finish([solved], tidy=True)
    ids = ids_of(room, made, catalogs)
    if not _same(made, ids, room.furniture):
        return CHANGED
    return _Furnished(AsFurnished(space, wanted, solved, ids), confirmed([solved])[0])


def _same(made: Arrangement, ids: Mapping[str, str], furniture: Iterable[Furniture]) -> bool:
    there = {piece.id: (to_mm(2 * piece.x), to_mm(2 * piece.z), piece.rotation) for piece in furniture}
    rects = ((ids[one.label], one.footprint, one.rotation) for one in made.placed)
    return there == {name: (rect.x0 + rect.x1, rect.z0 + rect.z1, turn) for name, rect, turn in rects}


def _wished(candidate: Candidate, box: ProblemBox, again: _Furnished) -> tuple[float, float] | None:
    """Returns where the footprint's centre was wished in the room; None for a piece that has its place at another one."""
    if candidate.attach is not None:
        return None
    wish, problem = [to_m(value) for value in candidate.anchor_mm], again.solved.problem
    for axis in (0, 1):
        variable = box.var[axis]
        low, high = problem.low[axis][variable], problem.high[axis][variable]
        if low == high:  # flush at its wall
            wish[axis] = to_m(low + box.offset[axis]) + to_m(box.extent[axis]) / 2
    return round(wish[0], 4), round(wish[1], 4)


def _notes(candidate: Candidate, again: _Furnished) -> Iterable[str]:
    if candidate.wall:
        yield f"its back is at the {candidate.wall} wall"
    if candidate.attach is not None:
        parent = again.ids.get(candidate.attach.parent, candidate.attach.parent)
        yield f"it has its place at {parent}"


def _holds(again: _Furnished, body: ProblemBox) -> Iterable[Hold]:
    """Yields what holds a body's variables, or those of what it moves with."""
    boxes = again.solved.problem.boxes
    for axis in (0, 1):
        mine = {body.var[axis]} | {box.var[axis] for box in boxes if box.label == body.label}
        for force in again.confirmed.forces:
            row = force.row
            if row.axis != axis or (row.i in mine) == (row.j in mine):
                continue  # of others, or between the body and its own use side
            towards = TOWARDS[axis][0 if row.j in mine else 1]
            variable = row.j if row.j in mine else row.i
            yield _hold(again, force, towards, [box for box in boxes if box.var[axis] == variable])


def _hold(again: _Furnished, force: Force, towards: str, held: list[ProblemBox]) -> Hold:
    holder = _holder(again, force, towards, held)
    return Hold(holder.by, holder.what, towards, force.per_m, f"kept from going further {towards} by {holder.words}")


def _holder(again: _Furnished, force: Force, towards: str, held: list[ProblemBox]) -> _Holder:
    problem, space = again.solved.problem, again.solved.space
    if force.choice is not None and force.choice < len(problem.choices):
        return _chosen_holder(again, problem.choices[force.choice], {(box.label, box.stand) for box in held})
    if force.choice is not None:
        return _A_WAY
    if not force.bound:
        variables = {force.row.i, force.row.j}
        other = next((box.label for box in problem.boxes if box.var[force.row.axis] in variables and box not in held), None)
        name = None if other is None or ORIGIN in variables else again.ids.get(other)
        return _Holder("relation", name, f"its relation to {name}") if name else _A_WAY
    if any(_meets(box, force, towards, space.clear, space.gap_mm) for box in held):
        return _Holder("wall", None, f"the {towards} wall")
    return _Holder("relation", None, "what its relations ask for")


def _chosen_holder(again: _Furnished, choice: Choice, mine: Collection[tuple[str, bool]]) -> _Holder:
    """Returns the other side of a choice: a piece, the floor to use one, or what a room keeps free."""
    space, one = again.solved.space, (choice.first, choice.stands[0])
    other, stand = (choice.second, choice.stands[1]) if one in mine else one
    if other in again.ids:
        name = again.ids[other]
        return _Holder("use_side", name, f"the floor that a person needs to use {name}") if stand else _Holder("piece", name, name)
    if other == "outline":
        return _Holder("outline", None, "a part of the wall that stands out")
    floor = next((piece for piece in again.room.wanted if piece.label == other), None)
    if floor is not None:
        return _floor_holder(floor, again.ids)
    if other == FLOOR:
        return _A_WAY
    what = "door" if any(doorway.id == other for doorway in space.doorways) else "window"
    return _Holder(what, other, f"the floor before {other}")


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
