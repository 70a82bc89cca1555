"""What rooms of a plan are: by their names, by what stands in them, by their form; held against homes whose types are hidden."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import get_args

import numpy as np
import pytest

from catalogs import Catalogs, load_catalogs
from catalogs.entries import Mark
from solver import generate
from solver.guessing import guessed_types
from solver.guessing.suiting import RoomMarks, RoomNumbers, Suiting, marks_of
from solver.request import Request
from solver.scene import EXTERIOR, Furniture, Opening, Room, Scene
from tests.guessing.plans import as_plan
from tests.sweeps import seeds

KNOWN = load_catalogs()
BEDROOMS = {"bedroom_master": "bedroom", "kids_bedroom": "bedroom"}
REQUESTS = [*({"program": name} for name in KNOWN.presets), {"width": 14, "depth": 11}, {"width": 9, "depth": 8}]


def types(scene: Scene, **more: object) -> dict[str, str]:
    return {guess.room: guess.type for guess in guessed_types(scene, KNOWN, **more)}  # type: ignore[arg-type]


@pytest.mark.parametrize("furnished", [False, True], ids=["by form", "by what stands there"])
def test_hidden_types_are_found(furnished: bool) -> None:
    right, count = 0, 0
    for seed in seeds(range(700, 740), 21):
        for request in REQUESTS:
            home = generate(Request(seed=seed, **request)).scene  # type: ignore[arg-type]
            found = types(as_plan(home, furnished))
            assert len(found) == len(home.rooms)
            for k, room in enumerate(home.rooms):
                right += BEDROOMS.get(room.type, room.type) == BEDROOMS.get(found[f"r{k}"], found[f"r{k}"])
                count += 1
    assert right / count >= (0.98 if furnished else 0.92)


def only_windows_of(kept: int, room: Room, k: int) -> tuple[Opening, ...]:
    """A room's openings in a plan that draws windows in every so many rooms alone, or in none."""
    return tuple(one for one in room.openings if one.kind != "window" or (kept and k % kept == 0))


def without_outer_doors(_: int, room: Room, __: int) -> tuple[Opening, ...]:
    """A room's openings in a plan that draws none to the outside but windows and garage doors."""
    return tuple(one for one in room.openings if one.kind not in ("door", "passage") or one.connects_to != EXTERIOR)


@pytest.mark.parametrize(
    ("drawn", "kept"),
    [(only_windows_of, 0), (only_windows_of, 9), (only_windows_of, 5), (without_outer_doors, 0)],
    ids=["no windows", "one window", "few windows", "no outer doors"],
)
def test_what_a_plan_does_not_draw_tells_nothing(drawn: Callable[[int, Room, int], tuple[Opening, ...]], kept: int) -> None:
    right, count = 0, 0
    for seed in seeds(range(740, 760), 20):
        for request in REQUESTS:
            home = generate(Request(seed=seed, **request)).scene  # type: ignore[arg-type]
            plan = as_plan(home)
            found = types(replace(plan, rooms=tuple(replace(room, openings=drawn(kept, room, k)) for k, room in enumerate(plan.rooms))))
            for k, room in enumerate(home.rooms):
                right += BEDROOMS.get(room.type, room.type) == BEDROOMS.get(found[f"r{k}"], found[f"r{k}"])
                count += 1
    assert right / count >= 0.85


def test_nobody_comes_to_a_room_of_all_through_a_bedroom_or_a_bathroom() -> None:
    """Behind a hall lies one room, and all others behind that: it is no bedroom, though it is as large as one."""
    home = around(Room("middle", width=4.4, depth=3.6), {"hall": (2, 2), "a": (3.4, 3.3), "b": (3.2, 3.4), "c": (3.6, 3.3), "d": (2, 2.2)})
    entered = tuple(replace(room, openings=(*room.openings, FRONT)) if room.id == "hall" else room for room in home.rooms)
    marks = {room.id: one for room, one in zip(entered, marks_of(entered), strict=True)}
    assert {name: one.behind for name, one in marks.items()} == {"middle": 1, "hall": None} | dict.fromkeys("abcd", 0)
    found = types(Scene(rooms=entered))
    assert KNOWN.rooms[found["middle"]].plan.way_through
    suiting = Suiting(list(marks.values()), KNOWN)
    for one in ("bedroom", "bathroom", "office"):
        assert suiting.past(one, "living_room") > suiting.past("living_room", one) == suiting.past(one, "balcony") == 0


