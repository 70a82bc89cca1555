/** On which side of an opening the house is. Pure. */
import type { Room } from "../contract";
import type { PlacedOpening } from "./openings";
import { roomHolding } from "./room_at";

/** How far before a wall one asks for the room [m]. */
const BEFORE = 0.2;

/** The side of an opening's line, 1 towards greater coordinates, that lies in a room under a roof. */
export function inwardOf(rooms: readonly Room[], { axis, line, from, to, level }: PlacedOpening): 1 | -1 {
  const middle = (from + to) / 2;
  const indoors = ([1, -1] as const).find((side) => {
    const across = line + side * BEFORE;
    const room = axis === "x" ? roomHolding(rooms, level, middle, across) : roomHolding(rooms, level, across, middle);
    return room && !room.outdoor;
  });
  return indoors ?? 1;
}
