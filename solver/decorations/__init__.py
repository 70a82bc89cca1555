"""A furnished room -> what lies on its furniture, hangs on its walls and stands on its floor.

Comes in: Rooms, their Spaces, the catalogs. Goes out: the Rooms, decorated. May import: the ground floor, catalogs. Not here:
where furniture stands (placement); nothing here moves it.
"""

from solver.decorations.decorating import BareRoom, DecorationSettings, decorated_rooms

__all__ = ["BareRoom", "DecorationSettings", "decorated_rooms"]
