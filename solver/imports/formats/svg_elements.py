"""The elements of an SVG file that draw something, each with its points in the file's own frame, its names and its `data-` attributes.

Nested transforms, `<use>` and `<svg>` are worked out, curves are taken as chords; what is hidden, only defined or text without place is
passed over.
"""

import math
import re
from collections.abc import Iterator, Mapping, Set
from typing import Any, Final, NamedTuple
from xml.etree.ElementTree import Element

from svg.path import Arc, CubicBezier, Line, QuadraticBezier, parse_path

from solver.errors import FieldError, SyntaxFault
from solver.imports.drawn import Spot
from solver.imports.plain_values import FARTHEST, LONGEST

MOST_DRAWN: Final = 50_000
"""Elements that are drawn, each as often as it is used."""
MOST_NUMBERS: Final = 200_000
"""Numbers and letters in all points, paths and transforms together."""
MOST_STYLE: Final = 200_000
"""Characters of a style sheet that are read."""
DEEPEST: Final = 200
"""Elements within elements, and uses of uses."""
NAMES_KEPT: Final = 6
"""Names of so many elements around one are kept, the nearest."""
NAMES_APART: Final = "|"
"""Between the names of one element."""
CHORDS: Final = 16
"""Chords that a curve is taken as."""
PIXELS: Final = {"": 1.0, "px": 1.0, "in": 96.0, "cm": 96 / 2.54, "mm": 96 / 25.4, "pt": 96 / 72, "pc": 16.0}
"""CSS: how many pixels a unit is."""
NOT_DRAWN: Final = frozenset((
    "defs", "symbol", "clipPath", "mask", "pattern", "marker", "metadata", "style", "script", "title", "desc", "filter", "linearGradient",
    "radialGradient", "foreignObject", "namedview", "image",
))  # fmt: skip
ESCAPED: Final = re.compile(r"_x([0-9A-Fa-f]{2})_")
LINE_END: Final = "\x1e"
"""What no XML holds."""
NUMBER: Final = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
NUMBER_OR_LETTER: Final = re.compile(rf"{NUMBER.pattern}|[a-zA-Z]+?")
LENGTH: Final = re.compile(rf"\s*({NUMBER.pattern})\s*([a-z]*)\s*")
RULE: Final = re.compile(r"(@[^{};]*\{(?:[^{}]*\{[^{}]*\})*[^{}]*\}|/\*.*?\*/)|([^{}]*)\{([^{}]*)\}", re.DOTALL)
"""A style sheet's rule as (left out, selectors, declarations): comments and rules for some media are left out."""
HIDING: Final = re.compile(r"(^|;)\s*(display\s*:\s*none|visibility\s*:\s*hidden)\s*(!|;|$)")
STEP: Final = re.compile(r"\s*,?\s*(matrix|translate|scale|rotate|skewX|skewY)\s*\(([^()]*)\)\s*")
SvgMatrix = tuple[float, float, float, float, float, float]
"""a, b, c, d, e, f of SVG: x' = ax + cy + e, y' = bx + dy + f."""
IDENTITY: Final[SvgMatrix] = (1.0, 0.0, 0.0, 1.0, 0.0, 0.0)
QUARTER: Final = 0.15
"""The cosine of the angle between the ends of an arc may be so far from that of a quarter circle."""


class SvgLine(NamedTuple):
    """A polyline; `swing` is (hinge, start, end) where a part of it is a quarter circle."""

    points: tuple[Spot, ...]
    closed: bool
    swing: tuple[Spot, Spot, Spot] | None = None


class SvgElement(NamedTuple):
    """Something drawn: its tag, its names and those around it (the outermost first), its place in the file, its lines, its matrix.

    `said` are its attributes, without namespaces; `words` what a text says.
    """

    tag: str
    names: tuple[str, ...]
    where: str
    lines: tuple[SvgLine, ...]
    matrix: SvgMatrix
    said: Mapping[str, str]
    words: str = ""


class _Turn(NamedTuple):
    """An element to come: with the names around it, its matrix, the ids of the uses it is within, how deep it is, whether it is used."""

    element: Element
    names: tuple[str, ...]
    matrix: SvgMatrix
    uses: tuple[str, ...]
    depth: int
    said: Mapping[str, str]


def local_name(name: object) -> str:
    """Returns a tag or an attribute's name without its namespace."""
    return str(name).rpartition("}")[2]


def said_of(element: Element) -> dict[str, str]:
    """Returns an element's attributes without namespaces."""
    return {local_name(key): value for key, value in element.attrib.items()}


