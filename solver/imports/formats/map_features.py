"""What maps of the indoors say of their features, IMDF's and OpenStreetMap's, in the words of our GeoJSON; doors that they draw as points.

Comes in: features' properties. Goes out: the same in our words, or why a feature is left out. May import: drawn.
"""

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any, Final, get_args

from solver.imports.drawn import DrawnOpening, DrawnRoom, OpeningKind, Spot

LEVELS: Final = re.compile(r"(-?\d{1,3})(?:[;,-].*)?")
"""A storey's number in letters; of several the first counts."""
NUMBER: Final = re.compile(r"(\d{1,4}(?:\.\d+)?)(?: ?m)?")
SIZES: Final = ("width", "depth", "height")
"""What maps give as numbers in letters."""
PARTS: Final = {"unit": "Polygon", "opening": "LineString"}
"""What is read of IMDF, and how it is drawn."""
NO_ROOM: Final = ("level", "wall", "no", "building")
"""What OpenStreetMap calls `indoor` that is no room, and what lies around all."""
ANY_ROOM: Final = ("room", "area", "yes", "unspecified")
"""What it calls so without a word of what it is."""
NAMES: Final = ("name", "room_name", "label")
"""What rooms are called under, the first of them that is said."""
STOREYS: Final = ("level", "floor", "storey", "vertical_order")
"""What storeys are numbered under, the first of them that is a number."""
DOOR: Final = 0.9
"""How wide an opening that is drawn as a point is, m, where the map does not say."""
IMDF: Final[Mapping[str, Mapping[str, object]]] = {"automobile": {"kind": "garage_door"}, "pedestrian.principal": {"main_entrance": True}}
"""What IMDF's categories of openings say in our words; the others are doors."""
NO_DOOR: Final = ("no", "")
FRONT_DOORS: Final = ("main", "home")
"""What OpenStreetMap calls an `entrance` that is the main one."""


def levels_of(features: Sequence[object]) -> dict[str, object]:
    """Returns the numbers of IMDF's levels by their ids."""
    levels = [one for one in features if isinstance(one, Mapping) and one.get("feature_type") == "level"]
    said = ((one.get("id"), one.get("properties")) for one in levels)
    return {key: told.get("ordinal") for key, told in said if isinstance(key, str) and isinstance(told, Mapping)}


def in_our_words(said: Mapping[str, Any], levels: Mapping[str, object]) -> dict[str, Any]:
    """Returns what a feature says of itself: maps number their features and storeys, and name rooms by language."""
    made = {key.lower() if key.isupper() else key: value for key, value in said.items()}
    if isinstance(made["id"], int | float) and not isinstance(made["id"], bool):
        made["id"] = str(made["id"])
    if isinstance(made.get("name"), Mapping):
        made["name"] = next((word for word in made["name"].values() if word), None)
    made["name"] = next((said for said in [made.pop(key, None) for key in NAMES] if said), None)
    storey = made.pop("level_id", None)
    if isinstance(storey, str) and storey in levels:
        made["level"] = levels[storey]
    number = next((found[1] for key in STOREYS if (found := LEVELS.fullmatch(str(made.get(key))))), None)
    if number is not None:
        made["level"] = int(number)
    for key in SIZES:
        if isinstance(made.get(key), str) and (size := NUMBER.fullmatch(made[key])):
            made[key] = float(size[1])
    if isinstance(made.get("entrance"), str) and made["entrance"] not in NO_DOOR and "kind" not in made:
        made = {"door": "yes", **made, **({"main_entrance": True} if made["entrance"] in FRONT_DOORS else {})}
    if "kind" not in made and made.get("type") in ("room", "wall", *get_args(OpeningKind)):
        made["kind"] = made.pop("type")
    outline = "building" if made.get("building") and not (made["name"] or made.get("indoor")) else None
    kinds = (*(made.get(key) for key in ("room", "category", "indoor")), outline)
    told = next((kind for kind in kinds if isinstance(kind, str) and kind and kind not in ANY_ROOM), None)
    made.pop("indoor", None)
    if made.get("feature_type") == "opening":
        return {**made, **IMDF.get(str(told), {})}
    return {"type": told, **made} if told else made


def why_left_out(said: Mapping[str, Any], form: str) -> str | None:
    """Returns why a feature of a map is neither a room nor an opening nor a piece; None where it is one."""
    called = said.get("feature_type")
    if called is not None and PARTS.get(called if isinstance(called, str) else "") != form:
        return f"a map's {called!r:.40}: of maps units and openings are read"
    if form in PARTS.values() and "kind" not in said and called is None and said.get("type") in NO_ROOM:
        return f"a map's {said['type']!r:.40}: of maps rooms, areas, corridors and doors are read"
    if form == "LineString" and "kind" not in said and "highway" in said:
        return f"a map's {said['highway']!r:.40}: of maps rooms, areas, corridors and doors are read"
    return None


def opening_at(said: Mapping[str, Any]) -> OpeningKind | None:
    """Returns which opening a point is, as OpenStreetMap draws them; None where it is none."""
    kinds: tuple[OpeningKind, ...] = () if "kind" in said else ("door", "window")
    return next((kind for kind in kinds if isinstance(said.get(kind), str) and said[kind] not in NO_DOOR), None)


def along_walls(one: DrawnOpening, width: float, rooms: Sequence[DrawnRoom]) -> DrawnOpening | None:
    """Returns an opening that is drawn as a point so wide along the nearest side of a room; None where there is none."""
    sides = [side for room in rooms if room.level == one.level for side in pairwise((*room.points, room.points[0])) if side[0] != side[1]]
    if not sides:
        return None
    _, (x, z), (along, across) = min(_foot(one.start, a, b) for a, b in sides)
    by = width / 2
    return replace(one, start=(x - along * by, z - across * by), end=(x + along * by, z + across * by))


def _foot(spot: Spot, a: Spot, b: Spot) -> tuple[float, Spot, Spot]:
    """Returns how far a line is from a point, where it is nearest, and which way it goes."""
    length = math.dist(a, b)
    way = (b[0] - a[0]) / length, (b[1] - a[1]) / length
    share = min(max((spot[0] - a[0]) * way[0] + (spot[1] - a[1]) * way[1], 0.0), length)
    foot = a[0] + way[0] * share, a[1] + way[1] * share
    return math.dist(spot, foot), foot, way
