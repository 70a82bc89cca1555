"""The types of shapes: how a kind looks, as a few solids within its box, and the materials they are made of.

Coordinates are shares of the unrotated body's box: x from left (0) to right (1), y from its underside (0) to its top (1),
z from its back (0) to its front (1).
"""

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
"""So many a file may write for one shape."""
MOST_SOLIDS: Final = 48
"""So many a shape may be, mirror images, boards of hollow parts and drawers' trays written out."""
Opens = Literal["left", "right", "up", "down", "lid", "drawer"]
"""How a front opens: it turns about its left, right, upper or lower edge, as a lid about its back edge, or slides out."""
QUARTER: Final = 90.0
"""How far a front turns unless it says otherwise, degrees."""
DRAWN: Final = 0.8
"""How much of its tray's depth a drawer comes out unless it says otherwise."""
Ratio = Annotated[float, Field(ge=0, le=10)]
FrontName = Annotated[str, Field(pattern="^[a-z][a-z_]*$", description="small letters and _")]
"""What a part that opens is called."""


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


class Hollow(Entry):
    """A box that is boards with free room between them, open to its front or its top.

    `boards` are the heights of the tops of boards inside, `uprights` the middles of upright ones from left to right: shares of the
    kind's box, as all coordinates are.
    """

    open: Literal["front", "top"] = "front"
    boards: tuple[Share, ...] = ()
    uprights: tuple[Share, ...] = ()


class ShapePart(Entry):
    """One part of a shape as a file writes it.

    An end of `y` may be the name of one of the kind's surfaces. `axis` is that of a cylinder, cone or capsule; `taper` the
    radius of a cylinder at its axis' far (higher) end by that at its near one, the larger of them filling the box. A cone's
    tip is at the far end. `mirror` adds the part's images in the middle planes of these axes.

    A part that `opens` is a front and has a `name`; parts `with` that name move with it. `range` is how far: degrees, of a drawer the
    share of its tray's depth. The second image of a front called `door` is `door_2`, and opens the other way. Where one that
    `must_open` is blocked, that is an error.
    """

    form: Form
    x: Ends = (0.0, 1.0)
    y: Annotated[tuple[End, End], AfterValidator(_ordered)] = (0.0, 1.0)
    z: Ends = (0.0, 1.0)
    axis: Axis = "y"
    taper: Annotated[float, Field(gt=0, le=10)] = 1.0
    material: MaterialName = "body"
    mirror: Literal["x", "z", "xz"] | None = None
    hollow: Hollow | None = None
    name: FrontName | None = None
    opens: Opens | None = None
    range: Annotated[float, Field(gt=0, le=180)] | None = None
    must_open: bool = False
    moves_with: FrontName | None = Field(default=None, alias="with")

    @model_validator(mode="after")
    def _opens_sensibly(self) -> "ShapePart":
        if (self.name is None) != (self.opens is None):
            raise ValueError("a part that `opens` has a `name` too, and a part that does not has none")
        if self.must_open and not self.opens:
            raise ValueError("must_open is of what opens")
        if self.range is not None and (self.opens is None or (self.opens == "drawer" and self.range > 1)):
            raise ValueError("range is of what opens: degrees, of a drawer at most 1")
        if self.opens and (self.hollow or self.moves_with or "z" in (self.mirror or "")):
            raise ValueError("what opens is not hollow, moves with nothing else and is not mirrored from front to back")
        if self.hollow and self.form != "box":
            raise ValueError("only a box is hollow")
        return self

    @model_validator(mode="after")
    def _sensible(self) -> "ShapePart":
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

    `taper` is the radius at the axis' far end by that at its near one: 1 but for tapered cylinders and cones (0). `front` names the
    front it moves with; the panel of one `opens`, by `range`: degrees, of a drawer the share of the body's depth. `board` numbers the
    hollow part that it is a board of, or a tray in.
    """

    form: Form
    x: tuple[Share, Share]
    y: tuple[Share, Share]
    z: tuple[Share, Share]
    axis: Axis
    taper: Ratio
    material: str
    front: str | None = None
    opens: Opens | None = None
    range: Annotated[float, Field(ge=0, le=180)] = 0.0
    must_open: bool = False
    board: int | None = None


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


def heights(part: ShapePart, surfaces: Mapping[str, float]) -> tuple[float, float]:
    """Returns a part's lower and higher end as shares of its kind's height.

    Raises:
        KeyError: it names a surface that the kind does not have.
    """
    low, high = (surfaces[end] if isinstance(end, str) else end for end in part.y)
    return low, high


def images(part: ShapePart, y: tuple[float, float]) -> list[Solid]:
    """Returns a part and its mirror images, each as one solid; `y` are its ends in height."""
    alike = {key: getattr(part, key) for key in ("form", "x", "z", "axis", "material", "opens", "must_open")}
    made = [Solid(**alike, y=y, taper=0.0 if part.form == "cone" else part.taper)]
    for axis in part.mirror or "":
        made += [_mirrored(solid, axis) for solid in made]
    return made


def _mirrored(solid: Solid, axis: str) -> Solid:
    low, high = getattr(solid, axis)
    change: dict[str, Any] = {axis: (round(1 - high, 9), round(1 - low, 9))}
    if solid.axis == axis:
        change["taper"] = 1 / solid.taper
    if axis == "x" and solid.opens in ("left", "right"):
        change["opens"] = "right" if solid.opens == "left" else "left"
    return solid.model_copy(update=change)
