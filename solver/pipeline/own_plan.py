"""furnish(): somebody's own plan -> its rooms' types and main entrance, where it says none -> reroll of its rooms.

Not here: how a room is furnished (generate).
"""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, Final

from catalogs import Catalogs, load_catalogs
from solver.answers import KEEPS, FurnishedPlan
from solver.errors import RequestError, SceneError
from solver.floorplan import program_counts, program_of
from solver.furnished import chosen_style, recoloured, with_materials
from solver.guessing import guessed_types, is_shaft, with_entrance, with_types
from solver.pipeline.accessible import walked_by, with_access
from solver.pipeline.generate import generator, reroll_plan
from solver.pipeline.timing import Clock, Timing
from solver.plain import quoted
from solver.scene import Room, Scene
from solver.scene_bodies import check_id, check_ids, check_is, check_scene
from solver.streams import Stream
from solver.understanding import understood
from solver.validator import check, sharing_floor, validate

HOME: frozenset[str] = frozenset({"kitchen", "bathroom", "living_room"})
"""Types of which two make a home: its rooms hold what it has no room for, such as a bed where there is no bedroom."""
_UNKNOWN: Final = "there is no furniture for what is called {called}: say which type the room has, if it has one"

_SHARED: Final = "shares floor with {other}: what stands in one would stand in the other"
_SHAFT: Final = "nobody can stand in it: it stays empty, as a shaft or a cupboard in a wall does"


def furnish(  # noqa: PLR0913 - keyword-only options of a public function
    scene: Scene,
    rooms: Sequence[str] = (),
    *,
    keep: str = KEEPS[0],
    types: Mapping[str, str] | None = None,
    program: Mapping[str, int] | str | None = None,
    style: str | None = None,
    decorate: bool | None = None,
    access: str | None = None,
    seed: int | None = None,
    catalogs: Catalogs | None = None,
    clock: Clock | None = None,
) -> FurnishedPlan:
    """Furnishes, decorates and peoples the rooms of a plan; its walls, doors and windows stay.

    Types that are missing or that the catalogs do not know are guessed, and a main entrance is chosen where there is none.

    Args:
        scene: the plan.
        rooms: ids of the rooms to furnish; by default the empty ones with `keep` all, else every room.
        keep: what stays in them: "all" that stands there, what is "locked", or "none" of it.
        types: room types by room id, instead of what the scene says.
        program: how many rooms of each word the home has, or a preset's name, to guess by.
        style: of the home; by default the scene's own, else one of the seed's.
        decorate: whether surfaces, walls and floors are decorated; by default as the scene's request says.
        access: a profile that the rooms are furnished for, or "none"; by default as the scene's request says.
        seed: of all chance; by default the scene's own, else 0.
        catalogs: what to furnish with; ours by default.
        clock: a clock in seconds, to fill `timing_ms`; the scene does not depend on it.

    Raises:
        SceneError: a room's id is not in the scene.
        RequestError: the programme, the style, the profile or a room type is not known.

    Example:
        >>> from compose_homes import Room, Scene, furnish
        >>> plan = Scene(rooms=(Room(id="r1", type="Schlafzimmer", width=4.0, depth=3.5),))
        >>> made = furnish(plan, seed=1)
        >>> made.guesses[0].type, any(piece.name == "bed" for piece in made.scene.rooms[0].furniture)
        ('bedroom', True)
    """
    known = catalogs or load_catalogs()
    check_scene(scene)
    ids = [room.id for room in scene.rooms]
    check_ids(ids, rooms=rooms)
    check_is("types", types or {}, Mapping, "a mapping of rooms to types")
    for name in types or ():
        check_id(f"types.{name}", name, ids)
    if keep not in KEEPS:
        raise RequestError("keep", f"is {keep!r:.60}", ", ".join(KEEPS))
    timing = Timing(clock)
    drawn = (scene.seed or 0) if seed is None else seed
    counted = None if program is None else program_counts(program, known)
    named = understood(_typed(scene, types or {}, known), known)
    guesses = guessed_types(named.scene, known, counted)
    plan, entrance = with_entrance(with_types(named.scene, {guess.room: guess.type for guess in guesses}, known), known)
    asked = set(rooms) or {room.id for room in plan.rooms if keep != "all" or not room.furniture}
    told = {"style": _style_of(plan, style, known, drawn), "decorate": decorate, **walked_by(plan, access, known)}
    plan = _with_request(_of_seed(plan, drawn, known), known, program, told)
    plan = _with_finishes(plan, known, drawn)
    timing.lap("guesses")
    done, left = _furnished_rooms(plan, asked, keep, drawn, known)
    done = with_access(named.in_their_words(done), known)
    timing.lap("rooms")
    issues = validate(done, known)
    timing.lap("validate")
    return FurnishedPlan(done, guesses, entrance, left, issues, timing.ms)


