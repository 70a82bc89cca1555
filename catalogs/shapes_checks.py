"""What must hold between shapes, the kinds that have them, and materials."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from math import pi
from typing import Final

from catalogs.entries import KindSpec, Surface
from catalogs.faults import Fault
from catalogs.references import near
from catalogs.schema import Catalogs
from catalogs.shapes import MOST_SOLIDS, ShapePart, Solid, heights
from catalogs.written_shapes import part_faults, solids

Shapes = Mapping[str, tuple[ShapePart, ...]]
LEVEL: Final = 0.01
"""A part's top is a surface if it lies within so much of it, m."""
CARRYING: Final = 0.25
"""At least this share of a surface is some part's top: the rim of a tub is a surface, and so is a cistern."""
ROUND: Final = ("cylinder", "cone", "ball", "capsule")
POSES: Final = ("seated", "upright")
"""A kind may have shapes of its own for these: `person_seated`, `book_upright` (tipped onto its lower edge)."""


def shape_of(catalogs: Catalogs, kind: str, shapes: Shapes) -> str:
    """Returns the name of a kind's shape: the one it names, else that of its own name, else what scenes call it: there may be none."""
    entry = catalogs.furniture.get(kind) or catalogs.decorations[kind]
    return entry.shape or (kind if kind in shapes else catalogs.name_of(kind))


def shaped(catalogs: Catalogs, shapes: Shapes) -> dict[str, tuple[Solid, ...]]:
    """Writes out the shape of every kind that has one and agrees with it, and those of its poses."""
    made = {}
    for kind, entry in (catalogs.furniture | catalogs.decorations).items():
        name = shape_of(catalogs, kind, shapes)
        if name in shapes and not any(_fit_faults(name, shapes[name], kind, entry)):
            made[kind] = solids(shapes[name], _levels(entry), entry.size)
            made |= {f"{kind}_{pose}": solids(shapes[posed], {}, entry.size) for pose in POSES if (posed := f"{name}_{pose}") in shapes}
    return made


def shape_faults(catalogs: Catalogs, shapes: Shapes) -> Iterator[Fault]:
    """Yields everything about shapes that does not fit together."""
    specs = catalogs.furniture | catalogs.decorations
    known = {word for kind, entry in specs.items() for word in (kind, catalogs.name_of(kind), entry.shape) if word}
    known |= {f"{word}_{pose}" for word in known for pose in POSES}
    for name, parts in shapes.items():
        if name not in known:
            problem = f"nothing has the shape {name!r}{near(name, known)}"
            yield Fault("shapes", (name,), problem, "a kind, its name, or what one names as its shape")
        yield from _pose_faults(name, parts)
    for kind, entry in specs.items():
        shape = shape_of(catalogs, kind, shapes)
        if shape in shapes:
            yield from _fit_faults(shape, shapes[shape], kind, entry)


def _pose_faults(name: str, parts: tuple[ShapePart, ...]) -> Iterator[Fault]:
    """Refuses names of surfaces in the shape of a pose: what sits, or is tipped, carries nothing."""
    if name.endswith(tuple(f"_{pose}" for pose in POSES)):
        for i, part in enumerate(parts):
            if any(isinstance(end, str) for end in part.y):
                yield Fault("shapes", (name, i, "y"), "the shape of a pose has no surfaces", "numbers")


def _fit_faults(name: str, parts: tuple[ShapePart, ...], kind: str, entry: KindSpec) -> Iterator[Fault]:
    """Checks that a shape is one for a kind; every fault is the shape's."""
    levels = _levels(entry)
    known = ", ".join(levels) or f"numbers: {kind!r} has no surfaces"
    unfit = False
    for i, part in enumerate(parts):
        strange = [end for end in part.y if isinstance(end, str) and end not in levels]
        if strange:
            yield Fault("shapes", (name, i, "y"), f"{kind!r} has no surface {strange[0]!r}", known)
        elif not (ends := heights(part, levels))[0] < ends[1]:
            yield Fault("shapes", (name, i, "y"), f"for {kind!r} it is [{ends[0]:.3f}, {ends[1]:.3f}]", "[lower, higher]")
        else:
            continue
        unfit = True
    if not unfit:
        found = list(part_faults(parts, levels, entry.size))
        yield from (Fault("shapes", (name, fault.part, fault.key), fault.problem, fault.allowed) for fault in found)
        if not found:
            yield from _whole_faults(name, solids(parts, levels, entry.size), kind, entry)


def _whole_faults(name: str, made: tuple[Solid, ...], kind: str, entry: KindSpec) -> Iterator[Fault]:
    if len(made) > MOST_SOLIDS:
        yield Fault("shapes", (name,), f"has {len(made)} parts with its mirror images, boards and trays", f"at most {MOST_SOLIDS}")
    for surface in entry.surfaces:
        if _carried(surface, made, entry.size) < CARRYING:
            problem = f"{kind!r} has a surface {surface.name!r} at {surface.height} m, where hardly any part has its top"
            yield Fault("shapes", (name,), problem, f"a part with y: [..., {surface.name}]")


def _levels(entry: KindSpec) -> dict[str, float]:
    return {surface.name: min(surface.height / entry.size[2], 1.0) for surface in entry.surfaces}


def _carried(surface: Surface, made: tuple[Solid, ...], size: tuple[float, float, float]) -> float:
    """Returns the share of a surface that is the top of some solid (solids do not lie in each other)."""
    width, depth, height = size
    margins = surface.inset / width, surface.inset / depth
    area = 0.0
    for solid in made:
        if abs(solid.y[1] * height - surface.height) <= LEVEL:
            sides = zip((solid.x, solid.z), margins, strict=True)
            spans = [max(min(high, 1 - margin) - max(low, margin), 0.0) for (low, high), margin in sides]
            area += spans[0] * spans[1] * (pi / 4 if solid.form in ROUND else 1.0)
    return area / ((1 - 2 * margins[0]) * (1 - 2 * margins[1]))
