"""The ground of the catalogs' types: what an entry is, and the units of its values.

Unknown keys are forbidden, everything is frozen. Lengths in metres, areas in m2, masses in kg, angles in degrees.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field

Side = Literal["front", "back", "left", "right"]
Colour = Annotated[str, Field(pattern=r"^#[0-9a-f]{6}$")]
Length = Annotated[float, Field(gt=0, le=100, allow_inf_nan=False)]
Cost = Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)]


def _words(value: Any) -> Any:
    """Lets a single word stand for a list of one."""
    return (value,) if isinstance(value, str) else value


def _interval(value: Any) -> Any:
    """Lets a single number stand for an interval of one value."""
    return (value, value) if isinstance(value, int | float) and not isinstance(value, bool) else value


Words = Annotated[tuple[str, ...], BeforeValidator(_words, json_schema_input_type=str | tuple[str, ...])]
Gap = Annotated[float, Field(ge=-2, le=20, allow_inf_nan=False)]
Interval = Annotated[tuple[Gap, Gap], BeforeValidator(_interval, json_schema_input_type=Gap | tuple[Gap, Gap])]


class Entry(BaseModel):
    """Base of every catalog entry."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Surface(Entry):
    """A surface that carries things.

    Its height above the piece's underside, how far in from the footprint's edges it starts, and the free height above
    it, m (None: open above).
    """

    name: str
    height: Length
    inset: Annotated[float, Field(ge=0, le=1)] = 0.02
    clearance: Length | None = None
