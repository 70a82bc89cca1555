"""An arrangement written into its room: ids, names, colours, metres.

Comes in: a Room and its Arrangement. Goes out: the Room with its furniture. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import NamedTuple

from catalogs import Catalogs
from catalogs.schema import FurnitureSpec
from catalogs.styles import Style
from solver.geometry import half_m, to_m
from solver.pieces import Arrangement, Placed
from solver.scene import Furniture, Room
from solver.streams import Stream

PLAIN_COLOUR = "#9a9a9a"
"""Of what the catalogs do not know."""


class _NamedKind(NamedTuple):
    """What the catalogs know of a kind: its name, and what they say of it."""

    name: str
    spec: FurnitureSpec | None

    @property
    def category(self) -> str:
        """What sort of thing it is."""
        return self.spec.category if self.spec else "misc"


def furnished(room: Room, arrangement: Arrangement, catalogs: Catalogs, stream: Stream, style: Style | None = None) -> Room:
    """Returns the room with the arrangement's pieces as its furniture.

    Ids count the pieces of one name: `<room id>/<name>_<n>`. A piece's colour is drawn from the stream: of the style's palette
    for it, which all pieces of the room with that palette then share, or else of its kind's own colours; all pieces of one kind
    in a room share it.
    """
    ids = ids_of(room, arrangement, catalogs)
    kinds = sorted({placed.chosen.kind for placed in arrangement.placed})
    known = {kind: _NamedKind(catalogs.name_of(kind), catalogs.furniture.get(kind)) for kind in kinds}
    colours = _colours(known, style, stream)
    pieces = tuple(_piece(placed, ids, colours, known[placed.chosen.kind]) for placed in arrangement.placed)
    return replace(room, furniture=pieces)


def recoloured(room: Room, catalogs: Catalogs, stream: Stream, style: Style) -> Room:
    """Returns a furnished room in the colours of a style, drawn as for new furniture; what has no kind keeps its colour."""
    kinds = sorted({piece.kind for piece in room.furniture if piece.kind in catalogs.furniture})
    colours = _colours({kind: _NamedKind(catalogs.name_of(kind), catalogs.furniture[kind]) for kind in kinds}, style, stream)
    return replace(room, furniture=tuple(replace(piece, color=colours.get(piece.kind or "", piece.color)) for piece in room.furniture))


def ids_of(room: Room, arrangement: Arrangement, catalogs: Catalogs) -> dict[str, str]:
    """Returns the ids of an arrangement's pieces in a room, by label."""
    ids: dict[str, str] = {}
    counts: dict[str, int] = {}
    for placed in arrangement.placed:
        name = catalogs.name_of(placed.chosen.kind)
        counts[name] = counts.get(name, 0) + 1
        ids[placed.label] = f"{room.id}/{name}_{counts[name]}"
    return ids


def _colours(kinds: Mapping[str, _NamedKind], style: Style | None, stream: Stream) -> dict[str, str]:
    colours: dict[str, str] = {}
    matching: dict[tuple[str, ...], str] = {}
    for kind, known in kinds.items():
        palette, spec = style.colours(kind, known.name, known.category) if style else (), known.spec
        if palette in matching:
            colours[kind] = matching[palette]
        else:
            colours[kind] = stream.pick(palette or ((spec.color, *spec.variants) if spec else (PLAIN_COLOUR,)))
        if palette:
            matching[palette] = colours[kind]
    return colours


def _piece(placed: Placed, ids: dict[str, str], colours: dict[str, str], known: _NamedKind) -> Furniture:
    chosen, rect = placed.chosen, placed.footprint
    width, depth, height = chosen.size_mm
    return Furniture(
        id=ids[placed.label],
        name=known.name,
        category=known.category,
        x=half_m(rect.x0 + rect.x1),
        y=to_m(chosen.bottom_mm),
        z=half_m(rect.z0 + rect.z1),
        rotation=placed.rotation,
        width=to_m(width),
        depth=to_m(depth),
        height=to_m(height),
        color=colours[chosen.kind],
        wall=placed.wall,
        under=ids.get(chosen.under or ""),
        on=ids.get(chosen.on or ""),
        kind=chosen.kind if known.spec else None,
    )
