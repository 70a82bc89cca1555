"""What a person does on the page, as issue by issue it is promised: each act is done in every way, and this is the matrix of both.

`pytest --collect-only -q tests/browser/test_every_way_*.py` prints it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import pytest

from tests.browser.ways import WAYS, Way

Do: TypeAlias = Callable[[Way], None]
MOST_STEPS = 12
"""No act takes more."""


@dataclass(frozen=True)
class Act:
    """Something to be done, and in which ways it cannot be, with what one does in place of it."""

    name: str
    do: Do
    instead: dict[str, str]


@dataclass
class Acts:
    """The acts of one page that is opened once for each way."""

    all: list[Act] = field(default_factory=list)

    def act(self, name: str, **instead: str) -> Callable[[Do], Do]:
        """Takes a function as an act; `instead` says of a way that has none what is done in place of it."""

        def take(do: Do) -> Do:
            self.all.append(Act(name, do, instead))
            return do

        return take

    def by_every_way(self) -> pytest.MarkDecorator:
        """Parametrizes a test with every act that each way has."""
        pairs = [(way, act) for way in WAYS for act in self.all if way.name not in act.instead]
        return pytest.mark.parametrize(
            ("way", "act"), [pytest.param(way, act, id=f"{way.name}: {act.name}") for way, act in pairs], indirect=["way"], scope="module"
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
