/** Camera presets: from where a house is looked at, and how far away it all fits. Pure. */

export type Vector = readonly [number, number, number];

/** A way of looking: the directions from the house to the camera to choose from, and the vertical field of view [deg]. */
export interface Preset {
  readonly from: readonly Vector[];
  readonly fov: number;
  /** How much wider the view is than the house, where the window is not narrow. */
  readonly margin?: number;
  /** The share of the view's height that is left free at its foot then. */
  readonly foot?: number;
}

export type PresetName = "top" | "corner" | "plan";

/** A direction by how far it is turned from the south to the east, and its height over the horizon [deg]. */
function towards(turn: number, height: number): Vector {
  const [a, h] = [(turn * Math.PI) / 180, (height * Math.PI) / 180];
  return [Math.sin(a) * Math.cos(h), Math.sin(h), Math.cos(a) * Math.cos(h)];
}

export const PRESETS: Readonly<Record<PresetName, Preset>> = {
  // A hair off the vertical, so that north is up; a narrow view from afar, so that walls hardly lean.
  top: { from: [[0, 1, 0.0001]], fov: 12 },
  // From so far that heights move nothing aside: what is drawn on the ground lies under what is pointed at.
  // Around the house the sheet has its dimensions and its title.
  plan: { from: [[0, 1, 0.0001]], fov: 1, margin: 1.4, foot: 0.14 },
  // The first is looked from unless another one shows the house clearly larger in the window as it is.
  corner: { from: [24, 40, 58].flatMap((turn) => [44, 50].map((height) => towards(turn, height))), fov: 30 },
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

/** The canvas: its width over its height, and the shares of its height that something lies over at the top and at the foot. */
export interface Window {
  readonly aspect: number;
  readonly covered?: number;
  readonly beneath?: number;
}

/** So much of the canvas lies under its toolbar, and of a narrow one under the switch of views, which lies across its foot [CSS pixels]. */
const TOOLBAR = 52;
const SWITCH = 60;
const NARROW = 560;
/** No more of the canvas than this share is left to either. */
const MOST_COVERED = 0.2;

/** What a canvas of a size [CSS pixels] leaves free. */
export function windowOf({ width, height }: { readonly width: number; readonly height: number }): Window {
  const share = (pixels: number): number => Math.min(MOST_COVERED, pixels / height);
  return { aspect: width / height, covered: share(TOOLBAR), beneath: width < NARROW ? share(SWITCH) : 0 };
}

const MARGIN = 1.06;
/** So much nearer another direction must bring the camera. */
const CLEARLY = 0.9;

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

/** A way of looking at all points, and from how far. */
interface Fitted {
  readonly framing: Framing;
  readonly distance: number;
}

/** The nearest place from which all points are seen within the planes that bound the view; what is left over is left on both sides. */
function fitted(points: readonly Vector[], from: Vector, { fov, margin, foot = 0 }: Preset, { aspect, covered = 0, beneath = 0 }: Window): Fitted {
  const [wider, free] = beneath > 0 || margin === undefined ? [MARGIN, beneath] : [margin, foot]; // a narrow window has no room round the house
  const { right, up, back } = axesOf(from);
  const slope = Math.tan((fov * Math.PI) / 360) / wider;
  const seen = points.map((point) => [dot(point, right), dot(point, up), dot(point, back)] as const);
  const reach = (k: 0 | 1, side: 1 | -1, steep: number): number => Math.max(...seen.map((at) => side * at[k] + steep * at[2]));
  const [aside, above, below] = [slope * aspect, slope * (1 - 2 * covered), slope * (1 - 2 * free)];
  const [east, west, top, bottom] = [reach(0, 1, aside), reach(0, -1, aside), reach(1, 1, above), reach(1, -1, below)];
  const depth = Math.max((east + west) / (2 * aside), (top + bottom) / (above + below));
  const height = (top - above * depth + (below * depth - bottom)) / 2;
  const eye = plus(plus(plus([0, 0, 0], right, (east - west) / 2), up, height), back, depth);
  const distance = depth - seen.reduce((sum, at) => sum + at[2], 0) / seen.length;
  return { framing: { eye, target: plus(eye, back, -distance), fov }, distance };
}

/** Places a camera so that the points fill the view. */
export function frame(points: readonly Vector[], preset: Preset, window: Window): Framing {
  const ways = preset.from.map((from) => fitted(points, from, preset, window));
  return ways.reduce((best, way) => (way.distance < best.distance * (best === ways[0] ? CLEARLY : 1) ? way : best)).framing;
}

/** Between two framings, `share` from 0 to 1. */
export function blend(a: Framing, b: Framing, share: number): Framing {
  const mix = (from: Vector, to: Vector): Vector => plus(from, plus(to, from, -1), share);
  return { eye: mix(a.eye, b.eye), target: mix(a.target, b.target), fov: a.fov + (b.fov - a.fov) * share };
}