def test_a_room_with_two_ways_in_lies_behind_neither() -> None:
    rooms = [Room(name, width=3, depth=3) for name in "abcd"]
    doors = {(a, b): Opening(a + b, "door", "north", 1.0, 0.9, 2.0, connects_to=b) for a, b in ("ab", "ac", "bd", "cd")}
    led = [replace(room, openings=tuple(door for (a, _), door in doors.items() if a == room.id)) for room in rooms]
    led[0] = replace(led[0], openings=(*led[0].openings, FRONT))
    assert [one.behind for one in marks_of(led)] == [None, 0, 0, None]
    assert [one.behind for one in marks_of([replace(led[0], openings=led[0].openings[:2]), *led[1:]])] == [None] * 4


def test_a_balcony_lies_behind_no_bathroom() -> None:
    home = around(Room("middle", width=2.0, depth=3.6), {"balcony": (3.0, 1.4)})
    shut, led = (Suiting(marks_of([home.rooms[0], replace(home.rooms[1], outdoor=outdoor)]), KNOWN) for outdoor in (False, True))
    assert led.alone(0, "bathroom") - led.alone(0, "kitchen") > 2 + shut.alone(0, "bathroom") - shut.alone(0, "kitchen")


def test_known_types_stay_and_names_win_over_what_stands_there() -> None:
    toilet = Furniture("t", "toilet", width=0.4, depth=0.6, height=0.8)
    rooms = (Room("a", type="office", width=3, depth=3), Room("b", type="Küche 2", width=3, depth=3, furniture=(toilet,)))
    (guess,) = guessed_types(Scene(rooms=rooms), KNOWN)
    assert (guess.room, guess.type, guess.by, guess.sent) == ("b", "kitchen", "name", "Küche 2")
    assert "Küche 2" in guess.message


def test_a_name_beside_the_type_counts_too() -> None:
    room = Room("a", type="room", width=3, depth=3, name="Salle de bain")
    assert types(Scene(rooms=(room,))) == {"a": "bathroom"}


def test_what_we_have_no_type_for_stays() -> None:
    assert types(Scene(rooms=(Room("a", type="walk-in closet", width=3, depth=3),))) == {}


def test_a_garage_is_for_as_many_cars_as_it_is_large() -> None:
    rooms = [Room(f"g{width}", type="Garage", width=width, depth=6) for width in (3.2, 6, 9.5)]
    assert list(types(Scene(rooms=tuple(rooms))).values()) == ["garage", "garage_2car", "garage_3car"]


def test_a_programme_tells_how_many_there_are() -> None:
    """Two like rooms off a hallway: both bedrooms where two are counted, one an office where that is."""
    doors = [Opening(f"d{k}", wall="south", position=1.0, connects_to="hall") for k in range(2)]
    window = Opening("w", kind="window", wall="north", position=1.7, width=1.4, height=1.4, sill=0.9)
    rooms = [Room(f"r{k}", type="", width=3.4, depth=3.2, x=3.4 * k, openings=(doors[k], replace(window, id=f"w{k}"))) for k in range(2)]
    hall = Room("hall", type="hallway", width=6.8, depth=1.4, z=3.2, openings=tuple(replace(door, connects_to=None) for door in doors))
    plan = Scene(rooms=(*rooms, hall))
    for program in ({"bedrooms": 2}, {"bedrooms": 1, "office": 1}):
        found = Counter(BEDROOMS.get(name, name) for name in types(plan, program=program).values())
        assert found == Counter({"bedroom": program["bedrooms"], "office": program.get("office", 0)}) - Counter()


