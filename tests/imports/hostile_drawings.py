"""Hostile drawings and archives: SVG, Sweet Home 3D; see `hostile_plans`."""

from __future__ import annotations

from io import BytesIO
from typing import Final
from zipfile import ZIP_DEFLATED, ZipFile

from tests.imports.hostile_plans import hostile


def _svg(*elements: str, more: str = "data-unit='m'") -> bytes:
    return f"<svg xmlns='http://www.w3.org/2000/svg' {more}>{''.join(elements)}</svg>".encode()


@hostile
def svg_that_uses_a_long_path_often() -> bytes:
    long = "<path id='p' class='room' d='M0 0" + "h1v1" * 4_000 + "'/>"
    return _svg("<defs>", long, "</defs>", *("<use href='#p'/>" for _ in range(40_000)))


@hostile
def svg_that_uses_a_circle_often() -> bytes:
    return _svg("<defs><circle id='c' class='wall' r='4'/></defs>", *("<use href='#c'/>" for _ in range(49_000)))


@hostile
def svg_of_texts_of_long_names() -> bytes:
    """Each within a name as long as is kept."""
    return _svg(*(f"<g id='{'room ' * 40}{at}'><text x='1' y='1'>a</text></g>" for at in range(20_000)))


@hostile
def svg_of_shapes_of_names_that_tell_nothing() -> bytes:
    names = ("zimmertisch" * 6, "der Saal 1 " * 6)
    return _svg(*(f"<rect id='{names[at % 2]}{at}' width='4' height='3'/>" for at in range(49_000)))


@hostile
def svg_path_of_curves() -> bytes:
    """Within the bound of numbers, as each curve is seven of them and sixteen chords."""
    return _svg(f"<path class='room' d='M0 0{'a1 1 0 0 1 1 1' * 28_000}z'/>")


@hostile
def svg_path_of_flags() -> bytes:
    """Digits without anything between them."""
    return _svg(f"<path class='room' d='M0 0{'1' * 4_000_000}'/>")


@hostile
def svg_of_a_long_transform() -> bytes:
    return _svg(f"<g transform='{'scale(1) ' * 190_000}'><rect class='room' width='4' height='3'/></g>")


@hostile
def svg_of_walls_alone() -> bytes:
    """4,900 walls whose lines cut the drawing into as many columns and rows."""
    lines = [
        f"<line x1='{at * 13 % 60}.{at % 1000:03}' y1='{at / 90}' x2='{at * 7 % 60}.{at % 997:03}' y2='{at / 90}'/>" for at in range(2_450)
    ]
    lines += [
        f"<line y1='{at * 13 % 60}.{at % 1000:03}' x1='{at / 90}' y2='{at * 7 % 60}.{at % 997:03}' x2='{at / 90}'/>" for at in range(2_450)
    ]
    return _svg("<g class='wall'>", *lines, "</g>")


@hostile
def svg_of_a_grid_of_walls_alone() -> bytes:
    """As many cells as are looked at, and every one too narrow for a room."""
    lines = [f"<line x1='0' y1='{at / 5}' x2='48' y2='{at / 5}'/><line y1='0' x1='{at / 5}' y2='48' x2='{at / 5}'/>" for at in range(245)]
    return _svg("<g class='wall'>", *lines, "</g>")


@hostile
def svg_of_small_rooms_between_walls() -> bytes:
    """7,000 faces between walls, each as large as a room must be; the walls are drawn in pieces."""
    ways = [(row * 0.7, column * 2.4) for row in range(86) for column in range(26)]
    return _svg("<g class='wall'>", *(f"<path d='M{x} {y}h2.4M{y} {x}v2.4'/>" for y, x in ways), "</g>")


@hostile
def svg_of_gaps_and_doors() -> bytes:
    """2,400 gaps in walls, each of which may be closed by each of 2,400 doors."""
    gaps = (f"<path class='wall' d='M{at % 60} {at // 60 * 3}h.05M{at % 60}.7 {at // 60 * 3}h.05'/>" for at in range(1_200))
    doors = (f"<path class='door' d='M{at % 60}.1 {at // 60 / 2}h.6'/>" for at in range(2_400))
    return _svg(*gaps, *doors)


