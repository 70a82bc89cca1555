"""The types of shapes: how a kind looks, as a few solids within its box, and the materials they are made of.

Coordinates are shares of the unrotated body's box: x from left (0) to right (1), y from its underside (0) to its top (1),
z from its back (0) to its front (1).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any, Final, Literal

from pydantic import AfterValidator, Field, SerializerFunctionWrapHandler, model_serializer, model_validator

from catalogs.entries import Colour, Entry, MaterialName, Share

Form = Literal["box", "rounded", "cylinder", "cone", "ball", "capsule"]
"""A `rounded` is a box with soft edges; a `ball` fills its box as an ellipsoid."""
Axis = Literal["x", "y", "z"]
Texture = Literal["wood", "fabric", "metal", "tile", "concrete", "stone", "grass", "deck", "leather", "plaster", "brick"]
LONG: Final = ("cylinder", "cone", "capsule")
"""Forms that have an axis."""
MOST_PARTS: Final = 16
Ratio = Annotated[float, Field(ge=0, le=10)]


def _ordered(ends: tuple[Any, Any]) -> tuple[Any, Any]:
    if all(isinstance(end, float) for end in ends) and not ends[0] < ends[1]:
        raise ValueError("must be [lower, higher]")
    return ends


def _within(end: float | str) -> float | str:
    if isinstance(end, float) and not 0 <= end <= 1:
        raise ValueError("must lie within 0 and 1")
    return end


Ends = Annotated[tuple[Share, Share], AfterValidator(_ordered)]
End = Annotated[float | str, AfterValidator(_within)]


class ShapePart(Entry):
    """One part of a shape as a file writes it.

    An end of `y` may be the name of one of the kind's surfaces. `axis` is that of a cylinder, cone or capsule; `taper` the
    radius of a cylinder at its axis' far (higher) end by that at its near one, the larger of them filling the box. A cone's
    tip is at the far end. `mirror` adds the part's images in the middle planes of these axes.
    """

    form: Form
    x: Ends = (0.0, 1.0)
    y: Annotated[tuple[End, End], AfterValidator(_ordered)] = (0.0, 1.0)
    z: Ends = (0.0, 1.0)
    axis: Axis = "y"
    taper: Annotated[float, Field(gt=0, le=10)] = 1.0
    material: MaterialName = "body"
    mirror: Literal["x", "z", "xz"] | None = None

    @model_validator(mode="after")
    def _sensible(self) -> ShapePart:
        if self.axis != "y" and self.form not in LONG:
            raise ValueError(f"a {self.form} has no axis")
        if self.taper != 1 and self.form != "cylinder":
            raise ValueError(f"a {self.form} has no taper")
        if self.form == "cone" and self.axis in (self.mirror or ""):
            raise ValueError("a cone is not mirrored along its own axis")
        return self


ShapeParts = Annotated[tuple[ShapePart, ...], Field(min_length=1, max_length=MOST_PARTS)]


class Solid(Entry):
    """One solid of a kind's shape: a part with its surfaces' names turned into numbers, every mirror image written out.

    `taper` is the radius at the axis' far end by that at its near one: 1 but for tapered cylinders and cones (0).
    """

    form: Form
    x: tuple[Share, Share]
    y: tuple[Share, Share]
    z: tuple[Share, Share]
    axis: Axis
    taper: Ratio
    material: str


class Material(Entry):
    """How a slot looks. `color: null` is the body's own colour; `shade` makes it darker (to -1) or lighter (to 1).

    `glow` is light of its own, `opacity` 1 lets nothing through; `texture` is drawn by whoever draws.
    """

    color: Colour | None = None
    shade: Annotated[float, Field(ge=-1, le=1)] = 0.0
    roughness: Share = 0.8
    metalness: Share = 0.0
    opacity: Annotated[float, Field(gt=0, le=1)] = 1.0
    glow: Share = 0.0
    texture: Texture | None = None


class MaterialChange(Material):
    """What a style changes of a material: only what it names."""

    @model_serializer(mode="wrap")
    def _named_only(self, write: SerializerFunctionWrapHandler) -> dict[str, Any]:
        return {key: value for key, value in write(self).items() if key in self.model_fields_set}


def solids(parts: tuple[ShapePart, ...], surfaces: Mapping[str, float]) -> tuple[Solid, ...]:
    """Writes a shape out for a kind.

    Args:
        parts: the shape; every name in it is a surface's, every span lies the right way up.
        surfaces: the kind's surfaces' heights by name, as shares of its own height.
    """
    return tuple(image for part in parts for image in _images(part, heights(part, surfaces)))


def heights(part: ShapePart, surfaces: Mapping[str, float]) -> tuple[float, float]:
    """Returns a part's lower and higher end as shares of its kind's height.

    Raises:
        KeyError: it names a surface that the kind does not have.
    """
    low, high = (surfaces[end] if isinstance(end, str) else end for end in part.y)
    return low, high


def _images(part: ShapePart, y: tuple[float, float]) -> list[Solid]:
    taper = 0.0 if part.form == "cone" else part.taper
    made = [Solid(form=part.form, x=part.x, y=y, z=part.z, axis=part.axis, taper=taper, material=part.material)]
    for axis in part.mirror or "":
        made += [_mirrored(solid, axis) for solid in made]
    return made


def _mirrored(solid: Solid, axis: str) -> Solid:
    low, high = getattr(solid, axis)
    change: dict[str, Any] = {axis: (round(1 - high, 9), round(1 - low, 9))}
    if solid.axis == axis:
        change["taper"] = 1 / solid.taper
    return solid.model_copy(update=change)