def pixels_of(text: str | None) -> float | None:
    """Returns a length in the user's units; None where it is none, or a share of something."""
    found = LENGTH.fullmatch(text or "")
    return float(found[1]) * PIXELS[found[2]] if found and found[2] in PIXELS else None


def view_of(said: Mapping[str, str]) -> tuple[float, ...] | None:
    """Returns the four numbers of a viewBox."""
    found = tuple(map(float, NUMBER.findall(said.get("viewBox", "")[:LONGEST])))
    return found if len(found) == 4 and found[2] > 0 and found[3] > 0 else None


def placed(matrix: SvgMatrix, spot: Spot, where: str = "") -> Spot:
    """Returns where a matrix takes a point.

    Raises:
        FieldError: it is farther than any house, or nowhere.
    """
    a, b, c, d, e, f = matrix
    x, y = a * spot[0] + c * spot[1] + e, b * spot[0] + d * spot[1] + f
    if not (abs(x) <= FARTHEST and abs(y) <= FARTHEST):
        raise FieldError(where or "transform", "puts a point out of reach", f"coordinates up to {FARTHEST:g}")
    return x, y


def drawn_elements(root: Element) -> Iterator[SvgElement]:
    """Yields the elements that draw something, in order.

    Raises:
        FieldError: a number, a transform, a path or a use is wrong; names the element.
        SyntaxFault: more is drawn than in any plan.
    """
    known = elements_by_id(root)
    hiding = _hiding(root)
    counts: dict[str, int] = {}
    ahead = [_Turn(root, (), IDENTITY, (), 0, {})]
    drawn, numbers = 0, 0
    while ahead:
        turn = ahead.pop()
        element, tag, said = turn.element, local_name(turn.element.tag), said_of(turn.element)
        where = f"{tag}[{counts.get(tag, 0)}]" + (f" {said['id']!r:.60}" if "id" in said else "")
        counts[tag] = counts.get(tag, 0) + 1
        drawn += 1
        numbers += sum(len(NUMBER_OR_LETTER.findall(said.get(key, ""))) for key in ("d", "points", "transform"))
        if drawn > MOST_DRAWN or numbers > MOST_NUMBERS:
            raise SyntaxFault(f"a drawing of more than {MOST_DRAWN:,} elements or {MOST_NUMBERS:,} numbers and commands")
        if turn.depth > DEEPEST:
            raise FieldError(where, f"lies within more than {DEEPEST} elements", "a drawing that is nested less")
        if (tag in NOT_DRAWN and not (turn.said and tag == "symbol")) or _is_hidden(said, hiding):
            continue
        matrix = times(turn.matrix, _transform(said, where)) if turn.depth else IDENTITY
        names = ((*_names(said), *turn.names) if turn.said else (*turn.names, *_names(said)))[-NAMES_KEPT:]
        inner = _view(tag, said, matrix) if turn.depth else matrix
        if tag == "use":
            ahead += _used(turn, said, known, (names, inner, where))
        elif tag in ("g", "svg", "a", "switch", "symbol"):
            ahead += [_Turn(one, names, inner, turn.uses, turn.depth + 1, {}) for one in reversed(element) if isinstance(one.tag, str)]
        yield _element(element, _Turn(element, names, matrix, turn.uses, turn.depth, {**turn.said, **said}), where)


def elements_by_id(root: Element) -> dict[str, Element]:
    """Returns the elements that a use may draw, drawn elsewhere or not."""
    return {key: element for element in root.iter() if (key := element.get("id"))}


def _hiding(root: Element) -> frozenset[str]:
    """Returns the classes (`.a`) and ids (`#a`) that the file's style sheets hide, as far as they name them alone."""
    sheets = ("".join(element.itertext()) for element in root.iter() if local_name(element.tag) == "style")
    rules = (rule for sheet in sheets for rule in RULE.finditer(sheet[:MOST_STYLE]) if rule[3] and HIDING.search(rule[3]))
    return frozenset(one.strip() for rule in rules for one in rule[2].split(","))


def _is_hidden(said: Mapping[str, str], hiding: Set[str]) -> bool:
    called = {*(f".{name}" for name in said.get("class", "").split()), f"#{said.get('id', '')}"}
    stated = said.get("display") == "none" or said.get("visibility") == "hidden"
    return stated or bool(HIDING.search(said.get("style", ""))) or not hiding.isdisjoint(called)


def _names(said: Mapping[str, str]) -> tuple[str, ...]:
    """Returns what an element is called: its label in an editor, its classes, its id."""
    found = [unescaped(said[key][:LONGEST]) for key in ("class", "id", "label", "data-name", "data-layer", "data-kind") if said.get(key)]
    return (NAMES_APART.join(found),) if found else ()


