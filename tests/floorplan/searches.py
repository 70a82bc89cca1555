"""Searches for homes, as their requests come to them: programmes that nobody chose, standards of access, limits loosened, every outline."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from random import Random

from catalogs import load_catalogs
from solver import Request
from solver.fields import RECTANGLE
from solver.floorplan.given import tilings_of
from solver.floorplan.programme.home_search import GIVEN, Frame, HomeSeed, outlines_for
from solver.floorplan.programme.planned_rooms import PlannedRoom, counts_of, loosened, planned_rooms, types_of
from solver.floorplan.tiling import HouseWalls
from solver.geometry import Rect
from solver.streams import Stream
from tests.floorplan.homes import random_programme

KNOWN = load_catalogs()
L = ((0, 0), (14, 0), (14, 6.2), (8.05, 6.2), (8.05, 12), (0, 12))
U = ((0, 0), (16, 0), (16, 11), (10.5, 11), (10.5, 5), (5.5, 5), (5.5, 11.3), (0, 11.3))
Z = ((0, 0), (9, 0), (9, 4), (14, 4), (14, 11), (5, 11), (5, 7), (0, 7))


@dataclass(frozen=True)
class HomeQuestion:
    """What is searched for: rooms in a frame, an outline, or an outline that is given."""

    planned: tuple[PlannedRoom, ...]
    outline: str
    frame: Frame
    walls: HouseWalls
    tilings: Sequence[Sequence[Rect]]
    seed: HomeSeed


def home_question(number: int) -> HomeQuestion:
    """Returns a search, of as many sorts as there are."""
    rng = Random(f"a home {number}")
    walls = HouseWalls(rng.choice((100, 100, 50, 115, 240)))
    catalogs = KNOWN.for_access(rng.choice(("none", *sorted(KNOWN.access)))).widened(walls.more)
    program = rng.choice(("studio", "one_bed", "family", "large", random_programme(number), random_programme(number)))
    types = types_of(counts_of(Request(program=program), catalogs), catalogs)
    floor = rng.choice((None, None, rng.uniform(8.0, 22.0) * len(types)))
    planned = planned_rooms(types, catalogs, floor)
    if rng.random() < 0.25:
        planned = loosened(planned, rng.choice((1.15, 1.5, 2.2, 4.0)), floor)
    outline = rng.choice((*outlines_for(planned), GIVEN))
    frame, tilings = Frame(), list[Sequence[Rect]]()
    if outline == RECTANGLE:
        frame = Frame(*(rng.choice((0, rng.randrange(4000, 20000))) for _ in range(2)))
    elif outline == GIVEN:
        scale = rng.uniform(0.5, 1.4)
        corners = [(round(x * scale, 2), round(z * scale, 2)) for x, z in rng.choice((L, U, Z))]
        tilings = [tiling for tiling in tilings_of(corners, Stream(number, "tilings")) if len(tiling) <= len(planned)]
        if not tilings:
            outline = RECTANGLE
    seed = HomeSeed(number, 0 if outline == GIVEN else rng.randrange(3))
    return HomeQuestion(planned, outline, frame, walls, tilings, seed)
