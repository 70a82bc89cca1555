"""What must hold between shapes, the kinds that have them, and materials; and shapes written out for a kind.

That is with mirror images, the boards of hollow parts, what moves with which front, and the trays of drawers.
"""

from collections.abc import Iterator, Mapping, Sequence
from math import pi
from typing import Any, Final, NamedTuple

from catalogs.entries import KindSpec, Surface
from catalogs.faults import Fault
from catalogs.references import near
from catalogs.schema import Catalogs
from catalogs.shapes import DRAWN, MOST_SOLIDS, QUARTER, Axis, Hollow, ShapePart, Solid, heights, images
from catalogs.synonyms import KindSize

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


BOARD: Final = 0.018
"""How thick a carcass' boards are, m."""
TRAY: Final = 0.012
"""How thick a drawer's bottom and sides are, m."""
BESIDE: Final = 0.015
"""How far a tray stays off what is beside it, and so half as much more from below, m."""
UNDER: Final = 0.02
"""How far a tray's sides stay under the upper edge of their front, and its back before the carcass', m."""
TRAY_HEIGHT: Final = 0.14
"""Sides of trays are at most so high, m."""
RECESSED: Final = 0.005
"""How far uprights stand behind the edges of boards, m: two faces in one plane flicker."""
Interval = tuple[float, float]


class _Inside(NamedTuple):
    """The room inside a hollow part, shares; `number` tells the hollow parts of a shape apart."""

    x: Interval
    y: Interval
    z: Interval
    number: int
    material: str


class PartFault(NamedTuple):
    """What does not fit at a part of a shape: its number and key, the problem, what would do."""

    part: int
    key: str
    problem: str
    allowed: str


def solids(parts: Sequence[ShapePart], surfaces: Mapping[str, float], size: KindSize) -> tuple[Solid, ...]:
    """Writes a shape out for a kind.

    Args:
        parts: the shape; every name in it is a surface's or a front's, every span lies the right way up (`part_faults` finds none).
        surfaces: the kind's surfaces' heights by name, as shares of its own height.
        size: its width, depth and height, m.
    """
    made: list[Solid] = []
    insides: list[_Inside] = []
    panels: list[tuple[Solid, float]] = []
    for part in parts:
        shown = images(part, heights(part, surfaces))
        for image, front in zip(shown, _fronts(part, len(shown), parts), strict=True):
            solid = image if front is None else _with(image, front=front)
            if part.hollow is not None:
                inside = _Inside(*_inner(image, part.hollow, size), len(insides), image.material)
                insides.append(inside)
                made += _boards(image, part.hollow, inside, size)
            elif image.opens is None:
                made.append(solid)
            else:
                panels.append((solid, part.range or 0.0))
    for panel, wished in panels:
        made += _drawer(panel, wished or DRAWN, insides, size) if panel.opens == "drawer" else [_with(panel, range=wished or QUARTER)]
    return tuple(made)


def part_faults(parts: Sequence[ShapePart], surfaces: Mapping[str, float], size: KindSize) -> Iterator[PartFault]:
    """Yields what does not fit together among the fronts and hollow parts of a shape whose heights are known to be right."""
    names = [part.name for part in parts if part.name]
    hollow = [image for part in parts if part.hollow is not None for image in images(part, heights(part, surfaces))]
    for number, part in enumerate(parts):
        shown = images(part, heights(part, surfaces))
        if part.name and names.count(part.name) > 1:
            yield PartFault(number, "name", f"two fronts are called {part.name!r}", "another name")
        if part.moves_with is not None:
            panel = next((one for one in parts if one.name == part.moves_with), None)
            if panel is None:
                yield PartFault(number, "with", f"there is no front {part.moves_with!r}", ", ".join(names) or "a part that opens")
            elif panel.mirror and panel.mirror != part.mirror:
                yield PartFault(number, "with", f"the front {part.moves_with!r} is mirrored and this is not", f"mirror: {panel.mirror}")
        if part.hollow is not None and any(min(span[1] - span[0] for span in _inner(image, part.hollow, size)) <= 0 for image in shown):
            yield PartFault(number, "hollow", "boards of 18 mm leave nothing free in it", "a larger box")
        if part.opens == "drawer" and not all(_is_before(image, hollow) for image in shown):
            yield PartFault(number, "opens", "a drawer is before a hollow part", "hollow at the part behind it")


