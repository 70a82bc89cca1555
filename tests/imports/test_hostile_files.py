"""Broken and hostile files are refused with the place or read without what is wrong, in bounded work and memory; all is told in German.

No clock is asked: each file is read under a limit on Python's own function calls, far above what any plan needs.
"""

from __future__ import annotations

import gzip
import json
import re
import sys
import tracemalloc
from collections.abc import Callable
from io import BytesIO
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile

import ezdxf.filemanagement
import pytest

from catalogs import load_catalogs
from solver.errors import ComposeError, FieldError, SyntaxFault
from solver.imports.formats import dxf_reading, ifc_reading
from tests.imports.hostile_buildings import (
    dxf_block,
    dxf_insert,
    dxf_line,
    dxf_of,
    ifc_of_a_large_shape_often,
    ifc_of_a_room_within_itself,
    ifc_of_a_way_without_a_length,
    ifc_of_axes_without_a_length,
    ifc_of_placements_in_a_ring,
    ifc_of_rooms_within_rooms,
    ifc_of_shapes_within_shapes,
)
from tests.imports.plans import Feature, box, collection, line, piece, polygon, read
from tests.imports.test_foreign_formats import apartment, packed, sweet_home
from tests.told_answers import untold_in_import, untold_in_refusal

MOST_CALLS = 5_000_000
MOST_MEMORY = 200 << 20
NAN, HUGE = float("nan"), 1e300
MANY_POINTS = "  0\nLWPOLYLINE\n  8\nroom\n" + " 10\n1\n 20\n1\n" * 100_001
KITCHEN = box("Kitchen", 0, 0, 4, 3)


def spoilt(change: Callable[[dict[str, Any]], Any]) -> bytes:
    """A plan with something wrong in it."""
    plan = collection(KITCHEN, line("door", (1, 0), (1.9, 0)), piece("Sofa", 2, 1, width=2, depth=0.9, height=0.8))
    change(plan)
    return json.dumps(plan).encode()


def with_points(points: object) -> bytes:
    return spoilt(lambda plan: plan["features"][0]["geometry"].update(coordinates=points))


def with_first(**said: object) -> bytes:
    return spoilt(lambda plan: plan["features"][0].update(said))


def many(count: int, make: Callable[[int], Feature]) -> Callable[[], bytes]:
    return lambda: json.dumps(collection(KITCHEN, *(make(at) for at in range(count)))).encode()


def bomb(name: str = "Home.xml") -> bytes:
    content = BytesIO()
    with ZipFile(content, "w", ZIP_DEFLATED) as archive:
        archive.writestr(name, b"<home>" + b" " * (200 << 20), compresslevel=1)
    return content.getvalue()


def zigzag(count: int) -> list[list[float]]:
    return [[at / count * 10, at % 2] for at in range(count)] + [[10.0, 5.0], [0.0, 5.0]]


LAUGHS = "".join(
    f"<!ENTITY a{at} '{'&a' + str(at - 1) + ';' if at else 'ha'}{('&a' + str(at - 1) + ';') * 9 if at else ''}'>" for at in range(10)
)
IFC = (
    b"ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('a','',(''),(''),'','','');\nFILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;\n"
    b"#1=IFCCARTESIANPOINT((0.,0.,0.));\nENDSEC;\nEND-ISO-10303-21;\n"
)
CORNERS = [{"x": x, "z": z} for x, z in ((0, 0), (4, 0), (4, 4))]
XXE = b"<!DOCTYPE home [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><home name='&x;'></home>"
XML_ROOM = "<room name='Kitchen'><point x='0' y='0'/><point x='400' y='0'/><point x='400' y='300'/></room>"


def svg(*elements: str, more: str = "") -> bytes:
    return f"<svg xmlns='http://www.w3.org/2000/svg' data-unit='m' {more}>{''.join(elements)}</svg>".encode()


def polyline(kind: str, count: int) -> Feature:
    return {"properties": {"kind": kind}, "geometry": {"type": "LineString", "coordinates": [[at / 50, at % 3] for at in range(count)]}}


def procthor(children: list[dict[str, Any]]) -> bytes:
    table = {"id": "Table|1", "position": {"x": 1, "y": 0.4, "z": 1}, "children": children}
    return json.dumps({"rooms": [{"id": "a", "roomType": "Kitchen", "floorPolygon": CORNERS}], "objects": [table]}).encode()


