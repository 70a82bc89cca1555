"""generate() and reroll(): request -> floor plan -> wanted pieces -> places -> checked scene, top to bottom."""

import secrets
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from catalogs import Catalogs, load_catalogs
from catalogs.styles import Style
from solver.answers import Generated
from solver.certificate import certificate, room_certificate
from solver.exchange import checked_request, write_request
from solver.floorplan import FloorPlan, door_positions, draw, wall_thickness_of, with_door_at
from solver.furnish import LowRooms, as_low_as, space_of, unwanted_pieces, wanted_pieces, wanted_rows
from solver.furnished import chosen_style, furnished, names_placed, with_materials
from solver.geometry import to_m
from solver.named_assets import with_assets
from solver.people import Household
from solver.pieces import Arrangement, Piece, Space
from solver.pipeline.accessible import with_access, with_fronts, with_walker
from solver.pipeline.inhabited import arranged, decorated, home_catalogs, inhabited, needed, parted
from solver.pipeline.insisted import dear_in, insisted_in, insisting
from solver.pipeline.reasons import with_lengths
from solver.pipeline.room_spaces import as_joined, cover_mm2, spaces_in
from solver.pipeline.staying import Staying, around, refuse, rejoined, staying_in, with_things
from solver.pipeline.timing import Clock, Timing
from solver.placement import place, place_wanted
from solver.records import changed
from solver.request import MAX_SEED, Request
from solver.scene import ROBOT_WIDTH, Level, Room, Scene, Size, robot_width_of
from solver.scene_bodies import check_ids, check_scene, storey_height
from solver.streams import Stream
from solver.validator import RULES, check, check_made, validate
from solver.version import VERSION

STOREY_HEIGHT = 2.8
"""Height of a storey, m."""
SMALL_ROOMS = 40
"""Rooms of a house, too small for their type, whose doors are tried elsewhere and whose missing pieces are explained in lengths."""
SHIFTS = 6
"""Places tried for each door of a room whose required or dear piece does not fit."""

_Asked = tuple[Staying, Space, tuple[Piece, ...]]
"""What stays in a room, and what is wanted around that."""


@dataclass(frozen=True)
class _Setting:
    """What every furnishing of one house shares."""

    seed: int
    catalogs: Catalogs
    engine: str
    thickness: float
    robot_width: float = ROBOT_WIDTH
    style: Style | None = None
    staying: Mapping[str, Staying] = field(default_factory=dict)
    """What stays in rooms that are furnished anew, by their ids."""
    others: Sequence[Room] = ()
    """The rooms of a scene that is furnished: one may list a door into another alone."""
    heights: Mapping[int, float] = field(default_factory=dict)
    """How high the rooms of the storeys are, m, where not as usual."""
    asked: dict[tuple[str, str | None], _Asked] = field(default_factory=dict, compare=False)
    """What was found of rooms in which something stays, by their ids and what is insisted on in them."""
    spaces: dict[str, tuple[Room, Space]] = field(default_factory=dict, compare=False)
    """The rooms that were looked at last, and their spaces, by the rooms' ids."""


