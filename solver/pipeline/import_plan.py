"""import_plan(): a file of a foreign floor plan -> a scene, with everything that was changed, guessed or left out."""

from collections.abc import Mapping, Set
from dataclasses import replace
from math import hypot
from typing import Final

from catalogs import Catalogs, load_catalogs
from solver.answers import ImportSettings, PlanImport
from solver.certificate import certified
from solver.errors import FieldError, SyntaxFault
from solver.exchange import FORMATS, format_of_file, format_of_name, load_text, misspelt, read_scene, write
from solver.export_formats import EXPORTERS
from solver.guessing import with_entrance
from solver.imports import READERS, PlanFile, PlanNotes, format_of_plan, imported, in_metres, scene_unit, unpacked
from solver.pipeline.fix import fix
from solver.pipeline.room_spaces import room_problem
from solver.repair import RepairSettings, all_bodies, with_walls_told
from solver.scene import Scene
from solver.understanding import understood, with_understood_kinds
from solver.validator import validate

CENTIMETRE: Final = 0.01
OWN: Final = "scene"
"""What our own documents are called among the formats."""
NO_FORMAT: Final = "is in none of the formats that are read here"


def import_plan(content: object, name: str = "", settings: ImportSettings | None = None, *, catalogs: Catalogs | None = None) -> PlanImport:
    """Reads a floor plan of another program, or a scene of ours.

    Args:
        content: the file's bytes; or the document that a JSON file holds.
        name: the file's name, where it has one.
        settings: which level, unit, furniture.
        catalogs: whose room types and kinds are known; ours by default.

    Raises:
        FieldError: the file is in none of the formats, or something in it cannot be read; names the place.

    Example:
        >>> from compose_homes import import_plan
        >>> plan = b'{"type": "FeatureCollection", "unit": "m", "features": [{"geometry": {"type": "Polygon", "coordinates":'
        >>> plan += b' [[[0, 0], [4, 0], [4, 3], [0, 3]]]}, "properties": {"name": "Kitchen"}}]}'
        >>> room = import_plan(plan).scene.rooms[0]
        >>> room.type, room.width, room.depth
        ('kitchen', 4.0, 3.0)
    """
    known, asked = catalogs or load_catalogs(), settings or ImportSettings()
    try:
        scene, notes, format = _read(_file(name, content), asked, known)
    except SyntaxFault as fault:
        raise FieldError("file", str(fault), f"a file of one of the formats {', '.join((OWN, *READERS))}") from None
    scene, entrance = with_entrance(scene, known)
    if entrance is not None:
        notes.guess(entrance.id, "main_entrance", "true", entrance.message)
    words = understood(scene, known).understood_as
    if any(room.furniture for room in scene.rooms) and format != OWN:
        scene = _at_walls(scene, known, notes)
        fixed = fix(scene, on_conflict="remove", repairs=False, catalogs=known)
        drawn, now = ({body.id: body for room in one.rooms for body in all_bodies(room)} for one in (scene, fixed.scene))
        broken = {name: issue.message for issue in reversed(validate(scene, known) if fixed.moves else ()) for name in issue.ids}
        for move in fixed.moves:
            far = hypot(move.dx, now[move.id].y - drawn[move.id].y, move.dz)
            notes.change("furniture", move.id, far, _moved(far, move.rotation, drawn[move.id].rotation, broken.get(move.id)))
        for gone in fixed.removed:
            notes.leave(str(gone["id"]), f"cannot stand: {gone['reason']}")
        scene = replace(fixed.scene, certificate=None)
    if format != OWN:
        scene = with_understood_kinds(scene, known)
    issues = tuple(validate(scene, known))
    kept = {room_piece.id for room in scene.rooms for room_piece in room.furniture}
    said = {key: kind for key, kind in words.items() if key in kept}
    return PlanImport(
        scene, format, tuple(map(write, notes.changes)), tuple(map(write, notes.guesses)), tuple(map(write, notes.unread)),
        issues, said,
    )  # fmt: skip


def _at_walls(scene: Scene, known: Catalogs, notes: PlanNotes) -> Scene:
    """Returns a scene whose pieces that stand at walls name the wall that they are drawn at: moved, they stay at one.

    One that stands with its back at a wall and is drawn with its front at one, and nothing behind it, is turned about.
    """
    named = understood(scene, known).scene
    walls = _walls_of(named, known)
    about = _walls_of(_turned_about(named, {name for name, wall in walls.items() if wall is None}), known)
    turned = {name for name, wall in about.items() if wall is not None and walls[name] is None}
    for name in sorted(turned):
        notes.change("furniture", name, 0.0, "turned by 180 degrees: it is drawn with its front at a wall")
    rooms = []
    for room in _turned_about(scene, turned).rooms:
        pieces = (replace(piece, wall=piece.wall or about[piece.id]) for piece in room.furniture)
        rooms.append(replace(room, furniture=tuple(pieces)))
    return replace(scene, rooms=tuple(rooms))


