"""How often, and how much, somebody may ask: a bucket of tokens each, and seconds of work a day."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import dataclass
from math import ceil
from typing import Final

KNOWN: Final = 10_000
"""How many callers are remembered; who has asked least recently is forgotten. Our choice: some megabytes."""
MINUTE_S: Final = 60.0
DAY_S: Final = 86_400


@dataclass(frozen=True)
class Allowance:
    """What one caller may do; 0 where there is no limit.

    Calls a minute, that many at once; seconds of work a day, of the calendar in UTC.
    """

    calls: int = 0
    work_s: float = 0


UNBOUNDED: Final = Allowance()


class Rates:
    """Lets each caller ask so often a minute, that many times at once; 0 for no limit."""

    def __init__(self, calls: int) -> None:
        self._calls = calls
        self._left: OrderedDict[str, tuple[float, float]] = OrderedDict()

    def wait(self, who: str, now: float) -> int:
        """Counts a call of somebody; returns 0 where it may be made, else how many seconds to wait. The clock, s, never goes back."""
        if self._calls == 0:
            return 0
        left, then = self._left.pop(who, (float(self._calls), now))
        left = min(float(self._calls), left + max(now - then, 0.0) * self._calls / MINUTE_S)
        allowed = left >= 1
        self._left[who] = (left - 1 if allowed else left, now)
        if len(self._left) > KNOWN:
            self._left.popitem(last=False)
        return 0 if allowed else ceil((1 - left) * MINUTE_S / self._calls)


class Quotas:
    """Lets each caller have so many seconds of work a day; 0 for no limit."""

    def __init__(self, work_s: float) -> None:
        self._most = work_s
        self._day = 0
        self._used: dict[str, float] = {}

    def wait(self, who: str, now: float) -> int:
        """Returns 0 where somebody may have more work today, else the seconds until tomorrow; `now` in seconds since 1970, UTC."""
        self._turn(now)
        return 0 if self._most == 0 or self._used.get(who, 0.0) < self._most else ceil(DAY_S - now % DAY_S)

    def spend(self, who: str, work_s: float, now: float) -> None:
        """Counts work that was done for somebody."""
        self._turn(now)
        if self._most > 0 and (who in self._used or len(self._used) < KNOWN):
            self._used[who] = self._used.get(who, 0.0) + work_s

    def _turn(self, now: float) -> None:
        """Begins another day; a clock that was put back a little goes on with the day there is, one that had been days ahead does not."""
        if (day := int(now // DAY_S)) > self._day or day < self._day - 1:
            self._day, self._used = day, {}
