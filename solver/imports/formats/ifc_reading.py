"""IFC 2x3 and 4: spaces as rooms, walls, the openings in them with their doors and windows, furniture by its names.

Its frame: x east, y north, z up, in the project's unit. Read by ifcopenshell, an extra: extruded shapes and flat faces are understood,
others are named. Spaces are drawn along inner faces, mostly. A piece is as large as the box around its body.
"""

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from importlib import import_module
from typing import Any, Final

import numpy as np

from solver.answers import Unread
from solver.errors import FieldError, SyntaxFault
from solver.imports.along_walls import drawn_along
from solver.imports.bounded_files import MOST_BYTES, said
from solver.imports.drawn import (
    MOST_POINTS,
    MOST_ROOMS,
    DrawnLevel,
    DrawnOpening,
    DrawnPiece,
    DrawnPlan,
    DrawnRoom,
    DrawnWall,
    Tally,
    check_count,
)
from solver.imports.formats.ifc_shapes import IfcBox, IfcOutline, IfcShapes

LOWEST_SILL: Final = 0.1
"""A hole without a door that begins so near the floor, m, and is PASSAGE high, is a passage."""
PASSAGE: Final = 1.8
SILL: Final = 0.3
"""A hole that begins so high above the floor, m, and is WINDOW wide and high, is a window of a building without any."""
WINDOW: Final = 0.4
THICKEST_FLOOR: Final = 0.4
"""So far above its storey's elevation, m, a floor may lie: where the lowest door begins."""
THICKEST: Final = 1.0
"""A wall that is thicker, m, holds several."""
LONG: Final = 2.0
"""So many times as long as it is thick, a wall tells itself which way it goes: some have their storey's frame."""
RISES: Final = 1.2
"""A wall is one of a storey at whose floor it reaches this height, m."""
MOST_ENTITIES: Final = 400_000
MOST_RELATIONS: Final = 100_000
"""Relations of elements that are looked at, each as often as it is."""
COUNTED: Final = {
    "IfcBuildingStorey": MOST_ROOMS, **dict.fromkeys(("IfcSpace", "IfcWall", "IfcOpeningElement", "IfcDoor", "IfcWindow",
                                                      "IfcFurnishingElement"), MOST_POINTS),
}  # fmt: skip
"""What is read, and how many of each at most."""
HOLDERS: Final = {
    "ContainedInStructure": "RelatingStructure", "Decomposes": "RelatingObject", "Nests": "RelatingObject",
    "FillsVoids": "RelatingOpeningElement", "VoidsElements": "RelatingBuildingElement",
}  # fmt: skip
"""The relations by which something holds an element, the nearest first, and what each calls it."""
REVIT: Final = re.compile(r"([^:]+):.*:\d+")
WITH: Final = re.compile(r"[\s_-]+w(?:ith)?[\s_/-]+")
"""Behind this a family's name says what there is besides."""
OURS: Final = ("Compose_Body", "Compose_Room")
HEADER: Final = b"ISO-10303-21"
Element = Any


def is_ifc(content: bytes) -> bool:
    """Tells whether a file is a STEP file of a building."""
    return content.lstrip()[:40].startswith(HEADER)


def read_ifc(content: bytes) -> DrawnPlan:
    """Reads a building.

    Raises:
        FieldError: ifcopenshell is not installed; or there is more in it than in any home.
        SyntaxFault: it cannot be read.
    """
    try:
        ifcopenshell = import_module("ifcopenshell")
    except ImportError:
        raise FieldError("file", "is IFC, which needs ifcopenshell", "pip install 'compose-homes[ifc]'") from None
    if len(content) > MOST_BYTES or content.count(b"\n#") > MOST_ENTITIES or b"END-ISO-10303-21" not in content[-2000:]:
        raise SyntaxFault(f"IFC that is cut off, or of more than {MOST_ENTITIES:,} entities")
    try:
        file = ifcopenshell.file.from_string(content.decode("utf-8", "replace"))
        _check_schema(file, ifcopenshell.ifcopenshell_wrapper.schema_names())
        return _ReadBuilding(file).plan()
    except (FieldError, SyntaxFault):
        raise
    except (RuntimeError, ValueError, AttributeError, TypeError, IndexError, KeyError, ifcopenshell.Error) as error:
        raise SyntaxFault(f"IFC that cannot be read: {said(error)}") from None


