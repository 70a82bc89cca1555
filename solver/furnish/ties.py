"""Ways to stand in another piece's frame: a box there for the relations to it, a rectangle in the room for those to the room."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from catalogs.schema import Rule
from solver.furnish.relations import SLOTTED
from solver.furnish.relations.boxes import ANYWHERE, BOXES, Box, Fit, shared
from solver.furnish.relations.regions import within_both
from solver.furnish.relations.slots import on
from solver.furnish.stances import Asking, Kept, Stance, best_places, missed, stance_of, variant
from solver.geometry import OPPOSITE, WALL_BEHIND, Rect, rotate, turned
from solver.wanted import Alternative, Attach, Placed

SLIDING_COST = 0.04
"""What a place that slides along an axis costs more than an exact one: pieces line up where they can."""
UNSURE = 0.25
FIRM, LOOSE = 0.3, 0.03
"""Pull, m^-2, to the middle of a box: of a place beside, before or around a piece, and of any other."""
SLACK_MM = 2
"""What halves of odd extents may add up to."""
BOXES_KEPT = 14
"""Most boxes of one stance that differ in what they hold."""
BETWEEN_WAYS = 12
"""Most ways of a piece between others that stand."""
PLACES = 3
"""Most ways of one stance beside one way of another piece."""
ANY_PLACE = Rect(ANYWHERE[0], ANYWHERE[0], ANYWHERE[1], ANYWHERE[1])
PLACES_EACH = 5
"""Most ways of all stances beside one way of another piece."""


def tied(asking: Asking, every: Sequence[tuple[Stance, Sequence[Kept]]], dearest: float) -> Iterator[Alternative]:
    """Yields the ways tied to another piece, each for one way that piece stands.

    Args:
        asking: the piece and its rules.
        every: its stances, each with the rectangles that hold relations to the room.
        dearest: ways that cost as much are not sought.
    """
    names = tuple(dict.fromkeys(name for rule in asking.to_pieces for name in rule.of))
    for label, parents in _by_label(asking.ask.parents(names)).items():
        rules = tuple(rule for rule in asking.to_pieces if label in asking.ask.labels(rule.of))
        rest = (rule for rule in asking.to_pieces if label not in asking.ask.labels(rule.of))
        others = sum(rule.cost * (1.0 if rule.type in SLOTTED else UNSURE) for rule in rest)
        if any(rule.type == "on" for rule in rules):
            for parent in parents:
                yield from _upon(asking, label, parent)
            continue
        frames = _Frames(asking, rules)
        hard = any(rule.required for rule in rules)
        for parent in (parent for parent in parents if hard or (label, parent) not in asking.dear):
            for cost, stance, box, rect in _cheapest(frames, every, (label, parent), dearest - others):
                yield frames.way((stance, rect), (label, parent), box, cost + others)


def _by_label(parents: Sequence[tuple[str, str]]) -> dict[str, list[str]]:
    found: dict[str, list[str]] = {}
    for label, parent in parents:
        found.setdefault(label, []).append(parent)
    return found


class _Frames:
    """The boxes of a piece's rules in the frame of another piece, each kind of frame worked out once.

    Args:
        asking: the piece.
        rules: those to the one other piece.
    """

    def __init__(self, asking: Asking, rules: Sequence[Rule]) -> None:
        self.asking, self._rules = asking, rules
        self._rules_about_walls = [(rule, rule.type == "opposite" or rule.wall is not None) for rule in rules]
        pull = FIRM if any(rule.type in SLOTTED for rule in rules) else LOOSE
        self._pulls = (pull, pull)
        clear = asking.ask.scope.space.clear
        self._far = max(clear.width, clear.depth)
        self._tucked: set[tuple[int, Box]] = set()
        self._centres: dict[tuple[Box, str], tuple[int, int, int, int]] = {}
        self._known: dict[tuple[str, int, tuple[bool, ...]], list[tuple[Box, float]]] = {}

    def boxes(self, parent: str, stance: Stance) -> list[tuple[Box, float]]:
        """Returns boxes that each hold at least one rule, cheapest first."""
        base, turn, at_wall = stance_of(parent)
        theirs = WALL_BEHIND[turn] if at_wall else None
        suits = tuple(not about or _walls_suit(rule, stance, theirs) for rule, about in self._rules_about_walls)
        key = (base, (stance.rotation - turn) % 360, suits)
        if key not in self._known:
            self._known[key] = _boxes(self.asking, [*zip(self._rules, suits, strict=True)], base, key[1])
            tucking = [rule for rule in self._rules if _tucks(rule)]
            self._tucked |= {(key[1], box) for rule in tucking for box in _within(self._known[key], _fit(self.asking, rule, base, key[1]))}
        return self._known[key]

    def centres(self, box: Box, to: tuple[str, str]) -> tuple[int, int, int, int]:
        """Returns low x, low z, high x and high z of where the centre may be in the room, wherever the other stands so."""
        found = self._centres.get((box, to[1]))
        if found is None:
            other = self.asking.reach.get(to, ANY_PLACE)
            turn = stance_of(to[1])[1]
            (x0, z0), (x1, z1) = rotate(box[0][0], box[1][0], turn), rotate(box[0][1], box[1][1], turn)
            self._centres[box, to[1]] = found = (
                other.x0 + min(x0, x1) - SLACK_MM, other.z0 + min(z0, z1) - SLACK_MM,
                other.x1 + max(x0, x1) + SLACK_MM, other.z1 + max(z0, z1) + SLACK_MM,
            )  # fmt: skip
        return found

    def way(self, at: tuple[Stance, Rect], to: tuple[str, str], box: Box, cost: float) -> Alternative:
        """Returns the way to stand in a box of the other's frame and a rectangle of the room."""
        (stance, rect), (label, parent) = at, to
        relative = (stance.rotation - stance_of(parent)[1]) % 360
        across, along = _clipped(box[0], self._far), _clipped(box[1], self._far)
        return Alternative(
            variant(self.asking.kind, stance.rotation, stance.wall), self.asking.size, relative,
            weights=self._pulls, within=rect, cost=round(cost, 6), attach=Attach(label, parent, across, along),
            under=label if (relative, box) in self._tucked else None,
        )  # fmt: skip


