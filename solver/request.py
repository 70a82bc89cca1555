"""What is asked of generate: the request, with its units and defaults."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Annotated, ClassVar, Final

from annotated_types import Ge, Le

from solver.fields import MAX_WHOLE, OMITTED, OUTLINE, STRICT, WHOLE, Flag, GivenCorners, Record, Says, Text, TextByIndex, counted
from solver.scene import ROBOT_WIDTH, RobotWidth

MAX_SEED: Final = MAX_WHOLE
PLAIN_SIZE: Final = (20.0, 15.0)
"""Width and depth of a house where nothing else is asked for, m."""
FITTED: Final = "unless a programme or an area chooses it"
NO_ACCESS: Final = "none"
"""Names no profile of access."""
MAX_COUNT: Final = 12
"""Most rooms of one word, or cars, that a programme may count; our choice, more than any home has."""

Seed = Annotated[int, Ge(0), Le(MAX_SEED), WHOLE]
Extent = Annotated[float, STRICT, Ge(2.0), Le(1000.0)]


@dataclass(frozen=True)
class Request(Record):
    """What to generate; all optional. Unknown keys are refused.

    With `program` (`{bedrooms: 3, bathrooms: 2, garage: 1}`) or `area` a home is planned for them, and `width` and `depth` are chosen to
    fit where they are not given; else `min_room_size`, `max_depth`, `use_spine` and `force_types` say how a rectangle is cut into rooms.
    Each edge between the corners of an `outline` is along x or z. The walker of an `access` must come everywhere, and the certificate
    tells what else of it is met.

    Args:
        use_spine: whether a rectangle that is cut has a hallway.
        outdoor: whether a garden or the like lies around the house.
        decorate: whether surfaces, walls and floors are decorated.
        robot_width: side of the square that must be able to walk everywhere, m.
        area: wished floor of the house, m2.
        style: the name of a style.
        wall_thickness: of inner walls, m; 0.1 by default.
        outer_wall_thickness: of outer walls, m; as inner ones by default.
    """

    camel_case: ClassVar[bool] = True

    seed: Annotated[Seed | None, Says("drawn where there is none")] = None
    width: Annotated[Extent | None, Says(f"m, {PLAIN_SIZE[0]:g} {FITTED}")] = None
    depth: Annotated[Extent | None, Says(f"m, {PLAIN_SIZE[1]:g} {FITTED}")] = None
    min_room_size: Annotated[float, STRICT, Ge(1.5), Le(50.0), Says("m, at most the house's shorter side")] = 3.0
    max_depth: Annotated[int, Ge(0), Le(16), WHOLE, Says("how often the rectangle is split")] = 5
    use_spine: Flag = True
    outdoor: Flag = False
    decorate: Flag = False
    force_types: Annotated[TextByIndex, Says("room types by the room's index")] = field(default_factory=dict)
    robot_width: RobotWidth = ROBOT_WIDTH
    program: Annotated[Mapping[str, int] | str | None, counted(MAX_COUNT), Says("a preset's name, or how many rooms of each word")] = None
    area: Annotated[float, STRICT, Ge(15.0), Le(1000.0)] | None = None
    style: Text | None = None
    outline: Annotated[str | GivenCorners | None, OUTLINE, Says("of a planned home, any by default; or of any home its corners, m")] = None
    access: Annotated[Text | None, Says("a profile of access.yaml, or none")] = None
    people: Annotated[Flag | None, Says("whether people and pets are in it")] = field(default=None, metadata={OMITTED: True})
    wall_thickness: Annotated[float, STRICT, Ge(0.05), Le(0.24)] | None = field(default=None, metadata={OMITTED: True})
    outer_wall_thickness: Annotated[float, STRICT, Ge(0.05), Le(0.6)] | None = field(default=None, metadata={OMITTED: True})

    @property
    def planned(self) -> bool:
        """Tells whether a home is planned for a programme or a wished area, instead of a rectangle cut into rooms."""
        return self.program is not None or self.area is not None

    @property
    def extents(self) -> tuple[float, float]:
        """Width and depth of a plain request's house, m."""
        return PLAIN_SIZE[0] if self.width is None else self.width, PLAIN_SIZE[1] if self.depth is None else self.depth
