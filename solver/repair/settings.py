"""On what terms a scene is repaired, and what is known of its kinds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property

from catalogs import Catalogs
from solver.answers import Pose
from solver.scene import Decoration, Furniture


@dataclass(frozen=True)
class RepairSettings:
    """What holds for every room of a scene that is repaired.

    Args:
        catalogs: whose kinds and room types are known.
        locked: ids that stay to the millimetre, besides the pieces that say so themselves.
        moved: ids that are held most strongly.
        walk: whether the ways to use sides are kept free.
        remove: whether what cannot stand is taken out, and not only named.
        previous: poses of the last answer, by id.
        work: what each attempt at a room may cost, in QPs of a small room.
        explaining_work: what saying why not may cost a room, in QPs of a small room; it changes nothing, so broken rooms alone
            share it.
        offering: whether what would help is looked for.
    """

    catalogs: Catalogs
    locked: frozenset[str] = frozenset()
    moved: frozenset[str] = frozenset()
    walk: bool = True
    remove: bool = False
    previous: Mapping[str, Pose] = field(default_factory=dict)
    work: float = 0.0
    explaining_work: float = 0.0
    offering: bool = True

    def is_locked(self, body: Furniture | Decoration) -> bool:
        """Tells whether a body must stay exactly as sent."""
        return body.id in self.locked or (isinstance(body, Furniture) and body.locked)

    @cached_property
    def required_names(self) -> frozenset[str]:
        """Names that some room type requires; they are more important than others."""
        return frozenset(name for room in self.catalogs.rooms.values() for either in room.requires for name in either)

    @cached_property
    def use_sides(self) -> Mapping[str, tuple[Sequence[str], bool]]:
        """From which sides pieces are used and whether all of them must be reached, by name; none where nobody walks."""
        return self.catalogs.use_sides() if self.walk else {}

    @cached_property
    def wall_names(self) -> frozenset[str]:
        """Names of the pieces that stand at walls."""
        return frozenset(name for name, kind in self.catalogs.kinds_by_name().items() if kind.stands == "wall")
