"""Sweet Home 3D: a .sh3d archive of version 5.3 or newer, or the Home.xml inside it; and what our own export adds as properties.

Its frame: x east, y south, cm; angles in radians, clockwise seen from above. Rooms are drawn along inner faces, mostly.
"""

import math
import re
from collections.abc import Iterator
from typing import Final, Literal
from xml.etree.ElementTree import Element

from catalogs import Catalogs, load_catalogs
from catalogs.synonyms import drawn_names_of
from solver.answers import Unread
from solver.errors import SyntaxFault
from solver.imports.along_walls import drawn_along
from solver.imports.bounded_files import numbered, xml_of
from solver.imports.drawn import (
    MOST_POINTS,
    DrawnLevel,
    DrawnOpening,
    DrawnPiece,
    DrawnPlan,
    DrawnRoom,
    DrawnText,
    DrawnWall,
    OpeningKind,
    check_count,
)
from solver.imports.plain_values import number_in
from solver.imports.shapes_plan import text_at
from solver.plain import quoted

HOME: Final = "Home.xml"
CM: Final = 0.01
LONGEST: Final = 200
"""Letters of a name."""
SILL: Final = 30.0
"""An opening whose underside is higher, cm, is a window."""
LOW: Final = 150.0
"""A wall that is lower, cm, is a railing or a fence."""
PASSAGES: Final = ("passage", "frame", "opening", "archway")
"""Words of openings without a leaf."""
ARGB: Final = re.compile("[0-9A-Fa-f]{8}")
PIECES: Final = ("pieceOfFurniture", "light", "shelfUnit")


def is_sweet_home(content: bytes) -> bool:
    """Tells whether a file is the Home.xml of such an archive."""
    return b"<home" in content[:1000]


def read_sweet_home(content: bytes, catalogs: Catalogs | None = None) -> DrawnPlan:
    """Reads a home; the catalogs' names of rooms are looked for among its labels.

    Raises:
        SyntaxFault: it is none.
        FieldError: something in it cannot be read; names its place.
    """
    root = xml_of(content)
    if root.tag != "home":
        raise SyntaxFault(f"no home: its first element is {root.tag!r:.40}")
    levels = _levels(root)
    ids = {level.name: number for number, level in enumerate(levels)}
    rooms: list[DrawnRoom] = []
    walls: list[DrawnWall] = []
    openings: list[DrawnOpening] = []
    pieces: list[DrawnPiece] = []
    unread: list[Unread] = []
    texts, names = list[DrawnText](), drawn_names_of(catalogs or load_catalogs())
    check_count("labels", len(root.findall("label")), MOST_POINTS)
    for element, where in numbered(root.iter(), HOME):
        level = ids.get(element.get("level", ""), 0)
        if element.tag == "room":
            rooms.append(_room(element, where, level))
        elif element.tag == "wall":
            walls += _wall(element, where, level, unread)
        elif element.tag == "doorOrWindow":
            openings.append(_opening(element, where, level))
        elif element.tag == "label":
            spot, words = (number_in(element, "x", where), number_in(element, "y", where)), element.findtext("text", "")[:LONGEST]
            texts += [text._replace(level=level) for text in (text_at(words, spot, names),) if text.means]
        elif element.tag in PIECES:
            pieces += _piece(element, where, level, unread)
    drawn, thickness = drawn_along(rooms, walls)
    named = tuple(DrawnLevel(number, one.said, one.elevation, one.height) for number, one in enumerate(levels))
    return DrawnPlan(
        tuple(rooms), tuple(openings), tuple(walls), tuple(pieces), named, CM, drawn, thickness, tuple(unread), texts=tuple(texts)
    )


class _Storey:
    """A level of the file: the id that others name it by, what it is called, its elevation and height, cm."""

    def __init__(self, element: Element, where: str) -> None:
        self.name, self.said = element.get("id", ""), element.get("name", "")
        self.elevation, self.height = number_in(element, "elevation", where, 0.0), number_in(element, "height", where, 250.0)
        self.order = number_in(element, "elevationIndex", where, 0.0)


def _levels(root: Element) -> list[_Storey]:
    found = [_Storey(element, where) for element, where in numbered(root.iter("level"), HOME)]
    return sorted(found, key=lambda one: (one.elevation, one.order))


def _said(element: Element) -> dict[str, str]:
    return {one.get("name", ""): one.get("value", "") for one in element.findall("property")}


