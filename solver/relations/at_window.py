"""`at_window`: at a window, its middle on the window's middle."""

from catalogs.schema import RelationSpec
from solver.geometry import ALONG_X, Rect, strip
from solver.relations.centred import about
from solver.relations.relation import SOUGHT, Relation, Tolerance
from solver.relations.subject import Footing, Scope


class AtWindow(Relation):
    """Stands at a window, centred on it; falls away in a room without one."""

    def regions(self, scope: Scope, spec: RelationSpec, footing: Footing, tolerance: Tolerance = SOUGHT) -> list[Rect]:
        """At the wall of each window, about its middle."""
        found = []
        for window in scope.opened("window"):
            along = 0 if window.wall in ALONG_X else 1
            interval = about(window.centre[along], footing.extent[along] / 2 + tolerance.nearly_mm)
            found.append(strip(scope.clear, window.wall, interval, footing.extent[1 - along] + 2 * tolerance.nearly_mm))
        return found
