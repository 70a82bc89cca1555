"""What a scene's bodies are shown as, written into it once, for whoever draws or exports it: their kinds, and assets of those that fit.

A body's box never changes: an asset is stretched into it, by at most 15 % a side. What lies on a body needs a surface of the asset at
that height. Of what fits, those are drawn by the scene's seed that are least distorted. Furniture of one kind
and size in a room is one set.
"""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import lru_cache
from math import log
from typing import Final, TypeVar

from catalogs import Catalogs
from catalogs.assets.asset_entry import Asset
from catalogs.assets.asset_measures import kind_table
from catalogs.insides import insides_of
from catalogs.kind_book import KindBook
from solver.scene import Decoration, Furniture, Room, Scene
from solver.streams import Stream

Named = TypeVar("Named", Furniture, Decoration)


def with_kinds(scene: Scene, catalogs: Catalogs) -> Scene:
    """Returns a scene whose furniture and decorations name their kinds; one that the catalogs do not know names none."""
    book = KindBook(catalogs)
    rooms = (
        replace(room, furniture=naming("furniture", room.furniture, book), decorations=naming("decoration", room.decorations, book))
        for room in scene.rooms
    )
    return replace(scene, rooms=tuple(rooms))


def naming(sort: str, bodies: Iterable[Named], book: KindBook) -> tuple[Named, ...]:
    """Returns bodies that name their kinds."""
    kinds = ((body, book.kind_of(sort, body.name, (body.width, body.depth, body.height), body.kind)) for body in bodies)
    return tuple(body if kind == body.kind else replace(body, kind=kind) for body, kind in kinds)


MOST_STRETCHED: Final = log(1.15)
"""By how much a side may be stretched, or shrunk, as a logarithm. Our choice: more shows."""
AS_GOOD: Final = log(1.03)
"""Assets whose distortion is at most so much above the least are drawn from. Our choice: as much does not show."""
LEVEL: Final = 0.02
"""What lies on a body may be so far above or below the asset's surface, m."""
TINY: Final = 1e-9
Shown = TypeVar("Shown", Furniture, Decoration)
AssetsByKind = Mapping[str, tuple[tuple[str, Asset], ...]]


def with_assets(scene: Scene, catalogs: Catalogs) -> Scene:
    """Returns a scene whose bodies name the assets that they are shown as.

    An asset that a body names already stays if it fits. Without assets in the catalogs the scene stays as it is.
    """
    if not catalogs.assets:
        return scene
    chooser = _Chooser(scene, catalogs)
    rooms = tuple(chooser.room(room) for room in scene.rooms)
    return scene if rooms == scene.rooms else replace(scene, rooms=rooms)


def fits(asset: Asset, size: tuple[float, float, float], resting: Iterable[float] = ()) -> bool:
    """Tells whether an asset may stand for a body of a size, m, on which things rest at these heights above its underside, m.

    One of whose surfaces nothing is said carries things on its very top.
    """
    if max(map(abs, _factors(asset, size))) > MOST_STRETCHED + TINY:
        return False
    stretched = size[2] / asset.size[2]
    surfaces = [height * stretched for height in asset.surfaces or (asset.size[2],)]
    return all(any(abs(height - surface) <= LEVEL + TINY for surface in surfaces) for height in resting)


def distortion(asset: Asset, size: tuple[float, float, float]) -> float:
    """Returns how unevenly an asset is stretched into a box: the spread of the logarithms of its three factors."""
    factors = _factors(asset, size)
    return max(factors) - min(factors)


def _factors(asset: Asset, size: tuple[float, float, float]) -> list[float]:
    return [log(wanted / extent) for wanted, extent in zip(size, asset.size, strict=True)]


class _Chooser:
    """Chooses the assets of one scene."""

    def __init__(self, scene: Scene, catalogs: Catalogs) -> None:
        self._catalogs, self._book, self._seed = catalogs, KindBook(catalogs), scene.seed or 0
        self._by_kind = assets_by_kind(catalogs)
        self._resting: dict[str, set[float]] = {}
        """At which heights above the floor things rest on a body, by its id, m."""
        for room in scene.rooms:
            for item in room.decorations:
                self._resting.setdefault(item.parent or "", set()).add(item.y)
            for piece in room.furniture:
                self._resting.setdefault(piece.on or "", set()).add(piece.y)
        for person in scene.dynamic:
            self._resting.setdefault(person.on or "", set()).add(person.y)

    def room(self, room: Room) -> Room:
        """Returns a room whose bodies name their assets."""
        sets: dict[str, set[float]] = {}
        keys = {piece.id: f"{piece.kind or piece.name}/{piece.width}/{piece.depth}/{piece.height}" for piece in room.furniture}
        for piece in room.furniture:
            sets.setdefault(keys[piece.id], set()).update(self._heights(piece))
        furniture = (self._shown(piece, "furniture", f"{room.id}/{keys[piece.id]}", sets[keys[piece.id]]) for piece in room.furniture)
        decorations = (self._shown(item, "decoration", item.id, self._heights(item)) for item in room.decorations)
        return replace(room, furniture=tuple(furniture), decorations=tuple(decorations))

    def _heights(self, body: Furniture | Decoration) -> set[float]:
        """Returns the heights above a body's underside at which things rest on it; what lies inside it is hidden by any asset."""
        heights = {round(height - body.y, 6) for height in self._resting.get(body.id, ())}
        return heights if isinstance(body, Decoration) else {one for one in heights if not self._is_inside(body, one)}

    def _is_inside(self, piece: Furniture, height: float) -> bool:
        size = piece.width, piece.depth, piece.height
        kind = self._book.kind_of("furniture", piece.name, size, piece.kind)
        return any(abs(one.height - height) < LEVEL / 10 for one in insides_of(self._book.solids(kind), size))

    def _shown(self, body: Shown, sort: str, drawn_by: str, resting: set[float]) -> Shown:
        """Returns a body that names its asset: the one it names if that fits it, else one that fits all of its set, drawn by a name."""
        size = body.width, body.depth, body.height
        kind = self._book.kind_of(sort, body.name, size, body.kind)
        known = self._by_kind.get(kind or "", ())
        named = dict(known).get(body.asset or "")
        if named and fits(named, size, self._heights(body)):
            return body
        fitting = [(distortion(asset, size), name) for name, asset in known if fits(asset, size, resting)]
        if not fitting:
            return body if body.asset is None else replace(body, asset=None)
        least, _ = min(fitting)
        good = [name for spread, name in fitting if spread <= least + AS_GOOD]
        return replace(body, asset=Stream(self._seed, "assets", drawn_by).pick(good))


@lru_cache(maxsize=8)
def assets_by_kind(catalogs: Catalogs) -> AssetsByKind:
    """Returns the assets of each kind, in the order of their names."""
    found: dict[str, list[tuple[str, Asset]]] = {}
    kinds = kind_table(catalogs.furniture, catalogs.decorations)
    for name, asset in catalogs.assets.items():
        for kind in kinds.keys_of(asset.kinds):
            found.setdefault(kind, []).append((name, asset))
    return {kind: tuple(assets) for kind, assets in found.items()}
