"""What the readers take, what they make up, and how they refuse: by field, with what is allowed."""

from __future__ import annotations

import math
import time
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from service.contract import PlaceBody
from solver.errors import FieldError, RequestError, SceneError
from solver.exchange import read, read_request, read_scene, write_scene
from solver.request import MAX_SEED, Request
from solver.scene import Scene, Sides
from tests.every import every
from tests.exchange.documents import PLAIN, piece, room, scene
from tests.sweeps import examples


def refused(document: object) -> SceneError:
    with pytest.raises(SceneError) as caught:
        read_scene(document)
    return caught.value


# --- forgiving ---------------------------------------------------------------------------------------------------------
def test_only_sizes_and_places_are_required() -> None:
    read = read_scene(scene({"width": 4, "depth": 3, "furniture": [piece(x=1, z=2)], "decorations": [piece()]}))
    (only,) = read.rooms
    assert (only.id, only.index, only.type, only.width, only.openings, only.outline) == ("room_0", 0, "room", 4.0, (), None)
    assert isinstance(only.width, float)
    assert (only.furniture[0].id, only.furniture[0].rotation, only.furniture[0].wall) == ("room_0/sofa_1", 0, None)
    assert only.decorations[0].id == "room_0/sofa_2"
    assert read_scene({}) == Scene()


@every("key", ["name", "x", "z", "width", "depth", "height"])
@every("part", ["furniture", "decorations"])
def test_what_a_piece_must_say(part: str, key: str) -> None:
    for wrong, problem in ({name: value for name, value in piece().items() if name != key}, "missing"), (piece(**{key: None}), "null"):
        error = refused(scene(room(), {"width": 1, "depth": 1, part: [piece(), wrong]}))
        assert error.field == f"rooms[1].{part}[1].{key}"
        assert problem in error.problem
        assert error.allowed


@pytest.mark.parametrize("key", ["width", "depth"])
def test_what_a_room_must_say(key: str) -> None:
    wrong = room()
    del wrong[key]
    assert refused(scene(wrong)).field == f"rooms[0].{key}"


def test_null_means_not_given() -> None:
    read = read_scene(scene(room(piece(rotation=None, locked=None), openings=None, type=None, index=None), rooms_more=None, levels=None))
    assert read.rooms[0].furniture[0].rotation == 0
    assert (read.rooms[0].openings, read.rooms[0].type, read.levels) == ((), "room", ())


def test_null_means_not_given_wherever_a_record_stands() -> None:
    sides = {"north": None, "south": True}
    (read,) = read_scene(scene(room(exterior_walls=sides, wall_flags=sides, openings=[{"sill": None}, {"sill": None}]))).rooms
    assert read.exterior_walls == read.wall_flags == Sides(south=True)
    assert [opening.sill for opening in read.openings] == [0.0, 0.0]


def test_unknown_keys_are_kept_at_every_level() -> None:
    known = scene(
        room(piece(brand={"a": [1, None]}), openings=[{"leaf": 1}], flooring={"pile": 2}, view="sea"),
        size={"width": 4, "depth": 3, "attic": 1},
        levels=[{"name": "ground"}],
        dynamic=[{"mood": "fine"}],
        source="elsewhere",
        extra={"extra": 1},
    )
    read = read_scene(known)
    assert read.extra == {"source": "elsewhere", "extra": {"extra": 1}}
    assert read.rooms[0].furniture[0].extra == {"brand": {"a": [1, None]}}
    written = write_scene(read)
    assert (written["source"], written["extra"], written["size"]["attic"]) == ("elsewhere", {"extra": 1}, 1)
    assert (written["rooms"][0]["view"], written["rooms"][0]["openings"][0]["leaf"]) == ("sea", 1)
    assert (written["rooms"][0]["flooring"]["pile"], written["levels"][0]["name"], written["dynamic"][0]["mood"]) == (2, "ground", "fine")


def test_a_scene_does_not_change_with_the_document_it_was_read_from() -> None:
    document = scene(room(), note=[1])
    read = read_scene(document)
    document["note"].append(2)
    assert read.extra == {"note": [1]}


