"""The floor plan's targets as a table, measured by checks.py: `floorplan_table(seeds)`."""

from __future__ import annotations

from collections import Counter
from statistics import median
from time import process_time

from catalogs import Catalogs, load_catalogs
from solver.floorplan import FloorPlan, draw
from solver.request import Request
from tests.floorplan import checks

PLAIN_ROOMS = {(20, 15, 3.0): 18, (20, 15, 2.4): 24, (12, 9, 3.0): 6, (12, 9, 2.4): 8, (30, 20, 3.0): 30, (30, 20, 2.4): 48}
"""Median rooms, hallways not counted, of a partition that cuts along the longer axis between 0.4 and 0.6 on both sides of a
spine, max_depth 5. The values at 30 x 20 with 2.4 were measured, the others are the design's table."""
HEAD = "| request | rooms (>=) | violations | faults | aspect p95, max | hallway | dark habitable | bathrooms, bedrooms | ms |"


class Row:
    """Measurements over the plans of one request."""

    def __init__(self, catalogs: Catalogs) -> None:
        self.catalogs = catalogs
        self.rooms: list[int] = []
        self.aspects: list[float] = []
        self.hallways: list[float] = []
        self.faults, self.violating, self.dark, self.crowded = 0, 0, 0, 0
        self.types: Counter[str] = Counter()
        self.notes: Counter[str] = Counter()

    def add(self, plan: FloorPlan, request: Request) -> None:
        indoor = [room for room in plan.rooms if room.type != "hallway"]
        self.rooms.append(len(indoor))
        self.aspects += [checks.aspect(room) for room in indoor]
        floor = sum(room.width * room.depth for room in plan.rooms if room.type == "hallway")
        width, depth = request.extents
        self.hallways.append(floor / (width * depth))
        self.faults += len(checks.sound(plan.rooms, width, depth)) + len(checks.gardens(plan.rooms))
        self.violating += bool(checks.violations(plan.rooms) if plan.spine else checks.walked_through(plan.rooms))
        self.crowded += checks.crowded(plan.rooms)
        for room in indoor:
            outside = room.exterior_walls
            lit = outside is not None and (outside.north or outside.south or outside.east or outside.west)
            self.dark += self.catalogs.rooms[room.type].plan.habitable and not lit
        self.types.update(room.type for room in plan.rooms)
        self.notes.update(plan.notes)

    def line(self, name: str, wanted: float | None, ms: float) -> str:
        aspects, count = sorted(self.aspects), len(self.rooms)
        beds = sum(self.types[name] for name in checks.SLEEPING) / count
        cells = [
            name,
            f"{median(self.rooms):g}" + (f" (>= {wanted:g})" if wanted else ""),
            f"{self.violating} of {count}",
            str(self.faults),
            f"{aspects[int(0.95 * (len(aspects) - 1))]:.2f}, {aspects[-1]:.2f}",
            f"{100 * median(self.hallways):.1f} %",
            f"{100 * self.dark / sum(self.rooms):.1f} %",
            f"{self.types['bathroom'] / count:.1f}, {beds:.1f}",
            f"{ms:.2f}",
        ]
        return "| " + " | ".join(cells) + " |"


def measure(name: str, seeds: int, catalogs: Catalogs, **fields: float) -> tuple[Row, str]:
    """Draws a request with seeds from 0 on; the time is processor time a plan."""
    row, plans = Row(catalogs), []
    requests = [Request(seed=seed, **fields) for seed in range(seeds)]  # type: ignore[arg-type]
    start = process_time()
    for request in requests:
        plans.append(draw(request, catalogs))
    ms = 1000 * (process_time() - start) / seeds
    for request, plan in zip(requests, plans, strict=True):
        row.add(plan, request)
    size = (int(fields.get("width", 20)), int(fields.get("depth", 15)), fields.get("min_room_size", 3.0))
    wanted = 0.75 * PLAIN_ROOMS[size] if size in PLAIN_ROOMS and fields.get("use_spine", True) else None
    return row, row.line(name, wanted, ms)


def floorplan_table(seeds: int) -> str:
    """Returns the table of all targets: `seeds` plans for each size, a fifth of them for each option."""
    catalogs = load_catalogs()
    lines = [HEAD, "|" + "---|" * (HEAD.count("|") - 1)]
    for width, depth, least in PLAIN_ROOMS:
        name = f"{width} x {depth}, min {least}"
        lines.append(measure(name, seeds, catalogs, width=width, depth=depth, min_room_size=least)[1])
    few = max(1, seeds // 5)
    lines.append(measure("spine off", few, catalogs, use_spine=False)[1])
    lines.append(measure("outdoor on", few, catalogs, outdoor=True)[1])
    return "\n".join(lines)


if __name__ == "__main__":
    import sys

    print(floorplan_table(int(sys.argv[1]) if len(sys.argv) > 1 else 1000))
