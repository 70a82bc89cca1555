"""The bodies of a room as the core told them: rows of numbers, of which furniture and decorations are made when somebody asks for them.

A home has some five hundred bodies, and whoever judges, counts or writes it needs numbers alone.
"""

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from struct import Struct
from typing import TYPE_CHECKING, Any, ClassVar, Final, TypeAlias, TypeVar

from solver.records import LATER, kept, made_later
from solver.scene import WALLS, Decoration, Furniture, Room

if TYPE_CHECKING:  # a scene is read and written without the catalogs
    from catalogs import Catalogs

BODY: Final = Struct("<8i8q")
"""Kind, on, under, wall, rotation, colour, number, nothing; x0, z0, x1, z1, low, width, depth, height, mm.

`on` and `under` count the furniture, then the things; -1 is nobody. `number` counts the room's bodies of one name.
"""
KIND: Final = Struct("<i92x")
"""The kind of such a row alone."""
_KIND_AND_SIZE: Final = Struct("<i68x24s")
SIZE: Final = Struct("<3q")
_TURN: Final = Struct("<16xi76x")
_NUMBER: Final = Struct("<24xi68x")
_POSE: Final = Struct("<16xi12x5q24x")
_KIND_AND_COLOUR: Final = Struct("<i16xi72x")
"""What else is asked of such rows alone: all of their numbers take longer."""
BODY_WALLS: Final = (*WALLS, None)
"""The walls that bodies stand or hang at, as they are numbered."""
BodyRow = tuple[int, ...]
BodyKey: TypeAlias = tuple[str, str, float, float, float, str | None]
"""What a body's kind is looked up by: "furniture" or "decoration", name, width, depth and height, m, the kind that the scene names."""
KindKey: TypeAlias = "BodyKey | Look"
"""The same, or a look by itself, which is quicker; of people "person", the kind, no size, "seated" of who sits."""
BodyTurn: TypeAlias = tuple[KindKey, float]
"""What a body is, and its rotation."""
RowsT = TypeVar("RowsT", bound="BodyRows")


class Look:
    """What bodies of a kind and size have in common: name, kind, width, depth and height, m, category; `key` says all of it but that.

    `extents` are width and depth as they are written into a mark of their room.
    """

    __slots__ = ("category", "extents", "key", "kind", "name", "size")

    def __init__(self, sort: str, name: str, kind: str | None, size: tuple[float, float, float], category: str | None = None) -> None:
        self.name, self.kind, self.size, self.category, self.key = name, kind, size, category, (sort, name, *size, kind)
        self.extents = f"{size[0]:.4f} {size[1]:.4f}"


def key_of(one: KindKey) -> BodyKey:
    """Returns what a body's kind is looked up by, written out."""
    return one.key if isinstance(one, Look) else one


LooksBySize = Mapping[tuple[int, bytes], Look]
"""How bodies look, by the number of their kind and their size, packed."""


def furniture_look(kind: str, size_mm: tuple[int, int, int], catalogs: "Catalogs") -> Look:
    """Returns how furniture of a kind looks in some size."""
    spec, (width, depth, height) = catalogs.furniture.get(kind), size_mm
    size = width / 1000, depth / 1000, height / 1000
    return _furniture_look("furniture", catalogs.name_of(kind), kind if spec else None, size, spec.category if spec else "misc")


_furniture_look: Final = lru_cache(maxsize=20_000)(Look)
"""One look is one object, whatever room type lists it: what is worked out of looks is kept by them."""


def looks_in(content: bytes, looks: LooksBySize) -> list[Look]:
    """Returns the look of each of some rows."""
    return [*map(looks.__getitem__, _KIND_AND_SIZE.iter_unpack(content))]


class BodyRows:
    """The bodies of one sort in a room as the core told them, in the order in which they were put there; called, it makes them.

    `looks` are those of each.
    """

    field: ClassVar[str]

    def __init__(self, content: bytes, room: Room, looks: Sequence[Look]) -> None:
        self.content, self.room, self.looks = content, room, looks

    def __len__(self) -> int:
        return len(self.content) // BODY.size

    def __call__(self) -> tuple[Any, ...]:
        """Returns the bodies."""
        raise NotImplementedError

    @kept
    def rows(self) -> Sequence[BodyRow]:
        """What was told of each."""
        return [*BODY.iter_unpack(self.content)]

    @property
    def poses(self) -> Iterator[BodyRow]:
        """The rotation of each, degrees; x0, z0, x1, z1 and low, mm."""
        return _POSE.iter_unpack(self.content)

    @kept
    def ids(self) -> Sequence[str]:
        """The id of each."""
        before = f"{self.room.id}/"
        return [f"{before}{look.name}_{number}" for look, (number,) in zip(self.looks, _NUMBER.iter_unpack(self.content), strict=True)]

    @property
    def colours(self) -> Sequence[str | None]:
        """The colour of each."""
        raise NotImplementedError

    def _made(self, of: type[Any], more: Sequence[Mapping[str, Any]]) -> tuple[Any, ...]:
        """Makes the bodies; `more` is what those of their class alone have."""
        made = []
        for name, look, color, row, others in zip(self.ids, self.looks, self.colours, self.rows, more, strict=True):
            _, _, _, _, rotation, _, _, _, x0, z0, x1, z1, low, *_ = row
            body = object.__new__(of)
            own = body.__dict__  # a frozen dataclass's own `__init__` takes three times as long
            own["id"], own["name"], own["kind"] = name, look.name, look.kind
            own["rotation"], own["color"], own["extra"] = rotation, color, {}
            own["x"], own["y"], own["z"] = (x0 + x1) / 2000, low / 1000, (z0 + z1) / 2000
            own["width"], own["depth"], own["height"] = look.size
            own.update(others)
            made.append(body)
        return tuple(made)


