"""The types of decorations: what kinds there are, and what lies where."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from catalogs.entries import Colour, Entry, Length, Surface


class DecorationKind(Entry):
    """One kind of decoration. `jitter`: it lies up to 15 degrees askew. Its `surfaces` carry other decorations."""

    group: str
    size: tuple[Length, Length, Length]
    color: Colour
    variants: tuple[Colour, ...] = ()
    mass: Annotated[float, Field(gt=0, le=500)]
    jitter: bool = False
    surfaces: tuple[Surface, ...] = ()


class Dressing(Entry):
    """What lies on one kind of furniture, hangs over it, or lies on the floor of a room type."""
