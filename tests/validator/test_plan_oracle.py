"""The rule `opening_wrong` on random plans, against what is counted millimetre by millimetre."""

from __future__ import annotations

from random import Random
from typing import NamedTuple

from solver.scene import EXTERIOR, Opening
from tests.every import every
from tests.validator.worlds import issues, opening, room, scene

SIDES = {"north": ("z", -1, "south"), "south": ("z", 1, "north"), "west": ("x", -1, "east"), "east": ("x", 1, "west")}
"""Of each wall along which axis its room ends there, which way is out, and the wall that another room has behind it."""


class Floor(NamedTuple):
    """A rectangular room in whole millimetres of the house."""

    x: int
    z: int
    width: int
    depth: int

    def wall(self, side: str) -> tuple[int, range]:
        """Where a wall lies, and the millimetres along it."""
        across, out, _ = SIDES[side]
        low, high = (self.z, self.z + self.depth) if across == "z" else (self.x, self.x + self.width)
        return high if out > 0 else low, range(self.x, self.x + self.width) if across == "z" else range(self.z, self.z + self.depth)


class Hole(NamedTuple):
    """An opening: whose it is, in which wall, the millimetres of the house that it takes along it, and where it says that it leads."""

    id: str
    room: str
    side: str
    cells: range
    to: str


def behind(floor: Floor, side: str, cells: set[int], other: Floor) -> int:
    """Over how many millimetres of a hole another room's wall is its other side."""
    line, (there, along) = floor.wall(side)[0], other.wall(SIDES[side][2])
    return len(cells & set(along)) if 0 <= (there - line) * SIDES[side][1] <= 600 else 0


def counted(floors: dict[str, Floor], holes: list[Hole]) -> dict[str, dict[int, set[str]]]:
    """How each hole is wrong: of amounts that may be told, mm, what the message then says."""
    found: dict[str, dict[int, set[str]]] = {}
    for number, hole in enumerate(holes):
        floor, cells = floors[hole.room], set(hole.cells)
        others = {other: behind(floor, hole.side, cells, floors[other]) for other in floors if other != hole.room}
        outside = len(cells - set(floor.wall(hole.side)[1]))
        met = next((one for one in holes[:number] if one[1:3] == hole[1:3] and cells & set(one.cells)), None)
        said = found[hole.id] = dict[int, set[str]]()
        if outside:
            said[outside] = {"beyond its wall"}
        elif hole.to == EXTERIOR and any(others.values()):
            for other, amount in others.items():
                said.setdefault(amount, set()).add(f"but {other} lies behind")
        elif hole.to in others and others[hole.to] < len(cells):
            said[len(cells) - others[hole.to]] = {f"leads to {hole.to}, whose wall is missing"}
        elif met:
            said[len(cells & set(met.cells))] = {f"and the door {met.id} share"}
    return {name: said for name, said in found.items() if said}


@every("seed", range(60))
def test_openings_of_any_plan_are_wrong_by_the_millimetres_that_are(seed: int) -> None:
    chance = Random(seed)
    floors = {f"r{k}": Floor(k % 3 * 3000 + chance.choice((0, 0, 0, 40, 450, 700, -30)), k // 3 * 2500, 3000, 2500) for k in range(6)}
    holes, listed = list[Hole](), {name: list[Opening]() for name in floors}
    for number in range(24):
        of, side, to = chance.choice([*floors]), chance.choice([*SIDES]), chance.choice([EXTERIOR, *floors])
        middle, half = chance.randrange(300, 2800), chance.choice((200, 450, 600))
        start = floors[of].wall(side)[1].start + middle
        if to != of:
            holes.append(Hole(f"d{number}", of, side, range(start - half, start + half), to))
            listed[of].append(opening(side, middle / 1000, id=f"d{number}", width=half / 500, connects_to=to))
    rooms = [room(id=name, x=at.x / 1000, z=at.z / 1000, width=3.0, depth=2.5, openings=tuple(listed[name])) for name, at in floors.items()]
    told = {issue.message.split()[2]: issue for issue in issues(scene(*rooms, wall_thickness=0.1), "opening_wrong")}
    wanted = counted(floors, holes)
    assert set(told) == set(wanted)
    for name, issue in told.items():
        assert any(words in issue.message for words in wanted[name][round(issue.amount * 1000)]), issue
