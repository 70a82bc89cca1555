"""One house -> the figures that statistics are made of."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from hashlib import blake2b
from typing import Any, Final

from solver.answers import Issue
from solver.scene import EXTERIOR, Furniture, Room, Scene

HALLWAY: Final = "hallway"
PERSON: Final = "person"
"""The kind of people; everybody else is a pet."""
MISSING: Final = "missing_required"


@dataclass(frozen=True)
class RoomFigures:
    """What one room shows.

    Args:
        type: the room's type.
        spread: figures that are told as a spread: `area` between wall lines, m2; `cover`, the share of that under furniture that
            stands on the floor; `walkable`, the share of the clear floor that the centre of who walks can come to; how many `pieces`
            of furniture, `decorations`, and both `together`.
        people: people and pets.
        missing: required pieces that are not there.
        left_out: why each optional piece that was thought of is not there, in the certificate's words up to the first semicolon.
        signature: pieces and their walls; equal where two rooms are furnished alike.
    """

    type: str
    spread: Mapping[str, float]
    people: int
    missing: int
    left_out: tuple[str, ...]
    signature: str


@dataclass(frozen=True)
class House:
    """What one house shows.

    Args:
        seed: of the house.
        style: of the house.
        rooms: its rooms.
        spread: figures that are told as a spread: `floor` of the indoor rooms between wall lines, m2; `hallway`, the share of that
            which is hallway; `cover` and `walkable` as of rooms; how many `rooms`, `doors` (openings that one can walk through),
            `windows`, `pieces`, `decorations`, `people`, `pets`.
        seated: how many of the people sit.
        proven: rooms whose placement is proven to be the best for the ways taken.
        use_sides: pieces that are used from a side, and those of them that can be.
        adjacency: signature of the graph of rooms that share a wall; equal where two homes have the same rooms beside each other.
        ways: signature of the graph of rooms joined by doors and passages, the front door included.
        notes: what the floor plan fell short of.
        issues: everything that the validator says.
    """

    seed: int
    style: str | None
    rooms: tuple[RoomFigures, ...]
    spread: Mapping[str, float]
    seated: int
    proven: int
    use_sides: tuple[int, int]
    adjacency: str
    ways: str
    notes: tuple[str, ...]
    issues: tuple[Issue, ...]


def house_of(scene: Scene, issues: Sequence[Issue], measures: Mapping[str, Any]) -> House:
    """Returns what a generated house shows; `measures` are those of the scene with the catalogs (`validate.metrics`)."""
    certificate: Mapping[str, Any] = scene.certificate or {}
    rooms = tuple(_room(room, scene, issues, measures["rooms"][room.id], certificate["rooms"][room.id]) for room in scene.rooms)
    style = (scene.request or {}).get("style")
    types = {str(room.index): room.type for room in scene.rooms}
    return House(
        seed=scene.seed or 0,
        style=style if isinstance(style, str) else None,
        rooms=rooms,
        spread=_spread(scene, measures),
        seated=sum(one.on is not None for one in scene.dynamic if one.kind == PERSON),
        proven=sum(bool(entry["proven"]) for entry in certificate["rooms"].values()),
        use_sides=(measures["use_sides"]["wanted"], measures["use_sides"]["reached"]),
        adjacency=graph_signature(types, [(str(a), str(b)) for a, b in scene.adjacency]),
        ways=graph_signature(*_ways(scene)),
        notes=tuple(certificate.get("notes", ())),
        issues=tuple(issues),
    )


def _spread(scene: Scene, measures: Mapping[str, Any]) -> dict[str, float]:
    counts, areas = measures["counts"], {room.id: measures["rooms"][room.id]["area"] for room in scene.rooms if not room.outdoor}
    floor, people = sum(areas.values()), sum(one.kind == PERSON for one in scene.dynamic)
    hallway = sum(areas[room.id] for room in scene.rooms if room.type == HALLWAY and room.id in areas)
    of_home = {"floor": round(floor, 4), "hallway": round(hallway / floor, 4) if floor else 0.0}
    of_rooms = {"cover": measures["furnished"], "walkable": measures["walkable"], "rooms": len(scene.rooms)}
    counted = {"doors": "doors", "windows": "windows", "pieces": "furniture", "decorations": "decorations"}
    alive = {"people": people, "pets": len(scene.dynamic) - people}
    return {**of_home, **of_rooms, **{name: counts[key] for name, key in counted.items()}, **alive}


def _ways(scene: Scene) -> tuple[dict[str, str], list[tuple[str, str]]]:
    """Returns the types of the rooms and of outside, by id, and the pairs that a door or passage joins, each once."""
    types = {room.id: room.type for room in scene.rooms} | {EXTERIOR: EXTERIOR}
    ends: dict[str, tuple[str, str]] = {}
    for room in scene.rooms:
        for opening in room.openings:
            if opening.kind != "window" and opening.connects_to in types:
                ends.setdefault(opening.id, (room.id, opening.connects_to))
    return types, list(ends.values())


def _room(room: Room, scene: Scene, issues: Sequence[Issue], measured: Mapping[str, Any], certified: Mapping[str, Any]) -> RoomFigures:
    pieces, decorations = len(room.furniture), len(room.decorations)
    measures = {"area": measured["area"], "cover": measured["furnished"], "walkable": measured["walkable"]}
    return RoomFigures(
        type=room.type,
        spread={**measures, "pieces": pieces, "decorations": decorations, "together": pieces + decorations},
        people=sum(one.room == room.id for one in scene.dynamic),
        missing=sum(issue.rule == MISSING and issue.room == room.id for issue in issues),
        left_out=tuple(entry["reason"].split(";")[0] for entry in certified["left_out"]),
        signature=room_signature(room.furniture),
    )


def room_signature(furniture: Iterable[Furniture]) -> str:
    """Returns a room's pieces and the walls they stand at, whatever their order and exact places."""
    return _digest(sorted(f"{piece.name} {piece.wall or 'free'}" for piece in furniture))


def graph_signature(labels: Mapping[str, str], edges: Sequence[tuple[str, str]]) -> str:
    """Returns a word that is the same for graphs that differ in the names and order of their nodes only.

    By colour refinement (Weisfeiler and Lehman 1968): a node's colour is its label, then again and again its own colour with those of its
    neighbours. Few graphs that differ get one word; so it never counts too many.
    """
    beside: dict[str, list[str]] = {name: [] for name in labels}
    for one, other in edges:
        beside[one].append(other)
        beside[other].append(one)
    colours = dict(labels)
    for _ in labels:
        colours = {name: _digest([colours[name], *sorted(colours[other] for other in beside[name])]) for name in labels}
    return _digest(sorted(colours.values()))


def _digest(words: Iterable[str]) -> str:
    return blake2b("\n".join(words).encode(), digest_size=8).hexdigest()
