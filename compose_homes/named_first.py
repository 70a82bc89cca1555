"""The public names that cost no catalogs: imported when the first of all is named."""

from compose_homes.files import dump, load
from solver import __getattr__ as flow  # type: ignore[attr-defined]
from solver.answers import Conflict, Fixed, Generated, Issue, Move, Pose
from solver.errors import ComposeError, FieldError, RequestError, SceneError, SyntaxFault
from solver.request import Request
from solver.scene import Decoration, Dynamic, Flooring, Furniture, Level, Opening, Room, Scene, Sides, Size, WallFinish
from solver.version import VERSION as __version__

__all__ = [
    "ComposeError",
    "Conflict",
    "Decoration",
    "Dynamic",
    "FieldError",
    "Fixed",
    "Flooring",
    "Furniture",
    "Generated",
    "Issue",
    "Level",
    "Move",
    "Opening",
    "Pose",
    "Request",
    "RequestError",
    "Room",
    "Scene",
    "SceneError",
    "Sides",
    "Size",
    "SyntaxFault",
    "WallFinish",
    "__version__",
    "dump",
    "flow",
    "load",
]
