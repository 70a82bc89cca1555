"""An arrangement written into its room: ids, names, colours, metres.

Comes in: a Room and its Arrangement. Goes out: the Room with its furniture. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from dataclasses import replace

from catalogs import Catalogs
from catalogs.styles import Style
from solver.geometry import half_m, to_m
from solver.pieces import Arrangement, Placed
from solver.scene import Furniture, Room
from solver.streams import Stream

PLAIN_COLOUR = "#9a9a9a"
"""Of what the catalogs do not know."""


def furnished(room: Room, arrangement: Arrangement, catalogs: Catalogs, stream: Stream, style: Style | None = None) -> Room:
    """Returns the room with the arrangement's pieces as its furniture.

    Ids count the pieces of one name: `<room id>/<name>_<n>`. A piece's colour is drawn from the stream: of the style's palette
    for it, which all pieces of the room with that palette then share, or else of its kind's own colours; all pieces of one kind
    in a room share it.
    """
    ids = ids_of(room, arrangement, catalogs)
    kinds = sorted({placed.chosen.kind for placed in arrangement.placed})
    colours = _colours({kind: _palette(kind, catalogs, style) for kind in kinds}, catalogs, stream)
    pieces = tuple(_piece(placed, ids, colours, catalogs) for placed in arrangement.placed)
    return replace(room, furniture=pieces)


def ids_of(room: Room, arrangement: Arrangement, catalogs: Catalogs) -> dict[str, str]:
    """Returns the ids of an arrangement's pieces in a room, by label."""
    ids: dict[str, str] = {}
    counts: dict[str, int] = {}
    for placed in arrangement.placed:
        name = catalogs.name_of(placed.chosen.kind)
        counts[name] = counts.get(name, 0) + 1
        ids[placed.label] = f"{room.id}/{name}_{counts[name]}"
    return ids


def _palette(kind: str, catalogs: Catalogs, style: Style | None) -> tuple[str, ...]:
    """Returns the colours a style has for a kind; none where it leaves the kind as it is."""
    return style.colours(kind, catalogs.name_of(kind), _category(kind, catalogs)) if style else ()


def _colours(palettes: dict[str, tuple[str, ...]], catalogs: Catalogs, stream: Stream) -> dict[str, str]:
    colours: dict[str, str] = {}
    matching: dict[tuple[str, ...], str] = {}
    for kind, palette in palettes.items():
        spec = catalogs.furniture.get(kind)
        if palette in matching:
            colours[kind] = matching[palette]
        else:
            colours[kind] = stream.pick(palette or ((spec.color, *spec.variants) if spec else (PLAIN_COLOUR,)))
        if palette:
            matching[palette] = colours[kind]
    return colours


def _piece(placed: Placed, ids: dict[str, str], colours: dict[str, str], catalogs: Catalogs) -> Furniture:
    chosen, rect = placed.chosen, placed.footprint
    width, depth, height = chosen.size_mm
    return Furniture(
        id=ids[placed.label],
        name=catalogs.name_of(chosen.kind),
        category=_category(chosen.kind, catalogs),
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
        kind=chosen.kind if chosen.kind in catalogs.furniture else None,
    )


def _category(kind: str, catalogs: Catalogs) -> str:
    spec = catalogs.furniture.get(kind)
    return spec.category if spec else "misc"
