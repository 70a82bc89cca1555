"""What a seed alone decides: the order of pieces that matter alike, how many there are, and small costs among good ways.

Two houses with one and the same room shall not furnish it alike, nor badly: these costs are smaller than that of a bad place.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from catalogs.schema import PieceSpec
from solver.pieces import Candidate
from solver.relations.subject import Kind
from solver.scene import WALLS
from solver.streams import Stream
from tests.furnish.reference.subject import Subject

WALL_PREFERENCE = 1.6
"""Most that a wall may cost a piece by the seed alone: less than standing before a window, as much as half a size variant."""
QUARTER_PREFERENCE = 0.35
"""The same for the quarters of the room, for pieces that stand free: small things cost little to leave out."""
SIDE_PREFERENCE = 0.3
"""The same for the side of another piece."""
KIND_PREFERENCE = 0.5
"""The same for a size variant."""
SIDES = ("left", "right", "front", "back")


class CountedPiece(NamedTuple):
    """A piece of a room type: its variants that suit the room, each with what settling for it costs, and how many are wanted.

    `corners`: those for a run's corner, each after the side that is hidden there.
    """

    spec: PieceSpec
    variants: tuple[tuple[Kind, float], ...]
    copies: int
    corners: tuple[tuple[str, Kind, float], ...] = ()


@dataclass(frozen=True)
class Preferences:
    """What one copy of a piece prefers of walls, quarters of the room, sides of other pieces and its variants, as costs."""

    walls: tuple[float, ...]
    quarters: tuple[float, ...]
    sides: tuple[float, ...]
    kinds: tuple[float, ...]

    def cost(self, candidate: Candidate, subject: Subject) -> float:
        """Returns what a candidate costs by preference."""
        kinds, clear = [kind.name for kind, _ in subject.variants], subject.scope.clear
        total = self.kinds[kinds.index(candidate.kind)] if candidate.kind in kinds[: len(self.kinds)] and len(kinds) > 1 else 0.0
        if candidate.attach is not None:
            slot = candidate.attach.slot
            return total + (self.sides[SIDES.index(slot)] if slot in SIDES else 0.0)
        if candidate.wall is not None:
            return total + self.walls[WALLS.index(candidate.wall)]
        (x, z), right, low = candidate.anchor_mm, clear.x0 + clear.x1, clear.z0 + clear.z1
        return total + self.quarters[2 * (2 * z > low) + (2 * x > right)]


def drawn_preferences(stream: Stream) -> Preferences:
    """Draws those of one copy of a piece; always as many numbers."""
    return Preferences(
        tuple(stream.uniform(0.0, WALL_PREFERENCE) for _ in WALLS),
        tuple(stream.uniform(0.0, QUARTER_PREFERENCE) for _ in range(4)),
        tuple(stream.uniform(0.0, SIDE_PREFERENCE) for _ in SIDES),
        tuple(stream.uniform(0.0, KIND_PREFERENCE) for _ in range(3)),
    )


def ordered(pieces: Sequence[PieceSpec], stream: Stream) -> list[PieceSpec]:
    """Returns the pieces by importance, required ones first; neighbours with one `among` change places by the seed.

    A piece that only stands with another one of its neighbours stays behind it.
    """
    blocks: list[list[list[PieceSpec]]] = []
    words: list[str | None] = []
    for piece in sorted(pieces, key=lambda piece: not piece.required):
        word = None if piece.required else piece.among
        if word is None or not words or words[-1] != word:
            blocks.append([])
            words.append(word)
        unit = _unit(piece, blocks[-1])
        if unit is None:
            blocks[-1].append([piece])
        else:
            unit.append(piece)
    for block in blocks:
        stream.shuffle(block)
    return [piece for block in blocks for unit in block for piece in unit]


def _unit(piece: PieceSpec, block: Sequence[list[PieceSpec]]) -> list[PieceSpec] | None:
    """Returns the unit of a block that a piece cannot do without; None where there is none."""
    needed = {name for rule in piece.rules if rule.required for name in rule.of}
    return next((unit for unit in block if any(other.piece in needed for other in unit)), None)


def count(piece: PieceSpec, area: float, stream: Stream) -> int:
    """Returns how many of a piece a room of that area, m2, wants; always draws two numbers."""
    chance, share = stream.unit(), stream.unit()
    if chance >= piece.chance:
        return 0
    least, most = _range(piece, area)
    return least + int(share * (most - least + 1))


def _range(piece: PieceSpec, area: float) -> tuple[int, int]:
    """Returns the least and the most of a piece that a room of that area, m2, wants if it wants the piece."""
    if area < piece.min_area:
        return 0, 0
    if piece.per_area is None:
        return piece.count, piece.count
    most = max(1, min(piece.count, int(area / piece.per_area)))
    return (most + 1) // 2, most
