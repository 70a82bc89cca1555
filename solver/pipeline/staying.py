"""What stays in a room that is furnished anew: its locked pieces, and what carries them or has them under it.

Around it new pieces are placed: it does not move, as pieces with one way each. Not here: placing (generate).

A piece that stays takes the place of the wanted piece that it could be, so that the others relate to it: the coffee table goes
before the locked sofa. One that could be none is wanted besides.
"""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from catalogs import Catalogs
from catalogs.entries import Side
from solver.errors import SceneError
from solver.free_floor import HEADROOM_MM
from solver.free_places import footprint, rounded_mm
from solver.geometry import to_mm
from solver.pieces import Arrangement, Candidate, Link, Piece, Placed, Space, Stance, Stand, Zone
from solver.placement import walkable_when_empty, with_joined_doors
from solver.repair import Body, all_bodies, as_it_stands, floor_bodies, root_of
from solver.scene import Decoration, Furniture, Room


@dataclass(frozen=True)
class Staying:
    """The pieces that stay in a room as it was, with those alone, and what lies on them.

    `labels` say under which label each is wanted, by id.
    """

    room: Room
    things: tuple[Decoration, ...] = ()
    labels: Mapping[str, str] = field(default_factory=dict)

    @property
    def ids(self) -> tuple[str, ...]:
        """Ids of the pieces."""
        return tuple(piece.id for piece in self.room.furniture)

    @property
    def locked(self) -> tuple[str, ...]:
        """Ids of those that are locked."""
        return tuple(piece.id for piece in self.room.furniture if piece.locked)

    def are_in(self, arrangement: Arrangement) -> bool:
        """Tells whether all that stays was found a place with the rest."""
        return set(self.labels.values()) <= {one.label for one in arrangement.placed}

    def new_in(self, arrangement: Arrangement) -> tuple[Placed, ...]:
        """Returns what an arrangement places besides."""
        return tuple(one for one in arrangement.placed if one.label not in self.labels.values())


def staying_in(room: Room) -> Staying:
    """Returns what stays in a room: what is locked, what carries that, the tables of locked chairs; and what lies on all these."""
    pieces = {piece.id: piece for piece in room.furniture}
    stays, more = set[str](), {piece.id for piece in room.furniture if piece.locked}
    while more:
        stays |= more
        more = {below for label in more for below in (pieces[label].on, pieces[label].under) if below in pieces and below} - stays
    carriers = _carriers(room.decorations)
    lying = tuple(thing for thing in room.decorations if root_of(thing.id, carriers) in stays)
    return Staying(replace(room, furniture=tuple(piece for piece in room.furniture if piece.id in stays), decorations=()), lying)


def _carriers(things: Iterable[Decoration]) -> dict[str, str]:
    """Returns what carries each thing that does not hang, by its id."""
    return {thing.id: thing.parent for thing in things if thing.parent is not None and thing.mounted_on_wall is None}


def around(staying: Staying, space: Space, wanted: Sequence[Piece], catalogs: Catalogs) -> tuple[Staying, Space, tuple[Piece, ...]]:
    """Returns a room's wanted pieces, as for an empty room, around those that stay."""
    blocked, standing = obstacles(staying.room, space, catalogs)
    blocked = replace(blocked, zones=space.zones)  # what stands is in the way as pieces, not as walls
    sent = {piece.id: piece for piece in staying.room.furniture}
    takes = _matched(staying.room.furniture, wanted, catalogs)
    names = {piece.label for piece in wanted}
    own = {one.label: f"{one.label} as it stands" if one.label in names else one.label for one in standing}
    labels = {label: takes.get(label, (name, None))[0] for label, name in own.items()}
    fixed = {}
    for one in standing:
        kind = takes.get(one.label, ("", None))[1]
        way = _told(one.candidates[0], sent[one.label], space, labels)
        way = replace(way, kind=kind, stance=None) if kind else way
        fixed[labels[one.label]] = replace(one, label=labels[one.label], candidates=(way,))
    gone = {label for label, _ in takes.values()} - fixed.keys()
    pieces = [_taken(piece, fixed.get(piece.label)) for piece in wanted if piece.label not in gone]
    besides = [one for label, one in fixed.items() if label not in names]
    ordered = sorted([*besides, *pieces], key=lambda piece: not piece.required)
    return replace(staying, labels=labels), blocked, _linked(ordered, frozenset(fixed))


