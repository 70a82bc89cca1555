/** Axis-aligned boxes in house coordinates [m]: x east, y up, z south. Everything of a wall is made of them. */

export interface Box {
  readonly x0: number;
  readonly x1: number;
  readonly y0: number;
  readonly y1: number;
  readonly z0: number;
  readonly z1: number;
}

/** The lower part of a box under a horizontal plane, or null where nothing of it is under the plane. */
export function clipBelow(box: Box, height: number): Box | null {
  if (box.y0 >= height) return null;
  return box.y1 <= height ? box : { ...box, y1: height };
}

/** Which way something runs in the plan: along x (east) or along z (south). */
export type Axis = "x" | "z";

export interface Span {
  readonly from: number;
  readonly to: number;
}

/** A box standing on a plan line: `along` the axis, `across` it, from `up.from` to `up.to`. */
export function boxOnLine(axis: Axis, along: Span, across: Span, up: Span): Box {
  const [x, z] = axis === "x" ? [along, across] : [across, along];
  return { x0: x.from, x1: x.to, y0: up.from, y1: up.to, z0: z.from, z1: z.to };
}
