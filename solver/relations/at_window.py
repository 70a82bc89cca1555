"""`at_window`: at a window, its middle on the window's middle."""

from __future__ import annotations

import math

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect, strip
from solver.pieces import Candidate
from solver.relations.centred import about, off_middle
from solver.relations.relation import NOTHING, SOUGHT, Effect, Relation, Tolerance
from solver.relations.subject import Footing, Scope, Subject


class AtWindow(Relation):
    """Stands at a window, centred on it; falls away in a room without one."""

    def effect(self, subject: Subject, spec: RelationSpec) -> Effect:
        """Tries the windows' middles, and costs by the distance from them."""
        windows = subject.scope.opened("window")
        if not windows:
            return NOTHING

        def cost_of(candidate: Candidate) -> float:
            here = [window for window in windows if window.wall == candidate.wall]
            axes = ((0 if window.wall in ALONG_X else 1, window) for window in here)
            return off_middle(spec, min((abs(candidate.anchor_mm[axis] - one.centre[axis]) for axis, one in axes), default=math.inf))

        positions = tuple((window.wall, kind.name, sum(window.interval) // 2) for window in windows for kind, _ in subject.variants)
        return Effect(cost_of=cost_of, positions=positions, weight=spec.weight)

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """At the wall of each window, about its middle."""
        found = []
        for window in scope.opened("window"):
            along = 0 if window.wall in ALONG_X else 1
            interval = about(window.centre[along], footing.extent[along] / 2 + tolerance.nearly_mm)
            found.append(strip(scope.clear, window.wall, interval, footing.extent[1 - along] + 2 * tolerance.nearly_mm))
        return found
