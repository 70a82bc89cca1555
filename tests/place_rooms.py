# ruff: noqa: E501 - a table is read by its columns
"""Seeded rooms of five types with lists of pieces and relations, as a user of /place might send them.

`python -m tests.place_rooms --rooms 50 --seed 1000` places them and tells how much of what can be held is held.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from random import Random
from statistics import mean, median
from time import process_time
from typing import Any, Final

from catalogs import Catalogs, load_catalogs
from service.contract import PlaceBody
from solver import place
from solver.exchange import read
from solver.requested import Placement
from tests.place_oracle import Oracle

TYPES: Final = ("bedroom", "living_room", "kitchen", "office", "bathroom")
SIDES: Final = {"bedroom": (3.4, 4.8), "living_room": (4.0, 6.2), "kitchen": (3.4, 5.2), "office": (3.0, 4.6), "bathroom": (2.4, 3.6)}
"""Shortest and longest side of a room, m."""
WINDOW: Final = {"bathroom": (0.8, 1.3)}
"""Width and sill of the window, m; else 1.4 and 0.9."""

Relation = dict[str, Any]


def _rel(type: str, of: str | None = None, **more: Any) -> Relation:
    return {"type": type, **({} if of is None else {"of": of}), **more}


@dataclass(frozen=True)
class Sort:
    """A piece that may be asked for: its id, the sizes it is drawn from (None: its kind's own) and relations to draw from."""

    id: str
    name: str
    sizes: tuple[tuple[float, float], ...] | None
    relations: tuple[Relation, ...]


WALL, CORNER, CENTRED = _rel("against_wall"), _rel("in_corner"), _rel("centred")
FROM_DOOR, BY_DOOR, WINDOWED = _rel("far_from_door", distance=1.2), _rel("near_door", distance=1.5), _rel("at_window")

SORTS: Final[dict[str, tuple[Sort, ...]]] = {
    "bedroom": (
        Sort("bed", "bed", ((1.6, 2.0), (1.4, 2.0)), (WALL, CENTRED, FROM_DOOR, _rel("far_from", "window", distance=0.5))),
        Sort("left_stand", "nightstand", None, (_rel("beside", "bed"), WALL, _rel("near", "bed", distance=0.5), FROM_DOOR)),
        Sort("right_stand", "nightstand", None, (_rel("beside", "bed"), WALL, _rel("aligned_with", "left_stand"))),
        Sort("wardrobe", "wardrobe", ((1.5, 0.6), (1.2, 0.6)), (WALL, CORNER, BY_DOOR, _rel("far_from", "window", distance=0.3))),
        Sort("desk", "desk", ((1.1, 0.55), (1.2, 0.6)), (WALL, WINDOWED, _rel("far_from", "bed", distance=0.6), _rel("near", "window"))),
        Sort("chair", "office_chair", ((0.55, 0.55),), (_rel("under", "desk"), _rel("facing", "desk"), _rel("near", "desk", distance=0.5))),
        Sort("dresser", "dresser", ((1.0, 0.45),), (WALL, _rel("opposite", "bed"), _rel("facing", "bed"), _rel("far_from", "window"))),
        Sort("armchair", "armchair", ((0.75, 0.75),), (_rel("facing", "bed"), CORNER, _rel("near", "window"), FROM_DOOR)),
        Sort("lamp", "floor_lamp", None, (_rel("beside", "armchair"), CORNER, _rel("near", "armchair", distance=0.6))),
        Sort("plant", "plant", None, (CORNER, _rel("near", "window", distance=1.5), FROM_DOOR)),
    ),
    "living_room": (
        Sort("sofa", "sofa", ((2.2, 0.9), (1.8, 0.88)), (WALL, CENTRED, FROM_DOOR, _rel("facing", "tv"))),
        Sort("tv", "tv_stand", ((1.5, 0.4), (1.2, 0.4)), (WALL, _rel("opposite", "sofa"), _rel("facing", "sofa"), _rel("far_from", "window"))),
        Sort("table", "coffee_table", None, (_rel("in_front_of", "sofa"), _rel("near", "sofa", distance=0.8), _rel("aligned_with", "sofa"))),
        Sort("chair_a", "armchair", None, (_rel("facing", "table"), _rel("near", "table", distance=1.0), _rel("around", "table", gap=[0.2, 0.7]))),
        Sort("chair_b", "armchair", None, (_rel("facing", "table"), _rel("near", "table", distance=1.2), _rel("far_from", "tv", distance=0.5))),
        Sort("shelf", "bookshelf", ((0.9, 0.3), (0.8, 0.3)), (WALL, CORNER, _rel("far_from", "sofa", distance=0.8), _rel("far_from", "window", distance=0.6))),
        Sort("shelf_b", "bookshelf", ((0.8, 0.3),), (WALL, _rel("in_row", "shelf"), _rel("near", "shelf", distance=0.5))),
        Sort("side", "side_table", None, (_rel("beside", "sofa"), _rel("near", "sofa", distance=0.5), FROM_DOOR)),
        Sort("lamp", "floor_lamp", None, (CORNER, _rel("near", "sofa", distance=1.5), FROM_DOOR)),
        Sort("plant", "plant", None, (CORNER, _rel("near", "window", distance=1.5), _rel("far_from", "tv", distance=0.6))),
        Sort("board", "sideboard", ((1.4, 0.45),), (WALL, BY_DOOR, _rel("far_from", "sofa", distance=0.6))),
        Sort("desk", "desk", ((1.1, 0.6),), (WALL, WINDOWED, _rel("far_from", "tv", distance=0.8))),
    ),
    "kitchen": (
        Sort("fridge", "refrigerator", None, (WALL, CORNER, _rel("far_from", "window", distance=0.3))),
        Sort("stove", "stove", None, (WALL, _rel("far_from", "fridge", distance=0.6), _rel("far_from_door", distance=0.8))),
        Sort("sink", "sink", None, (WALL, _rel("near", "stove", distance=1.5), _rel("near", "fridge", distance=2.0))),
        Sort("counter", "counter", ((1.2, 0.6), (0.6, 0.6)), (WALL, _rel("beside", "sink"), _rel("near", "stove", distance=1.0))),
        Sort("table", "dining_table", ((1.2, 0.8), (0.8, 0.8)), (_rel("far_from", "stove", distance=0.8), FROM_DOOR, _rel("near", "window", distance=2.0))),
        Sort("chair_a", "dining_chair", None, (_rel("around", "table", gap=[-0.2, 0.2]), _rel("facing", "table"), _rel("near", "table", distance=0.3))),
        Sort("chair_b", "dining_chair", None, (_rel("around", "table", gap=[-0.2, 0.2]), _rel("facing", "table"), _rel("near", "table", distance=0.3))),
        Sort("chair_c", "dining_chair", None, (_rel("around", "table", gap=[-0.2, 0.2]), _rel("facing", "table"), _rel("far_from", "stove", distance=0.4))),
        Sort("cupboard", "cupboard", ((0.9, 0.4),), (WALL, CORNER, BY_DOOR, _rel("far_from", "stove", distance=0.5))),
        Sort("bin", "bin", ((0.3, 0.3),), (_rel("beside", "counter"), WALL, _rel("near", "sink", distance=1.5))),
        Sort("plant", "plant", None, (CORNER, _rel("near", "window", distance=1.2), FROM_DOOR)),
    ),
    "office": (
        Sort("desk", "desk", ((1.4, 0.7), (1.2, 0.6)), (WALL, WINDOWED, FROM_DOOR, _rel("near", "window"))),
        Sort("chair", "office_chair", None, (_rel("under", "desk"), _rel("facing", "desk"), _rel("near", "desk", distance=0.4))),
        Sort("shelf", "bookshelf", ((0.9, 0.3), (0.8, 0.3)), (WALL, _rel("near", "desk", distance=2.0), _rel("far_from", "window", distance=0.4))),
        Sort("shelf_b", "bookshelf", ((0.8, 0.3),), (WALL, _rel("in_row", "shelf"), _rel("aligned_with", "shelf"))),
        Sort("cabinet", "cabinet", ((0.5, 0.5),), (_rel("beside", "desk"), WALL, CORNER)),
        Sort("visitor", "armchair", ((0.7, 0.7),), (_rel("facing", "desk"), _rel("near", "desk", distance=1.5), FROM_DOOR)),
        Sort("lamp", "floor_lamp", None, (CORNER, _rel("near", "desk", distance=1.5), _rel("beside", "visitor"))),
        Sort("printer", "printer", ((0.5, 0.45),), (WALL, BY_DOOR, _rel("far_from", "desk", distance=0.5))),
        Sort("plant", "plant", None, (CORNER, _rel("near", "window", distance=1.5), FROM_DOOR)),
    ),
    "bathroom": (
        Sort("toilet", "toilet", None, (WALL, FROM_DOOR, _rel("near", "sink", distance=1.0))),
        Sort("sink", "sink", ((0.6, 0.45),), (WALL, CENTRED, _rel("near_door", distance=2.0))),
        Sort("shower", "shower", ((0.9, 0.9), (0.8, 0.8)), (WALL, CORNER, _rel("far_from", "window", distance=0.3))),
        Sort("cabinet", "cabinet", ((0.4, 0.3),), (_rel("beside", "sink"), WALL, _rel("near", "sink", distance=0.5))),
        Sort("basket", "basket", ((0.35, 0.35),), (CORNER, _rel("near", "shower", distance=1.0), _rel("far_from", "toilet", distance=0.3))),
        Sort("stool", "stool", ((0.35, 0.35),), (_rel("near", "shower", distance=0.8), _rel("facing", "sink"), FROM_DOOR)),
        Sort("plant", "plant", ((0.3, 0.3),), (CORNER, _rel("near", "window", distance=1.0), _rel("far_from", "shower", distance=0.4))),
    ),
}  # fmt: skip
HEIGHT: Final = {"bin": 0.4, "basket": 0.5, "cupboard": 1.9, "cabinet": 0.8, "printer": 0.7, "stool": 0.45, "plant": 1.0, "shower": 2.0}


def place_request(seed: int) -> dict[str, Any]:
    """Returns the body of /place for a seed: the types take turns."""
    random = Random(seed)
    kind = TYPES[seed % len(TYPES)]
    width, depth = (round(random.uniform(*SIDES[kind]), 2) for _ in range(2))
    openings = _openings(random, kind, width, depth)
    room = {"id": f"{kind}_{seed}", "type": kind, "width": width, "depth": depth, "openings": openings}
    return {"room": room, "pieces": _pieces(random, kind, width * depth), "wall_thickness": 0.1}


def _openings(random: Random, kind: str, width: float, depth: float) -> list[dict[str, Any]]:
    """Two doors and a window, each in a wall of its own."""
    first, second, third = random.sample(["north", "south", "east", "west"], 3)
    wide, sill = WINDOW.get(kind, (1.4, 0.9))
    found = []
    for name, wall, opening in (("door_1", first, 0.9), ("door_2", second, 0.8), ("window_1", third, wide)):
        length = width if wall in ("north", "south") else depth
        edge = 0.15 + opening / 2
        ends = [edge, length - edge] if name != "window_1" else [length / 2]
        position = random.choice([*ends, random.uniform(edge, length - edge)])
        more = {"sill": sill} if name == "window_1" else {"connects_to": "EXTERIOR" if name == "door_1" else "hall"}
        found.append({"id": name, "kind": name[:-2], "wall": wall, "position": round(position, 2), "width": opening, **more})
    return found


def _pieces(random: Random, kind: str, area: float) -> list[dict[str, Any]]:
    """Draws 5 to 12 pieces, the important ones always, while a third of the floor is not covered; 2 to 4 relations each."""
    sorts = SORTS[kind]
    wished = random.randint(5, min(12, len(sorts)))
    chosen = [*sorts[:3], *random.sample(sorts[3:], wished - 3)]
    chosen.sort(key=sorts.index)
    sized = [(sort, random.choice(sort.sizes) if sort.sizes else None) for sort in chosen]
    while len(sized) > 5 and sum(w * d for _, size in sized if size for w, d in [size]) > 0.3 * area:
        sized.pop()
    names = {sort.id for sort, _ in sized}
    pieces = [_piece(random, sort, size, names) for sort, size in sized]
    random.shuffle(pieces)
    return pieces


def _piece(random: Random, sort: Sort, size: tuple[float, float] | None, names: set[str]) -> dict[str, Any]:
    pool = [relation for relation in sort.relations if relation.get("of", "window") in names | {"window", "door"}]
    number = min(random.randint(2, 4), len(pool))
    relations = [pool[k] for k in sorted(random.sample(range(len(pool)), number))]
    sizes: dict[str, float] = {} if size is None else {"width": size[0], "depth": size[1]}
    if sort.id in HEIGHT and size is not None:
        sizes["height"] = HEIGHT[sort.id]
    return {"id": sort.id, "name": sort.name, **sizes, "relations": relations}


def circles(request: dict[str, Any]) -> bool:
    """Tells whether two pieces that follow each other in the list refer to each other."""
    of = {piece["id"]: {relation.get("of") for relation in piece["relations"]} for piece in request["pieces"]}
    return any(a in of[b] and b in of[a] for a, b in pairwise(of))


@dataclass(frozen=True)
class Tally:
    """What became of one room: relations asked for, held, and held by the oracle; pieces left out, errors, CPU ms."""

    asked: int
    held: int
    possible: int
    closed: bool
    left_out: int
    errors: int
    cpu_ms: float


def timed(seed: int, catalogs: Catalogs) -> tuple[Placement, float]:
    """Places a seed's room; returns the best placement and the CPU time it took, ms."""
    body = read(PlaceBody, place_request(seed))
    start = process_time()
    best = place(body.room, body.pieces, wall_thickness=body.wall_thickness, catalogs=catalogs).best
    return best, 1000 * (process_time() - start)


def tally(seed: int, best: Placement, cpu_ms: float, catalogs: Catalogs, seconds: float = 120.0) -> Tally:
    """Counts what a placement holds; where it misses a relation, asks the oracle for a placement that holds more."""
    request = place_request(seed)
    own, word, more = sum(entry.held for entry in best.relations), "solved", list[bool]()
    if own < len(best.relations):
        kinds = {name: (entry.size, entry.stands) for name, entry in catalogs.furniture.items()}
        use = {name: (entry.use.sides, entry.use.need == "all") for name, entry in catalogs.furniture.items() if entry.use}
        word, more, _ = Oracle(request, kinds, use).most(own, seconds)
    errors = sum(issue.severity == "error" or issue.rule == "unreachable" for issue in best.issues)
    return Tally(len(best.relations), own, max(own, sum(more)), word != "limit", len(best.unplaced), errors, cpu_ms)


HEAD: Final = (
    "| seeds | rooms | relations asked for | satisfiable | held | pieces left out | errors, unreachable | CPU ms a room, mean, median |"
)


def report(seeds: range, tallies: Sequence[Tally]) -> str:
    """Returns the row of many rooms."""
    held, possible = sum(one.held for one in tallies), sum(one.possible for one in tallies)
    times = [one.cpu_ms for one in tallies]
    cells = (
        f"{seeds[0]}-{seeds[-1]}",
        f"{len(tallies)}, {sum(one.closed for one in tallies)} closed by the oracle",
        f"{sum(one.asked for one in tallies):,}",
        f"{possible:,}",
        f"{100 * held / possible:.1f} %",
        str(sum(one.left_out for one in tallies)),
        str(sum(one.errors for one in tallies)),
        f"{mean(times):.1f}, {median(times):.1f}",
    )
    return f"| {' | '.join(cells)} |"


def main() -> None:
    """Places many rooms and prints the figures, a row for each first seed."""
    parser = argparse.ArgumentParser(description=main.__doc__)
    parser.add_argument("--rooms", type=int, default=50)
    parser.add_argument("--seed", type=int, nargs="+", default=[1000])
    chosen = parser.parse_args()
    catalogs = load_catalogs()
    timed(0, catalogs)
    print(HEAD, "|---" * (HEAD.count("|") - 1) + "|", sep="\n")
    for first in chosen.seed:
        seeds = range(first, first + chosen.rooms)
        placed = [timed(seed, catalogs) for seed in seeds]
        print(report(seeds, [tally(seed, *one, catalogs) for seed, one in zip(seeds, placed, strict=True)]), flush=True)


if __name__ == "__main__":
    main()
