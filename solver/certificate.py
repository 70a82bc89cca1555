"""What a generated scene says about itself: rules checked, counts, and per room cost, proof and what was left out.

May import: the ground floor. Holds no times, so that equal requests give equal bytes.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from solver.scene import Dynamic, Room
from solver.wanted import Arrangement


def certificate(
    rooms: Sequence[Room],
    arrangements: Mapping[str, Arrangement],
    rules: Iterable[str],
    plan: Mapping[str, Any],
) -> dict[str, Any]:
    """Returns the certificate document.

    Args:
        rooms: the finished rooms.
        arrangements: by room id.
        rules: the rules that were checked.
        plan: what the floor plan has to say (spine, unjoined, notes).
    """
    return {
        "rules": list(rules),
        "counts": counts(rooms, ()),
        **plan,
        "rooms": {room.id: room_certificate(arrangements[room.id]) for room in rooms},
    }


def counts(rooms: Sequence[Room], people: Sequence[Dynamic]) -> dict[str, int]:
    """Returns how many there are in a house of everything that is counted."""
    openings = [opening for room in rooms for opening in room.openings]
    return {
        "rooms": len(rooms),
        "doors": len({opening.id for opening in openings if opening.kind != "window"}),
        "windows": sum(opening.kind == "window" for opening in openings),
        "furniture": sum(len(room.furniture) for room in rooms),
        "decorations": sum(len(room.decorations) for room in rooms),
        "dynamic": len(people),
    }


def room_certificate(arrangement: Arrangement) -> dict[str, Any]:
    """Returns one room's part of the certificate."""
    return {
        "cost": arrangement.cost,
        "proven": arrangement.proven,
        "best": arrangement.best,
        "left_out": [{"piece": label, "reason": reason} for label, reason in arrangement.left_out],
        "notes": list(arrangement.notes),
    }
