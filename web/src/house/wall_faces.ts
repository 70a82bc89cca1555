/**
 * The faces of a wall panel, cut at a height. The panel is a grid of cells between the edges of its holes: faces lie only
 * where stone meets air, and all corners coincide, so that no seam shows. Pure.
 */
import type { Span } from "./boxes";
import type { Hole, WallPanel } from "./wall_panel";

export type Point = readonly [number, number, number];

/** A rectangle in space, counter-clockwise seen from the side its normal points to. */
export interface Face {
  readonly corners: readonly [Point, Point, Point, Point];
  readonly normal: Point;
  /** Whether it is where the wall was cut. */
  readonly cut: boolean;
}

/** So high above the floor a wall may have a skirting [m]. */
export const SKIRTING = 0.08;

interface Cell {
  readonly along: Span;
  readonly up: Span;
}

function stops(span: Span, inner: readonly number[]): number[] {
  const inside = inner.filter((stop) => stop > span.from && stop < span.to);
  return [...new Set([span.from, ...inside, span.to])].sort((a, b) => a - b);
}

function spansBetween(ends: readonly number[]): Span[] {
  return ends.slice(1).map((to, i) => ({ from: ends[i] ?? to, to }));
}

function isHole(cell: Cell, holes: readonly Hole[]): boolean {
  const [s, h] = [(cell.along.from + cell.along.to) / 2, (cell.up.from + cell.up.to) / 2];
  return holes.some(({ along, up }) => along.from < s && s < along.to && up.from < h && h < up.to);
}

/** Coordinates of a panel (along, up, across) in the house. */
type Placing = (along: number, up: number, across: number) => Point;

function face(corners: readonly Point[], normal: Point, cut = false): Face {
  const [a, b, c, d] = corners as readonly [Point, Point, Point, Point];
  const [u, v] = [[b[0] - a[0], b[1] - a[1], b[2] - a[2]], [d[0] - a[0], d[1] - a[1], d[2] - a[2]]] as [Point, Point];
  const turned = (u[1] * v[2] - u[2] * v[1]) * normal[0] + (u[2] * v[0] - u[0] * v[2]) * normal[1] + (u[0] * v[1] - u[1] * v[0]) * normal[2];
  return { corners: turned > 0 ? [a, b, c, d] : [a, d, c, b], normal, cut };
}

function upright(cell: Cell, across: number, towards: 1 | -1, at: Placing, axis: WallPanel["axis"]): Face {
  const { along, up } = cell;
  const corners = [at(along.from, up.from, across), at(along.to, up.from, across), at(along.to, up.to, across), at(along.from, up.to, across)];
  return face(corners, axis === "x" ? [0, 0, towards] : [towards, 0, 0]);
}

function level(along: Span, height: number, across: Span, at: Placing, normal: 1 | -1, cut: boolean): Face {
  const corners = [at(along.from, height, across.from), at(along.to, height, across.from), at(along.to, height, across.to), at(along.from, height, across.to)];
  return face(corners, [0, normal, 0], cut);
}

function jamb(position: number, up: Span, across: Span, at: Placing, normal: Point): Face {
  return face([at(position, up.from, across.from), at(position, up.from, across.to), at(position, up.to, across.to), at(position, up.to, across.from)], normal);
}

/** All faces of a panel below the height `cut` above the ground [m]. */
export function facesOf(panel: WallPanel, cut: number): Face[] {
  const top = Math.min(panel.height, cut - panel.elevation);
  if (top <= 0) return [];
  const { axis, across, holes } = panel;
  const columns = spansBetween(stops(panel.along, [...holes.flatMap(({ along }) => [along.from, along.to]), ...panel.seams]));
  const rows = spansBetween(stops({ from: 0, to: top }, [SKIRTING, ...holes.flatMap(({ up }) => [up.from, up.to])]));
  const solid = columns.map((along) => rows.map((up) => !isHole({ along, up }, holes)));
  const at: Placing = (s, h, c) => (axis === "x" ? [s, panel.elevation + h, c] : [c, panel.elevation + h, s]);
  const endwise = (towards: 1 | -1): Point => (axis === "x" ? [towards, 0, 0] : [0, 0, towards]);
  const last = { column: columns.length - 1, row: rows.length - 1 };
  return columns.flatMap((along, i) => rows.flatMap((up, j) => {
    if (!solid[i]?.[j]) return [];
    const cell = { along, up };
    const faces = [upright(cell, across.from, -1, at, axis), upright(cell, across.to, 1, at, axis)];
    if (j === last.row) faces.push(level(along, up.to, across, at, 1, top < panel.height));
    else if (!solid[i]?.[j + 1]) faces.push(level(along, up.to, across, at, 1, false));
    if (j > 0 && !solid[i]?.[j - 1]) faces.push(level(along, up.from, across, at, -1, false));
    if (i === 0 ? panel.openStart : !solid[i - 1]?.[j]) faces.push(jamb(along.from, up, across, at, endwise(-1)));
    if (i === last.column ? panel.openEnd : !solid[i + 1]?.[j]) faces.push(jamb(along.to, up, across, at, endwise(1)));
    return faces;
  }));
}
