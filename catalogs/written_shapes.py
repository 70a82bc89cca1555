"""Shapes written out for a kind: mirror images, the boards of hollow parts, what moves with which front, the trays of drawers."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Final, NamedTuple

from catalogs.shapes import DRAWN, QUARTER, Axis, Hollow, ShapePart, Solid, heights, images
from catalogs.synonyms import KindSize

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
            if part.hollow is not None:
                inside = _Inside(*_inner(image, part.hollow, size), len(insides), image.material)
                insides.append(inside)
                made += _boards(image, part.hollow, inside, size)
            elif image.opens is None:
                made.append(image.model_copy(update={"front": front}))
            else:
                panels.append((image.model_copy(update={"front": front}), part.range or 0.0))
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
