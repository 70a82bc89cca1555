/** Rooms' edges: the lines of their outlines in the house. Pure. */
import type { Room, Side } from "../contract";
import type { Axis } from "./boxes";

/** One edge of a room's outline, in house coordinates [m]. */
export interface Edge {
  readonly level: number;
  readonly axis: Axis;
  /** The coordinate across the axis: z of an edge along x, x of an edge along z. */
  readonly line: number;
  readonly from: number;
  readonly to: number;
  /** On which side of the line the room lies: 1 towards greater coordinates, -1 towards smaller. */
  readonly inward: 1 | -1;
  readonly side: Side;
  readonly room: Room;
  /** Which of the room's edges it is, in the order of its outline's points. */
  readonly number: number;
}

/** Millimetres are the lattice of every plan; rounding to it undoes what adding metres in binary does. */
export function onLattice(metres: number): number {
  return Math.round(metres * 1000) / 1000;
}

/** A room's corners, room-relative, clockwise from the north-west. */
export function cornersOf(room: Room): readonly (readonly [number, number])[] {
  if (room.outline && room.outline.length >= 3) return room.outline;
  return [[0, 0], [room.width, 0], [room.width, room.depth], [0, room.depth]];
}

/** The area within corners [m²]: negative where they go counter-clockwise, as those of others may. */
function signedArea(corners: ReturnType<typeof cornersOf>): number {
  const twice = corners.reduce((sum, [x, z], i) => {
    const [nextX, nextZ] = corners[(i + 1) % corners.length] ?? [x, z];
    return sum + x * nextZ - nextX * z;
  }, 0);
  return twice / 2;
}

/** The floor within a room's outline [m²]. */
export function areaOf(room: Room): number {
  return Math.abs(signedArea(cornersOf(room)));
}

function edgeBetween(room: Room, a: readonly [number, number], b: readonly [number, number], clockwise: boolean, number: number): Edge {
  const alongX = Math.abs(b[0] - a[0]) >= Math.abs(b[1] - a[1]);
  const forwards = (alongX ? b[0] > a[0] : b[1] > a[1]) === clockwise;
  const [origin, across] = alongX ? [room.x, room.z + a[1]] : [room.z, room.x + a[0]];
  const ends = alongX ? [a[0], b[0]] : [a[1], b[1]];
  const side: Side = alongX ? (forwards ? "north" : "south") : forwards ? "east" : "west";
  return {
    level: room.level,
    axis: alongX ? "x" : "z",
    line: onLattice(across),
    from: onLattice(origin + Math.min(...ends)),
    to: onLattice(origin + Math.max(...ends)),
    inward: side === "north" || side === "west" ? 1 : -1,
    side,
    room,
    number,
  };
}

/** A room's edges in the order of its outline's points (north, east, south, west for a rectangle). */
export function edgesOf(room: Room): Edge[] {
  const corners = cornersOf(room);
  const clockwise = signedArea(corners) >= 0;
  return corners.map((corner, i) => edgeBetween(room, corner, corners[(i + 1) % corners.length] ?? corner, clockwise, i));
}

export function lineKey(on: { level: number; axis: Axis; line: number }): string {
  return `${on.level}:${on.axis}:${on.line}`;
}

/** Groups things by the wall line they lie on. */
export function byLine<T extends { level: number; axis: Axis; line: number }>(things: readonly T[]): Map<string, T[]> {
  const groups = new Map<string, T[]>();
  for (const thing of things) {
    const group = groups.get(lineKey(thing));
    if (group) group.push(thing);
    else groups.set(lineKey(thing), [thing]);
  }
  return groups;
}
