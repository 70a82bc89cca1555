"""What decorates a room as the core told it: rows of numbers, of which decorations are made when somebody asks for them.

Comes in: the core's rows, the furnished room, how kinds look. Goes out: a room whose `decorations` are made later; the rows. May import:
scene. A home has some four hundred decorations, and whoever judges, counts or writes it needs numbers alone.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from struct import Struct
from typing import Final

from solver.fields import LATER
from solver.scene import WALLS, Decoration, Room

_THING: Final = Struct("<6i8q")
THING_WALLS: Final = (*WALLS, None)
"""The walls that things hang at, as they are numbered."""


class Look:
    """What things of a kind and size have in common: name, kind, width, depth and height, m; `key` says all of it."""

    __slots__ = ("key", "kind", "name", "size")

    def __init__(self, name: str, kind: str | None, size: tuple[float, float, float]) -> None:
        self.name, self.kind, self.size, self.key = name, kind, size, ("decoration", name, *size, kind)


class Looks:
    """How things look in a style.

    Args:
        by_kind: how they look, by the number of their kind and their size, mm.
        colours: what each kind is drawn from.
        styled: whether those are the style's.
    """

    def __init__(self, by_kind: Mapping[tuple[int, int, int, int], Look], colours: Sequence[Sequence[str]], styled: Sequence[bool]) -> None:
        self.by_kind, self._colours, self._styled = by_kind, colours, styled

    def colour(self, room: Room, kind: int, number: int) -> str | None:
        """Returns a colour of a kind; -1 is the room's: one of the style's, where it has some for that kind, alike in one room."""
        colours = self._colours[kind]
        if number >= 0:
            return colours[number]
        return colours[room.index % len(colours)] if self._styled[kind] else room.accent


class DressedRows:
    """The things of a room, in the order in which they were put there.

    Args:
        content: as the core told them.
        room: the room, furnished.
        known: how they look.
    """

    def __init__(self, content: bytes, room: Room, known: Looks) -> None:
        self.content, self.room, self._known = content, room, known

    def __len__(self) -> int:
        return len(self.content) // _THING.size

    @cached_property
    def rows(self) -> Sequence[tuple[int, ...]]:
        """What was told of each: kind, parent, wall, rotation, colour, number, x0, z0, x1, z1, low, width, depth, height; mm.

        The parent counts the furniture, then the things; -1 is nobody.
        """
        return [*_THING.iter_unpack(self.content)]

    @cached_property
    def looks(self) -> Sequence[Look]:
        """The look of each."""
        known = self._known.by_kind
        return [known[kind, width, depth, height] for kind, _, _, _, _, _, _, _, _, _, _, width, depth, height in self.rows]

    @cached_property
    def ids(self) -> Sequence[str]:
        """The id of each: they go on counting behind the furniture of the same name."""
        before = f"{self.room.id}/"
        return [f"{before}{look.name}_{row[5]}" for look, row in zip(self.looks, self.rows, strict=True)]

    @cached_property
    def parents(self) -> Sequence[str | None]:
        """The id of what each lies on or hangs over, if anything."""
        ids = [*(piece.id for piece in self.room.furniture), *self.ids]
        return [None if row[1] < 0 else ids[row[1]] for row in self.rows]

    @cached_property
    def colours(self) -> Sequence[str | None]:
        """The colour of each."""
        colour = self._known.colour
        return [colour(self.room, row[0], row[4]) for row in self.rows]

    def decorations(self) -> tuple[Decoration, ...]:
        """Returns them as decorations."""
        made = []
        said = zip(self.ids, self.looks, self.parents, self.colours, self.rows, strict=True)
        for name, look, parent, color, (_, _, wall, rotation, _, _, x0, z0, x1, z1, low, *_) in said:
            thing = object.__new__(Decoration)
            own = thing.__dict__  # a frozen dataclass's own `__init__` takes three times as long
            own["id"], own["name"], own["parent"], own["mounted_on_wall"] = name, look.name, parent, THING_WALLS[wall]
            own["x"], own["y"], own["z"], own["rotation"] = (x0 + x1) / 2000, low / 1000, (z0 + z1) / 2000, rotation
            own["width"], own["depth"], own["height"] = look.size
            own["color"], own["kind"], own["extra"] = color, look.kind, {}
            made.append(thing)
        return tuple(made)


def dressed(room: Room, rows: DressedRows) -> Room:
    """Returns a room whose decorations are made of rows when somebody asks for them."""
    made = object.__new__(Room)
    own = made.__dict__
    own.update(room.__dict__)
    own.pop("decorations", None)
    own[LATER] = {"decorations": rows.decorations}
    own[_ROWS] = rows
    return made


_ROWS: Final = "_dressed"


def rows_in(room: Room) -> DressedRows | None:
    """Returns the rows that a room's decorations are made of, or None where they are told one by one."""
    found: DressedRows | None = room.__dict__.get(_ROWS)
    return found


def count_decorations(room: Room) -> int:
    """Returns how many decorations a room has."""
    rows = rows_in(room)
    return len(room.decorations) if rows is None else len(rows)
