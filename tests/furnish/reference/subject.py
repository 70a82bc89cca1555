"""A piece of a room type that seeks its places, and the pieces that are there before it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from math import inf
from typing import NamedTuple

from catalogs.schema import RelationSpec
from solver.geometry import Rect
from solver.pieces import Candidate
from solver.relations.subject import Kind, Scope


class Parent(NamedTuple):
    """One way a piece may stand that another one relates to: what it is then."""

    label: str
    kind: Kind


@dataclass(frozen=True)
class Subject:
    """One copy of a piece that seeks its places.

    Args:
        scope: the room.
        variants: its kinds, each with what settling for it costs; the wanted one first.
        relations: what it wishes for.
        earlier: the labels of the pieces before it, by the names that relations call them.
        standing: the ways that each of those may stand, by label.
    """

    scope: Scope
    variants: tuple[tuple[Kind, float], ...]
    relations: tuple[RelationSpec, ...]
    earlier: Mapping[str, tuple[str, ...]]
    standing: Mapping[str, tuple[Parent, ...]]

    @property
    def kind(self) -> Kind:
        """The wanted kind."""
        return self.variants[0][0]

    def labels(self, names: tuple[str, ...]) -> list[str]:
        """Returns the labels of the earlier pieces of those names."""
        return [label for name in names for label in self.earlier.get(name, ())]

    def parents(self, names: tuple[str, ...]) -> list[Parent]:
        """Returns every way that the earlier pieces of those names may stand."""
        return [parent for label in self.labels(names) for parent in self.standing[label]]


def wished_footprint(candidate: Candidate) -> Rect:
    """Where a candidate is wished, in its parent's frame where it has one."""
    return Rect.around(candidate.anchor_mm, candidate.extent)


def missed(spec: RelationSpec) -> float:
    """Returns what doing without a relation costs: everything, where it is hard."""
    return inf if spec.required else spec.cost
