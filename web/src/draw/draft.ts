/** A plan that is being drawn: rooms of corners, openings on wall lines. Every change makes a new one. */
import type { OpeningKind, Room } from "../contract";
import { areOverlapping, boxOf, combined, isSound, shifted, wallsOf, withWallAt, type Axis, type Box, type Corners, type Point, type Wall } from "./corners";

export interface DraftRoom {
  readonly id: string;
  /** A room type of the catalog; null: to be guessed. */
  readonly type: string | null;
  readonly corners: Corners;
  /** The room of the scene that it comes from, with all that stands in it. */
  readonly from: Room | null;
}

/** A door, passage or window: a stretch of a wall line [mm]. */
export interface DraftOpening {
  readonly id: string;
  readonly kind: OpeningKind;
  readonly axis: Axis;
  readonly line: number;
  readonly from: number;
  readonly to: number;
  readonly height: number;
  readonly sill: number;
  /** The end that carries the leaf. */
  readonly hinge: "start" | "end";
  /** Into which side of the line the leaf swings: 1 towards greater coordinates. */
  readonly swing: 1 | -1;
  readonly isMainEntrance: boolean;
}

export interface Draft {
  readonly rooms: readonly DraftRoom[];
  readonly openings: readonly DraftOpening[];
}

export const EMPTY: Draft = { rooms: [], openings: [] };

/** The least side of a room, and how near to a corner an opening may come [mm]. */
const LEAST_SIDE = 500;
const JAMB = 50;
/** How far apart the lines of two rooms may be that have a wall in common [mm]. */
const THICKEST = 600;

/** Sizes of what is put into a wall [mm]. */
export const OPENING_SIZES: Readonly<Record<OpeningKind, { readonly width: number; readonly height: number; readonly sill: number }>> = {
  door: { width: 900, height: 2100, sill: 0 },
  passage: { width: 1200, height: 2100, sill: 0 },
  garage_door: { width: 2500, height: 2100, sill: 0 },
  window: { width: 1400, height: 1200, sill: 900 },
};

/** A wall of a room of the plan. */
export interface RoomWall extends Wall {
  readonly room: DraftRoom;
}

export function allWalls({ rooms }: Draft): RoomWall[] {
  return rooms.flatMap((room) => wallsOf(room.corners).map((wall) => ({ ...wall, room })));
}

type Stretch = Pick<Wall, "axis" | "line" | "from" | "to">;

function isOnSameLine(a: Stretch, b: Stretch): boolean {
  return a.axis === b.axis && a.line === b.line;
}

/** The walls that an opening is in: of one room, or of two, on its line or beyond a wall as thick as the lines lie apart. */
export function wallsAt(draft: Draft, opening: Stretch): RoomWall[] {
  const along = allWalls(draft).filter((wall) => wall.axis === opening.axis && wall.from <= opening.from && opening.to <= wall.to);
  const here = along.filter((wall) => isOnSameLine(wall, opening));
  const [only, other] = here;
  if (!only || other) return here;
  const [beyond] = along
    .map((wall) => ({ wall, gap: (only.line - wall.line) * only.inward }))
    .filter(({ wall, gap }) => wall.inward === -only.inward && wall.room.id !== only.room.id && gap > 0 && gap <= THICKEST)
    .sort((a, b) => a.gap - b.gap);
  return beyond ? [only, beyond.wall] : here;
}

/** Whether the sides of a room are long enough for one, and no two rooms share floor. */
function isTenable(draft: Draft): boolean {
  const tooSmall = ({ corners }: DraftRoom): boolean => {
    const { x0, z0, x1, z1 } = boxOf(corners);
    return x1 - x0 < LEAST_SIDE || z1 - z0 < LEAST_SIDE || !isSound(corners);
  };
  if (draft.rooms.some(tooSmall)) return false;
  return draft.rooms.every((a, i) => draft.rooms.slice(i + 1).every((b) => !areOverlapping(a.corners, b.corners)));
}

function freeId(stem: string, taken: ReadonlySet<string>): string {
  for (let number = 1; ; number += 1) if (!taken.has(`${stem}_${number}`)) return `${stem}_${number}`;
}

