"""The solids with which a body touches others in a simulator, and how its mass is spread over them.

Here z is up, as simulators have it: a point (x, y, z) of the scene is (x, -z, y), extents (w, h, d) are (w, d, h), turns keep their value.
"""

import math
from collections.abc import Collection, Iterator, Sequence
from functools import lru_cache
from typing import Final, Literal, NamedTuple

from catalogs.shapes import Axis
from solver.body_parts import BodyPart, is_round
from solver.exports.model import Cuboid, DoorLeaf, FloorPlate, HouseModel, ModelBody, Paint, WallBox
from solver.geometry import rectangles_of

CLEARANCE: Final = 0.002
"""How far a leaf's collider stays off its frame at either end, m."""
FLOOR: Final = 0.05
"""How thick floors are, m; their tops are where the rooms' floors are."""
AXES: Final[dict[Axis, Axis]] = {"x": "x", "y": "z", "z": "y"}
"""What the scene's axes are called where z is up; the scene's z points to -y."""
RPY: Final[dict[Axis, str]] = {"x": "0 1.57079633 0", "y": "1.57079633 0 0", "z": "0 0 0"}
"""Roll, pitch and yaw, radians, by which a form along z comes to lie along an axis, its far end where the scene's axis points."""
EQUAL: Final = 1e-4
"""Diameters that differ by less are one, m."""
Touch = Literal["box", "cylinder", "capsule", "ellipsoid"]
Triple = tuple[float, float, float]


class Collider(NamedTuple):
    """A solid in its body's frame: its extents and its middle, m, z up. `axis` is a cylinder's or capsule's."""

    form: Touch
    size: Triple
    at: Triple
    axis: Axis = "z"

    @property
    def across(self) -> tuple[float, float]:
        """Its extents across its axis, m."""
        one, other = (extent for name, extent in zip("xyz", self.size, strict=True) if name != self.axis)
        return one, other

    @property
    def circular(self) -> bool:
        """Whether those are one."""
        return abs(self.across[0] - self.across[1]) < EQUAL

    @property
    def round_size(self) -> tuple[float, float]:
        """The radius of a cylinder or capsule, and its length from end to end, m."""
        return sum(self.across) / 4, self.size["xyz".index(self.axis)]

    @property
    def volume(self) -> float:
        """Its volume, m3."""
        if self.form == "box":
            return math.prod(self.size)
        if self.form == "ellipsoid":
            return math.prod(self.size) * math.pi / 6
        radius, length = self.round_size
        if self.form == "cylinder":
            return math.pi * radius**2 * length
        return math.pi * radius**2 * (length - 2 * radius) + 4 / 3 * math.pi * radius**3


