"""SVG: rooms as closed shapes, walls, doors and windows as shapes that are called so; and what `data-` attributes say, as our export does.

Its y points down, as ours points south. Names are ids, classes and labels of shapes and of the groups around them.
"""

import math
from collections import defaultdict
from collections.abc import Container, Iterator, Mapping, Sequence
from statistics import median
from typing import Final, Literal

import numpy as np

from catalogs import Catalogs, load_catalogs
from catalogs.synonyms import DrawnNames, RoomNames, drawn_names_of
from solver.answers import Unread
from solver.errors import FieldError, SyntaxFault
from solver.geometry import bounds_of_points, encloses
from solver.imports.bounded_files import xml_of
from solver.imports.drawn import (
    MOST_POINTS,
    DrawnAlong,
    DrawnLevel,
    DrawnOpening,
    DrawnPiece,
    DrawnPlan,
    DrawnRoom,
    OpeningKind,
    Spot,
    check_count,
)
from solver.imports.formats.svg_elements import (
    LENGTH,
    NAMES_APART,
    PIXELS,
    SvgElement,
    SvgLine,
    drawn_elements,
    elements_by_id,
    local_name,
    placed,
    said_of,
    unescaped,
    used_id,
    view_of,
)
from solver.imports.plain_values import a_number, number_in, one_of
from solver.imports.shape_openings import SWUNG, WIDEST, DrawnShape, DrawnSwing, between
from solver.imports.shapes_plan import DrawnSheet, UnitTold, plan_of_shapes, side_by_side, text_at
from solver.imports.units import DOOR_WIDTHS, PlanUnit, assumed, told_by_doors, unit_named

OPENINGS: Final[tuple[OpeningKind, ...]] = ("door", "window", "passage", "garage_door")
SCALES: Final = (1, 20, 50, 100, 200, 500)
"""Of plans on paper, where the file does not say: a scale is told by how wide doors come out."""
METRIC: Final = (1.0, 0.01, 0.001)
"""Units that drawings for screens are in, m."""
NAMES: Final = ("label", "data-name", "id", "class")
"""Attributes that call a shape something."""
START: Final = 4_000
"""Bytes at a file's beginning in which its root is looked for."""


def is_svg(content: bytes) -> bool:
    """Tells whether a file is SVG."""
    return b"<svg" in content[:START] and content.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"<")


def read_svg(content: bytes, metres: float | None = None, catalogs: Catalogs | None = None) -> DrawnPlan:
    """Reads a drawing; `metres` is the length of its unit, where the caller says it.

    The catalogs' names of rooms tell which shapes are rooms.

    Raises:
        SyntaxFault: it is none, declares entities, or draws more than any plan.
        FieldError: something in it cannot be read; names its element.
    """
    root = xml_of(content)
    if local_name(root.tag) != "svg":
        raise SyntaxFault(f"no SVG: its first element is {str(root.tag)!r:.40}")
    elements, said = list(drawn_elements(root)), said_of(root)
    openings = [one for element in elements if "data-opening" in element.said for one in _opening(element)]
    stated = [element for element in elements if "data-room" in element.said and element.lines]
    names = None if stated and openings else drawn_names_of(catalogs or load_catalogs())
    plan = _shapes_plan(elements, elements_by_id(root), names, lambda found: _unit_of(said, found), metres)
    rooms = [_room(element, line.points) for element in stated for line in element.lines[:1]] or list(plan.rooms)
    unit = _unit_of(said, openings) if openings or stated else PlanUnit(plan.metres, plan.unit_words)
    openings = openings or list(plan.openings)
    thickness = number_in(said, "data-wall-thickness", "svg", None)
    drawn: DrawnAlong = "inner" if one_of(said, "data-drawn", ("", "lines", "inner"), "svg") == "inner" else "lines"
    level = int(number_in(said, "data-level", "svg", None) or 0)
    elevation = number_in(said, "data-elevation", "svg", None)
    pieces = tuple(_pieces(elements, unit.metres, elevation or 0.0))
    return DrawnPlan(
        tuple(rooms), tuple(openings), () if stated else plan.walls, pieces,
        plan.levels or (DrawnLevel(level, "", elevation, number_in(said, "data-level-height", "svg", None)),),
        metres=unit.metres, drawn=drawn if stated or "data-drawn" in said else plan.drawn,
        wall_thickness=plan.wall_thickness if thickness is None else thickness, unread=() if stated else plan.unread,
        unit_words=unit.words, solid=() if stated else plan.solid, faces=() if stated else plan.faces,
    )  # fmt: skip


