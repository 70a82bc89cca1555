/** Walls as upright panels with holes, and what is fitted to them as boxes: frames, sill boards, glass, railings. */
import type { Room, Side } from "../contract";
import { boxOnLine, type Box, type Span } from "./boxes";
import { outwardOf, seamsOf } from "./finishes";
import type { PlacedOpening } from "./openings";
import { byLine, lineKey } from "./plan";
import { NEGLIGIBLE } from "./wall_bands";
import type { Run } from "./wall_runs";
import type { WallPanel } from "./wall_panel";

export type Surface = "railing" | "frame" | "threshold" | "glass";

export interface WallPart {
  readonly surface: Surface;
  readonly box: Box;
  /** Of a window: the floor of its storey [m], and towards which side its wall looks outside. */
  readonly window?: { readonly elevation: number; readonly outward: Side | null };
}

/** What a level's walls stand on and reach to [m]. */
export interface Storey {
  readonly elevation: number;
  readonly height: number;
}

export interface WallPlan {
  readonly runs: readonly Run[];
  readonly openings: readonly PlacedOpening[];
  readonly storeys: ReadonlyMap<number, Storey>;
  /** Whose finishes the walls have; none where they are all alike. */
  readonly rooms?: readonly Room[];
}

export const RAILING_HEIGHT = 0.6;
const RAILING_BAR = 0.05;
const POST_SPACING = 1.2;
/** How wide a frame's bars are [m]: a leaf that stands open, with its handle, is then no wider than its opening. */
const FRAME = 0.06;
const FRAME_PROUD = 0.01;
/** How high the board is that lies under a leaf, where two floors meet [m]. */
export const THRESHOLD = 0.008;
const GLASS_THICKNESS = 0.012;
const SILL_BOARD = 0.03;
const DEFAULT_STOREY: Storey = { elevation: 0, height: 2.8 };

function around(centre: number, thickness: number): Span {
  return { from: centre - thickness / 2, to: centre + thickness / 2 };
}

function shifted(up: Span, elevation: number): Span {
  return { from: up.from + elevation, to: up.to + elevation };
}

/** How a run ends: how far beyond its line's end, and whether it runs into a wall there. */
interface End {
  readonly reach: number;
  readonly inWall: boolean;
}

/**
 * Walls end at the line of the wall they meet, inside it; at a corner the one along x fills the square.
 * Railings stop at the wall's face.
 */
function endOf(run: Run, end: number, onward: 1 | -1, runs: readonly Run[]): End {
  const walls = runs.filter((other) => other.kind === "wall" && other.level === run.level && other.axis !== run.axis
    && Math.abs(other.line - end) <= other.shift + NEGLIGIBLE && other.from <= run.line + run.shift && run.line - run.shift <= other.to);
  const [first] = walls;
  if (!first) return { reach: 0, inWall: false };
  const middle = (other: Run): number => (other.line - end) * onward;
  if (run.kind === "railing") return { reach: Math.min(...walls.map((other) => middle(other) - other.thickness / 2)), inWall: true };
  const goesOn = walls.length > 1 || walls.some((other) => other.from + run.shift < run.line && run.line < other.to - run.shift);
  if (run.axis === "x" && !goesOn) return { reach: middle(first) + first.thickness / 2, inWall: false };
  return { reach: Math.min(Math.max(...walls.map(middle)), ...walls.map((other) => middle(other) + other.thickness / 2)), inWall: true };
}

/** The stretches of [from, to] that no gap covers. */
export function between(from: number, to: number, gaps: readonly Span[]): Span[] {
  const solid: Span[] = [];
  let reached = from;
  for (const gap of [...gaps].sort((a, b) => a.from - b.from)) {
    if (gap.from > reached) solid.push({ from: reached, to: Math.min(gap.from, to) });
    reached = Math.max(reached, gap.to);
  }
  if (reached < to) solid.push({ from: reached, to });
  return solid;
}

function windowParts(opening: PlacedOpening, elevation: number): WallPart[] {
  const { axis, line, thickness, from, to, sill, head } = opening;
  const frame = around(line, Math.min(thickness, 0.06));
  const bar = (along: Span, up: Span, across: Span = frame, surface: Surface = "frame"): WallPart => ({
    surface,
    box: boxOnLine(axis, along, across, shifted(up, elevation)),
  });
  const board = around(line, thickness + 0.06);
  const middle = (from + to) / 2;
  const [wide, high] = [frameOf(to - from), frameOf(head - sill)];
  const foot = sill + Math.min(SILL_BOARD, high);
  return [
    bar({ from: from - 0.02, to: to + 0.02 }, { from: sill, to: foot }, board),
    bar({ from, to: from + wide }, { from: sill, to: head }),
    bar({ from: to - wide, to }, { from: sill, to: head }),
    bar({ from, to }, { from: head - high, to: head }),
    ...(to - from > 0.9 ? [bar(around(middle, wide), { from: sill, to: head })] : []),
    bar({ from, to }, { from: foot, to: head - high }, around(line, GLASS_THICKNESS), "glass"),
  ];
}

