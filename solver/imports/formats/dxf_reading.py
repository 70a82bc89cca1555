"""DXF: closed polylines on layers of rooms, shapes on layers of doors, windows and openings, texts as names.

Its y points up. Read by ezdxf, an extra. Blocks are opened where their name or layer tells what they are; curves are taken by their points.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from importlib import import_module
from io import BytesIO, StringIO
from itertools import islice
from typing import Any, Final, NamedTuple

from solver.errors import FieldError, SyntaxFault
from solver.imported import Unread
from solver.imports.bounded_files import MOST_BYTES
from solver.imports.drawn import DrawnPlan, Spot
from solver.imports.shapes_plan import DrawnShape, DrawnSwing, DrawnText, plan_of_shapes, sort_within

METRES: Final = {1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1.0}
"""What `$INSUNITS` says."""
MOST_ENTITIES: Final = 50_000
BODY: Final = "KIND"
"""What our export's furniture has for an attribute: a wall clock is no wall."""
MOST_PARTS: Final = 150_000
"""Entities, vertices and entries of tables in a file, counted before it is read."""
DEEPEST: Final = 8
"""Blocks within blocks."""


def is_dxf(content: bytes) -> bool:
    """Tells whether a file is a DXF text."""
    return [line.strip() for line in content[:200].split(b"\n")[:2]] == [b"0", b"SECTION"] or content.startswith(b"999")


def read_dxf(content: bytes, metres: float | None = None) -> DrawnPlan:
    """Reads the model space of a drawing; `metres` is the length of its unit, where the caller says it.

    Raises:
        FieldError: ezdxf is not installed; or there is more in it than in any home.
        SyntaxFault: it cannot be read.
    """
    try:
        ezdxf = import_module("ezdxf")
    except ImportError:
        raise FieldError("file", "is DXF, which needs ezdxf", "pip install 'compose-homes[dxf]'") from None
    if len(content) > MOST_BYTES:
        raise SyntaxFault(f"larger than {MOST_BYTES >> 20} MB")
    if sum(map(_begins_a_part, islice(BytesIO(content), 0, None, 2))) > MOST_PARTS:
        raise SyntaxFault(f"of more than {MOST_PARTS:,} entities, vertices and entries")
    try:
        drawing = ezdxf.read(StringIO(content.decode("utf-8", "replace")))
        space = drawing.modelspace()
        if len(space) > MOST_ENTITIES:
            raise SyntaxFault(f"of more than {MOST_ENTITIES:,} entities")
        return _plan(space, metres or METRES.get(drawing.header.get("$INSUNITS", 0)))
    except (ezdxf.DXFError, ValueError, TypeError, AttributeError, LookupError, ArithmeticError) as error:
        raise SyntaxFault(f"DXF that cannot be read: {type(error).__name__} {error!s:.100}") from None


def _begins_a_part(code: bytes) -> bool:
    """Tells whether the first line of a pair is 0, in any way in which numbers are read."""
    return not code.isascii() or not code.strip().lstrip(b"+-_0")


class _Entity(NamedTuple):
    """An entity, its layer, what its layers and blocks tell it is, its place in the file."""

    it: Any
    layer: str
    sort: str | None
    where: str


def _opened(space: Any) -> Iterator[_Entity]:
    """Yields what is drawn; of blocks of doors, windows, openings, walls and rooms what is in them.

    Raises:
        SyntaxFault: with its blocks it is more than in any plan.
    """
    ahead = [(one, (one.dxf.layer,), f"{one.dxf.handle or number}", 0) for number, one in enumerate(space)][::-1]
    made = len(ahead)
    while ahead:
        one, names, number, depth = ahead.pop()
        kind = one.dxftype()
        inner = (*names, one.dxf.name) if kind == "INSERT" else names
        if kind == "INSERT" and depth < DEEPEST and sort_within(inner) and not one.has_attrib(BODY):
            made += one.mcount
            copies = (one,) if one.mcount == 1 else one.multi_insert() if made <= MOST_ENTITIES else ()
            parts = list(islice((part for copy in copies for part in copy.virtual_entities()), MOST_ENTITIES))
            made += len(parts)
            if made > MOST_ENTITIES:
                raise SyntaxFault(f"of more than {MOST_ENTITIES:,} entities, each as often as its block is inserted")
            for part in reversed(parts):
                own = () if part.dxf.layer == "0" else (part.dxf.layer,)
                ahead.append((part, (*inner, *own), number, depth + 1))
        else:
            yield _Entity(one, names[0], sort_within(names), f"{kind} {number} on layer {names[0]}")


def _plan(space: Any, metres: float | None) -> DrawnPlan:
    shapes: list[DrawnShape] = []
    texts: list[DrawnText] = []
    swings: list[DrawnSwing] = []
    passed: Counter[tuple[str, str]] = Counter()
    for one, layer, sort, where in _opened(space):
        kind = one.dxftype()
        if kind == "LWPOLYLINE":
            shapes.append(DrawnShape(layer, _spots(one.vertices_in_wcs()), bool(one.closed), where, sort))
        elif kind == "POLYLINE":
            shapes.append(DrawnShape(layer, _spots(one.points_in_wcs()), bool(one.is_closed), where, sort))
        elif kind == "LINE":
            shapes.append(DrawnShape(layer, _spots((one.dxf.start, one.dxf.end)), False, where, sort))
        elif kind == "ARC" and sort == "door":
            hinge, first, last = _spots((one.ocs().to_wcs(one.dxf.center), one.start_point, one.end_point))
            swings.append(DrawnSwing(hinge, (first, last), where))
        elif kind in ("TEXT", "MTEXT"):
            at = one.dxf.get("align_point", one.dxf.insert) if kind == "TEXT" else one.dxf.insert
            texts.append(DrawnText(one.dxf.text if kind == "TEXT" else one.plain_text(), float(at.x), -float(at.y)))
        else:
            passed[layer, kind] += 1
    unread = [Unread(f"layer {layer!r:.60}", f"{count} of {kind}, which is not read") for (layer, kind), count in sorted(passed.items())]
    return plan_of_shapes([shape for shape in shapes if shape.points], texts, swings, lambda _: metres, unread)


def _spots(points: Iterable[Any]) -> tuple[Spot, ...]:
    """Returns points with y pointing south."""
    return tuple((float(point.x), -float(point.y)) for point in points)
