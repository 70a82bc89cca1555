"""What bodies of a kind carry things on: their surfaces, the boards inside them and the bottoms of their drawers."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import NamedTuple

from catalogs.insides import insides_of
from catalogs.kind_book import UPRIGHT, KindBook


class Receptacle(NamedTuple):
    """A rectangle that things can stand on.

    `surface` is what the kind calls it; inside a body `shelves` or `drawers`, of these with the `front` that it moves with. Its middle
    is `x` to the right and `z` to the front of the body's, `height` above the underside; `clearance` is free over it (None: open), m.
    """

    surface: str
    front: str | None
    x: float
    z: float
    height: float
    width: float
    depth: float
    clearance: float | None


@lru_cache(maxsize=1 << 12)
def receptacles_of(book: KindBook, sort: str, key: str | None, size: tuple[float, float, float]) -> tuple[Receptacle, ...]:
    """Returns what a body carries things on, its surfaces as the catalogs list them, then what is inside.

    Nothing stands on people and pets, nor on what is tipped or of no kind. What is inside is known of bodies as large as their kind.
    """
    return () if key is None or sort == "dynamic" or key.endswith(UPRIGHT) else tuple(_found(book, sort, key, size))


def _found(book: KindBook, sort: str, key: str, size: tuple[float, float, float]) -> Iterator[Receptacle]:
    kind, (width, depth, height) = book.spec(sort, key), size
    for one in kind.surfaces:
        sides = width - 2 * one.inset, depth - 2 * one.inset
        if min(sides) > 0:
            yield _rounded(one.name, None, 0.0, 0.0, one.height * height / kind.size[2], *sides, one.clearance)
    for inside in insides_of(book.solids(key), size) if sort == "furniture" and size == kind.size else ():
        (x0, x1), (z0, z1) = inside.x, inside.z
        middle = (x0 + x1) / 2, (z0 + z1) / 2
        yield _rounded(inside.sort, inside.drawer, *middle, inside.height, x1 - x0, z1 - z0, inside.clearance)


def _rounded(surface: str, front: str | None, *lengths: float | None) -> Receptacle:
    return Receptacle(surface, front, *[None if length is None else round(length, 6) for length in lengths])  # type: ignore[arg-type]
