"""What things are painted with: the catalogs' material slots with a style's changes, in a body's own colour where they have none."""

from collections.abc import Iterable
from functools import lru_cache
from typing import Final

from catalogs import Catalogs
from catalogs.shapes import Material
from solver.body_parts import BodyPart
from solver.exports.model import Paint

ACCENT_SLOT: Final = "rug_border"
"""The slot that has the accent of the room a body is in: the hem of rugs."""
UNSAID: Final = "#8b949e"
"""The colour of a body that says none."""
PLAIN_WALL: Final = Paint("#e3dfd8", 0.95, texture="plaster")
"""A wall outside, and where a room does not say."""
REVEAL: Final = Paint("#e9e4da", 0.95)
"""The jambs of openings and the tops of walls."""
PLAIN_FLOOR: Final = Paint("#c9c2b6", 0.9)
PLAIN_CEILING: Final = Paint("#f5f3ee", 0.95)
SURFACES: Final = {
    "railing": Paint("#8a7a66"),
    "frame": Paint("#f1ede4"),
    "threshold": Paint("#8a7152"),
    "glass": Paint("#9fd0ee", 0.15, opacity=0.38),
}
"""What is fitted to walls."""
WALL_ROUGHNESS: Final = {"plaster": 0.95, "wallpaper": 0.9, "wood": 0.7, "tile": 0.35, "brick": 0.95, "concrete": 0.9}


def by_paint(parts: Iterable[BodyPart], paints: Iterable[Paint]) -> dict[Paint, tuple[BodyPart, ...]]:
    """Returns parts by their paints, in the order of the first of each."""
    found: dict[Paint, tuple[BodyPart, ...]] = {}
    for part, paint in zip(parts, paints, strict=True):
        found[paint] = (*found.get(paint, ()), part)
    return found


def channels(color: str) -> tuple[int, int, int]:
    """Returns red, green and blue of #rrggbb, 0 to 255; grey where it is no such colour."""
    try:
        value = int(color[1:7], 16)
    except ValueError:
        return 128, 128, 128
    return value >> 16 & 255, value >> 8 & 255, value & 255


def srgb(color: str) -> tuple[float, float, float]:
    """Returns red, green and blue of #rrggbb, 0 to 1, in sRGB."""
    red, green, blue = channels(color)
    return red / 255, green / 255, blue / 255


def linear(color: str) -> tuple[float, float, float]:
    """Returns a colour's linear light, 0 to 1, as glTF and USD want it (IEC 61966-2-1)."""
    red, green, blue = map(_linear, srgb(color))
    return red, green, blue


def _linear(share: float) -> float:
    return round(share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4, 6)


def shade(color: str, share: float) -> str:
    """Returns a colour moved towards white (share > 0) or black (share < 0)."""
    if not share:
        return color
    goal = 255 if share > 0 else 0
    return "#" + "".join(f"{int(channel + (goal - channel) * abs(share) + 0.5):02x}" for channel in channels(color))


_UNKNOWN = Material()


class Paints:
    """The paints of one style; the catalogs' materials as they are where they know no such style."""

    def __init__(self, catalogs: Catalogs, style: str | None) -> None:
        self._slots: dict[str, Material] = dict(catalogs.materials)
        self._mixed = lru_cache(maxsize=1 << 12)(self._mix)
        known = catalogs.styles.get(style or "")
        for slot, change in (known.materials if known else {}).items():
            base = self._slots.get(slot, Material())
            self._slots[slot] = base.model_copy(update={key: getattr(change, key) for key in change.model_fields_set})

    def of(self, slot: str, color: str | None, accent: str | None = None) -> Paint:
        """Returns the paint of a slot on a body of a colour, in a room with an accent; an unknown slot is the body's own colour."""
        own = (accent or color if slot == ACCENT_SLOT else color) or UNSAID
        return self._mixed(slot, own)

    def has(self, slot: str) -> bool:
        """Tells whether the catalogs know a slot."""
        return slot in self._slots

    def _mix(self, slot: str, own: str) -> Paint:
        material = self._slots.get(slot) or _UNKNOWN
        color = shade(material.color or own, material.shade)
        return Paint(color, material.roughness, material.metalness, material.opacity, material.glow, material.texture)


@lru_cache(maxsize=64)
def paints_of(catalogs: Catalogs, style: str | None) -> Paints:
    """Returns the paints of a style, kept from one house to the next."""
    return Paints(catalogs, style)