def _room(element: Element, where: str, level: int) -> DrawnRoom:
    points = tuple(
        (number_in(point, "x", f"{where} point[{at}]"), number_in(point, "y", f"{where} point[{at}]"))
        for at, point in enumerate(element.findall("point"))
    )
    said, name, floor = _said(element), element.get("name", "")[:LONGEST], _color(element.get("floorColor", ""))
    return DrawnRoom(points, name, where, level=level, id=said.get("id", ""), floor=floor).as_exported(said)


def _color(said: str) -> str | None:
    """Returns a colour that is said with its opacity before it; None where none is."""
    return f"#{said[2:].lower()}" if ARGB.fullmatch(said) else None


def _wall(element: Element, where: str, level: int, unread: list[Unread]) -> Iterator[DrawnWall]:
    if number_in(element, "arcExtent", where, 0.0):
        unread.append(Unread(where, "a round wall: the rooms' outlines tell where it is"))
        return
    start, end = ((number_in(element, f"x{at}", where), number_in(element, f"y{at}", where)) for at in ("Start", "End"))
    highest = max(number_in(element, key, where, 0.0 if key == "heightAtEnd" else 250.0) for key in ("height", "heightAtEnd"))
    yield DrawnWall(start, end, number_in(element, "thickness", where, 0.0), level, highest < LOW)


def _opening(element: Element, where: str, level: int) -> DrawnOpening:
    x, y, angle = number_in(element, "x", where), number_in(element, "y", where), number_in(element, "angle", where, 0.0)
    half, sill = number_in(element, "width", where) / 2, number_in(element, "elevation", where, 0.0)
    c, s = math.cos(angle), math.sin(angle)
    thick = _share(element, "wallThickness", 1.0) or 1.0
    in_wall = min(_share(element, "wallDistance", 0.0), 1.0 - thick) + thick / 2
    before = number_in(element, "depth", where, 0.0) * (in_wall - 0.5)
    x, y = x - before * s, y + before * c  # the box also holds what stands out of the wall, such as an open leaf
    start, end = (x - half * c, y - half * s), (x + half * c, y + half * s)
    said = _said(element)
    name = f"{element.get('catalogId', '')} {element.get('name', '')}".lower()
    hinge: Literal["start", "end"] | None = None
    towards = None
    sashes = element.findall("sash")
    if len(sashes) in (1, 2):  # of a door of two leaves the first one is told of: the other hangs opposite
        axis, turn = number_in(sashes[0], "xAxis", where, 0.0), 0.0
        first, last = number_in(sashes[0], "startAngle", where, 0.0), number_in(sashes[0], "endAngle", where, 0.0)
        mirrored = element.get("modelMirrored") == "true"
        hinge = "start" if (axis < 0.5) != mirrored else "end"
        turn = math.sin(last) if abs(math.sin(last)) > abs(math.sin(first)) else math.sin(first)
        side = -1.0 if turn > 0 else 1.0
        towards = (x - side * 50 * s, y + side * 50 * c)
    kind = _kind(name, sill, said.get("kind", ""))
    main = said["main_entrance"] == "true" if "main_entrance" in said else None
    return DrawnOpening(
        kind, start, end, where, number_in(element, "height", where, 210.0), sill, level, hinge, towards, main, id=said.get("id", "")
    )


def _share(element: Element, key: str, default: float) -> float:
    """Returns which share of a door's depth is said, the default where none is from 0 to 1."""
    try:
        said = float(element.get(key, default))
    except ValueError:
        return default
    return said if 0.0 <= said <= 1.0 else default


def _kind(name: str, sill: float, said: str) -> OpeningKind:
    if said in ("door", "garage_door", "passage", "window"):
        return said  # type: ignore[return-value]
    if sill > SILL or "fixed" in name:
        return "window"
    if "garage" in name:
        return "garage_door"
    return "passage" if any(word in name for word in PASSAGES) else "door"


def _piece(element: Element, where: str, level: int, unread: list[Unread]) -> Iterator[DrawnPiece]:
    name = element.get("name", "")[:LONGEST]
    if element.get("visible") == "false":
        unread.append(Unread(where, f"{quoted(name)}: it is hidden"))
        return
    said = _said(element)
    size = (number_in(element, "width", where), number_in(element, "depth", where), number_in(element, "height", where))
    color = element.get("color", "")
    yield DrawnPiece(
        said.get("name", name) if name == said.get("label", name) else name,
        number_in(element, "x", where),
        number_in(element, "y", where),
        number_in(element, "elevation", where, 0.0),
        -math.degrees(number_in(element, "angle", where, 0.0)),
        size,
        where,
        level,
        _color(color),
        said.get("id", ""),
        said.get("sort") == "decoration",
        said.get("kind"),
    )
