"""Work that a room may cost; counted, never timed, so that equal requests give equal bytes.

Comes in: nothing. Goes out: `Budget`, which every search of placement counts down.
"""

from __future__ import annotations

ROOM_WORK = 400_000.0
"""Work one room may cost, in QPs of a small room."""


class Budget:
    """Work that may still be done, in QPs of a small room. A problem of n variables an axis counts 1 + (n / 20)^2 a QP.

    Args:
        left: how much.
    """

    def __init__(self, left: float = ROOM_WORK) -> None:
        self.left = left

    @property
    def spent(self) -> bool:
        """Tells whether nothing is left."""
        return self.left <= 0
