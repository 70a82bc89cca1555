"""Print how one room of a home was furnished: what was wanted, with its candidates; what was not; what stands; what was refused, and why.

python -m scripts.debug_room --seed 42 --room kitchen_19 [--program family] [--piece plant] [--catalog DIR]

A piece that is missing and was required names the pieces it cannot stand with and the length that is short. With `--piece` every
candidate of that piece is listed and tried with the pieces that stand; what cannot names them too; `plant` is plant_1, plant_2 and so on;
of one that was not wanted the reason is told. `--home home.yaml` tells of a home in a file, as its own request furnishes the room.
Lengths in metres, relative to the room; what is at another piece tells its centre from that one's, in that one's frame.
"""

import argparse
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

from catalogs import CatalogError, Catalogs, load_catalogs
from compose_homes import load
from service.cli import forced, program
from solver import generate
from solver.errors import ComposeError
from solver.exchange import read_request
from solver.pieces import Arrangement, Attach, Candidate, Piece, Placed, Space
from solver.pipeline.generate import unwanted_in, wanted_in
from solver.pipeline.reasons import REASON_WORK, with_lengths
from solver.placement import Budget, OpenRoom, feasible, minimal_conflict, opened, place
from solver.placement.layout import ABSENT
from solver.scene import Room, Scene

Unwanted = Sequence[tuple[str, str]]
"""Names of pieces that a room's type lists, with the reasons why they were not wanted."""

BAD_USE = 2
NO_CHAIN = "lengths alone do not tell why"
STANDS, GONE = "stands", " does not stand"
UNFOUND = "stands, but the search finds no such place"


def described(room: Room, space: Space, wanted: Sequence[Piece], unwanted: Unwanted, tried: Sequence[Piece] = ()) -> Iterator[str]:
    """Tell how a room of a generated scene was furnished, line by line, and of every candidate of the pieces to be tried."""
    found = opened(space, wanted, wide=True, tidy=True)
    arrangement = found.solved.arrangement
    standing = {placed.label: placed for placed in arrangement.placed}
    yield f"{room.id}: {room.type}, {room.width:g} x {room.depth:g} m, {_metres(*space.clear)} clear"
    for opening in room.openings:
        yield f"  {opening.kind} {opening.id}: {opening.wall} wall at {opening.position:g}, {opening.width:g} wide"
    if space.cover_mm2:
        yield f"  wished cover: {space.cover_mm2 / 1e6:.2f} m2"
    yield "\nWANTED, the most important first"
    yield from _wanted(wanted)
    if unwanted:
        yield "\nNOT WANTED, or fewer than the room's type lists"
    for name, reason in unwanted:
        yield f"  {name}: {reason}"
    yield f"\nPLACED at cost {arrangement.cost:.3f}; proven: {arrangement.proven}, best: {arrangement.best}; {arrangement.solves} QPs"
    for placed in arrangement.placed:
        yield f"  {placed.label:26} {_metres(*placed.footprint)}; {_candidate(placed.chosen, standing)}"
    yield from _summed(found, arrangement)
    yield from _refused(space, wanted, arrangement)
    for piece in tried:
        yield from _candidates(space, wanted, piece, arrangement)


def _summed(found: OpenRoom, arrangement: Arrangement) -> Iterator[str]:
    """Tell what the floor that is better kept free costs, and what the cost of the room is the sum of."""
    decided = zip(found.core.encoded.pieces, found.decisions.tolist(), strict=True)
    floors = {piece.label: found.core.decided(decision).cost for piece, decision in decided if piece.is_floor and decision != ABSENT}
    for label, cost in floors.items():
        yield f"  {label}: {f'used, cost {cost:.2f}' if cost else 'kept free'}"
    own, floor = sum(placed.chosen.cost for placed in arrangement.placed), sum(floors.values())
    parts = {
        "of pieces": own,
        "of floor used": floor,
        "of relations between pieces and of sides of use": found.preference - own - floor,
        "of distances": arrangement.cost - found.preference,
    }
    yield f"  cost {arrangement.cost:.3f} = {' + '.join(f'{round(cost, 3) + 0.0:.3f} {of}' for of, cost in parts.items())}"


