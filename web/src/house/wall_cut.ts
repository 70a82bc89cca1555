/** How high walls are drawn: those before the viewer lower, so that they do not hide what stands at them. Pure. */
import type { Side } from "../contract";
import type { Axis } from "./boxes";

/** Up to `height` above the ground [m]; what looks outside towards one of the sides `before`, up to `LOW` of its floor. */
export interface WallCut {
  readonly height: number;
  readonly before: ReadonlySet<Side>;
}

/** How high above their floor the walls before the viewer are drawn [m]. */
export const LOW = 0.3;
/** A wall is before the viewer who looks at it by more than this; more from above than so, walls hide nothing [cosine]. */
const TOWARDS = 0.25;

/** From where each side is seen: what looks outside towards it. */
const OUTWARDS: readonly (readonly [Side, number, number])[] = [["north", 0, -1], ["east", 1, 0], ["south", 0, 1], ["west", -1, 0]];

/** All walls at one height. */
export function cutAll(height: number): WallCut {
  return { height, before: new Set() };
}

/** The sides of a house that are before who looks at it, as bits; `x`, `y`, `z` lead from what is looked at to the eye. */
export function sidesBefore({ x, y, z }: { readonly x: number; readonly y: number; readonly z: number }): number {
  const level = Math.hypot(x, z);
  if (level <= TOWARDS * Math.hypot(level, y)) return 0;
  return OUTWARDS.reduce((bits, [, dx, dz], i) => (dx * x + dz * z > TOWARDS * level ? bits | (1 << i) : bits), 0);
}

/** The sides of some bits. */
export function sidesOf(bits: number): ReadonlySet<Side> {
  return new Set(OUTWARDS.filter((_, i) => bits & (1 << i)).map(([side]) => side));
}

/** The side that lies beyond a wall along an axis, towards greater coordinates or smaller. */
export function sideBeyond(axis: Axis, towards: 1 | -1): Side {
  if (axis === "x") return towards > 0 ? "south" : "north";
  return towards > 0 ? "east" : "west";
}

/** How high above the ground something at a wall is drawn that looks outside towards `outward` and stands on a floor so high [m]. */
export function heightAt(cut: WallCut, outward: Side | null | undefined, elevation: number): number {
  return outward && cut.before.has(outward) ? Math.min(cut.height, elevation + LOW) : cut.height;
}
