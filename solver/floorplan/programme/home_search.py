"""The search for a home, by the core: rooms are dealt to the strips of a skeleton, the strips' widths solved, the cheapest drawing kept.

The search itself is in solver/core/homes/, what each skeleton is like in solver/core/homes/drafts.hpp.
"""

from collections.abc import Callable, Sequence
from struct import Struct, pack
from typing import Final, NamedTuple

from solver.core import ask
from solver.fields import RECTANGLE
from solver.floorplan.programme.planned_rooms import PlannedRoom
from solver.floorplan.tiling import HouseWalls
from solver.geometry import Rect
from solver.streams import Stream

GIVEN: Final = "given"
"""The outline, and the kind, of homes in an outline that is given."""
TRIES: Final = 3
"""How often a search is begun anew in one kind."""
CENTRE_MM: Final = 1600
"""Width of an axial hallway: as narrow as the foyer at its end may be."""
RATIO: Final = 1.6
"""Width over depth of a house whose strips are as deep as wished. Our choice."""
FLOOR: Final = 1.1
"""Floor of a house over that of its rooms. Measured."""
KINDS: Final = ("rows", "full", "ranch", "axial", "winged", GIVEN)
OUTLINES: Final = (RECTANGLE, "L", "T", "U", GIVEN)
"""As the core numbers them."""
_HEADER: Final = Struct("<4i3qd")
_ROOM: Final = Struct("<5qd2qQ")
_KIND: Final = Struct("<3q3Q")
_RECT: Final = Struct("<4q")
_FOUND: Final = Struct("<4qd4q")


class Frame(NamedTuple):
    """Outer width and depth asked for, mm; 0 where they are chosen to fit."""

    width: int = 0
    depth: int = 0


class HomeSeed(NamedTuple):
    """The house's seed, and which search of it this is."""

    seed: int
    turn: int = 0


class HomeVerdict(NamedTuple):
    """What a home costs; how many of its rooms are short of their limits, cannot be entered as they should, miss the street, are dark."""

    cost: float
    short: int
    unreached: int
    streetless: int
    dark: int


class FoundHome(NamedTuple):
    """The cheapest home: its kind, the rectangles of its rooms by index and of its hallways, the extents of all, mm, and its verdict."""

    kind: str
    boxes: Sequence[Rect]
    hallways: Sequence[Rect]
    width: int
    depth: int
    verdict: HomeVerdict

    @property
    def rank(self) -> tuple[int, int, float]:
        """What is better among homes that are not sound: all rooms entered, few short, cheap."""
        return self.verdict.unreached, self.verdict.short, self.verdict.cost


def find_home(
    planned: Sequence[PlannedRoom], frame_of: Callable[[str], Frame], seed: HomeSeed, walls: HouseWalls, outline: str = RECTANGLE
) -> FoundHome | None:
    """Searches in the kind that the seed draws; in the others too where a room falls short in it.

    `frame_of` tells the frame of a house of a kind. The outline is a rectangle, L, T or U; other than a rectangle only where the frame is
    free. None where nothing has the outline; a rectangle is always found.
    """
    return _read(ask("find_home", home_rows(planned, frame_of, seed, walls, outline)), len(planned))


def find_home_within(planned: Sequence[PlannedRoom], tilings: Sequence[Sequence[Rect]], seed: int, walls: HouseWalls) -> FoundHome | None:
    """Searches in an outline that is given, by the rectangles that it may be cut into; no more of them than there are rooms."""
    return _read(ask("find_home", rows_within(planned, tilings, seed, walls)), len(planned))


def home_rows(
    planned: Sequence[PlannedRoom], frame_of: Callable[[str], Frame], seed: HomeSeed, walls: HouseWalls, outline: str = RECTANGLE
) -> bytes:
    """Returns what the core is asked by `find_home`."""
    if outline != RECTANGLE:
        kind = bent_kind(planned, outline)
        return _rows(planned, outline, [_kind_row(kind, Frame(), seed.seed, f"{outline}.{kind}.{seed.turn}")], walls)
    kinds = list(kinds_for(planned))
    if kinds[0] != "rows":
        Stream(seed.seed, "programme.kind").shuffle(kinds)
    rows = [_kind_row(kind, frame_of(kind), seed.seed, f"{kind}.{seed.turn}") for kind in dict.fromkeys(kinds)]
    return _rows(planned, outline, rows, walls)