def unescaped(name: str) -> str:
    """Returns a name in which Illustrator's `_x20_` is a space again, and so on."""
    return ESCAPED.sub(lambda found: chr(int(found[1], 16)), name)


def _words(element: Element) -> str:
    """Returns what a text says; a tspan with a place of its own begins a line."""
    parts = [element.text or ""]
    for part in element:
        begins = isinstance(part.tag, str) and {"x", "y", "dy"} & {*part.attrib}
        parts += [LINE_END if begins else "", *part.itertext(), part.tail or ""]
    lines = (" ".join(line.split()) for line in "".join(parts).split(LINE_END))
    return "\n".join(line for line in lines if line)


def _used(
    turn: _Turn, said: Mapping[str, str], known: Mapping[str, Element], place: tuple[tuple[str, ...], SvgMatrix, str]
) -> Iterator[_Turn]:
    """Yields the element that a use draws, moved by its x and y, where it is in the file; refuses one that is drawn within itself."""
    names, matrix, where = place
    key = used_id(said)
    if key in turn.uses:
        raise FieldError(where, "is drawn within itself", "an element of the file by its id")
    if key in known:
        by = (pixels_of(said.get("x")) or 0.0, pixels_of(said.get("y")) or 0.0)
        inner = times(matrix, (1.0, 0.0, 0.0, 1.0, *by))
        yield _Turn(known[key], names, inner, (*turn.uses, key), turn.depth + 1, {"href": key})


def used_id(said: Mapping[str, str]) -> str:
    """Returns the id of the element that a use draws; nothing where that is in another file."""
    key = said.get("href", "").strip()
    return key[1:] if key.startswith("#") else ""


def _view(tag: str, said: Mapping[str, str], matrix: SvgMatrix) -> SvgMatrix:
    """Returns the matrix within an inner `<svg>`."""
    if tag != "svg":
        return matrix
    x, y = pixels_of(said.get("x")) or 0.0, pixels_of(said.get("y")) or 0.0
    view, wide, high = view_of(said), pixels_of(said.get("width")), pixels_of(said.get("height"))
    if view is None or not wide or not high:
        return times(matrix, (1.0, 0.0, 0.0, 1.0, x, y))
    by = min(wide / view[2], high / view[3])
    return times(matrix, (by, 0.0, 0.0, by, x + (wide - by * view[2]) / 2 - by * view[0], y + (high - by * view[3]) / 2 - by * view[1]))


def times(outer: SvgMatrix, inner: SvgMatrix) -> SvgMatrix:
    """Returns the matrix that does the inner one first, then the outer."""
    a, b, c, d, e, f = outer
    g, h, i, j, k, m = inner
    return a * g + c * h, b * g + d * h, a * i + c * j, b * i + d * j, a * k + c * m + e, b * k + d * m + f


def _transform(said: Mapping[str, str], where: str) -> SvgMatrix:
    """Returns an element's own matrix; refuses a transform that is none."""
    text, at, made = said.get("transform", "").strip(), 0, IDENTITY
    while at < len(text):
        step = STEP.match(text, at)
        matrix = _step(step[1], tuple(map(float, NUMBER.findall(step[2])))) if step else None
        if step is None or matrix is None:
            raise FieldError(f"{where}.transform", f"is {text[at:]!r:.60}", "matrix, translate, scale, rotate, skewX, skewY")
        made, at = times(made, matrix), step.end()
    return made


def _step(kind: str, said: tuple[float, ...]) -> SvgMatrix | None:
    """Returns the matrix of one step of a transform, None where it has the wrong numbers."""
    match kind, said:
        case "matrix", (a, b, c, d, e, f):
            return a, b, c, d, e, f
        case "translate", (x, *more) if len(more) <= 1:
            return 1.0, 0.0, 0.0, 1.0, x, more[0] if more else 0.0
        case "scale", (x, *more) if len(more) <= 1:
            return x, 0.0, 0.0, more[0] if more else x, 0.0, 0.0
        case "rotate", (angle, *about) if len(about) in (0, 2) and abs(angle) < FARTHEST:
            c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))
            x, y = about or (0.0, 0.0)
            return c, s, -s, c, x - c * x + s * y, y - s * x - c * y
        case "skewX", (angle,) if abs(angle) < 90:
            return 1.0, 0.0, math.tan(math.radians(angle)), 1.0, 0.0, 0.0
        case "skewY", (angle,) if abs(angle) < 90:
            return 1.0, math.tan(math.radians(angle)), 0.0, 1.0, 0.0, 0.0
    return None


