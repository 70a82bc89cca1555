"""Whether what a reader found in a format's files is what the description says."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from solver.exports import HouseModel
from tests.exports.readers import Seen


def differences(model: HouseModel, seen: Mapping[str, Seen]) -> Iterator[str]:
    """What is missing or invented, off by 1 mm, turned by 0.1 degree, of another size or mass."""
    bodies = {body.id: body for body in model.bodies}
    yield from (f"{one!r:.60} is in only one" for one in bodies.keys() ^ seen.keys())
    for name in bodies.keys() & seen.keys():
        body, found = bodies[name], seen[name]
        lengths = (body.x, body.y, body.z, body.width, body.depth, body.height)
        apart = [abs(a - b) for a, b in zip(lengths, (*found[:3], *found[4:7]), strict=True)]
        turned = abs((body.turn - found.turn + 180) % 360 - 180)
        if max(apart) > 1e-3 or turned > 0.1:
            yield f"{name!r:.60}: {lengths} {body.turn} is {found}"
        if found.mass is not None and abs(found.mass - body.mass) > 1e-3 * body.mass:
            yield f"{name!r:.60}: {body.mass} kg is {found.mass}"