def _matched(pieces: Sequence[Furniture], wanted: Sequence[Piece], catalogs: Catalogs) -> dict[str, tuple[str, str | None]]:
    """Returns which wanted piece each piece could be, by id, and of which kind; those of its very size first."""
    found: dict[str, tuple[str, str | None]] = {}
    names = {way.kind: catalogs.name_of(way.kind) for one in wanted for way in one.candidates}
    ways = [(one.label, [(names[way.kind], way.size_mm, way.kind) for way in one.candidates]) for one in wanted]
    kinds = [(label, {(name, size): kind for name, size, kind in reversed(own)}, {name for name, _, _ in own}) for label, own in ways]
    for exact in (True, False):
        for piece in pieces:
            size = (to_mm(piece.width), to_mm(piece.depth), to_mm(piece.height)) if exact and piece.rotation % 90 == 0 else None
            taken = {label for label, _ in found.values()}
            for label, sized, named in kinds if piece.id not in found and (size or not exact) else ():
                if label not in taken and ((piece.name, size) in sized if size else piece.name in named):
                    found[piece.id] = (label, sized[piece.name, size] if size else None)
                    break
    return found


def _told(way: Candidate, piece: Furniture, space: Space, labels: Mapping[str, str]) -> Candidate:
    """Returns a piece's one way with the labels of what it stands on or under, and the wall it says its back is at."""
    on, under = labels.get(way.on or ""), labels.get(way.under or "")
    away = -1 if piece.wall is None else footprint(piece).wall_distance(piece.wall, space.clear)
    if away < 0:
        return replace(way, on=on, under=under)
    return replace(way, on=on, under=under, wall=piece.wall, slack_mm=away)


def _taken(piece: Piece, fixed: Piece | None) -> Piece:
    """Returns a wanted piece that is there already: as it stands, with the relations it would like to have."""
    if fixed is None:
        return piece
    return replace(fixed, links=tuple(replace(link, required=False) for link in piece.links))


def _linked(ordered: Sequence[Piece], fixed: Collection[str]) -> tuple[Piece, ...]:
    """Returns the pieces in that order, those that stay with their relations to earlier ones alone."""
    earlier, found = set[str](), list[Piece]()
    for piece in ordered:
        links: tuple[Link, ...] = tuple(link for link in piece.links if piece.label not in fixed or link.of in earlier)
        found.append(replace(piece, links=links))
        earlier.add(piece.label)
    return tuple(found)


def rejoined(made: Sequence[Furniture], placed: Sequence[Placed], staying: Staying) -> Room:
    """Returns a room with what stays as it was, and new pieces, where they were placed, under ids that differ from it."""
    new = _free_ids([piece.id for piece in made], {*staying.ids, *(thing.id for thing in staying.things)})
    ids = {label: name for name, label in staying.labels.items()}
    ids |= {one.label: new[piece.id] for one, piece in zip(placed, made, strict=True)}
    named = [
        replace(piece, id=new[piece.id], under=ids.get(one.chosen.under or ""), on=ids.get(one.chosen.on or ""))
        for one, piece in zip(placed, made, strict=True)
    ]
    return replace(staying.room, furniture=(*staying.room.furniture, *named))


def with_things(room: Room, staying: Staying) -> Room:
    """Returns a decorated room with what lay on the pieces that stay; where something new stands on one, what lies there is new."""
    anew = {piece.on for piece in room.furniture if piece.id not in staying.ids}
    carriers = _carriers(staying.things)
    stays = tuple(thing for thing in staying.things if root_of(thing.id, carriers) not in anew)
    on = set(staying.ids) - {label for label in anew if label}
    carriers = _carriers(room.decorations)
    fresh = [thing for thing in room.decorations if root_of(thing.id, carriers) not in on]
    ids = _free_ids([thing.id for thing in fresh], {thing.id for thing in stays})
    renamed = (replace(thing, id=ids[thing.id], parent=ids.get(thing.parent or "", thing.parent)) for thing in fresh)
    return replace(room, decorations=(*stays, *renamed))


