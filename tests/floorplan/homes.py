"""An independent judge of planned homes: reads a plan's rooms as a stranger would, with limits of its own; its table.

Shares no code with the stage: the limits are the design's, the walk goes over the openings.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from statistics import median
from time import process_time

from catalogs import Catalogs, load_catalogs
from solver.floorplan import FloorPlan, draw
from solver.request import Request
from solver.scene import Room
from solver.streams import Stream
from tests.floorplan import checks, silhouettes

LIMITS: Mapping[str, tuple[float, float, float, float]] = {
    "bedroom": (9, 16, 2.75, 2.0), "kids_bedroom": (9, 16, 2.75, 2.0), "bedroom_master": (12, 20, 3.1, 2.0),
    "bathroom": (4, 8, 1.7, 2.0), "kitchen": (8, 16, 2.5, 2.0), "living_room": (16, 35, 3.5, 2.0), "dining_room": (9, 16, 2.8, 2.0),
    "office": (7, 12, 2.5, 2.0), "laundry": (3.5, 8, 1.7, 2.0), "foyer": (3, 8, 1.6, 2.3), "garage": (15, 20, 3.0, 2.0),
    "garage_2car": (30, 40, 5.5, 2.2), "garage_3car": (45, 60, 5.5, 2.2), "workshop": (9, 18, 2.7, 2.0),
}  # fmt: skip
"""Least and greatest area, m2, least width, m, and greatest aspect of every type (design)."""
WET = ("bathroom", "kitchen", "laundry")
WAYS = ("hallway", "foyer", "living_room", "dining_room", "kitchen")
OUTDOOR = ("backyard", "patio")
DOOR_MM = 1100


def short(room: Room) -> bool:
    """Whether a room misses a limit of its type."""
    if room.type not in LIMITS:
        return False
    least, most, width, aspect = LIMITS[room.type]
    low, high = sorted((room.width, room.depth))
    area = room.width * room.depth
    return not (least - 1e-9 <= area <= most + 1e-9 and low >= width - 1e-9 and high <= aspect * low + 1e-9)


def violations(rooms: Sequence[Room]) -> list[str]:
    """Every room is entered from a way through; but own bathrooms from a bedroom alone, and garages from a laundry too."""
    types = {room.id: room.type for room in rooms}
    faults = []
    for room in rooms:
        into = [types[str(o.connects_to)] for o in room.openings if o.kind in ("door", "passage") and o.connects_to in types]
        owned = room.type == "bathroom" and len(into) == 1 and into[0] in checks.SLEEPING
        mudroom = room.type.startswith("garage") and "laundry" in into
        first = any(o.main_entrance for o in room.openings)
        if not first and not set(into) & set(WAYS) and not owned and not mudroom:
            faults.append(f"{room.id} is off every way through")
        for other in into:
            if room.type in checks.SLEEPING and other not in (*WAYS, "bathroom"):
                faults.append(f"{room.id} is joined to a {other}")
    return faults + _walked_through(rooms)


def _walked_through(rooms: Sequence[Room]) -> list[str]:
    """Rooms that are no way through and yet the way to others."""
    faults = []
    for room in rooms:
        if room.type in WAYS:
            continue
        lost = [other for other in rooms if other.id not in checks.reached(rooms, room.id) and other.id != room.id]
        own = room.type in checks.SLEEPING and [other.type for other in lost] == ["bathroom"]
        mud = room.type == "laundry" and all(other.type.startswith("garage") for other in lost)
        faults += [f"{room.id} is the way to {', '.join(other.id for other in lost)}"] if lost and not own and not mud else []
    return faults


def sound(plan: FloorPlan) -> list[str]:
    """Everything that must hold of any planned home."""
    outline = plan.drawing.layout.outline
    return checks.sound(plan.rooms, outline.x1 / 1000, outline.z1 / 1000, bent=True) + checks.gardens(plan.rooms)


def outline_of(plan: FloorPlan) -> str:
    """What a person calls the outline of the house, its garden left out."""
    return silhouettes.name([checks.box(room) for room in plan.rooms if not room.outdoor])


@dataclass
class Homes:
    """What the homes of one programme show."""

    homes: int = 0
    rooms: int = 0
    short_rooms: int = 0
    short_homes: int = 0
    faults: list[str] = field(default_factory=list)
    wet: list[bool] = field(default_factory=list)
    bedrooms_off: list[bool] = field(default_factory=list)
    hallway: list[float] = field(default_factory=list)
    dark: int = 0
    graphs: Counter[tuple[tuple[str, str], ...]] = field(default_factory=Counter)
    outlines: Counter[str] = field(default_factory=Counter)
    least_line: int = 1_000_000
    """The shortest line of any outline, mm."""
    unlit: int = 0
    """Habitable rooms without a window."""
    ms: list[float] = field(default_factory=list)

    def add(self, plan: FloorPlan, seed: int) -> None:
        """Counts one home."""
        indoor = [room for room in plan.rooms if room.type not in OUTDOOR]
        rooms = [room for room in indoor if room.type != "hallway"]
        bad = sum(short(room) for room in rooms)
        self.outlines[outline_of(plan)] += 1
        self.least_line = min(self.least_line, silhouettes.least_jog([checks.box(room) for room in indoor]))
        dry = ("bathroom", "laundry", "foyer")
        self.unlit += sum(
            not any(o.kind == "window" for o in room.openings)
            for room in rooms
            if room.type not in dry and not room.type.startswith("garage")
        )
        self.homes, self.rooms = self.homes + 1, self.rooms + len(rooms)
        self.short_rooms, self.short_homes = self.short_rooms + bad, self.short_homes + (bad > 0)
        self.faults += [f"seed {seed}: {fault}" for fault in (*sound(plan), *violations(plan.rooms))]
        types = {room.id: room.type for room in plan.rooms}
        beside = checks.shared_walls(plan.rooms, DOOR_MM)
        joined = checks.joined(plan.rooms)
        pipes = {name for pair in beside if all(types[one] in WET for one in pair) for name in pair}
        self.wet += [room.id in pipes for room in rooms if room.type in WET]
        front = checks.entrances(plan.rooms)[0][0].id
        doors = {name for pair in joined if front in pair for name in pair}
        if {"foyer", "hallway"} & set(types.values()):  # else the living room is the way to all, as it is the entrance
            self.bedrooms_off += [room.id not in doors for room in rooms if room.type in checks.SLEEPING]
        floor = sum(room.width * room.depth for room in indoor)
        self.hallway.append(sum(room.width * room.depth for room in indoor if room.type == "hallway") / floor)
        for room in rooms:
            sides = room.exterior_walls
            lit = sides is not None and (sides.north or sides.south or sides.east or sides.west)
            self.dark += not lit and room.type not in ("bathroom", "laundry", "foyer") and not room.type.startswith("garage")
        self.graphs[tuple(sorted((min(types[a], types[b]), max(types[a], types[b])) for a, b in beside))] += 1

    def line(self, name: str) -> str:
        """Writes a row of the table."""
        share = sum(self.wet) / max(len(self.wet), 1)
        off = sum(self.bedrooms_off) / len(self.bedrooms_off) if self.bedrooms_off else 1.0
        times = sorted(self.ms)
        return (
            f"| {name} | {100 * self.short_rooms / self.rooms:.2f} / {100 * self.short_homes / self.homes:.1f} % | {100 * share:.1f} % "
            f"| {100 * off:.1f} % | {100 * median(self.hallway):.1f} % | {self.dark} | {len(self.faults)} | {len(self.graphs)} "
            f"| {median(times):.1f}, {times[int(0.95 * (len(times) - 1))]:.1f} |"
        )


HEAD = (
    "| programme | short rooms / homes | wet beside wet | bedrooms off the entrance room | hallway | dark habitable | faults "
    "| adjacency graphs | CPU ms median, p95 |"
)
PRESETS: Mapping[str, object] = {
    "studio (4 rooms)": "studio",
    "one_bed (5)": "one_bed",
    "family (10)": "family",
    "family + office + garage for 2 (12)": {"bedrooms": 3, "bathrooms": 2, "dining_room": 1, "laundry": 1, "office": 1, "garage": 2},
    "large (15)": "large",
}
OUTLINES = ("L", "T", "U")
BENT = 500
"""Homes of each outline."""
RANDOM = 450
"""Programmes that nobody chose."""
GRAPHS = {"family (10)": 150, "large (15)": 400}
"""Distinct adjacency graphs that 1,000 seeds must show at least."""


def missed(homes: Homes, name: str) -> list[str]:
    """Names the targets that homes of a programme miss; variety is judged where there are enough of them."""
    wet, beds = homes.wet, homes.bedrooms_off
    missed = {
        "short rooms": homes.short_rooms > 0.003 * homes.rooms,
        "short homes": homes.short_homes > 0.02 * homes.homes,
        "wet beside wet": sum(wet) < 0.82 * len(wet),
        "bedrooms off the entrance room": sum(beds) < 0.99 * len(beds),
        "hallway": median(homes.hallway) > 0.12,
        "faults": bool(homes.faults),
        "windows": homes.unlit > homes.dark,
        "graphs": homes.homes >= 1000 and len(homes.graphs) < GRAPHS.get(name, 1),
    }
    return [f"{name}: {target}" for target, is_missed in missed.items() if is_missed]


def misshapen(homes: Homes, name: str, outline: str) -> list[str]:
    """Names the targets that homes of an outline miss: nearly all have it, none is out of line by a little or lacks a window."""
    wrong = {
        "outline": homes.outlines[outline] < (0.98 if outline == "U" else 1.0) * homes.homes,
        "short lines": homes.least_line < 900,
        "rooms without a window": homes.unlit > 0,
    }
    return [f"{name}: {target}" for target, is_missed in wrong.items() if is_missed]


def programme_table(seeds: int) -> tuple[str, list[str]]:
    """Returns the table of the presets and of the random programmes, and the targets missed."""
    catalogs, lines, wrong = load_catalogs(), [HEAD, "|" + "---|" * (HEAD.count("|") - 1)], list[str]()
    for name, programme in PRESETS.items():
        homes = measure(range(seeds), catalogs, program=programme)
        lines.append(homes.line(name))
        wrong += missed(homes, name)
    for outline in OUTLINES:
        for name in ("one_bed", "family", "large"):
            if (name, outline) != ("one_bed", "U"):
                homes = measure(range(min(seeds, BENT)), catalogs, program=name, outline=outline)
                lines.append(homes.line(f"{name}, {outline}"))
                wrong += missed(homes, name) + misshapen(homes, f"{name}, {outline}", outline)
    every = Homes()
    for number in range(min(seeds, RANDOM)):
        measure([number], catalogs, every, program=random_programme(number))
    lines.append(every.line("random programmes"))
    return "\n".join(lines), wrong + missed(every, "random programmes")


def measure(seeds: Sequence[int], catalogs: Catalogs, into: Homes | None = None, **fields: object) -> Homes:
    """Plans homes of one programme."""
    homes = Homes() if into is None else into
    for seed in seeds:
        request = Request(seed=seed, **fields)  # type: ignore[arg-type]
        start = process_time()
        plan = draw(request, catalogs)
        homes.ms.append((process_time() - start) * 1000)
        homes.add(plan, seed)
    return homes


def random_programme(number: int) -> dict[str, int]:
    """Returns a programme that nobody chose: two to fifteen rooms."""
    stream = Stream(number, "a programme for a test")
    bedrooms = stream.below(6)
    return {
        "bedrooms": bedrooms,
        "bathrooms": 1 + stream.below(1 + (bedrooms + 1) // 2),
        "dining_room": stream.below(2),
        "laundry": stream.below(2),
        "office": stream.below(2) + stream.chance(0.1),
        "foyer": int(stream.chance(0.8)),
        "garage": stream.pick((0, 0, 0, 1, 2, 2, 3)),
        "workshop": int(stream.chance(0.15)),
        "living_room": 1 + (bedrooms > 3 and stream.chance(0.3)),
    }
