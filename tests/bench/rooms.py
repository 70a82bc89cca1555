"""Seeded placement problems, realistic and tight, built by hand: what the search is measured on.

Every piece has one fixed way to stand (a wall or free, a rotation); what is left is where along the wall and on which side
of each other. 3-14 pieces, floor cover 0.1-0.45, companions tied or attached, people's squares at use sides, door squares
and windows as zones.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from itertools import combinations

from solver.geometry import FACING, ROTATION_AT_WALL, Rect, rotate, strip, turned
from solver.placement.problem import DifferenceRow, ProblemBox
from solver.streams import Stream
from tests.oracles.problem import Problem, Term
from tests.oracles.problems import anchor, apart, choose, clear_of, new_variable

PERSON_MM = 600
WALLS = tuple(ROTATION_AT_WALL)
HOUSE = (3, 4, 4, 5, 5, 6, 6, 6, 7, 7, 8, 9, 10)
"""Pieces of the 13 rooms of a house: 80."""
LEAST_AREA, MOST_AREA, SHORT_SIDE = 4.0, 45.0, 1.9
"""Of the floor between the walls' faces, m2 and m."""
Size = tuple[int, int, int]


@dataclass(frozen=True)
class Sort:
    """A sort of furniture: sizes in mm from least to most, where it stands, whether its front is used."""

    least: Size
    most: Size
    wall: bool = True
    used: bool = True


SORTS = {
    "bed": Sort((900, 1950, 800), (1800, 2100, 1000)),
    "wardrobe": Sort((800, 550, 1900), (2000, 620, 2200)),
    "dresser": Sort((700, 400, 750), (1300, 500, 900)),
    "desk": Sort((1000, 500, 720), (1600, 800, 760), used=False),
    "shelf": Sort((500, 250, 1600), (1200, 400, 2000)),
    "sofa": Sort((1400, 800, 800), (2300, 950, 900)),
    "counter": Sort((600, 580, 850), (1900, 620, 920)),
    "cabinet": Sort((400, 300, 500), (700, 600, 2000), used=False),
    "table": Sort((750, 700, 720), (1700, 950, 760), wall=False, used=False),
    "armchair": Sort((700, 700, 800), (900, 900, 900), wall=False),
    "plant": Sort((300, 300, 900), (450, 450, 1200), wall=False, used=False),
}
WITH_COMPANION = ("bed", "desk", "sofa", "table")