def _element(element: Element, turn: _Turn, where: str) -> SvgElement:
    tag, said = local_name(element.tag), turn.said
    words, lines = "", tuple(_lines(tag, said, where))
    if tag == "text":
        words = _words(element)[:LONGEST]
        lines = (SvgLine((_text_place(element, said),), False),)
    moved = tuple(
        SvgLine(
            tuple(placed(turn.matrix, spot, where) for spot in line.points), line.closed,
            line.swing and (placed(turn.matrix, line.swing[0]), placed(turn.matrix, line.swing[1]), placed(turn.matrix, line.swing[2])),
        )
        for line in lines
    )  # fmt: skip
    return SvgElement(tag, turn.names, where, moved, turn.matrix, said, words)


def _text_place(element: Element, said: Mapping[str, str]) -> Spot:
    """Returns where a text stands: its own place, else that of its first part that has one."""
    for part in (said, *(said_of(one) for one in element.iter() if one is not element)):
        x, y = (NUMBER.match(part.get(key, "").strip()) for key in ("x", "y"))
        if x and y:
            return float(x[0]), float(y[0])
    return 0.0, 0.0


def _lines(tag: str, said: Mapping[str, str], where: str) -> Iterator[SvgLine]:
    """Yields the lines of a shape, before its transform; refuses a path's data that cannot be read."""
    if tag == "path":
        yield from _path(said.get("d", ""), where)
    elif tag in ("polygon", "polyline"):
        numbers = list(map(float, NUMBER.findall(said.get("points", ""))))
        yield SvgLine(tuple(zip(numbers[::2], numbers[1::2], strict=False)), tag == "polygon")
    elif tag == "line":
        x0, y0, x1, y1 = (pixels_of(said.get(key, "0")) for key in ("x1", "y1", "x2", "y2"))
        if x0 is not None and y0 is not None and x1 is not None and y1 is not None:
            yield SvgLine(((x0, y0), (x1, y1)), False)
    elif tag == "rect":
        x, y, wide, high = (pixels_of(said.get(key, "0")) for key in ("x", "y", "width", "height"))
        if x is not None and y is not None and wide and high:
            yield SvgLine(((x, y), (x + wide, y), (x + wide, y + high), (x, y + high)), True)
    elif tag in ("circle", "ellipse"):
        x, y = (pixels_of(said.get(key, "0")) or 0.0 for key in ("cx", "cy"))
        rx, ry = (pixels_of(said.get("r", said.get(key))) or 0.0 for key in ("rx", "ry"))
        ways = [at * math.pi / CHORDS for at in range(2 * CHORDS)]
        yield SvgLine(tuple((x + rx * math.cos(way), y + ry * math.sin(way)) for way in ways), True)


def _path(data: str, where: str) -> Iterator[SvgLine]:
    try:
        segments = list(parse_path(data))
    except (ValueError, IndexError, TypeError, ArithmeticError, AttributeError, AssertionError):
        raise FieldError(f"{where}.d", f"is {data!r:.40}", "the data of a path") from None
    points: list[Spot] = []
    swing, closed = None, False
    for segment in segments:
        kind = type(segment).__name__
        if kind == "Move" and points:
            yield SvgLine(tuple(points), closed or points[0] == points[-1], swing)
            points, swing, closed = [], None, False
        if kind == "Close":
            closed = True
            continue
        if not points:
            points.append(_spot(segment.start))
        if kind != "Move":
            points += _along(segment)
            swing = swing or _swing(segment)
    if points:
        yield SvgLine(tuple(points), closed or (len(points) > 2 and points[0] == points[-1]), swing)


def _along(segment: Any) -> list[Spot]:
    if isinstance(segment, Line):
        return [_spot(segment.end)]
    try:
        return [_spot(segment.point(at / CHORDS)) for at in range(1, CHORDS)] + [_spot(segment.end)]
    except (ArithmeticError, ValueError):
        return [_spot(segment.end)]


def _swing(segment: Any) -> tuple[Spot, Spot, Spot] | None:
    """Returns the hinge and the ends of a quarter circle, as a door's leaf draws it; None for other curves."""
    if not isinstance(segment, Arc | CubicBezier | QuadraticBezier):
        return None
    start, end = segment.start, segment.end
    try:
        first, last = segment.tangent(0), segment.tangent(1)
        first, last = first / abs(first), last / abs(last)
    except (ArithmeticError, ValueError):
        return None
    if not abs((first.conjugate() * last).real) < QUARTER:
        return None
    corner = start + first * ((end - start) * first.conjugate()).real
    out, back = abs(corner - start), abs(end - corner)
    hinge = start + end - corner
    return (_spot(hinge), _spot(start), _spot(end)) if out and abs(out - back) < QUARTER * out else None


def _spot(point: complex) -> Spot:
    return float(point.real), float(point.imag)