def _metres(x0: int, z0: int, x1: int, z1: int) -> str:
    return f"x {x0 / 1000:g} to {x1 / 1000:g}, z {z0 / 1000:g} to {z1 / 1000:g}"


def _wanted(wanted: Sequence[Piece]) -> Iterator[str]:
    """Yield a line for each wanted piece, in columns as wide as the longest entry."""
    rows = [(piece.label, _need(piece), f"{len(piece.candidates)} candidate{'s' * (len(piece.candidates) != 1)}") for piece in wanted]
    label_width, need_width, count_width = (max(map(len, column)) for column in zip(*rows, strict=True)) if rows else (0, 0, 0)
    for (label, need, number), piece in zip(rows, wanted, strict=True):
        yield f"  {label:{label_width}} {need:{need_width}} {number:>{count_width}}, {_costs(piece)}"


def _need(piece: Piece) -> str:
    if piece.is_floor:
        return f"floor better kept free, {piece.skip_cost:g} to use it"
    return "required" if piece.required else f"optional, {piece.skip_cost:g} to leave out"


def _costs(piece: Piece) -> str:
    costs = sorted(way.cost for way in piece.candidates)
    span = f"cost {costs[0]:.2f} to {costs[-1]:.2f}" if costs else "no place of the kind its relations ask for"
    kinds = ", ".join(dict.fromkeys(way.kind for way in piece.candidates))
    return span if piece.is_floor or not costs else f"{span} ({kinds})"


def _candidate(way: Candidate, standing: Mapping[str, Placed]) -> str:
    """Tell of a candidate, turned as the scene has it: at another piece, by how that one stands."""
    if way.attach:
        where, rotation = _at(way, way.attach), _turned(way.rotation, way.attach, standing)
    else:
        x, z = way.anchor_mm
        where, rotation = f"{way.wall} wall" if way.wall else "free", f"rotation {way.rotation}, anchor {x / 1000:.2f}, {z / 1000:.2f}"
    return f"{way.kind} {where}, {rotation}, cost {way.cost:.2f}"


def _at(way: Candidate, attach: Attach) -> str:
    """Tell which side of which piece a candidate is at, how that one stands, and its centre from that one's, in its frame."""
    wall = f" at the {attach.parent_stance.wall} wall" if attach.parent_stance and attach.parent_stance.wall else ""
    how = "on" if way.on else "under" if way.under else "by"
    slot = f" ({attach.slot})" if attach.slot else ""
    offset = f"{_span(attach.across_mm)} across and {_span(attach.along_mm)} along it"
    return f"{how} {attach.parent}{slot} as {attach.parent_kind}{wall}, {offset}"


def _span(interval: tuple[int, int]) -> str:
    low, high = (f"{end / 1000:g}" for end in interval)
    return low if low == high else f"{low} to {high}"


def _turned(rotation: int, attach: Attach, standing: Mapping[str, Placed]) -> str:
    if attach.parent_stance:
        return f"rotation {(attach.parent_stance.rotation + rotation) % 360}"
    if attach.parent in standing:
        return f"rotation {(standing[attach.parent].rotation + rotation) % 360}"
    return f"rotation that of {attach.parent} + {rotation}"


def _refused(space: Space, wanted: Sequence[Piece], arrangement: Arrangement) -> Iterator[str]:
    if arrangement.left_out:
        yield "\nREFUSED"
    for label, reason in with_lengths(space, wanted, arrangement).left_out:
        yield f"  {label}: {reason}"


