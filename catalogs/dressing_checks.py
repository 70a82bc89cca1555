"""What must hold between decorations, what they lie on, and the rooms they are in."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from catalogs.dressing import ALL, INDOOR, SURFACE, DecorationKind, Dressing, Lies, Row
from catalogs.entries import Surface
from catalogs.faults import Fault
from catalogs.schema import Catalogs

SLACK = 1e-9
Key = tuple[str | int, ...]


def dressing_faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Yields everything that does not fit together in decorations.yaml and dressing.yaml."""
    for name, kind in catalogs.decorations.items():
        yield from _kind_faults(name, kind)
    for name, entry in catalogs.dressing.items():
        yield from _entry_faults(catalogs, name, entry)
    yield from _circles(catalogs)


def _kind_faults(name: str, kind: DecorationKind) -> Iterator[Fault]:
    for i, length in enumerate(kind.size):
        if abs(length * 100 - round(length * 100)) > SLACK:
            yield Fault("decorations", (name, "size", i), f"{length} m is not a whole number of centimetres", "steps of 0.01")
    if kind.jitter and kind.surfaces:
        yield Fault("decorations", (name, "jitter"), "what carries things lies straight", "no `jitter` beside `surfaces`")
    for i, surface in enumerate(kind.surfaces):
        at = (name, "surfaces", i)
        if surface.height > kind.size[2] + SLACK:
            problem = f"the surface {surface.name!r} lies at {surface.height} m, above the thing"
            yield Fault("decorations", (*at, "height"), problem, f"at most {kind.size[2]}")
        if 2 * surface.inset >= min(kind.size[:2]):
            yield Fault("decorations", (*at, "inset"), f"the surface {surface.name!r} has no area left", "a smaller inset")


@dataclass(frozen=True)
class _Parent:
    """What an entry dresses: bodies with their footprints and surfaces, or a room."""

    bodies: tuple[tuple[tuple[float, float], tuple[Surface, ...]], ...] = ()
    is_room: bool = False


def _parents(catalogs: Catalogs, name: str) -> list[_Parent]:
    """Returns what bears a name: at most one of each sort."""
    pieces = [entry for kind, entry in catalogs.furniture.items() if (entry.name or kind) == name]
    found = [_Parent(tuple((piece.size[:2], piece.surfaces) for piece in pieces))] if pieces else []
    thing = catalogs.decorations.get(name)
    found += [_Parent(((thing.size[:2], thing.surfaces),))] if thing else []
    return [*found, _Parent(is_room=True)] if name in catalogs.rooms or name == INDOOR else found


def _entry_faults(catalogs: Catalogs, name: str, entry: Dressing) -> Iterator[Fault]:
    parents = _parents(catalogs, name)
    if len(parents) != 1:
        problem = f"unknown parent {name!r}" if not parents else f"{name!r} is a name of several things"
        yield Fault("dressing", (name,), problem, "a name of furniture.yaml, a key of decorations.yaml or of rooms/, or indoor")
        return
    parent = parents[0]
    if parent.is_room and entry.lies:
        yield Fault("dressing", (name, "lies"), "things lie on furniture and decorations", "`stands` for a room's floor")
    if not parent.is_room and entry.stands:
        yield Fault("dressing", (name, "stands"), "things stand on a room's floor", "`lies` for what is on a piece")
    for i, row in enumerate(entry.lies):
        yield from _row_faults(catalogs, (name, "lies", i), row)
        yield from _lying_faults(catalogs, (name, "lies", i), parent, entry.lies[: i + 1])
    for i, hanging in enumerate(entry.hangs):
        yield from _row_faults(catalogs, (name, "hangs", i), hanging)
    for i, standing in enumerate(entry.stands):
        yield from _row_faults(catalogs, (name, "stands", i), standing)
        names = {catalogs.name_of(kind) for kind in catalogs.furniture}
        yield from _unknown((name, "stands", i, "of"), standing.of, names, "piece", "a name of furniture.yaml")


def _unknown(at: Key, words: Sequence[str], known: Mapping[str, object] | set[str], what: str, allowed: str) -> Iterator[Fault]:
    for word in words:
        if word not in known:
            yield Fault("dressing", at, f"unknown {what} {word!r}", allowed)