# --- ids -------------------------------------------------------------------------------------------------------------
def test_ids_are_made_up_alike_and_never_twice() -> None:
    document = scene(
        room(piece(), piece(id="bedroom_0/sofa_2"), piece(), piece(name="bed"), type="bedroom", openings=[{}, {"kind": "window"}, {}]),
        room(piece(), type="bedroom", index=0),
        room(type="bedroom", id="bedroom_0_2"),
        dynamic=[{}, {"kind": "dog"}, {}],
    )
    read = read_scene(document)
    assert [one.index for one in read.rooms] == [1, 0, 2]
    assert [one.id for one in read.rooms] == ["bedroom_1", "bedroom_0", "bedroom_0_2"]
    assert [body.id for body in read.rooms[0].furniture] == ["bedroom_1/sofa_1", "bedroom_0/sofa_2", "bedroom_1/sofa_2", "bedroom_1/bed_1"]
    assert [body.id for body in read.rooms[1].furniture] == ["bedroom_0/sofa_1"]
    assert [one.id for one in read.rooms[0].openings] == ["bedroom_1/door_1", "bedroom_1/window_1", "bedroom_1/door_2"]
    assert [body.id for body in read.dynamic] == ["person_1", "dog_1", "person_2"]
    assert read_scene(document) == read
    assert read_scene(write_scene(read)) == read


def test_a_made_up_room_id_gives_way_to_a_given_one() -> None:
    read = read_scene(scene(room(id="room_1"), room(), room(id="room_1_2")))
    assert [one.id for one in read.rooms] == ["room_1", "room_1_3", "room_1_2"]


@pytest.mark.parametrize(
    ("document", "field"),
    [
        (scene(room(piece(id="a"), piece(id="a"))), "rooms[0].furniture[1].id"),
        (scene(room(piece(id="a")), room(piece(id="a"))), "rooms[1].furniture[0].id"),
        (scene(room(piece(id="a"), decorations=[piece(id="a")])), "rooms[0].decorations[0].id"),
        (scene(room(piece(id="a")), dynamic=[{"id": "a"}]), "dynamic[0].id"),
        (scene(room(id="a"), room(id="a")), "rooms[1].id"),
        (scene(room(openings=[{"id": "a", "wall": "north"}, {"id": "a", "wall": "south"}])), "rooms[0].openings[1].id"),
    ],
)
def test_ids_given_twice_are_refused(document: dict[str, Any], field: str) -> None:
    error = refused(document)
    assert error.field == field
    assert "'a'" in error.problem


def test_levels_of_one_index_are_refused() -> None:
    error = refused(scene(room(), levels=[{"index": 0}, {"index": 1}, {"index": 0}]))
    assert (error.field, error.problem) == ("levels[2].index", "is 0, which another level has too")


def test_a_room_alone_names_its_own_field_where_an_id_is_given_twice() -> None:
    with pytest.raises(FieldError) as wrong:
        read(PlaceBody, {"room": room(piece(id="a"), piece(id="a")), "pieces": []})
    assert wrong.value.field == "room.furniture[1].id"


def test_both_rooms_of_a_door_list_it_under_one_id() -> None:
    read = read_scene(scene(room(openings=[{"id": "d"}, {}]), room(openings=[{"id": "d"}])))
    assert [one.openings[0].id for one in read.rooms] == ["d", "d"]


# --- refusing ----------------------------------------------------------------------------------------------------------
WRONG_NUMBERS = ["1", True, None, [], {}, math.nan, math.inf, -math.inf, 10**400]


@every("value", [*WRONG_NUMBERS, 0, -1, 1000.001, 0.0, -0.0])
@every("key", ["width", "depth", "height"])
def test_sizes_are_positive_and_at_most_a_kilometre(key: str, value: Any) -> None:
    error = refused(scene(room(piece(**{key: value}))))
    assert error.field == f"rooms[0].furniture[0].{key}"
    assert error.allowed == "a number above 0, up to 1000"


@every("value", [*WRONG_NUMBERS, 1e7, -1e300])
def test_places_are_numbers_near_the_house(value: Any) -> None:
    error = refused(scene(room(piece(x=value))))
    assert (error.field, error.allowed) == ("rooms[0].furniture[0].x", "a number from -1000000 to 1000000")


