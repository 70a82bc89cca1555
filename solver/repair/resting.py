"""What floats or is too high -> on what carries it, at its wall or on the floor, by the shortest way.

Furniture comes back over what it says it stands on where that is near (it is over part of it still), where it was moved away from
under the piece, and where its kind stands on other pieces alone, as room types' rules tell. Else it is set down where it is. One
that is over another piece of a kind that carries it stands on that one from now on.

What a moved piece left behind goes after it together: by the shortest way on which all of it is on the piece, turned as most of it
says that the piece was turned. Nothing else is told of where the piece was. So goes what several things at once tell was left behind: where
one way brings all of them back.

What lay inside a piece, on a board or in a drawer, lies inside again. Nothing else is put there but what has no room under the ceiling.
"""

import math
from collections.abc import Container, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

from catalogs import Catalogs
from catalogs.kind_book import CarryingSurface, carrying_in
from solver.free_places import footprint, nearest_place
from solver.geometry import ALONG_X, Rect, to_mm
from solver.repair.bodies import (
    RESTS_MM,
    Body,
    all_bodies,
    below,
    brought_along,
    changed_from_the_floor_up,
    parents_of,
    size_of,
    squared,
    with_bodies,
)
from solver.repair.room_problem import RoomProblem
from solver.scene import Decoration, Furniture, Room

MOST_BESIDE = 20
"""Pieces on a carrier beside which a place for another is sought; on a fuller one they stand in each other."""


@dataclass(frozen=True)
class _Known:
    """What decides where a room's floating furniture goes; `moved` are ids of what was just moved.

    `carriers` are by name of a piece the names of what carries it by some room type's rules, `bound` names of pieces that no room type
    wants elsewhere than on another.
    """

    problem: RoomProblem
    moved: Container[str]
    carriers: Mapping[str, frozenset[str]]
    bound: frozenset[str]


def put_to_rest(problem: RoomProblem, moved: Container[str]) -> Room:
    """Returns the room with all that floats, or reaches above the ceiling, where something carries it; locked bodies stay.

    What stands on something already goes where on it there is room. Furniture on others that the user just moved goes there too where it is
    in the way. A ring of things that carry each other is opened: the first of them stands on the floor.
    """
    room, settings = problem.room, problem.settings
    wrong = {label for issue in problem.errors for label in issue.ids}
    floating = {label for issue in problem.errors if issue.rule == "floating" for label in issue.ids}
    going = floating | {piece.id for piece in room.furniture if piece.id in wrong & settings.moved and piece.on is not None}
    high = {label for issue in problem.errors if issue.rule == "above_ceiling" for label in issue.ids}
    going |= {body.id for body in all_bodies(room) if body.id in high and body.height <= problem.ceiling}
    going -= {body.id for body in all_bodies(room) if settings.is_locked(body)}
    if not going:
        return room
    room, gone_after, hung = _gone_after(problem, floating)
    going = going - gone_after | hung
    known = _Known(problem, moved, *_carrying_names(settings.catalogs))

    def at_rest(body: Body, now: Mapping[str, Body]) -> Body:
        if body.id not in going:
            return body
        return _carried(body, now, known) if isinstance(body, Furniture) else _laid(body, now, problem)

    return changed_from_the_floor_up(_without_rings(room, going), at_rest)


def _gone_after(problem: RoomProblem, floating: Container[str]) -> tuple[Room, set[str], set[str]]:
    """Returns the room in which all that a moved piece left behind has gone after it, which that is, and what of it hangs at walls."""
    settings, bodies = problem.settings, all_bodies(problem.room)
    stays = {body.id for body in bodies if settings.is_locked(body) or body.id in settings.moved}
    said = {child: parent for child, parent in parents_of(problem.room).items() if child not in stays}
    before: dict[str, Body] = {}
    for piece in problem.room.furniture:
        lying = [body for body in bodies if said.get(body.id) == piece.id and not _hangs(body) and body.y > piece.y]
        left = sum(body.id in floating for body in lying)
        if left > (piece.id not in settings.moved):
            was = _where_it_was(piece, lying, problem)
            before |= {piece.id: was} if was and was != piece else {}

    def gone_after(body: Body, now: Mapping[str, Body]) -> Body:
        parent = said.get(body.id, "")
        return brought_along(body, before[parent], now[parent]) if parent in before else body

    after = {body.id for body in bodies if said.get(body.id) in before}
    return changed_from_the_floor_up(problem.room, gone_after), after, {body.id for body in bodies if _hangs(body)} & after