@hostile
def svg_of_texts_in_rooms() -> bytes:
    rooms = [f"<rect class='room' x='{at % 22 * 3}' y='{at // 22 * 3}' width='3' height='3'/>" for at in range(480)]
    return _svg(*rooms, *(f"<text x='{at % 660 / 10}' y='{at % 650 / 10}'>Kitchen {at}</text>" for at in range(48_000)))


@hostile
def svg_of_doors_that_swing() -> bytes:
    """4,000 leaves among 900 walls: each is looked for at each."""
    doors = [f"<path class='door' d='M{at % 60} {at // 60}h.9a.9 .9 0 0 0 -.9 -.9z'/>" for at in range(4_000)]
    walls = [f"<rect class='wall' x='0' y='{at / 15}' width='60' height='.02'/>" for at in range(900)]
    return _svg("<rect class='room' width='60' height='60'/>", *walls, *doors)


def _zip(members: list[tuple[str, bytes]]) -> bytes:
    content = BytesIO()
    with ZipFile(content, "w", ZIP_DEFLATED) as archive:
        for name, inside in members:
            archive.writestr(name, inside)
    return content.getvalue()


_ROOM: Final = "<room name='Kitchen'><point x='0' y='0'/><point x='400' y='0'/><point x='400' y='300'/><point x='0' y='300'/></room>"


def _home(*elements: str) -> bytes:
    return f"<?xml version='1.0'?><home version='7000' name='a'>{''.join(elements)}</home>".encode()


@hostile
def sh3d_of_many_members() -> bytes:
    return _zip([*((f"{at}", b"") for at in range(60_000)), ("Home.xml", _home(_ROOM))])


@hostile
def sh3d_of_one_name_often() -> bytes:
    return _zip([("Home.xml", _home(_ROOM)) for _ in range(19_000)])


@hostile
def sh3d_whose_home_is_30_mb_of_attributes() -> bytes:
    rooms = _ROOM.replace("<room ", "<room " + " ".join(f"a{at}='{'x' * 90}'" for at in range(1_000)) + " ")
    return _zip([("Home.xml", _home(rooms * 290))])


@hostile
def sh3d_of_a_room_of_many_points() -> bytes:
    points = "".join(f"<point x='{at % 1000}' y='{at // 1000}'/>" for at in range(199_000))
    return _zip([("Home.xml", _home(f"<room name='Kitchen'>{points}</room>"))])


@hostile
def sh3d_of_properties() -> bytes:
    """Elements that say nothing, within elements that count once."""
    room = _ROOM.replace("</room>", "<property name='a' value='b'/>" * 190_000 + "</room>")
    return _zip([("Home.xml", _home(room))])


@hostile
def xml_nested_deeply() -> bytes:
    return _home("<group>" * 100_000 + _ROOM + "</group>" * 100_000)


@hostile
def xml_of_30_mb_of_text() -> bytes:
    return _home(_ROOM, "<!-- -->" * 900_000)


@hostile
def xml_of_a_million_elements() -> bytes:
    return _home(_ROOM, "<a b='c'/>" * 700_000)


@hostile
def sh3d_walls_in_every_place() -> bytes:
    walls = (
        f"<wall id='w{at}' xStart='0' yStart='{at}' xEnd='6000' yEnd='{at}' thickness='{at % 60 + 1}' height='250'/>" for at in range(4_900)
    )
    rooms = (_moved(at % 22 * 270, at // 22 * 270) for at in range(480))
    return _home(*rooms, *walls)


def _moved(x: int, y: int) -> str:
    corners = ((x, y), (x + 260, y), (x + 260, y + 260), (x, y + 260))
    return "<room name='Bedroom'>" + "".join(f"<point x='{a}' y='{b}'/>" for a, b in corners) + "</room>"
