/** Camera presets: from where a house is looked at, and how far away it all fits. Pure. */

export type Vector = readonly [number, number, number];

/** A way of looking: `from` is the direction from the house to the camera, `fov` the vertical field of view [deg]. */
export interface Preset {
  readonly from: Vector;
  readonly fov: number;
}

export type PresetName = "top" | "corner";

export const PRESETS: Readonly<Record<PresetName, Preset>> = {
  // A hair off the vertical, so that north is up; a narrow view from afar, so that walls hardly lean.
  top: { from: [0, 1, 0.0001], fov: 12 },
  corner: { from: [0.42, 1.05, 1], fov: 30 },
};

export interface Bounds {
  readonly min: Vector;
  readonly max: Vector;
}

/** A camera's place, the point it looks at, and its vertical field of view [deg]. */
export interface Framing {
  readonly eye: Vector;
  readonly target: Vector;
  readonly fov: number;
}

const MARGIN = 1.08;
const PASSES = 4;

const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const plus = (a: Vector, b: Vector, share = 1): Vector => [a[0] + b[0] * share, a[1] + b[1] * share, a[2] + b[2] * share];
const cross = (a: Vector, b: Vector): Vector => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function unit(a: Vector): Vector {
  const length = Math.hypot(...a);
  return [a[0] / length, a[1] / length, a[2] / length];
}

export function cornersOfBounds({ min, max }: Bounds): Vector[] {
  return [min[0], max[0]].flatMap((x) => [min[1], max[1]].flatMap((y) => [min[2], max[2]].map((z): Vector => [x, y, z])));
}

/** The camera's own directions: right and up on the screen, back towards the camera. */
export function axesOf(from: Vector): { right: Vector; up: Vector; back: Vector } {
  const back = unit(from);
  const right = unit(cross([0, 1, 0], back));
  return { right, up: cross(back, right), back };
}

/**
 * Places a camera so that the bounds fill the view and are in its middle.
 *
 * The distance is the least at which every corner is inside the view's pyramid; the target is then moved to the
 * middle of what is seen, and the distance taken again.
 */
export function frame(bounds: Bounds, preset: Preset, aspect: number): Framing {
  const { right, up, back } = axesOf(preset.from);
  const slopeUp = Math.tan((preset.fov * Math.PI) / 360) / MARGIN;
  const slopeRight = slopeUp * aspect;
  const corners = cornersOfBounds(bounds);
  let target: Vector = plus([0, 0, 0], plus(bounds.min, bounds.max), 0.5);
  let distance = 1;
  for (let pass = 0; pass < PASSES; pass += 1) {
    const seen = corners.map((corner) => plus(corner, target, -1)).map((at) => ({ x: dot(at, right), y: dot(at, up), z: dot(at, back) }));
    distance = Math.max(...seen.map(({ x, y, z }) => z + Math.max(Math.abs(x) / slopeRight, Math.abs(y) / slopeUp)));
    const heights = seen.map(({ y, z }) => y / (distance - z));
    target = plus(target, up, ((Math.max(...heights) + Math.min(...heights)) / 2) * distance);
  }
  return { eye: plus(target, back, distance), target, fov: preset.fov };
}

/** Between two framings, `share` from 0 to 1. */
export function blend(a: Framing, b: Framing, share: number): Framing {
  const mix = (from: Vector, to: Vector): Vector => plus(from, plus(to, from, -1), share);
  return { eye: mix(a.eye, b.eye), target: mix(a.target, b.target), fov: a.fov + (b.fov - a.fov) * share };
}
