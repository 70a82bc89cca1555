"""What a person does on the page, as issue by issue it is promised: each act is done in every way, and this is the matrix of both.

`SWEEPS=all pytest --collect-only -q tests/browser/test_every_way_*.py` prints it. In `make test` each act is done in the way whose turn it
is, those that show a sort of control in every way.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import pytest

from tests.browser.ways import WAYS, Way
from tests.sweeps import ALL

Do: TypeAlias = Callable[[Way], None]
MOST_STEPS = 12
"""No act takes more."""


@dataclass(frozen=True)
class Act:
    """Something to be done, and in which ways it cannot be, with what one does in place of it.

    `always`: in all its ways whatever is dealt, as it shows a sort of control.
    """

    name: str
    do: Do
    instead: dict[str, str]
    always: bool

    def has(self, way: type[Way]) -> bool:
        """Whether it can be done in a way."""
        return way.name not in self.instead

    def dealt(self, turn: int) -> list[type[Way]]:
        """The ways in which it is done in `make test`: of those that it has, the one whose turn it is."""
        own = [way for way in WAYS[turn % len(WAYS) :] + WAYS if self.has(way)]
        return own if self.always else own[:1]


@dataclass
class Acts:
    """The acts of one page that is opened once for each way."""

    all: list[Act] = field(default_factory=list)

    def act(self, name: str, *, always: bool = False, **instead: str) -> Callable[[Do], Do]:
        """Takes a function as an act; `instead` says of a way that has none what is done in place of it."""

        def take(do: Do) -> Do:
            self.all.append(Act(name, do, instead, always))
            return do

        return take

    def by_every_way(self) -> pytest.MarkDecorator:
        """Parametrizes a test with every act that each way has, or with those that are dealt to it."""
        done = [(way, act) for way in WAYS for at, act in enumerate(self.all) if (act.has(way) if ALL else way in act.dealt(at))]
        return pytest.mark.parametrize(
            ("way", "act"), [pytest.param(way, act, id=f"{way.name}: {act.name}") for way, act in done], indirect=["way"], scope="module"
        )


def left_as_found(way: Way, act: Act) -> None:
    """Does an act and takes back what it did to the home, which is then the same to the byte."""
    before = way.scene()
    way.visit.console.clear()
    try:
        act.do(way)
        way.let_go()
        walk_back(way, before)
    except BaseException:
        way.visit.reopened(way.page.reload)  # the next act finds the page as it would without this one
        way.page.keyboard.press(way.seen)
        walk_back(way, before)
        raise
    assert way.visit.console == []


def walk_back(way: Way, before: str) -> None:
    """Undoes step after step until the home is as it was before."""
    undo = way.page.locator("#tools [data-tool=undo]")
    for _ in range(MOST_STEPS):
        if way.scene() == before:
            break
        assert undo.is_enabled(), "this cannot be undone"
        way.changed(lambda: way.tool("undo"))
    assert way.scene() == before


def bodies(scene: Any) -> Iterator[Any]:
    """All furniture of a scene."""
    return (piece for room in scene["rooms"] for piece in room["furniture"])
