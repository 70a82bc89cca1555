"""Plans as documents, for tests: GeoJSON collections and their parts."""

from __future__ import annotations

import json
from collections.abc import Sequence
from io import StringIO
from typing import Any

from solver.answers import ImportSettings, PlanImport
from solver.pipeline.import_plan import import_plan
from solver.scene import Opening, Room

Feature = dict[str, Any]


def polygon(name: str, *points: tuple[float, float], **more: Any) -> Feature:
    return {"properties": {"name": name, **more}, "geometry": {"type": "Polygon", "coordinates": [[*map(list, points), list(points[0])]]}}


def box(name: str, x0: float, y0: float, x1: float, y1: float, **more: Any) -> Feature:
    return polygon(name, (x0, y0), (x1, y0), (x1, y1), (x0, y1), **more)


def line(kind: str, a: tuple[float, float], b: tuple[float, float], **more: Any) -> Feature:
    return {"properties": {"kind": kind, **more}, "geometry": {"type": "LineString", "coordinates": [list(a), list(b)]}}


def piece(name: str, x: float, y: float, **more: Any) -> Feature:
    return {"properties": {"name": name, **more}, "geometry": {"type": "Point", "coordinates": [x, y]}}


def collection(*features: Feature, **more: Any) -> dict[str, Any]:
    return {"type": "FeatureCollection", "unit": "m", "features": json.loads(json.dumps(features)), **more}


def read(document: object, name: str = "", **settings: Any) -> PlanImport:
    content = document if isinstance(document, bytes) else json.dumps(document).encode()
    return import_plan(content, name, ImportSettings(**settings))


def text_of(drawing: Any) -> str:
    """The file of a drawing of ezdxf's."""
    text = StringIO()
    drawing.write(text)
    return text.getvalue()


def imported(drawing: Any, **settings: Any) -> PlanImport:
    """What is read of a drawing of ezdxf's."""
    return read(text_of(drawing).encode(), "plan.dxf", **settings)


def rooms_of(answer: PlanImport) -> dict[str, Room]:
    return {room.id: room for room in answer.scene.rooms}


def opening(room: Room, name: str) -> Opening:
    (found,) = [one for one in room.openings if one.id == name]
    return found


def floor_area(corners: Sequence[tuple[float, float]]) -> float:
    following = [*corners[1:], *corners[:1]]
    return sum(x * next_z - next_x * z for (x, z), (next_x, next_z) in zip(corners, following, strict=True)) / 2
