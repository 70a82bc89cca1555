"""How far fronts open, as the rule finds it."""

from __future__ import annotations

from catalogs import Catalogs
from solver.scene import Scene
from solver.validator import check
from solver.validator.opening import FrontTravel, travels_in


def front_travels(scene: Scene, catalogs: Catalogs) -> dict[str, list[FrontTravel]]:
    """The fronts of a scene, by room."""
    return {case.room.room.id: travels_in(case) for case in check(scene, catalogs).cases}
