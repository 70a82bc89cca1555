"""Relations between two pieces that are no slots: conditions on walls and turns, pulls and distances."""

from __future__ import annotations

from catalogs.checks import OPENINGS
from catalogs.schema import Rule
from solver.furnish.ask import NOTHING, Ask, Effect
from solver.furnish.relations import places
from solver.wanted import Link

FAR = 2.0
"""What far_from takes for far where the rule names no distance, m."""


def _first(ask: Ask, rule: Rule) -> str | None:
    """Returns the label of the first earlier piece the rule names; None where the room has none."""
    return next(iter(ask.labels(rule.of)), None)


def opposite(ask: Ask, rule: Rule) -> Effect:
    """Stands at the wall opposite another piece, facing it, their middles in line."""
    label = _first(ask, rule)
    if label is None:
        return NOTHING
    link = Link(
        "opposite", label, turn=180, walls="opposite", cost=rule.cost, required=rule.required, align=rule.weight
    )  # fmt: skip
    return Effect(links=(link,))


def facing(ask: Ask, rule: Rule) -> Effect:
    """Turns its front towards a piece or an opening; in a slot of that piece the slot does it."""
    openings = tuple(name for name in rule.of if name in OPENINGS)
    if openings:
        return Effect(judge=places.turned_to(ask, rule, openings))
    if any(other.type in ("beside", "in_front_of", "around", "under") and set(other.of) & set(rule.of) for other in ask.piece.rules):
        return NOTHING
    label = _first(ask, rule)
    return NOTHING if label is None else Effect(links=(Link("facing", label, turn=180, cost=rule.cost, required=rule.required),))


def near(ask: Ask, rule: Rule) -> Effect:
    """Is drawn towards a piece with `weight`, or stands within `distance` of an opening."""
    openings = tuple(name for name in rule.of if name in OPENINGS)
    if openings:
        return places.nearness(ask, rule, openings)
    label = _first(ask, rule)
    if label is None:
        return NOTHING
    cost = rule.cost if rule.wall else 0.0
    return Effect(links=(Link("near", label, walls=rule.wall, cost=cost, required=rule.required, near=rule.weight),))


def far_from(ask: Ask, rule: Rule) -> Effect:
    """Keeps `distance` from a piece or an opening; every metre short of it costs."""
    openings = tuple(name for name in rule.of if name in OPENINGS)
    if openings:
        return places.remoteness(ask, rule, openings)
    distance = FAR if rule.distance is None else rule.distance
    links = [Link("far_from", label, apart_m=distance, apart_cost=rule.cost) for label in ask.labels(rule.of)]
    if rule.wall and links:
        links.append(Link("far_from", links[0].of, walls=rule.wall, cost=rule.cost, required=rule.required))
    return Effect(links=tuple(links))


def aligned_with(ask: Ask, rule: Rule) -> Effect:
    """Has its middle in line with another piece's middle."""
    label = _first(ask, rule)
    if label is None:
        return NOTHING
    walls = rule.wall
    return Effect(links=(Link("aligned_with", label, walls=walls, cost=rule.cost if walls else 0.0, align=rule.weight),))
