"""Walls cut at their holes: every spot of a wall is told the heights that holes over it take, whether they lie apart or over each other."""

from __future__ import annotations

from random import Random

from solver.wall_fittings import cut_at_holes


def test_each_stretch_is_told_what_holes_are_over_it() -> None:
    for seed in range(3000):
        chance = Random(seed)
        start, end = 0, chance.randrange(1, 12)
        holes = []
        for _ in range(chance.randrange(5)):
            low = chance.randrange(-1, 11)
            holes.append(((low, low + chance.randrange(1, 4)), (chance.randrange(2), 2 + chance.randrange(2))))
        found = list(cut_at_holes((start, end), holes))
        spots = [at + 0.5 for at in range(start, end)]
        assert [low for (low, _), _ in found] == [start, *(high for (_, high), _ in found[:-1])] and found[-1][0][1] == end
        for at in spots:
            (told,) = (heights for (low, high), heights in found if low < at < high)
            assert told == sorted({up for (low, high), up in holes if low < at < high})
