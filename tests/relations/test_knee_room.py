"""Where a piece can reach under another one: by hand, and against the parts of the catalogs' own kinds, box by box."""

from __future__ import annotations

from itertools import product
from random import Random

from catalogs import load_catalogs
from catalogs.schema import RelationSpec, RoomType
from solver.furnish import space_of, wanted_pieces
from solver.geometry import Rect, turned
from solver.pieces import Candidate
from solver.relations.subject import Kind, PartBox
from solver.scene import Room
from solver.streams import Stream
from tests.every import every
from tests.furnish.reference.knee_room import free, taken
from tests.furnish.reference.slots import nearest_free
from tests.relations.ways import beside

KNOWN = load_catalogs()
TABLE = (PartBox(Rect(-500, -300, 500, 300), 700, 750), PartBox(Rect(-500, -300, -450, 300), 0, 700))
STOOL = (PartBox(Rect(-200, -200, 200, 200), 0, 450),)
RULES: list[dict[str, object]] = [
    {"type": "under", "gap": -0.3},
    {"type": "under", "gap": -0.2, "align": "any"},
    {"type": "around", "gap": -0.15},
]
TUCKED = [
    (table, seat)
    for table, seats in {
        "dining_table": ["dining_chair"],
        "large_dining_table": ["dining_chair"],
        "small_dining_table": ["dining_chair"],
        "square_dining_table": ["dining_chair"],
        "desk": ["office_chair", "dining_chair"],
        "medium_desk": ["office_chair", "dining_chair"],
        "small_desk": ["office_chair", "dining_chair"],
        "dressing_table": ["ottoman"],
        "kids_table": ["kids_chair"],
        "patio_table": ["bistro_chair"],
        "bistro_table": ["bistro_chair"],
    }.items()
    for seat in seats
]


def slots(table: str, seat: str, rule: dict[str, object]) -> list[Candidate]:
    """Returns the slots of a room type's seat at a table, by a rule that it must keep."""
    pieces = [{"piece": table}, {"piece": seat, "rules": [{**rule, "of": [table], "required": True}]}]
    den = RoomType.model_validate(
        {"area": {"min": (4, 4), "typical": 12, "max": 60}, "flooring": "wood", "accent": "#808080", "pieces": pieces}
    )
    room = Room("den_0", 0, "den", width=5.0, depth=5.0)
    wanted = wanted_pieces(room, space_of(room, 0.1), KNOWN.model_copy(update={"rooms": {"den": den}}), Stream(1, "furnish", 0))
    (sought,) = (piece for piece in wanted if piece.label == f"{seat}_1")
    return [one for one in sought.candidates if one.attach]


def crosses(table: Kind, seat: Kind, at: tuple[float, float], turn: int) -> bool:
    """Tells whether any two parts' boxes share more than a millimetre with the seat's centre there, in the table's frame."""

    def spans(kind: str, size: tuple[int, int, int], by: int, move: tuple[float, float]) -> list[tuple[float, ...]]:
        found: list[tuple[float, ...]] = []
        for one in KNOWN.shapes[kind]:
            (x0, x1), (z0, z1) = (tuple((share - 0.5) * length for share in ends) for ends, length in ((one.x, size[0]), (one.z, size[1])))
            if by == 180:
                x0, x1, z0, z1 = -x1, -x0, -z1, -z0
            elif by == 90:
                x0, x1, z0, z1 = z0, z1, -x1, -x0
            elif by == 270:
                x0, x1, z0, z1 = -z1, -z0, x0, x1
            found.append((x0 + move[0], x1 + move[0], z0 + move[1], z1 + move[1], one.y[0] * size[2], one.y[1] * size[2]))
        return found

    mine, its = spans(seat.name, seat.size, turn, at), spans(table.name, table.size, 0, (0, 0))
    return any(all(min(a[k + 1], b[k + 1]) - max(a[k], b[k]) > 1 for k in (0, 2, 4)) for a, b in product(mine, its))


def test_a_part_is_in_the_way_only_of_what_is_at_its_height() -> None:
    assert taken(TABLE, STOOL, 0) == (Rect(-705, -505, -245, 505),)
    assert taken(TABLE, (PartBox(Rect(-200, -200, 200, 200), 0, 701),), 0) == (Rect(-705, -505, 705, 505),)
    assert taken((), STOOL, 0) == ()


