/** Walking through a house at eye height: where one stands, turns and wishes to go. Pure; what is in the way is walk_floor's. */
import type { PlacedOpening } from "../house/openings";
import type { Bounds, Vector } from "./cameras";

/** Where one's eyes are [m], and which way they look [rad]: a yaw of 0 is north, growing to the west; pitch up. */
export interface Pose {
  readonly eye: Vector;
  readonly yaw: number;
  readonly pitch: number;
}

/** A door to begin at, and on which side of its line the house is. */
export interface Entrance {
  readonly opening: Pick<PlacedOpening, "axis" | "line" | "from" | "to">;
  readonly inward: 1 | -1;
}

/** What the keys held down ask for, each from -1 to 1. */
export interface Stride {
  readonly ahead: number;
  readonly aside: number;
  readonly hurried: boolean;
}

export const EYE_HEIGHT = 1.6;
/** How far around the house one may go [m]. */
export const OUTSIDE = 3;
const PACE = 1.7;
const HURRY = 2;
const STEEPEST = 1.2;
/** How far within the entrance one starts [m]. */
const INSIDE = 0.7;
/** A little down: furniture stands below the eyes. */
const FIRST_PITCH = -0.12;

/** One looks so many times to each side, so far apart [rad], up to so far and in such steps [m]. */
const GLANCES = 6;
const GLANCE = Math.PI / 12;
const FARTHEST = 12;
const GLANCED = 0.25;
/** Turning is to show so much more [square root of m]. */
const WORTH_TURNING = 0.1;

const clamp = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value));

/** Just within the main entrance, looking in; without one, in a corner of the house, looking at its middle. */
export function firstPose(entrance: Entrance | null, bounds: Bounds): Pose {
  if (!entrance) {
    const middle: Vector = [(bounds.min[0] + bounds.max[0]) / 2, 0, (bounds.min[2] + bounds.max[2]) / 2];
    const eye: Vector = [bounds.min[0] + INSIDE, EYE_HEIGHT, bounds.max[2] - INSIDE];
    return { eye, yaw: Math.atan2(eye[0] - middle[0], eye[2] - middle[2]), pitch: FIRST_PITCH };
  }
  const { opening, inward } = entrance;
  const [along, across] = [(opening.from + opening.to) / 2, opening.line + inward * INSIDE];
  const eye: Vector = opening.axis === "x" ? [along, EYE_HEIGHT, across] : [across, EYE_HEIGHT, along];
  const yaw = opening.axis === "x" ? (inward === 1 ? Math.PI : 0) : inward * -Math.PI / 2;
  return { eye, yaw, pitch: FIRST_PITCH };
}

/**
 * Turns the head to where a view shows most: depth all across it, no wall before half of it;
 * straight on where nothing is gained by turning. It reaches so far to each side [rad].
 */
export function turnedToSight(pose: Pose, sees: (place: Vector) => boolean, aside = Math.PI / 4): Pose {
  const beside = Math.max(1, Math.round(aside / GLANCE));
  const { eye, yaw } = pose;
  const farAt = (step: number): number => {
    const [sin, cos] = [Math.sin(yaw + step * GLANCE), Math.cos(yaw + step * GLANCE)];
    let far = 0;
    while (far < FARTHEST && sees([eye[0] - sin * (far + GLANCED), eye[1], eye[2] - cos * (far + GLANCED)])) far += GLANCED;
    return far;
  };
  const reach = GLANCES + beside;
  const fars = Array.from({ length: 2 * reach + 1 }, (_, k) => Math.sqrt(farAt(k - reach)));
  const shown = (turn: number): number => fars.slice(turn + reach - beside, turn + reach + beside + 1).reduce((sum, far) => sum + far) / (2 * beside + 1);
  let best = 0;
  for (let turn = -GLANCES; turn <= GLANCES; turn += 1) if (shown(turn) > shown(best) + WORTH_TURNING) best = turn;
  return { ...pose, yaw: yaw + best * GLANCE };
}

/** Keeps one's eyes near the house [m]. */
export function keptNear({ eye, ...rest }: Pose, { min, max }: Bounds): Pose {
  return { ...rest, eye: [clamp(eye[0], min[0] - OUTSIDE, max[0] + OUTSIDE), eye[1], clamp(eye[2], min[2] - OUTSIDE, max[2] + OUTSIDE)] };
}

/** Goes on for some seconds. */
export function walked(pose: Pose, { ahead, aside, hurried }: Stride, seconds: number, bounds: Bounds): Pose {
  const length = Math.max(1, Math.hypot(ahead, aside));
  const way = (PACE * (hurried ? HURRY : 1) * seconds) / length;
  const [sin, cos] = [Math.sin(pose.yaw), Math.cos(pose.yaw)];
  const eye: Vector = [
    pose.eye[0] + (aside * cos - ahead * sin) * way, pose.eye[1], pose.eye[2] - (aside * sin + ahead * cos) * way,
  ];
  return keptNear({ ...pose, eye }, bounds);
}

/** Goes straight towards a place of the plan [m] for some seconds; arrived, one stands there. */
export function walkedTo(pose: Pose, [x, z]: readonly [number, number], seconds: number): { pose: Pose; arrived: boolean } {
  const [dx, dz] = [x - pose.eye[0], z - pose.eye[2]];
  const left = Math.hypot(dx, dz);
  const way = PACE * HURRY * seconds;
  const share = left > way ? way / left : 1;
  return { pose: { ...pose, eye: [pose.eye[0] + dx * share, pose.eye[1], pose.eye[2] + dz * share] }, arrived: share === 1 };
}

/** Turns the head by angles [rad]. */
export function turned(pose: Pose, left: number, up: number): Pose {
  return { ...pose, yaw: pose.yaw + left, pitch: clamp(pose.pitch + up, -STEEPEST, STEEPEST) };
}

/** The direction looked into, of length 1. */
export function gazeOf({ yaw, pitch }: Pose): Vector {
  return [-Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), -Math.cos(yaw) * Math.cos(pitch)];
}