def _within(boxes: Sequence[tuple[Box, float]], fit: Fit) -> list[Box]:
    """Returns the boxes in all of which a rule holds."""
    held = BOXES[fit.rule.type](fit)
    return [box for box, _ in boxes if any(shared(box, other) == box for other in held)]


def _fit(asking: Asking, rule: Rule, base: str, relative: int) -> Fit:
    width, depth, _ = asking.ask.scope.size(base)
    return Fit(rule, (width, depth), turned(asking.size[0], asking.size[1], relative), relative)


def _cheapest(
    frames: _Frames, every: Sequence[tuple[Stance, Sequence[Kept]]], to: tuple[str, str], dearest: float
) -> list[tuple[float, Stance, Box, Rect]]:
    """Returns the cheapest places of all stances beside one way of another piece, those of the likeliest stances first."""
    likely: list[tuple[float, int, Stance, list[tuple[Box, float]], Sequence[Kept]]] = []
    for stance, found in every:
        boxes = frames.boxes(to[1], stance)
        if boxes and found:
            likely.append((boxes[0][1] + found[0][1], len(likely), stance, boxes, found))
    likely.sort(key=lambda entry: entry[:2])
    ways: list[tuple[float, Stance, Box, Rect]] = []
    for least, _, stance, boxes, found in likely:
        if least >= dearest or (len(ways) >= PLACES_EACH and least >= ways[PLACES_EACH - 1][0]):
            break
        ways += [(cost, stance, box, rect) for cost, box, rect in _in_both(frames, stance, to, (boxes, found)) if cost < dearest]
        ways.sort(key=lambda way: round(way[0], 9))
    return ways[:PLACES_EACH]


