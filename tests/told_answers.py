"""What the page shows of a refusal, and of a file that was read."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from solver.answers import PlanImport
from solver.errors import ComposeError, FieldError
from tests.told_forms import is_told
from tests.told_sources import NAME


def untold_in_refusal(error: ComposeError) -> list[str]:
    """The words of a refusal that have no German."""
    entries = [(error.problem, error.allowed), *(one[1:] for one in error.more)] if isinstance(error, FieldError) else [(str(error), "")]
    return [words for entry in entries for words in entry if words and not is_told(words)]


def untold_in_import(answer: PlanImport, names: Iterable[str]) -> list[str]:
    """The words about a file that was read which have no German, beside names that it gives its pieces."""
    given = re.compile("|".join(map(re.escape, filter(None, names))))
    return [words for said in _said_in_import(answer) if not is_told(words := given.sub(NAME, said))]


def _said_in_import(answer: PlanImport) -> Iterator[str]:
    for guess in answer.guesses:
        yield from (str(guess[key]) for key in ("what", "taken", "message"))
    yield from (str(left[key]) for left in answer.unread for key in ("place", "reason"))
    yield from (str(change["message"]) for change in answer.changes)