def _free_ids(ids: Sequence[str], taken: Collection[str]) -> dict[str, str]:
    """Returns for each id itself, or where it is taken the next free number behind its name."""
    used, found = {*taken, *ids}, {}
    for label in ids:
        stem, _, last = label.rpartition("_")
        number = int(last) if last.isdecimal() else 1
        new = label
        while new in taken or (new != label and new in used):
            number += 1
            new = f"{stem}_{number}"
        used.add(new)
        found[label] = new
    return found


def refuse(asked: Sequence[str], stays: Mapping[str, Staying], wrong: Collection[str | None]) -> None:
    """Refuses rooms in which nothing valid was found around what is locked.

    Raises:
        SceneError: names the room and what is locked in it.
    """
    for k, name in enumerate(asked):
        if name in wrong and name in stays:
            ids = ", ".join(stays[name].locked)
            problem = f"room {name} holds locked pieces: {ids}; no valid way to furnish the rest around them was found"
            raise SceneError(f"reroll[{k}]", problem, "another room; or unlock them first")


def obstacles(room: Room, space: Space, catalogs: Catalogs, entrances: Collection[str] = ()) -> tuple[Space, tuple[Piece, ...]]:
    """Returns the space around what stands in a room, and what stands there, which does not move, as pieces with one way each.

    All of it can stay: what nobody can come to already is not asked for. Those doors are joined that are; of the `entrances`, by id, where
    not all doors are, any is enough. Where nobody can be at all, nobody is asked for.
    """
    loose = {body.id for body in floor_bodies(room)}
    bodies = [body for body in all_bodies(room) if body.id in loose or (isinstance(body, Furniture) and body.on is not None)]
    bodies.sort(key=lambda body: isinstance(body, Furniture) and (body.on or body.under) is not None)
    named, used = {body.id for body in bodies}, catalogs.use_sides()
    low = [footprint(body) for body in bodies if body.y * 1000 < HEADROOM_MM]
    taken = replace(space, zones=(*space.zones, *(Zone(rect, -1, "outline") for rect in low)))
    if not walkable_when_empty(taken):
        doors = (door._replace(walked="in") if door.id in entrances else door for door in space.doorways)
        taken = with_joined_doors(replace(taken, doorways=tuple(doors)), entrances)
    if not walkable_when_empty(taken):
        taken = replace(taken, doorways=tuple(door._replace(walked="not") for door in space.doorways))
    held = [_held(body, named, used.get(body.name, ((), False))) for body in bodies]
    there = held if walkable_when_empty(taken, held) else [replace(piece, stands=()) for piece in held]
    for k, piece in enumerate(held):
        if piece is not there[k] and piece.stands and walkable_when_empty(taken, more := [*there[:k], piece, *there[k + 1 :]]):
            there = more
    return replace(space, doorways=taken.doorways) if walkable_when_empty(taken) else taken, tuple(there)


def _held(body: Body, named: set[str], use: tuple[tuple[Side, ...], bool]) -> Piece:
    """Returns a body as a piece that stays as it stands; `use` tells its use sides, and whether all are needed."""
    way = as_it_stands(body)
    way = replace(way, kind=body.name, stance=Stance(way.rotation, bottom_mm=way.bottom_mm))
    if not isinstance(body, Furniture):
        return Piece(body.id, True, (way,), is_there=True)
    under, on = (label if label in named else None for label in (body.under, body.on))
    stands = tuple(Stand(side, rounded_mm(body)) for side in use[0])
    return Piece(body.id, True, (replace(way, under=under, on=on),), stands=stands, need_all=use[1], is_there=True)
