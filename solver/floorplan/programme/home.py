"""plan_home(): the whole of it, top to bottom: programme -> rooms -> the cheapest drawing -> layout and notes.

Comes in: a request with a programme or an area, the catalogs. Goes out: `PlannedHome`. May import: the modules beside it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

from catalogs.schema import Catalogs
from solver.errors import RequestError
from solver.floorplan.layout import Layout
from solver.floorplan.programme.columns import LATTICE_MM
from solver.floorplan.programme.drafts import Frame
from solver.floorplan.programme.search import Found, Search
from solver.floorplan.programme.wishes import WALLS_SHARE, Wish, counts_of, loosened, spared, types_of, wishes_of
from solver.floorplan.programme.yard import PlannedHome, house_frame, with_yard
from solver.geometry import Rect, to_mm
from solver.scene import Request
from solver.streams import Stream

SLACKS: Final = (1.15, 1.5, 2.2, 4.0)
"""What limits are loosened by, one after the other, where the outline asked for lets no home keep them."""
FEWER: Final = 3
"""How many rooms may be left out, one after the other, before limits are loosened."""
TURNS: Final = 4
"""How often a home whose outline is free is searched for until all its rooms can be entered."""
SMALLER_SLACK: Final = 1.3
"""The same where rooms are left out because the others could not be lived in."""
LIVABLE: Final = 0.75
"""Share of its type's least area and width that a room may have in an outline that was asked for."""
ASTRAY: Final = 0.1
"""Share by which a house may miss the floor wished without its being said."""
HALLWAY: Final = "hallway"


def plan_home(request: Request, catalogs: Catalogs) -> PlannedHome:
    """Plans a home.

    Args:
        request: its seed must be set, and its programme or its area.
        catalogs: room types and presets.

    Raises:
        RequestError: the programme cannot be read, or what does not go with it is asked for.
    """
    types = types_of(counts_of(request, catalogs), catalogs)
    plot = _plot(request)
    home = _written(_Attempts(types, catalogs, plot).first_sound(), plot)
    return with_yard(home, Frame(plot.width, plot.depth), catalogs) if request.outdoor else home


@dataclass(frozen=True)
class _Plot:
    """What the request says about the house's outline: extents, mm (0: to be chosen), and floor, m2 (None: as typical).

    `yard` tells that some of the extents are the garden's.
    """

    seed: int
    width: int
    depth: int
    area: float | None
    yard: bool

    @property
    def fixed(self) -> bool:
        """Tells whether nothing about the outline is left to choose."""
        return bool(self.width and self.depth)

    def frame(self, kind: str) -> Frame:
        """Returns what is left of the outline for a house of a kind."""
        return house_frame(kind, Frame(self.width, self.depth)) if self.yard else Frame(self.width, self.depth)

    @property
    def floor(self) -> float | None:
        """Floor that the house is to have, m2; None where the outline is chosen for the rooms as they are wished."""
        frame = self.frame("rows")
        return frame.width * frame.depth / 1e6 if self.fixed else self.area

    def says(self) -> str:
        """Names what is given of the outline in words."""
        if self.fixed:
            return f"{self.width / 1000:g} x {self.depth / 1000:g} m"
        return f"{self.width / 1000:g} m of width" if self.width else f"{self.depth / 1000:g} m of depth"


def _plot(request: Request) -> _Plot:
    width, depth, area = to_mm(request.width or 0.0), to_mm(request.depth or 0.0), request.area
    if area is not None and width and depth:
        raise RequestError("area", f"is given beside width and depth, which make {width * depth / 1e6:g} m2", "two of the three")
    if area is not None and (width or depth):
        other = max(round(area * 1e6 / (width or depth) / LATTICE_MM) * LATTICE_MM, 2000)
        width, depth = width or other, depth or other
    return _Plot(request.seed or 0, width, depth, area, request.outdoor)


@dataclass(frozen=True)
class _Attempt:
    """A search's result, the wishes it is judged by, and which types were left out for it."""

    found: Found
    wishes: tuple[Wish, ...]
    left_out: tuple[str, ...]

    @property
    def sound(self) -> bool:
        """Tells whether every room has its size and can be entered."""
        return not self.found.verdict.short and not self.found.verdict.unreached

    @property
    def livable(self) -> bool:
        """Tells whether every room can be entered and misses the least area and width of its type by little."""
        return not self.found.verdict.unreached and all(
            (x1 - x0) * (z1 - z0) >= LIVABLE * wish.home.area[0] * 1e6 and min(x1 - x0, z1 - z0) >= LIVABLE * wish.home.width * 1000
            for wish, (x0, z0, x1, z1) in zip(self.wishes, self.found.sheet.boxes, strict=True)
        )


