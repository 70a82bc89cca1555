"""DXF: closed polylines on layers of rooms, shapes on layers of doors, windows and openings, texts as names.

Its y points up. Read by ezdxf, an extra. Blocks are opened where their name or layer tells what they are; curves are taken by their points.
"""

import math
import re
from codecs import BOM_UTF8
from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from importlib import import_module
from io import StringIO
from itertools import islice, pairwise
from typing import Any, Final, NamedTuple

from catalogs import Catalogs, load_catalogs
from catalogs.synonyms import DrawnNames, drawn_names_of
from solver.answers import Unread
from solver.errors import FieldError, SyntaxFault
from solver.imports.bounded_files import MOST_BYTES, said
from solver.imports.drawn import MOST_POINTS, DrawnPiece, DrawnPlan, DrawnRoom, Spot
from solver.imports.plain_values import a_number
from solver.imports.shape_openings import SWUNG, WIDEST, DrawnShape, DrawnSwing
from solver.imports.shapes_plan import DrawnSheet, UnitTold, plan_of_shapes, side_by_side, text_at
from solver.imports.units import told_by_doors

METRES: Final = {1: 0.0254, 2: 0.3048, 4: 0.001, 5: 0.01, 6: 1.0, 10: 0.9144, 14: 0.1, 21: 0.3048}
"""What `$INSUNITS` says."""
MOST_ENTITIES: Final = 50_000
BODY: Final = "KIND"
"""What our export's furniture has for an attribute: a wall clock is no wall."""
A_STOREY: Final = 2.0
"""The lowest body in a drawing of ours stands on the floor of another storey than the ground where it is no nearer to that, m."""
OF_SMALL: Final = ("DECORATIONS", "HIGH")
"""Layers of ours: what is of no kind there is a small thing, or hangs."""
OF_BODIES: Final = (BODY, "ID", "NAME", "SIZE", "Y")
"""What is read of it."""
OWN: Final = "COMPOSE_HOMES"
"""The application of our export's extended data."""
TEXT: Final = 1000
OF_ROOMS: Final = ("id", "type", "label", "outdoor", "name")
OF_OPENINGS: Final = {TEXT: ("id",), 1041: ("sill", "height"), 1070: ("main_entrance",)}
"""What that says, by its codes."""
MOST_PARTS: Final = 150_000
"""Entities, vertices and entries of tables in a file, counted before it is read."""
UNREAD: Final = frozenset({"CLASSES", "OBJECTS", "ACDSDATA", "THUMBNAILIMAGE"})
"""Sections in which nothing is drawn."""
SPACES: Final = frozenset({"*model_space", "$model_space"})
"""Blocks that are the drawing itself."""
MANY: Final = f"of more than {MOST_PARTS:,} entities, vertices and entries"
MANY_ENTITIES: Final = f"of more than {MOST_ENTITIES:,} entities"
MOST_DXF_POINTS: Final = 100_000
"""Points of all that is drawn: a polyline's are no entities."""
DEEPEST: Final = 8
"""Blocks within blocks."""
BINARY: Final = b"AutoCAD Binary DXF"
"""How a DXF begins that is no text."""
FILLED: Final = frozenset({"HATCH", "SOLID", "TRACE"})
"""Areas: of walls, and on layers that tell nothing, they are taken as outlines."""
SAYS: Final = frozenset({"TEXT", "MTEXT", "ATTRIB", "DIMENSION", "INSERT"})
"""What draws no wall or room, whatever its layer is called."""
PARTS: Final = frozenset({"SECTION", "ENDSEC", "VERTEX", "ATTRIB", "SEQEND"})
"""What is no entity of its own."""
MULTI: Final = "MLINE"
"""Several lines beside one another, as walls are drawn."""
PICTURES: Final = re.compile(rb"^ *0\r?\n(?:IMAGE|OLE2FRAME|(?:PDF|DWF|DGN)UNDERLAY)\r?$", re.MULTILINE)
"""Entities that show what another file draws."""
CURVED: Final = frozenset({"LWPOLYLINE", "POLYLINE", "CIRCLE", "ARC", "ELLIPSE", "SPLINE"})
MESHES: Final = frozenset({"Polyface", "Polymesh"})
"""Kinds of POLYLINE that are surfaces."""
WIDTHS: Final = {"LWPOLYLINE": "const_width", "POLYLINE": "default_start_width"}
"""What says how thick a line is drawn."""
QUARTER: Final = 10
"""An arc on a layer that tells nothing may be a leaf's if it is a quarter circle, but for so many degrees."""
SHUT: Final = 1e-4
"""A line ends where it begins that leaves no larger a gap than this share of its length."""
CHORDS: Final = 16
"""Each curve is taken as so many chords."""


