"""A furnished room -> what lies on its furniture, hangs on its walls and stands on its floor.

Comes in: a Room, its Space, the catalogs' dressing. Goes out: the Room, decorated. May import: the ground floor, catalogs. Not here: where
furniture stands (placement); nothing here moves it.
"""

from solver.decorations.decorating import decorated_room
from solver.decorations.decoration_settings import DecorationSettings

__all__ = ["DecorationSettings", "decorated_room"]