def _typed(scene: Scene, types: Mapping[str, str], known: Catalogs) -> Scene:
    """Returns a scene whose rooms have the types they were told; refuses one that the catalogs do not know."""
    for name, told in types.items():
        if told not in known.rooms:
            raise RequestError(f"types.{name}", f"unknown room type {told!r:.60}", ", ".join(sorted(known.rooms)))
    return with_types(scene, types, known, stays=False)


def _of_seed(scene: Scene, seed: int, known: Catalogs) -> Scene:
    """Returns a scene that says what it is made from, where it does not yet."""
    return replace(scene, seed=seed if scene.seed is None else scene.seed, generator=scene.generator or generator(known))


def _style_of(scene: Scene, style: str | None, known: Catalogs, seed: int) -> str | None:
    own = (scene.request or {}).get("style")
    return own if style is None and isinstance(own, str) and own in known.styles else chosen_style(style, known, seed)


def _with_request(scene: Scene, known: Catalogs, program: Mapping[str, int] | str | None, told: Mapping[str, Any]) -> Scene:
    """Returns a scene whose request says how it is furnished; a home's, also which rooms it has."""
    request: dict[str, Any] = dict(scene.request or {})
    types = Counter(room.type for room in scene.rooms)
    if program is None and scene.request is None and len(HOME & types.keys()) > 1:
        program = program_of(list(types.elements()), known)
    every = {"program": dict(program) if isinstance(program, Mapping) else program, **told}
    return replace(scene, request={**request, **{key: value for key, value in every.items() if value is not None}})


def _with_finishes(scene: Scene, known: Catalogs, seed: int) -> Scene:
    """Returns a scene whose rooms have floors and walls of its style, and furniture its colours, where they say none."""
    style = known.styles.get(str((scene.request or {}).get("style")))

    def finished(room: Room) -> Room:
        room = recoloured(room, known, Stream(seed, "colour", room.index), style, bare=True)
        made = with_materials(room, known, style, seed)
        return replace(made, flooring=room.flooring or made.flooring, walls=room.walls or made.walls)

    return replace(scene, rooms=tuple(finished(room) for room in scene.rooms))


def _furnished_rooms(scene: Scene, asked: set[str], keep: str, seed: int, known: Catalogs) -> tuple[Scene, dict[str, str]]:
    """Furnishes the rooms asked for: the empty ones together, those in which something stays one by one, those that share floor not at all.

    Returns the scene, and why rooms were left as they were.
    """
    shared = {name: _SHARED.format(other=other) for name, other in sharing_floor(check(scene, known).cases).items() if name in asked}
    asked = asked - shared.keys()
    if keep == "none":
        bare = (replace(room, furniture=(), decorations=()) if room.id in asked else room for room in scene.rooms)
        scene = replace(scene, rooms=tuple(bare))
    stays = {room.id for room in scene.rooms if any(keep == "all" or piece.locked for piece in room.furniture)}
    empty = [room for room in scene.rooms if room.id in asked and room.id not in stays]
    if empty:
        scene = reroll_plan(scene, [room.id for room in empty], seed, known)
    unknown = [room for room in empty if room.type not in known.rooms]
    called = {room.id: ("" if is_shaft(room, scene) else room.type) if room.name is None else room.name for room in unknown}
    left = shared | {name: _UNKNOWN.format(called=quoted(word)) if word else _SHAFT for name, word in called.items()}
    for name in [room.id for room in scene.rooms if room.id in asked & stays]:
        try:
            scene = _around_all(scene, name, seed, known) if keep == "all" else reroll_plan(scene, [name], seed, known)
        except SceneError as error:
            left[name] = error.problem
    return _noted(scene, left), left


def _noted(scene: Scene, left: Mapping[str, str]) -> Scene:
    """Returns a scene whose certificate says of its rooms why they were left as they were."""
    if not left:
        return scene
    document: dict[str, Any] = dict(scene.certificate or {})
    rooms = dict(document.get("rooms") or {})
    for name, reason in left.items():
        rooms[name] = {**rooms.get(name, {}), "notes": [reason]}
    return replace(scene, certificate={**document, "rooms": rooms})


def _around_all(scene: Scene, name: str, seed: int, known: Catalogs) -> Scene:
    """Furnishes a room around all that stands in it."""
    sent = {piece.id: piece.locked for room in scene.rooms if room.id == name for piece in room.furniture}

    def locking(room: Room, locks: Mapping[str, bool]) -> Room:
        return replace(room, furniture=tuple(replace(piece, locked=locks.get(piece.id, piece.locked)) for piece in room.furniture))

    def with_locks(whole: Scene, locks: Mapping[str, bool]) -> Scene:
        return replace(whole, rooms=tuple(locking(room, locks) if room.id == name else room for room in whole.rooms))

    held = with_locks(scene, dict.fromkeys(sent, True))
    return with_locks(reroll_plan(held, [name], seed, known), sent)