@dataclass
class Room:
    """A room under construction: the floor, the problem, and what stands in it."""

    clear: Rect
    stream: Stream
    problem: Problem = field(default_factory=Problem)
    zones: list[tuple[Rect, int]] = field(default_factory=list)
    """Rectangle and the height from which it counts."""
    turns: dict[str, int] = field(default_factory=dict)
    tucked: set[tuple[str, str]] = field(default_factory=set)
    """Pairs that may overlap."""

    def body(self, label: str, size: Size, wall: str | None) -> ProblemBox:
        """Adds a piece at a wall, 30 mm off its face, or free."""
        turn = ROTATION_AT_WALL[wall] if wall else 90 * self.stream.below(4)
        extent = turned(size[0], size[1], turn)
        low = [self.clear.x0, self.clear.z0]
        high = [self.clear.x1 - extent[0], self.clear.z1 - extent[1]]
        if wall:
            axis = 1 if wall in ("north", "south") else 0
            low[axis] = high[axis] = low[axis] + 30 if wall in ("north", "west") else high[axis] - 30
        var = (new_variable(self.problem, 0, low[0], high[0]), new_variable(self.problem, 1, low[1], high[1]))
        for axis in (0, 1):
            wish = low[axis] / 1000 + self.stream.unit() * (high[axis] - low[axis]) / 1000
            self.problem.terms.append(anchor(axis, var[axis], wish, self.stream.pick((0.05, 0.3, 1.0, 4.0))))
        return self._part(ProblemBox(label, False, var, (0, 0), extent, 0, size[2]), turn)

    def _part(self, part: ProblemBox, turn: int) -> ProblemBox:
        self.problem.boxes.append(part)
        self.turns[part.label] = turn
        return part

    def companion(self, label: str, parent: ProblemBox, size: Size, place: tuple[str, int, int]) -> ProblemBox:
        """Adds a piece at a side of another, `gap` mm from it, free to slide by `slide` mm each way (0: a rigid tie)."""
        side, gap, slide = place
        turn = self.turns[parent.label]
        dx, dz = rotate(*{"front": (0, 1), "left": (-1, 0), "right": (1, 0)}[side], turn)
        extent = turned(size[0], size[1], turn)
        var, offset = [0, 0], [0, 0]
        for axis, step in enumerate((dx, dz)):
            at = (parent.extent[axis] - extent[axis]) // 2
            if step:
                at = parent.extent[axis] + gap if step > 0 else -extent[axis] - gap
            if step or not slide:
                var[axis], offset[axis] = parent.var[axis], parent.offset[axis] + at
                self._within(axis, var[axis], offset[axis], extent[axis])
            else:
                var[axis] = self._sliding(axis, parent, extent[axis], (at - slide, at + slide))
        return self._part(ProblemBox(label, False, (var[0], var[1]), (offset[0], offset[1]), extent, 0, size[2]), turn)

    def _within(self, axis: int, variable: int, offset: int, extent: int) -> None:
        low, high = (self.clear.x0, self.clear.x1) if axis == 0 else (self.clear.z0, self.clear.z1)
        own = self.problem
        own.low[axis][variable] = max(own.low[axis][variable], low - offset)
        own.high[axis][variable] = min(own.high[axis][variable], high - extent - offset)

    def _sliding(self, axis: int, parent: ProblemBox, extent: int, between: tuple[int, int]) -> int:
        """Adds a variable tied to a parent by two rows and drawn to their middle."""
        low, high = (self.clear.x0, self.clear.x1) if axis == 0 else (self.clear.z0, self.clear.z1)
        own = new_variable(self.problem, axis, low, high - extent)
        least, most = (parent.offset[axis] + end for end in between)
        self.problem.rows += [DifferenceRow(axis, parent.var[axis], own, least), DifferenceRow(axis, own, parent.var[axis], -most)]
        self.problem.terms.append(Term(axis, parent.var[axis], own, (least + most) / 2000, 0.02))
        return own

    def stand(self, body: ProblemBox) -> None:
        """Adds a person's square that touches the front of a piece and slides along it."""
        dx, dz = FACING[self.turns[body.label]]
        normal = 0 if dx else 1
        offset, var = [0, 0], [0, 0]
        var[normal] = body.var[normal]
        offset[normal] = body.offset[normal] + (body.extent[normal] if dx + dz > 0 else -PERSON_MM)
        self._within(normal, var[normal], offset[normal], PERSON_MM)
        half, along = PERSON_MM // 2, 1 - normal
        var[along] = self._sliding(along, body, PERSON_MM, (-half, body.extent[along] - half))
        extent = (PERSON_MM, PERSON_MM)
        self.problem.boxes.append(ProblemBox(body.label, True, (var[0], var[1]), (offset[0], offset[1]), extent, 0, 1800))

    def close(self) -> Problem:
        """Adds the choices: every pair of solids apart, every solid clear of the zones it reaches up to."""
        for part in self.problem.boxes:
            for k, (rect, above) in enumerate(self.zones):
                if not part.stand and part.top > above:
                    choose(self.problem, part.label, f"zone_{k}", clear_of(part, rect))
        for a, b in combinations(self.problem.boxes, 2):
            together = a.label == b.label or (a.stand and b.stand)
            if not together and (a.stand or b.stand or (a.label, b.label) not in self.tucked):
                choose(self.problem, a.label, b.label, apart(a, b))
        return self.problem


def _sizes(stream: Stream, count: int) -> list[tuple[str, Size, int]]:
    """Draws main pieces with the number of their companions, `count` in all: sort, size, companions."""
    names = tuple(SORTS)
    drawn: list[tuple[str, Size, int]] = []
    left = count
    while left > 0:
        name = stream.pick(names)
        sort = SORTS[name]
        width, depth, height = (low + stream.below(high - low + 1) for low, high in zip(sort.least, sort.most, strict=True))
        companions = min(1 + stream.below(2), left - 1) if name in WITH_COMPANION else 0
        drawn.append((name, (width, depth, height), companions))
        left -= 1 + companions
    return sorted(drawn, key=lambda piece: -piece[1][0] * piece[1][1])


