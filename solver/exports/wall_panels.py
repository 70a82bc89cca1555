"""Walls as panels with holes, as solid boxes round those holes, and what is fitted to them: frames, sills, panes, railings."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Final, Literal, NamedTuple

from solver.body_parts import BodyPart
from solver.demanded import demand
from solver.exports.model import Cuboid, Fitting, Paint, PanelHole, PlacedOpening, Point, WallBox, WallPanel
from solver.exports.paints import PLAIN_WALL, REVEAL, SURFACES, WALL_ROUGHNESS
from solver.exports.wall_bands import EDGE_WORK, NEGLIGIBLE, Line, PlanAxis, RoomFinder, WallRun
from solver.geometry import gaps_between
from solver.scene import Level, Room
from solver.wall_fittings import GLASS_THICKNESS, THRESHOLD, Bar, Span, around, cut_at_holes, door_bars, frame_of, window_bars, within_frame

RAILING_HEIGHT: Final = 0.6
RAILING_BAR: Final = 0.05
POST_SPACING: Final = 1.2
_BEFORE: Final = 0.02
"""How far before a face the room is that it belongs to, m."""


@dataclass(frozen=True)
class WallPlan:
    """What walls are made from."""

    runs: Sequence[WallRun]
    openings: Sequence[PlacedOpening]
    storeys: Mapping[int, Level]
    rooms: Sequence[Room]

    def storey(self, level: int) -> Level:
        """Returns a level's storey."""
        return self.storeys.get(level, Level())

    @cached_property
    def stretches(self) -> "list[_Stretch]":
        """The runs, with where they end and what is in them."""
        return _stretches(self)


class _Stretch(NamedTuple):
    run: WallRun
    along: Span
    openings: list[PlacedOpening]
    storey: Level


def _stretches(plan: WallPlan) -> list[_Stretch]:
    walls: dict[tuple[int, PlanAxis], list[WallRun]] = defaultdict(list)
    openings: dict[Line, list[PlacedOpening]] = defaultdict(list)
    for run in plan.runs:
        if run.kind == "wall":
            walls[run.line[:2]].append(run)
    for opening in plan.openings:
        openings[opening.level, opening.axis, opening.line].append(opening)
    made = []
    for run in plan.runs:
        crossing = walls[run.line[0], "z" if run.line[1] == "x" else "x"]
        here = [opening for opening in openings[run.line] if opening.end > run.start and opening.start < run.end]
        along = run.start - _reach(run, run.start, -1, crossing), run.end + _reach(run, run.end, 1, crossing)
        made.append(_Stretch(run, along, here, plan.storey(run.line[0])))
    return made


def _reach(run: WallRun, end: float, onward: Literal[1, -1], crossing: Sequence[WallRun]) -> float:
    """Returns how far a run, which goes `onward` there, reaches beyond its line's end, m.

    Walls end at the line of the wall they meet, inside it; at a corner the one along x fills the square. Railings stop at
    the wall's face.
    """
    _, axis, line = run.line
    demand(EDGE_WORK * len(crossing))
    near = run.shift + NEGLIGIBLE
    walls = [
        other for other in crossing
        if abs(other.line[2] - end) <= other.shift + NEGLIGIBLE and other.start <= line + near and line - near <= other.end
    ]  # fmt: skip
    if not walls:
        return 0.0
    middles = [((other.line[2] - end) * onward, other.thickness / 2) for other in walls]
    if run.kind == "railing":
        return min(middle - half for middle, half in middles)
    goes_on = len(walls) > 1 or any(other.start + near < line < other.end - near for other in walls)
    if axis == "x" and not goes_on:
        return sum(middles[0])
    return min(max(middle for middle, _ in middles), *(middle + half for middle, half in middles))


def panels_of(plan: WallPlan) -> list[WallPanel]:
    """Returns the walls of a house, without its railings."""
    corners = _finish_corners(plan.rooms)
    return [_panel(stretch, corners) for stretch in plan.stretches if stretch.run.kind == "wall"]


def _panel(stretch: _Stretch, corners: Mapping[PlanAxis, Sequence[float]]) -> WallPanel:
    level, axis, line = stretch.run.line
    start, end = stretch.along
    return WallPanel(
        axis=axis,
        line=line,
        start=start,
        end=end,
        thickness=stretch.run.thickness,
        elevation=stretch.storey.elevation,
        height=stretch.storey.height,
        level=level,
        holes=tuple(PanelHole(one.id, one.start, one.end, one.sill, one.head) for one in stretch.openings),
        seams=tuple(at for at in corners[axis] if start < at < end),
    )


def _finish_corners(rooms: Sequence[Room]) -> dict[PlanAxis, list[float]]:
    """Returns where rooms with a finish end along x and along z, each place once, m."""
    corners = [(room.x + x, room.z + z) for room in rooms if room.walls for x, z in room.corners]
    return {"x": list(dict.fromkeys(x for x, _ in corners)), "z": list(dict.fromkeys(z for _, z in corners))}


