"""What must hold between decorations, what they lie on, and the rooms they are in."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from graphlib import CycleError, TopologicalSorter
from itertools import pairwise

from catalogs.decoration_types import ALL, INDOOR, SURFACE, Decorating, DecorationKind, Holds, Lies
from catalogs.entries import KindSpec
from catalogs.faults import Fault, Key
from catalogs.insides import insides_of
from catalogs.references import near
from catalogs.schema import Catalogs

SLACK = 1e-9


def decorating_faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Yields everything that does not fit together in decorations.yaml and decorating.yaml."""
    for name, kind in catalogs.decorations.items():
        if kind.jitter and kind.surfaces:
            yield Fault("decorations", (name, "jitter"), "what carries things lies straight", "no `jitter` beside `surfaces`")
    for name, entry in catalogs.decorating.items():
        yield from _entry_faults(catalogs, name, entry)
    yield from _circles(catalogs)


def _parents(catalogs: Catalogs, name: str) -> list[Sequence[KindSpec]]:
    """Returns what bears a name: at most one of each sort; a room is no kind at all."""
    pieces = [entry for kind, entry in catalogs.furniture.items() if (entry.name or kind) == name]
    things = [catalogs.decorations[name]] if name in catalogs.decorations else []
    room: list[Sequence[KindSpec]] = [()] if name in catalogs.rooms or name == INDOOR else []
    return [*(found for found in (pieces, things) if found), *room]


def _entry_faults(catalogs: Catalogs, name: str, entry: Decorating) -> Iterator[Fault]:
    parents = _parents(catalogs, name)
    if len(parents) != 1:
        words = {*catalogs.kinds_by_name(), *catalogs.decorations, *catalogs.rooms, INDOOR}
        problem = f"unknown parent {name!r}{near(name, words)}" if not parents else f"{name!r} is a name of several things"
        yield Fault("decorating", (name,), problem, "a name of furniture.yaml, a key of decorations.yaml or of rooms/, or indoor")
        return
    (kinds,) = parents
    if entry.holds and not any(kind in catalogs.furniture.values() for kind in kinds):
        yield Fault("decorating", (name, "holds"), "furniture alone holds things", "`lies` for what is on a thing")
        return
    if not kinds and entry.lies:
        yield Fault("decorating", (name, "lies"), "things lie on furniture and decorations", "`stands` for a room's floor")
    if kinds and entry.stands:
        yield Fault("decorating", (name, "stands"), "things stand on a room's floor", "`lies` for what is on a piece")
    for i in range(len(entry.lies)):
        yield from _lying_faults(catalogs, (name, "lies", i), kinds, entry.lies[: i + 1])


def holding_faults(catalogs: Catalogs) -> Iterator[Fault]:
    """Yields every row of what furniture `holds` that has no room inside any kind of its name; shapes are known by now."""
    for name, entry in catalogs.decorating.items():
        for i, row in enumerate(entry.holds):
            yield from _holding_faults(catalogs, (name, "holds", i), name, row)


def _holding_faults(catalogs: Catalogs, at: Key, name: str, row: Holds) -> Iterator[Fault]:
    """Checks that a row has room inside any kind of that name."""
    kinds = {kind: entry for kind, entry in catalogs.furniture.items() if (entry.name or kind) == name}
    inside = [one for kind, entry in kinds.items() for one in insides_of(catalogs.shapes.get(kind, ()), entry.size)]
    if not any(one.sort in row.surface for one in inside):
        yield Fault("decorating", (*at, "surface"), f"{name!r} has no {' or '.join(row.surface)} inside", "a shape with a `hollow` part")
        return
    places = [((one.x[1] - one.x[0], one.z[1] - one.z[0]), one.clearance) for one in inside if one.sort in row.surface]
    for thing in row.put:
        kind = catalogs.decorations.get(thing)
        if kind and not any(_fits(kind, row, *place) for place in places):
            yield Fault("decorating", (*at, "put"), f"{thing!r} is larger than {' and '.join(row.surface)} in {name!r}", "a smaller thing")


def _unknown(at: Key, words: Sequence[str], known: Collection[str], what: str, allowed: str) -> Iterator[Fault]:
    for word in words:
        if word not in known:
            yield Fault("decorating", at, f"unknown {what} {word!r}{near(word, known)}", allowed)


def _lying_faults(catalogs: Catalogs, at: Key, parents: Sequence[KindSpec], rows: Sequence[Lies]) -> Iterator[Fault]:
    """Checks the last of some rows: what it lies on, and whether it finds room there."""
    row, before = rows[-1], {name for other in rows[:-1] for name in other.put}
    names = {surface.name for parent in parents for surface in parent.surfaces}
    yield from _unknown((*at, "surface"), row.surface, names | {ALL}, "surface", ", ".join([*sorted(names), ALL]))
    yield from _unknown((*at, "on"), row.on, before | {SURFACE}, "carrier", ", ".join([*sorted(before), SURFACE]))
    for name in row.on:
        carrier = catalogs.decorations.get(name)
        if carrier is not None and not carrier.surfaces:
            yield Fault("decorating", (*at, "on"), f"{name!r} has no surface", "a kind with `surfaces`")
    if not names and set(row.on) <= {SURFACE}:
        yield Fault("decorating", (*at, "put"), f"{at[0]!r} has no surface to lie on", "a parent with `surfaces`")
        return
    for name in row.put:
        kind = catalogs.decorations.get(name)
        places = list(_places(catalogs, parents, row))
        if kind and places and not any(_fits(kind, row, *place) for place in places):
            widest = max(places, key=lambda place: place[0][0])[0]
            yield Fault("decorating", (*at, "put"), f"{name!r} is larger than its surface", f"at most {widest[0]:.2f} x {widest[1]:.2f} m")


def _places(catalogs: Catalogs, parents: Sequence[KindSpec], row: Lies) -> Iterator[tuple[tuple[float, float], float | None]]:
    """Yields the extents of the surfaces that a row's things may lie on, and the free height above."""
    for name in row.on or (SURFACE,):
        thing = catalogs.decorations.get(name)
        for kind in parents if name == SURFACE else [thing] if thing else []:
            named = [surface for surface in kind.surfaces if ALL in row.surface or surface.name in row.surface]
            for surface in named if row.surface else kind.surfaces[-1:]:
                yield (kind.size[0] - 2 * surface.inset, kind.size[1] - 2 * surface.inset), surface.clearance


def _fits(kind: DecorationKind, row: Lies, extent: tuple[float, float], clearance: float | None) -> bool:
    width, depth, height = kind.size[0] * row.min_scale, kind.size[1] * row.min_scale, kind.size[2]
    if row.upright:
        depth, height = height, depth
    if row.turn in (90, 270):
        width, depth = depth, width
    if row.fill:
        width, depth = 0.0, 0.0
    low_enough = clearance is None or height <= clearance + SLACK
    return low_enough and width <= extent[0] + SLACK and depth <= extent[1] + SLACK


def _circles(catalogs: Catalogs) -> Iterator[Fault]:
    """Refuses decorations that would carry one another without end."""
    things = catalogs.decorating.keys() & catalogs.decorations.keys()
    carries = {name: {put for row in catalogs.decorating[name].lies for put in row.put} & things for name in sorted(things)}
    try:
        TopologicalSorter(carries).prepare()
    except CycleError as circle:
        path = circle.args[1][::-1]
        links = ", ".join(f"{one} carries {other}" for one, other in pairwise(path))
        problem = f"decorations go round in a circle: {links}"
        yield Fault("decorating", (path[0], "lies"), problem, "things that carry others, not themselves")