def rows_within(planned: Sequence[PlannedRoom], tilings: Sequence[Sequence[Rect]], seed: int, walls: HouseWalls) -> bytes:
    """Returns what the core is asked by `find_home_within`."""
    fitting = [tiling for tiling in tilings if len(tiling) <= len(planned)]
    return _rows(planned, GIVEN, [_kind_row(GIVEN, Frame(), seed, f"{GIVEN}.{GIVEN}.0")], walls, fitting)


def _rows(
    planned: Sequence[PlannedRoom], outline: str, kinds: Sequence[bytes], walls: HouseWalls, tilings: Sequence[Sequence[Rect]] = ()
) -> bytes:
    floor = FLOOR * sum(one.size.typical for one in planned)
    wished = ((floor / RATIO) ** 0.5 - walls.hallway) / 2
    sizes = walls.hallway, CENTRE_MM + walls.more, walls.door_wall
    header = _HEADER.pack(OUTLINES.index(outline), len(planned), len(kinds), len(tilings), *sizes, wished)
    counts = [len(tiling) for tiling in tilings] + [0] * (len(tilings) % 2)
    rects = [_RECT.pack(*rect) for tiling in tilings for rect in tiling]
    return b"".join([header, *(_room_row(one, planned) for one in planned), *kinds, pack(f"<{len(counts)}i", *counts), *rects])


def _read(answer: bytes, rooms: int) -> FoundHome | None:
    found, kind, width, depth, *verdict = _FOUND.unpack_from(answer)
    if not found:
        return None
    boxes = [Rect(*row) for row in _RECT.iter_unpack(answer[_FOUND.size :])]
    return FoundHome(KINDS[kind], boxes[:rooms], boxes[rooms:], width, depth, HomeVerdict(*verdict))


def _kind_row(kind: str, frame: Frame, seed: int, name: str) -> bytes:
    """Writes a skeleton to search in, with the streams of its tries."""
    return _KIND.pack(KINDS.index(kind), *frame, *(Stream(seed, "programme", f"{name}.{number}").state for number in range(TRIES)))


def _room_row(one: PlannedRoom, planned: Sequence[PlannedRoom]) -> bytes:
    """Writes a room as the core reads it: its size, what it is (bit by bit), its owner, and behind which rooms a garage may lie."""
    plan, requires, size = one.kind.plan, one.kind.requires, one.size
    asked = (any(name in line for line in requires) for name in ("dining_table", "bed", "toilet"))
    traits = sum(is_so << bit for bit, is_so in enumerate((plan.way_through, plan.habitable, plan.wet, one.garage, *asked)))
    through = 0
    if one.garage:
        through = sum(1 << i for i, other in enumerate(planned) if other.type in plan.behind and not other.kind.plan.way_through)
    owner = -1 if one.owner is None else one.owner
    return _ROOM.pack(size.least, size.typical, size.most, size.width, size.length, size.aspect, traits, owner, through)


TWO_WINGS: Final = 4
"""Least private rooms of a home with two wings."""


def kinds_for(planned: Sequence[PlannedRoom]) -> tuple[str, ...]:
    """Returns the skeletons that suit a programme: by how many rooms need a hallway, and whether cars come in.

    Where rows suit, the others are only for homes that rows fail.

    The ranch stands thrice: it is drawn more often than the others, whose hallways are half as long again.
    """
    private = sum(not one.kind.plan.way_through and one.owner is None and not one.garage for one in planned)
    sleeping = sum(one.kind.plan.habitable and not one.public for one in planned)
    if sleeping <= 1 and private <= 3:
        return ("rows", "full", "ranch") if any(one.garage for one in planned) else ("rows", "full")
    public = sum(one.public for one in planned)
    kinds = ["full"]
    if public >= 2:
        kinds += ["ranch"] * 3
    if not any(one.garage for one in planned) and any(one.entry for one in planned):
        kinds.append("axial")
    return tuple(kinds)


def outlines_for(planned: Sequence[PlannedRoom]) -> tuple[str, ...]:
    """Returns the outlines that a programme's home may have."""
    kinds = kinds_for(planned)
    if kinds[0] == "rows":
        return ("rectangle", "L", "T")
    if "ranch" not in kinds:
        return ("rectangle",)
    private = sum(not one.public and not one.entry and not one.garage and one.owner is None for one in planned)
    return ("rectangle", "L", "T", "U") if private >= TWO_WINGS else ("rectangle", "L", "T")


def bent_kind(planned: Sequence[PlannedRoom], outline: str) -> str:
    """Returns the skeleton that makes an outline which is no rectangle."""
    if outline == "U":
        return "winged"
    return "rows" if kinds_for(planned)[0] == "rows" else "ranch"
