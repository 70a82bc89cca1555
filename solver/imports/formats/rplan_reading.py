"""RPLAN as HouseGAN++ keeps it: `room_type`, `boxes` and `edges` with the codes of the rooms beside them, in pixels of a 256 x 256 image.

Its y points down. The image is 18 m wide, so a pixel is 7 cm; doors, 12 pixels, come out at 0.84 m.
"""

from collections.abc import Mapping, Sequence
from typing import Any, Final

from solver.answers import Unread
from solver.errors import FieldError
from solver.imports.drawn import MOST_POINTS, DrawnOpening, DrawnPlan, DrawnRoom, Spot, check_count
from solver.imports.plain_values import a_list, a_number

PIXEL: Final = 18 / 256
"""m."""
TAKEN: Final = "a pixel is taken as 18 m / 256, the scale of RPLAN's images"
ROOM_TYPES: Final = {
    1: "living_room", 2: "kitchen", 3: "bedroom", 4: "bathroom", 5: "balcony", 6: "foyer", 7: "dining_room", 8: "office", 10: "storage",
    16: "unknown",
}  # fmt: skip
"""What a code means; others are called by their number."""
OUTDOOR: Final = 5
ENTRANCE: Final = 15
DOOR: Final = 17
Segment = tuple[Spot, Spot]


def read_rplan(document: Mapping[str, Any]) -> DrawnPlan:
    """Reads an apartment.

    Raises:
        FieldError: something in it cannot be read; names its place.
    """
    check_count("room_type", len(a_list(document["room_type"], "room_type")), MOST_POINTS)
    types = [round(a_number({"": value}, "", f"room_type[{at}]")) for at, value in enumerate(a_list(document["room_type"], "room_type"))]
    owned: list[list[Segment]] = [[] for _ in types]
    sides, edges = a_list(document["ed_rm"], "ed_rm"), a_list(document["edges"], "edges")
    check_count("edges", len(edges), MOST_POINTS)
    if len(sides) != len(edges):
        raise FieldError("ed_rm", f"has {len(sides)} entries", f"one for each of {len(edges)} edges")
    for at, (edge, rooms) in enumerate(zip(edges, sides, strict=True)):
        numbers = [a_number({"": value}, "", f"edges[{at}]") for value in a_list(edge, f"edges[{at}]")[:4]]
        owner = next(iter(a_list(rooms, f"ed_rm[{at}]")), None)
        if len(numbers) < 4 or not isinstance(owner, int) or not 0 <= owner < len(types):
            raise FieldError(f"edges[{at}]", "is no edge of a room", "x, y, x, y; and in ed_rm the number of its room first")
        owned[owner].append(((numbers[0], numbers[1]), (numbers[2], numbers[3])))
    rooms, openings, unread = [], [], []
    for number, (kind, segments) in enumerate(zip(types, owned, strict=True)):
        where = f"room_type[{number}]"
        outlines = _loops(segments)
        if kind in (DOOR, ENTRANCE):
            openings += _door(kind, segments, where)
        elif not outlines:
            unread.append(Unread(where, "its edges close no outline"))
        else:
            rooms += [
                DrawnRoom(tuple(points), "", where, ROOM_TYPES.get(kind, f"room of code {kind}"), 0, kind == OUTDOOR) for points in outlines
            ]
    return DrawnPlan(tuple(rooms), tuple(openings), metres=PIXEL, drawn="inner", unread=tuple(unread), unit_words=TAKEN)


def _loops(segments: Sequence[Segment]) -> list[list[Spot]]:
    """Returns the closed outlines that segments make, each going on where the last one ended."""
    found: list[list[Spot]] = []
    way: list[Spot] = []
    for a, b in segments:
        if way and way[-1] != a:
            way = []
        way = way or [a]
        way.append(b)
        if b == way[0]:
            found.append(way[:-1])
            way = []
    return [points for points in found if len(points) >= 4]


def _door(kind: int, segments: Sequence[Segment], where: str) -> list[DrawnOpening]:
    """Returns a door along the longer side of the box that its edges make."""
    spots = [spot for segment in segments for spot in segment]
    if not spots:
        return []
    x0, x1 = min(x for x, _ in spots), max(x for x, _ in spots)
    y0, y1 = min(y for _, y in spots), max(y for _, y in spots)
    ends: Segment = ((x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2)) if x1 - x0 >= y1 - y0 else (((x0 + x1) / 2, y0), ((x0 + x1) / 2, y1))
    return [DrawnOpening("door", *ends, where, main_entrance=kind == ENTRANCE)]
