"""Who is wished what, and what is known of kinds. May import: scene."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from solver.scene import Decoration, Furniture

Sides = tuple[tuple[str, ...], bool]
"""Use sides of a kind (front, back, left, right of the unrotated body), and whether all of them must be reached."""


@dataclass(frozen=True)
class Wishes:
    """Who is wished what: locked ids stay to the millimetre, moved ids are held most strongly.

    Args:
        locked: ids, besides the pieces that say so themselves.
        moved: ids.
        required_kinds: names that some room type requires; they are more important than others.
        uses: use sides by name of piece. With them pieces ask for a free place to stand at their use sides.
    """

    locked: frozenset[str] = frozenset()
    moved: frozenset[str] = frozenset()
    required_kinds: frozenset[str] = frozenset()
    uses: Mapping[str, Sides] = field(default_factory=dict)

    def is_locked(self, body: Furniture | Decoration) -> bool:
        """Tells whether the body must stay exactly as sent."""
        return body.id in self.locked or (isinstance(body, Furniture) and body.locked)
