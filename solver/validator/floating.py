"""The rule `floating`: a decoration lies on something, or hangs at its wall; furniture stands `on` what it says.

Comes in: a `World`, one of its places and the catalogs. Goes out: findings. May import: scene, catalogs.

A parent of a kind and size that the catalogs know carries things on its surfaces, each as far in from its edges as the kind says. Any
other parent is what its sizes say: it carries on all of its top, and at the heights that the catalogs know for its name. A thing
without a parent, or whose parent is not in the room, lies on the floor or on any of the room's bodies. Furniture that says `on`
what it stands is judged like a thing with that parent; of other furniture nothing is said: a cupboard may hang.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Final, NamedTuple, TypeAlias

from solver.scene import Decoration, Furniture
from solver.validator.judging import Finding, RuleCase
from solver.validator.kinds import Kinds
from solver.validator.lattice import ExactBox, WallEdge, exact, words
from solver.validator.world import box_of

RESTS: Final = exact(0.01)
"""A thing lies on a surface whose height differs by no more; our choice: scenes rounded to centimetres stay clean."""
HANGS: Final = exact(0.03)
"""A thing hangs at a wall whose face is no farther; our choice, as wall-hugging furniture stands."""


Thing: TypeAlias = Furniture | Decoration


class Support(NamedTuple):
    """What carries: a rectangle at a height, of the body of that id (None: the floor)."""

    id: str | None
    box: ExactBox
    level: int


def floating(case: RuleCase) -> Iterator[Finding]:
    """A body's middle is not over a surface of what carries it at its height, or a decoration hangs at no wall."""
    room = case.room.room
    bodies: dict[str, Thing] = {piece.id: piece for piece in room.furniture}
    bodies |= {thing.id: thing for thing in room.decorations}
    for piece in room.furniture:
        if piece.on is not None:
            yield from _not_carried(case, piece, bodies)
    for thing in room.decorations:
        if thing.mounted_on_wall is not None:
            yield from _off_its_wall(case, thing)
        else:
            yield from _not_carried(case, thing, bodies)


def _not_carried(case: RuleCase, thing: Thing, bodies: Mapping[str, Thing]) -> Iterator[Finding]:
    parent = bodies.get(_below(thing))
    if parent is not None and _carries_itself(thing, bodies):
        how = "its own parent" if parent is thing else f"on {parent.id}, and that on {thing.id} in the end"
        yield Finding((thing.id,), 0, f"{thing.id} is {how}: nothing carries it")
        return
    if parent is not None:
        found = list(_supports(parent, case.kinds))
    else:
        others = [body for body in bodies.values() if body is not thing]
        found = [Support(None, case.room.outline.bounds, 0), *(one for body in others for one in _supports(body, case.kinds))]
    yield from _unsupported(thing, found, parent)


def _below(body: Thing) -> str:
    """Returns the id of what a body says carries it; nothing for what hangs: its wall does."""
    if isinstance(body, Decoration):
        return (body.parent or "") if body.mounted_on_wall is None else ""
    return body.on or ""


def _carries_itself(thing: Thing, bodies: Mapping[str, Thing]) -> bool:
    """Tells whether what carries a thing, and what carries that, comes back to the thing."""
    seen, at = {""}, _below(thing)
    while at not in seen:
        seen.add(at)
        if at == thing.id:
            return True
        at = _below(bodies[at]) if at in bodies else ""
    return False


def _supports(body: Thing, kinds: Kinds) -> Iterator[Support]:
    size = body.width, body.depth, body.height
    box, low = box_of(body), exact(body.y)
    for height, inset in kinds.surfaces(body.name, size):
        yield Support(body.id, box.grown(-exact(inset)), low + exact(height))


def _unsupported(thing: Thing, supports: Sequence[Support], parent: Thing | None) -> Iterator[Finding]:
    x, y, z = exact(thing.x), exact(thing.y), exact(thing.z)
    misses = [(_miss(support, x, y, z), support) for support in supports]
    if any(miss == (0, 0) for miss, _ in misses):
        return
    own = "its parent " if isinstance(thing, Decoration) else ""
    below = f"{own}{parent.id}" if parent is not None else "anything"
    (beside, above), _ = min(misses, key=lambda miss: max(miss[0]))
    how = f"{words(above)} above or below" if above >= beside else f"with its middle {words(beside)} beside"
    yield Finding((thing.id,), max(beside, above), f"{thing.id} floats {how} what could carry it on {below}")


def _miss(support: Support, x: int, y: int, z: int) -> tuple[int, int]:
    """Returns how far a middle is beside a support, and how far above or below it."""
    box = support.box
    beside = max(box.x0 - x, x - box.x1, box.z0 - z, z - box.z1, 0)
    apart = abs(y - support.level)
    return beside, apart if apart > RESTS else 0


def _off_its_wall(case: RuleCase, thing: Decoration) -> Iterator[Finding]:
    place = case.room
    box = box_of(thing)
    away = min((_away(edge, box, case.world.half_wall) for edge in place.edges if edge.side == thing.mounted_on_wall), default=None)
    if away is None:
        yield Finding((thing.id,), 0, f"{thing.id} hangs at the {thing.mounted_on_wall} wall, which {place.room.id} does not have")
    elif away > HANGS:
        where = f"{words(away)} from the face of the {thing.mounted_on_wall} wall of {place.room.id}"
        yield Finding((thing.id,), away, f"{thing.id} floats {where}")


def _away(edge: WallEdge, box: ExactBox, half_wall: int) -> int:
    """Returns how far a box's back is from a piece of wall's face, or its middle from that piece's ends."""
    line = {"north": box.z0, "south": box.z1, "west": box.x0, "east": box.x1}[edge.side]
    face = edge.line + (half_wall if edge.side in ("north", "west") else -half_wall)
    middle = (box.x0 + box.x1) // 2 if edge.runs_east else (box.z0 + box.z1) // 2
    return max(abs(line - face), edge.start - middle, middle - edge.end)
