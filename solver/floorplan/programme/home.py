"""plan_home(): the whole of it, top to bottom: programme -> rooms -> the cheapest drawing -> layout and notes."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import accumulate
from typing import Final

from catalogs.schema import Catalogs
from solver.errors import RequestError
from solver.fields import ANY, RECTANGLE
from solver.floorplan.given import tilings_of
from solver.floorplan.programme.home_search import GIVEN, FoundHome, Frame, HomeSeed, find_home, find_home_within, outlines_for
from solver.floorplan.programme.planned_rooms import WALLS_SHARE, PlannedRoom, counts_of, loosened, planned_rooms, spared, types_of
from solver.floorplan.programme.yard import PlannedHome, house_frame, with_yard
from solver.floorplan.tiling import LATTICE_MM, LEAF_MM, HouseWalls, Layout
from solver.geometry import Rect, to_mm
from solver.request import Request
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
NARROW_MM: Final = 1500
"""Least width of a part of an outline that is given: a bathroom's. Our choice."""
HALLWAY: Final = "hallway"
DRAWN: Final = {"rectangle": 0.5, "L": 0.24, "T": 0.1, "U": 0.16}
"""How often each outline is drawn where any will do. Our choice."""
PLAINER: Final = {"U": ("U", "L", "rectangle"), "T": ("T", "L", "rectangle"), "L": ("L", "rectangle"), "rectangle": ("rectangle",)}
"""What is tried, one after the other, where the programme has no sound home of an outline."""


def plan_home(request: Request, catalogs: Catalogs, walls: HouseWalls) -> PlannedHome:
    """Plans a home; the request's seed must be set, and its programme or its area.

    Raises:
        RequestError: the programme cannot be read, or what does not go with it is asked for.
    """
    wider = max(0, to_mm(request.robot_width) - LEAF_MM)
    sized, plot = catalogs.widened(walls.more + wider), _plot(request)
    types = types_of(counts_of(request, sized), sized)
    home = _written(_Attempts(types, sized, plot, walls).first_sound(), plot, walls)
    return with_yard(home, Frame(plot.width, plot.depth), catalogs) if request.outdoor else home


@dataclass(frozen=True)
class _Plot:
    """What the request says about the house's outline: extents, mm (0: to be chosen), and floor, m2 (None: as typical).

    `yard` tells that some of the extents are the garden's. `outline` is the outline asked for; of a given one, `tilings` are ways to
    cut it into rectangles.
    """

    seed: int
    width: int
    depth: int
    area: float | None
    yard: bool
    outline: str
    tilings: tuple[tuple[Rect, ...], ...] = ()

    @property
    def parts(self) -> int:
        """The fewest rectangles that a given outline is cut into; every one holds a room."""
        return min((len(tiling) for tiling in self.tilings), default=1)

    @property
    def fixed(self) -> bool:
        """Tells whether nothing about the outline is left to choose."""
        return bool(self.tilings or (self.width and self.depth))

    @property
    def free(self) -> bool:
        """Tells whether nothing about the outline is given."""
        return not (self.tilings or self.width or self.depth)

    def frame(self, kind: str) -> Frame:
        """Returns what is left of the outline for a house of a kind."""
        return house_frame(kind, Frame(self.width, self.depth)) if self.yard else Frame(self.width, self.depth)

    @property
    def floor(self) -> float | None:
        """Floor that the house is to have, m2; None where the outline is chosen for the rooms as they are wished."""
        if self.tilings:
            return sum(rect.area_m2 for rect in self.tilings[0])
        frame = self.frame("rows")
        return frame.width * frame.depth / 1e6 if self.fixed else self.area

    def says(self) -> str:
        """Names what is given of the outline in words."""
        if self.tilings:
            return f"the outline's {self.floor:g} m2"
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
    outline = ANY if request.outline is None else request.outline
    if not isinstance(outline, str):
        return _given(request, outline)
    if outline not in (ANY, RECTANGLE) and (width or depth):
        raise RequestError("outline", f"{outline} is given beside width or depth", "an area, or nothing: the extents are chosen to fit")
    return _Plot(request.seed or 0, width, depth, area, request.outdoor, outline)


def _given(request: Request, corners: Sequence[tuple[float, float]]) -> _Plot:
    """Reads an outline's corners, m; extents and area are what they enclose."""
    for key in ("width", "depth", "area"):
        if getattr(request, key) is not None:
            raise RequestError(key, "is given beside the outline's corners", "one of the two")
    seed = request.seed or 0
    tilings = tilings_of(corners, Stream(seed, "programme.tilings"))
    narrow = min(min(rect.width, rect.depth) for rect in tilings[0])
    if narrow < NARROW_MM:
        raise RequestError(
            "outline", f"has a part that is {narrow / 1000:g} m wide", f"parts of at least {NARROW_MM / 1000:g} m for a program"
        )
    return _Plot(seed, 0, 0, None, request.outdoor, GIVEN, tilings)


