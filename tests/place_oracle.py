"""How many of a request's relations can hold together? A mixed-integer programme for HiGHS; shares no code with the solver.

Continuous: the min corner of every piece, m. Binary: its rotation, the wall at its back, on which side of each other piece
it stands, whether each relation holds and by which of its options. Distances are octagons around the true circles, walking is
left out: what the oracle holds is at least what can be held. Every piece stands; kinds that stand at walls do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tests.place_oracle_sides import FRONT, ROTATIONS, Placed, at_sides, between
from tests.programme import BIG, Expr, Programme

NEARLY, AT_WALL = 0.1, 0.03
WALL_OF = {0: "north", 90: "west", 180: "south", 270: "east"}
DIRECTIONS = [(1, 0), (-1, 0), (0, 1), (0, -1)] + [(s * 0.7071, t * 0.7071) for s in (1, -1) for t in (1, -1)]


Kinds = Mapping[str, tuple[tuple[float, float, float], str]]


class Oracle:
    """One request as a programme.

    Args:
        request: the body of /place, without `count`s.
        kinds: size and `stands` of the catalog's kinds, by name.
        use: the sides a person must get to, by name, and whether to all of them: there a square must be free.
    """

    def __init__(self, request: Mapping[str, Any], kinds: Kinds, use: Mapping[str, tuple[Sequence[str], bool]]) -> None:
        self.p = Programme()
        room, half = request["room"], request.get("wall_thickness", 0.0) / 2
        self.low, self.high = (half, half), (room["width"] - half, room["depth"] - half)
        self.walls = {"north": (1, 0.0), "south": (1, room["depth"]), "west": (0, 0.0), "east": (0, room["width"])}
        self.openings = [(o["kind"], o["wall"], o["position"], o["width"], o.get("sill", 0.0)) for o in room["openings"]]
        self.pieces = {piece["id"]: self._piece(piece, kinds) for piece in request["pieces"]}
        self.relations: list[tuple[str, dict[str, Any], Expr]] = []
        tucked: dict[tuple[str, str], list[Expr]] = {}
        for piece in request["pieces"]:
            for relation in piece["relations"]:
                held = self.p.binary()
                self._relation(self.pieces[piece["id"]], relation, held)
                self.relations.append((piece["id"], relation, held))
                if relation["type"] == "under" or relation.get("gap", [0])[0] < 0:
                    tucked.setdefault((piece["id"], relation["of"]), []).append(held)
        names = list(self.pieces)
        for k, a in enumerate(names):
            self._clear_of_openings(self.pieces[a])
            for b in names[:k]:
                excuse = tucked.get((a, b), []) + tucked.get((b, a), [])
                self._apart(self.pieces[a], self.pieces[b], excuse)
        for piece in request["pieces"]:
            sides, every = use.get(piece["name"], ((), False))
            self._used(self.pieces[piece["id"]], sides, every, request.get("robot_width", 0.6))

    def _used(self, piece: Placed, sides: Sequence[str], every: bool, size: float) -> None:
        """A square free of bodies touches the sides that are used, its middle within the side's extent."""
        p, found = self.p, []
        for side in sides:
            chosen = p.binary()
            found.append(chosen)
            stand = (p.variable(self.low[0], self.high[0] - size), p.variable(self.low[1], self.high[1] - size))
            for r, (fx, fz) in FRONT.items():
                dx, dz = {"front": (fx, fz), "back": (-fx, -fz), "left": (-fz, fx), "right": (fz, -fx)}[side]
                axis, sign = (0, dx) if dx else (1, dz)
                touch = stand[axis] - piece.high(axis) if sign > 0 else piece.low[axis] - stand[axis] - size
                between(self.p, touch, 0.0, 0.0, chosen, piece.turn[r])
                p.at_least(stand[1 - axis] + size / 2 - piece.low[1 - axis], 0.0, chosen, piece.turn[r])
                p.at_least(piece.high(1 - axis) - stand[1 - axis] - size / 2, 0.0, chosen, piece.turn[r])
            for other in self.pieces.values():
                if other is not piece:
                    options = []
                    for k in (0, 1):
                        options += [p.binary(), p.binary()]
                        p.at_least(stand[k] - other.high(k), 0.0, options[-2])
                        p.at_least(other.low[k] - stand[k] - size, 0.0, options[-1])
                    p.one_of(options, chosen)
        if found:
            if every:
                for chosen in found:
                    p.one_of([chosen])
            else:
                p.one_of(found)

    def _piece(self, piece: Mapping[str, Any], kinds: Kinds) -> Placed:
        size, stands = kinds.get(piece["name"], ((1.0, 1.0, 1.0), "free"))
        width, depth, height = (piece.get(key, size[i]) for i, key in enumerate(("width", "depth", "height")))
        p = self.p
        turn = {r: p.binary() for r in ROTATIONS}
        p.one_of(list(turn.values()))
        total = turn[0] + turn[90] + turn[180] + turn[270]
        p.at_least(-total, -1.0)
        along, across = turn[0] + turn[180], turn[90] + turn[270]
        extent = (along.times(width) + across.times(depth), along.times(depth) + across.times(width))
        low = (p.variable(self.low[0], self.high[0]), p.variable(self.low[1], self.high[1]))
        placed = Placed(piece["id"], low, extent, turn, height, stands == "wall")
        for axis in (0, 1):
            p.at_least(-placed.high(axis), -self.high[axis])
        if placed.at_wall:
            for r in ROTATIONS:
                self._back_at_wall(placed, r, turn[r])
        return placed

    def _back_at_wall(self, piece: Placed, r: int, *when: Expr) -> None:
        axis, _ = self.walls[WALL_OF[r]]
        if WALL_OF[r] in ("north", "west"):
            self.p.at_least(-piece.low[axis], -(self.low[axis] + AT_WALL), *when)
            self.p.at_least(piece.low[axis], self.low[axis] + (AT_WALL if piece.at_wall else 0), *when)
        else:
            self.p.at_least(piece.high(axis), self.high[axis] - AT_WALL, *when)
            self.p.at_least(-piece.high(axis), -(self.high[axis] - (AT_WALL if piece.at_wall else 0)), *when)

    def _clear_of_openings(self, piece: Placed) -> None:
        for kind, wall, position, width, sill in self.openings:
            if kind == "window" and piece.height <= sill:
                continue
            deep, side = (0.5, 0.1) if kind == "window" else (min(width, 0.9), 0.0)
            axis, line = self.walls[wall]
            inner = (line, line + deep) if line == 0 else (line - deep, line)
            spans: list[tuple[float, float]] = [(0, 0), (0, 0)]
            spans[axis], spans[1 - axis] = inner, (position - width / 2 - side, position + width / 2 + side)
            options = []
            for k in (0, 1):
                options += [self.p.binary(), self.p.binary()]
                self.p.at_least(-piece.high(k), -spans[k][0], options[-2])
                self.p.at_least(piece.low[k], spans[k][1], options[-1])
            self.p.one_of(options)

    def _apart(self, a: Placed, b: Placed, excuse: Sequence[Expr]) -> None:
        options = list(excuse)
        for first, second in ((a, b), (b, a)):
            for k in (0, 1):
                options.append(self.p.binary())
                self.p.at_least(second.low[k] - first.high(k), 0.0, options[-1])
        self.p.one_of(options)

    def _relation(self, own: Placed, relation: dict[str, Any], held: Expr) -> None:
        of = relation.get("of")
        other = self.pieces_or_none(of)
        options = getattr(self, f"_{relation['type']}")(own, other, relation, of)
        self.p.one_of(options, held)

    def pieces_or_none(self, name: str | None) -> Placed | None:
        return self.pieces.get(name) if name else None

    def _option(self) -> Expr:
        return self.p.binary()

    def _against_wall(self, own: Placed, *_: Any) -> list[Expr]:
        options = []
        for r in ROTATIONS:
            options.append(self._option())
            self.p.at_least(own.turn[r], 1.0, options[-1])
            self._back_at_wall(own, r, options[-1])
        return options

    def _in_corner(self, own: Placed, *_: Any) -> list[Expr]:
        options = []
        for east in (False, True):
            for south in (False, True):
                options.append(self._option())
                for axis, far in ((0, east), (1, south)):
                    if far:
                        self.p.at_least(own.high(axis), self.high[axis] - NEARLY, options[-1])
                    else:
                        self.p.at_least(-own.low[axis], -(self.low[axis] + NEARLY), options[-1])
        return options

    def _centred(self, own: Placed, *_: Any) -> list[Expr]:
        middle = [(self.low[k] + self.high[k]) / 2 for k in (0, 1)]
        options = self._against_wall(own)
        for r, option in zip(ROTATIONS, options, strict=True):
            axis = 1 - self.walls[WALL_OF[r]][0]
            between(self.p, own.middle(axis), middle[axis] - NEARLY, middle[axis] + NEARLY, option)
        options.append(self._option())
        for axis in (0, 1):
            between(self.p, own.middle(axis), middle[axis] - NEARLY, middle[axis] + NEARLY, options[-1])
        return options

    def _at_window(self, own: Placed, *_: Any) -> list[Expr]:
        options = []
        for kind, wall, position, _width, _sill in self.openings:
            if kind == "window":
                options.append(self._option())
                axis, line = self.walls[wall]
                if line == 0:
                    self.p.at_least(-own.low[axis], -(self.low[axis] + 0.2), options[-1])
                else:
                    self.p.at_least(own.high(axis), self.high[axis] - 0.2, options[-1])
                between(self.p, own.middle(1 - axis), position - NEARLY, position + NEARLY, options[-1])
        return options

    def _points(self, kind: str) -> list[tuple[float, float]]:
        found = []
        for of, wall, position, _width, _sill in self.openings:
            if of == kind:
                axis, line = self.walls[wall]
                found.append((line, position) if axis == 0 else (position, line))
        return found

    def _near_door(self, own: Placed, _: Any, relation: dict[str, Any], __: Any) -> list[Expr]:
        return self._near_points(own, "door", relation.get("distance", 1.5))

    def _far_from_door(self, own: Placed, _: Any, relation: dict[str, Any], __: Any) -> list[Expr]:
        return self._far_points(own, "door", relation.get("distance", 1.5))

    def _near_points(self, own: Placed, kind: str, distance: float) -> list[Expr]:
        options = []
        for point in self._points(kind):
            options.append(self._option())
            gaps = [self.p.variable(0, BIG), self.p.variable(0, BIG)]
            for k in (0, 1):
                self.p.at_least(gaps[k] - own.low[k], -point[k])
                self.p.at_least(gaps[k] + own.high(k), point[k])
                self.p.at_least(-gaps[k], -distance, options[-1])
            self.p.at_least(-(gaps[0] + gaps[1]), -1.4143 * distance, options[-1])
        return options

    def _far_points(self, own: Placed, kind: str, distance: float) -> list[Expr]:
        every = self._option()
        for point in self._points(kind):
            options = []
            for dx, dz in DIRECTIONS:
                options.append(self._option())
                reach = (own.low[0] - point[0] if dx > 0 else own.high(0) - point[0]).times(dx)
                reach = reach + (own.low[1] - point[1] if dz > 0 else own.high(1) - point[1]).times(dz)
                self.p.at_least(reach, 0.93 * distance, options[-1])
            self.p.one_of(options, every)
        return [every]

    def _near(self, own: Placed, other: Placed | None, relation: dict[str, Any], of: str) -> list[Expr]:
        distance = relation.get("distance", 1.5)
        if other is None:
            return self._near_points(own, of, distance)
        option, gaps = self._option(), [self.p.variable(0, BIG), self.p.variable(0, BIG)]
        for k in (0, 1):
            self.p.at_least(gaps[k] - own.low[k] + other.high(k), 0.0)
            self.p.at_least(gaps[k] - other.low[k] + own.high(k), 0.0)
            self.p.at_least(-gaps[k], -distance, option)
        self.p.at_least(-(gaps[0] + gaps[1]), -1.4143 * distance, option)
        return [option]

    def _far_from(self, own: Placed, other: Placed | None, relation: dict[str, Any], of: str) -> list[Expr]:
        if other is None:
            return self._far_points(own, of, relation.get("distance", 1.5))
        options = []
        for dx, dz in DIRECTIONS:
            options.append(self._option())
            reach = (own.low[0] - other.high(0) if dx > 0 else own.high(0) - other.low[0]).times(dx)
            reach = reach + (own.low[1] - other.high(1) if dz > 0 else own.high(1) - other.low[1]).times(dz)
            self.p.at_least(reach, 0.93 * relation.get("distance", 2.0), options[-1])
        return options

    def _aligned_with(self, own: Placed, other: Placed, *_: Any) -> list[Expr]:
        options = []
        for k in (0, 1):
            options.append(self._option())
            between(self.p, own.middle(k) - other.middle(k), -NEARLY, NEARLY, options[-1])
        return options

    def _facing(self, own: Placed, other: Placed, *_: Any) -> list[Expr]:
        options = []
        for r, (dx, dz) in FRONT.items():
            axis, sign = (0, dx) if dx else (1, dz)
            ahead = (other.middle(axis) - own.middle(axis)).times(sign)
            aside = other.middle(1 - axis) - own.middle(1 - axis)
            options.append(self._option())
            self.p.at_least(own.turn[r], 1.0, options[-1])
            self.p.at_least(ahead - aside, 0.0, options[-1])
            self.p.at_least(ahead + aside, 0.0, options[-1])
            options.append(self._option())
            self.p.at_least(own.turn[r], 1.0, options[-1])
            self._ahead(own, other, r, options[-1])
            self._meets(own, other, 1 - axis, options[-1])
        return options

    def _ahead(self, own: Placed, other: Placed, r: int, when: Expr) -> None:
        dx, dz = FRONT[r]
        axis, sign = (0, dx) if dx else (1, dz)
        self.p.at_least(other.low[axis] - own.high(axis) if sign > 0 else own.low[axis] - other.high(axis), 0.0, when)

    def _meets(self, own: Placed, other: Placed, axis: int, when: Expr) -> None:
        self.p.at_least(own.middle(axis) - other.low[axis], 0.0, when)
        self.p.at_least(other.high(axis) - own.middle(axis), 0.0, when)

    def _opposite(self, own: Placed, other: Placed, *_: Any) -> list[Expr]:
        options = []
        for r, (dx, _dz) in FRONT.items():
            for first, second in ((own, other), (other, own)):
                options.append(self._option())
                self.p.at_least(own.turn[r], 1.0, options[-1])
                self.p.at_least(other.turn[(r + 180) % 360], 1.0, options[-1])
                self._ahead(own, other, r, options[-1])
                self._meets(first, second, 1 if dx else 0, options[-1])
                self._back_at_wall(own, r, options[-1])
        return options

    def _beside(self, own: Placed, other: Placed, relation: dict[str, Any], _: Any) -> list[Expr]:
        return at_sides(self.p, (own, other), relation, ("left", "right"), False)

    def _in_front_of(self, own: Placed, other: Placed, relation: dict[str, Any], _: Any) -> list[Expr]:
        return at_sides(self.p, (own, other), relation, ("front",), False)

    def _around(self, own: Placed, other: Placed, relation: dict[str, Any], _: Any) -> list[Expr]:
        return at_sides(self.p, (own, other), relation, ("front", "back", "left", "right"), True)

    def _under(self, own: Placed, other: Placed, relation: dict[str, Any], _: Any) -> list[Expr]:
        return at_sides(self.p, (own, other), relation, ("front",), True)

    def _in_row(self, own: Placed, other: Placed, relation: dict[str, Any], _: Any) -> list[Expr]:
        options = at_sides(self.p, (own, other), relation, ("left", "right"), False)
        for k, option in enumerate(options):
            r = ROTATIONS[k // 4]
            self.p.at_least(own.turn[r], 1.0, option)
            axis, positive = {0: (1, False), 90: (0, False), 180: (1, True), 270: (0, True)}[r]
            ends = (own.high(axis), other.high(axis)) if positive else (own.low[axis], other.low[axis])
            between(self.p, ends[0] - ends[1], -NEARLY, NEARLY, option)
        return options

    def most(self, more_than: int, seconds: float) -> tuple[str, list[bool], dict[str, tuple[float, float, int]]]:
        """Looks for a placement that holds more relations than that.

        Returns:
            "solved", "infeasible" or "limit"; which relations hold; where the pieces stand (min corner, rotation).
        """
        total = Expr()
        for _, _, held in self.relations:
            total = total + held
        self.p.rows.append((total - (more_than + 1.0), 0.0))
        word, x = self.p.solve(total, seconds)
        self.p.rows.pop()
        if x is None:
            return word, [], {}
        value = {name: (self._value(x, p.low[0]), self._value(x, p.low[1]), self._turn(x, p)) for name, p in self.pieces.items()}
        return word, [self._value(x, held) > 0.5 for _, _, held in self.relations], value

    def _turn(self, x: Any, piece: Placed) -> int:
        return max(ROTATIONS, key=lambda r: self._value(x, piece.turn[r]))

    def _value(self, x: Any, expr: Expr) -> float:
        return expr.get(-1, 0.0) + sum(c * float(x[k]) for k, c in expr.items() if k >= 0)
