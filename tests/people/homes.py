"""Houses to people, made once; who is in them for any seed; and what is wrong with where they are, from the scene alone.

The oracle shares nothing with the stage but the types of the scene and `space_of`; walking is tests/oracles/walk's.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import lru_cache

from catalogs import load_catalogs
from solver import Request, Scene, generate
from solver.furnish import space_of
from solver.geometry import Rect
from solver.people import Household, peopled
from solver.scene import Decoration, Dynamic, Furniture, Room, robot_width_of
from tests.oracles.walk import missed

REQUESTS = (
    Request(seed=501),
    Request(seed=502, outdoor=True),
    Request(seed=503, width=12, depth=9, decorate=True),
    Request(seed=504, width=9, depth=8, outdoor=True),
    Request(seed=505, width=34, depth=24, decorate=True, outdoor=True),
)
MAJOR = {"living_room", "kitchen", "dining_room", "bedroom_master", "backyard", "patio", "outdoor_deck"}
WORKTOPS = {"counter", "kitchen_island", "workbench"}
TURNED = ("south", "east", "north", "west")
ALL_WALLS = ("north", "south", "west", "east")


@lru_cache(maxsize=8)
def house(number: int) -> Scene:
    """A furnished house with nobody in it."""
    return replace(generate(REQUESTS[number]).scene, dynamic=())


def household(number: int, seed: int) -> Scene:
    """The same house with who is there for a seed."""
    scene = house(number)
    known = Household(seed, load_catalogs(), lambda room: space_of(room, scene.wall_thickness, robot_width_of(scene), scene.rooms))
    return replace(scene, dynamic=peopled(scene.rooms, known))


def bounds(body: Furniture | Decoration | Dynamic) -> tuple[float, float, float, float]:
    """The bounding rectangle of a body, m."""
    angle = math.radians(body.rotation)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    half = ((body.width * c + body.depth * s) / 2, (body.width * s + body.depth * c) / 2)
    return body.x - half[0], body.z - half[1], body.x + half[0], body.z + half[1]


def share(a: Furniture | Decoration | Dynamic, b: Furniture | Decoration | Dynamic) -> bool:
    """Whether two bodies share more than a tenth of a millimetre of space."""
    p, q = bounds(a), bounds(b)
    wide, deep = min(p[2], q[2]) - max(p[0], q[0]), min(p[3], q[3]) - max(p[1], q[1])
    tall = min(a.y + a.height, b.y + b.height) - max(a.y, b.y)
    return min(wide, deep, tall) > 1e-4


def meets(person: Dynamic, thing: Decoration) -> bool:
    """Whether a thing lies right below somebody who sits, in part or whole."""
    p, q = bounds(person), bounds(thing)
    above = min(p[2], q[2]) - max(p[0], q[0]), min(p[3], q[3]) - max(p[1], q[1])
    return min(above) > 1e-4 and abs(thing.y + thing.height - person.y) < 1e-3


def crossed(person: Dynamic, scene: Scene) -> Iterator[str]:
    """What a person or pet shares space with, or leaves."""
    room = next(room for room in scene.rooms if room.id == person.room)
    half = scene.wall_thickness / 2
    x0, z0, x1, z1 = bounds(person)
    if min(x0, z0) < half - 1e-9 or x1 > room.width - half + 1e-9 or z1 > room.depth - half + 1e-9:
        yield "leaves the room"
    others = [one for one in scene.dynamic if one.room == room.id]
    things: list[Furniture | Decoration | Dynamic] = [*room.furniture, *room.decorations, *others]
    for thing in things:
        lies_on_seat = isinstance(thing, Decoration) and thing.parent == person.on and thing.height <= 0.06
        if thing.id not in (person.id, person.on) and thing.height > 0.02 and not lies_on_seat and share(person, thing):
            yield f"shares space with {thing.id}"
    for opening in room.openings:
        deep = min(opening.width, 0.9)
        a, b = opening.position - opening.width / 2, opening.position + opening.width / 2
        square = {
            "north": (a, 0, b, deep), "south": (a, room.depth - deep, b, room.depth),
            "west": (0, a, deep, b), "east": (room.width - deep, a, room.width, b),
        }[opening.wall or ""]  # fmt: skip
        inside = x0 < square[2] - 1e-9 and square[0] < x1 - 1e-9 and z0 < square[3] - 1e-9 and square[1] < z1 - 1e-9
        if opening.kind in ("door", "passage") and inside:
            yield f"stands in the square of {opening.id}"


def seen(person: Dynamic, room: Room) -> Iterator[str]:
    """What within 2 m lies within 45 degrees of a person's front: seats, screens, worktops, windows, doors."""
    front = (math.sin(math.radians(person.rotation)), math.cos(math.radians(person.rotation)))
    for name, (x0, z0, x1, z1) in _sights(room):
        near = (min(max(person.x, x0), x1) - person.x, min(max(person.z, z0), z1) - person.z)
        middle = ((x0 + x1) / 2 - person.x, (z0 + z1) / 2 - person.z)
        angles = [math.acos(max(-1, min(1, (front[0] * x + front[1] * z) / math.hypot(x, z)))) for x, z in (near, middle)]
        if math.hypot(*near) <= 2.01 and max(angles) <= math.radians(45):
            yield name