def _where_it_was(piece: Furniture, lying: Sequence[Body], problem: RoomProblem) -> Furniture | None:
    """Returns a piece as it stood under all that lies where it was, the shortest way from where it is; None where it stood so nowhere.

    It was turned as most of what lies there is, where that lets it have stood under all of it; else as most of the rest is.
    """
    turns = [(squared(piece.rotation) - squared(body.rotation)) % 360 for body in lying]
    for turn in sorted((0, 90, 180, 270), key=turns.count, reverse=True):
        before = replace(piece, rotation=(squared(piece.rotation) - turn) % 360)
        ways = [(_least_step(one.span(0)), _least_step(one.span(1))) for one in _common_steps(lying, before, problem)]
        if ways:
            dx, dz = min(ways, key=lambda way: (abs(way[0]) + abs(way[1]), way))
            turned = (piece.rotation - squared(piece.rotation) + before.rotation) % 360
            return replace(before, x=round(before.x + dx / 1000, 4), z=round(before.z + dz / 1000, 4), rotation=turned)
    return None


def _least_step(span: tuple[int, int]) -> int:
    return max(span[0], min(0, span[1]))


def _common_steps(lying: Sequence[Body], carrier: Furniture, problem: RoomProblem) -> set[Rect]:
    """Returns the steps of a carrier, mm, that bring it under all that lies on it."""
    found = set(_steps_under(lying[0], carrier, problem))
    for body in lying[1:]:
        both = [one.common(other) for one in found for other in _steps_under(body, carrier, problem)]
        found = {one for one in both if min(one.width, one.depth) >= 0}
    return found


def _steps_under(body: Body, carrier: Furniture, problem: RoomProblem) -> list[Rect]:
    """Returns the steps of a carrier, mm, that bring a surface of its under a body, the nearest first: of those as high as that."""
    own, places = footprint(body), _places(body, carrier, problem)
    areas = [one.area(own) if isinstance(body, Furniture) else one.rect for one in places if one.level == places[0].level]
    lows = [(own.x1 - area.x1, own.z1 - area.z1) for area in areas]
    highs = [(own.x0 - area.x0, own.z0 - area.z0) for area in areas]
    return [Rect(*map(min, low, high), *map(max, low, high)) for low, high in zip(lows, highs, strict=True)]


def _carrying_names(catalogs: Catalogs) -> tuple[Mapping[str, frozenset[str]], frozenset[str]]:
    """Returns which names stand on which by some room type's rules, and those of them that stand nowhere else by any."""
    found: dict[str, set[str]] = {}
    free: set[str] = set()
    for room_type in catalogs.rooms.values():
        names = {piece.piece: {catalogs.name_of(variant.kind) for variant in piece.variants} for piece in room_type.pieces}
        for piece in room_type.pieces:
            rules = [rule for rule in piece.rules if rule.type == "on" and rule.required]
            carriers = {name for rule in rules for label in rule.of for name in names.get(label, ())}
            free |= set() if carriers else names[piece.piece]
            for name in names[piece.piece] if carriers else ():
                found.setdefault(name, set()).update(carriers)
    return {name: frozenset(carriers) for name, carriers in found.items()}, frozenset(found.keys() - free)


def _without_rings(room: Room, going: Container[str]) -> Room:
    """Returns the room with every ring of carriers opened at the first of its bodies that may be moved."""
    said, opened = _said(all_bodies(room)), {body.id: body for body in all_bodies(room)}
    for body in all_bodies(room):
        if body.id in going and body.id in below(body.id, said):
            del said[body.id]
            opened[body.id] = replace(body, on=None, y=0.0) if isinstance(body, Furniture) else replace(body, parent=None)
    return with_bodies(room, opened.values())


def _said(bodies: Iterable[Body]) -> dict[str, str]:
    """Returns what every body says carries it; the wall carries what hangs."""
    said = {body.id: body.on if isinstance(body, Furniture) else body.parent for body in bodies if not _hangs(body)}
    return {label: parent for label, parent in said.items() if parent in said and parent is not None}


def _hangs(body: Body) -> bool:
    return isinstance(body, Decoration) and body.mounted_on_wall is not None


