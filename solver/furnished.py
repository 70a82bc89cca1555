"""An arrangement written into its room: ids, names, colours, metres.

Comes in: a Room and its Arrangement. Goes out: the Room with its furniture. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from dataclasses import replace

from catalogs import Catalogs
from solver.geometry import half_m, to_m
from solver.scene import Furniture, Room
from solver.streams import Stream
from solver.wanted import Arrangement, Placed


def furnished(room: Room, arrangement: Arrangement, catalogs: Catalogs, stream: Stream) -> Room:
    """Returns the room with the arrangement's pieces as its furniture.

    Ids count the pieces of one name: `<room id>/<name>_<n>`. A piece's colour is one of its kind's, drawn from the
    stream; all pieces of one kind in a room share it.
    """
    ids: dict[str, str] = {}
    counts: dict[str, int] = {}
    for placed in arrangement.placed:
        name = catalogs.name_of(placed.chosen.kind)
        counts[name] = counts.get(name, 0) + 1
        ids[placed.label] = f"{room.id}/{name}_{counts[name]}"
    colours = _colours(sorted({placed.chosen.kind for placed in arrangement.placed}), catalogs, stream)
    pieces = tuple(_piece(placed, ids, colours, catalogs) for placed in arrangement.placed)
    return replace(room, furniture=pieces)


def _colours(kinds: list[str], catalogs: Catalogs, stream: Stream) -> dict[str, str]:
    colours = {}
    for kind in kinds:
        spec = catalogs.furniture[kind]
        colours[kind] = stream.pick((spec.color, *spec.variants))
    return colours


def _piece(placed: Placed, ids: dict[str, str], colours: dict[str, str], catalogs: Catalogs) -> Furniture:
    chosen, rect = placed.chosen, placed.footprint
    width, depth, height = chosen.size_mm
    return Furniture(
        id=ids[placed.label],
        name=catalogs.name_of(chosen.kind),
        category=catalogs.furniture[chosen.kind].category,
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
    )
