"""Questions about everything in a scene at once: how much there is, under which ids, what moved."""

from collections.abc import Callable, Collection, Iterator, Sequence
from functools import cache, partial
from itertools import chain, islice
from numbers import Real
from operator import attrgetter
from typing import Annotated, get_args, get_origin, get_type_hints

from annotated_types import Ge, Le

from catalogs.misfits import called
from solver.answers import Move
from solver.body_rows import DecorationRows, FurnitureRows, count_decorations, count_furniture, rows_in
from solver.errors import MOST_TOLD, FieldError, SceneError, all_of
from solver.scene import Decoration, Dynamic, Furniture, Level, Opening, Room, Scene, Size

MOVED = 0.001
"""A body that moved by more, m, is listed in `moves` (docs/fix.md)."""
SentBody = Furniture | Decoration | Dynamic


def said_height(scene: Scene, level: int) -> float | None:
    """Returns how high the rooms of a storey are said to be, m: by `levels`; where none is listed, of one storey by `size`; else None."""
    listed = {one.index: one.height for one in scene.levels}
    if listed or scene.size is None or any(room.level != level for room in scene.rooms):
        return listed.get(level)
    return scene.size.height


def storey_height(scene: Scene, level: int) -> float:
    """Returns how high the rooms of a storey are, m: as is said, else as high as rooms usually are."""
    said = said_height(scene, level)
    return Level.height if said is None else said


def storey_levels(scene: Scene) -> dict[int, Level]:
    """Returns a scene's storeys by the number that rooms name; those that it does not list lie on the highest one beneath them."""
    found = {one.index: one for one in scene.levels}
    for index in sorted({room.level for room in scene.rooms} - found.keys()):
        tops = (one.elevation + one.height for one in found.values() if one.index < index)
        found[index] = Level(index, max(tops, default=Level.elevation), storey_height(scene, index))
    return found


def counted(rooms: Sequence[Room], people: Sequence[Dynamic]) -> dict[str, int]:
    """Returns how many there are in a house of everything that is counted; a door that two rooms list is one."""
    openings = {opening.id: opening.kind for room in rooms for opening in room.openings}
    windows = sum(kind == "window" for kind in openings.values())
    return {
        "rooms": len(rooms),
        "doors": len(openings) - windows,
        "windows": windows,
        "furniture": sum(map(count_furniture, rooms)),
        "decorations": sum(map(count_decorations, rooms)),
        "dynamic": len(people),
    }


def bodies_of(scene: Scene) -> list[SentBody]:
    """Returns all bodies of a scene: furniture and decorations room by room, then people and pets."""
    found: list[SentBody] = []
    for room in scene.rooms:
        found += [*room.furniture, *room.decorations]
    return [*found, *scene.dynamic]


def home_of(scene: Scene, person: Dynamic) -> str | None:
    """Returns the id of the room that a person or pet says it is in; the only room's where it does not say."""
    return scene.rooms[0].id if person.room is None and len(scene.rooms) == 1 else person.room


def people_in(scene: Scene, room: Room) -> tuple[Dynamic, ...]:
    """Returns the people and pets in a room."""
    return tuple(person for person in scene.dynamic if home_of(scene, person) == room.id)


def body_ids(scene: Scene) -> list[str]:
    """Returns the ids of all bodies of a scene, in the order of `bodies_of`."""
    return [body.id for body in bodies_of(scene)]


def moves_between(before: Scene, after: Scene) -> tuple[Move, ...]:
    """Lists what moved by more than a millimetre, also up or down alone, or turned; all that is in the second scene is in the first."""
    sent = {body.id: body for body in bodies_of(before)}
    moves = []
    for body in bodies_of(after):
        old = sent[body.id]
        dx, dy, dz = round(body.x - old.x, 4), round(body.y - old.y, 4), round(body.z - old.z, 4)
        if max(abs(dx), abs(dy), abs(dz)) > MOVED or (body.rotation - old.rotation) % 360:
            moves.append(Move(body.id, dx, dz, body.rotation))
    return tuple(moves)


def check_listed(field: str, given: object, entry: type, called_so: str, error: type[FieldError] = SceneError) -> None:
    """Refuses what is no collection of such entries: a text or one entry alone, which Python takes for a list, or what is none at all.

    Raises:
        FieldError: names what is wrong, and that a list, or `called_so`, is wanted.
    """
    if isinstance(given, str) or not isinstance(given, Collection):
        raise error(field, f"is {called(given)}", "a list")
    for place, one in enumerate(given):
        check_is(f"{field}[{place}]", one, entry, called_so, error)


def check_is(field: str, given: object, of: type | tuple[type, ...], called_so: str, error: type[FieldError] = SceneError) -> None:
    """Refuses what is not of a type: true and false are no numbers.

    Raises:
        FieldError: names what is wrong, and that `called_so` is wanted.
    """
    if not isinstance(given, of) or isinstance(given, bool):
        raise error(field, f"is {called(given)}", called_so)


