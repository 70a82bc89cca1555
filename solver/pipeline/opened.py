"""A scene whose certificate says how far each front opens.

Comes in: a finished scene, catalogs. Goes out: the scene. May import: validator.
"""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import Any

from catalogs import Catalogs
from solver.scene import Scene
from solver.validator.opening import certified_fronts, front_travels


def with_fronts(scene: Scene, catalogs: Catalogs, rooms: Collection[str] | None = None) -> Scene:
    """Returns a scene whose certificate says of some rooms, or of all, how far their fronts open, and what they meet."""
    document: dict[str, Any] = dict(scene.certificate or {})
    entries: dict[str, Any] = dict(document.get("rooms") or {})
    for name, travels in front_travels(scene, catalogs).items():
        if travels and name in entries and (rooms is None or name in rooms):
            entries[name] = {**entries[name], "fronts": certified_fronts(travels)}
    return replace(scene, certificate={**document, "rooms": entries})