def test_what_marks_cost_is_a_catalogs_own(tmp_path: Path) -> None:
    """One bedroom like another is an office where offices are the rule, and a narrow room no kitchen where those are wide."""
    (tmp_path / "guessing.yaml").write_text("first: {types: {office: -9}}\nwidth: {cost: 40, types: {kitchen: 3}}", encoding="utf-8")
    own = load_catalogs(tmp_path)
    home = as_plan(generate(Request(seed=4, program="family")).scene)
    ours, theirs = ([guess.type for guess in guessed_types(home, one)] for one in (KNOWN, own))
    assert ("office" in theirs, "office" in ours) == (True, False)
    galley = Suiting(marks_of([Room("a", width=5.0, depth=2.4)]), KNOWN), Suiting(marks_of([Room("a", width=5.0, depth=2.4)]), own)
    assert galley[0].alone(0, "kitchen") < galley[0].alone(0, "bedroom") + 1 < galley[1].alone(0, "kitchen")


def costs_by(catalogs: Catalogs) -> list[float]:
    """What rooms of many forms, doors between all types, and homes of many rooms cost."""
    forms = product((1.0, 30.0), (0.8, 4.0), ("", "door", "main"), (0, 1), (0, 1), (0, 4), (frozenset[str](), frozenset({"bed"})))
    marks = [
        RoomMarks(area, short, 9.0, tuple((there, False) for there in range(ways)), front, large, small, False, False, pieces)
        for area, short, front, large, small, ways, pieces in forms
    ]
    suiting, names = Suiting(marks, catalogs), list(catalogs.rooms)
    found = [suiting.alone(k, name) for k in range(len(marks)) for name in names]
    found += [suiting.joined(one, other, is_open) for one in names for other in names for is_open in (False, True)]
    found += [suiting.past(one, other) for one in names for other in names]
    homes = np.vstack([np.zeros((1, len(names)), np.int64), np.eye(len(names), dtype=np.int64) * 2])
    for program in (None, {"kitchen": 1}):
        numbers = RoomNumbers(catalogs, 12, program)
        found += [*numbers.more(homes).ravel(), *numbers.missing(homes)]
    return found


@pytest.fixture(scope="module")
def told() -> list[float]:
    return costs_by(KNOWN)


@pytest.mark.parametrize("mark", get_args(Mark))
def test_each_mark_tells_something(mark: str, told: list[float]) -> None:
    without = KNOWN.model_copy(update={"guessing": {name: told for name, told in KNOWN.guessing.items() if name != mark}})
    assert costs_by(without) != told


def test_the_same_plan_gives_the_same_guesses() -> None:
    home = as_plan(generate(Request(seed=5, program="family")).scene)
    assert guessed_types(home, KNOWN) == guessed_types(home, KNOWN)


@pytest.mark.parametrize("size", [(1e-9, 1e-9), (1e-300, 3.0), (1000.0, 1e-6), (1000.0, 1000.0)])
def test_rooms_of_no_size_and_of_any_get_a_type(size: tuple[float, float]) -> None:
    rooms = (Room("a", width=size[0], depth=size[1]), Room("b", x=1001.0, width=4.0, depth=3.0))
    assert {*types(Scene(rooms=rooms))} >= {"b"}


def around(middle: Room, others: dict[str, tuple[float, float]]) -> Scene:
    """Returns a home whose other rooms lie behind one door each in the middle room."""
    doors = {name: Opening(f"to {name}", "door", "north", 1.0, 0.9, 2.0, connects_to=name) for name in others}
    back = {name: replace(door, connects_to=middle.id) for name, door in doors.items()}
    rooms = [Room(name, width=width, depth=depth, openings=(back[name],)) for name, (width, depth) in others.items()]
    return Scene(rooms=(replace(middle, openings=(*middle.openings, *doors.values())), *rooms))