def _in_both(
    frames: _Frames, stance: Stance, to: tuple[str, str], at: tuple[Sequence[tuple[Box, float]], Sequence[Kept]]
) -> list[tuple[float, Box, Rect]]:
    """Returns the cheapest pairs of a box in the other's frame and a rectangle in the room that can hold together."""
    boxes, found = at
    pairs = sorted((cost + more, i, j) for i, (_, cost) in enumerate(boxes) for j, (_, more) in enumerate(found))
    half_x, half_z = stance.extent[0] // 2, stance.extent[1] // 2
    ways: list[tuple[float, Box, Rect]] = []
    for cost, i, j in pairs:
        if len(ways) == PLACES or cost == math.inf:
            break
        (x0, z0, x1, z1), (low_x, low_z, high_x, high_z) = found[j][0], frames.centres(boxes[i][0], to)
        if low_x <= x1 - half_x and x0 + half_x <= high_x and low_z <= z1 - half_z and z0 + half_z <= high_z:
            ways.append((cost, boxes[i][0], found[j][0]))
    return ways


def ways_between(asking: Asking, poses: Mapping[str, Placed]) -> list[Alternative]:
    """Returns ways to stand where as many relations as can be hold together with the other pieces where they are.

    Args:
        asking: the piece and its rules.
        poses: where the other pieces stand, by label.
    """
    found: list[tuple[float, Stance, Rect, Attach | None]] = []
    for stance, in_room in asking.places:
        places, tucked = in_room, list[tuple[Attach, Rect]]()
        for rule in asking.to_pieces:
            held = _held_at(asking, rule, stance, poses)
            both = [(cut, cost) for rect, cost in places for _, other in held if (cut := within_both(rect, other, stance.extent))]
            places = best_places([*both, *((rect, cost + missed(rule)) for rect, cost in places)])
            tucked += held if _tucks(rule) else []
        for rect, cost in places[:PLACES]:
            found.append((cost, stance, rect, next((attach for attach, other in tucked if other.contains(rect)), None)))
    found.sort(key=lambda entry: entry[0])
    return [_between(asking, stance, (rect, cost), attach) for cost, stance, rect, attach in found[:BETWEEN_WAYS]]