def boxes_of(panel: WallPanel, finder: RoomFinder) -> Iterator[WallBox]:
    """Yields a panel's solid boxes: whole columns between holes, what is under sills and over heads; cut where its finish changes."""
    half = panel.thickness / 2
    across = panel.line - half, panel.line + half
    holes = [((hole.start, hole.end), (hole.low, hole.high)) for hole in panel.holes]
    for (start, end), gaps in cut_at_holes((panel.start, panel.end), holes, panel.seams):
        middle = (start + end) / 2
        greater, lesser = map(_paint_in, finder.beside((panel.level, panel.axis, panel.line), middle, half + _BEFORE))
        for up in gaps_between((0.0, panel.height), gaps):
            box = box_on_line(panel.axis, (start, end), across, shifted(up, panel.elevation))
            yield WallBox(panel.axis, box, lesser, greater, REVEAL)


def _paint_in(room: Room | None) -> Paint:
    """Returns the paint of a room's walls."""
    finish = room.walls if room else None
    return Paint(finish.color, WALL_ROUGHNESS.get(finish.type, 0.95), texture=finish.type) if finish else PLAIN_WALL


def fittings_of(plan: WallPlan) -> list[Fitting]:
    """Returns what is fitted to a house's walls, and its railings."""
    made: list[Fitting] = []
    for stretch in plan.stretches:
        if stretch.run.kind == "railing":
            made += _railing(stretch)
        else:
            made += [part for opening in stretch.openings for part in _fitted(opening, stretch.run, stretch.storey.elevation)]
    return made


def _fitted(opening: PlacedOpening, run: WallRun, elevation: float) -> list[Fitting]:
    if opening.kind == "passage":
        return [_threshold(opening, (opening.start, opening.end), elevation)] if run.shift else []
    return (_window if opening.kind == "window" else _door_frame)(opening, elevation)


def _window(opening: PlacedOpening, elevation: float) -> list[Fitting]:
    bars = window_bars((opening.start, opening.end), (opening.sill, opening.head), opening.thickness)
    return [_barred(opening, bar, elevation) for bar in bars]


def _door_frame(opening: PlacedOpening, elevation: float) -> list[Fitting]:
    along = opening.start, opening.end
    frame = door_bars(along, opening.head, opening.thickness)
    return [*(_barred(opening, bar, elevation) for bar in frame), _threshold(opening, within_frame(along), elevation)]


def _threshold(opening: PlacedOpening, along: Span, elevation: float) -> Fitting:
    """Returns the board in an opening, where two floors meet."""
    across = around(opening.line, opening.thickness)
    return fitting("threshold", box_on_line(opening.axis, along, across, shifted((-0.01, THRESHOLD), elevation)))


def _barred(opening: PlacedOpening, bar: Bar, elevation: float) -> Fitting:
    across = opening.line + bar.across[0], opening.line + bar.across[1]
    return fitting(bar.surface, box_on_line(opening.axis, bar.along, across, shifted(bar.up, elevation)))


def frame_parts(kind: str, size: Point) -> list[tuple[BodyPart, Paint]]:
    """Returns an opening's frame, and a window's pane, in the middle of its foot; `size` is its width and height, and its wall's thickness.

    For programmes that know a door or window as one thing, no wider than its hole.
    """
    width, height, depth = size
    side = frame_of(min(width, height))
    boards = [((side, height, depth), (where * (width - side) / 2, height / 2, 0.0)) for where in (-1, 1)]
    rails = (0.0, height - side) if kind == "window" else (height - side,)
    boards += [((width - 2 * side, side, depth), (0.0, low + side / 2, 0.0)) for low in rails]
    parts = [(BodyPart("box", size, at, "y", 1.0, "body"), SURFACES["frame"]) for size, at in boards]
    if kind == "window":
        pane = (width - 2 * side, height - 2 * side, min(GLASS_THICKNESS, depth / 2))
        parts.append((BodyPart("box", pane, (0.0, height / 2, 0.0), "y", 1.0, "body"), SURFACES["glass"]))
    return parts


def _railing(stretch: _Stretch) -> Iterator[Fitting]:
    run, elevation = stretch.run, stretch.storey.elevation
    axis, across = run.line[1], around(run.line[2], RAILING_BAR)
    for start, end in gaps_between(stretch.along, ((one.start, one.end) for one in stretch.openings)):
        bays = max(1, int((end - start) / POST_SPACING + 0.5))
        step = (end - start - RAILING_BAR) / bays
        posts = [(start + i * step, start + i * step + RAILING_BAR) for i in range(bays + 1)]
        bars = [(post, (0.0, RAILING_HEIGHT - RAILING_BAR)) for post in posts]
        bars += [((start, end), (low, low + RAILING_BAR)) for low in (RAILING_HEIGHT - RAILING_BAR, RAILING_HEIGHT / 2 - RAILING_BAR)]
        yield from (fitting("railing", box_on_line(axis, along, across, shifted(up, elevation))) for along, up in bars)


def fitting(surface: Literal["railing", "frame", "threshold", "glass"], box: Cuboid) -> Fitting:
    """Returns a fitting in the paint of its surface."""
    return Fitting(surface, box, SURFACES[surface])


def shifted(up: Span, elevation: float) -> Span:
    """Returns an interval moved up."""
    return up[0] + elevation, up[1] + elevation


def box_on_line(axis: PlanAxis, along: Span, across: Span, up: Span) -> Cuboid:
    """Returns a box that stands on a line of the plan."""
    x, z = (along, across) if axis == "x" else (across, along)
    return Cuboid(x[0], up[0], z[0], x[1], up[1], z[1])