def generate(
    request: Request | None = None,
    *,
    catalogs: Catalogs | None = None,
    engine: str = "osqp",
    clock: Clock | None = None,
) -> Generated:
    """Makes a furnished house.

    Args:
        request: what is wished; a seed is drawn and echoed when it has none.
        catalogs: what to furnish with; ours by default.
        engine: who confirms the optimum, "osqp" or "reference".
        clock: a clock in seconds, to fill `timing_ms`; the scene does not depend on it.

    Raises:
        RequestError: a field of the request is wrong, or cannot be met by any house.

    Example:
        >>> from compose_homes import Request, generate
        >>> made = generate(Request(seed=42, width=7, depth=5))
        >>> made.scene.size.width, [issue for issue in made.issues if issue.severity == "error"]
        (7.0, [])
    """
    known = catalogs or load_catalogs()
    asked = Request() if request is None else checked_request(request)
    seed = secrets.randbelow(MAX_SEED + 1) if asked.seed is None else asked.seed
    asked = with_walker(changed(asked, seed=seed, style=chosen_style(asked.style, known, seed)), known)
    setting = _Setting(seed, known, engine, wall_thickness_of(asked), asked.robot_width, known.styles.get(asked.style or ""))
    timing = Timing(clock)
    made_for = known.for_access(asked.access)
    plan = draw(asked, made_for)
    setting = changed(setting, catalogs=made_for.of_home([room.type for room in plan.rooms], asked.planned))
    timing.lap("floorplan")
    setting, arrangements = _furnished_rooms(plan.rooms, setting)
    plan, arrangements = _shifted(plan, arrangements, setting)
    scene = changed(_scene(plan, arrangements, asked, setting), generator=generator(known))
    timing.lap("furniture")
    spaces = {room.id: _space(room, setting) for room in plan.rooms}
    scene = decorated(scene, {room.id for room in scene.rooms}, known, seed, lambda room: spaces[room.id])
    timing.lap("decorations")
    scene = inhabited(scene, scene.rooms, Household(seed, setting.catalogs, lambda room: spaces[room.id]))
    timing.lap("people")
    checked = check_made(scene, known)
    scene = with_access(with_fronts(scene, checked), known)
    timing.lap("validate")
    return Generated(with_assets(scene, known), checked.issues, timing.ms)


def _furnished_rooms(rooms: Sequence[Room], setting: _Setting) -> tuple[_Setting, dict[str, Arrangement]]:
    """Furnishes rooms, those last that ask what stands in others: these insist on what none has. Returns the setting that knows."""
    first, last = parted(rooms, setting.catalogs)
    made = _arrangements(first, setting)
    if last:
        setting = changed(setting, catalogs=setting.catalogs.holding(arranged(made, setting.catalogs)))
        asked, alone = _arrangements(last, setting), len(setting.others or rooms) == 1
        for room in last:
            gone = {label for label, _ in asked[room.id].left_out}
            lacking = set() if alone else gone & needed(room, setting.catalogs)
            made[room.id] = _insisted(room, asked[room.id], setting, lacking) if lacking else asked[room.id]
    return setting, made


def _shifted(plan: FloorPlan, arrangements: dict[str, Arrangement], setting: _Setting) -> tuple[FloorPlan, dict[str, Arrangement]]:
    """Insists on a dear piece, and shifts a door where that or a required one would not fit otherwise; says why one does not."""
    lacking = [room.id for room in plan.rooms if _missing(arrangements[room.id], room, setting)]
    for room_id in lacking[:SMALL_ROOMS]:
        room = next(room for room in plan.rooms if room.id == room_id)
        arrangements[room_id] = _with_dear(room, arrangements[room_id], setting)
        if _missing(arrangements[room.id], room, setting):
            plan = _shift_doors(plan, room, arrangements, setting)
    return plan, _explained(plan.rooms, arrangements, setting) if lacking else arrangements


def generator(catalogs: Catalogs) -> dict[str, Any]:
    """Returns what a scene says of the Compose and the catalogs that it was made with."""
    return {"version": VERSION, "catalog": catalogs.fingerprint}


def wanted_in(scene: Scene, room: Room, catalogs: Catalogs) -> tuple[Space, tuple[Piece, ...]]:
    """Returns what placement was asked for in a room of a generated scene: the room's space, and the pieces with their candidates."""
    return _wished(room, _setting_of(scene, catalogs, scene.seed or 0), insisted_in(scene.certificate, room.id))


def unwanted_in(scene: Scene, room: Room, catalogs: Catalogs) -> tuple[tuple[str, str], ...]:
    """Returns what else the type of a room of a generated scene lists, with the reasons why that is not wanted."""
    setting = _setting_of(scene, catalogs, scene.seed or 0)
    space, wanted = _wished(room, setting, insisted_in(scene.certificate, room.id))
    return unwanted_pieces(room, space, _low(room.level, setting).catalogs, _furnishing(room, setting), wanted)


def _furnishing(room: Room, setting: _Setting) -> Stream:
    return Stream(setting.seed, "furnish", room.index)


def _wished(room: Room, setting: _Setting, insisted: str | None = None) -> tuple[Space, tuple[Piece, ...]]:
    return _around(room, setting, insisted)[1:]


