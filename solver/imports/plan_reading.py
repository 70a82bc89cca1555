"""A file of a floor plan -> the scene it draws: which format it is in, and the steps from there, in order. Start reading here."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Final, NamedTuple

from catalogs import Catalogs
from solver.answers import ImportSettings
from solver.errors import FieldError, SyntaxFault
from solver.foreign_plans import is_features, is_procthor, is_rplan
from solver.geometry import to_m
from solver.imports.carried_things import with_carriers
from solver.imports.drawn import DrawnLevel, DrawnPlan, DrawnRoom, PlanNotes, check_plan
from solver.imports.formats.dxf_reading import is_dxf, read_dxf
from solver.imports.formats.ifc_reading import is_ifc, read_ifc
from solver.imports.formats.plan_features import read_features
from solver.imports.formats.procthor_reading import read_procthor
from solver.imports.formats.rplan_reading import read_rplan
from solver.imports.formats.svg_reading import is_svg, read_svg
from solver.imports.formats.sweet_home_reading import is_sweet_home, read_sweet_home
from solver.imports.holes import cut_open
from solver.imports.in_millimetres import in_millimetres, of_one_level
from solver.imports.joining import joined
from solver.imports.line_growing import grown, usual_gap
from solver.imports.missing_walls import passages, without_niches
from solver.imports.pieces_in_rooms import with_pieces
from solver.imports.rectilinear import FloorCorners, edges_of_corners
from solver.imports.shapes_plan import with_labels
from solver.imports.straighten import NEAR, straightened, tell_of
from solver.imports.to_scene import NamedRoom, adjacency_of, named_rooms, outdoor_told, scene_rooms, tell_type, type_of_drawn, with_floor
from solver.imports.trimmed_pieces import trimmed
from solver.imports.units import check_size, unit_named, unit_of
from solver.imports.untold_openings import told_apart, with_glass
from solver.imports.wall_depths import WallDepths, faces_behind, outer_thicknesses
from solver.imports.walls_alone import with_rooms_between
from solver.scene import Level, Room, Scene, Size

USUAL_THICKNESS: Final = 100
"""Of walls, mm, where neither the file nor the gaps between its rooms tell."""
THICKEST: Final = 1000
"""Of a scene's walls, mm: thicker ones are held as thick."""
HEIGHT: Final = 2.8
"""Of a storey, m, where the file does not say."""
LINES_APART: Final = 20
"""Rooms whose neighbours are no farther away, mm, are drawn along the lines of their walls."""
WALL: Final = 0.75
"""Inner faces that are farther apart than this share of the usual thickness have a wall between them."""


@dataclass(frozen=True)
class PlanFile:
    """A file: its name, its content, the document in it where it is JSON or YAML; its unit, m, and catalogs, as the caller says."""

    name: str
    content: bytes
    document: object = None
    metres: float | None = None
    catalogs: Catalogs | None = None


class PlanReader(NamedTuple):
    """A format: how a file of it is known, how it is read."""

    is_it: Callable[[PlanFile], bool]
    read: Callable[[PlanFile], DrawnPlan]


def _document(read: Callable[[Mapping[str, Any]], DrawnPlan]) -> Callable[[PlanFile], DrawnPlan]:
    """Returns a reader of files from one of documents."""

    def read_file(file: PlanFile) -> DrawnPlan:
        if not isinstance(file.document, Mapping):
            raise SyntaxFault("not an object")
        return read(file.document)

    return read_file


def _drawing(read: Callable[[bytes, float | None, Catalogs | None], DrawnPlan]) -> Callable[[PlanFile], DrawnPlan]:
    return lambda file: read(file.content, file.metres, file.catalogs)


