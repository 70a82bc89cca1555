"""Stage times, by a clock that the caller brings: the solver itself knows no time."""

from collections.abc import Callable

Clock = Callable[[], float]
"""Returns seconds; only differences count."""


class Timing:
    """Milliseconds by stage; without a clock there are none."""

    def __init__(self, clock: Clock | None) -> None:
        self.clock = clock
        self.ms: dict[str, float] = {}
        self.last = self.first = clock() if clock else 0.0

    def lap(self, stage: str) -> None:
        """Ends a stage: notes its own time and the total so far."""
        if self.clock:
            now = self.clock()
            self.ms[stage] = round((now - self.last) * 1000, 3)
            self.ms["total"] = round((now - self.first) * 1000, 3)
            self.last = now