def _sights(room: Room) -> Iterator[tuple[str, tuple[float, float, float, float]]]:
    for piece in room.furniture:
        if piece.category == "seating" or piece.name == "tv" or piece.name in WORKTOPS:
            yield piece.id, bounds(piece)
    for opening in room.openings:
        if opening.kind in ("door", "window"):
            a, b = opening.position - opening.width / 2, opening.position + opening.width / 2
            across = {"north": 0.0, "west": 0.0, "south": room.depth, "east": room.width}[opening.wall or ""]
            yield opening.id, (a, across, b, across) if opening.wall in ("north", "south") else (across, a, across, b)


def out_of_reach(scene: Scene, room: Room) -> list[str]:
    """What cannot be come to in a room with its people: doors, use sides, the floor, who stands there, the fronts of seats sat on."""
    known = load_catalogs()
    space = space_of(room, scene.wall_thickness, robot_width_of(scene), scene.rooms)
    loose = [thing for thing in room.decorations if thing.parent is None and thing.mounted_on_wall is None and thing.y == 0]
    here = [person for person in scene.dynamic if person.room == room.id]
    standing = [person for person in here if person.on is None]
    bodies: list[Furniture | Decoration | Dynamic] = [*room.furniture, *loose, *standing]
    solids = [_rect(body) for body in bodies if body.height > 0.02 and body.y < 2]
    uses = []
    for piece in room.furniture:
        kinds = [entry for kind, entry in known.furniture.items() if known.name_of(kind) == piece.name and entry.use]
        if kinds and kinds[0].use:
            uses.append((piece.id, _rect(piece), [_looks(piece, side) for side in kinds[0].use.sides], kinds[0].use.need == "all"))
        if piece.id in {person.on for person in here}:
            uses.append((f"{piece.id}'s front", _rect(piece), [_looks(piece, "front")], False))
    uses += [(person.id, _rect(person), list(ALL_WALLS), False) for person in standing]
    return missed(space, solids, uses)


def _looks(piece: Furniture, side: str) -> str:
    return TURNED[(round(piece.rotation / 90) + {"front": 0, "right": 1, "back": 2, "left": 3}[side]) % 4]


def _rect(body: Furniture | Decoration | Dynamic) -> Rect:
    x0, z0, x1, z1 = bounds(body)
    return Rect(*(math.floor(v * 1000 + 1e-6) for v in (x0, z0)), *(math.ceil(v * 1000 - 1e-6) for v in (x1, z1)))