FRONT = Opening("front", "door", "south", 1.0, 0.9, 2.0, connects_to=EXTERIOR, main_entrance=True)


def test_one_neither_dines_nor_lives_behind_the_only_door_of_a_room() -> None:
    home = around(Room("hall", width=6, depth=4, openings=(FRONT,)), {"a": (3.4, 3.3), "b": (3.4, 3.4), "c": (3.8, 3.8), "d": (2, 2.2)})
    found = types(home)
    assert found["d"] == "bathroom"
    assert not {"dining_room", "living_room"} & {found[name] for name in "abc"}


def test_a_room_that_is_called_a_garden_is_weighed_as_one() -> None:
    """Rooms in a row behind it: taken for one indoors, it made the room before it a bathroom."""
    widths = (3.7, 2.6, 3.9, 4.8)
    rooms = [Room(f"r{at}", x=sum(widths[:at]), width=width, depth=2.6) for at, width in enumerate(widths)]
    for at in range(3):
        door = Opening(f"door_{at}", "door", "east", 1.3, 0.8, connects_to=f"r{at + 1}")
        rooms[at] = replace(rooms[at], openings=(*rooms[at].openings, door))
        rooms[at + 1] = replace(rooms[at + 1], openings=(replace(door, wall="west", connects_to=f"r{at}"),))
    named, said = replace(rooms[0], name="Garten"), replace(rooms[0], name="Garten", outdoor=True)
    assert types(Scene(rooms=(named, *rooms[1:]))) == types(Scene(rooms=(said, *rooms[1:])))


@pytest.mark.parametrize("outdoor", [False, True])
def test_only_rooms_indoors_count_as_those_a_hallway_leads_to(outdoor: bool) -> None:
    home = around(Room("middle", width=3, depth=2.4), {"a": (3.4, 3.3), "b": (3, 1.2)})
    last = replace(home.rooms[2], outdoor=outdoor)
    leading, shut = (Suiting(marks_of(rooms), KNOWN).alone(0, "hallway") for rooms in ((*home.rooms[:2], last), home.rooms[:2]))
    assert (leading == shut) == outdoor


@pytest.mark.parametrize("seed", seeds(range(20, 40), 7))
def test_no_other_types_of_a_small_home_are_cheaper(seed: int) -> None:
    """All ways to give four rooms one of the eight types that suit each best are tried, and summed up plainly."""
    plan = as_plan(generate(Request(seed=seed, program="studio")).scene)
    marks = marks_of(plan.rooms)
    suiting, names = Suiting(marks, KNOWN), list(KNOWN.rooms)
    numbers = RoomNumbers(KNOWN, len(marks), None)
    alone = [{name: suiting.alone(k, name) for name in names} for k in range(len(marks))]

    def cost(given: tuple[str, ...]) -> float:
        doors = {(min(k, there), max(k, there), is_open) for k, one in enumerate(marks) for there, is_open in one.ways}
        total = sum(alone[k][name] for k, name in enumerate(given))
        for a, b, is_open in doors:
            total += suiting.joined(given[a], given[b], is_open)
            total += suiting.past(given[a], given[b]) if marks[b].behind == a else 0.0
            total += suiting.past(given[b], given[a]) if marks[a].behind == b else 0.0
        counts = np.zeros((1, len(names)), dtype=np.int64)
        for name in given:
            total += numbers.more(counts)[0][names.index(name)]
            counts[0, names.index(name)] += 1
        return float(total + numbers.missing(counts)[0])

    found = cost(tuple(types(plan).values()))
    best = [sorted(one, key=lambda name: one[name])[:8] for one in alone]
    assert found <= min(map(cost, product(*best))) + 1e-6