@pytest.mark.parametrize(
    ("document", "field"),
    [
        (None, "scene"),
        ([], "scene"),
        ("x", "scene"),
        ({"rooms": {}}, "rooms"),
        ({"rooms": [3]}, "rooms[0]"),
        ({1: 2}, "scene"),
        (scene(format="glTF"), "format"),
        (scene(seed="7"), "seed"),
        (scene(seed=1.5), "seed"),
        (scene(request=[]), "request"),
        (scene(wall_thickness=-0.1), "wall_thickness"),
        (scene(size={"width": 3}), "size.depth"),
        (scene(corridors=[1]), "corridors[0]"),
        (scene(adjacency=[[0, "1"]]), "adjacency[0][1]"),
        (scene(adjacency=[[0]]), "adjacency[0][1]"),
        (scene(certificate={"cost": math.nan}), "certificate.cost"),
        (scene(note={"a": [{"b": math.inf}]}), "note.a[0].b"),
        (scene(note={1, 2}), "note"),
        (scene(note="\ud800"), "note"),
        (scene(room(piece(id="\udfff"))), "rooms[0].furniture[0].id"),
        (scene(room(piece(id=5))), "rooms[0].furniture[0].id"),
        (scene(room(piece(locked=1))), "rooms[0].furniture[0].locked"),
        (scene(room(piece(wall="up"))), "rooms[0].furniture[0].wall"),
        (scene(room(index=1.5)), "rooms[0].index"),
        (scene(room(index=True)), "rooms[0].index"),
        (scene(room(outline=[[0, 0], [1, 0], [1, 1]])), "rooms[0].outline"),
        (scene(room(outline=[[0, 0], [1, 0], [1, 1], [0.5, 2]])), "rooms[0].outline[2]"),
        (scene(room(outline=[[0, 0], [1, 0], [2, 0], [3, 0]])), "rooms[0].outline"),
        (scene(room(outline=[[0, 0], [1, 0], [1, 1], [1, 0]])), "rooms[0].outline"),
        (scene(room(outline=[[0, 0], [1, 0], [1, 1], [0, 1], [0, 1]])), "rooms[0].outline[3]"),
        (scene(room(outline=[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]])), "rooms[0].outline[4]"),
        (scene(room(outline=[[0, 0], [1, 0], [1, 1], [0, 1, 2]])), "rooms[0].outline[3]"),
        (scene(room(openings=[{"edge": 0}])), "rooms[0].openings[0].edge"),
        (scene(room(openings=[{"edge": 4}], outline=[[0, 0], [1, 0], [1, 1], [0, 1]])), "rooms[0].openings[0].edge"),
        (scene(room(openings=[{"kind": "hatch"}])), "rooms[0].openings[0].kind"),
        (scene(room(openings=[{"swing": "up"}])), "rooms[0].openings[0].swing"),
        (scene(dynamic=[{"height": 0}]), "dynamic[0].height"),
    ],
)
def test_what_is_wrong_is_named(document: object, field: str) -> None:
    error = refused(document)
    assert error.field == field
    assert error.problem
    assert error.allowed


@pytest.mark.parametrize(
    ("document", "format"),
    [
        ({"type": "FeatureCollection", "features": []}, "geojson"),
        ({"rooms": [{"floorPolygon": [], "width": 4, "depth": 3}]}, "procthor"),
        ({"room_type": [], "boxes": [], "edges": [], "ed_rm": []}, "rplan"),
    ],
)
def test_a_plan_of_another_program_is_told_to_be_one(document: object, format: str) -> None:
    assert refused(document).problem == f"is a floor plan of the format {format}"


def test_choices_are_listed() -> None:
    assert refused(scene(room(piece(wall="up")))).allowed == "north, south, east, west"


def test_an_unknown_key_is_told_beside_those_there_are_also_where_null_may_stand() -> None:
    told = refused(scene(room(exterior_walls={"nort": True})))
    assert (told.field, told.problem) == ("rooms[0].exterior_walls.nort", "is not known; north?")
    assert told.allowed == "north, south, east, west"


def test_whole_numbers_may_be_written_with_a_point() -> None:
    assert read_scene(scene(room(index=3.0))).rooms[0].index == 3


def test_nesting_is_limited_without_recursion() -> None:
    deep: Any = 1
    for _ in range(5000):
        deep = [deep]
    assert refused(scene(note=deep)).field.startswith("note[0][0]")