def is_dxf(content: bytes) -> bool:
    """Tells whether a file is a DXF, a text or a binary one."""
    lines = content[:200].removeprefix(BOM_UTF8).split()[:2]
    return lines == [b"0", b"SECTION"] or content.startswith((b"999", BINARY))


def read_dxf(content: bytes, metres: float | None = None, catalogs: Catalogs | None = None) -> DrawnPlan:
    """Reads the model space of a drawing; `metres` is the length of its unit, where the caller says it.

    The catalogs' names of rooms are looked for among the texts.

    Raises:
        FieldError: ezdxf is not installed; or there is more in it than in any home.
        SyntaxFault: it cannot be read.
    """
    try:
        ezdxf = import_module("ezdxf")
    except ImportError:
        raise FieldError("file", "is DXF, which needs ezdxf", "pip install 'compose-homes[dxf]'") from None
    if len(content) > MOST_BYTES:
        raise SyntaxFault(f"larger than {MOST_BYTES >> 20} MB")
    try:
        known = catalogs or load_catalogs()
        names = drawn_names_of(known)
        drawing = _drawing(content, names)
        space = drawing.modelspace()
        if len(space) > MOST_ENTITIES:
            raise SyntaxFault(MANY_ENTITIES)
        unit = METRES.get(drawing.header.get("$INSUNITS", 0))
        bodies: list[_Entity] = []
        plan = _plan(space, lambda found: told_by_doors(found, unit), metres, names, bodies)
        if pictures := len(PICTURES.findall(content)):
            words = f"pictures and pages of other files, in which nothing is read: {pictures}"
            plan = replace(plan, unread=(*plan.unread, Unread("pictures", words)))
        return _with_pieces(plan, bodies, known)
    except (ezdxf.DXFError, ValueError, TypeError, AttributeError, LookupError, ArithmeticError) as error:
        raise SyntaxFault(f"DXF that cannot be read: {said(error)}") from None


def _drawing(content: bytes, names: DrawnNames) -> Any:
    """Returns the drawing in a file, with as many parts as a plan may have at most."""
    tags = import_module("ezdxf.lldxf.tagger")
    if not content.startswith(BINARY):
        return import_module("ezdxf.filemanagement").read(StringIO("\n".join(_looked_at(_text(content).split("\n"), names))))
    if sum(tag.code == 0 for tag in tags.binary_tags_loader(content, errors="ignore")) > MOST_PARTS:
        raise SyntaxFault(MANY)
    return import_module("ezdxf.document").Drawing.load(tags.binary_tags_loader(content, errors="ignore"))


def _text(content: bytes) -> str:
    """Returns a file's text: files of before 2007 that are not UTF-8 are in the code page that they name."""
    content = b"\n".join(content.removeprefix(BOM_UTF8).splitlines()) + b"\n"
    try:
        return content.decode("utf-8")
    except UnicodeDecodeError:
        told = import_module("ezdxf.filemanagement").dxf_stream_info(StringIO(content.decode("latin-1")))
        return content.decode(told.encoding, "replace")


def _looked_at(lines: list[str], names: DrawnNames) -> list[str]:
    """Returns a file's lines but for what is never looked at, most of some files: sections that draw nothing, furniture's blocks."""
    zeros = {code for code in set(lines[::2]) if _begins_a_part(code)}
    starts = [2 * at for at, code in enumerate(lines[::2]) if code in zeros]
    if len(starts) > MOST_PARTS:
        raise SyntaxFault(MANY)
    parts = [(start, end, lines[start + 1]) for start, end in pairwise((*starts, len(lines))) if start + 1 < end]
    opened = _blocks_to_open((lines[start:end] for start, end, kind in parts if kind == "INSERT"), names)
    section, block, kept, drawn = "", "", lines[: starts[0] if starts else None], 0
    for start, end, kind in parts:
        if kind in ("SECTION", "EOF"):
            section, block = _said(2, lines[start:end]), ""
        elif kind == "ENDBLK":
            block = ""
        hidden = kind == "ATTDEF" or (kind == "ATTRIB" and not _is_read(lines[start:end])) or (block and block not in opened)
        if section not in UNREAD and not hidden:
            kept += lines[start:end]
            drawn += section == "ENTITIES" and kind not in PARTS
        if kind == "BLOCK":
            block = _said(2, lines[start:end]).lower()
    if drawn > MOST_ENTITIES:
        raise SyntaxFault(MANY_ENTITIES)
    if sum(kept[::2].count(code) for code in set(kept[::2]) if code.strip() == "10") > MOST_DXF_POINTS:
        raise SyntaxFault(f"of more than {MOST_DXF_POINTS:,} points")
    return kept


