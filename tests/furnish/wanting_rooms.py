"""Random rooms that want to be furnished: of our types and of random ones, for narrow and wide people, some to be covered in part alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from random import Random

from catalogs import Catalogs, load_catalogs
from solver.furnish import space_of, wanted_pieces, wanted_rows
from solver.pieces import Piece, Space, WantedRows
from solver.scene import Room
from solver.streams import Stream
from tests.furnish.random_types import random_room, random_type

KNOWN = load_catalogs()


@dataclass(frozen=True)
class WantingRoom:
    """A room to be furnished."""

    room: Room
    space: Space
    catalogs: Catalogs
    seed: int

    def pieces(self) -> tuple[Space, Sequence[Piece]]:
        """Returns what placement is asked, piece by piece."""
        return self.space, wanted_pieces(self.room, self.space, self.catalogs, Stream(self.seed, "furnish", 0))

    def rows(self) -> WantedRows:
        """Returns what the core is asked in one go."""
        return wanted_rows(self.room, self.space, self.catalogs, Stream(self.seed, "furnish", 0))


def wanting_room(seed: int) -> WantingRoom:
    """Returns a room; every third is of a random type."""
    rng = Random(f"wanting {seed}")
    room = random_room(rng, rng.choice(sorted(KNOWN.rooms)))
    known = KNOWN.model_copy(update={"rooms": {room.type: random_type(rng, KNOWN)}}) if seed % 3 == 2 else KNOWN
    space = space_of(room, 0.1, rng.choice((0.5, 0.6, 0.75)))
    return WantingRoom(room, replace(space, cover_mm2=rng.choice((0, 0, 3_000_000))), known, seed)
