"""SVG drawings of others: what shapes are is told by names around them, how long a unit is by the file or by doors."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

import pytest

from catalogs import load_catalogs
from compose_homes import import_plan
from solver.answers import PlanImport
from solver.errors import FieldError
from tests.imports.plans import box, collection, opening, read, rooms_of

SVG = "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' {}>{}</svg>"
TWO_ROOMS = """<g class='rooms'><rect x='10' y='10' width='80' height='60'/><rect x='90' y='10' width='80' height='60'/></g>
    <text x='40' y='40'>Schlafzimmer 1</text><text><tspan x='120' y='40'>Bad</tspan></text><text x='40' y='50'>12.0 m2</text>
    <g id='doors'><line x1='90' y1='30' x2='90' y2='48'/></g>"""


def drawn(body: str, more: str = "viewBox='0 0 200 120'", **settings: object) -> PlanImport:
    return read(SVG.format(more, body).encode(), "plan.svg", **settings)


def sizes_of(answer: PlanImport) -> list[tuple[str, float, float, float, float]]:
    return [(room.type, room.x, room.z, room.width, room.depth) for room in answer.scene.rooms]


def test_groups_name_shapes_and_texts_name_rooms() -> None:
    answer = drawn(TWO_ROOMS, unit="0.05")
    assert answer.format == "svg"
    assert sizes_of(answer) == [("bedroom", 0.0, 0.0, 4.0, 3.0), ("bathroom", 4.0, 0.0, 4.0, 3.0)]
    door = opening(answer.scene.rooms[0], "door_0")
    assert (door.wall, door.width, door.connects_to) == ("east", 0.9, answer.scene.rooms[1].id)


def test_a_bed_in_a_room_is_no_room_and_one_beside_it_is() -> None:
    rooms = "<rect id='{}' x='10' y='10' width='80' height='60'/><rect id='bath' x='90' y='10' width='80' height='60'/>"
    pieces = "<rect id='bed' x='20' y='20' width='30' height='40'/><g id='furniture'><rect id='bath' x='95' y='15' width='9' height='30'/>"
    door = "</g><g id='doors'><line x1='90' y1='30' x2='90' y2='48'/></g>"
    for name, kind in {"bedroom": "bedroom", "bed_2": "bedroom", "kids_room": "kids_bedroom"}.items():
        answer = drawn(rooms.format(name) + pieces + door, unit="0.05")
        assert sizes_of(answer) == [(kind, 0.0, 0.0, 4.0, 3.0), ("bathroom", 4.0, 0.0, 4.0, 3.0)]
        assert [one["place"] for one in answer.unread] == ["layer 'bed'", "layer 'furniture'"]


def test_a_bath_in_a_bedroom_and_what_is_called_a_room_are_rooms() -> None:
    home = "<rect id='apartment' class='room' width='160' height='120'/><rect id='bedroom' width='80' height='120'/>"
    rooms = "<rect id='bath' x='40' width='40' height='40'/><rect id='bed' class='room' x='2' y='2' width='30' height='40'/>"
    answer = drawn(home + rooms + "<rect id='bed_2' x='80' width='80' height='60'/>", unit="0.05")
    assert sorted(one.type for one in answer.scene.rooms) == ["bathroom", "bedroom", "bedroom", "bedroom", "room"]


@pytest.mark.parametrize(("said", "kind"), [("Door None", "passage"), ("Door Swing Beside", "door")])
def test_a_door_that_is_called_none_is_a_passage(said: str, kind: str) -> None:
    answer = drawn(TWO_ROOMS.replace("id='doors'", f"id='Door' class='{said}'"), unit="0.05")
    assert [one.kind for one in answer.scene.rooms[0].openings] == [kind]


@pytest.mark.parametrize("scale", [20, 50, 100])
def test_a_sheet_of_paper_is_to_the_scale_that_makes_doors_doors(scale: int) -> None:
    wide, high = 200 * 50 / scale, 120 * 50 / scale
    answer = drawn(TWO_ROOMS, f"viewBox='0 0 200 120' width='{wide / 10:g}cm' height='{high}mm'")
    assert sizes_of(answer) == sizes_of(drawn(TWO_ROOMS, unit="0.05"))
    (told,) = [guess for guess in answer.guesses if guess["what"] == "unit"]
    assert f"1:{scale}" in str(told["message"])


@pytest.mark.parametrize("said", ["100", "1:100"])
def test_a_sheet_may_say_its_scale(said: str) -> None:
    answer = drawn(TWO_ROOMS, f"viewBox='0 0 200 120' width='10cm' height='60mm' data-scale='{said}'")
    assert sizes_of(answer) == sizes_of(drawn(TWO_ROOMS, unit="0.05"))


@pytest.mark.parametrize("scale", [1.0, 1.9, 3.3])
def test_of_pixels_of_any_length_the_doors_tell_how_long_they_are(scale: float) -> None:
    """Doors are 18, 34 and 59 pixels wide: no inches or feet, whatever they come out at."""
    answer = drawn(f"<g transform='scale({scale})'>{TWO_ROOMS}</g>")
    assert sizes_of(answer) == sizes_of(drawn(TWO_ROOMS, unit="0.05"))
    (told,) = [guess for guess in answer.guesses if guess["what"] == "unit"]
    assert "doors' median width is taken as 0.90 m" in str(told["message"])
    assert float(str(told["taken"])) == pytest.approx(0.05 / scale, rel=1e-4)


def test_where_no_door_is_drawn_the_gaps_in_walls_tell_how_long_pixels_are() -> None:
    """Walls 0.3 m thick around 9 x 6 m, one of 0.1 m between two rooms with a gap of 0.9 m; a window 1.2 m wide."""
    walls = "M0 0 H60 V6 H6 V114 H174 V6 H84 V0 H180 V120 H0 Z M100 6 H102 V50 H100 Z M100 68 H102 V114 H100 Z"
    names = "<text x='40' y='60'>Kitchen</text><text x='140' y='60'>Bedroom</text>"
    answer = drawn(f"<path id='walls' d='{walls}'/><rect class='window' x='60' width='24' height='6'/>{names}")
    assert [(room.type, room.width) for room in answer.scene.rooms] == [("kitchen", 4.8), ("bedroom", 3.7)]
    (told,) = [guess for guess in answer.guesses if guess["what"] == "unit"]
    assert (told["taken"], "the median gap in walls is taken as 0.90 m" in str(told["message"])) == ("0.05", True)


def test_the_root_may_say_the_unit_and_elements_what_they_are() -> None:
    room = "<polygon data-room='laundry' data-id='wash' data-name='Utility' points='0,0 3,0 3,2 0,2'/>"
    said = "data-id='front' data-hinge='start' data-towards='1 1' data-main-entrance='true'"
    door = f"<line data-opening='door' x1='1' y1='2' x2='1.9' y2='2' {said}/>"
    answer = drawn(f"<g transform='scale(100)'>{room}{door}</g><circle class='room' r='900'/>", "data-unit='cm'")
    (found,) = answer.scene.rooms
    assert (found.id, found.type, found.width, found.depth, found.name) == ("wash", "laundry", 3.0, 2.0, "Utility")
    front = opening(found, "front")
    assert (front.wall, front.position, front.hinge, front.swing, front.main_entrance) == ("south", 1.45, "start", "in", True)


def test_shapes_are_rooms_by_the_names_of_the_callers_catalog(tmp_path: Path) -> None:
    """A closed shape called `gynaeceum` tells nothing to our catalogs."""
    file = (b"<svg xmlns='http://www.w3.org/2000/svg' data-unit='cm'><rect id='kitchen' width='300' height='300'/>"
            b"<rect id='gynaeceum' x='300' width='400' height='300'/></svg>")  # fmt: skip
    (tmp_path / "room_names.yaml").write_text("bedroom: {known_as: [gynaeceum]}", encoding="utf-8")
    ours, theirs = (import_plan(file, "plan.svg", catalogs=one).scene.rooms for one in (None, load_catalogs(tmp_path)))
    assert [room.type for room in ours] == ["kitchen"]
    assert [room.type for room in theirs] == ["kitchen", "bedroom"]


def test_transforms_uses_and_inner_drawings_are_worked_out() -> None:
    body = """<defs><symbol id='unit'><rect width='200' height='150'/></symbol></defs>
      <use xlink:href='#unit' id='kitchen' transform='translate(100 50)'/>
      <g id='Wohnzimmer' transform='matrix(2 0 0 2 300 50)'><path d='m0,0 h100 v75 h-100 z'/></g>
      <svg x='100' y='200' width='400' height='300' viewBox='0 0 40 30'><rect class='room' id='bathroom' width='40' height='30'/></svg>
      <g class='doors'><line x1='0' x2='90' transform='translate(300, 80) rotate(90)'/></g>"""
    answer = drawn(body, "data-unit='cm'")
    assert sizes_of(answer) == [("kitchen", 0.0, 0.0, 2.0, 1.5), ("living_room", 2.0, 0.0, 2.0, 1.5), ("bathroom", 0.0, 1.5, 4.0, 3.0)]
    door = opening(answer.scene.rooms[0], "door_0")
    assert (door.wall, door.position, door.width) == ("east", 0.75, 0.9)


@pytest.mark.parametrize("used", ["#nothing", "http://localhost/symbols.svg#kitchen", "", "xkitchen", "kitchen"])
def test_what_is_drawn_in_another_file_is_left_out(used: str) -> None:
    use = f"<use href='{used}' x='400'/>"
    answer = drawn(f"<rect class='room' id='kitchen' width='300' height='300'/>{use * 3}", "data-unit='cm'")
    assert sizes_of(answer) == [("kitchen", 0.0, 0.0, 3.0, 3.0)]
    assert [one for one in answer.unread if "use" in one["reason"]] == [
        {"place": "use[0]", "reason": "uses of what is not in the file draw nothing: 3"}
    ]


@pytest.mark.parametrize(
    "unseen", ["<g id='a' display='none'><rect width='9' height='9'/></g>", "<linearGradient id='a'/>", "<image id='a'/>"]
)
def test_what_is_in_the_file_is_not_said_to_be_elsewhere(unseen: str) -> None:
    answer = drawn(f"<defs>{unseen}</defs><rect class='room' id='kitchen' width='300' height='300'/><use href='#a'/>", "data-unit='cm'")
    assert [one for one in answer.unread if "file" in one["reason"]] == []


def test_a_worktop_with_a_round_end_on_no_layer_is_no_door() -> None:
    boxes = ((0, 0, 900, 500), (30, 30, 410, 440), (450, 30, 420, 440))
    walls = "".join(f"<rect x='{x}' y='{y}' width='{wide}' height='{high}'/>" for x, y, wide, high in boxes)
    names = "<text x='200' y='250'>Kitchen</text><text x='650' y='250'>Bedroom</text>"
    leaf, worktop = "<path d='M440 200 h-90 a90 90 0 0 1 90 -90'/>", "<path d='M30 30 h60 v90 a60 60 0 0 1 -60 60 z'/>"
    rooms = drawn(f"{walls}{leaf}{worktop}{names}", "data-unit='cm'").scene.rooms
    assert [(room.type, [(one.kind, one.width) for one in room.openings]) for room in rooms] == [
        ("kitchen", [("door", 0.9)]), ("bedroom", [("door", 0.9)])
    ]  # fmt: skip


def test_a_door_beside_a_corner_is_shut_in_the_gap_of_its_wall() -> None:
    """Open, its leaf is nearer to the wall that it swings to than shut to the faces of its own."""
    rooms = "<g class='rooms'><rect width='300' height='300'/><rect x='310' width='200' height='300'/></g>"
    walls = "<g class='walls'><rect x='300' width='10' height='4'/><rect x='300' y='84' width='10' height='216'/></g>"
    answer = drawn(f"{rooms}{walls}<path class='door' d='M305 84 A80 80 0 0 0 385 4'/>", "data-unit='cm'")
    (door,) = answer.scene.rooms[0].openings
    assert (door.kind, door.wall, door.width, door.connects_to) == ("door", "east", 0.8, answer.scene.rooms[1].id)


def test_a_door_across_the_way_of_a_gap_is_no_leaf_of_it() -> None:
    """It lies in a wall: an open leaf would hang at the corner of the gap."""
    wall = "<rect class='wall' x='{}' y='{}' width='{}' height='{}'/>"
    parts = (
        (-8, 0, 8, 400), (212, 0, 8, 400), (220, 196, 200, 8), (420, 0, 8, 400), (-40, 196, 40, 8), (-8, -8, 436, 8), (-8, 400, 436, 8),
    )  # fmt: skip
    rooms = (
        "<rect class='room' width='212' height='400'/><rect class='room' x='220' width='200' height='196'/>"
        "<rect class='room' x='220' y='204' width='200' height='196'/>"
    )
    doors = "<rect class='door' x='212' y='230' width='8' height='90'/><rect class='door' x='212' y='40' width='8' height='90'/>"
    answer = drawn(rooms + "".join(wall.format(*part) for part in parts) + doors, "data-unit='cm'")
    assert [one.width for one in answer.scene.rooms[0].openings] == [0.9, 0.9]


@pytest.mark.parametrize(
    ("transform", "corners"),
    [
        ("skewX(45)", "0 0 4 0 1 3 -3 3"),
        ("skewY(45)", "0 0 4 -4 4 -1 0 3"),
        ("rotate(90 4 0)", "4 4 4 0 7 0 7 4"),
        ("translate(3) scale(.5 -1)", "-6 0 2 0 2 -3 -6 -3"),
    ],
)
def test_every_step_of_a_transform_makes_a_room_of_four_by_three_metres(transform: str, corners: str) -> None:
    body = f"<polygon id='kitchen' points='{corners}' transform='{transform}'/><rect id='bedroom' x='4' width='3' height='3'/>"
    answer = drawn(body, "data-unit='m'")
    assert sizes_of(answer) == [("kitchen", 0.0, 0.0, 4.0, 3.0), ("bedroom", 4.0, 0.0, 3.0, 3.0)]


def test_a_wrong_element_is_named_by_its_number_among_those_of_its_tag() -> None:
    with pytest.raises(FieldError, match=r"rect\[2\] 'third'"):
        drawn("<rect class='room' width='4' height='3'/><g/><rect/><rect id='third' transform='spin(3)'/>")


def test_the_arc_of_a_leaf_is_a_door_and_rooms_between_walls_are_grown() -> None:
    rooms = "<rect id='kitchen' width='400' height='300'/><rect id='bedroom' x='412' width='400' height='300'/>"
    quarter = "a 90 90 0 0 1 90 90", "c 49.7 0 90 40.3 90 90"
    for arc in quarter:
        answer = drawn(f"{rooms}<g id='door'><path d='M406 100 v-90 {arc}'/></g><path id='sofa' class='furniture' d='M1 1h9v9z'/>", "")
        kitchen, bedroom = rooms_of(answer).values()
        assert (answer.scene.wall_thickness, kitchen.width, bedroom.x) == (0.12, 4.12, 4.12)
        door = opening(kitchen, "door_0")
        assert (door.wall, door.width, door.hinge, door.swing) == ("east", 0.9, "end", "out")
        assert [left["place"] for left in answer.unread] == ["layer 'furniture|sofa'"]


def test_a_drawing_that_is_turned_is_turned_back() -> None:
    answer = drawn(
        "<g transform='rotate(30)'><rect class='room' width='400' height='300'/><rect class='door' x='10' width='90' height='8'/></g>", ""
    )
    ((_, _, _, *size),) = sizes_of(answer)
    assert sorted(size) == [3.0, 4.0]
    (door,) = answer.scene.rooms[0].openings
    assert abs(door.width - 0.9) <= 0.001


def test_classes_of_groups_tell_what_their_parts_are() -> None:
    """Drawings for training recognition keep openings within walls, and call rooms by the classes of groups."""
    body = """<g class='Model'><g id='First_Floor' class='Floorplan Floor-1'>
      <g id='Wall' class='Wall External'><polygon points='0,0 800,0 800,20 0,20'/>
        <g class='Window Regular'><polygon points='100,0 250,0 250,20 100,20'/>
          <g class='Glass'><polygon points='100,8 250,8 250,12 100,12'/></g></g></g>
      <g id='Wall' class='Wall'><polygon points='400,20 412,20 412,380 400,380'/>
        <g class='Door Swing Beside'><polygon points='400,100 412,100 412,190 400,190'/>
          <g class='Panel Left'><path d='M412,100 q90,0 90,90 l-90,0 Z'/></g></g></g>
      <g class='Wall External'><g class='Door'><polygon points='600,380 690,380 690,400 600,400'/></g></g>
      <g id='s1' class='Space Kitchen'><polygon points='20,20 400,20 400,380 20,380'/>
        <g class='NameLabel'><text x='90' y='90'>K</text></g></g>
      <g id='s2' class='Space LivingRoom'><polygon points='412,20 780,20 780,380 412,380'/></g>
      <g class='FixedFurniture BaseCabinet'><polygon points='20,20 80,20 80,200 20,200'/></g></g></g>"""
    answer = drawn(body)
    kitchen, living = rooms_of(answer).values()
    assert (kitchen.type, living.type, answer.scene.wall_thickness) == ("kitchen", "living_room", 0.12)
    assert [(one.kind, one.wall, one.width) for one in kitchen.openings] == [("door", "east", 0.9), ("window", "north", 1.5)]
    assert (opening(kitchen, "door_0").hinge, opening(kitchen, "door_0").swing) == ("end", "out")
    assert opening(living, "door_1").main_entrance
    assert [guess["taken"] for guess in answer.guesses if guess["what"] == "unit"] == ["cm"]


ILLUSTRATOR = """<?xml version="1.0" encoding="{}"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [
    <!ENTITY ns_svg "http://www.w3.org/2000/svg">
    <!ENTITY ns_label "K&#252;che">
]>
<svg xmlns="&ns_svg;" data-unit="m">
<style type="text/css">
    /* .shown{{display:none}} */ @media print {{ .shown {{ display: none }} }}
    .st0{{display:none;}} .st1, #old_kitchen {{ fill:#fff; visibility : hidden }} .shown{{display:inline;}}
