"""A piece that matters, which the search left out though there is a place: it is searched again as if it were required.

Not here: whose rooms: a plan's, those that ask what stands elsewhere, and those that lack what is dear (generate).
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import Any, Final

from catalogs import Catalogs
from solver.pieces import Arrangement, Piece, Space
from solver.placement import needed, place

MATTERS: Final = 10.0
"""What leaving a piece out costs, from which on it is insisted on."""
DEAR: Final = 20.0
"""What leaving a piece out costs, from which on doors are shifted for it, too."""


@lru_cache(maxsize=1024)
def dear_in(catalogs: Catalogs, name: str) -> frozenset[str]:
    """Returns the labels of what is dear to leave out in rooms of a type."""
    kind = catalogs.rooms.get(name)
    return frozenset(f"{one.piece}_1" for one in kind.pieces if one.skip_cost >= DEAR) if kind else frozenset()


def insisting(space: Space, wanted: Sequence[Piece], arrangement: Arrangement, mattering: Collection[str] = ()) -> Arrangement:
    """Insists on the most important piece that matters and was left out; by default what is dear to leave out matters.

    Returns the arrangement with it where that is cheaper, all that is left out counted; else the arrangement as it was.
    """
    gone = {label for label, _ in arrangement.left_out}
    lacking = (piece for piece in wanted if piece.label in gone and not (piece.required or piece.is_floor))
    matter = (piece.label for piece in lacking if (piece.label in mattering if mattering else piece.skip_cost >= MATTERS))
    label = next(matter, None)
    if label is None:
        return arrangement
    (made,) = place([(space, demanded(wanted, label))], tidy=True)
    is_cheaper = _cost(wanted, made, mattering) < _cost(wanted, arrangement, mattering)
    return replace(made, insisted=label) if is_cheaper else arrangement


def demanded(wanted: Sequence[Piece], label: str | None) -> tuple[Piece, ...]:
    """Returns wanted pieces of which the one with a label is required, with what it stands together with alone: the floor of its fronts.

    Where others, as of a kitchen's run, have floor that matters, they keep it, too: what is required has it required, what is optional
    stands with it alone. Else what is insisted on would stand where their drawers open.
    """
    necessary = _necessary(wanted, label)
    floors = dict[str, list[Piece]]()
    for piece in wanted:
        if (owner := _owner(piece)) is not None:
            floors.setdefault(owner, []).append(piece)
    found = list[Piece]()
    for piece in wanted:
        if _owner(piece) is not None:
            continue
        required, own = piece.label in necessary, floors.get(piece.label, [])
        found.append(replace(piece, required=required, with_next=piece.with_next or (bool(own) and not required)))
        found += [replace(floor, required=required, with_next=not required and floor is not own[-1]) for floor in own]
    return tuple(found)


def _necessary(wanted: Sequence[Piece], label: str | None) -> set[str]:
    """Returns the labels of what is required with the piece of a label: all that it needs, each with what it stands together with alone."""
    found = set[str]()
    asked = {piece.label for piece in wanted if piece.required or piece.label == label}
    while asked != found:
        found = asked
        asked = needed([replace(piece, required=piece.label in found) for piece in wanted])
        asked |= {after.label for piece, after in pairwise(wanted) if piece.with_next and piece.label in asked}
    return found


def _owner(piece: Piece) -> str | None:
    """Returns the label of the piece whose floor it is, where that floor matters."""
    owners = {way.attach.parent for way in piece.candidates if way.attach} if piece.is_floor and piece.skip_cost >= MATTERS else ()
    return next(iter(owners)) if len(owners) == 1 else None


def insisted_in(certificate: Mapping[str, Any] | None, room: str) -> str | None:
    """Returns the label of the piece that a certificate says was insisted on in a room."""
    rooms = (certificate or {}).get("rooms")
    entry = rooms.get(room) if isinstance(rooms, Mapping) else None
    label = entry.get("insisted") if isinstance(entry, Mapping) else None
    return label if isinstance(label, str) else None


def _cost(wanted: Sequence[Piece], arrangement: Arrangement, mattering: Collection[str]) -> tuple[int, float]:
    """Returns how many pieces a room lacks that are required or matter so, and what its placement and all that it lacks cost."""
    gone = {label for label, _ in arrangement.left_out}
    dear = {piece.label for piece in wanted if piece.required} | set(mattering)
    return len(gone & dear), arrangement.cost + sum(piece.skip_cost for piece in wanted if piece.label in gone - dear)