def _row_faults(catalogs: Catalogs, at: Key, row: Row) -> Iterator[Fault]:
    yield from _unknown((*at, "put"), row.put, catalogs.decorations, "kind", "a key of decorations.yaml")
    yield from _unknown((*at, "styles"), row.styles, catalogs.styles, "style", "a key of styles.yaml")
    yield from _unknown((*at, "rooms"), row.rooms, catalogs.rooms, "room type", "a file of rooms/")
    yield from _unknown((*at, "not_in"), row.not_in, catalogs.rooms, "room type", "a file of rooms/")


def _lying_faults(catalogs: Catalogs, at: Key, parent: _Parent, rows: Sequence[Lies]) -> Iterator[Fault]:
    """Checks the last of some rows: what it lies on, and whether it finds room there."""
    row, before = rows[-1], {name for other in rows[:-1] for name in other.put}
    names = {surface.name for _, surfaces in parent.bodies for surface in surfaces}
    yield from _unknown((*at, "surface"), row.surface, names | {ALL}, "surface", ", ".join([*sorted(names), ALL]))
    yield from _unknown((*at, "upon"), row.upon, before | {SURFACE}, "carrier", ", ".join([*sorted(before), SURFACE]))
    for name in row.upon:
        carrier = catalogs.decorations.get(name)
        if carrier is not None and not carrier.surfaces:
            yield Fault("dressing", (*at, "upon"), f"{name!r} has no surface", "a kind with `surfaces`")
    if not names and set(row.upon) <= {SURFACE}:
        yield Fault("dressing", (*at, "put"), f"{at[0]!r} has no surface to lie on", "a parent with `surfaces`")
        return
    for name in row.put:
        kind = catalogs.decorations.get(name)
        places = list(_places(catalogs, parent, row))
        if kind and places and not any(_fits(kind, row, *place) for place in places):
            widest = max(places, key=lambda place: place[0][0])[0]
            yield Fault("dressing", (*at, "put"), f"{name!r} is larger than its surface", f"at most {widest[0]:.2f} x {widest[1]:.2f} m")


def _places(catalogs: Catalogs, parent: _Parent, row: Lies) -> Iterator[tuple[tuple[float, float], Surface]]:
    """Yields the extents of the surfaces that a row's things may lie on."""
    for name in row.upon or (SURFACE,):
        kind = catalogs.decorations.get(name)
        bodies = parent.bodies if name == SURFACE else ((kind.size[:2], kind.surfaces),) if kind else ()
        for (width, depth), surfaces in bodies:
            chosen = (
                [surface for surface in surfaces if ALL in row.surface or surface.name in row.surface] if row.surface else surfaces[-1:]
            )
            yield from (((width - 2 * surface.inset, depth - 2 * surface.inset), surface) for surface in chosen)


def _fits(kind: DecorationKind, row: Lies, extent: tuple[float, float], surface: Surface) -> bool:
    width, depth, height = kind.size[0] * row.least, kind.size[1] * row.least, kind.size[2]
    if row.upright:
        depth, height = height, depth
    if row.turn in (90, 270):
        width, depth = depth, width
    if row.fill:
        width, depth = 0.0, 0.0
    low_enough = surface.clearance is None or height <= surface.clearance + SLACK
    return low_enough and width <= extent[0] + SLACK and depth <= extent[1] + SLACK


def _circles(catalogs: Catalogs) -> Iterator[Fault]:
    """Refuses decorations that would carry one another without end."""
    carries = {
        name: {put for row in catalogs.dressing[name].lies for put in row.put if put in catalogs.dressing}
        for name in catalogs.dressing
        if name in catalogs.decorations
    }
    for start in carries:
        path = _path_back(start, carries)
        if path:
            links = ", ".join(f"{one} carries {other}" for one, other in pairwise(path))
            yield Fault(
                "dressing", (start, "lies"), f"decorations go round in a circle: {links}", "things that carry others, not themselves"
            )
            return


def _path_back(start: str, carries: Mapping[str, set[str]]) -> tuple[str, ...]:
    paths: list[tuple[str, ...]] = [(start,)]
    seen = {start}
    while paths:
        path = paths.pop()
        for name in sorted(carries.get(path[-1], ())):
            if name == start:
                return (*path, name)
            if name not in seen:
                seen.add(name)
                paths.append((*path, name))
    return ()