def _unit_of(said: Mapping[str, str], openings: Sequence[DrawnOpening]) -> PlanUnit:
    """Returns the unit: what `data-unit` says; else paper's millimetres times the scale that makes doors doors; else what doors tell."""
    if said.get("data-unit"):
        return told_by_doors(openings, unit_named(said["data-unit"]))
    found, view = LENGTH.fullmatch(said.get("width", "")), view_of(said)
    if not found or found[2] not in PIXELS or found[2] in ("", "px"):
        return _of_pixels(openings)
    paper = PIXELS[found[2]] / PIXELS["mm"] / 1000 * float(found[1]) / (view[2] if view else float(found[1]) * PIXELS[found[2]])
    scale = number_in({"data-scale": said["data-scale"].removeprefix("1:")} if "data-scale" in said else {}, "data-scale", "svg", None)
    if scale:
        return PlanUnit(paper * scale)
    doors = [math.dist(one.start, one.end) * paper for one in openings if one.kind == "door"]
    told = [one for one in SCALES if doors and DOOR_WIDTHS[0] <= median(doors) * one <= DOOR_WIDTHS[1]]
    if len(told) != 1:
        return _of_pixels(openings)
    return PlanUnit(
        paper * told[0], f"the drawing is {found[1]} {found[2]} wide; at 1:{told[0]} its doors' median is {median(doors) * told[0]:.2f} m"
    )


def _of_pixels(openings: Sequence[DrawnOpening]) -> PlanUnit:
    """Returns the unit in which doors are as wide as doors; where they would be inches or feet, it is so by chance."""
    told = told_by_doors(openings, None)
    return told if told.metres in METRIC else assumed(openings)


def _outer(element: SvgElement) -> tuple[float | None, ...]:
    """Returns how thick a room says that its outer walls are, by side of its outline; None where it says `-`."""
    key = "data-outer-walls"
    words = element.said.get(key, "").split()
    return tuple(None if word == "-" else number_in({key: word}, key, element.where, None) for word in words)


def _room(element: SvgElement, points: tuple[Spot, ...]) -> DrawnRoom:
    said = element.said
    outdoor = one_of(said, "data-outdoor", ("", "true", "false"), element.where)
    return DrawnRoom(
        points, said.get("data-name", ""), element.where, said["data-room"], outdoor=outdoor == "true" if outdoor else None,
        id=said.get("data-id", ""), outer=_outer(element),
    )  # fmt: skip


def _opening(element: SvgElement) -> Iterator[DrawnOpening]:
    """Yields an opening that a line with `data-opening` draws; refuses what is no line, and an attribute that is wrong."""
    said, where = element.said, element.where
    kind = one_of(said, "data-opening", OPENINGS, where, required=True)
    if len(element.lines) != 1 or len(element.lines[0].points) != 2:
        raise FieldError(where, "has data-opening and is not one straight line", "a line along its wall")
    start, end = element.lines[0].points
    hinge = one_of(said, "data-hinge", ("", "start", "end"), where)
    main = one_of(said, "data-main-entrance", ("", "true", "false"), where)
    towards = said.get("data-towards", "").split()
    try:
        aim = placed(element.matrix, (float(towards[0]), float(towards[1])), where) if towards else None
    except (ValueError, IndexError):
        raise FieldError(
            f"{where}.data-towards", f"is {said['data-towards']!r:.40}", "two numbers: a point on the side it swings to"
        ) from None
    yield DrawnOpening(
        next(one for one in OPENINGS if one == kind), start, end, where, number_in(said, "data-height", where, None),
        number_in(said, "data-sill", where, None), hinge=_end(hinge), towards=aim, main_entrance=main == "true" if main else None,
        id=said.get("data-id", ""),
    )  # fmt: skip


def _end(word: str) -> Literal["start", "end"] | None:
    return "start" if word == "start" else "end" if word == "end" else None


def _pieces(elements: Sequence[SvgElement], metres: float | None, elevation: float) -> Iterator[DrawnPiece]:
    """Yields the pieces: uses of symbols that say how large they are; sizes and heights in m, as our export says them."""
    if metres is None:
        return
    sizes = {one.said["id"]: one.said["data-size"] for one in elements if "data-size" in one.said and "id" in one.said}
    for element in elements:
        said, where = element.said, element.where
        size = sizes.get(used_id(said))
        if element.tag != "use" or size is None or said.get("data-sort") == "dynamic":
            continue
        try:
            width, depth, height = (a_number({"": float(one)}, "", where) / metres for one in size.split())
        except ValueError:
            raise FieldError(f"{where}.data-size", f"is {size!r:.40}", "width, depth, height in m") from None
        x, z = placed(element.matrix, (0.0, 0.0), where)
        turn = -math.degrees(math.atan2(element.matrix[1], element.matrix[0]))
        y = (number_in(said, "data-y", where, None) or 0.0) / metres - elevation
        name = said.get("data-name") or said.get("data-kind") or "thing"
        yield DrawnPiece(
            name, x, z, y, turn, (width, depth, height), where, id=said.get("data-id", ""),
            decoration=said.get("data-sort") == "decoration", kind=said.get("data-kind"),
        )  # fmt: skip


