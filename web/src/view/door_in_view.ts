/** Which door a key opens or closes: the one in the middle of what is looked at. */
import { Vector3 } from "three";
import type { House } from "../house/house";
import type { Viewport } from "./viewport";

/** Where walls are cut a doorway is looked for at this height over its floor [m]. */
const HALF_WAY = 0.6;
/** Just before the wall that the door is in, seen from where one stands: a share of the way there. */
const BEFORE = 0.99;

interface Candidate {
  readonly id: string;
  readonly index: number;
  /** From the middle of the canvas [CSS pixels], or from who walks [m]. */
  readonly distance: number;
}

/** The doorways on the canvas, the nearest to its middle first; to who walks those in sight, the nearest first. */
function candidates(house: House, viewport: Viewport): Candidate[] {
  const { pose, size: { width, height } } = viewport;
  return house.doorways.flatMap(({ id, index, at: [x, y, z] }): Candidate[] => {
    const at = new Vector3(x, pose ? pose.eye[1] : y + HALF_WAY, z);
    const on = viewport.project(at);
    if (!on || on.x < 0 || on.y < 0 || on.x > width || on.y > height) return [];
    if (!pose) return [{ id, index, distance: Math.hypot(on.x - width / 2, on.y - height / 2) }];
    const eye = new Vector3(...pose.eye);
    const before = eye.clone().lerp(at, BEFORE);
    return house.sees(pose.eye, before.toArray()) ? [{ id, index, distance: eye.distanceTo(at) }] : [];
  }).sort((a, b) => a.distance - b.distance);
}

/** The number of the leaf; undefined where no door is in view. One that stands open may be hidden: it is still to be closed. */
export function doorInView(house: House, viewport: Viewport, isSeen: (id: string) => boolean): number | undefined {
  const open = new Set(house.doors.open);
  return candidates(house, viewport).find(({ id }) => viewport.pose !== null || open.has(id) || isSeen(id))?.index;
}
