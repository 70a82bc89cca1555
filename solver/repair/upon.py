"""Furniture that floats -> on what carries it, by the shortest way, or down on the floor.

Comes in: a sent Room, its Space, and which of its pieces float. Goes out: the Room; what lies on such a piece comes along. May import: the
ground floor, catalogs.

A piece comes back over what it says it stands on where that is near (it is over part of it still), where it was moved away from
under the piece, and where its kind stands on other pieces alone, as room types' rules tell. Else it is set down where it is. One
that is over another piece of a kind that carries it stands on that one from now on.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from catalogs import Catalogs
from catalogs.schema import Piece, RoomType
from solver.free_places import footprint, nearest_place
from solver.geometry import Rect, to_mm
from solver.repair.bodies import above, carried_along, climb, size_of, squared
from solver.repair.resting import surfaces_of
from solver.scene import Furniture, Room
from solver.wanted import Space, Zone

MOST_BESIDE = 20
"""Pieces on a carrier beside which a place for another is sought; on a fuller one they stand in each other."""


@dataclass(frozen=True)
class _Known:
    """What decides where a room's floating pieces go.

    Args:
        zones: of the room, where what is too tall is in the way.
        moved: ids of what was just moved.
        perches: by name of a piece, the names of what carries it by some room type's rules.
        bound: names of pieces that no room type wants elsewhere than on another.
        catalogs: where the surfaces of known kinds are.
    """

    zones: Sequence[Zone]
    moved: Container[str]
    perches: Mapping[str, frozenset[str]]
    bound: Container[str]
    catalogs: Catalogs


def put_upon(room: Room, space: Space, floating: Collection[str], moved: Container[str], catalogs: Catalogs) -> Room:
    """Returns the room with the furniture of those ids where something carries it; the way there is the shortest.

    What stands on something already goes where on it there is room.

    A ring of pieces that stand on each other is opened: the first of them stands on the floor.

    Args:
        room: as sent.
        space: what its doors and windows keep free.
        floating: ids.
        moved: ids of what was just moved.
        catalogs: where the surfaces of known kinds are, and which kinds stand on which; other bodies carry on their tops.
    """
    known = _Known(space.zones, moved, *_perches(catalogs), catalogs)
    sent = {piece.id: piece for piece in _opened(room.furniture, floating)}
    now = dict(sent)
    for piece in _carriers_first(sent):
        after = carried_along(piece, sent.get(piece.on or ""), now.get(piece.on or ""))
        now[piece.id] = _put(after, now, known) if piece.id in floating and piece.on else after
    parents, before = above(room), {piece.id: piece for piece in room.furniture}
    changed = {label for label, piece in before.items() if (piece.x, piece.y, piece.z) != (now[label].x, now[label].y, now[label].z)}
    things = []
    for thing in room.decorations:
        carrier = climb(thing.id, parents, changed)
        goes = carrier in changed and thing.mounted_on_wall is None
        things.append(carried_along(thing, before[carrier], now[carrier]) if goes else thing)
    return replace(room, furniture=tuple(now[piece.id] for piece in room.furniture), decorations=tuple(things))


def _perches(catalogs: Catalogs) -> tuple[Mapping[str, frozenset[str]], frozenset[str]]:
    """Returns which names stand on which by some room type's rules, and those of them that stand nowhere else by any."""
    found: dict[str, set[str]] = {}
    free: set[str] = set()
    for room_type in catalogs.rooms.values():
        for piece in room_type.pieces:
            names = _names(piece, catalogs)
            below = {name for rule in piece.rules if rule.type == "on" and rule.required for name in _of(rule.of, room_type, catalogs)}
            free |= set() if below else names
            for name in names if below else ():
                found.setdefault(name, set()).update(below)
    return {name: frozenset(below) for name, below in found.items()}, frozenset(found.keys() - free)


def _names(piece: Piece, catalogs: Catalogs) -> set[str]:
    return {catalogs.name_of(variant.kind) for variant in piece.variants}


def _of(labels: Collection[str], room_type: RoomType, catalogs: Catalogs) -> Iterator[str]:
    for piece in room_type.pieces:
        if piece.piece in labels:
            yield from _names(piece, catalogs)


def _opened(furniture: Sequence[Furniture], floating: Container[str]) -> list[Furniture]:
    """Returns the furniture with every ring opened at the first of its pieces that may be moved."""
    pieces = {piece.id: piece for piece in furniture}
    for piece in furniture:
        if piece.id in floating and piece.id in _below(piece, pieces):
            pieces[piece.id] = replace(piece, on=None, y=0.0)
    return list(pieces.values())


def _below(piece: Furniture, pieces: Mapping[str, Furniture]) -> list[str]:
    """Returns the ids of what carries a piece, one under the other; its own among them where it carries itself."""
    found: list[str] = []
    at = piece.on
    while at in pieces and at is not None and at not in found:
        found.append(at)
        at = pieces[at].on
    return found


