"""The free place nearest to a wished one, against a try of every millimetre."""

from __future__ import annotations

from itertools import product
from random import Random

from solver.free_places import nearest_place
from solver.geometry import Rect
from tests.sweeps import seeds


def drawn(random: Random, most: int, largest: int) -> Rect:
    x, z = random.randrange(-4, most), random.randrange(-4, most)
    return Rect(x, z, x + random.randrange(1, largest), z + random.randrange(1, largest))


def by_trying(own: Rect, area: Rect, blocks: list[Rect], reach: int | None) -> Rect | None:
    """Tries every place in the area; of equally near ones the first is that of the lesser step along x, then west, then north."""
    width, depth = own.x1 - own.x0, own.z1 - own.z0
    found = []
    for x, z in product(range(area.x0, area.x1 - width + 1), range(area.z0, area.z1 - depth + 1)):
        clear = not any(x < block.x1 and block.x0 < x + width and z < block.z1 and block.z0 < z + depth for block in blocks)
        far = (x - own.x0) ** 2 + (z - own.z0) ** 2
        if clear and (reach is None or far <= reach**2):
            found.append((far, abs(x - own.x0), x, z))
    return Rect(min(found)[2], min(found)[3], min(found)[2] + width, min(found)[3] + depth) if found else None


def test_it_is_what_a_try_of_every_millimetre_finds() -> None:
    nowhere = elsewhere = 0
    for seed in seeds(range(6000), 10):
        random = Random(seed)
        own, area = drawn(random, 24, 12), Rect(0, 0, random.randrange(4, 26), random.randrange(4, 26))
        blocks = [drawn(random, 24, 10) for _ in range(random.randrange(12))]
        reach = random.choice((None, None, 0, 3, 9))
        told = by_trying(own, area, blocks, reach)
        assert nearest_place(own, area, blocks, reach) == told, seed
        nowhere += told is None
        elsewhere += told is not None and told != own
    assert nowhere > 50
    assert elsewhere > 100


def test_a_box_that_fits_exactly_stands_and_one_larger_does_not() -> None:
    area, blocks = Rect(0, 0, 3000, 1000), [Rect(0, 0, 1200, 1000), Rect(1800, 0, 3000, 1000)]
    assert nearest_place(Rect(0, 0, 600, 1000), area, blocks) == Rect(1200, 0, 1800, 1000)
    assert nearest_place(Rect(0, 0, 601, 1000), area, blocks) is None
    assert nearest_place(Rect(0, 0, 600, 1000), area, blocks, 1199) is None
    assert nearest_place(Rect(0, 0, 600, 1000), area, blocks, 1200) == Rect(1200, 0, 1800, 1000)
