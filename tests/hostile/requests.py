"""Hostile requests, by seed: small bodies that ask for much.

Comes in: a seed. Goes out: a call and its body. Each family has a size that grows from almost nothing to what a body of a megabyte holds.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from random import Random
from typing import Any, Final, NamedTuple, TypeAlias, get_args

from catalogs.schema import RelationWord

Document: TypeAlias = dict[str, Any]
MOST_BYTES: Final = 1_000_000
KINDS: Final = ("chair", "sofa", "bed", "dining_table", "desk", "wardrobe", "armchair", "nightstand", "bookshelf", "rug", "x")
TYPES: Final = ("living_room", "bedroom", "kitchen", "bathroom", "office", "hallway", "dining_room", "x")
WALLS: Final = ("north", "south", "east", "west")
RELATED: Final = get_args(RelationWord)


class Hostile(NamedTuple):
    """A request: what it is, the call, the body."""

    family: str
    call: str
    body: bytes


def many(random: Random, most: int) -> int:
    """Draws how many, small numbers as often as great ones."""
    return round(math.exp(random.uniform(0, math.log(most))))


def pieces(random: Random, number: int, width: float, depth: float) -> list[Document]:
    """Returns bodies in a room: spread, in one heap, in rows that just overlap, locked or not."""
    size = random.choice([0.05, 0.3, 0.5, 1.0, 2.0, width])
    way, kind, locked = random.choice(["spread", "heap", "row", "one place"]), random.choice(KINDS), random.choice([0.0, 0.0, 0.3, 1.0])
    found = []
    for k in range(number):
        if way == "spread":
            x, z = random.uniform(0, width), random.uniform(0, depth)
        elif way == "heap":
            x, z = random.gauss(width / 2, width / 9), random.gauss(depth / 2, depth / 9)
        else:
            x, z = (k * size * 0.9 % width, k * size * 0.9 // width * size) if way == "row" else (width / 2, depth / 2)
        one = {"name": kind, "x": round(x, 3), "z": round(z, 3), "width": size, "depth": size, "height": 0.9}
        if random.random() < locked:
            one["locked"] = True
        if random.random() < 0.2:
            one["rotation"] = random.choice([90, 180, 45, 33.3])
        found.append(one)
    return found


def outline(random: Random, number: int, width: float, depth: float) -> list[list[float]]:
    """Returns an outline of so many corners: a comb, a staircase, or round."""
    if random.random() < 0.3:
        turns = [2 * math.pi * k / max(number, 3) for k in range(max(number, 3))]
        return [[width / 2 * (1 + math.cos(turn)), depth / 2 * (1 + math.sin(turn))] for turn in turns]
    teeth, comb = max(number // 4, 1), random.random() < 0.5
    step = width / (2 * teeth)
    points: list[list[float]] = []
    for k in range(teeth):
        low = depth / 2 if comb else depth * (k + 1) / (2 * teeth)
        points += [[2 * k * step, depth], [2 * k * step, low], [(2 * k + 1) * step, low], [(2 * k + 1) * step, depth]]
    return [[0.0, 0.0], *points, [width, depth], [width, 0.0]] if comb else points


def openings(random: Random, number: int, length: float) -> list[Document]:
    """Returns doors, windows and passages, upon one another as it comes."""
    return [
        {
            "kind": random.choice(["door", "window", "passage"]),
            "wall": random.choice(WALLS),
            "position": round(random.uniform(0, length), 3),
        }
        for _ in range(number)
    ]


def room(random: Random, number: int) -> Document:
    """Returns a room with so many things in it, of one sort."""
    width, depth = random.choice([1.0, 3.0, 6.0, 12.0, 100.0, 1000.0]), random.choice([1.0, 3.0, 6.0, 30.0, 1000.0])
    found: Document = {"id": f"r{random.randrange(10**6)}", "type": random.choice(TYPES), "width": width, "depth": depth}
    what = random.choice(["furniture", "furniture", "furniture", "openings", "outline", "people", "decorations"])
    if what == "furniture":
        found["furniture"] = pieces(random, number, width, depth)
    elif what == "outline":
        found["outline"] = outline(random, number, width, depth)
        found["furniture"] = pieces(random, 5, width, depth)
    elif what == "openings":
        found["openings"] = openings(random, number, min(width, depth))
        found["furniture"] = pieces(random, 5, width, depth)
    elif what == "decorations":
        found["decorations"] = pieces(random, number, width, depth)
    else:
        found["furniture"] = pieces(random, min(number, 40), width, depth)
        found["openings"] = openings(random, 3, min(width, depth))
    return found


def scene(random: Random) -> Document:
    """Returns a scene of one full room, or of many."""
    if random.random() < 0.6:
        return {"rooms": [room(random, many(random, 12_000))]}
    count = many(random, 9000)
    one = room(random, many(random, max(12_000 // count, 1)))
    across = max(round(math.sqrt(count)), 1)
    places = ((k % across * one["width"], k // across * one["depth"]) for k in range(count))
    return {"rooms": [{**one, "id": f"r{k}", "x": x % 9000, "z": z % 9000} for k, (x, z) in enumerate(places)]}


def fix(random: Random) -> Document:
    """Returns a body of /fix."""
    return {"scene": scene(random), "on_conflict": random.choice(["report", "remove"])}


def place(random: Random) -> Document:
    """Returns a body of /place: up to 64 copies that all refer to one another."""
    left, wishes = 64, []
    names = random.sample([*KINDS], k=random.randint(1, 5))
    for name in names:
        count = random.randint(1, max(left - len(names), 1))
        left -= count
        rules = [{"type": random.choice(RELATED), "of": random.choice(names)} for _ in range(random.choice([0, 1, 2, 4, 16]))]
        wish: Document = {"id": name, "name": name, "count": count, "relations": rules, "required": random.random() < 0.8}
        if name == "x" or random.random() < 0.3:
            size = random.choice([0.05, 0.5, 1.0, 3.0])
            wish |= {"width": size, "depth": size, "height": 1.0}
        wishes.append(wish)
    body: Document = {"room": room(random, many(random, 3000)), "pieces": wishes, "alternatives": random.choice([1, 2, 16])}
    if random.random() < 0.5:
        body["room"] = {"id": "a", "width": random.choice([3, 6, 10, 30]), "depth": random.choice([3, 6, 10, 30])}
    return body


def furnish(random: Random) -> Document:
    """Returns a body of /furnish."""
    body: Document = {"scene": scene(random), "seed": random.randrange(99), "keep": random.choice(["all", "locked", "none"])}
    if random.random() < 0.3:
        body["decorate"] = True
    return body


def reroll(random: Random) -> Document:
    """Returns a body of /generate that furnishes all rooms anew."""
    wanted = scene(random)
    return {"scene": wanted, "reroll": [one["id"] for one in wanted["rooms"]], "seed": 1}


def request(random: Random) -> Document:
    """Returns a request for a home."""
    body: Document = {"seed": random.randrange(999), "decorate": random.random() < 0.5, "outdoor": random.random() < 0.2}
    if random.random() < 0.5:
        body["program"] = random.choice(["family", "large", {"bedrooms": random.randint(1, 12), "bathrooms": random.randint(0, 12)}])
        body["area"] = random.choice([15, 100, 1000])
        body["outline"] = random.choice(["any", "L", "U", "T"])
    else:
        body |= {"width": random.choice([2, 20, 200, 1000]), "depth": random.choice([2, 20, 1000]), "max_depth": random.choice([0, 5, 16])}
        body["min_room_size"] = random.choice([1.5, 3, 50])
    if random.random() < 0.3:
        body["robot_width"] = random.choice([0.1, 2.0])
    return body


def only_scene(random: Random) -> Document:
    """Returns a body that is a scene."""
    return {"scene": scene(random)}


def judged(random: Random) -> Document:
    """Returns a body of /validate."""
    return {"scene": scene(random), "report": random.random() < 0.3, "access": random.choice([None, "din_18040_2", "ada"])}


def geojson(random: Random) -> Document:
    """Returns a body of /import: many rooms, or rooms of many corners."""
    count, corners = many(random, 2000), many(random, 3000)
    corners = max(min(corners, 30_000 // count), 4)
    across = max(round(math.sqrt(count)), 1)
    features = []
    for k in range(count):
        x, z = 5.0 * (k % across), 5.0 * (k // across)
        ring = [[round(x + px, 3), round(z + pz, 3)] for px, pz in outline(random, corners, 4.9, 4.9)]
        geometry = {"type": "Polygon", "coordinates": [[*ring, ring[0]]]}
        features.append({"type": "Feature", "properties": {"name": random.choice(TYPES)}, "geometry": geometry})
    return {"document": {"type": "FeatureCollection", "features": features}}


def named_piece(random: Random) -> Document:
    """Returns a body of /explain or /drag."""
    wanted = {"rooms": [room(random, many(random, 3000))]}
    wanted["rooms"][0]["furniture"] = [{**one, "id": f"p{k}"} for k, one in enumerate(pieces(random, many(random, 3000), 6.0, 6.0))]
    return {"scene": wanted, "id": "p0"}


FAMILIES: Final[Mapping[str, tuple[str, Callable[[Random], Document]]]] = {
    "fix": ("fix", fix), "place": ("place", place), "furnish": ("furnish", furnish), "reroll": ("generate", reroll),
    "generate": ("generate", request), "validate": ("validate", judged), "view": ("view", only_scene), "floor": ("floor", only_scene),
    "import": ("import", geojson), "drag": ("drag", named_piece), "explain": ("explain", named_piece), "glb": ("export", only_scene),
    "restyle": ("generate", lambda random: {"scene": scene(random), "style": "rustic", "decorate": True}),
}  # fmt: skip


def hostile(seed: int) -> Hostile:
    """Returns the request of a seed; at most MOST_BYTES long."""
    random = Random(seed)
    family = list(FAMILIES)[seed % len(FAMILIES)]
    call, make = FAMILIES[family]
    while True:
        body = json.dumps(make(random), separators=(",", ":")).encode()
        if len(body) <= MOST_BYTES:
            return Hostile(family, call, body)
