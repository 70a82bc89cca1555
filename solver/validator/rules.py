"""All rules, in the order of the table in docs/scene.md."""

from collections.abc import Callable, Iterable, Iterator
from typing import Final

from solver.answers import Issue
from solver.demanded import demand
from solver.scene import Scene
from solver.scene_bodies import home_of
from solver.validator.judging import FINDING_WORK, JUDGED, Finding, RuleCase
from solver.validator.lattice import metres
from solver.validator.opening import front_blocked
from solver.validator.room_rules import missing_required, opening_wrong, rooms_overlap, unreachable
from solver.validator.standing import above_ceiling, blocks_door, blocks_window, floating, out_of_bounds, overlap, shapes_cross, wall_far

_SEVERITIES: Final[dict[Callable[[RuleCase], Iterator[Finding]], str]] = {
    out_of_bounds: "error",
    overlap: "error",
    wall_far: "error",
    blocks_door: "error",
    blocks_window: "error",
    unreachable: "error",
    floating: "error",
    above_ceiling: "error",
    missing_required: "warning",
    shapes_cross: "warning",
    front_blocked: "warning",
    rooms_overlap: "warning",
    opening_wrong: "warning",
}
"""What checks a rule in one room, a function of the rule's name, and its severity, in the order issues are listed."""
RULES: Final = {check.__name__: severity for check, severity in _SEVERITIES.items()}
"""Every rule and its severity."""
CHECKS: Final = {check.__name__: check for check in _SEVERITIES}
UNJUDGED: Final = tuple([rule for rule in RULES if rule not in JUDGED])
"""The rules that the core does not judge."""


def issues_of(rules: Iterable[str], case: RuleCase) -> dict[str, tuple[Issue, ...]]:
    """Lists what breaks rules in one room, by those of them that something breaks; what the core found was counted before."""
    found = dict[str, tuple[Issue, ...]]()
    for rule in rules:
        issues = list[Issue]()
        for one in CHECKS[rule](case):
            if rule not in JUDGED:
                demand(FINDING_WORK)
            issues.append(_issue(rule, case.room.room.id, one))
        if issues:
            found[rule] = tuple(issues)
    return found


def homeless(scene: Scene) -> Iterator[Issue]:
    """Lists people and pets that are in no room of the scene: they leave every room's floor."""
    known = {room.id for room in scene.rooms}
    for person in scene.dynamic:
        if home_of(scene, person) not in known:
            message = f"{person.id} is in no room of the scene ({person.room or 'none given'})"
            yield _issue("out_of_bounds", None, Finding((person.id,), 0, message))


def _issue(rule: str, room: str | None, found: Finding) -> Issue:
    return Issue(rule, found.severity or RULES[rule], room, found.ids, metres(found.amount), found.message)
