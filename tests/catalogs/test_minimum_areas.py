"""Every room type holds its required pieces at the least area it is given: its data are wrong otherwise, and users would find out.

The rooms: the type's least area for one door and for two, every side ratio that its short side and aspect allow, lying and
standing, doors and a window in the middle of their walls. Of two doors that face each other one may stand towards an end of
its wall instead: the floor plan shifts doors where pieces would not fit. Judged by the validator and by a flood that shares
no code with the placement.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
import yaml

from catalogs import Catalogs, load_catalogs
from catalogs.schema import RoomType
from solver.furnish import space_of, wanted_pieces
from solver.furnished import furnished
from solver.placement import place
from solver.scene import EXTERIOR, Opening, Room, Scene
from solver.streams import Stream
from solver.validator import validate
from tests.oracles.rules import faults, unreached

OURS = load_catalogs()
WALL_M = 0.1
RATIO_STEP = 0.25
DOOR_M, CAR_DOOR_M, JAMB_M, WINDOW_EDGE_M = 0.9, 2.4, 0.2, 0.3
OPPOSITE = {"south": "north", "north": "south", "east": "west", "west": "east"}


@dataclass(frozen=True)
class Case:
    """An empty room and how to speak of it."""

    name: str
    area: float
    room: Room

    def __str__(self) -> str:
        room = self.room
        doors = " and ".join(o.wall or "" for o in room.openings if o.kind == "door")
        return f"{self.name} of {self.area:g} m2 ({room.width:g} x {room.depth:g} m, {doors} door)"


def ratios(kind: RoomType, area: float) -> Iterator[tuple[float, float]]:
    """Yields (short, long) sides, m, from the square to the longest room of an area that the type allows."""
    most = min(kind.aspect, area / kind.short_side**2)
    steps = math.ceil((most - 1) / RATIO_STEP)
    for k in range(steps + 1):
        ratio = min(1 + k * RATIO_STEP, most)
        short = max(math.floor(100 * math.sqrt(area / ratio)) / 100, kind.short_side)
        yield short, math.ceil(100 * area / short - 1e-6) / 100


def cars(kind: RoomType) -> int:
    """Returns how many cars' width the garage door has; 0 where there is none."""
    if not kind.plan.garage_door:
        return 0
    return max([line["car"] for line in kind.requires if "car" in line], default=1)


def centred(kind: str, wall: str, room: tuple[float, float], width: float, number: int) -> Opening:
    """Returns an opening in the middle of a wall."""
    length = room[0] if wall in ("south", "north") else room[1]
    window = kind == "window"
    height, sill = ((1.4, 0.9) if width > 1 else (0.6, 1.4)) if window else (2.1, 0.0)
    return Opening(
        f"{kind}_{number}", kind, wall, round(length / 2, 3), width, height, sill, EXTERIOR,
        hinge="start" if kind == "door" else None, swing="out" if kind == "door" else None, main_entrance=number == 1 and kind == "door",
    )  # fmt: skip


def openings(kind: RoomType, size: tuple[float, float], doors: tuple[str, ...]) -> tuple[Opening, ...] | None:
    """Returns doors in these walls, a garage door and a window in walls that are left; None where a door has no wall."""
    lengths = {wall: size[0] if wall in ("south", "north") else size[1] for wall in OPPOSITE}
    found, free = [], [wall for wall in ("north", "west", "east", "south") if wall not in doors]
    for number, wall in enumerate(doors, 1):
        if lengths[wall] < DOOR_M + JAMB_M:
            return None
        found.append(centred("door", wall, size, DOOR_M, number))
    wide = round(CAR_DOOR_M * cars(kind), 1)
    if wide:
        street = [wall for wall in free if lengths[wall] >= wide + 2 * JAMB_M]
        if not street:
            return None
        found.append(centred("garage_door", street[0], size, wide, 1))
        free.remove(street[0])
    pane = 0.6 if kind.plan.wet and not kind.plan.habitable else 1.2
    lit = [wall for wall in free if lengths[wall] >= pane + 2 * WINDOW_EDGE_M]
    if kind.plan.windows and not kind.outdoor and lit:
        found.append(centred("window", lit[0], size, pane, 1))
    return tuple(found)


def cases(name: str, kind: RoomType) -> list[Case]:
    """Returns the rooms of a type at its least areas."""
    found = []
    for doors in (("south",), ("south", "north"), ("south", "east")):
        area = kind.area.min[len(doors) - 1]
        for short, long in ratios(kind, area):
            for size in dict.fromkeys([(long, short), (short, long)]):
                cut = openings(kind, size, doors)
                if cut is not None:
                    room = Room(f"{name}_0", 0, name, width=size[0], depth=size[1], outdoor=kind.outdoor, openings=cut)
                    found.append(Case(name, area, room))
    return found