def nodes(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    inner = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [path] + [found for key, item in inner for found in nodes(item, (*path, key))]


def replaced(value: Any, path: tuple[Any, ...], new: Any) -> Any:
    if not path:
        return new
    copied = dict(value) if isinstance(value, dict) else list(value)
    copied[path[0]] = replaced(value[path[0]], path[1:], new)
    return copied


WHOLE_SCENE = write_scene(
    read_scene(
        scene(
            room(piece(), openings=[{}], decorations=[piece()], outline=[[0, 0], [4, 0], [4, 3], [0, 3]], flooring={}, wall_flags={}),
            size={"width": 4, "depth": 3},
            levels=[{}],
            dynamic=[{}],
            adjacency=[[0, 0]],
            request={"seed": 1},
            corridors=[{"from": 1}],
        )
    )
)
JUNK = PLAIN | st.sampled_from([math.nan, math.inf, -1, 0, 1e9, 10**400, True, "\ud800", b"", (), set(), object()])


@examples(100)
@given(st.sampled_from(nodes(WHOLE_SCENE)), JUNK)
def test_a_scene_with_anything_anywhere_is_read_or_refused(path: tuple[Any, ...], junk: Any) -> None:
    """Never another error; and what is refused is named at the place, or inside it."""
    document = replaced(WHOLE_SCENE, path, junk)
    try:
        read = read_scene(document)
    except SceneError as error:
        assert error.problem and error.field
    else:
        assert read_scene(write_scene(read)) == read


def test_reading_takes_time_in_proportion() -> None:
    """Ten times the pieces take about ten times as long: their ids are made up without looking back."""

    def seconds(count: int) -> float:
        document = scene(room(*[piece()] * count))
        start = time.process_time()
        read_scene(document)
        return time.process_time() - start

    small = min(seconds(400) for _ in range(5))
    assert min(seconds(4000) for _ in range(3)) < 60 * small


# --- requests ----------------------------------------------------------------------------------------------------------
def test_a_request_may_say_nothing_or_everything() -> None:
    assert read_request({}) == Request()
    everything = {
        "seed": 5,
        "width": 12,
        "depth": 9.5,
        "minRoomSize": 2.4,
        "maxDepth": 4,
        "useSpine": False,
        "outdoor": True,
        "decorate": True,
        "forceTypes": {"0": "office", 2: "kitchen"},
        "robotWidth": 0.5,
    }
    request = Request(5, 12.0, 9.5, 2.4, 4, False, True, True, {0: "office", 2: "kitchen"}, 0.5)
    assert read_request(everything) == request
    snake = {"min_room_size": 2.4, "max_depth": 4, "use_spine": False, "force_types": {0: "office", "2": "kitchen"}, "robot_width": 0.5}
    assert read_request({"seed": 5, "width": 12, "depth": 9.5, "outdoor": True, "decorate": True, **snake}) == request


@pytest.mark.parametrize(
    ("document", "field"),
    [
        (None, "request"),
        ([], "request"),
        ({"sed": 1}, "sed"),
        ({"useOllama": True}, "useOllama"),
        ({"seed": -1}, "seed"),
        ({"seed": MAX_SEED + 1}, "seed"),
        ({"seed": 1.5}, "seed"),
        ({"seed": "1"}, "seed"),
        ({"seed": True}, "seed"),
        ({"width": 1e9}, "width"),
        ({"width": 1.99}, "width"),
        ({"depth": math.nan}, "depth"),
        ({"depth": math.inf}, "depth"),
        ({"width": "20"}, "width"),
        ({"max_depth": 60000}, "max_depth"),
        ({"maxDepth": 17}, "max_depth"),
        ({"max_depth": 2.5}, "max_depth"),
        ({"min_room_size": 1.4}, "min_room_size"),
        ({"min_room_size": 51}, "min_room_size"),
        ({"width": 4, "min_room_size": 5}, "min_room_size"),
        ({"minRoomSize": 5, "min_room_size": 5}, "min_room_size"),
        ({"use_spine": "yes"}, "use_spine"),
        ({"use_spine": 1}, "use_spine"),
        ({"force_types": ["office"]}, "force_types"),
        ({"force_types": {"x": "office"}}, "force_types.x"),
        ({"force_types": {-1: "office"}}, "force_types[-1]"),
        ({"force_types": {True: "office"}}, "force_types[1]"),
        ({"force_types": {"0": 3}}, "force_types[0]"),
        ({"force_types": {"0": "office", 0: "kitchen"}}, "force_types[0]"),
        ({"robot_width": 0}, "robot_width"),
        ({"program": ["family"]}, "program"),
        ({"program": {"bedrooms": -1}}, "program.bedrooms"),
        ({"program": {"bedrooms": True}}, "program.bedrooms"),
        ({"program": {3: 1}}, "program[3]"),
        ({"area": 14.9}, "area"),
        ({"area": "large"}, "area"),
        ({"style": 1}, "style"),
    ],
)
def test_what_is_wrong_with_a_request_is_named(document: object, field: str) -> None:
    with pytest.raises(RequestError) as caught:
        read_request(document)
    assert caught.value.field == field
    assert caught.value.problem
    assert caught.value.allowed
    assert isinstance(caught.value, FieldError)


def test_the_default_room_size_shrinks_with_the_house() -> None:
    assert read_request({"width": 2, "depth": 2.5}).min_room_size == 2.0
    assert read_request({"width": 2, "depth": 2.5, "min_room_size": 2}).min_room_size == 2.0


def test_a_programme_is_a_presets_name_or_counts() -> None:
    assert read_request({"program": "family", "area": 120, "style": "modern"}) == Request(program="family", area=120.0, style="modern")
    assert read_request({"program": {"bedrooms": 3.0, "garage": 2}}).program == {"bedrooms": 3, "garage": 2}
    assert read_request({"program": {}}).planned and not read_request({"program": None}).planned
    assert read_request({"program": "studio", "width": 2, "depth": 2}).min_room_size == 3.0
