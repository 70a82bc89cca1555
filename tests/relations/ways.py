"""The ways to stand that a piece of a list gets, alone in a room but for another piece."""

from __future__ import annotations

from catalogs.schema import RelationSpec
from solver.furnish import Habits, Listing
from solver.geometry import Rect
from solver.pieces import Candidate, Opened, Space
from solver.relations.subject import Kind, Scope
from solver.requested import PieceRequest
from solver.scene import Room

CLEAR = Rect(0, 0, 5000, 4000)
SCOPE = Scope(CLEAR, (Opened("door", "south", (1000, 1900), 4000), Opened("window", "north", (2000, 3400), 0)))


def ways(spec: RelationSpec, own: Kind, other: Kind) -> tuple[Candidate, ...]:
    """Returns all ways of a piece with one relation, in SCOPE; the other one is called `it`."""
    space = Space("den", CLEAR, (), (), gap_mm=SCOPE.gap_mm, openings=SCOPE.openings)
    asked = (PieceRequest("it", other.name), PieceRequest("own", own.name, relations=(spec,)))
    listed = Listing(Room("den", width=5.0, depth=4.0), space, space.zones, asked, {"it": other, "own": own}, Habits(), (), {}).nearly_all
    assert listed is not None
    return listed.pieces[1].candidates


def beside(spec: RelationSpec, own: Kind, other: Kind) -> list[Candidate]:
    """Returns those in the other piece's frame, where they hold the relation to it."""
    return [way for way in ways(spec, own, other) if way.attach is not None]


def holding(spec: RelationSpec, own: Kind, other: Kind) -> list[Candidate]:
    """Returns those in the room that do not pay for missing the relation to it."""
    return [way for way in ways(spec, own, other) if way.attach is None and way.cost < spec.cost]