@dataclass(frozen=True)
class _Attempt:
    """A search's result, the rooms it is judged by, and which types were left out for it."""

    found: FoundHome
    planned: tuple[PlannedRoom, ...]
    left_out: tuple[str, ...]
    outline: str

    @property
    def sound(self) -> bool:
        """Tells whether every room has its size and can be entered, in an outline of our choice also those on the street from there."""
        verdict = self.found.verdict
        return not verdict.short and not verdict.unreached and (self.outline == RECTANGLE or not verdict.streetless)

    @property
    def livable(self) -> bool:
        """Tells whether every room can be entered and misses the least area and width of its type by little, and has light if given."""
        dark = self.outline == GIVEN and self.found.verdict.dark
        return not (self.found.verdict.unreached or dark) and all(
            (x1 - x0) * (z1 - z0) >= LIVABLE * one.home.area[0] * 1e6 and min(x1 - x0, z1 - z0) >= LIVABLE * one.home.width * 1000
            for one, (x0, z0, x1, z1) in zip(self.planned, self.found.boxes, strict=True)
        )


class _Attempts:
    """Searches with the whole programme, with fewer rooms, and with looser limits, until a home is sound."""

    def __init__(self, types: Sequence[str], catalogs: Catalogs, plot: _Plot, walls: HouseWalls) -> None:
        self.catalogs, self.plot, self.walls = catalogs, plot, walls
        self.types = tuple(types)

    @cached_property
    def programmes(self) -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
        """The types less 0, 1, 2 ... rooms, those first that a home can best do without; and the rooms left out."""
        programmes: list[tuple[tuple[str, ...], tuple[str, ...]]] = [(self.types, ())]
        left, parts = list(self.types), self.plot.parts
        if len(left) < parts:
            raise RequestError("outline", f"is made up of {parts} rectangles, more than the program has rooms", f"at most {len(left)}")
        while (name := spared(left, self.catalogs)) is not None and len(left) > parts:
            del left[len(left) - 1 - left[::-1].index(name)]
            programmes.append((tuple(left), (*programmes[-1][1], name)))
        return programmes

    def first_sound(self) -> _Attempt:
        """Returns the first home that is sound, else the one with the fewest faults, with fewer rooms if they cannot be lived in."""
        attempts = list[_Attempt]()
        for attempt in self._each():
            if attempt.sound and attempt.livable:
                return attempt
            attempts.append(attempt)
        best = min(
            attempts, key=lambda attempt: (not attempt.livable, attempt.found.rank) if self.plot.tilings else (False, attempt.found.rank)
        )
        if best.livable or self.plot.free:
            return best
        fewer = range(len(best.left_out) + 1, len(self.programmes))
        smaller = (self._attempt(without, slack) for without in fewer for slack in (1.0, SMALLER_SLACK))
        found = next((attempt for attempt in smaller if attempt.livable), best)
        if self.plot.tilings and not found.livable:
            raise _refused(found, self.plot)
        return found

    def _each(self) -> Iterator[_Attempt]:
        if self.plot.free:
            for outline in self._outlines():
                yield from self._turns(outline)
            return
        without, last = 0, len(self.programmes) - 1
        floor = self.plot.floor if self.plot.fixed else None
        while floor is not None and without < last and self._floor(without, 0) > floor:
            without += 1
        yield self._attempt(without, 1.0)
        for fewer in range(without + 1, min(without + FEWER, last) + 1):
            if floor is None or self._floor(fewer - 1, 1) <= floor:
                break
            yield self._attempt(fewer, 1.0)
        least = 1.0 if floor is None else max(1.0, floor / self._floor(without, 2), self._floor(without, 0) / floor)
        for slack in SLACKS:
            yield self._attempt(without, slack * least)

    def _floor(self, without: int, which: int) -> float:
        """Returns the floor of a house with the least (0), typical (1) or greatest (2) areas of the rooms not left out, m2."""
        types = self.programmes[without][0]
        return sum(home.area[which] for name in types if (home := self.catalogs.rooms[name].home)) * WALLS_SHARE

    def _outlines(self) -> tuple[str, ...]:
        """Returns the outlines to try: that asked for, or one that the seed draws, and plainer ones behind it."""
        if self.plot.outline != ANY:
            return PLAINER[self.plot.outline]
        drawn = Stream(self.plot.seed, "programme.outline").uniform(0.0, 1.0)
        within = (name for name, share in zip(DRAWN, accumulate(DRAWN.values()), strict=True) if drawn < share)
        return PLAINER[next(within, RECTANGLE)]

    def _turns(self, outline: str) -> Iterator[_Attempt]:
        """Yields homes of the whole programme in an outline that is free."""
        planned = planned_rooms(self.types, self.catalogs, self.plot.floor)
        if outline not in outlines_for(planned):
            return
        for turn in range(TURNS):
            found = find_home(planned, self.plot.frame, HomeSeed(self.plot.seed, turn), self.walls, outline)
            if found is not None:
                yield _Attempt(found, planned, (), outline)

    def _attempt(self, without: int, slack: float) -> _Attempt:
        types, left_out = self.programmes[without]
        planned = planned_rooms(types, self.catalogs, self.plot.floor)
        loose = planned if slack == 1.0 else loosened(planned, slack, self.plot.floor)
        if self.plot.tilings:
            found = find_home_within(loose, self.plot.tilings, self.plot.seed, self.walls)
        else:
            found = find_home(loose, self.plot.frame, HomeSeed(self.plot.seed), self.walls)
        if found is None:
            asked = "outline" if self.plot.tilings else "depth" if self.plot.depth else "width"
            raise RequestError(asked, f"has no space for {len(planned)} rooms in {self.plot.says()}", "a larger outline, or fewer rooms")
        return _Attempt(found, planned, left_out, self.plot.outline if self.plot.tilings else RECTANGLE)