class FurnitureRows(BodyRows):
    """The furniture of a room; `by_kind` has the colour of each kind by its number."""

    field = "furniture"

    def __init__(self, content: bytes, room: Room, looks: Sequence[Look], by_kind: Mapping[int, str]) -> None:
        super().__init__(content, room, looks)
        self._by_kind = by_kind

    def __call__(self) -> tuple[Furniture, ...]:
        """Returns the furniture."""
        ids = (*self.ids, None)
        names = zip(self.looks, self.rows, strict=True)
        more = [{"category": look.category, "wall": BODY_WALLS[row[3]], "under": ids[row[2]], "on": ids[row[1]]} for look, row in names]
        return self._made(Furniture, more)

    @property
    def colours(self) -> Sequence[str]:
        """The colour of each."""
        colours = self._by_kind
        return [colours[kind] for (kind,) in KIND.iter_unpack(self.content)]


class DecorationRows(BodyRows):
    """The decorations of a furnished room; `colours` is what each kind is drawn from, `styled`: those are the style's."""

    field = "decorations"

    def __init__(self, content: bytes, room: Room, looks: Sequence[Look], colours: Sequence[Sequence[str]], styled: Sequence[bool]) -> None:
        super().__init__(content, room, looks)
        self._drawn_from, self._styled = colours, styled

    def __call__(self) -> tuple[Decoration, ...]:
        """Returns the decorations."""
        more = [{"parent": parent, "mounted_on_wall": BODY_WALLS[row[3]]} for parent, row in zip(self.parents, self.rows, strict=True)]
        return self._made(Decoration, more)

    @kept
    def parents(self) -> Sequence[str | None]:
        """The id of what each lies on or hangs over, if anything."""
        ids = [*furniture_ids(self.room), *self.ids]
        return [None if row[1] < 0 else ids[row[1]] for row in self.rows]

    @property
    def colours(self) -> Sequence[str | None]:
        """The colour of each: one of its kind's; or the room's: of the style's for that kind, alike in one room, or its accent."""
        drawn = self._drawn_from
        return [drawn[kind][number] if number >= 0 else self._of_room(kind) for kind, number in _KIND_AND_COLOUR.iter_unpack(self.content)]

    def _of_room(self, kind: int) -> str | None:
        colours = self._drawn_from[kind]
        return colours[self.room.index % len(colours)] if self._styled[kind] else self.room.accent


def told(room: Room, rows: BodyRows) -> Room:
    """Returns a room whose bodies of one sort are made of rows when somebody asks for them."""
    return made_later(room, **{rows.field: rows})


def rows_in(room: Room, of: type[RowsT]) -> RowsT | None:
    """Returns the rows that a room's bodies of a sort are made of, or None where they are told one by one."""
    later: Mapping[str, Any] | None = room.__dict__.get(LATER)  # as `maker_in` says, in half its time: a room is asked twenty times
    return later.get(of.field) if later else None


def furniture_ids(room: Room) -> Sequence[str]:
    """Returns the ids of a room's furniture."""
    rows = rows_in(room, FurnitureRows)
    return [piece.id for piece in room.furniture] if rows is None else rows.ids


def decoration_ids(room: Room) -> Sequence[str]:
    """Returns the ids of a room's decorations."""
    rows = rows_in(room, DecorationRows)
    return [thing.id for thing in room.decorations] if rows is None else rows.ids


def furniture_names(room: Room) -> Sequence[str]:
    """Returns the names of a room's furniture."""
    rows = rows_in(room, FurnitureRows)
    return [piece.name for piece in room.furniture] if rows is None else [look.name for look in rows.looks]


def furniture_keys(room: Room) -> Sequence[KindKey]:
    """Returns what the kind of each piece of a room's furniture is looked up by."""
    rows = rows_in(room, FurnitureRows)
    if rows is not None:
        return rows.looks
    return [("furniture", one.name, one.width, one.depth, one.height, one.kind) for one in room.furniture]


def furniture_turns(room: Room) -> Sequence[BodyTurn]:
    """Returns what each piece of a room's furniture is, and its rotation."""
    rows = rows_in(room, FurnitureRows)
    turns = [one.rotation for one in room.furniture] if rows is None else [turn for (turn,) in _TURN.iter_unpack(rows.content)]
    return [*zip(furniture_keys(room), turns, strict=True)]


def count_furniture(room: Room) -> int:
    """Returns how many pieces of furniture a room has."""
    rows = rows_in(room, FurnitureRows)
    return len(room.furniture) if rows is None else len(rows)


def count_decorations(room: Room) -> int:
    """Returns how many decorations a room has."""
    rows = rows_in(room, DecorationRows)
    return len(room.decorations) if rows is None else len(rows)
