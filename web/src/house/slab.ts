/** The slab that a house stands on: under each room of the lowest storey, a little wider than it. */
import { BoxGeometry, Mesh, MeshStandardMaterial } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import type { Room } from "../contract";
import { keptMaterial } from "./kept";
import { cornersOf } from "./plan";

export const SLAB_MARGIN = 0.35;
const THICKNESS = 0.16;
/** Floors lie this much over the slab, so that the two never fight for a pixel. */
const GAP = 0.02;

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
  const boxes = rooms.filter(({ level }) => level === lowest).flatMap(stripsOf).map(({ x0, x1, z0, z1 }) => {
    const box = new BoxGeometry(x1 - x0 + 2 * SLAB_MARGIN, THICKNESS, z1 - z0 + 2 * SLAB_MARGIN);
    return box.translate((x0 + x1) / 2, y - THICKNESS / 2 - GAP, (z0 + z1) / 2);
  });
  if (boxes.length === 0) return null;
  const mesh = new Mesh(mergeGeometries(boxes), keptMaterial("slab", () => new MeshStandardMaterial({ color: "#9a9d9f", roughness: 1 })));
  mesh.receiveShadow = true;
  for (const box of boxes) box.dispose();
  return mesh;
}
