"""Print how one room of a home was furnished: what was wanted, with its candidates; what was not; what stands; what was refused, and why.

python -m scripts.debug_room --seed 42 --room kitchen_19 [--program family] [--piece plant] [--catalog DIR]

A piece that is missing and was required names the pieces it cannot stand with and the length that is short. With `--piece` every
candidate of that piece is listed and tried with the pieces that stand; what cannot names them too; `plant` is plant_1, plant_2 and so on.
Lengths in metres, relative to the room; what is at another piece tells its centre from that one's, in that one's frame.
"""

import argparse
import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from catalogs import CatalogError, load_catalogs
from service.cli import forced, program
from solver import generate
from solver.errors import ComposeError
from solver.exchange import read_request
from solver.pieces import Arrangement, Attach, Candidate, Piece, Placed, Space
from solver.pipeline.generate import wanted_in
from solver.pipeline.reasons import with_lengths
from solver.placement import feasible, place
from solver.scene import Room

Unwanted = Sequence[tuple[str, str]]
"""Names of pieces that a room's type lists, with the reasons why they were not wanted."""

BAD_USE = 2
NO_CHAIN = "no chain of lengths says more"


def described(room: Room, space: Space, wanted: Sequence[Piece], unwanted: Unwanted, tried: Sequence[Piece] = ()) -> Iterator[str]:
    """Tell how a room of a generated scene was furnished, line by line, and of every candidate of the pieces to be tried."""
    (arrangement,) = place([(space, wanted)], tidy=True)
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
    yield from _refused(space, wanted, arrangement)
    for piece in tried:
        yield from _candidates(space, wanted, piece, arrangement)


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
    verdicts = {True: "stands", False: "cannot stand", None: "not found within the limit"}
    standing = {placed.label: placed for placed in arrangement.placed if placed.label != tried.label}
    chosen = {label: (placed.chosen,) for label, placed in standing.items()}
    chosen[tried.label] = tried.candidates
    asked = [replace(one, required=True, candidates=chosen[one.label], links=()) for one in wanted if one.label in chosen]
    piece = next(one for one in asked if one.label == tried.label)
    yield f"\nCANDIDATES of {piece.label}, each with what stands beside it, walking included"
    for way in sorted(piece.candidates, key=lambda one: one.cost):
        verdict = feasible(space, [replace(one, candidates=(way,)) if one is piece else one for one in asked], walk=True)
        yield f"  {_candidate(way, standing)}: {verdicts[verdict]}"
    yield f"  why: {with_lengths(space, asked, Arrangement(space.room, (), ((piece.label, NO_CHAIN),))).left_out[0][1]}"


def _asked(wanted: Sequence[Piece], name: str | None) -> list[Piece]:
    """Return the piece of a label, or all pieces of a name."""
    return [piece for piece in wanted if name in (piece.label, piece.label.rpartition("_")[0])]


def main(arguments: Sequence[str] | None = None) -> int:
    """Make the home and tell of one room."""
    parser = argparse.ArgumentParser("scripts.debug_room", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--room", required=True, help="its id, or the id without the number")
    parser.add_argument("--piece", help="list and try every candidate of this piece, such as plant_1; plant: of all plants")
    parser.add_argument("--program", type=program, help="a preset, or bedrooms=3,bathrooms=2; without it the house is 20 x 15 m")
    parser.add_argument(
        "--force-type", action="append", default=[], type=forced, metavar="INDEX=TYPE", help="a room's type, without --program"
    )
    parser.add_argument("--catalog", type=Path, metavar="DIR", help="a folder of your own catalog files, laid over ours")
    asked = parser.parse_args(arguments)
    request: dict[str, Any] = {"seed": asked.seed, "program": asked.program, "force_types": dict(asked.force_type)}
    try:
        catalogs = load_catalogs(asked.catalog)
        scene = generate(read_request(request), catalogs=catalogs).scene
    except (CatalogError, ComposeError) as error:
        return _refused_use(str(error))
    room = next((room for room in scene.rooms if asked.room in (room.id, room.type)), None)
    if room is None:
        return _refused_use(f"no room {asked.room}; there are {', '.join(room.id for room in scene.rooms)}")
    space, wanted, unwanted = wanted_in(scene, room, catalogs)
    tried = _asked(wanted, asked.piece)
    if asked.piece is not None and not tried:
        return _refused_use(f"no piece {asked.piece} was wanted; there are {', '.join(piece.label for piece in wanted)}")
    print("\n".join(described(room, space, wanted, unwanted, tried)))
    return 0


def _refused_use(words: str) -> int:
    print(words, file=sys.stderr)
    return BAD_USE


if __name__ == "__main__":
    sys.exit(main())
