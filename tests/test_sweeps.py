"""What `make test` takes of a long sweep has one of each kind: no member of a dealt list, and nothing that a way can do, is left out."""

from __future__ import annotations

import re
from collections.abc import Callable
from inspect import getsource, isfunction
from itertools import product

import pytest

from tests import sweeps
from tests.browser import test_every_way_of_a_home, test_every_way_of_editing
from tests.browser.acts import Act
from tests.browser.ways import WAYS, Way

PAGES: list[list[Act]] = [vars(page)["ACTS"].all for page in (test_every_way_of_a_home, test_every_way_of_editing)]
USED = re.compile(r"\bway\.(\w+)\(")


def used(do: Callable[..., None], known: frozenset[str] = frozenset()) -> set[str]:
    """What of a way is used by an act, and by the functions of its module that it calls."""
    source = getsource(do)
    called = {name for name in re.findall(r"\b(\w+)\(", source) if isfunction(do.__globals__.get(name))} - known - {do.__name__}
    found = set(USED.findall(source))
    for name in called:
        found |= used(do.__globals__[name], known | called | {do.__name__})
    return found


def by(way: type[Way], acts: list[Act]) -> set[str]:
    return set().union(*(used(act.do) for act in acts if act.has(way)))


@pytest.mark.parametrize("way", WAYS)
def test_acts_that_are_dealt_to_a_way_use_all_that_it_can_do(way: type[Way]) -> None:
    every = by(way, [act for acts in PAGES for act in acts])
    dealt = by(way, [act for acts in PAGES for at, act in enumerate(acts) if way in act.dealt(at)])
    assert every > {"press", "tool", "choose", "select", "view", "changed"}
    assert every - dealt == set()


def test_each_act_is_dealt_to_some_of_its_ways() -> None:
    dealt = [(act, act.dealt(at)) for acts in PAGES for at, act in enumerate(acts)]
    assert all(ways and all(map(act.has, ways)) for act, ways in dealt)
    assert all(sum(way in ways for _, ways in dealt) > len(dealt) / 4 for way in WAYS)


@pytest.mark.parametrize(("ones", "others"), [("abc", "xyz"), ("a", "xyz"), ("abcde", "xy"), ("ab", "uvwxyz")])
def test_pairs_leave_out_none_of_either_list_and_all_are_each_with_each(ones: str, others: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sweeps, "ALL", False)
    some = sweeps.pairs(ones, others)
    assert ({one for one, _ in some}, {other for _, other in some}) == (set(ones), set(others))
    assert len(some) == len(set(some)) == max(len(ones), len(others))
    monkeypatch.setattr(sweeps, "ALL", True)
    assert sweeps.pairs(ones, others) == [*product(ones, others)]


@pytest.mark.parametrize(("longer", "kinds", "shorter"), [(4, 2, 2), (8, 4, 2), (8, 2, 4), (9, 3, 3), (16, 4, 4), (15, 3, 4)])
def test_kinds_that_take_turns_in_the_longer_list_meet_each_of_the_shorter(
    longer: int, kinds: int, shorter: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two of four formats were read with walls of one thickness alone."""
    monkeypatch.setattr(sweeps, "ALL", False)
    met = {(one % kinds, other) for one, other in sweeps.pairs(range(longer), range(shorter))}
    assert met == {*product(range(kinds), range(shorter))}
    assert met == {(one % kinds, other) for other, one in sweeps.pairs(range(shorter), range(longer))}
