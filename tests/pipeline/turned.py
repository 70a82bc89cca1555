"""Requests for /place turned, mirrored and told otherwise: each is the same room, so the answer must be the same.

In: documents. Out: documents. Shares no code with the solver.
"""

from __future__ import annotations

from copy import deepcopy
from typing import Any, Final

Request = dict[str, Any]
NEXT: Final = {"north": "east", "east": "south", "south": "west", "west": "north"}
ACROSS: Final = {"north": "north", "south": "south", "east": "west", "west": "east"}


def turned(request: Request) -> Request:
    """Returns the room turned by a quarter, clockwise seen from above: what was in the north is in the east."""
    other = deepcopy(request)
    room = other["room"]
    depth = room["depth"]
    for opening in room["openings"]:
        if opening["wall"] in ("east", "west"):
            opening["position"] = round(depth - opening["position"], 6)
        opening["wall"] = NEXT[opening["wall"]]
    for piece in room.get("furniture", ()):
        piece["x"], piece["z"] = round(depth - piece["z"], 6), piece["x"]
        piece["rotation"] = (piece.get("rotation", 0) - 90) % 360
        piece["wall"] = NEXT.get(piece.get("wall") or "")
    room["width"], room["depth"] = depth, room["width"]
    return other


def mirrored(request: Request) -> Request:
    """Returns the room with west and east exchanged."""
    other = deepcopy(request)
    room = other["room"]
    for opening in room["openings"]:
        if opening["wall"] in ("north", "south"):
            opening["position"] = round(room["width"] - opening["position"], 6)
        opening["wall"] = ACROSS[opening["wall"]]
    for piece in room.get("furniture", ()):
        piece["x"] = round(room["width"] - piece["x"], 6)
        piece["rotation"] = -piece.get("rotation", 0) % 360
        piece["wall"] = ACROSS.get(piece.get("wall") or "")
    return other


def moved(request: Request) -> Request:
    """Returns the room somewhere else in the house."""
    return {**request, "room": {**request["room"], "x": 7.25, "z": -3.5}}


def renamed(request: Request) -> Request:
    """Returns the list with other ids, whose order is another one, too."""
    other = deepcopy(request)
    ids = {piece["id"]: f"{chr(ord('z') - k)}{k}" for k, piece in enumerate(other["pieces"])}
    for piece in other["pieces"]:
        piece["name"], piece["id"] = piece.get("name", piece["id"]), ids[piece["id"]]
        for relation in piece["relations"]:
            if "of" in relation:
                relation["of"] = ids.get(relation["of"], relation["of"])
    return other


def permuted(request: Request) -> Request:
    """Returns the list the other way round."""
    return {**request, "pieces": request["pieces"][::-1]}
