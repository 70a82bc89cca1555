"""The type of a style: palettes, floor and wall materials, and the decorations it is fond of."""

from typing import Annotated, Literal

from pydantic import Field

from catalogs.entries import Colour, Entry, FlooringName, MaterialName, Words
from catalogs.references import Names
from catalogs.shapes import MaterialChange

Finish = Literal["plaster", "wallpaper", "wood", "brick", "concrete", "tile"]
"""What a wall is finished with."""


Decorations = Annotated[Words, Names("decoration or group", "a kind or group of decorations.yaml")]
PAINTED = Names("kind or category", "a kind or category of furniture.yaml, a kind or group of decorations.yaml")


class FloorFinish(Entry):
    """A floor as a style lays it: its colour, and another material of floorings.yaml where it takes one."""

    type: FlooringName | None = None
    color: Colour


class WallPaint(Entry):
    """The finish of a room's walls and its colour."""

    type: Finish
    color: Colour


class Leaning(Entry):
    """Decorations a style likes to see and those it does without: their kinds or groups."""

    favoured: Decorations = ()
    avoided: Decorations = ()


class Style(Entry):
    """One style of a home. It changes colours, materials and decorations, never where furniture stands.

    `palette` gives colours by kind or name of furniture or decoration, else by category or group; an empty list keeps what
    the kind says itself. `floors` and `walls`, of indoor rooms, go by the flooring that the room's type has in its own file: one
    of the entries is taken for a house's floors, one for each room's walls; what is not named stays as it is. `materials`
    changes what parts of shapes are made of, by slot.
    """

    palette: dict[Annotated[str, PAINTED], tuple[Colour, ...]]
    floors: dict[FlooringName, Annotated[tuple[FloorFinish, ...], Field(min_length=1)]] = Field(default_factory=dict)
    walls: dict[FlooringName, Annotated[tuple[WallPaint, ...], Field(min_length=1)]] = Field(default_factory=dict)
    decorations: Leaning = Leaning()
    materials: dict[MaterialName, MaterialChange] = Field(default_factory=dict)

    def colours(self, *names: str) -> tuple[Colour, ...]:
        """Returns the palette of the first of some names that has one, such as kind, name and category; else none."""
        palette = self.palette
        for name in names:
            if name in palette:
                return palette[name]
        return ()
