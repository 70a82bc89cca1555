"""What a rule is asked, and what it answers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Final, NamedTuple

from solver.body_rows import furniture_ids
from solver.validator.kinds import Kinds
from solver.validator.sent_rooms import NumberedKinds
from solver.validator.walk import JudgedRows, Walk
from solver.validator.world import PlacedRoom, World

JUDGED: Final = (
    "out_of_bounds",
    "overlap",
    "wall_far",
    "blocks_door",
    "blocks_window",
    "floating",
    "shapes_cross",
    "above_ceiling",
    "rooms_overlap",
    "opening_wrong",
)
"""The rules that the core judges, by their numbers there (`enum class Rule` of solver/core/validate/room.hpp)."""
FINDING_WORK: Final = 10
"""What putting a finding into words counts, and sending it; measured."""


class Told(NamedTuple):
    """A broken rule as the core tells it: bodies or openings by their place in the room, rooms in the storey; lengths in lattice steps."""

    body: int
    other: int
    amount: int
    a: int
    b: int
    c: int
    how: int


@dataclass(frozen=True)
class RuleCase:
    """A room to be judged: the house it is in, the walk of its storey, its kinds, and the room as the core reads it.

    `judged` is what the core tells of it, `others` are all rooms of the house by id.
    """

    world: World
    walk: Walk
    room: PlacedRoom
    table: NumberedKinds
    rows: bytes
    judged: JudgedRows
    others: Mapping[str, RuleCase] = field(default_factory=dict, compare=False, repr=False)

    @property
    def kinds(self) -> Kinds:
        """What the catalogs say."""
        return self.table.kinds

    @property
    def may_break_judged(self) -> bool:
        """Tells whether there may be something to say by the rules that the core judges."""
        return bool(self.judged.findings or self.judged.of_plan) or len(self.room.holes) < len(self.room.room.openings)

    @cached_property
    def told(self) -> Mapping[str, Sequence[Told]]:
        """What the core finds in the room, by rule."""
        found: dict[str, list[Told]] = {rule: [] for rule in JUDGED}
        for rule, *row in (*self.judged.findings, *self.judged.of_plan):
            found[JUDGED[rule]].append(Told(*row))
        return found

    def name(self, body: int) -> str:
        """Returns the id of a body by its place in the room."""
        pieces = furniture_ids(self.room.room)
        return pieces[body] if body < len(pieces) else self.room.ids[body]


class Finding(NamedTuple):
    """A broken rule before it is an issue: the bodies, by how much (lattice steps), the words; how severe, where not as the rule is."""

    ids: tuple[str, ...]
    amount: int
    message: str
    severity: str | None = None
