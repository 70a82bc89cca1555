/** A room's clear floor: its outline moved in to the faces of its walls, as the plan measures it. Pure. */
import type { Room } from "../contract";
import { areaOf, cornersOf, edgesOf, onLattice } from "./plan";
import type { Run } from "./wall_runs";

/** The clear floor's area [m²], and its whole extent from west to east and from north to south [m]. */
export interface ClearFloor {
  readonly area: number;
  readonly width: number;
  readonly depth: number;
}

function isSlanting(room: Room): boolean {
  const corners = cornersOf(room);
  return corners.some(([x, z], i) => { const [nextX, nextZ] = corners[(i + 1) % corners.length] ?? [x, z]; return x !== nextX && z !== nextZ; });
}

/** The clear floor of a room, between the walls of its house, by half a thickness [m] within its lines where it has none; with a slanting wall all within its outline. */
export function clearFloorOf(room: Room, runs: readonly Run[], thickness: number): ClearFloor {
  if (isSlanting(room)) return { area: areaOf(room), width: room.width, depth: room.depth };
  const walls = runs.filter(({ kind, level }) => kind === "wall" && level === room.level);
  const lines = edgesOf(room).filter(({ from, to }) => to > from).map(({ axis, line, from, to, inward }) => {
    const near = walls.filter((wall) => wall.axis === axis && Math.abs(wall.line - line) <= wall.thickness / 2 + 1e-9 && wall.from < to && wall.to > from);
    const [wall] = near.sort((a, b) => Math.abs(a.line - line) - Math.abs(b.line - line));
    return { axis, at: wall ? wall.line + (inward * wall.thickness) / 2 : line + (inward * thickness) / 2 };
  });
  const turning = lines.filter(({ axis }, i) => axis !== lines.at(i - 1)?.axis);
  const corners = turning.map(({ axis, at }, i) => {
    const before = turning.at(i - 1)?.at ?? at;
    return axis === "x" ? [before, at] as const : [at, before] as const;
  });
  const doubled = corners.reduce((sum, [x, z], i) => {
    const [nextX, nextZ] = corners[(i + 1) % corners.length] ?? [x, z];
    return sum + x * nextZ - nextX * z;
  }, 0);
  const extent = (of: readonly number[]): number => onLattice(Math.max(0, ...of) - Math.min(...of, Infinity));
  return { area: Math.abs(doubled) / 2, width: extent(corners.map(([x]) => x)), depth: extent(corners.map(([, z]) => z)) };
}