def _check_schema(file: Any, known: Sequence[str]) -> None:
    """Refuses a file of a schema that is not read, by its name."""
    names = tuple(map(str, file.header.file_schema.schema_identifiers))
    if not {name.upper() for name in names} & set(known):
        read = ", ".join(sorted(name for name in known if name.startswith("IFC")))
        raise SyntaxFault(f"IFC of the schema {' '.join(names) or '?':.60}; read are {read}")


class _ReadBuilding:
    """One file's building."""

    def __init__(self, file: Any) -> None:
        self.file = file
        self.unread: list[Unread] = []
        for kind, most in COUNTED.items():
            check_count(kind, len(file.by_type(kind)), most)
        self.tally = Tally()
        self.shapes = IfcShapes(self.tally)
        self.ways: dict[int, tuple[float, float]] = {}
        self.bodies = IfcShapes(Tally())
        self.metres = float(import_module("ifcopenshell.util.unit").calculate_unit_scale(file))
        storeys = sorted(file.by_type("IfcBuildingStorey"), key=lambda one: (one.Elevation or 0.0, one.id()))
        self.storeys = {one.id(): number for number, one in enumerate(storeys)}
        self.floors = [float(self.shapes.world_of(one)[2][3]) for one in storeys] or [0.0]
        self.levels = [DrawnLevel(number, one.Name or "", self.floors[number]) for number, one in enumerate(storeys)]

    def plan(self) -> DrawnPlan:
        """Returns what is drawn."""
        rooms = tuple(self._rooms())
        walls = tuple(self._walls(sorted({room.level for room in rooms})))
        drawn, thickness = drawn_along(rooms, walls)
        return DrawnPlan(
            rooms, tuple(self._openings()), walls, tuple(self._pieces()), tuple(self.levels), self.metres, drawn, thickness,
            tuple(self.unread),
        )  # fmt: skip

    def _related(self, element: Element, name: str) -> Sequence[Element]:
        """Returns the relations that an element has of a sort, counted."""
        found: Sequence[Element] = getattr(element, name, None) or ()
        self.tally.add("relations", len(found), MOST_RELATIONS)
        return found

    def _holder(self, element: Element) -> Element | None:
        for name, key in HOLDERS.items():
            if found := self._related(element, name):
                return getattr(found[0], key, None)
        return None

    def _level(self, element: Element) -> int:
        """Returns the storey that an element is in: by what holds it, else by its height; refuses one that holds itself in the end."""
        holder, held = self._holder(element), {element.id()}
        while holder is not None and holder.id() not in self.storeys:
            if holder.id() in held:
                raise FieldError(_place(holder), "is drawn within itself", "what a storey holds")
            held.add(holder.id())
            holder = self._holder(holder)
        if holder is not None:
            return self.storeys[holder.id()]
        height = float(self.shapes.world_of(element)[2][3])
        return max((number for number, floor in enumerate(self.floors) if floor <= height + 0.5 / self.metres), default=0)

    def _solid(self, element: Element, where: str) -> IfcOutline | None:
        solid = self.shapes.solid_of(element)
        if solid is None:
            self.unread.append(Unread(where, "its shape is none that is read here: an extruded profile, or flat faces"))
        return solid

    def _rooms(self) -> Iterator[DrawnRoom]:
        for space in self.file.by_type("IfcSpace"):
            where = _place(space)
            solid = self._solid(space, where)
            if solid is not None:
                name = space.LongName or space.Name or ""
                outdoor = (
                    getattr(space, "PredefinedType", None) == "EXTERNAL" or getattr(space, "InteriorOrExteriorSpace", None) == "EXTERNAL"
                )
                yield DrawnRoom(
                    tuple((x, -y) for x, y in solid.footprint), name, where, "", self._level(space), outdoor or None,
                    (space.Name or "") if self._is_ours() else "",
                ).as_exported({key.lower(): str(value) for key, value in self._said(space).items()})  # fmt: skip

    def _is_ours(self) -> bool:
        return str(self.file.header.file_name.originating_system) == "Compose"

    def _walls(self, levels: Sequence[int]) -> Iterator[DrawnWall]:
        """Yields walls, each on those of some levels through which it rises, whichever holds it; without levels on its own.

        Of one shape that holds several walls there are the lines of their faces.
        """
        for wall in self.file.by_type("IfcWall"):
            solid = self._solid(wall, _place(wall))
            if solid is not None:
                start, end, thickness = solid.middle_line(self.shapes.world_of(wall))
                if math.dist(start, end) >= LONG * thickness:
                    self.ways[wall.id()] = (end[0] - start[0], end[1] - start[1])
                low, high, by = solid.points[:, 2].min(), solid.points[:, 2].max(), RISES / self.metres
                for level in [at for at in levels if low <= self.floors[at] + by <= high] if levels else [self._level(wall)]:
                    is_one = thickness * self.metres <= THICKEST or not solid.faces
                    for a, b in [(start, end)] if is_one else solid.sliced(self.floors[level] + by):
                        yield DrawnWall((a[0], -a[1]), (b[0], -b[1]), thickness if is_one else 0.0, level)

    def _openings(self) -> Iterator[DrawnOpening]:
        filled: set[int] = set()
        yield from self._from_the_floor(list(self._filling("IfcDoor", filled)))
        yield from self._filling("IfcWindow", filled)
        seen: set[tuple[float, ...]] = set()
        has_windows = bool(self.file.by_type("IfcWindow"))
        for hole in self.file.by_type("IfcOpeningElement"):
            is_wanted = hole.id() not in filled and not self._related(hole, "HasFillings") and self._is_in_wall(hole)
            made = self._opening(hole, hole, False) if is_wanted else None
            if made is None:
                continue
            key = (*(round(value * self.metres, 2) for value in (*made.start, *made.end)), float(made.level))
            is_passage = (made.sill or 0.0) * self.metres <= LOWEST_SILL and (made.height or 0.0) * self.metres >= PASSAGE
            is_wide = min(made.height or 0.0, math.dist(made.start, made.end)) * self.metres >= WINDOW
            if not is_passage and (has_windows or not is_wide or (made.sill or 0.0) * self.metres < SILL):
                self.unread.append(Unread(made.where, "a hole in a wall that is neither filled nor a passage"))
            elif key not in seen:
                seen.add(key)
                yield made

    def _is_in_wall(self, hole: Element) -> bool:
        """Tells whether a hole is none in a roof, a floor or a piece of furniture."""
        return all(relation.RelatingBuildingElement.is_a("IfcWall") for relation in self._related(hole, "VoidsElements"))

    def _filling(self, kind: str, filled: set[int]) -> Iterator[DrawnOpening]:
        """Yields doors or windows; the holes that they fill are added to those filled."""
        for element in self.file.by_type(kind):
            fills = [fill.RelatingOpeningElement for fill in self._related(element, "FillsVoids")]
            filled |= {hole.id() for hole in fills}
            made = self._opening(element, fills[0] if fills else None, kind == "IfcWindow")
            if made is not None:
                yield made

    def _from_the_floor(self, doors: Sequence[DrawnOpening]) -> Iterator[DrawnOpening]:
        """Yields doors; the floor of each storey is taken where its lowest door begins, as far as it may lie above the slab."""
        above = {level: min(one.sill or 0.0 for one in doors if one.level == level) for level in {one.level for one in doors}}
        for level, by in above.items():
            if by * self.metres <= THICKEST_FLOOR:
                self.floors[level] += by
        for one in doors:
            by = above[one.level]
            yield replace(one, sill=(one.sill or 0.0) - by) if by * self.metres <= THICKEST_FLOOR else one

    def _opening(self, element: Element, hole: Element | None, is_window: bool) -> DrawnOpening | None:
        """Returns an opening along its wall: as long as the hole that it fills, else as its own words say."""
        where, frame = _place(element), self.shapes.world_of(element)
        solid = None if hole is None else self.shapes.solid_of(hole)
        voids = () if hole is None else self._related(hole, "VoidsElements")
        wall = voids[0].RelatingBuildingElement if voids else None
        if solid is not None and wall is not None:
            start, end, low, height = solid.along_wall(np.asarray(self.ways.get(wall.id(), self.shapes.world_of(wall)[:2, 0])))
        elif getattr(element, "OverallWidth", None):
            x, y, low = (frame[k][3] for k in range(3))
            start, end = (x, y), (x + frame[0][0] * element.OverallWidth, y + frame[1][0] * element.OverallWidth)
            height = element.OverallHeight or (2.1 / self.metres)
        else:
            self.unread.append(Unread(where, "an opening without a width"))
            return None
        level = self._level(element)
        floor = self.floors[min(level, len(self.floors) - 1)]
        kind, hinge = _kind(element, is_window), None
        towards = None
        style = str(getattr(element, "OperationType", None) or "")
        if kind == "door" and style in ("SINGLE_SWING_LEFT", "SINGLE_SWING_RIGHT", "DOUBLE_DOOR_SINGLE_SWING"):
            origin = (frame[0][3], frame[1][3])
            near = math.dist(origin, start) < math.dist(origin, end)
            hinge = "start" if near != (style == "SINGLE_SWING_RIGHT") else "end"
            towards = (start[0] + frame[0][1] / self.metres, -(start[1] + frame[1][1] / self.metres))
        name = element.Name or ""
        return DrawnOpening(
            kind, (start[0], -start[1]), (end[0], -end[1]), where, height, max(0.0, low - floor), level, hinge, towards,  # type: ignore[arg-type]
            id=name if self._is_ours() else "", unsaid=kind == "passage",
        )  # fmt: skip

    def _said(self, element: Element) -> dict[str, Any]:
        """Returns what our export's set of properties says of a piece or a space."""
        for relation in self._related(element, "IsDefinedBy"):
            found = relation.RelatingPropertyDefinition if relation.is_a("IfcRelDefinesByProperties") else None
            if found is not None and found.is_a("IfcPropertySet") and found.Name in OURS:
                return {one.Name: one.NominalValue.wrappedValue for one in self._related(found, "HasProperties") if one.NominalValue}
        return {}

    def _pieces(self) -> Iterator[DrawnPiece]:
        for piece in self.file.by_type("IfcFurnishingElement"):
            frame, said, level = self.shapes.world_of(piece), self._said(piece), self._level(piece)
            sizes: list[Any] = [said.get(key) for key in ("Width", "Depth", "Height")]
            foot, size = frame[:3, 3], None if None in sizes else (float(sizes[0]), float(sizes[1]), float(sizes[2]))
            box = self._box(piece) if size is None else None
            if box is not None:
                foot, size = box.foot, box.sizes
            turn, floor = math.degrees(math.atan2(frame[1][0], frame[0][0])), self.floors[min(level, len(self.floors) - 1)]
            yield DrawnPiece(
                _called(piece), float(foot[0]), -float(foot[1]), float(foot[2]) - floor,
                turn, size, _place(piece), level, None, str(said.get("Id", "")), said.get("Sort") == "decoration",
                str(said.get("Kind") or ""),
            )  # fmt: skip

    def _box(self, piece: Element) -> IfcBox | None:
        """Returns the box around a piece; None where nothing of it is understood, or all pieces have more points than in any plan."""
        try:
            return self.bodies.box_of(piece)
        except FieldError:
            return None


def _called(piece: Element) -> str:
    """Returns what a piece is called: its family, where its name is Revit's `family:type:number`, else its type.

    Families say first what they are, then which: `M_Table-Coffee` is a coffee table, `Table_Dining w-Chairs` a dining table with chairs.
    """
    family = REVIT.fullmatch(piece.Name or "")
    if not family:
        return str(piece.ObjectType or piece.Name or "")
    name, *things = WITH.split(family[1].removeprefix("M_"))
    return " with ".join((" ".join(part.strip() for part in reversed(name.split("-"))), *things))


def _kind(element: Element, is_window: bool) -> Any:
    if is_window:
        return "window"
    if element.is_a("IfcOpeningElement"):
        return "passage"
    words = f"{element.Name or ''} {getattr(element, 'OperationType', None) or ''}".lower()
    return "garage_door" if "garage" in words or "rollingup" in words else "door"


def _place(element: Element) -> str:
    return f"#{element.id()} {element.is_a()} {str(element.Name or '')!r:.60}"
