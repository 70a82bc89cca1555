"""Homes of ours as somebody's own plan would hold them: rooms without types, names that tell nothing, furniture left out."""

from __future__ import annotations

from dataclasses import replace

from solver.scene import Opening, Room, Scene


def as_plan(home: Scene, furnished: bool = False) -> Scene:
    """Returns a home with nothing that tells its rooms' types but their form, and their furniture where that is kept."""
    names = {room.id: f"r{k}" for k, room in enumerate(home.rooms)}

    def opening(one: Opening) -> Opening:
        return replace(one, connects_to=names.get(one.connects_to or "", one.connects_to))

    def bare(room: Room) -> Room:
        furniture = room.furniture if furnished else ()
        openings = tuple(opening(one) for one in room.openings)
        return replace(
            room,
            id=names[room.id],
            type="room",
            furniture=furniture,
            decorations=(),
            openings=openings,
            flooring=None,
            walls=None,
            accent=None,
            extra={},
        )

    return Scene(wall_thickness=home.wall_thickness, rooms=tuple(bare(room) for room in home.rooms))
