"""What a seed alone decides: the order of pieces that matter alike, how many there are, and small costs among good ways.

Two houses with one and the same room shall not furnish it alike, nor badly: whims are smaller than what a bad way costs.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from catalogs.schema import Piece
from solver.geometry import Rect
from solver.scene import WALLS
from solver.streams import Stream
from solver.wanted import Alternative

WALL_WHIM = 1.6
"""Most that a wall may cost a piece by whim alone: less than standing before a window, as much as half a size variant."""
QUARTER_WHIM = 0.35
"""The same for the quarters of the room, for pieces that stand free: small things cost little to leave out."""
SIDE_WHIM = 0.3
"""The same for the side of another piece."""
KIND_WHIM = 0.5
"""The same for a size variant."""
SIDES = ("left", "right", "front", "back")


@dataclass(frozen=True)
class Whims:
    """What one copy of a piece feels about walls, quarters of the room, sides of other pieces and its variants, as costs."""

    walls: tuple[float, ...]
    quarters: tuple[float, ...]
    sides: tuple[float, ...]
    kinds: tuple[float, ...]

    def cost(self, alternative: Alternative, piece: Piece, clear: Rect) -> float:
        """Returns what an alternative costs by whim."""
        kinds = [variant.kind for variant in piece.variants]
        total = self.kinds[kinds.index(alternative.kind)] if alternative.kind in kinds[: len(self.kinds)] and len(kinds) > 1 else 0.0
        if alternative.attach is not None:
            slot = alternative.attach.slot
            return total + (self.sides[SIDES.index(slot)] if slot in SIDES else 0.0)
        if alternative.wall is not None:
            return total + self.walls[WALLS.index(alternative.wall)]
        (x, z), right, low = alternative.anchor_mm, clear.x0 + clear.x1, clear.z0 + clear.z1
        return total + self.quarters[2 * (2 * z > low) + (2 * x > right)]


def drawn(stream: Stream) -> Whims:
    """Draws the whims of one copy of a piece; always as many numbers."""
    return Whims(
        tuple(stream.uniform(0.0, WALL_WHIM) for _ in WALLS),
        tuple(stream.uniform(0.0, QUARTER_WHIM) for _ in range(4)),
        tuple(stream.uniform(0.0, SIDE_WHIM) for _ in SIDES),
        tuple(stream.uniform(0.0, KIND_WHIM) for _ in range(3)),
    )


def ordered(pieces: Sequence[Piece], stream: Stream) -> list[Piece]:
    """Returns the pieces by importance, required ones first; neighbours with one `among` change places by the seed.

    A piece that only stands with another one of its neighbours stays behind it.
    """
    blocks: list[list[list[Piece]]] = []
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


def _unit(piece: Piece, block: Sequence[list[Piece]]) -> list[Piece] | None:
    """Returns the unit of a block that a piece cannot do without; None where there is none."""
    needed = {name for rule in piece.rules if rule.required for name in rule.of}
    return next((unit for unit in block if any(other.piece in needed for other in unit)), None)


def count(piece: Piece, area: float, stream: Stream) -> int:
    """Returns how many of a piece a room of that area, m2, wants; always draws two numbers."""
    chance, share = stream.unit(), stream.unit()
    if piece.required:
        return piece.count
    if area < piece.min_area or chance >= piece.chance:
        return 0
    if piece.per_area is None:
        return piece.count
    most = max(1, min(piece.count, int(area / piece.per_area)))
    least = (most + 1) // 2
    return least + int(share * (most - least + 1))