def _carriers_first(pieces: Mapping[str, Furniture]) -> list[Furniture]:
    return sorted(pieces.values(), key=lambda piece: len(_below(piece, pieces)))


def _put(piece: Furniture, now: Mapping[str, Furniture], known: _Known) -> Furniture:
    """Returns a floating piece on what carries it best; set down where nothing does."""
    own = now.get(piece.on or "")
    names = known.perches.get(piece.name, frozenset()) | ({own.name} if own else set())
    others = [other for other in now.values() if other.name in names and other is not own and _may_carry(other, piece, now)]
    rect = footprint(piece)
    middle = rect.x0 + rect.x1, rect.z0 + rect.z1
    over = [other for other in others if _beside(middle, other) == 0]
    if own is not None and not (over and _beside(middle, own)):
        left = own.id in known.moved and piece.id not in known.moved
        if left or piece.name in known.bound or rect.overlaps(footprint(own)):
            return _put_on(piece, own, now, known)
    if over or (own is None and others and piece.name in known.bound):
        return _put_on(piece, min(over or others, key=lambda other: _beside(middle, other)), now, known)
    return replace(piece, y=0.0, on=None)


def _may_carry(other: Furniture, piece: Furniture, now: Mapping[str, Furniture]) -> bool:
    """Tells whether another piece neither is nor stands on the piece."""
    return other.id != piece.id and piece.id not in _below(other, now)


def _beside(middle: tuple[int, int], other: Furniture) -> int:
    """Returns how far a middle, doubled mm, is from a piece's footprint, doubled mm, both axes added."""
    (x, z), rect = middle, footprint(other)
    return max(0, 2 * rect.x0 - x, x - 2 * rect.x1) + max(0, 2 * rect.z0 - z, z - 2 * rect.z1)


def _put_on(piece: Furniture, carrier: Furniture, now: Mapping[str, Furniture], known: _Known) -> Furniture:
    """Moves a piece onto a carrier by the shortest way, beside what stands there where there is room for both."""
    own, height, base = footprint(piece), size_of(piece)[2], to_mm(carrier.y)
    straight = replace(carrier, rotation=squared(carrier.rotation))
    places = surfaces_of(straight, known.catalogs, height)
    level, surface = min(places, key=lambda place: abs(base + place[0] - to_mm(piece.y)))
    area, bottom = _area(own, surface, footprint(straight)), base + level
    blocks = _beside_on(piece, (carrier, area), (bottom, bottom + height), now)
    blocks += [zone.rect for zone in known.zones if zone.above_mm < bottom + height and zone.rect.overlaps(area)]
    place = nearest_place(own, area, blocks) or nearest_place(own, area, ())
    dx, dz = (place.x0 - own.x0, place.z0 - own.z0) if place else (0, 0)
    x, z = round(piece.x + dx / 1000, 4), round(piece.z + dz / 1000, 4)
    return replace(piece, x=x, y=bottom / 1000, z=z, on=carrier.id, wall=None if dx or dz else piece.wall)


def _beside_on(piece: Furniture, to: tuple[Furniture, Rect], heights: tuple[int, int], now: Mapping[str, Furniture]) -> list[Rect]:
    """Returns what is in a piece's way on its carrier (and in that area) at those heights, mm; nothing where there is too much."""
    (carrier, area), (low, high) = to, heights
    found: list[Rect] = []
    below = {carrier.id, *_below(carrier, now)}
    for other in now.values():
        apart = max(abs(other.x - carrier.x), abs(other.z - carrier.z))
        far = 2 * apart > sum(body.width + body.depth for body in (piece, carrier, other))
        if far or other.id in below or other.y * 1000 >= high or (other.y + other.height) * 1000 <= low:
            continue
        rect = footprint(other)
        if rect.overlaps(area) and piece.id not in (other.id, *_below(other, now)):
            found.append(rect)
    return found if len(found) <= MOST_BESIDE else []


def _area(own: Rect, surface: Rect, carrier: Rect) -> Rect:
    """Returns where a footprint may be: within its carrier's with its middle over the surface; as it fits where it is larger."""
    x0, x1 = _stretch(own.width, (surface.x0, surface.x1), (carrier.x0, carrier.x1))
    z0, z1 = _stretch(own.depth, (surface.z0, surface.z1), (carrier.z0, carrier.z1))
    return Rect(x0, z0, x1, z1)


def _stretch(extent: int, surface: tuple[int, int], carrier: tuple[int, int]) -> tuple[int, int]:
    half = extent // 2
    low, high = max(carrier[0], surface[0] - half), min(carrier[1], surface[1] + half)
    if high - low >= extent:
        return low, high
    start = (carrier[0] + carrier[1] - extent) // 2
    return start, start + extent
