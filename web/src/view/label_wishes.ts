/** How much a label matters, and whether it is shown to who walks. Pure. */
import type { Point } from "../house/wall_faces";
import type { LabelElement } from "./label_elements";
import type { LabelWish } from "./label_layout";
import type { Pose } from "./walk";
import { gazeOf } from "./walk";

/** A label asked for in a frame; one that finds no place keeps its dot or is left out. */
export interface Asked extends LabelWish {
  readonly label: LabelElement;
  readonly keepsDot?: boolean;
  /** It is its dot even where it would find a place. */
  readonly isDot?: boolean;
}

/** Words of what is wrong come first, then what is pointed at, then what is chosen, then rooms, then pieces. */
export const RANK = { mark: 4e6, tip: 3.5e6, chosen: 3e6, room: 2e6, piece: 0 } as const;

/** Who walks reads no names further away than this [m]. */
const ROOMS_WITHIN = 9;
const MOST_AHEAD = 4;
/** Less than this ahead a name would hang before one's nose [m]. */
const NEAREST = 0.6;

/** How far a point is from one's eyes, in the plan [m]; null behind them. */
export function aheadBy(pose: Pose, [x, , z]: Point): number | null {
  const gaze = gazeOf(pose);
  const [dx, dz] = [x - pose.eye[0], z - pose.eye[2]];
  return (dx * gaze[0] + dz * gaze[2]) / Math.hypot(gaze[0], gaze[2]) > NEAREST ? Math.hypot(dx, dz) : null;
}

/** The rooms whose names are shown to who walks: those near, ahead and in sight, the nearest first. */
export function roomsAhead<Room extends { readonly at: Point }>(pose: Pose, rooms: readonly Room[], isSeen: (room: Room) => boolean): Room[] {
  return rooms
    .flatMap((room) => {
      const distance = aheadBy(pose, room.at);
      return distance !== null && distance < ROOMS_WITHIN && isSeen(room) ? [{ room, distance }] : [];
    })
    .sort((a, b) => a.distance - b.distance)
    .slice(0, MOST_AHEAD)
    .map(({ room }) => room);
}

/** How large a piece looks: its longest side over its distance. */
export function sizeSeen({ width, depth, height }: { width: number; depth: number; height: number }, distance: number): number {
  return Math.max(width, depth, height / 2) / Math.max(0.5, distance);
}