/** How wide the bars of a frame are in an opening that is so wide or high [m]: in a small one a quarter of that. */
export function frameOf(extent: number): number {
  return Math.min(FRAME, extent / 4);
}

/** What an opening's frame leaves of it along its wall [m]. */
export function withinFrame({ from, to }: Span): Span {
  return { from: from + frameOf(to - from), to: to - frameOf(to - from) };
}

/** The board in an opening, where two floors meet. */
function threshold({ axis, line, thickness }: PlacedOpening, along: Span, elevation: number): WallPart {
  return { surface: "threshold", box: boxOnLine(axis, along, around(line, thickness), shifted({ from: -0.01, to: THRESHOLD }, elevation)) };
}

function doorFrame(opening: PlacedOpening, elevation: number): WallPart[] {
  const { axis, line, thickness, from, to, head } = opening;
  const across = around(line, thickness + 2 * FRAME_PROUD);
  const bar = (along: Span, up: Span): WallPart => ({ surface: "frame", box: boxOnLine(axis, along, across, shifted(up, elevation)) });
  const within = withinFrame(opening);
  return [
    bar({ from, to: within.from }, { from: 0, to: head }),
    bar({ from: within.to, to }, { from: 0, to: head }),
    bar({ from, to }, { from: head, to: head + FRAME }),
    threshold(opening, within, elevation),
  ];
}

function fittings(opening: PlacedOpening, run: Run, elevation: number): WallPart[] {
  if (opening.kind === "window") return windowParts(opening, elevation);
  if (opening.kind === "passage") return run.shift > 0 ? [threshold(opening, opening, elevation)] : [];
  return doorFrame(opening, elevation);
}

function railingParts(run: Run, along: Span, openings: readonly PlacedOpening[], elevation: number): WallPart[] {
  const across = around(run.line, RAILING_BAR);
  const part = (stretch: Span, up: Span): WallPart => ({ surface: "railing", box: boxOnLine(run.axis, stretch, across, shifted(up, elevation)) });
  return between(along.from, along.to, openings).flatMap((stretch) => {
    const bays = Math.max(1, Math.round((stretch.to - stretch.from) / POST_SPACING));
    const step = (stretch.to - stretch.from - RAILING_BAR) / bays;
    const posts = Array.from({ length: bays + 1 }, (_, i) => {
      const at = stretch.from + i * step;
      return part({ from: at, to: at + RAILING_BAR }, { from: 0, to: RAILING_HEIGHT - RAILING_BAR });
    });
    const rails = [RAILING_HEIGHT - RAILING_BAR, RAILING_HEIGHT / 2 - RAILING_BAR];
    return [...posts, ...rails.map((low) => part(stretch, { from: low, to: low + RAILING_BAR }))];
  });
}

/** A run with all that is needed to draw it. */
interface Stretch {
  readonly run: Run;
  readonly along: Span;
  readonly ends: readonly [End, End];
  readonly openings: readonly PlacedOpening[];
  readonly storey: Storey;
}

function stretchesOf(plan: WallPlan): Stretch[] {
  const openings = byLine(plan.openings);
  return plan.runs.map((run) => {
    const ends = [endOf(run, run.from, -1, plan.runs), endOf(run, run.to, 1, plan.runs)] as const;
    return {
      run,
      ends,
      along: { from: run.from - ends[0].reach, to: run.to + ends[1].reach },
      openings: (openings.get(lineKey(run)) ?? []).filter((opening) => opening.to > run.from && opening.from < run.to),
      storey: plan.storeys.get(run.level) ?? DEFAULT_STOREY,
    };
  });
}

/** The walls of a house, without its railings. */
export function wallPanelsOf(plan: WallPlan): WallPanel[] {
  return stretchesOf(plan).filter(({ run }) => run.kind === "wall").map(({ run, along, ends, openings, storey }) => ({
    axis: run.axis,
    along,
    across: around(run.line, run.thickness),
    elevation: storey.elevation,
    height: storey.height,
    level: run.level,
    seams: seamsOf(plan.rooms ?? [], run.axis, along),
    holes: openings.map((opening) => ({ along: opening, up: { from: opening.sill, to: opening.head } })),
    openStart: !ends[0].inWall,
    openEnd: !ends[1].inWall,
  }));
}

/** What is fitted to a house's walls, and its railings. */
export function fittingsOf(plan: WallPlan): WallPart[] {
  return stretchesOf(plan).flatMap(({ run, along, openings, storey: { elevation } }) => (run.kind === "railing"
    ? railingParts(run, along, openings, elevation)
    : openings.flatMap((opening) => {
      const parts = fittings(opening, run, elevation);
      const window = { elevation, outward: outwardOf({ ...run, across: around(run.line, run.thickness) }, (opening.from + opening.to) / 2, plan.rooms ?? []) };
      return opening.kind === "window" ? parts.map((part) => ({ ...part, window })) : parts;
    })));
}