def test_a_door_that_two_rooms_list_leads_from_one_to_the_other_though_both_say_outside() -> None:
    door = Opening("d", "door", "south", 1.0, 0.9, 2.1, connects_to=EXTERIOR)
    rooms = (Room("a", width=4, depth=3, openings=(door,)), Room("b", width=4, depth=3, z=3.0, openings=(replace(door, wall="north"),)))
    first, second = marks_of(rooms)
    assert (first.front, second.front) == ("", "")
    assert (first.ways, second.ways) == (((1, False),), ((0, False),))


def listed_once(plan: Scene) -> Scene:
    """A plan whose inner doors are listed by the last of their rooms alone; and each says that it leads outside."""
    last = {opening.id: room.id for room in plan.rooms for opening in room.openings if opening.kind in ("door", "passage")}

    def of(room: Room) -> tuple[Opening, ...]:
        kept = (one for one in room.openings if last.get(one.id, room.id) == room.id)
        return tuple(
            replace(one, connects_to=EXTERIOR) if one.id in last and not outdoors.intersection({room.id, one.connects_to}) else one
            for one in kept
        )

    outdoors = {room.id for room in plan.rooms if room.outdoor}
    return replace(plan, rooms=tuple(replace(room, openings=of(room)) for room in plan.rooms))


def test_a_door_that_one_room_lists_leads_where_it_lies_whatever_it_says() -> None:
    """Homes of every outline: what the rooms are joined to, and so each guess, is what it is where both rooms list each door."""
    for seed in seeds(range(820, 836), 9):
        for outline in ("rectangle", "L", "U"):
            plan = as_plan(generate(Request(seed=seed, program="family", outline=outline)).scene)
            told = listed_once(plan)
            assert told != plan
            whole, once = marks_of(plan.rooms), marks_of(told.rooms)
            assert [dict(one.ways) for one in once] == [dict(one.ways) for one in whole]
            assert types(told) == types(plan)


def test_a_door_to_a_yard_leads_outside_and_one_without_a_wall_nowhere() -> None:
    door = Opening("d", "door", "south", 1.0, 0.9, 2.1, connects_to=EXTERIOR)
    below = Room("b", width=4, depth=3, z=3.2)
    assert marks_of((Room("a", width=4, depth=3, openings=(door,)), below))[0].ways == ((1, False),)
    for openings, other in (
        ((door,), replace(below, outdoor=True)),
        ((door,), replace(below, level=1)),
        ((replace(door, wall="north"),), below),
        ((replace(door, wall=None),), below),
        ((door,), replace(below, z=3.8)),
        ((door,), replace(below, z=0.5)),
        ((replace(door, main_entrance=True),), below),
    ):
        first, _ = marks_of((Room("a", width=4, depth=3, openings=openings), other))
        assert (first.ways, first.front) == ((), "main" if openings[0].main_entrance else "door")


@pytest.mark.parametrize("seed", range(4))
def test_each_of_two_dwellings_that_no_door_joins_is_guessed_as_if_it_were_alone(seed: int) -> None:
    """Two flats of other programmes, side by side; upstairs there is a room more, which is the first one's."""

    def named(plan: Scene, prefix: str, x: float) -> tuple[Room, ...]:
        def to(one: Opening) -> Opening:
            inside = one.connects_to not in (None, EXTERIOR)
            return replace(one, id=prefix + one.id, connects_to=prefix + str(one.connects_to) if inside else one.connects_to)

        return tuple(replace(room, id=prefix + room.id, x=room.x + x, openings=tuple(map(to, room.openings))) for room in plan.rooms)

    first, second = (as_plan(generate(Request(program=name, seed=seed)).scene) for name in ("one_bed", "family"))
    attic = Room("attic", type="room", level=1, width=4.0, depth=4.0)
    both = Scene(wall_thickness=0.1, rooms=(*named(first, "a_", 0.0), *named(second, "b_", 30.0), attic))
    alone = types(replace(first, rooms=(*named(first, "a_", 0.0), attic))) | types(replace(second, rooms=named(second, "b_", 30.0)))
    assert types(both) == alone
