"""What a format's own reader finds in its files, to be compared with the description: one module a format, `read(files)`."""

from __future__ import annotations

from typing import NamedTuple


class Seen(NamedTuple):
    """A body as a file holds it, in the scene's frame: x east, y up, z south, in the house, m.

    `x`, `y`, `z` are the middle of its footprint at its underside, `turn` degrees about +y (0 faces south), sizes those of the
    unturned body. None: the format does not say.
    """

    x: float
    y: float
    z: float
    turn: float
    width: float
    depth: float
    height: float
    mass: float | None = None
