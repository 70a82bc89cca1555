"""Furniture of a foreign plan -> furniture of the scene's rooms, under its own names: /fix understands and repairs it."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from itertools import count
from typing import Final, TypeVar

from catalogs import Catalogs
from catalogs.kind_book import UPRIGHT
from catalogs.synonyms import Meaning, Synonyms, synonyms_of, words_of
from solver.geometry import encloses, extents, to_mm
from solver.imports.carried_things import RESTING, covers
from solver.imports.drawn import DrawnPiece, PlanNotes, check_count
from solver.imports.rectilinear import FloorCorner
from solver.imports.unsized_things import with_usual_sizes
from solver.plain import quoted
from solver.scene import Decoration, Furniture, Room

Body = TypeVar("Body", Furniture, Decoration)
LIVING: Final = "dynamic"
"""The category of who is no furniture."""
SEAT_WIDTH: Final = 0.8
"""A seat that may be under a table is no wider, m."""
TABLE_HEIGHT: Final = 0.46
"""A table that a seat may be under is higher, m."""
TUCKED: Final = 0.005
"""A seat is under a table if their footprints share more, m."""
MOST_IN_ROOM: Final = 1_000
"""Things in a room. Our choice: each may be in the way of each."""
LARGEST: Final = 50.0
"""Nothing in a home is larger, m."""
ABOVE_SILL: Final = 0.02
"""What is higher than a window's sill by no more, m, is drawn to stand beneath it: it is taken as high as the sill."""
OVERHEAD: Final = 1.6
"""Furniture that begins higher, m, hangs on the wall: a board."""
HIGH: Final = frozenset({"electronics"})
"""Categories of which pieces stay what they are however high they hang: screens."""
HUNG: Final = "wall_cabinet"
"""What hangs on the wall under its own name, as there is no kind of it."""


def with_pieces(
    rooms: Sequence[Room], pieces: Sequence[DrawnPiece], origin: FloorCorner, catalogs: Catalogs, notes: PlanNotes
) -> list[Room]:
    """Returns rooms with the pieces that stand in them; what stands in none, or has no size, is left out and told."""
    furniture: list[list[Furniture]] = [[] for _ in rooms]
    decorations: list[list[Decoration]] = [[] for _ in rooms]
    outlines = [_outline(room) for room in rooms]
    unsized: Counter[tuple[str, str]] = Counter()
    names, taken = synonyms_of(catalogs), {piece.id for piece in pieces}
    for piece in with_usual_sizes(_told_apart(pieces, notes), catalogs):
        x, z = (piece.x - origin[0]) / 1000, (piece.z - origin[1]) / 1000
        place = next((at for at, outline in enumerate(outlines) if encloses(outline, x * 1000, z * 1000)), None)
        if place is not None:
            check_count(f"things in {rooms[place].id}", len(furniture[place]) + len(decorations[place]) + 1, MOST_IN_ROOM)
        meaning = _meaning(piece, names)
        size = piece.size
        if place is None or size is None or not 0 < min(size) <= max(size) <= LARGEST or abs(piece.y) > LARGEST:
            words = "its size is none" if abs(piece.y) <= LARGEST else f"it is more than {LARGEST:g} m from the floor"
            words = "it stands in no room" if place is None else "the file gives no size" if size is None else words
            notes.leave(piece.where, f"{quoted(piece.name)}: {words}")
            continue
        sort = _sort(meaning, catalogs)
        if sort == LIVING:
            notes.leave(piece.where, f"{quoted(piece.name)}: people and pets are left out")
            continue
        kind = piece.kind if meaning is not None and meaning.key == _plain(piece.kind) else None
        room, sizes = rooms[place], tuple(max(0.001, round(one, 3)) for one in size)
        body = replace(piece, x=round(x - room.x, 4), z=round(z - room.z, 4), size=(sizes[0], sizes[1], sizes[2]))
        if piece.decoration or _hangs(meaning, sort, piece.y):
            if piece.usual:
                unsized[piece.name, _written(sizes)] += 1
            body = _named(body, f"{room.id}/small_", len(decorations[place]), taken)
            decorations[place].append(_written_body(Decoration, body, kind))
        elif meaning is not None and meaning.sort == "other":
            notes.leave(piece.where, f"{quoted(piece.name)}: no furniture")
        else:
            if piece.usual:
                notes.guess(piece.where, "size", _written(sizes), f"{quoted(piece.name)}: the file gives no size")
            body = _named(body, f"{room.id}/", len(furniture[place]), taken)
            body = _on_whole_mm(body)
            furniture[place].append(replace(_written_body(Furniture, body, kind), on=_under(body, furniture[place])))
    for (name, usual), many in unsized.items():
        notes.guess("plan", "size", usual, f"{quoted(name)}: the file gives no size of {many} of them")
    return [
        replace(room, furniture=tuple(_beneath_sills(room, _tucked(_on_top(standing, catalogs, notes), catalogs), notes)),
                decorations=tuple(small))
        for room, standing, small in zip(rooms, furniture, decorations, strict=True)
    ]  # fmt: skip