def _candidates(space: Space, wanted: Sequence[Piece], tried: Piece, arrangement: Arrangement) -> Iterator[str]:
    """Try each candidate of a piece with the pieces that stand, each of these in the candidate that was taken, free to slide."""
    standing = {placed.label: placed for placed in arrangement.placed if placed.label != tried.label}
    chosen: dict[str, tuple[Candidate, ...]] = {label: (placed.chosen,) for label, placed in standing.items()}
    chosen[tried.label] = tried.candidates
    asked = [replace(one, required=True, candidates=chosen[one.label], links=()) for one in wanted if one.label in chosen]
    trial = _Trial(space, wanted, asked, tried.label, standing)
    yield f"\nCANDIDATES of {tried.label}, each with what stands beside it, walking included"
    verdicts = [(way, trial.verdict(way)) for way in sorted(tried.candidates, key=lambda one: one.cost)]
    for way, verdict in verdicts:
        yield f"  {_candidate(way, standing)}: {verdict}"
    refused = dict(arrangement.left_out).get(tried.label)
    if verdicts and refused:
        yield f"  why: {trial.why([verdict for _, verdict in verdicts], refused)}"


class _Trial(NamedTuple):
    """A piece that is tried with those that stand.

    Args:
        wanted: everything that was wanted, floor too.
        asked: the piece, and those that stand, each in the candidate that it took.
    """

    space: Space
    wanted: Sequence[Piece]
    asked: Sequence[Piece]
    label: str
    standing: Mapping[str, Placed]

    def verdict(self, way: Candidate) -> str:
        """Tell whether a candidate can stand, and with which pieces it cannot."""
        parent = way.attach.parent if way.attach else None
        if way.attach and parent not in self.standing:
            return f"{parent}{GONE}"
        if way.attach and parent and self.standing[parent].chosen.kind != way.attach.parent_kind:
            return f"{parent} stands as {self.standing[parent].chosen.kind}"
        pieces = [replace(one, candidates=(way,)) if one.label == self.label else one for one in self.asked]
        stands = feasible(self.space, pieces, walk=True)
        if stands is None:
            return "not found within the limit"
        if stands:
            return self._beside_floor(way)
        members = minimal_conflict(self.space, pieces, self.label, Budget(REASON_WORK), True)
        if members is None:
            return "cannot stand, with what was not found within the limit"
        others = [member for member in members if member != self.label]
        return f"cannot stand with {' and '.join(others)}" if others else "cannot stand even alone"

    def _beside_floor(self, way: Candidate) -> str:
        """Tell whether a candidate that can stand is worth it, and does so beside the floor that is better kept free."""
        floor = [one.label for one in self.wanted if one.is_floor]
        if self._cost(way, floor) is not None:
            return STANDS
        if self._cost(way) is None:
            dear = (self._cost(way, required=True) or 0.0) - (self._cost(None) or 0.0)
            is_left_out = not self._tried.required and dear > self._tried.skip_cost
            return f"{STANDS}, but costs {dear:.2f}: more than to leave it out" if is_left_out else UNFOUND
        taken = [label for label in floor if self._cost(way, [label]) is None] or ["floor that is better kept free"]
        return f"{STANDS}, but takes {' and '.join(f'the {label}' for label in taken)}"

    @property
    def _tried(self) -> Piece:
        return next(one for one in self.wanted if one.label == self.label)

    def _cost(self, way: Candidate | None, floor: Sequence[str] = (), required: bool = False) -> float | None:
        """Place the pieces that stand, beside this floor, and the piece tried in one candidate; None where it is left out."""
        fixed = {one.label: one for one in self.asked} | {one.label: one for one in self.wanted if one.label in floor}
        del fixed[self.label]
        if way is not None:
            needed = required or self._tried.required
            fixed[self.label] = replace(self._tried, required=needed, candidates=(way,), links=())
        (made,) = place([(self.space, [fixed[one.label] for one in self.wanted if one.label in fixed])])
        return made.cost if way is None or any(placed.label == self.label for placed in made.placed) else None

    def why(self, verdicts: Sequence[str], refused: str) -> str:
        """Tell why a piece was left out, after its candidates were tried; `refused` is the reason that the room gives."""
        if STANDS in verdicts:
            return f"it can stand; {refused.partition(';')[0]}"
        if any(verdict.startswith(STANDS) for verdict in verdicts):
            return "it can stand only as told above"
        if all(verdict.endswith(GONE) for verdict in verdicts):
            return f"{' and '.join(dict.fromkeys(verdicts))}, and it stands nowhere else: ask about that one"
        told = with_lengths(self.space, self.asked, Arrangement(self.space.room, (), ((self.label, NO_CHAIN),))).left_out[0][1]
        return told.removesuffix(f"; {NO_CHAIN}") if ": " in told else told


