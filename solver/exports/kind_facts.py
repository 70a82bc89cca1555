"""What all bodies of a kind share: what they are called, weigh and are made of; kept from one house to the next."""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Final, Literal, NamedTuple

from catalogs import Catalogs
from catalogs.decoration_types import DecorationKind
from catalogs.entries import Side
from catalogs.fronts import BodyFront, fronts_of, sized_front
from catalogs.kind_book import KindBook
from catalogs.schema import FurnitureSpec
from solver.body_parts import BodyPart, sized, unit_parts
from solver.exports.model import Paint
from solver.exports.paints import Paints

UNKNOWN_DENSITY: Final = 120.0
"""What a thing weighs by its box that the catalogs do not know, kg/m3: the middle of our furniture."""
LIVING: Final = "dynamic"
"""The category of people and pets."""
FRICTION: Final = {"low": 0.3, "medium": 0.6, "high": 0.9}
"""Coefficients of dry friction: polished or on castors; wood, plastic; rubber, cloth."""


class KindFacts(NamedTuple):
    """What bodies of a kind share.

    `key` is the catalogs' (None: they do not know it), `shape` the key of its shape. A body weighs `mass`, kg, by the ratio of its box to
    `volume`, m3. `labels` are semantic, the most particular first; `friction` a coefficient; `moves` what the kind says of itself;
    `sides` those it is used from; `color` is what furniture has that says none.
    """

    key: str | None
    shape: str
    category: str
    labels: tuple[str, ...]
    mass: float
    volume: float
    friction: float
    moves: Literal["free", "fixed"] | None
    sides: Sequence[Side]
    color: str | None = None


@lru_cache(maxsize=8)
def book_of(catalogs: Catalogs) -> KindBook:
    """Returns the kinds of catalogs by what scenes call them."""
    return KindBook(catalogs)


@lru_cache(maxsize=8)
def classes_of(catalogs: Catalogs) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Returns the names of all kinds of furniture, and of all categories that things have; in order."""
    categories = {kind.category for kind in catalogs.furniture.values()} | {kind.group for kind in catalogs.decorations.values()}
    return tuple(sorted(catalogs.furniture)), tuple(sorted(categories))


@lru_cache(maxsize=1 << 12)
def furniture_facts(book: KindBook, name: str, key: str | None, category: str | None) -> KindFacts:
    """Returns what is known of a piece by its name, its kind's key and the category that its scene says."""
    spec = book.spec("furniture", key) if key else None
    known = category or (spec.category if isinstance(spec, FurnitureSpec) else "misc")
    return _facts(spec, name, (key, key or "", known))._replace(color=spec.color if spec else None)


@lru_cache(maxsize=1 << 12)
def decoration_facts(book: KindBook, name: str, key: str | None) -> KindFacts:
    """Returns what is known of a decoration by its name and its kind's key."""
    spec = book.spec("decoration", key) if key else None
    return _facts(spec, name, (key, key or "", spec.group if isinstance(spec, DecorationKind) else "decor"))._replace(
        color=spec.color if spec else None
    )


@lru_cache(maxsize=256)
def living_facts(book: KindBook, kind: str, seated: bool) -> KindFacts:
    """Returns what is known of a person or a pet."""
    spec = book.dweller(kind)
    return _facts(spec, kind, (kind if spec else None, book.living(kind, seated) or "", LIVING))


def _facts(spec: FurnitureSpec | DecorationKind | None, name: str, named: tuple[str | None, str, str]) -> KindFacts:
    """Returns a kind's facts; `named` are its key, its shape and its category."""
    key, shape, category = named
    labels = tuple(dict.fromkeys((*((key,) if key else ()), name, category, *(spec.labels if spec else ()))))
    if spec is None:
        return KindFacts(key, shape, category, labels, UNKNOWN_DENSITY, 1.0, FRICTION["medium"], None, ())
    sides = spec.use.sides if isinstance(spec, FurnitureSpec) and spec.use else ()
    return KindFacts(key, shape, category, labels, spec.mass, math.prod(spec.size), FRICTION[spec.friction], spec.moves, sides)


@lru_cache(maxsize=1 << 12)
def unit_shape(book: KindBook, shape: str) -> tuple[BodyPart, ...]:
    """Returns the parts of a shape as shares of a body's box."""
    return unit_parts(book.solids(shape))


@lru_cache(maxsize=1 << 12)
def parts_of_shape(book: KindBook, shape: str, size: tuple[float, float, float]) -> tuple[BodyPart, ...]:
    """Returns the parts of a shape in a box of this width, depth and height, m."""
    return sized(unit_shape(book, shape), *size)


@lru_cache(maxsize=1 << 12)
def fronts_of_shape(book: KindBook, shape: str, size: tuple[float, float, float]) -> tuple[BodyFront, ...]:
    """Returns what opens of a shape in a box of this width, depth and height, m."""
    return tuple(sized_front(one, size) for one in fronts_of(book.solids(shape)))


@lru_cache(maxsize=1 << 12)
def paints_of_shape(book: KindBook, shape: str, paints: Paints, colors: tuple[str | None, str | None]) -> tuple[Paint, ...]:
    """Returns the paints of a shape's parts; `colors` are the body's own and the accent of its room."""
    return tuple(paints.of(part.material, *colors) for part in unit_shape(book, shape))
