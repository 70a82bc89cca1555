"""How much work a call may do: one count for all its searches, the same on every machine; and what an answer says where it ended them.

Not here: the counting (placement).
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    from solver.answers import Limited
    from solver.placement import CallWork

EFFORTS: Final[Mapping[str, float]] = {"quick": 0.1, "normal": 1.0, "thorough": 10.0}
"""How many times the work of a normal call each may do."""
NORMAL: Final = "normal"
NORMAL_WORK: Final = 1_500_000
"""Work of a normal call, in QPs of a small room: two to four seconds of CPU. Our choice: repairing a home takes a hundredth of it."""

NORMAL_JUDGING: Final = 1_000_000
"""Work of a call beside its searches, in the same unit. Our choice: judging a home of thirty rooms takes a two-hundredth of it."""

YOUNG: Final = 50_000
"""Objects made, beyond those gone, until a process looks for cycles: a home holds some ten thousand and makes no cycle."""


@dataclass(frozen=True)
class Terms:
    """What whoever runs the service allows: the work of a normal call, in QPs of a small room; the greatest effort; and `judging`.

    That is work that a call of any effort may do beside its searches: what cannot end early with a lesser answer.
    """

    work: float = NORMAL_WORK
    most: str = "thorough"
    judging: float = NORMAL_JUDGING


USUAL: Final = Terms()


@dataclass
class Bill:
    """The terms that calls are made on, and the work that they did."""

    terms: Terms
    done: float = 0.0


_bill: ContextVar[Bill] = ContextVar("what calls may do and did", default=Bill(USUAL))  # noqa: B039 - one for all calls on the usual terms


@contextmanager
def on_terms(terms: Terms) -> Iterator[Bill]:
    """Has calls within a block made on these terms; yields what tells the work that they did."""
    bill = Bill(terms)
    before = _bill.set(bill)
    try:
        yield bill
    finally:
        _bill.reset(before)


class Spending:
    """The work of a call while it is made, and what is to be said of it."""

    def __init__(self, effort: str, counted: "CallWork") -> None:
        self._effort, self._counted = effort, counted

    def limited(self) -> "Limited | None":
        """Returns what the answer says where the limit ended a search; None where it did not."""
        if not self._counted.spent:
            return None
        from solver.answers import Limited  # noqa: PLC0415 - the command line's words need none of it

        most = round(self._counted.most)
        more = [name for name in list(EFFORTS)[list(EFFORTS).index(self._effort) + 1 :] if EFFORTS[name] <= EFFORTS[_bill.get().terms.most]]
        words = f"the search ended at its limit of work, {most:,}; more may be found with " + (
            f"effort {more[0]}" if more else "less to place, or on the command line"
        )
        return Limited(self._effort, most, words)


@contextmanager
def limited_to(effort: str = NORMAL) -> Iterator[Spending]:
    """Limits the work of a block to that of one of EFFORTS.

    Raises:
        FieldError: it is more than may be asked for.
    """
    from solver.errors import FieldError  # noqa: PLC0415
    from solver.placement import work_of_call  # noqa: PLC0415 - what only reads a scene needs no placement

    bill = _bill.get()
    terms = bill.terms
    if EFFORTS[effort] > EFFORTS[terms.most]:
        allowed = [name for name, times in EFFORTS.items() if times <= EFFORTS[terms.most]]
        raise FieldError("effort", f"is {effort}, more than this service does", ", ".join(allowed))
    with work_of_call(terms.work * EFFORTS[effort]) as counted:
        yield Spending(effort, counted)
    bill.done += counted.done
