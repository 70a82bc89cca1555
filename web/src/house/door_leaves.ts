/** Where door leaves hang and how they turn; pure, so that it can be tested without a canvas. */
import { roomsBeside } from "./entrance";
import type { PlacedOpening } from "./openings";
import { frameOf, RAILING_HEIGHT, THRESHOLD, withinFrame, type WallPlan } from "./walls";

/** How a leaf is made: between rooms, at the street, to a terrace, of a garage, in a railing. */
export type LeafLook = "inner" | "entrance" | "glazed" | "sectional" | "gate";

/** A leaf that turns about its hinge, or a panel that rolls up. Lengths [m], angles [rad] about +y. */
export interface Leaf {
  /** The door's, of its second leaf with `/2`. */
  readonly id: string;
  readonly opening: string;
  readonly motion: "swing" | "roll";
  readonly look: LeafLook;
  readonly hinge: { readonly x: number; readonly y: number; readonly z: number };
  readonly width: number;
  readonly height: number;
  readonly closedAngle: number;
  /** What opening adds to the closed angle: a quarter turn either way. */
  readonly turn: number;
  /** How far it stands open in the scene, 0 to 1. */
  readonly open?: number;
}

export const LEAF_THICKNESS = 0.04;
const GROUND_GAP = THRESHOLD + 0.002;
/** The widest opening of a door that has one leaf [m]; a wider one has two, which meet in its middle. */
export const WIDEST_LEAF = 1.25;

/** The angle about +y that brings +x to a direction of the plan. */
export function angleTowards(x: number, z: number): number {
  return Math.atan2(-z, x);
}

function quarterTurn(from: number, to: number): number {
  return Math.sin(to - from) > 0 ? Math.PI / 2 : -Math.PI / 2;
}

function hasRailing(opening: PlacedOpening, plan: WallPlan): boolean {
  return plan.runs.some((run) => run.kind === "railing" && run.level === opening.level && run.axis === opening.axis
    && run.line === opening.line && run.from < opening.to && opening.from < run.to);
}

function lookOf(opening: PlacedOpening, plan: WallPlan): LeafLook {
  if (opening.kind === "garage_door") return "sectional";
  if (hasRailing(opening, plan)) return "gate";
  if (opening.mainEntrance) return "entrance";
  const [one, other] = roomsBeside(plan.rooms ?? [], opening);
  return one && other && one.outdoor !== other.outdoor ? "glazed" : "inner";
}

/** The ends of an opening at which leaves hang, that of its hinge first. */
function hungAt({ kind, hinge, from, to }: PlacedOpening): readonly ("start" | "end")[] {
  if (kind !== "door") return ["start"];
  if (to - from <= WIDEST_LEAF + 1e-9) return [hinge];
  return hinge === "start" ? ["start", "end"] : ["end", "start"];
}

function leafOf(opening: PlacedOpening, plan: WallPlan, number: number, count: number): Leaf {
  const { axis, line, from, to, opensTowards } = opening;
  const swings = opening.kind === "door";
  const fromStart = hungAt(opening)[number] === "start";
  const along = fromStart ? 1 : -1;
  const at = fromStart ? withinFrame(opening).from : withinFrame(opening).to;
  const offset = swings ? opensTowards * Math.max(0, opening.thickness / 2 - LEAF_THICKNESS / 2) : 0;
  const closed = axis === "x" ? angleTowards(along, 0) : angleTowards(0, along);
  const open = axis === "x" ? angleTowards(0, opensTowards) : angleTowards(opensTowards, 0);
  const elevation = plan.storeys.get(opening.level)?.elevation ?? 0;
  const [x, z] = axis === "x" ? [at, line + offset] : [line + offset, at];
  return {
    id: number > 0 ? `${opening.id}/${number + 1}` : opening.id,
    opening: opening.id,
    motion: swings ? "swing" : "roll",
    look: lookOf(opening, plan),
    hinge: { x, y: elevation + GROUND_GAP, z },
    width: (to - from - 2 * frameOf(to - from)) / count,
    height: (hasRailing(opening, plan) ? Math.min(opening.head, RAILING_HEIGHT) : opening.head) - GROUND_GAP,
    closedAngle: closed,
    turn: quarterTurn(closed, open),
    open: opening.open ?? 0,
  };
}

/** The leaves of a house: one or two for each door, one for each garage door, none for passages and windows. */
export function leavesOf(plan: WallPlan): Leaf[] {
  return plan.openings
    .filter(({ kind, head }) => (kind === "door" || kind === "garage_door") && head > GROUND_GAP)
    .flatMap((opening) => hungAt(opening).map((_, number, all) => leafOf(opening, plan, number, all.length)));
}

