/** The slab that a house stands on: under each room of the lowest storey, a little wider than it. */
import { Mesh } from "three";
import type { Room } from "../contract";
import { cornersOf } from "./plan";
import { mergeQuads, quadsOf } from "./quad_mesh";
import { faceMaterial } from "./wall_shader";

export const SLAB_MARGIN = 0.35;
const THICKNESS = 0.16;
const COLOR = "#9a9d9f";
/** Floors lie this much over the slab, so that the two never fight for a pixel. */
const GAP = 0.02;
/** Drawn after the floors that hide it. */
const BEHIND = 2;

/** A rectangle of the ground [m]. */
export interface Ground {
  readonly x0: number;
  readonly x1: number;
  readonly z0: number;
  readonly z1: number;
}

/** The floor of a room as rectangles: between two lines across it, from wall to wall in the middle of them. */
export function stripsOf(room: Room): Ground[] {
  const corners = cornersOf(room).map(([x, z]) => [room.x + x, room.z + z] as const);
  const cuts = [...new Set(corners.map(([, z]) => z))].sort((a, b) => a - b);
  return cuts.slice(1).flatMap((z1, i) => {
    const z0 = cuts[i] as number;
    const middle = (z0 + z1) / 2;
    const walls = corners.flatMap(([ax, az], k) => {
      const [bx, bz] = corners[(k + 1) % corners.length] ?? [ax, az];
      return az < middle !== bz < middle ? [ax + ((bx - ax) * (middle - az)) / (bz - az)] : [];
    }).sort((a, b) => a - b);
    return walls.flatMap((x0, k) => (k % 2 === 0 ? [{ x0, x1: walls[k + 1] ?? x0, z0, z1 }] : []));
  });
}

/** The slab under rooms, its top under the ground `y` [m]; null where there are none. */
export function slab(rooms: readonly Room[], y: number): Mesh | null {
  const lowest = Math.min(...rooms.map(({ level }) => level));
  const top = y - GAP;
  const quads = rooms.filter(({ level }) => level === lowest).flatMap(stripsOf).flatMap(({ x0, x1, z0, z1 }) => quadsOf(
    { x0: x0 - SLAB_MARGIN, x1: x1 + SLAB_MARGIN, y0: top - THICKNESS, y1: top, z0: z0 - SLAB_MARGIN, z1: z1 + SLAB_MARGIN }, COLOR,
  ));
  if (quads.length === 0) return null;
  const mesh = new Mesh(mergeQuads(quads), faceMaterial("slab"));
  Object.assign(mesh, { receiveShadow: true, renderOrder: BEHIND });
  return mesh;
}