def _walls_of(named: Scene, known: Catalogs) -> dict[str, str | None]:
    """Returns the wall at the back of each piece, by its id; None where none is, or its kind does not stand at one."""
    settings = RepairSettings(known, moved=frozenset(piece.id for room in named.rooms for piece in room.furniture))
    told = [with_walls_told(room_problem(named, room, (), settings)) for room in named.rooms]
    return {piece.id: piece.wall for room in told for piece in room.furniture}


def _turned_about(scene: Scene, names: Set[str]) -> Scene:
    rooms = []
    for room in scene.rooms:
        pieces = (replace(one, rotation=(one.rotation + 180) % 360) if one.id in names else one for one in room.furniture)
        rooms.append(replace(room, furniture=tuple(pieces)))
    return replace(scene, rooms=tuple(rooms))


def _moved(far: float, rotation: float, drawn: float, broken: str | None) -> str:
    """Says how a piece was moved, m, and which rule it breaks where it is drawn, if it breaks one itself."""
    why = f"as it is drawn, {broken}" if broken else "others needed its place"
    turned = abs((rotation - drawn + 180) % 360 - 180)
    if not turned:
        return f"moved by {far:.2f} m: {why}" if far >= CENTIMETRE else f"moved by less than 1 cm: {why}"
    if far >= CENTIMETRE:
        return f"moved by {far:.2f} m and turned to {rotation:g} degrees: {why}"
    return f"turned by {turned:.2g} degrees to {rotation:g}: {why if broken else 'things stand along walls or across them'}"


def plan_format(name: str, content: bytes) -> str | None:
    """Returns the format of the file of another program's floor plan; None where it is none, or cannot be told.

    Raises:
        SyntaxFault: it is of a sort that people have plans in and that is not read (PDF, DWG, a picture), or compressed and broken.
    """
    content = unpacked(content)
    try:
        return format_of_plan(_file(name, content))
    except (FieldError, SyntaxFault):
        return None


def _read(file: PlanFile, settings: ImportSettings, catalogs: Catalogs) -> tuple[Scene, PlanNotes, str]:
    """Returns the scene in a file, what is said about it, and which format it is in."""
    format = format_of_plan(file)
    if format is None:
        notes = PlanNotes()
        scene = _own_scene(file, settings, notes)
        for place, meant in misspelt(scene).items():
            way, _, key = place.rpartition(".")
            notes.leave(way or "scene", f"no property is called {key!r:.60}; {meant}?")
        return scene, notes, OWN
    return *imported(file, format, settings, catalogs), format


def _file(name: str, content: object) -> PlanFile:
    """Returns a file with its document, where it is JSON."""
    if not isinstance(content, bytes):
        return PlanFile(name, b"{}", content)
    content = unpacked(content)
    start = content.lstrip(b"\xef\xbb\xbf \t\r\n")[:1]
    format = format_of_file(name, content)
    if format == "json" and start in (b"{", b"["):
        return PlanFile(name, content, load_text(content, "json"))
    return PlanFile(name, content)


def _loaded(file: PlanFile) -> object:
    """Reads a text as a scene's; of a file that is not called one it is first said that it is of no format."""
    try:
        return load_text(file.content, format_of_file(file.name, file.content))
    except SyntaxFault as fault:
        if format_of_name(file.name) in FORMATS or not file.content:
            raise
        if b"\0" in file.content or not str(fault).startswith("not "):
            raise SyntaxFault(f"{NO_FORMAT}, and no text in UTF-8") from None
        raise SyntaxFault(f"{NO_FORMAT}; read as a scene: {fault}") from None


def _own_scene(file: PlanFile, settings: ImportSettings, notes: PlanNotes) -> Scene:
    """Reads a scene of ours; one in which no door is as wide as a door in metres is in another unit, and that is noted.

    Raises:
        SyntaxFault: it is none, and no other format that is read here.
        FieldError: a field is wrong.
    """
    document = file.document if file.document is not None else _loaded(file)
    if isinstance(document, Mapping) and "scene" in document and "rooms" not in document:
        document = document["scene"]
    if isinstance(document, Mapping) and document.get("export") in (*EXPORTERS,):
        raise SyntaxFault(f"an export of ours, {document['export']}, which does not say all of a home: send the scene, as JSON or YAML")
    if not isinstance(document, Mapping) or "rooms" not in document:
        raise SyntaxFault(NO_FORMAT)
    metres = scene_unit(document, settings.unit, notes)
    scene = certified(read_scene(document if metres == 1.0 else in_metres(document, metres)))
    if settings.level is not None and settings.level not in {room.level for room in scene.rooms}:
        raise FieldError("level", f"{settings.level} has no rooms", ", ".join(map(str, sorted({room.level for room in scene.rooms}))))
    bare = tuple(replace(room, furniture=(), decorations=()) for room in scene.rooms)
    return scene if settings.furniture else replace(scene, rooms=bare, dynamic=(), certificate=None)
