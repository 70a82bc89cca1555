/** The points of a house that must be in view to see all of it: its ground and what stands on it. Pure. */
import type { Room } from "../contract";
import type { PlacedBody } from "./frame";
import { cornersOf } from "./plan";
import type { Point } from "./wall_faces";
import type { Storey } from "./walls";

/** Walls are looked at cut about here [m]. */
const CUT = 1.2;

/** The ground that is looked at where there is no room [m]. */
export const PLOT = { width: 12, depth: 9 } as const;

/** `margin` is how far the ground reaches beyond the rooms [m]. */
export function outlineOf(rooms: readonly Room[], storeys: ReadonlyMap<number, Storey>, bodies: readonly PlacedBody[], margin: number): Point[] {
  const floors = rooms.flatMap((room) => cornersOf(room).flatMap(([x, z]): Point[] => {
    const [at, y] = [[room.x + x, room.z + z] as const, storeys.get(room.level)?.elevation ?? 0];
    const ground = [-margin, margin].flatMap((dx) => [-margin, margin].map((dz): Point => [at[0] + dx, y, at[1] + dz]));
    return [...ground, [at[0], y + CUT, at[1]]];
  }));
  const tall = bodies.filter(({ y, height }) => y + height > CUT).flatMap(({ x, y, z, width, depth, height }) => {
    const half = Math.max(width, depth) / 2;
    return [-half, half].flatMap((dx) => [-half, half].map((dz): Point => [x + dx, y + height, z + dz]));
  });
  return floors.length > 0 ? [...floors, ...tall] : [0, PLOT.width].flatMap((x) => [0, PLOT.depth].map((z): Point => [x, 0, z]));
}
