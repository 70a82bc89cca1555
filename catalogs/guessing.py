"""What tells the type of a plan's room by its form, and how much: a cost each, lower is likelier; below nought it speaks for the type."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from catalogs.entries import ROOM_TYPE, Entry

Weight = Annotated[float, Field(strict=True, ge=-100, le=100, allow_inf_nan=False)]
OfType = dict[Annotated[str, ROOM_TYPE], Weight]
Mark = Literal[
    "typical", "beyond", "width", "long", "no_window", "small_windows", "wet_large", "wet_small", "way_windows", "windows",
    "front", "entrance", "side_door", "side_entrance", "no_garage_door", "no_front", "hall_width", "short_hall", "dead_end",
    "hall_ways", "shut_off", "ways", "outside", "open", "strange_opening", "leaf", "behind", "past", "off_hall", "through", "joined",
    "missing", "usual", "again", "first", "no_first", "later_alone", "miscounted", "beside_pieces",
]  # fmt: skip


class Evidence(Entry):
    """One mark of a room, a door between two, or a home: its `cost`, times what is measured.

    `types` is what the mark has for a type alone, `pairs` what it costs between two. What each mark measures is said in guessing.yaml.
    """

    cost: Weight = 0.0
    types: OfType = Field(default_factory=dict)
    pairs: dict[Annotated[str, ROOM_TYPE], OfType] = Field(default_factory=dict)