def _shapes_plan(
    elements: Sequence[SvgElement], known: Container[str], names: DrawnNames | None, told: UnitTold, metres: float | None
) -> DrawnPlan:
    """Returns what shapes draw by their names, as far as attributes do not say it: then there are no names of rooms to go by."""
    sheets: defaultdict[int | None, DrawnSheet] = defaultdict(lambda: DrawnSheet([], [], []))
    if names is None:
        return plan_of_shapes(DrawnSheet([], [], []), told, metres)
    called, both = 0, set[str]()
    for element in elements:
        shapes, texts, swings = sheets[names.storey_of_layer("/".join(element.names[:2]))]
        texts += [text_at(element.words, element.lines[0].points[0], names)] if element.words else []
        if element.tag == "text" or not element.lines:
            continue
        sort = names.sort_within(element.names)
        label = _label(element, names.rooms, sort == "room") if sort in (None, "room") else ""
        both |= {element.where} if sort is None and names.is_thing(label) else set()
        for line in element.lines:
            if sort in (*SWUNG, None) and line.swing and (sort or not _is_rounded(line)):
                swings.append(DrawnSwing(line.swing[0], (line.swing[1], line.swing[2]), element.where, sort))
                continue
            is_room = sort == "room" or (sort is None and bool(label) and line.closed)
            closed = line.closed or (is_room and len(line.points) > 3)
            width = _stroke(element) if sort == "wall" and (not closed or _styled(element, "fill") == "none") else 0.0
            named = "/".join(element.names[:1])
            shapes.append(DrawnShape(named, line.points, closed, element.where, "room" if is_room else sort, label, width))
            called += shapes[-1].sort is not None
        check_count("shapes", called, MOST_POINTS)
    sheet = side_by_side(sheets)
    return plan_of_shapes(sheet._replace(shapes=_without_beds(sheet.shapes, both, names.rooms)), told, metres, _lost(elements, known))


def _without_beds(shapes: Sequence[DrawnShape], both: Container[str], names: RoomNames) -> list[DrawnShape]:
    """Returns shapes, of which those within a room of their type are none that may be called as `both` are, a room and a piece: a bed."""
    rooms = [(one, meaning.key) for one in shapes if one.sort == "room" and one.points and (meaning := names.meaning(one.label))]
    boxes = np.array([bounds_of_points(one.points) for one, _ in rooms]).reshape(-1, 4)
    sizes, beds = (boxes[:, 2:] - boxes[:, :2]).prod(axis=1), set[str]()
    for (bed, kind), box, size in zip(rooms, boxes, sizes, strict=True):
        x, z = between((box[0], box[1]), (box[2], box[3]))
        around = ((boxes[:, :2] < (x, z)) & (boxes[:, 2:] > (x, z))).all(axis=1) & (sizes > size)
        larger = (rooms[at] for at in np.flatnonzero(around) if bed.where in both)
        if any(kind in other and encloses(room.points, x, z) for room, other in larger):  # a `kids_bedroom` is a `bedroom`, too
            beds.add(bed.where)
    return [one._replace(sort=None) if one.where in beds else one for one in shapes]


def _is_rounded(line: SvgLine) -> bool:
    """Tells whether an outline with a quarter circle goes on beyond what a leaf sweeps: a worktop with a round end."""
    hinge, tip = line.swing[:2] if line.swing else line.points[:2]
    return line.closed and max(math.dist(hinge, spot) for spot in line.points) > WIDEST * math.dist(hinge, tip)


def _lost(elements: Sequence[SvgElement], known: Container[str]) -> list[Unread]:
    """Returns how many uses draw what is not in the file."""
    lost = [one.where for one in elements if one.tag == "use" and used_id(one.said) not in known]
    return [Unread(lost[0], f"uses of what is not in the file draw nothing: {len(lost)}")] if lost else []


def _stroke(element: SvgElement) -> float:
    """Returns how thick an element says that its lines are drawn, 0 where it does not."""
    found, (a, b, c, d, *_) = LENGTH.fullmatch(_styled(element, "stroke-width")), element.matrix
    if not found or found[2] not in PIXELS or _styled(element, "stroke") == "none":
        return 0.0
    return float(found[1]) * PIXELS[found[2]] * math.sqrt(abs(a * d - b * c))


def _styled(element: SvgElement, key: str) -> str:
    """Returns what an element's own style says, else its attribute."""
    rules = (rule.split(":", 1) for rule in element.said.get("style", "").split(";") if ":" in rule)
    return {name.strip(): value.strip() for name, value in rules}.get(key, element.said.get(key, ""))


def _label(element: SvgElement, names: RoomNames, is_room: bool) -> str:
    """Returns the first of a shape's own names that plainly names a room; of a shape without a name, of the group's around it.

    Of one that is called a room, the first that tells at all which, where none plainly does.
    """
    said = [unescaped(element.said[key]) for key in NAMES if element.said.get(key)] or [
        name for names_of in element.names[-1:] for name in names_of.split(NAMES_APART)
    ]
    plain = next((name for name in said if names.is_plain(name)), "")
    return plain or next((name for name in said if is_room and names.meaning(name)), "")