def _floor(stream: Stream, covered: float) -> Rect:
    """Draws a floor that `covered` m2 of furniture cover to 0.1-0.45, up to 1:1.7."""
    area = min(max(covered / stream.uniform(0.1, 0.45), LEAST_AREA, covered / 0.45), max(MOST_AREA, covered / 0.45))
    deep = max((area / stream.uniform(1.0, 1.7)) ** 0.5, SHORT_SIDE)
    width, depth = round(1000 * area / deep), round(1000 * deep)
    return Rect(50, 50, 50 + width, 50 + depth) if stream.chance(0.5) else Rect(50, 50, 50 + depth, 50 + width)


def _openings(room: Room) -> dict[str, int]:
    """Adds a door or two and a window; returns how much of each wall is left for furniture, mm."""
    left = {wall: (room.clear.width if wall in ("north", "south") else room.clear.depth) for wall in WALLS}
    stream, walls = room.stream, list(WALLS)
    stream.shuffle(walls)
    for k in range(1 + stream.below(2)):
        low, high = room.clear.along(walls[k])
        at = low + 50 + stream.below(high - low - 1000 + 1)
        room.zones.append((strip(room.clear, walls[k], (at, at + 900), 850), 0))
        left[walls[k]] -= 900
    low, high = room.clear.along(walls[2])
    wide = 800 + stream.below(min(1000, high - low - 900))
    at = low + stream.below(high - low - wide + 1)
    room.zones.append((strip(room.clear, walls[2], (at, at + wide), 450), 900))
    return left


def _wall_for(room: Room, left: dict[str, int], size: Size) -> str | None:
    """Draws a wall on whose remaining length the piece fits, and takes that length."""
    fitting = [wall for wall in WALLS if left[wall] >= size[0]]
    if not fitting:
        return None
    wall = room.stream.pick(fitting)
    left[wall] -= size[0]
    return wall


def _companions(room: Room, name: str, parent: ProblemBox, count: int) -> None:
    size: Size
    for k in range(count):
        label = f"{parent.label}_{k}"
        side = ("left", "right")[k]
        if name == "desk":
            size, place = (450, 500, 900), (("front", -300, 0), ("right", 20, 0))[k]
            room.tucked.add((parent.label, label))
        elif name == "bed":
            size, place = (400 + room.stream.below(80), 380, 550), (side, 20, 200)
        elif name == "sofa":
            size, place = ((1000, 550, 420), (460, 460, 550))[k], (("front", 400, 300), ("left", 40, 0))[k]
        else:
            size, place = (460, 500, 900), (side, -150, 150)
            room.tucked.add((parent.label, label))
        room.companion(label, parent, size, place)


def room_problem(seed: int, count: int | None = None) -> Problem:
    """Returns the room of a seed.

    Args:
        seed: any integer.
        count: pieces, companions among them; by the seed, 3-14, when None.
    """
    stream = Stream(seed, "bench")
    drawn = _sizes(stream, count or 3 + seed % 12)
    covered = sum(size[0] * size[1] for _, size, _ in drawn) / 1e6 + 0.25 * sum(companions for *_, companions in drawn)
    room = Room(_floor(stream, covered), stream)
    left = _openings(room)
    bodies: list[ProblemBox] = []
    for k, (name, size, companions) in enumerate(drawn):
        wall = _wall_for(room, left, size) if SORTS[name].wall else None
        bodies.append(room.body(f"{name}_{k}", size, wall))
        _companions(room, name, bodies[-1], companions)
        if SORTS[name].used and stream.chance(0.6):
            room.stand(bodies[-1])
    for a, b in combinations(bodies, 2):
        if stream.chance(0.1):
            axis = stream.below(2)
            offset = (a.extent[axis] - b.extent[axis]) / 2000
            room.problem.terms.append(Term(axis, a.var[axis], b.var[axis], offset, stream.pick((0.1, 0.5))))
    return room.close()


def house_problems(seed: int, possible: Callable[[Problem], bool]) -> list[Problem]:
    """Returns the 13 rooms of a house, 80 pieces: of each number of pieces the first possible room of its seeds."""
    counts = list(HOUSE)
    Stream(seed, "bench", "house").shuffle(counts)
    problems = []
    for k, count in enumerate(counts):
        tries = (room_problem(100_000 + 10_000 * seed + 100 * k + n, count) for n in range(100))
        problems.append(next(problem for problem in tries if possible(problem)))
    return problems