def complaints(case: Case, catalogs: Catalogs) -> list[str]:
    """Furnishes a room and lists what is wrong, each line with the type, its area and the piece."""
    space = space_of(case.room, WALL_M)
    wanted = [one for one in wanted_pieces(case.room, space, catalogs, Stream(0, "furnish", case.name)) if not one.is_floor]
    (arrangement,) = place([(space, wanted)])
    there = {piece.label for piece in arrangement.placed}
    reasons = dict(arrangement.left_out)
    found = [f"{piece.label} does not fit: {reasons[piece.label]}" for piece in wanted if piece.required and piece.label not in there]
    found += faults(space, wanted, arrangement)
    found += [f"{label} cannot be reached" for label in unreached(space, wanted, arrangement)]
    scene = Scene(wall_thickness=WALL_M, rooms=(furnished(case.room, arrangement, catalogs, Stream(0, "colour", case.name)),))
    found += [issue.message for issue in validate(scene, catalogs) if issue.severity == "error" or issue.rule == "missing_required"]
    return [f"{case}: {line}" for line in found]


@pytest.mark.parametrize("name", sorted(OURS.rooms))
def test_the_required_pieces_fit_the_least_area(name: str) -> None:
    kind = OURS.rooms[name]
    found = cases(name, kind)
    assert {sum(o.kind == "door" for o in case.room.openings) for case in found} == {1, 2}, (
        f"{name}: no room of its least area has its doors"
    )
    assert [line for case in found for line in lacking(case, OURS)] == []


def shifted(case: Case) -> list[Case]:
    """Returns the room with its second door towards either end of its wall, where its two doors face each other."""
    doors = [o for o in case.room.openings if o.kind == "door"]
    if len(doors) < 2 or OPPOSITE[doors[0].wall or ""] != doors[1].wall:
        return []
    end = (DOOR_M + JAMB_M) / 2 + WALL_M / 2
    ends = (end, round(case.room.width - end, 3))
    others = [tuple(replace(o, position=at) if o is doors[1] else o for o in case.room.openings) for at in ends]
    return [replace(case, room=replace(case.room, openings=cut)) for cut in others]


def lacking(case: Case, catalogs: Catalogs) -> list[str]:
    """Lists what is wrong with a room unless a shifted door puts all of it right."""
    found = complaints(case, catalogs)
    return [] if found and any(not complaints(other, catalogs) for other in shifted(case)) else found


def overlaid(folder: Path, name: str, **changes: object) -> Catalogs:
    """Returns our catalogs with entries of one room type replaced."""
    source = Path(__file__).parents[2] / "catalogs" / "rooms" / f"{name}.yaml"
    document = {**yaml.load(source.read_text(encoding="utf-8"), yaml.CSafeLoader), **changes}
    (folder / "rooms").mkdir(parents=True, exist_ok=True)
    (folder / "rooms" / f"{name}.yaml").write_text(yaml.safe_dump(document), encoding="utf-8")
    return load_catalogs(folder)


def all_complaints(name: str, catalogs: Catalogs) -> list[str]:
    return [line for case in cases(name, catalogs.rooms[name]) for line in lacking(case, catalogs)]


def test_a_least_area_that_is_too_small_is_found(tmp_path: Path) -> None:
    small = overlaid(tmp_path, "bedroom_master", area={"min": [4.0, 4.0], "typical": 15.0, "max": 24.0}, short_side=1.6)
    found = all_complaints("bedroom_master", small)
    assert any(line.startswith("bedroom_master of 4 m2") and "bed_1 does not fit" in line for line in found), found


def test_a_required_piece_that_is_too_large_is_found(tmp_path: Path) -> None:
    large = overlaid(
        tmp_path, "bathroom", pieces=[{"piece": "toilet", "required": True}, {"piece": "king_bed", "required": True}], requires=[]
    )
    found = all_complaints("bathroom", large)
    assert any(line.startswith("bathroom of 3.6 m2") and "king_bed_1 does not fit" in line for line in found), found


def test_a_required_piece_that_shuts_the_way_is_found(tmp_path: Path) -> None:
    """A pantry of 1.2 m is wide enough for two shelves, not for who wants to use them."""
    shelves = [{"piece": "bookshelf", "count": 8, "required": True}]
    shut = overlaid(
        tmp_path, "laundry", area={"min": [2.4, 2.4], "typical": 3.0, "max": 4.0}, short_side=1.2, aspect=2.0, pieces=shelves, requires=[]
    )
    assert any("bookshelf_" in line and line.startswith("laundry of 2.4 m2") for line in all_complaints("laundry", shut))


def test_the_rooms_are_of_the_area_and_form_the_type_allows() -> None:
    for name, kind in OURS.rooms.items():
        for case in cases(name, kind):
            sides = sorted((case.room.width, case.room.depth))
            assert case.area - 1e-9 <= sides[0] * sides[1] <= case.area + 0.01 * sides[0] + 1e-9, str(case)
            assert sides[0] >= kind.short_side, str(case)
            assert sides[1] / sides[0] <= kind.aspect + 0.03, str(case)