def _around(room: Room, setting: _Setting, insisted: str | None) -> _Asked:
    if (room.id, insisted) in setting.asked:
        return setting.asked[room.id, insisted]
    space = _space(room, setting)
    wanted = wanted_pieces(room, space, _low(room.level, setting).catalogs, _furnishing(room, setting), insisted)
    staying = setting.staying.get(room.id)
    if not staying:
        return Staying(room), space, wanted
    return setting.asked.setdefault((room.id, insisted), around(staying, space, wanted, setting.catalogs))


def _space(room: Room, setting: _Setting) -> Space:
    known = setting.spaces.get(room.id)
    if known is None or known[0] is not room:
        space = space_of(room, setting.thickness, setting.robot_width, setting.others, cover_mm2(room, setting.catalogs, setting.seed))
        known = setting.spaces[room.id] = room, as_joined(room, space, setting.others)
    return known[1]


def _arrangements(rooms: Sequence[Room], setting: _Setting, insisted: str | None = None) -> dict[str, Arrangement]:
    """Furnishes rooms: by the core in one go, or from pieces, where some stay."""
    low = {level: _low(level, setting) for level in {room.level for room in rooms}}
    if _is_in_one_go(setting):
        each = [(room, _space(room, setting), low[room.level].catalogs, _furnishing(room, setting), insisted) for room in rooms]
        made = place_wanted([wanted_rows(*one) for one in each], tidy=True, engine=setting.engine)
    else:
        made = place([_wished(room, setting, insisted) for room in rooms], setting.engine, tidy=True)
    return {room.id: _with_too_high(done, low[room.level].left_out.get(room.type)) for room, done in zip(rooms, made, strict=True)}


def _with_too_high(done: Arrangement, too_high: Sequence[tuple[str, str]] | None) -> Arrangement:
    return replace(done, left_out=(*done.left_out, *too_high)) if too_high else done


def _low(level: int, setting: _Setting) -> LowRooms:
    return as_low_as(setting.heights.get(level, STOREY_HEIGHT), setting.catalogs)


def _is_in_one_go(setting: _Setting) -> bool:
    return not setting.staying


def _explained(rooms: Sequence[Room], arrangements: Mapping[str, Arrangement], setting: _Setting) -> dict[str, Arrangement]:
    """Says in lengths why required pieces are missing, in the first SMALL_ROOMS rooms that miss some."""
    lacking = [room for room in rooms if _missing(arrangements[room.id], room, setting)][:SMALL_ROOMS]
    return {**arrangements, **{room.id: with_lengths(*_wished(room, setting), arrangements[room.id]) for room in lacking}}


def _dear(room: Room, arrangement: Arrangement, setting: _Setting) -> frozenset[str]:
    return dear_in(setting.catalogs, room.type).intersection([label for label, _ in arrangement.left_out])


def _missing(arrangement: Arrangement, room: Room, setting: _Setting) -> int:
    """Returns how many of the room type's requirements the arrangement does not meet, and how many dear pieces it leaves out."""
    room_type = setting.catalogs.rooms.get(room.type)
    if room_type is None:
        return 0
    names = names_placed(arrangement, setting.catalogs) if room_type.requires else []
    unmet = sum(not any(names.count(name) >= number for name, number in either.items()) for either in room_type.requires)
    return len(_dear(room, arrangement, setting)) + unmet


def _insisted(room: Room, arrangement: Arrangement, setting: _Setting, mattering: Collection[str] = ()) -> Arrangement:
    """Insists on a piece that matters and that an arrangement leaves out."""
    return insisting(arrangement, lambda label: _arrangements([room], setting, label)[room.id], mattering)


def _with_dear(room: Room, arrangement: Arrangement, setting: _Setting) -> Arrangement:
    """Insists on a dear piece that an arrangement leaves out."""
    return _insisted(room, arrangement, setting, dear) if (dear := _dear(room, arrangement, setting)) else arrangement