def test_free_places_are_the_largest_rectangles_left() -> None:
    hole = Rect(4, 4, 6, 6)
    assert free(Rect(0, 0, 10, 10), []) == [Rect(0, 0, 10, 10)]
    left = [Rect(0, 0, 4, 10), Rect(6, 0, 10, 10), Rect(0, 0, 10, 4), Rect(0, 6, 10, 10)]
    assert sorted(free(Rect(0, 0, 10, 10), [hole])) == sorted(left)
    assert free(Rect(4, 5, 4, 5), [hole]) == [Rect(4, 5, 4, 5)]
    assert free(Rect(5, 5, 5, 5), [hole]) == []
    assert free(Rect(0, 5, 10, 5), [hole]) == [Rect(0, 5, 4, 5), Rect(6, 5, 10, 5)]


@every("seed", range(20))
def test_free_places_are_all_there_are(seed: int) -> None:
    random = Random(seed)

    def drawn(most: int) -> Rect:
        x, z = random.randrange(most), random.randrange(most)
        return Rect(x, z, x + random.randrange(1, 8), z + random.randrange(1, 8))

    area, holes = Rect(0, 0, 15, 15), [drawn(14) for _ in range(random.randrange(1, 7))]
    left = free(area, holes)
    for x, z in product(range(16), repeat=2):
        inside = any(hole.x0 < x < hole.x1 and hole.z0 < z < hole.z1 for hole in holes)
        assert any(rect.x0 <= x <= rect.x1 and rect.z0 <= z <= rect.z1 for rect in left) == (not inside), (x, z)


def test_the_nearest_place_keeps_under_before_it_keeps_in_line() -> None:
    wish, reach, hole = Rect(0, 0, 0, 0), Rect(-10, 0, 10, 20), Rect(-4, -5, 6, 5)
    assert nearest_free(wish, reach, [hole], sideways=False) == [Rect(-4, 0, -4, 0)]
    assert nearest_free(wish, reach, [hole], sideways=True) == [Rect(0, 5, 0, 5)]
    assert nearest_free(wish, reach, [Rect(-20, -5, 20, 5)], sideways=False) == [Rect(0, 5, 0, 5)]
    assert nearest_free(wish, Rect(-10, 0, 10, 4), [Rect(-20, -5, 20, 5)], sideways=False) == []


@every(("table", "seat"), TUCKED)
def test_what_is_free_under_a_table_crosses_nothing(table: str, seat: str) -> None:
    parent, own = Kind.of(table, KNOWN), Kind.of(seat, KNOWN)
    for turn in (0, 90, 180, 270):
        width, depth = turned(*own.size[:2], turn)
        reach = Rect(-(parent.size[0] + width) // 2, -(parent.size[1] + depth) // 2, 0, 0)
        for place in free(reach, taken(parent.parts, own.parts, turn)):
            assert not any(crosses(parent, own, at, turn) for at in ((place.x0, place.z0), (place.x1, place.z1), (place.x0, place.z1)))


@every(("table", "seat"), TUCKED)
@every("rule", [{"type": "under", "gap": -0.3}, {"type": "under", "gap": -0.2, "align": "any"}, {"type": "around", "gap": -0.15}])
def test_slots_of_room_types_reach_under_and_cross_nothing(table: str, seat: str, rule: dict[str, object]) -> None:
    parent, own = Kind.of(table, KNOWN), Kind.of(seat, KNOWN)
    found = slots(table, seat, rule)
    assert found
    for slot in found:
        assert slot.attach is not None and slot.under == f"{table}_1"
        for at in product(slot.attach.across_mm, slot.attach.along_mm):
            assert not crosses(parent, own, at, slot.rotation)
            width, depth = turned(*own.size[:2], slot.rotation)
            shared = (parent.size[0] + width) / 2 - abs(at[0]), (parent.size[1] + depth) / 2 - abs(at[1])
            assert min(shared) >= (10 if rule["type"] == "under" else 0)


@every(("table", "seat"), TUCKED)
def test_places_that_are_sought_cross_nothing(table: str, seat: str) -> None:
    parent, own = Kind.of(table, KNOWN), Kind.of(seat, KNOWN)
    spec = RelationSpec.model_validate({"type": "under", "of": ["it"]})
    places = [way.attach for way in beside(spec, own, parent) if way.rotation == 180]
    assert places
    for place in places:
        assert place is not None
        assert not any(crosses(parent, own, at, 180) for at in product(place.across_mm, place.along_mm))


def test_a_corner_seat_moves_off_the_leg_and_stays_apart_from_its_neighbour() -> None:
    parent, own = Kind.of("small_dining_table", KNOWN), Kind.of("dining_chair", KNOWN)
    assert crosses(parent, own, (300, parent.size[1] // 2 + own.size[1] // 2 - 150), 180)
    found = slots("small_dining_table", "dining_chair", {"type": "around", "sides": ["front"], "gap": -0.15})
    across = sorted(slot.attach.across_mm for slot in found if slot.attach)
    assert across[0][0] == -across[1][0] and own.size[0] <= across[1][0] - across[0][0] < 600