/** The openings that still lie in a wall, moved along it where it has become too short at their end. */
function settled(draft: Draft): Draft {
  const openings = draft.openings.flatMap((opening) => {
    if (wallsAt(draft, opening).length > 0) return [opening];
    const width = opening.to - opening.from;
    const [nearest] = allWalls(draft)
      .filter((wall) => isOnSameLine(wall, opening) && wall.to - wall.from >= width + 2 * JAMB && wall.from < opening.to && opening.from < wall.to)
      .map((wall) => Math.max(wall.from + JAMB, Math.min(wall.to - JAMB - width, opening.from)))
      .sort((a, b) => Math.abs(a - opening.from) - Math.abs(b - opening.from));
    return nearest === undefined ? [] : [{ ...opening, from: nearest, to: nearest + width }];
  });
  return { ...draft, openings };
}

/** The plan, where rooms stay rooms; null where they do not. */
function tenable(draft: Draft): Draft | null {
  return isTenable(draft) ? settled(draft) : null;
}

export function withRoom(draft: Draft, corners: Corners, type: string | null = null): { readonly draft: Draft; readonly id: string } | null {
  const id = freeId("room", new Set(draft.rooms.map((room) => room.id)));
  const drawn = tenable({ ...draft, rooms: [...draft.rooms, { id, type, corners, from: null }] });
  return drawn && { draft: drawn, id };
}

function withChanged(draft: Draft, id: string, change: (room: DraftRoom) => DraftRoom): Draft {
  return { ...draft, rooms: draft.rooms.map((room) => (room.id === id ? change(room) : room)) };
}

export function withType(draft: Draft, id: string, type: string | null): Draft {
  return withChanged(draft, id, (room) => ({ ...room, type }));
}

/** A room with a rectangle added or cut away. */
export function reshaped(draft: Draft, id: string, box: Box, how: "add" | "cut"): Draft | null {
  const corners = draft.rooms.find((room) => room.id === id)?.corners;
  const shape = corners && combined(corners, box, how);
  return shape ? tenable(withChanged(draft, id, (room) => ({ ...room, corners: shape }))) : null;
}

export function withoutRoom(draft: Draft, id: string): Draft {
  return settled({ ...draft, rooms: draft.rooms.filter((room) => room.id !== id) });
}

/** A room elsewhere, with what stands in it and the openings that are in its walls alone. */
export function roomMoved(draft: Draft, id: string, dx: number, dz: number): Draft | null {
  const own = new Set(draft.openings.filter((opening) => wallsAt(draft, opening).every((wall) => wall.room.id === id)).map((opening) => opening.id));
  const along = (from: Room | null): Room | null => from && { ...from, x: from.x + dx / 1000, z: from.z + dz / 1000 };
  const rooms = withChanged(draft, id, (room) => ({ ...room, corners: shifted(room.corners, dx, dz), from: along(room.from) })).rooms;
  const openings = draft.openings.map((opening) => {
    if (!own.has(opening.id)) return opening;
    const [off, by] = opening.axis === "x" ? [dz, dx] : [dx, dz];
    return { ...opening, line: opening.line + off, from: opening.from + by, to: opening.to + by };
  });
  return tenable({ rooms, openings });
}

/** All walls of other rooms that make one wall with this: on its line, each touching the next over some length. */
function runOf(draft: Draft, wall: RoomWall): RoomWall[] {
  const onLine = allWalls(draft).filter((other) => isOnSameLine(other, wall));
  const run = onLine.filter((other) => other.room.id === wall.room.id && other.index === wall.index);
  for (let before = 0; before !== run.length;) {
    before = run.length;
    for (const other of onLine) {
      const isPart = !run.includes(other) && run.some((one) => one.inward !== other.inward && one.from < other.to && other.from < one.to);
      if (isPart) run.push(other);
    }
  }
  return run;
}

/** A wall at another line, with the rooms on both sides of it, or this room alone; what is in it goes along. */
export function wallMoved(draft: Draft, id: string, index: number, line: number, alone = false): Draft | null {
  const wall = allWalls(draft).find((one) => one.room.id === id && one.index === index);
  if (!wall) return null;
  const run = alone ? [wall] : runOf(draft, wall);
  let rooms = draft.rooms;
  for (const { room } of run) {
    const current = rooms.find((one) => one.id === room.id) as DraftRoom;
    const at = wallsOf(current.corners).find((one) => one.axis === wall.axis && one.line === wall.line && run.some((part) => part.room.id === room.id && part.from === one.from && part.to === one.to));
    const corners = at && withWallAt(current.corners, at.index, line);
    if (!corners) return null;
    rooms = rooms.map((one) => (one.id === room.id ? { ...one, corners } : one));
  }
  const goesAlong = (opening: DraftOpening): boolean => isOnSameLine(opening, wall) && run.some((part) => part.from <= opening.from && opening.to <= part.to);
  return tenable({ rooms, openings: draft.openings.map((opening) => (goesAlong(opening) ? { ...opening, line } : opening)) });
}