def _on_whole_mm(piece: DrawnPiece) -> DrawnPiece:
    """Returns a piece moved by less than a millimetre so that its footprint, squared up, begins on whole ones: it takes up its size."""
    width, depth, _ = piece.size or (0.0, 0.0, 0.0)
    reach = extents(width, depth, round(piece.rotation / 90) * 90.0)
    x, z = (round((at - wide / 2) * 1000) / 1000 + wide / 2 for at, wide in zip((piece.x, piece.z), reach, strict=True))
    return replace(piece, x=round(x, 4), z=round(z, 4))


def _meaning(piece: DrawnPiece, synonyms: Synonyms) -> Meaning | None:
    """Returns what a piece is: of the kind that the file names, if it is one of ours, else by its name and size."""
    if piece.size and min(piece.size) <= 0:
        return None
    return synonyms.said(_plain(piece.kind)) or synonyms.meaning(piece.name, piece.size)


def _hangs(meaning: Meaning | None, sort: str | None, above: float) -> bool:
    """Tells whether a thing is none that stands on the floor: a decoration, or what hangs on the wall, from so high on, m."""
    if meaning is None:
        return above > OVERHEAD
    return meaning.sort == "decoration" or meaning.key == HUNG or (meaning.sort == "furniture" and above > OVERHEAD and sort not in HIGH)


def _plain(kind: str | None) -> str | None:
    """Returns the kind of a thing that may be tipped onto its edge."""
    return kind and kind.removesuffix(UPRIGHT)


def _written(sizes: Sequence[float]) -> str:
    return " x ".join(f"{one:g}" for one in sizes)


def _outline(room: Room) -> list[FloorCorner]:
    return [(to_mm(room.x + x), to_mm(room.z + z)) for x, z in room.corners]


def _sort(meaning: Meaning | None, catalogs: Catalogs) -> str | None:
    """Returns the category of a kind of furniture."""
    return catalogs.furniture[meaning.key].category if meaning is not None and meaning.sort == "furniture" else None


def _sort_of(one: Furniture, catalogs: Catalogs) -> str | None:
    """Returns the category of what a piece of the scene is: of its kind, else by its name and size."""
    names = synonyms_of(catalogs)
    return _sort(names.said(one.kind) or names.meaning(one.name, (one.width, one.depth, one.height)), catalogs)


def _on_top(standing: Sequence[Furniture], catalogs: Catalogs, notes: PlanNotes) -> list[Furniture]:
    """Returns furniture whose screens stand on the pieces within which they are drawn, as in the open front of a cabinet."""
    found = []
    for one in standing:
        is_screen = one.y >= RESTING and one.on is None and _sort_of(one, catalogs) in HIGH
        tops = ((round(other.y + other.height, 4), other) for other in standing if is_screen and covers(other, one.x, one.z))
        top, other = next(((top, other) for top, other in tops if other is not one and one.y < top <= OVERHEAD), (one.y, None))
        if other is not None:
            notes.change("furniture", one.id, top - one.y, f"put on {other.id}: it is drawn within it")
        found.append(one if other is None else replace(one, y=top, on=other.id))
    return found