def _shift_doors(plan: FloorPlan, room: Room, arrangements: dict[str, Arrangement], setting: _Setting) -> FloorPlan:
    """Tries other places for a room's doors; keeps the first that lets more of these pieces in, both sides counted."""
    for opening in room.openings:
        if opening.kind not in ("door", "passage"):
            continue
        for position in door_positions(plan, opening.id)[:SHIFTS]:
            shifted = with_door_at(plan, opening.id, position)
            tried = _improved(shifted, room.id, opening.id, arrangements, setting)
            if tried is not None:
                arrangements.update(tried)
                return shifted
    return plan


def _improved(
    shifted: FloorPlan, room_id: str, door: str, arrangements: Mapping[str, Arrangement], setting: _Setting
) -> dict[str, Arrangement] | None:
    """Furnishes both sides of a shifted door anew; returns them if more of these pieces stand, both sides counted."""
    sides = [room for room in shifted.rooms if any(opening.id == door for opening in room.openings)]
    sides.sort(key=lambda side: side.id != room_id)
    gained, tried = 0, dict[str, Arrangement]()
    for side in sides:
        tried[side.id] = _with_dear(side, _arrangements([side], setting)[side.id], setting)
        gained += _missing(arrangements[side.id], side, setting) - _missing(tried[side.id], side, setting)
        if gained <= 0:
            return None
    return tried


def _written(rooms: Iterable[Room], arrangements: Mapping[str, Arrangement], setting: _Setting) -> tuple[Room, ...]:
    """Writes the furniture into its rooms, in the colours of the house's style."""
    known, style, seed = setting.catalogs, setting.style, setting.seed
    return tuple(furnished(room, arrangements[room.id], known, Stream(seed, "colour", room.index), style) for room in rooms)


def _scene(plan: FloorPlan, arrangements: Mapping[str, Arrangement], request: Request, setting: _Setting) -> Scene:
    bare = (with_materials(room, setting.catalogs, setting.style, setting.seed) for room in plan.rooms)
    rooms, outline = _written(bare, arrangements, setting), plan.drawing.layout.outline
    of_plan = {
        "spine": plan.spine,
        "unjoined": [list(pair) for pair in plan.unjoined],
        "notes": list(plan.notes),
    }
    return Scene(
        seed=setting.seed,
        request=write_request(request if request.planned else changed(request, width=request.extents[0], depth=request.extents[1])),
        size=Size(to_m(outline.width), to_m(outline.depth), STOREY_HEIGHT),
        wall_thickness=setting.thickness,
        levels=(Level(0, 0.0, STOREY_HEIGHT),),
        rooms=rooms,
        corridors=plan.corridors,
        adjacency=plan.adjacency,
        certificate=certificate(rooms, arrangements, RULES, of_plan),
    )


def reroll(
    scene: Scene,
    rooms: Sequence[str],
    *,
    seed: int | None = None,
    catalogs: Catalogs | None = None,
    clock: Clock | None = None,
) -> Generated:
    """Furnishes and peoples the named rooms of a scene anew, in the style of the house; the others stay untouched.

    What is locked in them stays where it is, with what lies on it; the rest is furnished around it.

    Args:
        scene: the house; its openings stay.
        rooms: ids of the rooms to furnish.
        seed: of the furnishing; the scene's own by default.
        catalogs: what to furnish with; ours by default.
        clock: a clock in seconds, to fill `timing_ms`.

    Raises:
        SceneError: a room's id is not in the scene, or nothing valid was found around what is locked in it.

    Example:
        >>> from compose_homes import Request, generate, reroll
        >>> house = generate(Request(seed=42, width=7, depth=5)).scene
        >>> other = reroll(house, [house.rooms[0].id], seed=7).scene
        >>> other.rooms[1].furniture == house.rooms[1].furniture
        True
    """
    known = catalogs or load_catalogs()
    return _rerolled(scene, rooms, ((scene.seed if seed is None else seed) or 0, False), known, Timing(clock))


def reroll_plan(scene: Scene, rooms: Sequence[str], seed: int, known: Catalogs) -> Scene:
    """Furnishes rooms of somebody's own plan as `reroll` does, insisting in each on what matters and was left out."""
    return _rerolled(scene, rooms, (seed, True), known, Timing(None)).scene