def _carried(piece: Furniture, now: Mapping[str, Body], known: _Known) -> Furniture:
    """Returns a floating piece on what carries it best; set down where nothing does."""
    pieces = {body.id: body for body in now.values() if isinstance(body, Furniture)}
    own = pieces.get(piece.on or "")
    names = known.carriers.get(piece.name, frozenset()) | ({own.name} if own else set())
    on_it = {label for label in pieces if piece.id in (label, *below(label, _said(pieces.values())))} if names else set()
    others = [other for other in pieces.values() if other.name in names and other is not own and other.id not in on_it]
    rect = footprint(piece)
    near = sorted(others, key=lambda other: _beside(rect, footprint(other)))
    over = [other for other in near if _beside(rect, footprint(other)) == 0]
    if own is not None and not (over and _beside(rect, footprint(own))):
        left = own.id in known.moved and piece.id not in known.moved
        if left or piece.name in known.bound or rect.overlaps(footprint(own)):
            return _put_on(piece, [own, *(near if piece.name in known.bound else ())], pieces, known)
    if over or (own is None and others and piece.name in known.bound):
        return _put_on(piece, [*(near if piece.name in known.bound else over), *([own] if own else ())], pieces, known)
    return replace(piece, y=0.0, on=None)


def _beside(rect: Rect, other: Rect) -> int:
    """Returns how far the middle of a rectangle is from another one, doubled mm, both axes added."""
    x, z = rect.x0 + rect.x1, rect.z0 + rect.z1
    return max(0, 2 * other.x0 - x, x - 2 * other.x1) + max(0, 2 * other.z0 - z, z - 2 * other.z1)


def _put_on(piece: Furniture, carriers: Sequence[Furniture], pieces: Mapping[str, Furniture], known: _Known) -> Furniture:
    """Moves a piece onto the first carrier that has room for it beside what stands there, else onto the first."""
    free = (_put_on_one(piece, carrier, pieces, known) for carrier in carriers)
    return next((found for found, has_room in free if has_room), _put_on_one(piece, carriers[0], pieces, known)[0])


def _put_on_one(piece: Furniture, carrier: Furniture, pieces: Mapping[str, Furniture], known: _Known) -> tuple[Furniture, bool]:
    """Moves a piece onto a carrier by the shortest way, or sets it down where the ceiling is too low; tells whether it has room there."""
    own, height = footprint(piece), size_of(piece)[2]
    place, *_ = _places(piece, replace(carrier, rotation=squared(carrier.rotation)), known.problem)
    area, bottom = place.area(own), place.level
    if _is_above_ceiling(piece, place, known.problem):
        return replace(piece, y=0.0, on=None), False
    blocks = _beside_on(piece, (carrier, area), (bottom, bottom + height), pieces)
    blocks += [zone.rect for zone in known.problem.space.zones if zone.above_mm < bottom + height and zone.rect.overlaps(area)]
    free = nearest_place(own, area, blocks)
    found = free or nearest_place(own, area, ())
    dx, dz = (found.x0 - own.x0, found.z0 - own.z0) if found else (0, 0)
    x, z = round(piece.x + dx / 1000, 4), round(piece.z + dz / 1000, 4)
    return replace(piece, x=x, y=bottom / 1000, z=z, on=carrier.id, wall=None if dx or dz else piece.wall), free is not None


def _beside_on(piece: Furniture, to: tuple[Furniture, Rect], heights: tuple[int, int], pieces: Mapping[str, Furniture]) -> list[Rect]:
    """Returns what is in a piece's way on its carrier (and in that area) at those heights, mm; nothing where there is too much."""
    (carrier, area), (low, high) = to, heights
    said = _said(pieces.values())
    carriers = {carrier.id, *below(carrier.id, said)}
    found: list[Rect] = []
    for other in pieces.values():
        level = other.y * 1000 < high and (other.y + other.height) * 1000 > low
        if level and other.id not in carriers and piece.id not in (other.id, *below(other.id, said)):
            rect = footprint(other)
            found += [rect] if rect.overlaps(area) else []
    return found if len(found) <= MOST_BESIDE else []


class _Place(NamedTuple):
    """A surface of a carrier: its height above the floor, its rectangle, and within what may be what stands on it, mm."""

    level: int
    rect: Rect
    bounds: Rect

    def area(self, own: Rect) -> Rect:
        """Returns where a footprint may be: within the bounds with its middle over the surface; as it fits where it is larger."""
        x0, x1 = _stretch(own.width, self.rect.span(0), self.bounds.span(0))
        z0, z1 = _stretch(own.depth, self.rect.span(1), self.bounds.span(1))
        return Rect(x0, z0, x1, z1)


def _stretch(extent: int, surface: tuple[int, int], carrier: tuple[int, int]) -> tuple[int, int]:
    half = extent // 2
    low, high = max(carrier[0], surface[0] - half), min(carrier[1], surface[1] + half)
    if high - low >= extent:
        return low, high
    start = (carrier[0] + carrier[1] - extent) // 2
    return start, start + extent