</style>
<g id="rooms"><rect class="shown" width="4" height="3"/><g class="st0"><rect x="4" width="2" height="3"/></g>
<rect class="st2 st1" x="4" width="2" height="3"/><rect id="old_kitchen" x="4" width="2" height="3"/></g>
<text x="1" y="1">&ns_label;</text></svg>"""


@pytest.mark.parametrize("how", ["utf-8", "utf-16", "utf-16-le", "utf-16-be", "gzip"])
def test_files_of_drawing_programmes_are_read_as_they_are_stored(how: str) -> None:
    text = ILLUSTRATOR.format("UTF-16" if "16" in how else "utf-8")
    content = gzip.compress(text.encode()) if how == "gzip" else text.encode(how)
    answer = read(content, "plan.svgz" if how == "gzip" else "plan.svg")
    assert answer.format == "svg"
    assert sizes_of(answer) == [("kitchen", 0.0, 0.0, 4.0, 3.0)]
    assert answer.scene.rooms[0].name == "Küche"


def test_other_formats_are_read_as_they_are_stored() -> None:
    room = "<room name='Kitchen'><point x='0' y='0'/><point x='400' y='0'/><point x='400' y='300'/><point x='0' y='300'/></room>"
    home = f"<?xml version='1.0' encoding='UTF-16'?><home version='6000'>{room}</home>"
    assert sizes_of(read(home.encode("utf-16"), "Home.xml")) == [("kitchen", 0.0, 0.0, 4.0, 3.0)]
    plan = collection(box("Kitchen", 0, 0, 4, 3))
    assert sizes_of(read(gzip.compress(json.dumps(plan).encode()), "plan.geojson.gz")) == [("kitchen", 0.0, 0.0, 4.0, 3.0)]
    assert sizes_of(read(json.dumps(plan).encode("utf-16"), "plan.geojson")) == [("kitchen", 0.0, 0.0, 4.0, 3.0)]


def test_the_frame_of_a_window_is_no_window() -> None:
    frames = "".join(
        f"<path class='window' d='M{x} 9.3 V10.7'/><rect class='window' x='{x}' y='9.8' width='0.4' height='0.4'/>" for x in (15, 75)
    )
    body = TWO_ROOMS + f"<g class='window'><line x1='25' y1='10' x2='49' y2='10'/>{frames}</g>"
    answer = drawn(body, unit="0.05")
    windows = [one.width for room in answer.scene.rooms for one in room.openings if one.kind == "window"]
    assert windows == [1.2]
    assert sum("a part of one, such as its frame" in str(one["reason"]) for one in answer.unread) >= 2


def test_a_group_that_says_it_is_a_room_draws_none_and_keeps_nothing_from_being_read_and_told() -> None:
    """Others put `data-room` on the group of a room's walls; their walls are read, and what is left out is listed as ever."""
    sides = ((0, 0, 4, 0.1), (0, 2.9, 4, 3), (0, 0, 0.1, 3), (3.9, 0, 4, 3))
    walls = "".join(f"<rect class='wall' x='{a}' y='{b}' width='{c - a}' height='{d - b}'/>" for a, b, c, d in sides)
    svg = (
        "<svg xmlns='http://www.w3.org/2000/svg' data-unit='m'><g class='room' data-room='Bath'>{}<text x='1' y='1'>Bath</text></g>{}</svg>"
    )
    answer = read(svg.format(walls, "<rect class='stuff' width='1' height='1'/>").encode(), "plan.svg")
    assert [(room.type, room.width, room.depth) for room in answer.scene.rooms] == [("bathroom", 3.9, 2.9)]
    assert [one["place"] for one in answer.unread] == ["layer 'stuff'"]