class _Attempts:
    """Searches with the whole programme, with fewer rooms, and with looser limits, until a home is sound."""

    def __init__(self, types: list[str], catalogs: Catalogs, plot: _Plot) -> None:
        self.types, self.catalogs, self.plot = types, catalogs, plot

    def first_sound(self) -> _Attempt:
        """Returns the first home that is sound, else the one with the fewest faults, with fewer rooms if they cannot be lived in."""
        attempts = list[_Attempt]()
        for attempt in self._each():
            if attempt.sound and attempt.livable:
                return attempt
            attempts.append(attempt)
        best = min(attempts, key=lambda attempt: attempt.found.rank)
        if best.livable or not (self.plot.width or self.plot.depth):
            return best
        return next((attempt for attempt in self._smaller(best) if attempt.livable), best)

    def _smaller(self, best: _Attempt) -> Iterator[_Attempt]:
        """Yields homes with ever fewer rooms than one that cannot be lived in."""
        left_out = list(best.left_out)
        types = self._without(left_out)
        while self._leave_out(types, left_out):
            yield self._attempt(types, left_out, 1.0)
            yield self._attempt(types, left_out, SMALLER_SLACK)

    def _without(self, left_out: Sequence[str]) -> list[str]:
        """Returns the types of the programme less those left out."""
        types, gone = list(self.types), list[str]()
        while len(gone) < len(left_out) and self._leave_out(types, gone):
            pass
        return types

    def _each(self) -> Iterator[_Attempt]:
        types, left_out = list(self.types), list[str]()
        floor = self.plot.floor if self.plot.fixed else None
        while floor is not None and self._floor(types, 0) > floor and self._leave_out(types, left_out):
            pass
        for turn in range(TURNS):
            yield self._attempt(types, left_out, 1.0, turn)
            if self.plot.width or self.plot.depth:
                break
        else:
            return
        fewer, gone = list(types), list(left_out)
        for _ in range(FEWER):
            if floor is None or self._floor(fewer, 1) <= floor or not self._leave_out(fewer, gone):
                break
            yield self._attempt(fewer, gone, 1.0)
        least = 1.0 if floor is None else max(1.0, floor / self._floor(types, 2), self._floor(types, 0) / floor)
        for slack in SLACKS:
            yield self._attempt(types, left_out, slack * least)

    def _floor(self, types: Sequence[str], which: int) -> float:
        """Returns the floor of a house with the rooms' least (0), typical (1) or greatest (2) areas, m2."""
        return sum(home.area[which] for name in types if (home := self.catalogs.rooms[name].home)) * WALLS_SHARE

    def _leave_out(self, types: list[str], left_out: list[str]) -> bool:
        name = spared(types, self.catalogs)
        if name is None:
            return False
        del types[len(types) - 1 - types[::-1].index(name)]
        left_out.append(name)
        return True

    def _attempt(self, types: Sequence[str], left_out: Sequence[str], slack: float, turn: int = 0) -> _Attempt:
        wishes = wishes_of(types, self.catalogs, self.plot.floor)
        loose = wishes if slack == 1.0 else loosened(wishes, slack, self.plot.floor)
        return _Attempt(Search(loose, self.plot.frame, self.plot.seed, turn).run(), wishes, tuple(left_out))


def _written(best: _Attempt, plot: _Plot) -> PlannedHome:
    """Writes the drawing as a layout, the hallway first, every second house mirrored."""
    sheet = best.found.sheet
    mirrored = Stream(plot.seed, "programme.mirror").chance(0.5)
    boxes = [sheet.hallway, *sheet.boxes] if sheet.hallway is not None else list(sheet.boxes)
    rooms = tuple(Rect(sheet.width - x1, z0, sheet.width - x0, z1) if mirrored else Rect(x0, z0, x1, z1) for x0, z0, x1, z1 in boxes)
    first = len(boxes) - len(sheet.boxes)
    owners = {first + i: first + wish.owner for i, wish in enumerate(best.wishes) if wish.owner is not None}
    entry = next((first + i for i, wish in enumerate(best.wishes) if wish.entry), None)
    types = (*(HALLWAY,) * first, *(wish.type for wish in best.wishes))
    layout = Layout(Rect(0, 0, sheet.width, sheet.depth), rooms, hallways=first, behind=owners)
    return PlannedHome(layout, types, entry, best.found.kind, _notes(best, plot, types, rooms))


def _notes(best: _Attempt, plot: _Plot, types: Sequence[str], rooms: Sequence[Rect]) -> tuple[str, ...]:
    """Says what was left out and which rooms miss the limits of their types."""
    notes = []
    if best.left_out:
        notes.append(f"left out, for want of space in {plot.says()}: {', '.join(best.left_out)}")
    first = len(rooms) - len(best.wishes)
    for i, (wish, rect) in enumerate(zip(best.wishes, rooms[first:], strict=True), start=first):
        missed = _missed(wish, rect)
        if missed:
            notes.append(f"{types[i]}_{i} {missed}")
    if plot.area is not None and not plot.fixed:
        floor = sum(rect.area_m2 for rect in rooms)
        if abs(floor / plot.area - 1) > ASTRAY:
            notes.append(
                f"the house has {floor:.0f} m2, not {plot.area:g}: its rooms would be too {'small' if floor > plot.area else 'large'}"
            )
    return tuple(notes)


def _missed(wish: Wish, rect: Rect) -> str:
    """Names the first limit of its type that a room misses."""
    home, (low, high) = wish.home, sorted((rect.width / 1000, rect.depth / 1000))
    if rect.area_m2 < home.area[0]:
        return f"has {rect.area_m2:.1f} m2, less than {home.area[0]:g}"
    if rect.area_m2 > home.area[2]:
        return f"has {rect.area_m2:.1f} m2, more than {home.area[2]:g}"
    if low < home.width:
        return f"is {low:g} m wide, less than {home.width:g}"
    if high > home.aspect * low + 1e-9:
        return f"is {high / low:.1f} times as long as wide, more than {home.aspect:g}"
    return ""