class Inertia(NamedTuple):
    """A body's centre, m, and its moments about that, kg m2: xx, yy, zz and the products xy, xz, yz; z up."""

    middle: Triple
    moments: Triple
    products: Triple

    @property
    def named(self) -> dict[str, float]:
        """The moments and products by the names that simulators give them."""
        return dict(zip(("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), (*self.moments, *self.products), strict=True))


def z_up(x: float, y: float, z: float) -> Triple:
    """Returns a point of the scene's frame where z is up."""
    return x, 0.0 - z, y


def is_one_box(body: ModelBody, carries: Collection[str]) -> bool:
    """Tells whether a body collides as its whole box: a decoration that carries nothing; `carries` are the ids of all that do.

    Furniture, people, and what carries other things collide with their parts, as things lie in shelves and between armrests.
    """
    return body.sort == "decoration" and body.id not in carries


def colliders_of(body: ModelBody, carries: Collection[str]) -> tuple[Collider, ...]:
    """Returns what a body collides with; `carries` are the ids of all that carry something."""
    if is_one_box(body, carries):
        return (Collider("box", (body.width, body.depth, body.height), (0.0, 0.0, body.height / 2)),)
    return _solids(body.parts)


@lru_cache(maxsize=1 << 12)
def _solids(parts: tuple[BodyPart, ...]) -> tuple[Collider, ...]:
    return tuple(map(collider_of, parts))


def carriers(bodies: Sequence[ModelBody]) -> set[str]:
    """Returns the ids of all that carry something."""
    return {body.parent for body in bodies if body.parent}


def box_between(box: Cuboid) -> Collider:
    """Returns an axis-aligned box of the house, z up."""
    (w, h, d), middle = box.size, box.middle
    return Collider("box", (w, d, h), z_up(*middle))


def leaf_colliders(leaf: DoorLeaf) -> tuple[Collider, ...]:
    """Returns a slab a little narrower than its frame, and the handles that stand out of it; the hinge at the origin, the width along x."""
    half = leaf.width / 2
    slab = Collider("box", (leaf.width - 2 * CLEARANCE, leaf.thickness, leaf.height), (half, 0.0, leaf.height / 2))
    proud = [part for part in parts_of_hung_leaf(leaf) if part.at[2] and abs(part.at[2]) + part.size[2] / 2 > leaf.thickness / 2 + 1e-6]
    return slab, *map(collider_of, proud)


def parts_of_hung_leaf(leaf: DoorLeaf) -> tuple[BodyPart, ...]:
    """Returns a leaf's parts with its hinge at the origin, in the scene's frame."""
    return tuple(part._replace(at=(part.at[0] + leaf.width / 2, *part.at[1:])) for part in leaf.parts)


def wall_solids(model: HouseModel) -> Iterator[tuple[Collider, Paint | None]]:
    """Yields what walls and what is fitted to them are touched as (None), and what they are seen as, in its paint."""
    for wall in model.walls:
        yield box_between(wall.box), None
        yield from _painted_halves(wall)
    for fitting in model.fittings:
        box = box_between(fitting.box)
        if fitting.surface != "threshold":
            yield box, None
        yield box, fitting.paint


def shell_solids(model: HouseModel) -> Iterator[tuple[Collider, Paint | None]]:
    """Yields walls, what is fitted to them, and floors, as `wall_solids` does."""
    yield from wall_solids(model)
    for floor in model.rooms:
        for box in floor_boxes(floor):
            yield from ((box, None), (box, floor.paint))


def _painted_halves(wall: WallBox) -> Iterator[tuple[Collider, Paint]]:
    """Yields a wall's two halves, each in the paint of the room it faces."""
    box, middle = wall.box, wall.box.middle
    if wall.axis == "x":
        halves = box._replace(z1=middle[2]), box._replace(z0=middle[2])
    else:
        halves = box._replace(x1=middle[0]), box._replace(x0=middle[0])
    yield from ((box_between(half), paint) for half, paint in zip(halves, (wall.lesser, wall.greater), strict=True))


def floor_boxes(floor: FloorPlate) -> Iterator[Collider]:
    """Yields the boxes that make a room's floor, z up."""
    for west, north, east, south in rectangles_of(floor.corners):
        yield box_between(Cuboid(west, floor.elevation - FLOOR, north, east, floor.elevation, south))


def shared_mass(colliders: Sequence[Collider], mass: float) -> list[tuple[Collider, float]]:
    """Returns each solid of a body with its share of the mass, kg, by volume."""
    shares = shares_of(tuple(colliders))
    return [(solid, mass * volume / whole) for solid, (volume, whole) in zip(colliders, shares, strict=True)]


@lru_cache(maxsize=1 << 12)
def shares_of(colliders: tuple[Collider, ...]) -> tuple[tuple[float, float], ...]:
    """Returns each solid's volume, m3, with that of all together."""
    volumes = [solid.volume for solid in colliders]
    whole = sum(volumes)
    return tuple((volume, whole) for volume in volumes)


def collider_of(part: BodyPart) -> Collider:
    """Returns what a part collides as."""
    box = box_around(part)
    if part.form == "ball":
        return box._replace(form="ellipsoid")
    if is_round(part.form, part.axis, part.size):
        return box._replace(form="capsule" if part.form == "capsule" and box.round_size[1] > max(box.across) else "cylinder")
    return box


def box_around(part: BodyPart) -> Collider:
    """Returns the box around a part, with the part's axis."""
    width, height, depth = part.size
    return Collider("box", (width, depth, height), z_up(*part.at), AXES[part.axis])


def inertia_of(colliders: Sequence[Collider], mass: float) -> Inertia:
    """Returns the inertia of a body of one density: at least one solid, `mass` kg together."""
    shares = [share for _, share in shared_mass(colliders, mass)]
    middle = _weighted(colliders, shares, mass)
    moments, products = [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]
    for solid, share in zip(colliders, shares, strict=True):
        own = _moments(solid)
        off = [at - centre for at, centre in zip(solid.at, middle, strict=True)]
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            moments[i] += share * (own[i] + off[j] ** 2 + off[k] ** 2)
        for i, (j, k) in enumerate(((0, 1), (0, 2), (1, 2))):
            products[i] -= share * off[j] * off[k]
    return Inertia(middle, (moments[0], moments[1], moments[2]), (products[0], products[1], products[2]))


def _weighted(colliders: Sequence[Collider], shares: Sequence[float], mass: float) -> Triple:
    x, y, z = (sum(share * solid.at[i] for solid, share in zip(colliders, shares, strict=True)) / mass for i in range(3))
    return x, y, z


def _moments(solid: Collider) -> Triple:
    """Returns the moments of inertia of a solid of 1 kg about its own middle, m2."""
    x, y, z = (extent**2 for extent in solid.size)
    if solid.form == "box":
        return (y + z) / 12, (x + z) / 12, (x + y) / 12
    if solid.form == "ellipsoid":
        return (y + z) / 20, (x + z) / 20, (x + y) / 20
    radius, length = solid.round_size
    around, across = radius**2 / 2, radius**2 / 4 + length**2 / 12
    return (around if solid.axis == "x" else across, around if solid.axis == "y" else across, around if solid.axis == "z" else across)
