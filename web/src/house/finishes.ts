/** What the faces of walls are finished with: that of the room that a face looks into. Pure. */
import type { Room, Side } from "../contract";
import type { Span } from "./boxes";
import { cornersOf } from "./plan";
import { sideBeyond } from "./wall_cut";
import type { Face } from "./wall_faces";
import type { WallPanel } from "./wall_panel";

/** How far before a face the room is that it belongs to [m]. */
const BEFORE = 0.02;
/** How far a wall reaches at most into the one that it meets [m]. */
const REACH = 0.45;

interface Outline {
  readonly corners: readonly (readonly [number, number])[];
  readonly x: Span;
  readonly z: Span;
  /** Whether it fills those spans. */
  readonly whole: boolean;
}

/** Walls ask for every room's outline at every face: each is made once. */
const outlines = new WeakMap<Room, Outline>();

function outlined(room: Room): Outline {
  const corners = cornersOf(room).map(([x, z]) => [room.x + x, room.z + z] as const);
  const spanOf = (values: readonly number[]): Span => ({ from: Math.min(...values), to: Math.max(...values) });
  return { corners, whole: !room.outline, x: spanOf(corners.map(([x]) => x)), z: spanOf(corners.map(([, z]) => z)) };
}

function outlineOf(room: Room): Outline {
  const outline = outlines.get(room) ?? outlined(room);
  outlines.set(room, outline);
  return outline;
}

type Ends = Readonly<Record<WallPanel["axis"], readonly number[]>>;

const ends = new WeakMap<readonly Room[], Ends>();

/** Where rooms with a finish end, each place once [m]. */
function endsOf(rooms: readonly Room[]): Ends {
  const known = ends.get(rooms);
  if (known) return known;
  const corners = rooms.filter((room) => room.walls).flatMap((room) => outlineOf(room).corners);
  const found = { x: [...new Set(corners.map(([x]) => x))], z: [...new Set(corners.map(([, z]) => z))] };
  ends.set(rooms, found);
  return found;
}

/** Where along a panel the finish may change: at the corners of rooms [m]. */
export function seamsOf(rooms: readonly Room[], axis: WallPanel["axis"], along: Span): number[] {
  return endsOf(rooms)[axis].filter((end) => along.from < end && end < along.to);
}

/** Towards which side a wall looks outside at a place along it [m]: one side of it is indoors, the other is not; else null. */
export function outwardOf({ axis, across, level }: Pick<WallPanel, "axis" | "across" | "level">, at: number, rooms: readonly Room[]): Side | null {
  const isIndoors = (beyond: number): boolean => {
    const [x, z] = axis === "x" ? [at, beyond] : [beyond, at];
    return rooms.some((room) => room.level === level && !room.outdoor && holds(room, x, z));
  };
  const [lower, greater] = [isIndoors(across.from - BEFORE), isIndoors(across.to + BEFORE)];
  return lower === greater ? null : sideBeyond(axis, lower ? 1 : -1);
}

/** A wall that looks outside towards one side, or nowhere. */
export interface OuterPanel extends WallPanel {
  readonly outward: Side | null;
}

/** A wall by its pieces that look outside to one side each, or to none. */
export function outerPiecesOf(panel: WallPanel, rooms: readonly Room[]): OuterPanel[] {
  const { axis, along } = panel;
  const corners = rooms.flatMap((room) => outlineOf(room).corners.map(([x, z]) => (axis === "x" ? x : z)));
  const inner = [...new Set(corners)].filter((corner) => along.from + REACH < corner && corner < along.to - REACH).sort((a, b) => a - b);
  const pieces: OuterPanel[] = [];
  for (const [i, to] of [...inner, along.to].entries()) {
    const from = inner[i - 1] ?? along.from;
    const outward = outwardOf(panel, (from + to) / 2, rooms);
    const last = pieces.at(-1);
    if (last?.outward === outward) pieces[pieces.length - 1] = { ...last, along: { from: last.along.from, to } };
    else pieces.push({ ...panel, along: { from, to }, outward });
  }
  return pieces;
}

/** Whether a point of the plan [m] is within a room's outline. */
export function holds(room: Room, x: number, z: number): boolean {
  const { corners, x: across, z: along, whole } = outlineOf(room);
  if (x < across.from || x > across.to || z < along.from || z > along.to) return false;
  if (whole) return true;
  return corners.reduce((inside, [x0, z0], i) => {
    const [x1, z1] = corners[(i + 1) % corners.length] ?? [x0, z0];
    const crosses = z0 > z !== z1 > z && x < x0 + ((z - z0) / (z1 - z0)) * (x1 - x0);
    return crosses ? !inside : inside;
  }, false);
}

export type Finish = NonNullable<Room["walls"]>;

/** The finish of the side of a wall; null outside, at jambs and tops, and where the room does not say. */
export function finishOf(face: Face, panel: WallPanel, rooms: readonly Room[]): Finish | null {
  const [nx, ny, nz] = face.normal;
  if (ny !== 0 || (panel.axis === "x" ? nx : nz) !== 0) return null;
  const [a, , c] = face.corners;
  const [x, z] = [(a[0] + c[0]) / 2 + nx * BEFORE, (a[2] + c[2]) / 2 + nz * BEFORE];
  return rooms.find((room) => room.level === panel.level && holds(room, x, z))?.walls ?? null;
}