def _blocks_to_open(inserts: Iterable[list[str]], names: DrawnNames) -> set[str]:
    """Returns the names of blocks, in small letters, that neither their names nor the layers they are inserted on tell to hold nothing."""
    named, passed = {(_said(8, one), _said(2, one)) for one in inserts}, names.is_passed
    told = {name.lower() for layer, name in named if not passed((name,)) and (not passed((layer,)) or names.sort_within((name,)))}
    return told | SPACES


def _said(code: int, lines: list[str]) -> str:
    """Returns what a part of a file says first under some code."""
    return next((lines[at + 1] for at in range(0, len(lines) - 1, 2) if lines[at].strip() == str(code)), "")


def _is_read(attribute: list[str]) -> bool:
    """Tells whether an attribute of a block says something: a room's name, or that it is a piece of ours."""
    return _said(2, attribute) in OF_BODIES or any(letter.isalpha() for letter in _said(1, attribute))


def _begins_a_part(code: str) -> bool:
    """Tells whether the first line of a pair is 0, in any way in which numbers are read."""
    return not code.isascii() or not code.strip().lstrip("+-_0")


class _Entity(NamedTuple):
    """An entity, its layer, what its layers and blocks tell it is, its place in the file."""

    it: Any
    layer: str
    sort: str | None
    where: str


class _Blocks:
    """Which blocks hold something on a layer, or a block, whose name tells what it is: a whole house may be one block."""

    def __init__(self, blocks: Any, names: DrawnNames) -> None:
        self._blocks, self._names = blocks, names
        self._known: dict[str, bool] = {}

    def __call__(self, names: tuple[str, ...], block: str, depth: int) -> bool:
        """Tells whether a block does that lies under some names, none of which says that it holds none."""
        return not self._names.is_passed(names) and self._holds(block, depth)

    def _holds(self, name: str, depth: int) -> bool:
        if name not in self._known:
            self._known[name] = False
            parts = self._blocks.get(name) if depth < DEEPEST else None
            self._known[name] = any(self._tells(part, depth) for part in parts or ())
        return self._known[name]

    def _tells(self, part: Any, depth: int) -> bool:
        inner = (part.dxf.layer, *((part.dxf.name,) if part.dxftype() == "INSERT" else ()))
        is_told = bool(self._names.sort_within(inner))
        return is_told or (len(inner) > 1 and not self._names.is_passed(inner) and self._holds(inner[1], depth + 1))


def _drawn(space: Any, known: DrawnNames) -> Iterator[_Entity]:
    """Yields what is drawn; where nothing is called a room or a wall, blocks are opened whatever their names are."""
    found = list(_opened(space, known))
    drawn = (one for one in found if one.it.dxftype() not in SAYS)
    return iter(found) if any(one.sort in ("room", "wall") for one in drawn) else _opened(space, known, every=True)


def _lines_at_most(part: Any) -> int:
    """Returns how many lines of two points each hold as many as part of a drawing has."""
    if part.dxftype() not in ("LWPOLYLINE", "POLYLINE"):
        return 1
    return (CHORDS if part.has_arc else 1) * len(part) // 2 + 1


def _opened(space: Any, known: DrawnNames, *, every: bool = False) -> Iterator[_Entity]:
    """Yields what is drawn; of blocks of doors, windows, openings, walls and rooms, and those that hold layers of them, what is in them.

    Of `every` block whose name and layer do not say that it holds none of these, while all is no more than is told by its form.

    Raises:
        SyntaxFault: with its blocks it is more than in any plan.
    """
    holds, sort_within = _Blocks(space.doc.blocks, known), known.sort_within
    ahead = [(one, (one.dxf.layer,), f"{one.dxf.handle or number}", 0) for number, one in enumerate(space)][::-1]
    made = len(ahead)
    while ahead:
        one, names, number, depth = ahead.pop()
        kind = one.dxftype()
        inner = (*names, one.dxf.name) if kind == "INSERT" else names
        said = one.attribs if kind == "INSERT" and not one.has_attrib(BODY) else []
        ahead += [(part, (part.dxf.layer,), number, depth) for part in said]
        made += len(said)
        if said and sort_within(inner) == "room":
            continue
        is_block = kind == "INSERT" and depth < DEEPEST and not one.has_attrib(BODY)
        fits = is_block and every and 0 < one.mcount * sum(map(_lines_at_most, one.block() or ())) <= MOST_POINTS // 2 - made
        if is_block and (sort_within(inner) or holds(inner, one.dxf.name, depth) or (fits and not known.is_passed(inner))):
            made += one.mcount
            copies = (one,) if one.mcount == 1 else one.multi_insert() if made <= MOST_ENTITIES else ()
            parts = list(islice((part for copy in copies for part in copy.virtual_entities()), MOST_ENTITIES))
            made += sum(map(_lines_at_most, parts)) if every else len(parts)
            if made > MOST_ENTITIES:
                raise SyntaxFault(f"{MANY_ENTITIES}, each as often as its block is inserted")
            for part in reversed(parts):
                own = () if part.dxf.layer == "0" else (part.dxf.layer,)
                ahead.append((part, (*inner, *own), number, depth + 1))
        elif kind == MULTI and sort_within(names):
            parts = list(islice(one.virtual_entities(), MOST_ENTITIES))
            made += len(parts)
            if made > MOST_ENTITIES:
                raise SyntaxFault(MANY_ENTITIES)
            ahead += [(part, names, number, depth) for part in reversed(parts)]
        else:
            sort = sort_within(tuple(name.lower().replace("hatch", "") for name in names) if kind in FILLED else names)
            yield _Entity(one, names[0], sort, f"{kind} {number} on layer {names[0]}")


