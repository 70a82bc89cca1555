/** What lies on both sides of an opening. Pure. */
import type { Room } from "../contract";
import type { PlacedOpening } from "./openings";
import { roomHolding } from "./room_at";

/** How far before a wall one asks for the room [m]. */
const BEFORE = 0.15;

/** The rooms before an opening: towards greater coordinates of its line, then towards smaller. */
export function roomsBeside(rooms: readonly Room[], { axis, line, thickness, from, to, level }: PlacedOpening): [Room | undefined, Room | undefined] {
  const middle = (from + to) / 2;
  const at = (across: number): Room | undefined =>
    axis === "x" ? roomHolding(rooms, level, middle, across) : roomHolding(rooms, level, across, middle);
  const away = thickness / 2 + BEFORE;
  return [at(line + away), at(line - away)];
}

/** The side of an opening's line, 1 towards greater coordinates, that lies in a room under a roof. */
export function inwardOf(rooms: readonly Room[], opening: PlacedOpening): 1 | -1 {
  const [greater, smaller] = roomsBeside(rooms, opening);
  if (greater && !greater.outdoor) return 1;
  return smaller && !smaller.outdoor ? -1 : 1;
}
