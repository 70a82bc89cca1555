"""Whether people still get everywhere when one more body stands in a room.

Comes in: what has to stay within reach. Goes out: yes or no. May import: the ground floor.
"""

from __future__ import annotations

from solver.geometry import Rect
from solver.ways import Ways


class Walking:
    """A room's walk while things are put into it: `passes` tells whether all doors and use sides are still within reach."""

    def __init__(self, ways: Ways) -> None:
        self.ways, self.added = ways, list[Rect]()
        self.sound = bool(ways.space.doorways) and ways.open()

    def passes(self, rect: Rect) -> bool:
        """Tells whether one more body may stand there; where nobody could come in before, none may."""
        return self.sound and (self.ways.harmless(rect, self.added) or self.ways.open([*self.added, rect]))

    def add(self, rect: Rect) -> None:
        """Puts one more body into the room."""
        self.added.append(rect)