def _refused(best: _Attempt, plot: _Plot) -> RequestError:
    """Says of an outline that holds no home what the nearest one to it misses."""
    rooms = zip(best.planned, best.found.boxes, strict=True)
    missed = [f"a {one.type} {words}" for one, rect in rooms if (words := _missed(one, rect))]
    narrow = min(min(rect.width, rect.depth) for rect in plot.tilings[0]) / 1000
    verdict = best.found.verdict
    why = "rooms cannot be entered" if verdict.unreached else "rooms have no window" if verdict.dark else missed[0]
    return RequestError(
        "outline",
        f"holds no home of this program in {plot.floor:g} m2, its narrowest part {narrow:g} m: at best {why}",
        "a larger or plainer outline, or fewer rooms",
    )


def _written(best: _Attempt, plot: _Plot, walls: HouseWalls) -> PlannedHome:
    """Writes the drawing as a layout, the hallway first, every second house mirrored."""
    found = best.found
    mirrored = not plot.tilings and Stream(plot.seed, "programme.mirror").chance(0.5)
    boxes = [*found.hallways, *found.boxes]
    rooms = tuple(Rect(found.width - x1, z0, found.width - x0, z1) if mirrored else Rect(x0, z0, x1, z1) for x0, z0, x1, z1 in boxes)
    first = len(boxes) - len(found.boxes)
    owners = {first + i: first + one.owner for i, one in enumerate(best.planned) if one.owner is not None}
    types = (*(HALLWAY,) * first, *(one.type for one in best.planned))
    layout = Layout(Rect(0, 0, found.width, found.depth), rooms, hallways=first, behind=owners, walls=walls)
    return PlannedHome(layout, types, found.kind, _notes(best, plot, types, rooms))


def _notes(best: _Attempt, plot: _Plot, types: Sequence[str], rooms: Sequence[Rect]) -> tuple[str, ...]:
    """Says what was left out and which rooms miss the limits of their types."""
    notes = []
    if plot.outline not in (ANY, best.outline):
        notes.append(f"no sound home of these rooms was found whose outline is {plot.outline}: it is {best.outline}")
    if best.left_out:
        notes.append(f"left out, for want of space in {plot.says()}: {', '.join(best.left_out)}")
    if not (best.livable or plot.free):
        notes.append(f"no home that can be lived in was found for these rooms in {plot.says()}: another size, or fewer rooms, may help")
    first = len(rooms) - len(best.planned)
    for i, (one, rect) in enumerate(zip(best.planned, rooms[first:], strict=True), start=first):
        missed = _missed(one, rect)
        if missed:
            notes.append(f"{types[i]}_{i} {missed}")
    if plot.area is not None and not plot.fixed:
        floor = sum(rect.area_m2 for rect in rooms)
        if abs(floor / plot.area - 1) > ASTRAY:
            notes.append(
                f"the house has {floor:.0f} m2, not {plot.area:g}: its rooms would be too {'small' if floor > plot.area else 'large'}"
            )
    return tuple(notes)


def _missed(one: PlannedRoom, rect: Rect) -> str:
    """Names the first limit of its type that a room misses."""
    home, (low, high) = one.home, sorted((rect.width / 1000, rect.depth / 1000))
    if rect.area_m2 < home.area[0]:
        return f"has {rect.area_m2:.1f} m2, less than {home.area[0]:g}"
    if rect.area_m2 > home.area[2]:
        return f"has {rect.area_m2:.1f} m2, more than {home.area[2]:g}"
    if low < home.width:
        return f"is {low:g} m wide, less than {home.width:g}"
    if high > home.aspect * low + 1e-9:
        return f"is {high / low:.1f} times as long as it is wide; rooms of its type are at most {home.aspect:g} times"
    return ""
