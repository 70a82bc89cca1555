"""An arrangement written into its room: ids, names, colours, metres; the style of a house, its floors and walls.

Not here: the colours of decorations (decorations).
"""

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Final, NamedTuple

from catalogs import Catalogs
from catalogs.styles import Style
from solver.body_rows import BODY, BODY_WALLS, KIND, FurnitureRows, furniture_look, told
from solver.errors import RequestError
from solver.pieces import Arrangement, Placed, StandingRows
from solver.records import changed
from solver.scene import Flooring, Room, WallFinish
from solver.streams import Stream

PLAIN_COLOUR = "#9a9a9a"
"""Of what the catalogs do not know."""


class _Colouring(NamedTuple):
    """What the colour of a kind is drawn from: what palettes may name it by, and its own colours."""

    names: tuple[str, str, str]
    own: tuple[str, ...]


class _Colourings(dict[str, _Colouring]):
    """What the colours of the catalogs' kinds are drawn from, by kind."""

    def __init__(self, catalogs: Catalogs) -> None:
        super().__init__()
        self._catalogs = catalogs

    def __missing__(self, kind: str) -> _Colouring:
        spec = self._catalogs.furniture.get(kind)
        category, own = (spec.category, (spec.color, *spec.variants)) if spec else ("misc", (PLAIN_COLOUR,))
        found = self[kind] = _Colouring((kind, self._catalogs.name_of(kind), category), own)
        return found


_colourings: Final = lru_cache(maxsize=64)(_Colourings)
"""Those of catalogs."""
_flooring, _finish = lru_cache(maxsize=1024)(Flooring), lru_cache(maxsize=1024)(WallFinish)
"""Each flooring and finish is one object, which rooms share."""


@lru_cache(maxsize=1024)
def _floor_drawn(seed: int, flooring: str, count: int) -> int:
    """Draws which of so many floors a house has in rooms with the same flooring."""
    return Stream(seed, "floor", flooring).below(count)


def furnished(room: Room, arrangement: Arrangement, catalogs: Catalogs, stream: Stream, style: Style | None = None) -> Room:
    """Returns the room with the arrangement's pieces as its furniture.

    Ids count the pieces of one name: `<room id>/<name>_<n>`. A piece's colour is drawn from the stream: of the style's palette
    for it, which all pieces of the room with that palette then share, or else of its kind's own colours; all pieces of one kind
    in a room share it.
    """
    content, kinds, looks = arrangement.standing or _standing(arrangement.placed, catalogs)
    present = {number: kinds[number][0] for (number,) in KIND.iter_unpack(content)}
    colours = _colours(sorted(set(present.values())), catalogs, style, stream)
    rows = FurnitureRows(content, room, looks, {number: colours[kind] for number, kind in present.items()})
    return told(room, rows)


def _standing(placed: Sequence[Placed], catalogs: Catalogs) -> StandingRows:
    """Returns pieces as the core tells of those that it places."""
    kinds = tuple({(one.chosen.kind, one.chosen.size_mm): None for one in placed})
    places, rows = {one.label: place for place, one in enumerate(placed)}, []
    counts: Counter[str] = Counter()
    for one in placed:
        way, name = one.chosen, catalogs.name_of(one.chosen.kind)
        counts[name] += 1
        carriers = places.get(way.on or "", -1), places.get(way.under or "", -1)
        turn = BODY_WALLS.index(one.wall), one.rotation, 0, counts[name], 0
        rows.append(BODY.pack(kinds.index((way.kind, way.size_mm)), *carriers, *turn, *one.footprint, way.bottom_mm, *way.size_mm))
    looks = [furniture_look(one.chosen.kind, one.chosen.size_mm, catalogs) for one in placed]
    return StandingRows(b"".join(rows), kinds, looks)


def names_placed(arrangement: Arrangement, catalogs: Catalogs) -> list[str]:
    """Returns what scenes call the pieces that stand."""
    rows = arrangement.standing
    return [look.name for look in rows.looks] if rows else [catalogs.name_of(one.chosen.kind) for one in arrangement.placed]


def recoloured(room: Room, catalogs: Catalogs, stream: Stream, style: Style | None, bare: bool = False) -> Room:
    """Returns a furnished room in the colours of a style (None: the kinds' own), drawn as for new furniture.

    What has no kind keeps its colour. `bare`: only what has no colour gets one.
    """
    kinds = {piece.kind for piece in room.furniture if piece.kind in catalogs.furniture and not (bare and piece.color)}
    colours = _colours(sorted(kinds), catalogs, style, stream)
    pieces = (
        piece if bare and piece.color else replace(piece, color=colours.get(piece.kind or "", piece.color)) for piece in room.furniture
    )
    return replace(room, furniture=tuple(pieces))


def ids_of(room: Room, arrangement: Arrangement, catalogs: Catalogs) -> dict[str, str]:
    """Returns the ids of an arrangement's pieces in a room, by label."""
    ids: dict[str, str] = {}
    counts: dict[str, int] = {}
    for placed in arrangement.placed:
        name = catalogs.name_of(placed.chosen.kind)
        counts[name] = counts.get(name, 0) + 1
        ids[placed.label] = f"{room.id}/{name}_{counts[name]}"
    return ids


def _colours(kinds: Sequence[str], catalogs: Catalogs, style: Style | None, stream: Stream) -> dict[str, str]:
    colours: dict[str, str] = {}
    matching: dict[tuple[str, ...], str] = {}
    known = _colourings(catalogs)
    for kind in kinds:
        names, own = known[kind]
        palette = style.colours(*names) if style else ()
        if palette in matching:
            colours[kind] = matching[palette]
        else:
            colours[kind] = stream.pick(palette or own)
        if palette:
            matching[palette] = colours[kind]
    return colours


def chosen_style(wished: str | None, catalogs: Catalogs, seed: int) -> str | None:
    """Returns the style of a house: the one wished for, else one of the seed's; None where the catalogs know none.

    Raises:
        RequestError: the catalogs do not know the style.
    """
    known = tuple(catalogs.styles)
    if wished is None:
        return Stream(seed, "style").pick(known) if known else None
    if wished not in catalogs.styles:
        raise RequestError("style", f"unknown style {wished!r:.60}", ", ".join(known) or "none: the catalogs have no styles")
    return wished


def with_materials(room: Room, catalogs: Catalogs, style: Style | None, seed: int) -> Room:
    """Returns an indoor room with the floor and the walls of a style.

    Rooms with the same flooring in their types' files share one floor; each room's walls are drawn by themselves.
    """
    known = catalogs.rooms.get(room.type)
    if style is None or known is None or room.outdoor:
        return room
    floors, walls = style.floors.get(known.flooring, ()), style.walls.get(known.flooring, ())
    flooring, finish = room.flooring, room.walls
    if floors:
        floor = floors[_floor_drawn(seed, known.flooring, len(floors))]
        flooring = _flooring(floor.type or known.flooring, floor.color)
    if walls:
        wall = Stream(seed, "wall", room.index).pick(walls)
        finish = _finish(wall.type, wall.color)
    return changed(room, flooring=flooring, walls=finish)
