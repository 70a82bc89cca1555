"""An entry of `assets.yaml` and its file -> the asset: its size in metres, as it is said, or measured where one unit alone fits."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Final, NamedTuple

from catalogs.assets.asset_entry import FRONT_TURNS, Asset, AssetEntry, AssetSize, Front
from catalogs.assets.glb_file import GlbBounds, GlbFault, bounds_of, read_glb
from catalogs.decoration_types import DecorationKind
from catalogs.schema import FurnitureSpec

UNITS: Final[Mapping[str, float]] = {"m": 1.0, "cm": 0.01, "mm": 0.001, "inch": 0.0254}
"""Units that a file's numbers may be in, m."""
PLAUSIBLE: Final = 1.5
"""A unit fits if each side is at most so many times, and at least one so many-th of, that of a kind."""
UNEVEN: Final = 0.02
"""A size that is said may differ from the measured proportions by this share: it is a scale, no stretch."""
KindSpecs = Mapping[str, FurnitureSpec | DecorationKind]


class KindTable(NamedTuple):
    """Kinds by key, and by what scenes call them."""

    specs: KindSpecs
    named: Mapping[str, tuple[str, ...]]

    def keys_of(self, words: Iterable[str]) -> list[str]:
        """Returns the kinds that some words mean."""
        return list(dict.fromkeys(key for word in words for key in ((word,) if word in self.specs else ()) + self.named.get(word, ())))


def kind_table(furniture: Mapping[str, FurnitureSpec], decorations: Mapping[str, DecorationKind]) -> KindTable:
    """Returns all kinds that an asset may stand for."""
    named: dict[str, tuple[str, ...]] = {}
    for key, kind in furniture.items():
        if kind.name:
            named[kind.name] = (*named.get(kind.name, ()), key)
    return KindTable({**decorations, **furniture}, named)


def measured(folder: Path, entry: AssetEntry, kinds: KindTable) -> Asset:
    """Measures an asset.

    Raises:
        GlbFault: its file is refused, its size contradicts it, or no one unit fits.
    """
    path = f"{folder}/{entry.file}"
    file = read_glb(path)
    bounds = bounds_of(file)
    extents = turned_extents(bounds, entry.front)
    size, guessed = (_scaled(extents, entry.size), ()) if entry.size else _in_metres(extents, kinds, entry.kinds)
    if entry.surfaces and max(entry.surfaces) > size[2] + 0.001:
        raise GlbFault(f"has a surface at {max(entry.surfaces)} m; it is {size[2]:.3f} m high")
    return Asset(
        kinds=entry.kinds, front=entry.front, size=size, low=bounds.low, high=bounds.high, surfaces=entry.surfaces, mass=entry.mass,
        license=entry.license, source=entry.source, author=entry.author, guessed=tuple(dict.fromkeys((*entry.guessed, *guessed))),
        bytes=file.start + file.length, triangles=bounds.triangles, path=path,
    )  # fmt: skip


def turned_extents(bounds: GlbBounds, front: Front) -> AssetSize:
    """Returns the width, depth and height of a box whose front is turned to +z, in the file's units."""
    x, y, z = (high - low for low, high in zip(bounds.low, bounds.high, strict=True))
    return (x, z, y) if FRONT_TURNS[front] % 180 == 0 else (z, x, y)


def _scaled(extents: AssetSize, said: AssetSize) -> AssetSize:
    factors = [wanted / extent for wanted, extent in zip(said, extents, strict=True)]
    if max(factors) / min(factors) > 1 + UNEVEN:
        shown = " x ".join(f"{extent:.4g}" for extent in extents)
        raise GlbFault(f"has the proportions {shown}, not those of its size {said}; is its front another?")
    return said


def fitting_units(extents: AssetSize, sizes: Iterable[AssetSize]) -> list[str]:
    """Returns the units in which a box is about as large as one of some kinds."""
    known = list(sizes)
    return [unit for unit, metres in UNITS.items() if any(_is_like([extent * metres for extent in extents], size) for size in known)]


def _is_like(extents: Iterable[float], size: AssetSize) -> bool:
    return all(1 / PLAUSIBLE <= extent / wanted <= PLAUSIBLE for extent, wanted in zip(extents, size, strict=True))


def _in_metres(extents: AssetSize, kinds: KindTable, words: Iterable[str]) -> tuple[AssetSize, tuple[str, ...]]:
    """Returns a box in metres, and ("size",) where its unit is no metre."""
    keys = kinds.keys_of(words)
    units = fitting_units(extents, (kinds.specs[key].size for key in keys))
    if len(units) != 1:
        shown = " x ".join(f"{extent:.4g}" for extent in extents)
        fits = f"{' and '.join(units)} fit" if units else f"none of {', '.join(UNITS)} fits"
        raise GlbFault(f"is of an unknown unit: as {', '.join(words)} of {shown} {fits}; say its `size`, m")
    width, depth, height = (round(extent * UNITS[units[0]], 6) for extent in extents)
    return (width, depth, height), () if units == ["m"] else ("size",)