def boxed(*boxes: tuple[str, int, int, int, int], texts: str) -> list[tuple[str, float, float]]:
    """The rooms of a drawing of boxes without names, in cm, and texts in them."""
    shapes = "".join(f"<rect {name} x='{x}' y='{z}' width='{width}' height='{depth}'/>" for name, x, z, width, depth in boxes)
    answer = read(f"<svg xmlns='http://www.w3.org/2000/svg' data-unit='cm'>{shapes}{texts}</svg>".encode(), "plan.svg")
    return [(room.type, room.width, room.depth) for room in answer.scene.rooms]


TEXTS = "<text x='120' y='120'>Kitchen</text><text x='520' y='120'>Bedroom</text><text x='550' y='250'>Oak</text>"
SHEET = ("", -300, -300, 1500, 900)


def test_boxes_around_names_of_rooms_are_rooms_where_nothing_is_called_one() -> None:
    """A sheet's frame is around both; a bed and the frame of a text are smaller; what no name of a room stands in is none."""
    rooms = [("", 0, 0, 400, 300), ("", 400, 0, 300, 300)]
    others = [SHEET, ("", 500, 90, 160, 200), ("", 100, 100, 60, 30), ("", 900, 0, 200, 200)]
    assert boxed(*others[:2], *rooms, *others[2:], texts=TEXTS) == [("kitchen", 4.0, 3.0), ("bedroom", 3.0, 3.0)]
    one = boxed(SHEET, rooms[0], texts="<text x='120' y='120'>Kitchen</text>")
    assert one == [("kitchen", 4.0, 3.0)]


