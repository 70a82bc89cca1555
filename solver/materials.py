"""The style of a house, and what its floors and walls are made of in it.

Not here: the colours of furniture (furnished) and of decorations (decorations).
"""

from catalogs import Catalogs
from catalogs.styles import Style
from solver.errors import RequestError
from solver.records import changed
from solver.scene import Flooring, Room, WallFinish
from solver.streams import Stream


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
        floor = Stream(seed, "floor", known.flooring).pick(floors)
        flooring = Flooring(floor.type or known.flooring, floor.color)
    if walls:
        wall = Stream(seed, "wall", room.index).pick(walls)
        finish = WallFinish(wall.type, wall.color)
    return changed(room, flooring=flooring, walls=finish)
