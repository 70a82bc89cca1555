"""What a rule is asked, and what it answers. May import: nothing of ours but the scene in exact numbers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from solver.validator.kinds import Kinds
from solver.validator.walk import Walk
from solver.validator.world import PlacedRoom, World


@dataclass(frozen=True)
class RuleCase:
    """A room to be judged: the house it is in, the walk of its storey, and what the catalogs say."""

    world: World
    walk: Walk
    room: PlacedRoom
    kinds: Kinds


class Finding(NamedTuple):
    """A broken rule before it is an issue: the bodies, by how much (lattice steps), and the words."""

    ids: tuple[str, ...]
    amount: int
    message: str
