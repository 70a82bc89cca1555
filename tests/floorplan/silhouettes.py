"""What a house looks like from above: its outline as corners, and what a person would call it. Shares no code with the stage."""

from __future__ import annotations

from collections.abc import Sequence

Box = tuple[int, int, int, int]


def cells(boxes: Sequence[Box]) -> tuple[list[int], list[int], set[tuple[int, int]]]:
    """Lines along x and z, and which cells between them are covered."""
    xs = sorted({x for box in boxes for x in (box[0], box[2])})
    zs = sorted({z for box in boxes for z in (box[1], box[3])})
    filled = {(i, j) for w, n, e, s in boxes for i in range(xs.index(w), xs.index(e)) for j in range(zs.index(n), zs.index(s))}
    return xs, zs, filled


def corners(boxes: Sequence[Box]) -> list[tuple[int, int, bool]]:
    """Corners of the outline, clockwise from the north-west: x, z and whether the corner points inwards.

    Raises:
        ValueError: the house is in several parts, or has a hole.
    """
    xs, zs, filled = cells(boxes)
    steps: dict[tuple[int, int], list[tuple[int, int]]] = {}
    for i, j in filled:
        for side, start, end in (
            ((0, -1), (i, j), (i + 1, j)),
            ((1, 0), (i + 1, j), (i + 1, j + 1)),
            ((0, 1), (i + 1, j + 1), (i, j + 1)),
            ((-1, 0), (i, j + 1), (i, j)),
        ):
            if (i + side[0], j + side[1]) not in filled:
                steps.setdefault(start, []).append(end)
    if any(len(ends) > 1 for ends in steps.values()):
        raise ValueError("parts that meet at a corner alone")
    path = [min(steps)]
    while (following := steps[path[-1]][0]) != path[0]:
        path.append(following)
    if len(path) != len(steps):
        raise ValueError("several parts, or a hole")
    found = []
    for before, here, after in zip([path[-1], *path[:-1]], path, [*path[1:], path[0]], strict=True):
        turn = (here[0] - before[0]) * (after[1] - here[1]) - (here[1] - before[1]) * (after[0] - here[0])
        if turn:
            found.append((xs[here[0]], zs[here[1]], turn < 0))
    return found


def name(boxes: Sequence[Box]) -> str:
    """What a person calls the outline: a rectangle, L, T, U (with a court of three sides), or something else."""
    inwards = "".join("r" if reflex else "c" for _, _, reflex in corners(boxes))
    around = inwards + inwards
    if "r" not in inwards:
        return "rectangle"
    if inwards.count("r") == 1:
        return "L"
    if "rr" in around:
        return "U"
    return "T" if len(inwards) == 8 and "rccr" in around else "other"


def least_jog(boxes: Sequence[Box]) -> int:
    """The shortest line of the outline, mm."""
    found = corners(boxes)
    return min(abs(x - u) + abs(z - v) for (x, z, _), (u, v, _) in zip(found, [*found[1:], found[0]], strict=True))