def _asked(wanted: Sequence[Piece], name: str | None) -> list[Piece]:
    """Return the piece of a label, or all pieces of a name."""
    return [piece for piece in wanted if name in (piece.label, _stem(piece.label))]


def _stem(label: str) -> str:
    """Take the number off a label: `bed_1` was wanted as `bed`."""
    head, _, number = label.rpartition("_")
    return head if head and number.isdigit() else label


def _parsed(arguments: Sequence[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser("scripts.debug_room", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    which = parser.add_mutually_exclusive_group(required=True)
    which.add_argument("--seed", type=int, help="of a home that is made for it")
    which.add_argument("--home", type=Path, metavar="FILE", help="a home that was made before, or a plan that was furnished")
    parser.add_argument("--room", required=True, help="its id, or the id without the number")
    parser.add_argument("--piece", help="list and try every candidate of this piece, such as plant_1; plant: of all plants")
    parser.add_argument("--program", type=program, help="a preset, or bedrooms=3,bathrooms=2; without it the house is 20 x 15 m")
    parser.add_argument(
        "--force-type", action="append", default=[], type=forced, metavar="INDEX=TYPE", help="a room's type, without --program"
    )
    parser.add_argument("--catalog", type=Path, metavar="DIR", help="a folder of your own catalog files, laid over ours")
    return parser.parse_args(arguments)


def _made(asked: argparse.Namespace, catalogs: Catalogs) -> Scene:
    """Return the home that is asked about: read, or made."""
    if asked.home is not None:
        return load(asked.home)
    request: dict[str, Any] = {"seed": asked.seed, "program": asked.program, "force_types": dict(asked.force_type)}
    return generate(read_request(request), catalogs=catalogs).scene


def main(arguments: Sequence[str] | None = None) -> int:
    """Make the home, or read it, and tell of one room."""
    asked = _parsed(arguments)
    try:
        catalogs = load_catalogs(asked.catalog)
        scene = _made(asked, catalogs)
    except (CatalogError, ComposeError, OSError) as error:
        return _refused_use(str(error))
    room = next((room for room in scene.rooms if asked.room in (room.id, room.type)), None)
    if room is None:
        return _refused_use(f"no room {asked.room}; there are {', '.join(room.id for room in scene.rooms)}")
    space, wanted = wanted_in(scene, room, catalogs)
    unwanted = unwanted_in(scene, room, catalogs)
    tried = _asked(wanted, asked.piece)
    reasons = [f"{name}: {reason}" for name, reason in unwanted if name in (asked.piece, _stem(asked.piece or ""))]
    if asked.piece is not None and not tried and not reasons:
        names = dict.fromkeys([*(_stem(piece.label) for piece in wanted if not piece.is_floor), *(name for name, _ in unwanted)])
        return _refused_use(f"no piece {asked.piece} in the type {room.type}; there are {', '.join(names)}")
    print("\n".join(described(room, space, wanted, unwanted, tried)))
    if asked.piece is not None and not tried:
        print(f"\nNOT WANTED was {reasons[0]}")
    return 0


def _refused_use(words: str) -> int:
    print(words, file=sys.stderr)
    return BAD_USE


if __name__ == "__main__":
    sys.exit(main())
