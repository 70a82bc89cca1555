"""What the rooms of a house are decorated with."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from catalogs import Catalogs
from catalogs.styles import Style
from solver.geometry import Rect


@dataclass(frozen=True)
class DecorationSettings:
    """What the rooms of a storey are decorated with, in which style, m from floor to ceiling, and by room what is `kept` free.

    That is floor on which nothing is to come to stand, beside that at the sides of furniture, mm in the room.
    """

    catalogs: Catalogs
    style: Style | None = None
    style_name: str = ""
    height: float = 2.8
    kept: Mapping[str, Sequence[Rect]] = field(default_factory=dict)
