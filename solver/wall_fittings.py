"""What is fitted to openings in walls, for the exports and the rules alike: frames, sill boards, panes, door leaves."""

from collections import Counter
from collections.abc import Iterable, Iterator
from heapq import heappop, heappush
from itertools import pairwise
from typing import Final, Literal, NamedTuple

FRAME: Final = 0.06
"""How wide a frame's bars are, m: a leaf that stands open, with its handle, is then no wider than its opening (door_leaves)."""
FRAME_PROUD: Final = 0.01
GLASS_THICKNESS: Final = 0.012
SILL_BOARD: Final = 0.03
_SILL_PROUD: Final = 0.03
_SILL_WIDER: Final = 0.02
THRESHOLD: Final = 0.008
"""How high the board is that lies under a leaf, where two floors meet, m."""
GROUND_GAP: Final = THRESHOLD + 0.002
"""How far above the floor a leaf hangs, m."""
LEAF_THICKNESS: Final = 0.04
HANDLE_HEIGHT: Final = 1.0
HANDLE_PROUD: Final = 0.04
"""How far a handle stands out of its leaf: with half a leaf no more than a frame, so that it keeps to the door's square."""
HANDLE_FROM_EDGE: Final = 0.06
"""Where a handle turns, from the edge of its leaf, m."""
LEVER: Final = (0.13, 0.022)
"""How long and high a lever is, m."""
WIDEST_LEAF: Final = 1.25
"""The widest opening of a door, m, that has one leaf; a wider one has two, which meet in its middle."""
LEVER_INWARDS: Final = 0.055
"""How far a lever's middle is from where it turns, towards the hinge, m."""
Span = tuple[float, float]


class Bar(NamedTuple):
    """A box in or at a wall: along the wall, up from the floor, and across from the wall's middle line."""

    along: Span
    up: Span
    across: Span
    surface: Literal["frame", "glass"] = "frame"


def window_bars(along: Span, up: Span, thickness: float) -> list[Bar]:
    """Returns a window's sill board, which stands out at both faces, its frame, and its pane."""
    (start, end), (sill, head) = along, up
    frame, middle = around(0.0, min(thickness, 0.06)), (start + end) / 2
    wide, high = frame_of(end - start), frame_of(head - sill)
    foot = sill + min(SILL_BOARD, high)
    mullion = [Bar(around(middle, wide), up, frame)] if end - start > 0.9 else []
    return [
        Bar((start - _SILL_WIDER, end + _SILL_WIDER), (sill, foot), around(0.0, thickness + 2 * _SILL_PROUD)),
        Bar((start, start + wide), up, frame),
        Bar((end - wide, end), up, frame),
        Bar(along, (head - high, head), frame),
        *mullion,
        Bar(along, (foot, head - high), around(0.0, GLASS_THICKNESS), "glass"),
    ]


def door_bars(along: Span, head: float, thickness: float) -> list[Bar]:
    """Returns a door's frame."""
    (start, end), across = within_frame(along), around(0.0, thickness + 2 * FRAME_PROUD)
    return [
        Bar((along[0], start), (0.0, head), across),
        Bar((end, along[1]), (0.0, head), across),
        Bar(along, (head, head + FRAME), across),
    ]


def leaf_bars(along: Span, head: float, middle: float, hinge: str | None) -> list[Bar]:
    """Returns what shuts an opening: a slab a leaf, and the levers on both sides.

    Args:
        along: the opening's ends.
        head: how high it is.
        middle: how far the slab's middle is from the wall's.
        hinge: `end` for a leaf that hangs there; nothing has levers that does not turn: None.
    """
    up, thick = (GROUND_GAP, head), around(middle, LEAF_THICKNESS)
    if hinge is None:
        return [Bar(within_frame(along), up, thick)]
    inwards = HANDLE_FROM_EDGE + LEVER_INWARDS
    high = around(GROUND_GAP + min(HANDLE_HEIGHT, (head - GROUND_GAP) * 0.8), LEVER[1])
    found = []
    for (start, end), hung in leaf_spans(along, hinge):
        lever = around(start + inwards if hung == "end" else end - inwards, LEVER[0])
        found += [Bar((start, end), up, thick), Bar(lever, high, around(middle, LEAF_THICKNESS + 2 * HANDLE_PROUD))]
    return found


def leaf_spans(along: Span, hinge: str) -> list[tuple[Span, str]]:
    """Returns where the leaves of a door that turns reach between its jambs, each with the end it hangs at; the one at `hinge` first."""
    start, end = within_frame(along)
    if along[1] - along[0] <= WIDEST_LEAF + 1e-9:
        return [((start, end), hinge)]
    middle = (start + end) / 2
    return sorted([((start, middle), "start"), ((middle, end), "end")], key=lambda leaf: leaf[1] != hinge)


def frame_of(extent: float) -> float:
    """Returns how wide the bars of a frame are, m, in an opening that is so wide or high: in a small one a quarter of that."""
    return min(FRAME, extent / 4)


def within_frame(along: Span) -> Span:
    """Returns what an opening's frame leaves of it along its wall."""
    bar = frame_of(along[1] - along[0])
    return along[0] + bar, along[1] - bar


def leaf_offset(thickness: float) -> float:
    """Returns how far the middle of a leaf that turns is from its wall's, m: it is flush with the face that it turns to."""
    return max(0.0, (thickness - LEAF_THICKNESS) / 2)


def around(centre: float, thickness: float) -> Span:
    """Returns an interval of that length around a middle."""
    return centre - thickness / 2, centre + thickness / 2


def cut_at_holes(ends: Span, holes: Iterable[tuple[Span, Span]], seams: Iterable[float] = ()) -> Iterator[tuple[Span, list[Span]]]:
    """Yields the stretches of a wall between the sides of holes, each with the heights that holes over it take, in order.

    Holes say where they begin and end along the wall, and from which height to which, m; it is cut at `seams` besides.
    """
    start, end = ends
    opening = sorted(holes, key=lambda hole: hole[0][0], reverse=True)
    stops = sorted({start, end, *seams, *(at for along, _ in opening for at in along if start < at < end)})
    closing: list[tuple[float, Span]] = []
    taken = Counter[Span]()
    for low, high in pairwise(stops):
        while opening and opening[-1][0][0] <= low:
            (_, until), up = opening.pop()
            heappush(closing, (until, up))
            taken[up] += 1
        while closing and closing[0][0] <= low:
            up = heappop(closing)[1]
            taken[up] -= 1
            if not taken[up]:
                del taken[up]
        yield (low, high), sorted(taken)
