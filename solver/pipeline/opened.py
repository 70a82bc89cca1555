"""A scene whose certificate says how far each front opens."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

from solver.records import changed
from solver.scene import Scene
from solver.validator import Checked
from solver.validator.opening import certified_fronts, travels_in


def with_fronts(scene: Scene, checked: Checked, rooms: Collection[str] | None = None) -> Scene:
    """Returns a scene whose certificate says of some rooms, or of all, how far their fronts open, and what they meet.

    The scene is as it was checked; no rule reads what is added.
    """
    document: dict[str, Any] = dict(scene.certificate or {})
    entries: dict[str, Any] = dict(document.get("rooms") or {})
    for case in checked.cases:
        name = case.room.room.id
        if name in entries and (rooms is None or name in rooms) and (travels := travels_in(case)):
            entries[name] = {**entries[name], "fronts": certified_fronts(travels)}
    return changed(scene, certificate={**document, "rooms": entries})
