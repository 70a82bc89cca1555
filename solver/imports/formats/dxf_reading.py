"""DXF: closed polylines on layers of rooms, shapes on layers of doors, windows and openings, texts as names.

Its y points up. Read by ezdxf, an extra. Blocks are not opened, curves are taken by their points.
"""

from __future__ import annotations

from collections import Counter
from importlib import import_module
from io import StringIO
from typing import Any, Final

from solver.errors import FieldError, SyntaxFault
from solver.imported import Unread
from solver.imports.bounded_files import MOST_BYTES
from solver.imports.drawn import DrawnPlan
from solver.imports.shapes_plan import DrawnShape, DrawnSwing, DrawnText, plan_of_shapes, sort_of

METRES: Final = {1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1.0}
"""What `$INSUNITS` says."""
MOST_ENTITIES: Final = 50_000


def is_dxf(content: bytes) -> bool:
    """Tells whether a file is a DXF text."""
    return [line.strip() for line in content[:200].split(b"\n")[:2]] == [b"0", b"SECTION"] or content.startswith(b"999")


def read_dxf(content: bytes) -> DrawnPlan:
    """Reads the model space of a drawing.

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
    try:
        drawing = ezdxf.read(StringIO(content.decode("utf-8", "replace")))
        space = drawing.modelspace()
        if len(space) > MOST_ENTITIES:
            raise SyntaxFault(f"of more than {MOST_ENTITIES:,} entities")
        return _plan(space, METRES.get(drawing.header.get("$INSUNITS", 0)))
    except (ezdxf.DXFError, ValueError, TypeError, AttributeError, KeyError, IndexError) as error:
        raise SyntaxFault(f"DXF that cannot be read: {type(error).__name__} {error!s:.100}") from None


def _plan(space: Any, metres: float | None) -> DrawnPlan:
    shapes: list[DrawnShape] = []
    texts: list[DrawnText] = []
    swings: list[DrawnSwing] = []
    passed: Counter[tuple[str, str]] = Counter()
    for number, one in enumerate(space):
        kind, layer = one.dxftype(), one.dxf.layer
        where = f"{kind} {one.dxf.handle or number} on layer {layer}"
        if kind == "LWPOLYLINE":
            shapes.append(DrawnShape(layer, tuple((float(x), -float(y)) for x, y in one.get_points("xy")), bool(one.closed), where))
        elif kind == "POLYLINE":
            shapes.append(DrawnShape(layer, tuple((float(p.x), -float(p.y)) for p in one.points()), bool(one.is_closed), where))
        elif kind == "LINE":
            ends = tuple((float(p.x), -float(p.y)) for p in (one.dxf.start, one.dxf.end))
            shapes.append(DrawnShape(layer, ends, False, where))
        elif kind == "ARC" and sort_of(layer) == "door":
            hinge, first, last = ((float(p.x), -float(p.y)) for p in (one.dxf.center, one.start_point, one.end_point))
            swings.append(DrawnSwing(hinge, (first, last), where))
        elif kind in ("TEXT", "MTEXT"):
            at = one.dxf.get("align_point", one.dxf.insert) if kind == "TEXT" else one.dxf.insert
            texts.append(DrawnText(one.dxf.text if kind == "TEXT" else one.plain_text(), float(at.x), -float(at.y)))
        else:
            passed[layer, kind] += 1
    unread = [Unread(f"layer {layer!r:.60}", f"{count} of {kind}, which is not read") for (layer, kind), count in sorted(passed.items())]
    return plan_of_shapes([shape for shape in shapes if shape.points], texts, swings, metres, unread)