LINE = dxf_line(0, 0, 1, 0)
SVG_ROOM = "<rect id='kitchen' width='4' height='3'/>"
DOUBLED = "<use href='#a{0}'/><use href='#a{0}'/>"
SVG_DOOR = "<line data-opening='door' x1='1' y1='0' x2='1.9' y2='0' {}/>"

REFUSED: dict[str, bytes | Callable[[], bytes]] = {
    "empty": b"",
    "blank": b"   \n",
    "bytes": bytes(range(256)) * 40,
    "no json": b'{"type": "FeatureCollection", "features": [',
    "half a letter": b'{"type": "FeatureCollection", "features": ["\xff"]}',
    "a key twice": b'{"type": "FeatureCollection", "type": "FeatureCollection"}',
    "nested deeply": b"[" * 100_000 + b"]" * 100_000,
    "another document": b'{"hello": "world"}',
    "a list": b"[1, 2, 3]",
    "no features": b'{"type": "FeatureCollection"}',
    "features are text": b'{"type": "FeatureCollection", "features": "many"}',
    "nothing in it": json.dumps(collection()).encode(),
    "no rooms": json.dumps(collection(line("door", (0, 0), (1, 0)))).encode(),
    "feature is null": spoilt(lambda plan: plan["features"].append(None)),
    "no geometry": with_first(geometry=None),
    "another geometry": with_first(geometry={"type": "MultiPolygon", "coordinates": []}),
    "properties are a list": with_first(properties=[1]),
    "a name that is a number": with_first(properties={"name": 7}),
    "coordinates are text": with_points("0 0, 4 0"),
    "a point of one number": with_points([[[0, 0], [4], [4, 3]]]),
    "two corners": with_points([[[0, 0], [4, 0]]]),
    "not a number": with_points([[[0, 0], [4, NAN], [4, 3], [0, 3]]]),
    "infinite": with_points([[[0, 0], [float("inf"), 0], [4, 3], [0, 3]]]),
    "far away": with_points([[[0, 0], [HUGE, 0], [4, 3], [0, 3]]]),
    "a number of 5000 digits": with_points([[[0, 0], [int("9" * 4000), 0], [4, 3], [0, 3]]]),
    "a yes for a number": with_points([[[0, 0], [True, 0], [4, 3], [0, 3]]]),
    "a hole of two corners": with_points([[[0, 0], [4, 0], [4, 3], [0, 3]], [[1, 1], [2, 1]]]),
    "no floor": with_points([[[0, 0], [4, 0], [2, 0]]]),
    "a sliver": with_points([[[0, 0], [4, 0], [4, 0.05], [0, 0.05]]]),
    "wider than any house": with_points([[[0, 0], [4000, 0], [4000, 3], [0, 3]]]),
    "smaller than any house": with_points([[[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]]),
    "an unknown unit": spoilt(lambda plan: plan.update(unit="furlong")),
    "a unit that is nothing": spoilt(lambda plan: plan.update(unit="0")),
    "no unit and no likely size": json.dumps({**collection(box("Kitchen", 0, 0, 0.1, 0.1)), "unit": None}).encode(),
    "an unknown kind of line": spoilt(lambda plan: plan["features"][1]["properties"].update(kind="moat")),
    "a thickness that is text": spoilt(lambda plan: plan.update(wall_thickness="thick")),
    "a hundred thousand corners": with_points([[[0, 0]]]).replace(b"[0, 0]", b"[0,0]," * 99_999 + b"[1,1]"),
    "a thousand rooms": many(1_000, lambda at: box("Kitchen", at * 5, 0, at * 5 + 4, 3)),
    "ten thousand doors": many(10_000, lambda at: line("door", (at % 3, 0), (at % 3 + 0.9, 0))),
    "ten thousand chairs": many(10_000, lambda at: piece("Chair", 1, 1, width=0.4, depth=0.4, height=0.8)),
    "procthor without corners": json.dumps({"rooms": [{"id": "a", "floorPolygon": []}]}).encode(),
    "procthor with a lost wall": json.dumps({"rooms": [{"id": "a", "floorPolygon": CORNERS}], "doors": [{"wall0": "b"}]}).encode(),
    "rplan without owners": json.dumps({**apartment(), "ed_rm": []}).encode(),
    "rplan with a wrong owner": json.dumps({**apartment(), "ed_rm": [[99]] * 24}).encode(),
    "xml that laughs": f"<!DOCTYPE home [{LAUGHS}]><home name='&a9;'></home>".encode(),
    "xml that reads files": XXE,
    "xml that is cut off": sweet_home(XML_ROOM)[:-9],
    "xml with a number that is none": sweet_home(XML_ROOM.replace("'400'", "'four'")),
    "xml with nan": sweet_home(XML_ROOM.replace("'400'", "'nan'")),
    "xml of many elements": sweet_home("<a/>" * 201_000),
    "xml of many rooms": sweet_home(XML_ROOM * 2_000),
    "xml without rooms": sweet_home(),
    "a zip that is cut off": packed(Home_xml=sweet_home(XML_ROOM))[:60],
    "a zip without a home": packed(other=b"Home"),
    "a zip of two buildings": packed(**{"a.ifc": IFC, "b.IFC": IFC}),
    "a zip bomb": bomb,
    "a zip bomb of a building": lambda: bomb("house.ifc"),
    "a zip that is broken": packed(Home_xml=sweet_home(XML_ROOM)).replace(b"Kitchen", b"KitcheX"),
    "ifc that is cut off": IFC[:-40],
    "ifc without a head": b"ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n",
    "ifc without a schema": IFC.replace(b"IFC4", b"IFC9"),
    "ifc without rooms": IFC,
    "ifc of noise": IFC.replace(b"#1=", b"#1=#1=((("),
    "dxf that is cut off": b"  0\nSECTION\n  2\nENTITIES\n  0\nLWPOLYLINE\n 10\n",
    "dxf of noise": b"  0\nSECTION\n  2\nENTITIES\nxx\nyy\n",
    "svg that laughs": f"<!DOCTYPE svg [{LAUGHS}]><svg><text>&a9;</text></svg>".encode(),
    "svg that reads files": b"<!DOCTYPE svg [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><svg><text>&x;</text></svg>",
    "svg of a long text said often": b"<!DOCTYPE svg [<!ENTITY a '%s'>]><svg><text>%s</text></svg>" % (b"a" * 2_000, b"&a;" * 20_000),
    "svg of an entity of parts": b"<!DOCTYPE svg [<!ENTITY % a '<!ENTITY b \"c\">'> %a;]><svg><text>&b;</text></svg>",
    "a compressed file that is cut off": gzip.compress(svg(SVG_ROOM))[:60],
    "a compressed file that grows": lambda: gzip.compress(svg(" " * (200 << 20), SVG_ROOM), 1),
    "half of a wide character": svg(SVG_ROOM).decode().encode("utf-16")[:-1],
    "svg that is cut off": svg(SVG_ROOM)[:-9],
    "svg without rooms": svg("<rect width='4' height='3'/>"),
    "svg of a million points": svg(f"<polygon class='room' points='{'1,1 ' * 1_000_000}'/>"),
    "svg of a million segments": svg(f"<path class='room' d='M0 0{'h1v1' * 500_000}'/>"),
    "svg of many elements": svg(SVG_ROOM, "<g/>" * 201_000),
    "svg of many rooms": svg("<rect class='room' width='4' height='3'/>" * 1_000),
    "svg that draws itself": svg(SVG_ROOM, "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>"),
    "svg whose uses double": svg("<defs>", *(f"<g id='a{at}'>{DOUBLED.format(at - 1) if at else SVG_ROOM}</g>" for at in range(40)),
                                 "</defs><use href='#a39'/>"),
    "svg that is nested deeply": svg("<g>" * 1_000 + SVG_ROOM + "</g>" * 1_000),
    "svg of an endless scale": svg(f"<g transform='scale(1e300)'><g transform='scale(1e300)'>{SVG_ROOM}</g></g>"),
    "svg of an unknown transform": svg(f"<g transform='spin(3)'>{SVG_ROOM}</g>"),
    "svg of a transform without numbers": svg(f"<g transform='translate(nan, inf)'>{SVG_ROOM}</g>"),
    "svg with a path of noise": svg("<path class='room' d='M 0 0 L nan 4 z'/>"),
    "svg with a far path": svg("<path class='room' d='M 0 0 L 1e400 4 L 3 3 z'/>"),
    "svg with an unknown unit": svg(SVG_ROOM).replace(b"data-unit='m'", b"data-unit='furlong'"),
    "svg with a thickness that is none": svg(SVG_ROOM, more="data-wall-thickness='nan'"),
    "svg with an unknown opening": svg(SVG_ROOM, SVG_DOOR.format("").replace("'door'", "'moat'")),
    "svg with an opening that is no line": svg(SVG_ROOM, "<rect data-opening='door' width='1' height='1'/>"),
    "svg with an opening towards nothing": svg(SVG_ROOM, SVG_DOOR.format("data-towards='1'")),
    "svg with a height that is none": svg(SVG_ROOM, SVG_DOOR.format("data-height='high'")),
    "svg of commands without numbers": svg(f"<path class='room' d='M0 0{'z' * 1_000_000}'/>"),
    "svg of many texts": svg(SVG_ROOM, "<text x='1' y='1'>Kitchen</text>" * 5_001),
    "a thousand chairs in a room": many(1_001, lambda at: piece("Chair", 1 + at / 1e4, 1, width=0.4, depth=0.4, height=0.8)),
    "lines of many points each": many(200, lambda at: polyline("wall", 200)),
    "dxf of a block inserted a billion times": dxf_of(dxf_insert("door", 32_000, 32_000), dxf_block("door", LINE)),
    "dxf of an empty block inserted a billion times": dxf_of(dxf_insert("door", 32_000, 32_000), dxf_block("door", "")),
    "dxf of arrays within arrays": dxf_of(
        dxf_insert("outer door", 20, 20), dxf_block("door", LINE) + dxf_block("outer door", dxf_insert("door", 300, 300))),
    "dxf of an infinite count": dxf_of(dxf_insert("door", "1e999"), dxf_block("door", LINE)),
    "dxf of many parts": dxf_of(LINE * 151_000),
    "rplan of many rooms": json.dumps({**apartment(), "room_type": [2] * 100_000}).encode(),
    "procthor of many children": procthor([{"id": "Book|1", "position": {"x": 1, "y": 1, "z": 1}}] * 20_000),
    **{make.__name__: make for make in (ifc_of_placements_in_a_ring, ifc_of_a_room_within_itself, ifc_of_shapes_within_shapes,
                                        ifc_of_a_large_shape_often, ifc_of_axes_without_a_length, ifc_of_a_way_without_a_length)},
    "glb that is none": b"glTF" + bytes(40),
}  # fmt: skip


def content_of(file: bytes | Callable[[], bytes]) -> bytes:
    """Makes a file that is large only when it is read."""
    return file() if callable(file) else file


def bounded(work: Callable[[], Any], watched: bool = False) -> Any:
    """Does some work within a number of Python's calls and, where it is watched, an amount of memory."""
    load_catalogs()  # once for all work
    calls = 0

    def count(*_: object) -> None:  # of calls alone: no lines are traced of a function for which none is returned
        nonlocal calls
        calls += 1
        if calls > MOST_CALLS:
            raise AssertionError("more work than any plan needs")

    if watched:
        tracemalloc.start()
    sys.settrace(count)
    try:
        return work()
    finally:
        sys.settrace(None)
        most = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert most < MOST_MEMORY


def test_there_are_fifty() -> None:
    assert len(REFUSED) >= 50


@pytest.mark.parametrize("name", REFUSED)
def test_it_is_refused_with_words(name: str) -> None:
    content = content_of(REFUSED[name])

    def refused() -> ComposeError:
        with pytest.raises(FieldError) as caught:
            read(content)
        return caught.value

    error = bounded(refused, watched="zip" in name or "laughs" in name)
    assert error.field and error.problem
    assert "of many elements" not in name or "more than 200,000 elements" in error.problem
    assert not re.search("NoneType|object is|has no attribute|index out of", error.problem), "what Python says of itself"
    assert untold_in_refusal(error) == []


def test_a_long_name_is_told_in_quotes_that_end() -> None:
    """What stands between quotes nobody translates: cut off without the second it was no name."""
    name = "Kitchen with a name that nobody would ever write on a plan, however large it is"
    answer = read(spoilt(lambda plan: plan["features"][0]["properties"].update(name=name, type=None)))
    told = [guess["message"] for guess in answer.guesses if guess["what"] == "type"]
    assert told == [f"it is called '{name[:57]}…'"]


@pytest.mark.parametrize(
    ("drawn", "words"), [(dxf_line(0, 0, 1, 1) * 50_001, "50,000 entities"), (MANY_POINTS, "100,000 points")], ids=["entities", "points"]
)
def test_what_is_drawn_is_counted_before_the_drawing_is_built(drawn: str, words: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ezdxf.filemanagement, "read", None)
    with pytest.raises(SyntaxFault, match=words):
        dxf_reading.read_dxf(dxf_of(drawn))


def test_a_room_within_itself_is_named() -> None:
    with pytest.raises(FieldError, match="#12 IfcSpace 'a': is drawn within itself"):
        read(ifc_of_a_room_within_itself())


@pytest.mark.parametrize(("deep", "is_refused"), [(10, False), (30, True)])
def test_relations_are_counted_as_often_as_they_are_followed(deep: int, is_refused: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rooms within rooms are followed once for each: a few pass a limit that is as many as they are squared, more do not."""
    monkeypatch.setattr(ifc_reading, "MOST_RELATIONS", 300)
    content = ifc_of_rooms_within_rooms(deep)
    if is_refused:
        with pytest.raises(FieldError, match=r"relations: are \d+ \(allowed: at most 300\)"):
            read(content)
    else:
        assert len(read(content).scene.rooms) == deep


MENDED: dict[str, bytes | Callable[[], bytes]] = {
    "a bow tie": with_points([[[0, 0], [4, 3], [4, 0], [0, 3]]]),
    "not closed": with_points([[[0, 0], [4, 0], [4, 3], [0, 3]]]),
    "counter-clockwise": with_points([[[0, 0], [0, 3], [4, 3], [4, 0]]]),
    "each corner ten times": with_points([[point for point in ([0, 0], [4, 0], [4, 3], [0, 3]) for _ in range(10)]]),
    "a spike": with_points([[[0, 0], [4, 0], [9, 0], [4, 0], [4, 3], [0, 3]]]),
    "far from the origin": with_points([[[7e6 + x, -3e6 + y] for x, y in ((0, 0), (4, 0), (4, 3), (0, 3))]]),
    "a zigzag of nine hundred corners": with_points([zigzag(900)]),
    "a door of no width": spoilt(lambda plan: plan["features"][1]["geometry"].update(coordinates=[[1, 0], [1, 0]])),
    "a door far away": spoilt(lambda plan: plan["features"][1]["geometry"].update(coordinates=[[1e6, 0], [1e6 + 1, 0]])),
    "a sofa without a size": spoilt(lambda plan: plan["features"][2]["properties"].pop("width")),
    "a sofa of no size": spoilt(lambda plan: plan["features"][2]["properties"].update(width=0)),
    "a sofa as large as a town": spoilt(lambda plan: plan["features"][2]["properties"].update(width=5000)),
    "svg with a room of no size": svg(SVG_ROOM, "<rect class='room'/>", "<polygon class='room' points=''/>", "<path class='room' d=''/>"),
    "svg with half a point": svg("<polygon id='kitchen' points='0,0 4,0 4,3 0,3 7'/>"),
    "svg with a room that is hidden": svg(SVG_ROOM, "<rect class='room' width='40' height='30' style='display: none'/>"),
    "four hundred rooms on each other": many(400, lambda at: polygon("Kitchen", (0, 0), (4, 0), (4, 3), (0, 3))),
}  # fmt: skip


@pytest.mark.parametrize("name", MENDED)
def test_it_is_read_as_far_as_it_goes(name: str) -> None:
    content = content_of(MENDED[name])
    answer = bounded(lambda: read(content, furniture="sofa" in name))
    assert answer.scene.rooms
    assert all(room.width <= 11 and room.depth <= 11 for room in answer.scene.rooms)
    assert untold_in_import(answer, ["Sofa"]) == []
