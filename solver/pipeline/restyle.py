"""restyle(): a home in another style, or with other decorations, in place."""

from dataclasses import replace

from catalogs import Catalogs, load_catalogs
from solver.answers import Generated
from solver.certificate import certified
from solver.furnished import chosen_style, recoloured, with_materials
from solver.named_assets import with_assets
from solver.people import Household
from solver.pipeline.accessible import with_fronts
from solver.pipeline.inhabited import decorated, home_catalogs, inhabited
from solver.pipeline.room_spaces import spaces_in
from solver.pipeline.timing import Clock, Timing
from solver.scene import Room, Scene
from solver.streams import Stream
from solver.validator import check


def restyle(
    scene: Scene,
    *,
    style: str | None = None,
    decorate: bool | None = None,
    catalogs: Catalogs | None = None,
    clock: Clock | None = None,
) -> Generated:
    """Changes the style of a home, whether it is decorated, or both; its furniture stays where it stands.

    A generated home becomes the very one that its request makes with that style and those decorations. What is decorated is
    decorated anew, and who lives in it finds other places, out of the way of that.

    Args:
        scene: the home.
        style: a style's name: colours, floors and walls become its own. None: they stay.
        decorate: True decorates every room, False takes all decorations away, None leaves it as its request says.
        catalogs: what to decorate with; ours by default.
        clock: a clock in seconds, to fill `timing_ms`.

    Raises:
        RequestError: the catalogs do not know the style.

    Example:
        >>> from compose_homes import Request, generate, restyle
        >>> house = generate(Request(seed=42, width=7, depth=5, style="modern")).scene
        >>> restyle(house, style="rustic").scene == generate(Request(seed=42, width=7, depth=5, style="rustic")).scene
        True
    """
    known = catalogs or load_catalogs()
    timing, seed = Timing(clock), scene.seed or 0
    asked = dict(scene.request or {})
    was = asked.get("decorate") is True
    asked |= {} if style is None else {"style": chosen_style(style, known, seed)}
    asked |= {} if decorate is None else {"decorate": decorate}
    new = replace(scene, request=asked)
    if style is not None:
        new = replace(new, rooms=tuple(_in_style(room, known, style, seed) for room in new.rooms))
    timing.lap("style")
    if asked.get("decorate") is True or decorate is not None:
        new = decorated(new, {room.id for room in new.rooms}, known, seed)
        timing.lap("decorations")
        if scene.dynamic and (was or asked.get("decorate") is True):
            new = inhabited(new, new.rooms, Household(seed, home_catalogs(new, known), spaces_in(new)))
        timing.lap("people")
    checked = check(new, known)
    new = certified(with_fronts(new, checked))
    timing.lap("validate")
    return Generated(with_assets(new, known), checked.issues, timing.ms)


def _in_style(room: Room, known: Catalogs, style: str, seed: int) -> Room:
    """Returns a room with the colours, the floor and the walls of a style."""
    own = known.styles[style]
    return with_materials(recoloured(room, known, Stream(seed, "colour", room.index), own), known, own, seed)
