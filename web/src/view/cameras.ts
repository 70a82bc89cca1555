/** Camera presets: from where a house is looked at, and how far away it all fits. Pure. */
import { SIZED } from "../plan/readable";

export type Vector = readonly [number, number, number];

/** A way of looking: the directions from the house to the camera to choose from, and the vertical field of view [deg]. */
export interface Preset {
  readonly from: readonly Vector[];
  readonly fov: number;
  /** A sheet, which has its lengths round the house where it is large enough for them, and the window is not narrow. */
  readonly isSheet?: boolean;
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
  plan: { from: [[0, 1, 0.0001]], fov: 1, isSheet: true },
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

/** The canvas: its width over its height, and the share of its height that something lies over at the top; how high it is [CSS pixels]. */
export interface Window {
  readonly aspect: number;
  readonly covered?: number;
  /** How far the switch of views reaches from the lower left corner: its shares of the width and of the height. */
  readonly switched?: readonly [across: number, up: number] | null;
  readonly height?: number;
  readonly isNarrow?: boolean;
}

/** So much of the canvas lies under its toolbar, whose buttons are as high as fingers on a phone; so much is left over the switch of views at its foot, and at the foot of a sheet where there is none [CSS pixels]. */
const [TOOLBAR, PHONE_TOOLBAR] = [52, 66];
const [OVER_SWITCH, NO_SWITCH] = [16, 60];
const NARROW = 560;
/** No more of the canvas than this share is left to either. */
const MOST_COVERED = 0.2;
/** So much is left round a sheet: for three chains of lengths in the north and west, two in the south and east, and where there are none [CSS pixels]. */
const [THREE_CHAINS, TWO_CHAINS, NO_CHAINS] = [126, 92, 14];
/** So wide are the handles at both sides of the canvas that fold the panels [CSS pixels]. */
const HANDLE = 26;
/** No more than this share of the canvas is left round a sheet on any side. */
const MOST_ROUND = 0.34;

/** What a canvas of a size leaves free; `views`: their switch, null where there is none [CSS pixels]. */
export function windowOf({ width, height }: { readonly width: number; readonly height: number }, views: Pick<HTMLElement, "offsetLeft" | "offsetWidth" | "offsetHeight"> | null): Window {
  const share = (pixels: number): number => Math.min(MOST_COVERED, pixels / height);
  const switched = views && ([(views.offsetLeft + views.offsetWidth) / width, share(views.offsetLeft + views.offsetHeight + OVER_SWITCH)] as const); // as far from the foot as from the left
  const isNarrow = width < NARROW;
  return { aspect: width / height, covered: share(isNarrow ? PHONE_TOOLBAR : TOOLBAR), switched, height, isNarrow };
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

/** What is left free round the points: how much wider the view is, and the shares of it at the top, at the foot, in the west and east. */
interface Free {
  readonly wider: number;
  readonly top: number;
  readonly foot: number;
  readonly west: number;
  readonly east: number;
}

/** The nearest place from which all points are seen within the planes that bound the view; what is left over is left on both sides. */
function fitted(points: readonly Vector[], from: Vector, { fov }: Preset, aspect: number, free: Free): Fitted {
  const { right, up, back } = axesOf(from);
  const slope = Math.tan((fov * Math.PI) / 360) / free.wider;
  const seen = points.map((point) => [dot(point, right), dot(point, up), dot(point, back)] as const);
  const reach = (k: 0 | 1, side: 1 | -1, steep: number): number => Math.max(...seen.map((at) => side * at[k] + steep * at[2]));
  const [towardsEast, towardsWest] = [free.east, free.west].map((share) => slope * aspect * (1 - 2 * share)) as [number, number];
  const [above, below] = [slope * (1 - 2 * free.top), slope * (1 - 2 * free.foot)];
  const [east, west, top, bottom] = [reach(0, 1, towardsEast), reach(0, -1, towardsWest), reach(1, 1, above), reach(1, -1, below)];
  const depth = Math.max((east + west) / (towardsEast + towardsWest), (top + bottom) / (above + below));
  const height = (top - above * depth + (below * depth - bottom)) / 2;
  const aside = (east - towardsEast * depth + (towardsWest * depth - west)) / 2;
  const eye = plus(plus(plus([0, 0, 0], right, aside), up, height), back, depth);
  const distance = depth - seen.reduce((sum, at) => sum + at[2], 0) / seen.length;
  return { framing: { eye, target: plus(eye, back, -distance), fov }, distance };
}

/** The steps in which a line is turned that parts the points from a corner of the view. */
const TURNS = Array.from({ length: 33 }, (_, step) => step / 32);

/** Whether what lies between the points is seen beside, or above, what reaches so far from the lower left corner. */
function isClear(points: readonly Vector[], from: Vector, { eye, fov }: Framing, aspect: number, [across, up]: readonly [number, number]): boolean {
  const axes = axesOf(from);
  const slope = Math.tan((fov * Math.PI) / 360);
  const seen = points.map((point) => {
    const at = plus(point, eye, -1);
    const half = -2 * slope * dot(at, axes.back);
    return [dot(at, axes.right) / (half * aspect) + 0.5 - across, dot(at, axes.up) / half + 0.5 - up] as const;
  });
  return TURNS.some((turn) => seen.every(([x, y]) => turn * x + (1 - turn) * y >= 0));
}

/** As near as a preset comes from a direction: a sheet with its lengths round it, else with those of two sides, where they can be read, else the rooms alone. */
function near(points: readonly Vector[], from: Vector, preset: Preset, { aspect, covered = 0, switched = null, height = 0, isNarrow = false }: Window): Fitted {
  const fit = (free: Free): Fitted => fitted(points, from, preset, aspect, free);
  if (!preset.isSheet || height === 0 || isNarrow) {
    const plain: Free = { wider: MARGIN, top: covered, foot: 0, west: 0, east: 0 };
    const whole = fit(plain);
    return !switched || isClear(points, from, whole.framing, aspect, switched) ? whole : fit({ ...plain, foot: switched[1] });
  }
  const share = (pixels: number, of: number): number => Math.min(MOST_ROUND, pixels / of);
  const foot = switched ? switched[1] * height : NO_SWITCH;
  const round = (aboveAndBelow: boolean, atSides: boolean): Fitted => {
    const [north, south] = aboveAndBelow ? [THREE_CHAINS, TWO_CHAINS] : [NO_CHAINS, NO_CHAINS];
    const [west, east] = atSides ? [THREE_CHAINS, TWO_CHAINS] : [NO_CHAINS, NO_CHAINS];
    return fit({
      wider: 1, top: share(TOOLBAR + north, height), foot: share(foot + south, height),
      west: share(HANDLE + west, height * aspect), east: share(HANDLE + east, height * aspect),
    });
  };
  const isSized = ({ distance }: Fitted): boolean => height / (2 * distance * Math.tan((preset.fov * Math.PI) / 360)) / 1000 >= SIZED;
  const ofTwoSides = [round(true, false), round(false, true)].sort((a, b) => a.distance - b.distance);
  return [round(true, true), ...ofTwoSides].find(isSized) ?? round(false, false);
}

/** Places a camera so that the points fill the view. */
export function frame(points: readonly Vector[], preset: Preset, window: Window): Framing {
  const ways = preset.from.map((from) => near(points, from, preset, window));
  return ways.reduce((best, way) => (way.distance < best.distance * (best === ways[0] ? CLEARLY : 1) ? way : best)).framing;
}

/** Between two framings, `share` from 0 to 1. */
export function blend(a: Framing, b: Framing, share: number): Framing {
  const mix = (from: Vector, to: Vector): Vector => plus(from, plus(to, from, -1), share);
  return { eye: mix(a.eye, b.eye), target: mix(a.target, b.target), fov: a.fov + (b.fov - a.fov) * share };
}