def test_boxes_around_names_are_none_where_something_is_called_a_room() -> None:
    found = boxed(("class='room' id='hallway'", 0, 0, 400, 300), ("", 400, 0, 300, 300), texts=TEXTS)
    assert [kind for kind, *_ in found] == ["hallway"]


def test_a_room_is_known_by_a_class_that_only_holds_its_name() -> None:
    assert [kind for kind, *_ in boxed(("class='Space Bath Shower'", 0, 0, 400, 300), texts="")] == ["bathroom"]


def test_shapes_are_counted_while_they_are_read() -> None:
    """What comes behind too many is not looked at: names cost more than anything else of a drawing."""
    walls = "".join(f"<rect id='wall {at}' width='4' height='3'/>" for at in range(6_000))
    with pytest.raises(FieldError, match=r"shapes: are 5,001 \(allowed: at most 5,000\)"):
        read(f"<svg xmlns='http://www.w3.org/2000/svg'>{walls}</svg>".encode())


def test_a_path_that_cannot_be_read_is_named_by_what_it_says() -> None:
    with pytest.raises(FieldError) as refused:
        drawn("<path class='room' d='M0 0 L x'/>")
    assert (refused.value.field, refused.value.problem, refused.value.allowed) == ("path[0].d", "is 'M0 0 L x'", "the data of a path")