def _with(solid: Solid, **change: Any) -> Solid:
    return solid.model_copy(update=change)


def _fronts(part: ShapePart, count: int, parts: Sequence[ShapePart]) -> list[str | None]:
    """Returns the front that each image of a part belongs to."""
    name = part.name or part.moves_with
    if name is None:
        return [None] * count
    panel = next(one for one in parts if one.name == name)
    return [name, f"{name}_2"] if panel.mirror else [name] * count


def _inner(image: Solid, hollow: Hollow, size: KindSize) -> tuple[Interval, Interval, Interval]:
    """Returns the room between the boards of a hollow part, as far as it is open."""
    width, depth, height = size
    (x0, x1), (y0, y1), (z0, z1) = image.x, image.y, image.z
    across, up, along = BOARD / width, BOARD / height, BOARD / depth
    if hollow.open == "top":
        return (x0 + across, x1 - across), (y0 + up, y1), (z0 + along, z1 - along)
    return (x0 + across, x1 - across), (y0 + up, y1 - up), (z0 + along, z1)


def _boards(image: Solid, hollow: Hollow, inside: _Inside, size: KindSize) -> Iterator[Solid]:
    """Yields a back, sides, bottom, and top or front, and what is inside."""
    width, depth, height = size
    x, y, z = inside.x, inside.y, inside.z
    thick = BOARD / width, BOARD / height
    uprights = [at for one in hollow.uprights for at in dict.fromkeys((one, round(1 - one, 9))) if image.x[0] < at < image.x[1]]
    spans = [
        (image.x, image.y, (image.z[0], z[0])),
        ((image.x[0], x[0]), image.y, z),
        ((x[1], image.x[1]), image.y, z),
        (x, (image.y[0], y[0]), z),
        (x, (y[1], image.y[1]), z) if hollow.open == "front" else (image.x, image.y, (z[1], image.z[1])),
        *((x, (top - thick[1], top), z) for top in hollow.boards),
        *(((at - thick[0] / 2, at + thick[0] / 2), y, (z[0], z[1] - RECESSED / depth)) for at in uprights),
    ]
    yield from (_box(image, span, board=inside.number) for span in spans)


def _box(like: Solid, spans: tuple[Interval, Interval, Interval], **change: Any) -> Solid:
    named: dict[Axis, Interval] = dict(zip(("x", "y", "z"), (_rounded(span) for span in spans), strict=True))
    return Solid(form="box", axis="y", taper=1.0, material=like.material, **named, **change)


def _rounded(span: Interval) -> Interval:
    return round(span[0], 9), round(span[1], 9)


def _is_before(panel: Solid, hollow: Sequence[Solid]) -> bool:
    """Tells whether the middle of a front lies before one of the hollow parts."""
    x, y = sum(panel.x) / 2, sum(panel.y) / 2
    return any(one.x[0] < x < one.x[1] and one.y[0] < y < one.y[1] and one.z[1] <= panel.z[0] + 1e-9 for one in hollow)


def _drawer(panel: Solid, share: float, insides: Sequence[_Inside], size: KindSize) -> Iterator[Solid]:
    """Yields a drawer's front, and its tray: a bottom, sides and a back."""
    width, depth, height = size
    x, y = sum(panel.x) / 2, sum(panel.y) / 2
    behind = next(one for one in insides if one.x[0] < x < one.x[1] and one.y[0] < y < one.y[1])
    left, right = max(panel.x[0], behind.x[0]) + BESIDE / width, min(panel.x[1], behind.x[1]) - BESIDE / width
    low = max(panel.y[0], behind.y[0]) + BESIDE / 2 / height
    high = min(panel.y[1] - UNDER / height, behind.y[1] - UNDER / height, low + TRAY_HEIGHT / height)
    back, front = behind.z[0] + UNDER / depth, panel.z[0]
    yield _with(panel, range=round(share * (front - back), 9))
    side, floor, rear = TRAY / width, low + TRAY / height, back + TRAY / depth
    spans = (
        ((left, right), (low, floor), (back, front)),
        ((left, left + side), (floor, high), (back, front)),
        ((right - side, right), (floor, high), (back, front)),
        ((left + side, right - side), (floor, high), (back, rear)),
    )
    yield from (_with(_box(panel, span, board=behind.number), material=behind.material, front=panel.front) for span in spans)
