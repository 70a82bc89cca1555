/** Which room's floor a ray meets. Pure. */
import type { Room } from "../contract";
import { holds } from "./finishes";
import type { PlacedBody } from "./frame";
import type { Point } from "./wall_faces";
import type { Storey } from "./walls";

/** A body whose middle is no higher than this over the floor is walked on [m]. */
const FLAT = 0.03;

export interface FloorHit {
  readonly room: Room;
  /** From the ray's origin, in lengths of its direction. */
  readonly distance: number;
}

/** The room of a level that holds a point of the plan [m]. */
export function roomHolding(rooms: readonly Room[], level: number, x: number, z: number): Room | undefined {
  return rooms.find((room) => room.level === level && holds(room, x, z));
}

/** The first floor that a ray coming from above meets. */
export function floorUnder(
  rooms: readonly Room[], storeys: ReadonlyMap<number, Storey>, origin: Point, direction: Point,
): FloorHit | null {
  if (direction[1] >= 0) return null;
  const hits = [...storeys].flatMap(([level, { elevation }]) => {
    const distance = (elevation - origin[1]) / direction[1];
    const room = distance > 0 ? roomHolding(rooms, level, origin[0] + direction[0] * distance, origin[2] + direction[2] * distance) : undefined;
    return room ? [{ room, distance }] : [];
  });
  return hits.sort((a, b) => a.distance - b.distance)[0] ?? null;
}

/** Whether a body lies flat on a floor, as rugs and mats do. */
export function liesFlat({ y, height }: Pick<PlacedBody, "y" | "height">, storeys: ReadonlyMap<number, Storey>): boolean {
  return [...storeys.values()].some(({ elevation }) => Math.abs(y + height / 2 - elevation) <= FLAT);
}