def _places(body: Body, carrier: Body, problem: RoomProblem) -> Sequence[_Place]:
    """Returns a carrier's surfaces, the best for a body first.

    Best is the one at whose height it is; else a top, the nearest in height, but for a thing within the carrier's height, for which what is
    inside is as good; of several of one height the nearest to it. One that lets
    it into the ceiling comes last, and before that one without room for it.
    """
    own, sort, tall = footprint(body), "furniture" if isinstance(carrier, Furniture) else "decoration", size_of(body)[2]
    is_within = isinstance(body, Decoration) and carrier.y < body.y and body.y + body.height < carrier.y + carrier.height
    ranked: list[tuple[tuple[int, ...], int, _Place]] = []
    for one in carrying_in(problem.settings.catalogs).surfaces_of(
        sort, carrier.name, (carrier.width, carrier.depth, carrier.height), carrier.kind
    ):
        rect = _rect_of(one, carrier)
        place = _Place(to_mm(carrier.y) + _up(one.height), rect, footprint(carrier) if one.is_top else rect)
        apart = abs(place.level - to_mm(body.y))
        is_low = one.clearance is not None and to_mm(one.clearance) < tall
        is_narrow = not one.is_top and (own.width > rect.width or own.depth > rect.depth)
        elsewhere, above = apart > RESTS_MM and not is_within, _is_above_ceiling(body, place, problem)
        no_room = (apart > RESTS_MM or isinstance(body, Furniture)) and (is_low or is_narrow)
        rank = above, no_room, elsewhere and not one.is_top, apart, is_narrow, _beside(own, rect)
        ranked.append((rank, len(ranked), place))
    return [place for _, _, place in sorted(ranked)]


def _is_above_ceiling(body: Body, place: _Place, problem: RoomProblem) -> bool:
    return place.level / 1000 + body.height > problem.ceiling + 1e-6


def _rect_of(surface: CarryingSurface, carrier: Body) -> Rect:
    """Returns where a surface is; on a carrier at another than a right angle as far in from all edges as from the nearest."""
    rect, (left, right, back, front) = footprint(carrier), map(_up, (surface.left, surface.right, surface.back, surface.front))
    if carrier.rotation % 90:
        return rect.shrunk(min(left, right, back, front))
    quarters = squared(carrier.rotation) // 90
    west, north, east, south = (left, back, right, front, left, back, right)[quarters : quarters + 4]
    return Rect(rect.x0 + west, rect.z0 + north, rect.x1 - east, rect.z1 - south)


def _up(metres: float) -> int:
    return math.ceil(metres * 1000 - 1e-6)


def _laid(thing: Decoration, now: Mapping[str, Body], problem: RoomProblem) -> Decoration:
    """Returns a floating decoration at its wall under the ceiling, on or in what carries it where the ceiling lets it, or on the floor."""
    if thing.mounted_on_wall is not None:
        own, half = footprint(thing), problem.walls.half_mm
        deep = own.depth if thing.mounted_on_wall in ALONG_X else own.width
        edges = [(wall, line, start + half, end - half) for wall, line, start, end in problem.walls.edges]
        faces = [problem.walls.before(edge, deep) for edge in edges if edge[0] == thing.mounted_on_wall]
        top = max(problem.ceiling - thing.height, 0.0)
        level = to_mm(thing.y) if thing.y <= top else math.floor(top * 1000 + 1e-6)
        hung = [_moved_into(thing, face, level) for face in faces]
        return min(hung, key=lambda place: abs(place.x - thing.x) + abs(place.z - thing.z), default=thing)
    carrier = now.get(thing.parent or "")
    if carrier is None:
        return _moved_into(thing, problem.walls.clear, 0)
    place, *_ = _places(thing, carrier, problem)
    return thing if _is_above_ceiling(thing, place, problem) else _moved_into(thing, place.rect, place.level)


def _moved_into(thing: Decoration, area: Rect, level: int) -> Decoration:
    """Moves a thing into an area at a height by the shortest way; where it is larger than the area, onto its middle."""
    own = footprint(thing)
    x = _moved(thing.x, (own.x0, own.x1), (area.x0, area.x1))
    z = _moved(thing.z, (own.z0, own.z1), (area.z0, area.z1))
    return replace(thing, x=x, z=z, y=level / 1000)


def _moved(middle: float, own: tuple[int, int], area: tuple[int, int]) -> float:
    if own[1] - own[0] > area[1] - area[0]:
        return (area[0] + area[1]) / 2000
    step = max(area[0] - own[0], 0) + min(area[1] - own[1], 0)
    return round(middle + step / 1000, 4) if step else middle
