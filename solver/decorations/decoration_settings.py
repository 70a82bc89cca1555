"""What the rooms of a house are decorated with.

Comes in: catalogs, a style. Goes out: `DecorationSettings`. May import: the ground floor, catalogs.
"""

from __future__ import annotations

from dataclasses import dataclass

from catalogs import Catalogs
from catalogs.styles import Style


@dataclass(frozen=True)
class DecorationSettings:
    """What all rooms of a house are decorated with, in which style, and m from floor to ceiling."""

    catalogs: Catalogs
    style: Style | None = None
    style_name: str = ""
    height: float = 2.8