def check_scene(scene: object) -> None:
    """Refuses what is no scene, and numbers of one made in Python that no reader takes: nothing can be said of what is at no place.

    Raises:
        SceneError: says what was given, or names the field and what is allowed.
    """
    check_is("scene", scene, Scene, "a Scene, as `load` or `generate` gives it")
    assert isinstance(scene, Scene)
    _check_numbers("", Scene, scene)
    if scene.size is not None:
        _check_numbers("size.", Size, scene.size)
    for field, kind, records in _numbered(scene):
        if not _are_sound(kind, records):
            for number, one in enumerate(records):
                _check_numbers(f"{field}[{number}].", kind, one)


@cache
def _limits_of(kind: type) -> dict[str, tuple[float | None, float]]:
    """Returns the least and the most that each number of a kind of record may be, as its type says; least None: above 0."""
    found = {}
    for name, hint in get_type_hints(kind, include_extras=True).items():
        if get_origin(hint) is Annotated and get_args(hint)[0] is float:
            marks = {type(mark): mark for mark in get_args(hint)[1:]}
            found[name] = (marks[Ge].ge if Ge in marks else None, marks[Le].le)
    return found


@cache
def _reading_of(kind: type) -> tuple[Callable[[object], tuple[float, ...]], Callable[[object], tuple[float, ...]], float, float]:
    """Returns what reads a record's numbers, and what those above 0, several both; and the most that others and these may be."""
    limits = _limits_of(kind)
    most_place, most_size = (min(most for least, most in limits.values() if (least is None) is is_size) for is_size in (False, True))
    return attrgetter(*limits), attrgetter(*(key for key, (least, _) in limits.items() if least is None)), most_place, most_size


def _are_sound(kind: type, records: Sequence[object]) -> bool:
    """Tells quickly whether all numbers of records are surely such as may be; else one may be wrong."""
    values, sizes, most_place, most_size = _reading_of(kind)
    try:
        total = sum(map(abs, chain.from_iterable(map(values, records))))
        lengths = [*chain.from_iterable(map(sizes, records)), most_size]
        return total <= most_place and min(lengths) > 0 and max(lengths) <= most_size
    except (TypeError, OverflowError):
        return False


def _check_numbers(prefix: str, kind: type, record: object) -> None:
    """Refuses a number of a record that is none, or out of its range."""
    for key, (least, most) in _limits_of(kind).items():
        value = getattr(record, key)
        if not (isinstance(value, Real) and (value > 0 if least is None else value >= least) and value <= most):  # type: ignore[operator]
            told = f"a number above 0, up to {most:g}" if least is None else f"a number from {least:.0f} to {most:.0f}"
            raise SceneError(prefix + key, f"is {called(value)}", told)


def _numbered(scene: Scene) -> Iterator[tuple[str, type, Sequence[object]]]:
    """Yields what of a scene has numbers, those of bodies that the core told left aside, with its field and what kind of record it is."""
    yield "levels", Level, scene.levels
    yield "rooms", Room, scene.rooms
    for number, room in enumerate(scene.rooms):
        yield f"rooms[{number}].openings", Opening, room.openings
        yield f"rooms[{number}].furniture", Furniture, () if rows_in(room, FurnitureRows) else room.furniture
        yield f"rooms[{number}].decorations", Decoration, () if rows_in(room, DecorationRows) else room.decorations
    yield "dynamic", Dynamic, scene.dynamic


def check_ids(known: Sequence[str], **wanted: Sequence[str]) -> None:
    """Refuses ids, by the name of the field that lists them, that a scene does not have, or has twice, and what is no list of ids.

    Raises:
        SceneError: names the entries and some ids that would do.
    """
    for field, ids in wanted.items():
        check_listed(field, ids, str, "a text")
    have = set(known)
    if len(have) < len(known):
        twice = next(one for k, one in enumerate(known) if one in known[:k])
        raise SceneError("scene", f"{twice!r} is given twice", "ids that differ, also from those of what stands in the room")
    named = ((f"{field}[{k}]", one) for field, ids in wanted.items() for k, one in enumerate(ids) if one not in have)
    all_of(partial(check_id, field, one, known) for field, one in islice(named, MOST_TOLD))


def check_id(field_name: str, wanted: str, known: Sequence[str]) -> None:
    """Refuses an id that a scene does not have.

    Raises:
        SceneError: names the field and some ids that would do, those first that are called so in another room or are in the room meant.
    """
    if not isinstance(wanted, str):
        raise SceneError(field_name, f"is {called(wanted)}", "a text")
    if wanted not in known:
        room, _, own = wanted.rpartition("/")
        likely = sorted(known, key=lambda one: (one.rpartition("/")[2] != own, one.rpartition("/")[0] != room))
        shown = ", ".join(likely[:12]) + (", ..." if len(known) > 12 else "")
        raise SceneError(
            field_name, f"nothing in the scene has the id {wanted!r}", f"one of {shown}" if known else "no id: nothing is there"
        )