/** Where an opening of a width comes to lie in the wall nearest to a point, within reach [mm]; null where none takes it. */
export function placeInWall(draft: Draft, at: Point, width: number, reach: number): (Stretch & { readonly wall: RoomWall }) | null {
  const [nearest] = allWalls(draft)
    .filter((wall) => wall.to - wall.from >= width + 2 * JAMB)
    .map((wall) => {
      const [across, along] = wall.axis === "x" ? [at.z, at.x] : [at.x, at.z];
      return { wall, off: Math.hypot(across - wall.line, Math.max(0, wall.from - along, along - wall.to)), along };
    })
    .filter(({ off }) => off <= reach)
    .sort((a, b) => a.off - b.off || a.wall.to - a.wall.from - (b.wall.to - b.wall.from));
  if (!nearest) return null;
  const { wall, along } = nearest;
  const from = Math.round(Math.max(wall.from + JAMB, Math.min(wall.to - JAMB - width, along - width / 2)));
  return { axis: wall.axis, line: wall.line, from, to: from + width, wall };
}

function isFree(draft: Draft, place: Stretch, except: string): boolean {
  return !draft.openings.some((other) => other.id !== except && isOnSameLine(other, place) && other.from < place.to && place.from < other.to);
}

/** The plan with an opening put into the wall nearest to a point. */
export function withOpening(draft: Draft, kind: OpeningKind, at: Point, reach: number): { readonly draft: Draft; readonly id: string } | null {
  const size = OPENING_SIZES[kind];
  const place = placeInWall(draft, at, size.width, reach);
  if (!place || !isFree(draft, place, "")) return null;
  const id = freeId(kind, new Set(draft.openings.map((opening) => opening.id)));
  const { axis, line, from, to } = place;
  const { height, sill } = size;
  const isFirstWayOut = kind === "door" && wallsAt(draft, place).length === 1 && !draft.openings.some((opening) => opening.isMainEntrance);
  const opening: DraftOpening = { id, kind, axis, line, from, to, height, sill, hinge: "start", swing: place.wall.inward, isMainEntrance: isFirstWayOut };
  return { draft: { ...draft, openings: [...draft.openings, opening] }, id };
}

/** An opening in the wall nearest to a point. */
export function openingMoved(draft: Draft, id: string, at: Point, reach: number): Draft | null {
  const opening = draft.openings.find((one) => one.id === id);
  const place = opening && placeInWall(draft, at, opening.to - opening.from, reach);
  if (!place || !isFree(draft, place, id)) return null;
  const { axis, line, from, to } = place;
  return withOpeningChanged(draft, id, { axis, line, from, to });
}

/** An opening with other properties; null where it would leave its wall or meet another. */
export function withOpeningChanged(draft: Draft, id: string, change: Partial<DraftOpening>): Draft | null {
  const changed = draft.openings.map((one) => (one.id === id ? { ...one, ...change } : change.isMainEntrance ? { ...one, isMainEntrance: false } : one));
  const opening = changed.find((one) => one.id === id);
  const next = { ...draft, openings: changed };
  return opening && opening.from < opening.to && wallsAt(next, opening).length > 0 && isFree(next, opening, id) ? next : null;
}

export function withoutOpening(draft: Draft, id: string): Draft {
  return { ...draft, openings: draft.openings.filter((opening) => opening.id !== id) };
}

/** A wall of a length [mm]: the wall at its eastern or southern end moves. */
export function wallLengthened(draft: Draft, id: string, index: number, length: number): Draft | null {
  const walls = wallsOf(draft.rooms.find((room) => room.id === id)?.corners ?? []);
  const wall = walls[index];
  const ends = wall ? [walls.at(index - 1), walls[(index + 1) % walls.length]] : [];
  const end = ends.find((other) => other?.line === wall?.to);
  return wall && end ? wallMoved(draft, id, end.index, wall.from + length) : null;
}
