"""All rules, in the order of the contract's table, and `validate`, which applies them.

Comes in: a scene and the catalogs. Goes out: issues. May import: scene, catalogs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Final, TypeAlias

from catalogs import Catalogs
from solver.scene import Issue, Scene
from solver.validate.floating import floating
from solver.validate.kinds import Kinds
from solver.validate.lattice import metres
from solver.validate.reaching import unreachable
from solver.validate.requirements import missing_required
from solver.validate.standing import Finding, blocks_door, blocks_window, out_of_bounds, overlap, wall_far
from solver.validate.walk import Walk, walks
from solver.validate.world import Place, World, home_of, world_of

Check: TypeAlias = Callable[[World, Walk, Place, Kinds], Iterator[Finding]]

RULES: Final = {
    "out_of_bounds": "error",
    "overlap": "error",
    "wall_far": "error",
    "blocks_door": "error",
    "blocks_window": "error",
    "unreachable": "error",
    "floating": "error",
    "missing_required": "warning",
}
"""Every rule and its severity, in the order issues are listed."""

_CHECKS: Final[dict[str, Check]] = {
    "out_of_bounds": lambda world, walk, place, kinds: out_of_bounds(world, place),
    "overlap": lambda world, walk, place, kinds: overlap(world, place),
    "wall_far": lambda world, walk, place, kinds: wall_far(world, place),
    "blocks_door": lambda world, walk, place, kinds: blocks_door(world, place),
    "blocks_window": lambda world, walk, place, kinds: blocks_window(world, place),
    "unreachable": unreachable,
    "floating": lambda world, walk, place, kinds: floating(world, place, kinds),
    "missing_required": lambda world, walk, place, kinds: missing_required(world, place, kinds),
}


def validate(scene: Scene, catalogs: Catalogs) -> tuple[Issue, ...]:
    """Lists what breaks the rules: room by room, in a room rule by rule, in a rule in the document's order.

    Args:
        scene: any scene that could be read.
        catalogs: which sides of a piece are used, and what room types require.

    Returns:
        Issues; amounts in metres. None with severity `error`: the scene is clean.
    """
    world, kinds = world_of(scene), Kinds(catalogs)
    walk_of = {place.room.id: walk for walk in walks(world) for place in walk.places}
    issues = list(_homeless(scene))
    for place in world.places:
        for rule, check in _CHECKS.items():
            issues += (_issue(rule, place.room.id, found) for found in check(world, walk_of[place.room.id], place, kinds))
    return tuple(issues)


def _issue(rule: str, room: str | None, found: Finding) -> Issue:
    return Issue(rule, RULES[rule], room, found.ids, metres(found.amount), found.message)


def _homeless(scene: Scene) -> Iterator[Issue]:
    """People and pets that are in no room of the scene leave every room's floor."""
    known = {room.id for room in scene.rooms}
    for person in scene.dynamic:
        if home_of(scene, person) not in known:
            message = f"{person.id} is in no room of the scene ({person.room or 'none given'})"
            yield _issue("out_of_bounds", None, Finding((person.id,), 0, message))
