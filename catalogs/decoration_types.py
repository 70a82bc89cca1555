"""The types of decorations: what kinds there are, and what lies, hangs or stands where."""

from typing import Annotated, Literal

from pydantic import BeforeValidator, Field, model_validator

from catalogs.entries import PIECE_NAMES, Entry, KindSpec, Metres, Probability, RoomTypeNames, Share, Words, as_words
from catalogs.insides import InsideSort
from catalogs.references import Names

SurfacePlace = tuple[Share, Share]
"""Where on a surface: from its left (0) to its right (1) edge, and from its back (0) to its front (1)."""
ReachMetres = Annotated[float, Field(ge=0, le=20)]
Group = Literal[
    "soft_goods", "lighting", "wall_art", "books", "tech", "containers", "drinkware", "decor", "plants", "dining", "kitchen",
    "bedroom", "bathroom", "entry", "kids", "floor", "workshop", "outdoor", "shelves",
]  # fmt: skip
SURFACE = "surface"
"""In `on`: the parent's own surface."""
ALL = "all"
"""In `surface`: every surface of the parent."""
INDOOR = "indoor"
"""The entry whose rows are for every indoor room."""


class DecorationKind(KindSpec):
    """One kind of decoration. `jitter`: it lies up to 15 degrees askew. `mixed`: of several each has its own colour.

    Its `surfaces` carry other decorations. Its `size` is meant as it lies.
    """

    group: Group
    mass: Annotated[float, Field(gt=0, le=500)]
    jitter: bool = False
    mixed: bool = False


class DecoratingRow(Entry):
    """What every row says: which kinds (several take turns), how often, in which styles, how small they get.

    `styled`: only in homes that have a style, or (false) only in those that have none.

    `rooms` and `not_in`: only in rooms of these types, and in none of those.

    `min_scale`: where a thing does not fit it is made smaller, down to this share of its width and depth. `accent`: it has the
    room's accent colour, or one that the style has for it. `chance` is drawn once for the row on each parent.
    """

    put: Annotated[Words, Names("decoration", "a key of decorations.yaml")] = Field(min_length=1)
    chance: Probability = 1.0
    styles: Annotated[Words, Names("style", "a key of styles.yaml")] = ()
    styled: bool | None = None
    rooms: RoomTypeNames = ()
    not_in: RoomTypeNames = ()
    min_scale: Probability = 1.0
    accent: bool = False


class Lies(DecoratingRow):
    """Something on a surface of its parent.

    `at` are its places, or `seats`: one before every chair that stands at the table. `surface` names the parent's surfaces
    (its highest by default, or `all`). `on`: it lies on decorations of these kinds that are already on the parent, on each of
    the first kind that is there; `surface` among them means the parent itself. `turn` is its rotation against what
    carries it, degrees; `upright` tips it onto its lower edge. `fill`: its width and depth as shares of the surface's (0: its own).
    Where its place is taken it goes to the nearest free one, at most `reach` m away.
    """

    at: tuple[SurfacePlace, ...] | Literal["seats"] = ((0.5, 0.5),)
    surface: Words = ()
    on: Words = ()
    turn: Literal[0, 90, 180, 270] = 0
    upright: bool = False
    fill: tuple[Share, Share] | None = None
    reach: ReachMetres | None = None


class Holds(Lies):
    """Something inside a piece, behind its doors or in its drawers; at most `most` of it in one piece.

    `surface` says whether it lies on the `shelves` inside or in the `drawers`; which of them come first is drawn. Nothing in a drawer
    stands out above its sides.
    """

    at: tuple[SurfacePlace, ...] = ((0.5, 0.5),)
    surface: Annotated[tuple[InsideSort, ...], BeforeValidator(as_words), Field(min_length=1)]
    on: tuple[()] = ()
    most: Annotated[int, Field(ge=1, le=8)] = 2


class Hangs(DecoratingRow):
    """Something on the wall behind its parent, or on the longest free wall of a room.

    `height` is its underside above the floor, m; over a parent it hangs at least `gap` above that one's top. `at` are places
    along the parent, left (0) to right (1); where one is taken it hangs as near as it can, its middle over the parent.
    """

    at: Annotated[tuple[Share, ...], Field(min_length=1)] = (0.5,)
    height: Metres
    gap: Annotated[float, Field(ge=0, le=2)] = 0.1


class Stands(DecoratingRow):
    """Something on a room's floor, `count` of it, one for every `per_area` m2 if that is given.

    `where`: in the `middle`, in a `corner`, `beside` a piece named by `of` (the first names first; else at a wall), at a
    `wall`, or anywhere `free`; at most `reach` m from there. Or `under` the piece that `of` names first, and so far as it
    `reach`es beyond that on every side where there is floor, to 0.1 m from walls; of that piece it leaves the share `bare` so, from
    its back on, and what is beside that: a rug begins before a bed's nightstands. `fill`: its extents are this share of the room's, the
    lesser one at most `widest` m; where the greater one is over `longest` m, as few alike as are no longer lie one behind another.
    A room whose lesser side is under `min_side` m goes without.
    """

    where: Literal["middle", "corner", "beside", "wall", "free", "under"]
    of: Annotated[Words, PIECE_NAMES] = ()
    count: Annotated[int, Field(ge=1, le=12)] = 1
    per_area: Annotated[float, Field(gt=0)] | None = None
    min_side: Annotated[float, Field(ge=0)] = 0.0
    fill: Probability | None = None
    widest: Metres | None = None
    longest: Annotated[float, Field(ge=1, le=100)] | None = None
    bare: Share = 0.0
    reach: ReachMetres = 0.8

    @model_validator(mode="after")
    def _complete(self) -> "Stands":
        if (self.where in ("beside", "under")) != bool(self.of):
            raise ValueError("`of` goes with `where: beside` or `under`, and they with it")
        if self.bare and self.where != "under":
            raise ValueError("`bare` goes with `where: under`")
        if self.fill is None and (self.widest, self.longest) != (None, None):
            raise ValueError("`widest` and `longest` go with `fill`")
        return self


class Decorating(Entry):
    """What decorates a kind of furniture or decoration (`lies`, `hangs`) or a room type (`stands`, `hangs`), in this order.

    What furniture `holds` comes last of all in a room.
    `together`: the room's pieces of that name share the rows, so that a run of counters has one coffee maker.
    `indoor: false`: a room type that goes without the rows for every indoor room.
    """

    lies: tuple[Lies, ...] = ()
    hangs: tuple[Hangs, ...] = ()
    stands: tuple[Stands, ...] = ()
    holds: tuple[Holds, ...] = ()
    together: bool = False
    indoor: bool = True