def _between(asking: Asking, stance: Stance, place: Kept, attach: Attach | None) -> Alternative:
    """Returns the way to stand at a place; tied to the piece it is tucked under, which may slide."""
    (rect, cost), rotation, wall = place, stance.rotation, stance.wall
    if attach is not None:
        rotation, wall = (rotation - stance_of(attach.parent_kind)[1]) % 360, None
    return Alternative(
        variant(asking.kind, stance.rotation, stance.wall), asking.size, rotation, wall,
        ((rect.x0 + rect.x1) // 2, (rect.z0 + rect.z1) // 2), (LOOSE, LOOSE), within=rect, cost=round(cost, 6),
        attach=attach, under=attach.parent if attach else None,
    )  # fmt: skip


def _held_at(asking: Asking, rule: Rule, stance: Stance, poses: Mapping[str, Placed]) -> list[tuple[Attach, Rect]]:
    """Returns the rectangles within which a footprint holds a rule with any of the pieces it names, where they stand."""
    found: list[tuple[Attach, Rect]] = []
    for label in asking.ask.labels(rule.of):
        other = poses.get(label)
        if other is None or rule.type == "on":
            continue
        width, depth = stance.extent
        x, z = other.footprint.x0 + other.footprint.x1, other.footprint.z0 + other.footprint.z1
        base, turn, at_wall = stance_of(other.chosen.kind)
        suits = _walls_suit(rule, stance, WALL_BEHIND[turn] if at_wall else None)
        for (across, along), cost in _boxes(asking, [(rule, suits)], base, (stance.rotation - turn) % 360):
            if cost < rule.cost:
                (x0, z0), (x1, z1) = (rotate(across[k], along[k], other.rotation) for k in (0, 1))
                low_x, low_z = (x - width) // 2 + min(x0, x1), (z - depth) // 2 + min(z0, z1)
                high_x, high_z = (x + width + 1) // 2 + max(x0, x1), (z + depth + 1) // 2 + max(z0, z1)
                found.append((Attach(label, other.chosen.kind, across, along), Rect(low_x, low_z, high_x, high_z)))
    return found


def _tucks(rule: Rule) -> bool:
    return rule.type == "under" or (rule.gap is not None and rule.gap[0] < 0)


def _boxes(asking: Asking, rules: Sequence[tuple[Rule, bool]], base: str, relative: int) -> list[tuple[Box, float]]:
    """Returns boxes in the other's frame, each holding at least one of the rules, cheapest first.

    Args:
        asking: the piece.
        rules: those to the other piece, each with whether the walls at their backs suit it.
        base: the other's kind.
        relative: the own rotation minus the other's.
    """
    found: list[tuple[Box, float]] = [((ANYWHERE, ANYWHERE), 0.0)]
    for rule, suits in rules:
        boxes = BOXES[rule.type](_fit(asking, rule, base, relative)) if suits else []
        priced = [(box, _sliding(rule, box)) for box in boxes]
        held = [(both, cost + more) for box, cost in found for other, more in priced if (both := shared(box, other))]
        without = missed(rule)
        found = _best([*held, *((box, cost + without) for box, cost in found)])
    return [(box, cost) for box, cost in found if box != (ANYWHERE, ANYWHERE)]


def _best(found: Sequence[tuple[Box, float]]) -> list[tuple[Box, float]]:
    """Sorts by cost and drops what lies within a box that costs no more."""
    best: list[tuple[Box, float]] = []
    edges: list[tuple[int, int, int, int]] = []
    for box, cost in sorted(found, key=_by_cost_then_size):
        (x0, x1), (z0, z1) = box
        if cost == math.inf or len(best) == BOXES_KEPT:
            break
        for a0, a1, b0, b1 in edges:
            if a0 <= x0 and x1 <= a1 and b0 <= z0 and z1 <= b1:
                break
        else:
            best.append((box, cost))
            edges.append((x0, x1, z0, z1))
    return best


def _by_cost_then_size(entry: tuple[Box, float]) -> tuple[float, int]:
    ((x0, x1), (z0, z1)), cost = entry
    return cost, (x0 - x1) * (z1 - z0)


def _sliding(rule: Rule, box: Box) -> float:
    (x0, x1), (z0, z1) = box
    return SLIDING_COST * ((x0 < x1) + (z0 < z1)) if rule.type in SLOTTED else 0.0


def _walls_suit(rule: Rule, stance: Stance, theirs: str | None) -> bool:
    """Tells whether a stance and the wall of the other piece suit a rule that speaks of walls."""
    mine = stance.wall
    if rule.type == "opposite" and theirs is not None and mine != OPPOSITE[theirs]:
        return False
    if rule.wall is None:
        return True
    if mine is None or theirs is None:
        return False
    found = "same" if mine == theirs else "opposite" if OPPOSITE[mine] == theirs else "adjacent"
    return found == rule.wall or (rule.wall == "other" and found != "same")


def _upon(asking: Asking, label: str, parent: str) -> Iterator[Alternative]:
    """Yields the places on another piece's surface; it stands as that piece does."""
    base, turn, _ = stance_of(parent)
    bare = replace(
        asking.ask, kinds={one: tuple(dict.fromkeys(stance_of(kind)[0] for kind in asking.ask.kinds[one])) for one in asking.ask.kinds}
    )
    for rule in asking.to_pieces:
        for slot in on(bare, rule).slots if rule.type == "on" else ():
            attach = slot.attach
            if attach is not None and (attach.parent, attach.parent_kind) == (label, base):
                place = Attach(label, parent, attach.across_mm, attach.along_mm, attach.slot)
                yield Alternative(
                    variant(asking.kind, turn, None), asking.size, 0, weights=(FIRM, FIRM), attach=place, on=label, bottom_mm=slot.bottom_mm
                )


def _clipped(interval: tuple[int, int], far: int) -> tuple[int, int]:
    """Cuts an interval without an end off where the room ends, so that its middle means something."""
    low, high = interval
    if low <= ANYWHERE[0]:
        low = min(-far, high)
    if high >= ANYWHERE[1]:
        high = max(far, low)
    return low, high
