"""Files made to cost an importer more than they should: one function a file, each within what the service takes as a body.

They differ from `test_hostile_files.REFUSED` in size: what is wrong with them is how much there is of it.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from typing import Final

from tests.imports.plans import Feature, box, collection, line, piece, polygon

MAKERS: Final[dict[str, Callable[[], bytes]]] = {}


def hostile(make: Callable[[], bytes]) -> Callable[[], bytes]:
    MAKERS[make.__name__] = make
    return make


def _features(*features: Feature, **members: object) -> bytes:
    return json.dumps({**collection(*features), **members}).encode()


def _circle(count: int, radius: float, x: float = 0.0, y: float = 0.0) -> list[tuple[float, float]]:
    ways = [2 * math.pi * at / count for at in range(count)]
    return [(x + radius * math.cos(way), y + radius * math.sin(way)) for way in ways]


def _star(count: int, inner: float, outer: float, x: float = 0.0) -> list[tuple[float, float]]:
    return [
        (x + r * math.cos(math.pi * at / count), r * math.sin(math.pi * at / count))
        for at in range(2 * count)
        for r in [outer if at % 2 else inner]
    ]


@hostile
def geojson_of_many_holes() -> bytes:
    plan = collection(box("Kitchen", 0, 0, 40, 30))
    rings = [[[x, y], [x + 0.1, y], [x + 0.1, y + 0.1], [x, y + 0.1]] for x in range(1, 39) for y in range(1, 29) for _ in range(40)]
    plan["features"][0]["geometry"]["coordinates"] += rings
    return json.dumps(plan).encode()


@hostile
def geojson_of_nested_coordinates() -> bytes:
    return _features(box("Kitchen", 0, 0, 4, 3)).replace(b"[[[0", b"[" * 20_000 + b"0", 1)


@hostile
def geojson_of_a_comb() -> bytes:
    """A thousand corners: 250 teeth of 1 cm in a hall of 100 m."""
    teeth = [(x, y) for at in range(249) for x, y in ((at * 0.4, 0.0), (at * 0.4, 90.0), (at * 0.4 + 0.01, 90.0), (at * 0.4 + 0.01, 0.0))]
    return _features(polygon("Hall", *teeth, (100.0, 0.0), (100.0, 100.0), (0.0, 100.0)), unit="m")


@hostile
def geojson_of_five_hundred_circles() -> bytes:
    return _features(*(polygon("Kitchen", *_circle(10, 30.0, at * 0.3)) for at in range(500)), unit="m")


@hostile
def geojson_of_stars() -> bytes:
    """Slanted walls as far as the bounds of the format go: five rooms of 998 corners, 900 m across."""
    return _features(*(polygon("Kitchen", *_star(499, 100.0, 450.0, at)) for at in range(5)), unit="m")


@hostile
def geojson_of_rooms_upon_each_other() -> bytes:
    return _features(*(box("Kitchen", at / 97, at / 89, at / 97 + 6, at / 89 + 5) for at in range(500)), unit="m")


@hostile
def geojson_of_a_grid_of_walls() -> bytes:
    walls = [line("wall", (at / 40, 0), (at / 40, 60)) for at in range(2_400)] + [
        line("wall", (0, at / 40), (60, at / 40)) for at in range(2_400)
    ]
    rooms = [box("Bedroom", x * 2.6, y * 3, x * 2.6 + 2.6, y * 3 + 3) for x in range(22) for y in range(20)]
    return _features(*rooms, *walls, unit="m")


@hostile
def geojson_of_openings_in_every_wall() -> bytes:
    rooms = [box("Bedroom", x * 2.6, y * 3, x * 2.6 + 2.6, y * 3 + 3) for x in range(22) for y in range(22)]
    doors = [
        line("door", (at % 22 * 2.6 + at % 7 / 10, at // 22 % 22 * 3), (at % 22 * 2.6 + 0.9 + at % 7 / 10, at // 22 % 22 * 3))
        for at in range(4_900)
    ]
    return _features(*rooms, *doors, unit="m")


@hostile
def geojson_of_a_store_of_chairs() -> bytes:
    chairs = (piece("Chair", at % 70 / 2, at // 70 / 2, width=0.45, depth=0.45, height=0.9) for at in range(4_900))
    return _features(box("Living room", 0, 0, 36, 36), *chairs, unit="m")


@hostile
def geojson_of_small_things_upon_each_other() -> bytes:
    things = (piece("Book", 2, 2, width=0.2, depth=0.2, height=0.01, elevation=at * 0.01) for at in range(4_900))
    return _features(box("Living room", 0, 0, 6, 6), *things, unit="m")


@hostile
def geojson_far_away_and_tiny() -> bytes:
    """A kitchen 900,000 km from the origin: its corners lie closer than the numbers there."""
    return _features(polygon("Kitchen", *((9e8 + x * 1e-7, 9e8 + y * 1e-7) for x, y in ((0, 0), (4, 0), (4, 3), (0, 3)))))


@hostile
def geojson_of_many_levels() -> bytes:
    return _features(*(box("Kitchen", 0, 0, 4, 3, level=at * 1_000_003) for at in range(500)), unit="m")


@hostile
def geojson_of_long_names() -> bytes:
    return _features(*(box("k" * 16_000, at * 5, 0, at * 5 + 4, 3) for at in range(400)), unit="m")


@hostile
def procthor_of_many_corners() -> bytes:
    rooms = [{"id": f"r{k}", "roomType": "Kitchen", "floorPolygon": [{"x": at, "y": 0, "z": k} for at in range(4_900)]} for k in range(50)]
    return json.dumps({"rooms": rooms}).encode()


@hostile
def procthor_of_doors_of_one_wall() -> bytes:
    corners = [{"x": x, "y": 0, "z": z} for x, z in ((0, 0), (4, 0), (4, 3), (0, 3))]
    wall = {"id": "w", "polygon": corners}
    doors = [{"id": f"d{at}", "wall0": "w", "holePolygon": [{"x": 0, "y": 0, "z": 0}, {"x": 1, "y": 2, "z": 0}]} for at in range(60_000)]
    return json.dumps({"rooms": [{"id": "a", "roomType": "Kitchen", "floorPolygon": corners}], "walls": [wall], "doors": doors}).encode()


@hostile
def rplan_of_many_loops() -> bytes:
    edges = [[0, 0, 9, 0], [9, 0, 9, 9], [9, 9, 0, 9], [0, 9, 0, 0]] * 1_200
    return json.dumps({"room_type": [2] * 4_000, "boxes": [], "edges": edges, "ed_rm": [[at % 4_000] for at in range(4_800)]}).encode()


@hostile
def json_of_many_empty_lists() -> bytes:
    return b'{"type": "FeatureCollection", "features": [' + b"[]," * 2_500_000 + b"[]]}"


@hostile
def json_of_many_keys() -> bytes:
    return b'{"type": "FeatureCollection", "features": [], ' + b",".join(b'"%d": {}' % at for at in range(500_000)) + b"}"


@hostile
def yaml_of_aliases() -> bytes:
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x, x]"] + [f"a{at}: &a{at} [{', '.join([f'*a{at - 1}'] * 10)}]" for at in range(1, 12)]
    return ("rooms: []\n" + "\n".join(lines)).encode()