def _is_planned_whole(room: Room, setting: _Setting) -> bool:
    """Tells whether the pieces of a room's type stand in a run, which is planned as a whole."""
    kind = setting.catalogs.rooms.get(room.type)
    return kind is not None and kind.run is not None


def _rerolled(scene: Scene, rooms: Sequence[str], how: tuple[int, bool], known: Catalogs, timing: Timing) -> Generated:
    """Furnishes rooms anew; `how` is the seed, and whether it is insisted on what matters."""
    check_scene(scene)
    check_ids([room.id for room in scene.rooms], reroll=rooms)
    chosen = [room for room in scene.rooms if room.id in set(rooms)]
    stays = {room.id: staying for room in chosen if (staying := staying_in(room)).ids}
    setting, arrangements = _furnished_rooms(chosen, _setting_of(scene, known, how[0], stays, [room.id for room in chosen]))
    if how[1]:
        for room in (one for one in chosen if not _is_planned_whole(one, setting)):
            arrangements[room.id] = _insisted(room, arrangements[room.id], setting)
    arrangements = _explained(chosen, arrangements, setting)
    done = _rejoined(chosen, arrangements, setting)
    document: dict[str, Any] = dict(scene.certificate or {})
    reports = {name: room_certificate(arrangements[name], room) for name, room in done.items()}
    document["rooms"] = {**(document.get("rooms") or {}), **reports}
    new = replace(scene, rooms=tuple(done.get(room.id, room) for room in scene.rooms), certificate=document)
    timing.lap("furniture")
    new = decorated(new, done, known, setting.seed)
    new = replace(new, rooms=tuple(with_things(room, stays[room.id]) if room.id in stays else room for room in new.rooms))
    timing.lap("decorations")
    household = Household(setting.seed, setting.catalogs, spaces_in(new))
    new = inhabited(new, [room for room in new.rooms if room.id in done], household, scene.dynamic)
    timing.lap("people")
    checked = check(new, known)
    new, issues = with_access(with_fronts(new, checked, done), known), checked.issues
    if stays:
        before = {(issue.rule, issue.ids) for issue in validate(scene, known)}
        refuse(rooms, stays, {issue.room for issue in issues if issue.severity == "error" and (issue.rule, issue.ids) not in before})
    timing.lap("validate")
    return Generated(with_assets(new, known), issues, timing.ms)


def _setting_of(
    scene: Scene, known: Catalogs, seed: int, staying: Mapping[str, Staying] | None = None, anew: Sequence[str] = ()
) -> _Setting:
    """Returns what a furnishing of a scene's rooms shares: that of its house, around what stays in them; those `anew` hold nothing yet."""
    home, style = home_catalogs(scene, known, anew), _style_of(scene, known)
    heights = {level: storey_height(scene, level) for level in {room.level for room in scene.rooms}}
    return _Setting(seed, home, "osqp", scene.wall_thickness, robot_width_of(scene), style, staying or {}, scene.rooms, heights)


def _rejoined(rooms: Sequence[Room], arrangements: Mapping[str, Arrangement], setting: _Setting) -> dict[str, Room]:
    """Writes the furniture into its rooms, around what stays in them; refuses what cannot be furnished around."""
    there = [room for room in rooms if room.id in setting.staying]
    stays = {room.id: _around(room, setting, arrangements[room.id].insisted)[0] for room in there}
    wrong = {name for name, staying in stays.items() if not staying.are_in(arrangements[name])}
    refuse([room.id for room in rooms], stays, wrong)
    new = {name: replace(arrangements[name], placed=staying.new_in(arrangements[name])) for name, staying in stays.items()}
    done = {room.id: room for room in _written(rooms, {**arrangements, **new}, setting)}
    return done | {name: rejoined(done[name].furniture, new[name].placed, staying) for name, staying in stays.items()}


def _style_of(scene: Scene, known: Catalogs) -> Style | None:
    """Returns the style a scene says it was made in; None where it says none that the catalogs know."""
    name = (scene.request or {}).get("style")
    return known.styles.get(name) if isinstance(name, str) else None
