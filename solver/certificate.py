"""What a generated scene says about itself: rules checked, counts, and per room cost, proof and what was left out.

A proof speaks of one placement: each room's part holds a mark of it (`of`), and is worth nothing for another one. Holds no times, so that
equal requests give equal bytes.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from typing import Any, Final

from solver.body_rows import FurnitureRows, rows_in
from solver.pieces import Arrangement
from solver.records import MadeOnce
from solver.scene import Room, Scene
from solver.scene_bodies import counted

OF_ONE_PLACEMENT: Final = frozenset({"cost", "proven", "best", "residuals", "fronts"})
"""What is true of the placement that was made, and of no other."""
MARK_LENGTH: Final = 12
ACCESS: Final = "access"
"""What a profile of access makes of the whole home."""
_POSE: Final = "%s" + 6 * " %.4f"
_WRITTEN: Final = MadeOnce[int, str](lambda halves: f"{halves / 2000:.4f}", 20_000)
"""Half millimetres as they are written into a mark, m; degrees are 2000 of them."""


def certificate(
    rooms: Sequence[Room],
    arrangements: Mapping[str, Arrangement],
    rules: Iterable[str],
    plan: Mapping[str, Any],
) -> dict[str, Any]:
    """Returns the certificate document; `plan` is what the floor plan has to say (spine, unjoined, notes). Nothing is counted yet."""
    return {
        "rules": list(rules),
        "counts": {},
        **plan,
        "rooms": {room.id: room_certificate(arrangements[room.id], room) for room in rooms},
    }


def room_certificate(arrangement: Arrangement, room: Room) -> dict[str, Any]:
    """Returns the certificate's part about a finished room."""
    return {
        "of": mark_of(room),
        "cost": arrangement.cost,
        "proven": arrangement.proven,
        "best": arrangement.best,
        **({"residuals": arrangement.residuals._asdict()} if arrangement.residuals else {}),
        "left_out": [{"piece": label, "reason": reason} for label, reason in arrangement.left_out],
        "notes": list(arrangement.notes),
        **({"insisted": arrangement.insisted} if arrangement.insisted else {}),
    }


def mark_of(room: Room) -> str:
    """Returns a mark that a room has in common with no other placement of furniture in it."""
    rows = rows_in(room, FurnitureRows)
    poses = map(_POSE.__mod__, sorted(_poses(room))) if rows is None else _poses_told(rows)
    said = [f"{room.width:.4f} {room.depth:.4f}", *poses]
    return sha256("\n".join(said).encode(errors="surrogatepass")).hexdigest()[:MARK_LENGTH]


def _poses(room: Room) -> Iterator[tuple[str, float, float, float, float, float, float]]:
    """Yields the id, place, rotation, width and depth of each piece of furniture."""
    for one in room.furniture:
        yield one.id, one.x + 0.0, one.y + 0.0, one.z + 0.0, one.rotation + 0.0, one.width, one.depth


def _poses_told(rows: FurnitureRows) -> Iterator[str]:
    """Yields the same of pieces that are told as rows, written, in the same order."""
    said = _WRITTEN
    for name, (turn, x0, z0, x1, z1, low), look in sorted(zip(rows.ids, rows.poses, rows.looks, strict=True)):
        yield f"{name} {said[x0 + x1]} {said[2 * low]} {said[z0 + z1]} {said[2000 * turn]} {look.extents}"


def true_of(room: Room, entry: Mapping[str, Any]) -> Mapping[str, Any]:
    """Returns what still is true of a room's part of the certificate: of changed furniture nothing is proven."""
    if "of" not in entry or entry["of"] == mark_of(room):
        return entry
    return {key: value for key, value in entry.items() if key not in OF_ONE_PLACEMENT}


def certified(scene: Scene) -> Scene:
    """Returns a scene whose certificate says of its rooms, of access and of all that is counted only what is true now."""
    said = scene.certificate or {}
    now = {**said, **({"counts": counted(scene.rooms, scene.dynamic)} if "counts" in said else {})}
    entries = said.get("rooms")
    if isinstance(entries, Mapping):
        rooms = {room.id: room for room in scene.rooms}
        known = {name: entry for name, entry in entries.items() if name in rooms and isinstance(entry, Mapping)}
        now["rooms"] = {**entries, **{name: true_of(rooms[name], entry) for name, entry in known.items()}}
        if now["rooms"] != entries:
            now.pop(ACCESS, None)
    return scene if now == said else replace(scene, certificate=now)