def _tucked(standing: Sequence[Furniture], catalogs: Catalogs) -> list[Furniture]:
    """Returns furniture whose seats say which table they are drawn under."""
    sorts = [_sort_of(one, catalogs) for one in standing]
    tables = [one for one, sort in zip(standing, sorts, strict=True) if sort == "table" and one.y == 0.0 and one.height > TABLE_HEIGHT]
    found = []
    for one, sort in zip(standing, sorts, strict=True):
        near = [(_shared(one, table), table.id) for table in tables] if sort == "seating" and one.width <= SEAT_WIDTH else []
        share, name = max(near, default=(0.0, ""))
        found.append(replace(one, under=name) if share > TUCKED else one)
    return found


def _beneath_sills(room: Room, standing: Sequence[Furniture], notes: PlanNotes) -> list[Furniture]:
    """Returns furniture as high as a sill of the room where it is hardly higher: a tap, drawn with its sink."""
    sills = sorted({opening.sill for opening in room.openings if opening.kind == "window"})
    found = []
    for one in standing:
        sill = next((sill for sill in sills if 0 < one.y + one.height - sill <= ABOVE_SILL and sill > one.y), None)
        if sill is not None:
            notes.change("furniture", one.id, one.y + one.height - sill, f"taken as high as a window's sill, {sill:g} m")
        found.append(one if sill is None else replace(one, height=round(sill - one.y, 3)))
    return found


def _shared(a: Furniture, b: Furniture) -> float:
    """Returns over how much two footprints overlap, the lesser of the two ways, m; as if both stood at right angles."""
    reach = [(one.depth, one.width) if round(one.rotation / 90) % 2 else (one.width, one.depth) for one in (a, b)]
    across, along = ((reach[0][k] + reach[1][k]) / 2 for k in (0, 1))
    return min(across - abs(a.x - b.x), along - abs(a.z - b.z))


def _written_body(of: type[Body], piece: DrawnPiece, kind: str | None) -> Body:
    width, depth, height = piece.size or (0.0, 0.0, 0.0)
    return of(
        piece.id, piece.name, x=piece.x, y=round(max(piece.y, 0.0), 4), z=piece.z,
        rotation=round(piece.rotation % 360, 3) % 360, width=width, depth=depth, height=height, color=piece.color, kind=kind,
    )  # fmt: skip


def _told_apart(pieces: Sequence[DrawnPiece], notes: PlanNotes) -> list[DrawnPiece]:
    """Returns pieces of which no two say one id: a copy of an element has that of the first, which keeps it."""
    seen = {""}
    found = []
    for piece in pieces:
        if piece.id and piece.id in seen:
            notes.change("furniture", piece.where, 0.0, f"another piece has the id {quoted(piece.id)}, too: this one gets an own")
        found.append(replace(piece, id="") if piece.id in seen else piece)
        seen.add(piece.id)
    return found


def _named(piece: DrawnPiece, prefix: str, number: int, taken: set[str]) -> DrawnPiece:
    """Returns a piece with an id, where it has none of its own: its room, what it is called, its number there or the next free one."""
    if piece.id:
        return piece
    stem = prefix + ("_".join(words_of(piece.name)) or "piece")
    name = next(name for more in count(number + 1) if (name := f"{stem}_{more}") not in taken)
    taken.add(name)
    return replace(piece, id=name)


def _under(piece: DrawnPiece, there: Sequence[Furniture]) -> str | None:
    """Returns what a thing above the floor stands on: the piece below its middle whose top is its underside."""
    if piece.y < RESTING:
        return None
    below = [one for one in there if abs(one.y + one.height - piece.y) <= RESTING and covers(one, piece.x, piece.z)]
    return below[0].id if below else None
