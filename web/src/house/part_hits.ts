/** Where a ray meets a body: the nearest of its parts, each by its box. Pure. */
import type { PlacedBody } from "./frame";
import { backwards, inFrameOf, movedWith, turnedWith, type Swing } from "./fronts";
import type { Part } from "./parts";

/** A straight line from a point; the direction has length 1. */
export interface Straight {
  readonly origin: readonly [number, number, number];
  readonly direction: readonly [number, number, number];
}

/** Thin things can be met, too [m]. */
const LEAST = 0.004;

/** Where a line enters a box around `at`; null where it passes by or the box lies behind. */
function enters(line: Straight, at: Part["at"], size: Part["size"]): number | null {
  let [near, far] = [Number.NEGATIVE_INFINITY, Number.POSITIVE_INFINITY];
  for (const k of [0, 1, 2] as const) {
    const half = Math.max(size[k], LEAST) / 2;
    const [from, along] = [line.origin[k] - at[k], line.direction[k]];
    if (along === 0) {
      if (Math.abs(from) > half) return null;
      continue;
    }
    const [a, b] = [(-half - from) / along, (half - from) / along];
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near > far || far < 0 ? null : Math.max(near, 0);
}

/** The line in a body's own frame. */
function straightIn(body: PlacedBody, { origin, direction }: Straight): Straight {
  return { origin: inFrameOf(body, origin), direction: inFrameOf({ ...body, x: 0, y: 0, z: 0 }, direction) };
}

/** The line as a part sees it that has moved with a front. */
function before(line: Straight, swing: Swing): Straight {
  const back = backwards(swing);
  return { origin: movedWith(line.origin, back), direction: turnedWith(line.direction, back) };
}

/** Where a line meets a body: how far along [m], and the front that the part met belongs to. */
export interface Met {
  readonly distance: number;
  readonly front: string | undefined;
}

/** Where a line meets a body whose fronts may stand open; null where it does not. */
export function meetsOpen(line: Straight, body: PlacedBody, parts: readonly Part[], swingOf: (front: string | undefined) => Swing | undefined): Met | null {
  const own = straightIn(body, line);
  let nearest: Met | null = null;
  for (const { front, at, size } of parts) {
    const swing = swingOf(front);
    const distance = enters(swing ? before(own, swing) : own, at, size);
    if (distance !== null && (nearest === null || distance < nearest.distance)) nearest = { distance, front };
  }
  return nearest;
}

/** How far along a line it meets a body [m], null where it does not. */
export function meets(line: Straight, body: PlacedBody, parts: readonly Part[]): number | null {
  const own = straightIn(body, line);
  const reach = body.seat ?? 0;
  const [width, height, depth] = [body.width, body.height + reach, body.depth + 2 * reach];
  if (enters(own, [0, body.height / 2 - reach / 2, 0], [width + LEAST, height + 0.02, depth + LEAST]) === null) return null;
  const distances = parts.flatMap((part) => enters(own, part.at, part.size) ?? []);
  return distances.length > 0 ? Math.min(...distances) : null;
}