def _with_pieces(plan: DrawnPlan, bodies: Sequence[_Entity], known: Catalogs) -> DrawnPlan:
    """Returns the plan of a drawing of ours with the bodies in it; of one that was turned, or of several storeys, they are not read."""
    if not bodies or plan.metres is None or plan.turned or len(plan.levels) > 1:
        words = f"{len(bodies)} blocks of our own, which are not read in a drawing that was turned, or of several storeys"
        return replace(plan, unread=(*plan.unread, *([Unread("furniture", words)] if bodies else [])))
    pieces = [piece for body in bodies if (piece := _piece(body, plan.metres, known))]
    lowest = min((piece.y for piece in pieces), default=0.0)
    floor = lowest if abs(lowest) * plan.metres >= A_STOREY else 0.0
    return replace(plan, pieces=tuple(replace(piece, y=piece.y - floor) for piece in pieces))


def _piece(body: _Entity, metres: float, known: Catalogs) -> DrawnPiece | None:
    """Returns a body that our export drew, which says its sizes and its height in the house in m; None of who lives there."""
    one, where, plain = body.it, body.where, import_module("ezdxf.tools.text").caret_decode
    kind, id, said, size, y = (plain(one.get_attrib_text(tag)) for tag in OF_BODIES)
    if any(kind in one.kinds for one in known.people.values()):
        return None
    try:
        width, depth, height, under = (a_number({"": float(word)}, "", where) / metres for word in (*size.split(), y))
    except ValueError:
        raise FieldError(f"{where}.SIZE", f"is {size!r:.40}", "width, depth, height in m") from None
    (spot,) = _spots([one.ocs().to_wcs(one.dxf.insert)])
    entry = known.furniture.get(kind)
    name = said or (entry and entry.name) or kind.removesuffix("_upright") or "thing"
    is_small, sizes = entry is None and (bool(kind) or body.layer in OF_SMALL), (width, depth, height)
    return DrawnPiece(name, *spot, under, one.dxf.rotation, sizes, where, id=id, decoration=is_small, kind=kind or None)