READERS: Final[Mapping[str, PlanReader]] = {
    "geojson": PlanReader(lambda file: is_features(file.document), _document(read_features)),
    "procthor": PlanReader(lambda file: is_procthor(file.document), _document(read_procthor)),
    "rplan": PlanReader(lambda file: is_rplan(file.document), _document(read_rplan)),
    "sh3d": PlanReader(lambda file: is_sweet_home(file.content), lambda file: read_sweet_home(file.content, file.catalogs)),
    "dxf": PlanReader(lambda file: is_dxf(file.content), _drawing(read_dxf)),
    "svg": PlanReader(lambda file: is_svg(file.content), _drawing(read_svg)),
    "ifc": PlanReader(lambda file: is_ifc(file.content), lambda file: read_ifc(file.content)),
}
"""The formats by name."""


def format_of_plan(file: PlanFile) -> str | None:
    """Returns the format of a file, None where it is none of READERS."""
    return next((name for name, reader in READERS.items() if reader.is_it(file)), None)


def imported(file: PlanFile, format: str, settings: ImportSettings, catalogs: Catalogs) -> tuple[Scene, PlanNotes]:
    """Returns the scene that a file in one of the formats of READERS draws, and what is not as it says.

    Raises:
        SyntaxFault: it cannot be read at all.
        FieldError: something in it cannot be read, or no room is left of it; names the place.
    """
    notes = PlanNotes()
    metres = unit_named(settings.unit)
    plan = READERS[format].read(replace(file, metres=metres, catalogs=catalogs))
    check_plan(plan)
    plan = with_labels(with_rooms_between(plan, metres))
    check_plan(plan)
    notes.unread += plan.unread
    plan = of_one_level(plan, settings.level, notes)
    metres = unit_of(plan, settings.unit, notes)
    if settings.unit is None:
        check_size(plan, metres)
    plan = in_millimetres(plan, metres, notes)
    rooms = _straight_rooms(plan, catalogs, notes)
    rooms = _without_niches(plan, rooms, notes)
    rooms, thickness = _along_lines(plan, rooms, notes)
    edges = [edges_of_corners(number, room.corners) for number, room in enumerate(rooms)]
    ids = [room.drawn.id for room in rooms]
    openings = told_apart(joined(plan.openings, edges, ids, thickness // 2, notes), rooms, catalogs, notes)
    openings = with_glass(openings, rooms, notes)
    entered = {edge.room for one in openings if one.drawn.kind != "window" for edge in one.edges}
    gardens = {number for number, room in enumerate(rooms) if room.drawn.outdoor and number in entered}
    openings += passages(edges, plan, openings, gardens, notes)
    origin = (min(x for room in rooms for x, _ in room.corners), min(z for room in rooms for _, z in room.corners))
    made = scene_rooms(rooms, openings, origin)
    if settings.furniture:
        made = with_pieces(made, plan.pieces, origin, catalogs, notes)
        if all(piece.size for piece in plan.pieces):
            made = [trimmed(room, (thickness + 1) // 2, notes) for room in made]
        made = with_carriers(made, thickness / 1000)
    return _scene(made, rooms, plan.levels, thickness), notes


def _straight_rooms(plan: DrawnPlan, catalogs: Catalogs, notes: PlanNotes) -> list[NamedRoom]:
    plan = replace(plan, rooms=tuple(cut_open(room, plan.openings, notes) for room in plan.rooms))
    apart = plan.wall_thickness * WALL if plan.drawn == "inner" and plan.wall_thickness else NEAR
    made = straightened([room.points for room in plan.rooms], apart)
    kept: list[tuple[DrawnRoom, str, FloorCorners]] = []
    straight = []
    for room, one in zip(plan.rooms, made, strict=True):
        if not one.corners:
            notes.leave(room.where, f"room {room.label!r}: its outline encloses less than 0.5 m2 of floor between straight walls")
            continue
        kept.append((room, type_of_drawn(room, catalogs), one.corners))
        straight.append(one)
    if not kept:
        raise FieldError("rooms", "enclose no floor", "outlines around at least 0.5 m2")
    named = named_rooms(kept)
    for made_room, one in zip(named, straight, strict=True):
        tell_of(made_room.id, one, notes)
        tell_type(made_room, notes)
    return [with_floor(outdoor_told(room, catalogs, notes), catalogs) for room in named]


def _without_niches(plan: DrawnPlan, rooms: list[NamedRoom], notes: PlanNotes) -> list[NamedRoom]:
    found = []
    for room in rooms:
        corners, depth = without_niches(room.corners, room.drawn.points, plan.openings, plan.walls)
        if depth:
            words = f"niches up to {depth} mm deep, such as a door's reveal, are taken as parts of the wall"
            notes.change("wall_lines", room.id, depth / 1000, words)
        found.append(replace(room, corners=corners))
    return found


def _along_lines(plan: DrawnPlan, rooms: list[NamedRoom], notes: PlanNotes) -> tuple[list[NamedRoom], int]:
    """Returns rooms along wall lines, and the scene's thickness of walls, mm; outer walls of another say so."""
    faces = ((one.start, one.end) for one in plan.walls if not one.thickness)
    depths = WallDepths((*plan.walls, *plan.solid), (*plan.faces, *faces))
    made, thickness = _lines_of(plan, rooms, depths, notes)
    for room in (one for one in made if not one.corners):
        notes.leave(room.drawn.where, f"room {room.drawn.label!r}: its walls leave no floor between them")
    made = [one for one in made if one.corners]
    if not made:
        raise FieldError("rooms", "enclose no floor between their walls", "outlines around at least 0.5 m2")
    edges = [edges_of_corners(number, room.corners) for number, room in enumerate(made)]
    own = outer_thicknesses([room.drawn for room in made], depths, edges, thickness)
    return [replace(room, wall_thickness=one) for room, one in zip(made, own, strict=True)], thickness


def _lines_of(plan: DrawnPlan, rooms: list[NamedRoom], depths: WallDepths, notes: PlanNotes) -> tuple[list[NamedRoom], int]:
    said = None if plan.wall_thickness is None else max(0, min(THICKEST, round(plan.wall_thickness)))
    apart = usual_gap([room.corners for room in rooms]) if plan.drawn == "unsaid" else 0
    faces = [edges_of_corners(number, room.corners) for number, room in enumerate(rooms)]
    thickness, found = faces_behind(faces, depths, USUAL_THICKNESS if said is None else said)
    within_walls = bool(depths) and thickness > LINES_APART
    if plan.drawn == "lines" or (plan.drawn == "unsaid" and (apart <= LINES_APART or within_walls)):
        if found is None:
            if said is None and not depths:
                notes.guess("plan", "wall_thickness", str(to_m(USUAL_THICKNESS)), "the file does not say how thick walls are")
            return rooms, thickness
        faces = found
    made = grown(faces, said)
    half = made.thickness // 2
    for room, moved in zip(rooms, made.moved, strict=True):
        worst = max((by - half for by in moved), key=abs, default=0)
        if abs(worst) > 5:
            words = f"a wall is drawn {max(0, 2 * (worst + half))} mm thick and held as {made.thickness}: half of that is floor"
            notes.change("wall_lines", room.id, abs(worst) / 1000, words)
    words = f"rooms are grown to the lines of their walls, the thinnest of which are {made.thickness / 1000:.2f} m thick"
    notes.change("wall_lines", "plan", half / 1000, words)
    return [replace(room, corners=corners) for room, corners in zip(rooms, made.corners, strict=True)], made.thickness


def _scene(made: Sequence[Room], rooms: Sequence[NamedRoom], levels: Sequence[DrawnLevel], thickness: int) -> Scene:
    width = max(room.x + room.width for room in made)
    depth = max(room.z + room.depth for room in made)
    storeys = tuple(Level(one.number, round(one.elevation or 0.0, 4), round(one.height or HEIGHT, 4)) for one in levels)
    return Scene(
        size=Size(round(width, 3), round(depth, 3), storeys[0].height), wall_thickness=to_m(thickness), levels=storeys,
        rooms=tuple(made), adjacency=adjacency_of(rooms),
    )  # fmt: skip