def _plan(space: Any, told: UnitTold, metres: float | None, names: DrawnNames, bodies: list[_Entity]) -> DrawnPlan:
    """Returns the plan that is drawn, and gathers the bodies of a drawing of ours."""
    make_path = import_module("ezdxf.path").make_path
    sheets: defaultdict[int | None, DrawnSheet] = defaultdict(lambda: DrawnSheet([], [], []))
    passed: Counter[tuple[str, str]] = Counter()
    said: defaultdict[str, Sequence[Any]] = defaultdict(tuple)
    for one, layer, sort, where in _drawn(space, names):
        said[where] = one.get_xdata(OWN) if one.has_xdata(OWN) and not one.is_virtual else ()
        kind, (shapes, texts, swings) = one.dxftype(), sheets[names.storey_of_layer(layer)]
        if (sort in SWUNG or (sort is None and _is_quarter(one, kind))) and (arcs := list(_arcs(one, kind))):
            swings += [DrawnSwing(*arc, where, sort) for arc in arcs]
        elif kind in CURVED and (sort is not None or "POLYLINE" in kind) and type(one).__name__ not in MESHES:
            points = _spots(make_path(one).flattening(math.inf, CHORDS))
            closed = len(points) > 3 and math.dist(points[0], points[-1]) <= SHUT * math.dist(points[0], points[len(points) // 2])
            width = abs(one.dxf.get(WIDTHS[kind], 0.0)) if kind in WIDTHS else 0.0
            called = next((tag.value for tag in said[where] if tag.code == TEXT), "")
            shape = DrawnShape(layer, points[:-1] if closed else points, closed, where, sort, width=width, id=called)
            shapes += [shape] if points else []
        elif kind in FILLED and sort in ("wall", None):
            shapes += [DrawnShape(layer, points, True, where, sort, filled=True) for points in _filled(one) if len(points) > 2]
        elif kind == "LINE":
            shapes.append(DrawnShape(layer, _spots((one.dxf.start, one.dxf.end)), False, where, sort))
        elif kind in ("TEXT", "ATTRIB", "MTEXT"):
            at = one.dxf.insert if kind == "MTEXT" else one.ocs().to_wcs(one.dxf.get("align_point", one.dxf.insert))
            texts.append(text_at(one.plain_text(), (float(at.x), -float(at.y)), names))
        elif kind == "INSERT" and one.has_attrib(BODY):
            bodies.append(_Entity(one, layer, sort, where))
        else:
            passed[layer, kind] += 1
    unread = [Unread(f"layer {layer!r:.60}", f"{count} of {kind}, which is not read") for (layer, kind), count in sorted(passed.items())]
    plan = plan_of_shapes(side_by_side(sheets), told, metres, unread)
    return replace(
        plan, rooms=tuple(_room_told_itself(one, said[one.where]) for one in plan.rooms),
        openings=tuple(_told_itself(one, said[one.where]) for one in plan.openings),
    )  # fmt: skip


def _room_told_itself(room: DrawnRoom, said: Sequence[Any]) -> DrawnRoom:
    """Returns a room with what our export's extended data says of it."""
    plain = import_module("ezdxf.tools.text").caret_decode
    found = dict(zip(OF_ROOMS, (plain(tag.value) for tag in said if tag.code == TEXT), strict=False))
    return replace(room, id=found.get("id", "")).as_exported(found)


def _told_itself(one: Any, said: Sequence[Any]) -> Any:
    """Returns an opening with what our export's extended data says of it."""
    found: dict[str, Any] = {}
    for code, keys in OF_OPENINGS.items():
        values = [tag.value for tag in said if tag.code == code]
        found |= dict(zip(keys, values, strict=True)) if len(values) == len(keys) else {}
    return replace(one, **{key: value if key == "id" else a_number(found, key, one.where) for key, value in found.items()})


def _is_quarter(one: Any, kind: str) -> bool:
    """Tells whether an entity is a quarter circle, or a line with one arc, that, along which nothing leaves what a leaf sweeps."""
    arcs = [part for part in one.virtual_entities() if part.dxftype() == "ARC"] if kind in WIDTHS and one.has_arc else [one]
    if len(arcs) != 1 or arcs[0].dxftype() != "ARC" or abs((arcs[0].dxf.end_angle - arcs[0].dxf.start_angle) % 360 - 90) > QUARTER:
        return False
    middle, far = arcs[0].ocs().to_wcs(arcs[0].dxf.center), WIDEST * arcs[0].dxf.radius
    return one is arcs[0] or all(middle.distance(end) <= far for part in one.virtual_entities() for end in _ends(part))


def _ends(part: Any) -> tuple[Any, Any]:
    return (part.start_point, part.end_point) if part.dxftype() == "ARC" else (part.dxf.start, part.dxf.end)


def _arcs(one: Any, kind: str) -> Iterator[tuple[Spot, tuple[Spot, Spot]]]:
    """Yields the middle and the ends of each arc that an entity is, or has for a part."""
    for part in one.virtual_entities() if kind in WIDTHS and one.has_arc else (one,):
        if part.dxftype() in ("ARC", "ELLIPSE"):
            middle = part.ocs().to_wcs(part.dxf.center) if part.dxftype() == "ARC" else part.dxf.center
            hinge, first, last = _spots((middle, part.start_point, part.end_point))
            if first != last:
                yield hinge, (first, last)


def _filled(one: Any) -> Iterator[tuple[Spot, ...]]:
    """Yields the outlines of an area, the last point left out where it is the first again."""
    path = import_module("ezdxf.path")
    outlines = (each.flattening(math.inf, CHORDS) for each in path.from_hatch(one)) if one.dxftype() == "HATCH" else (one.wcs_vertices(),)
    for points in map(_spots, outlines):
        yield points[:-1] if len(points) > 3 and points[0] == points[-1] else points


def _spots(points: Iterable[Any]) -> tuple[Spot, ...]:
    """Returns points with y pointing south."""
    return tuple((float(point.x), -float(point.y)) for point in points)
