/** A plan that is being drawn: rooms of corners, openings on wall lines. Every change makes a new one. */
import type { OpeningKind, Room, Scene } from "../contract";
import { areOverlapping, boxOf, combined, isSound, shifted, wallsOf, withWallAt, type Axis, type Box, type Corners, type Point, type Wall } from "./corners";

export interface DraftRoom {
  readonly id: string;
  /** A room type of the catalog; null: to be guessed, by the name where it has one. */
  readonly type: string | null;
  /** What it is called; "": nothing. */
  readonly name: string;
  readonly outdoor: boolean;
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
  /** The scene that it was taken from. */
  readonly base: Scene | null;
}

export const EMPTY: Draft = { rooms: [], openings: [], base: null };

/** The least side of a room, and how near to a corner an opening may come [mm]. */
const LEAST_SIDE = 500;
const JAMB = 50;
/** How far apart the lines of two rooms may be that have a wall in common [mm]. */
const THICKEST = 600;

/** Sizes of what is put into a wall, and how narrow it becomes where there is less wall [mm]. */
export const OPENING_SIZES: Readonly<Record<OpeningKind, { readonly width: number; readonly least: number; readonly height: number; readonly sill: number }>> = {
  door: { width: 900, least: 700, height: 2100, sill: 0 },
  passage: { width: 1200, least: 700, height: 2100, sill: 0 },
  garage_door: { width: 2500, least: 2000, height: 2100, sill: 0 },
  window: { width: 1400, least: 400, height: 1200, sill: 900 },
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

/** A part of a wall with one thing beyond it: one room, or the outside. What is put into a wall lies in one face. */
export interface Face extends Stretch {
  readonly wall: RoomWall;
}

/** The walls of other rooms that a wall has beyond it, on its line or at most the thickest wall away, the nearest first. */
function wallsBeyond(draft: Draft, wall: RoomWall): RoomWall[] {
  const gap = (other: RoomWall): number => (wall.line - other.line) * wall.inward;
  return allWalls(draft)
    .filter((other) => other.room.id !== wall.room.id && other.axis === wall.axis && other.inward === -wall.inward && gap(other) >= 0 && gap(other) <= THICKEST)
    .sort((a, b) => gap(a) - gap(b));
}

export function facesOf(draft: Draft, wall: RoomWall): Face[] {
  const beyond = wallsBeyond(draft, wall);
  const ends = [wall.from, ...beyond.flatMap(({ from, to }) => [from, to]).filter((at) => at > wall.from && at < wall.to), wall.to].sort((a, b) => a - b);
  const faces: (Face & { readonly beyond: string | null })[] = [];
  ends.slice(1).forEach((to, i) => {
    const from = ends[i] as number;
    const across = beyond.find((other) => other.from <= from && to <= other.to)?.room.id ?? null;
    const last = faces.at(-1);
    if (last?.beyond === across) faces[faces.length - 1] = { ...last, to };
    else if (from < to) faces.push({ axis: wall.axis, line: wall.line, from, to, wall, beyond: across });
  });
  return faces;
}

/** The faces on the line of an opening that it lies in, wholly or in part. */
function facesAt(draft: Draft, opening: Stretch): Face[] {
  const meets = (one: Stretch): boolean => isOnSameLine(one, opening) && one.from < opening.to && opening.from < one.to;
  return allWalls(draft).filter(meets).flatMap((wall) => facesOf(draft, wall)).filter(meets);
}

/** Whether an opening has one thing beyond it, not a room for a part of its width and another, or the outside, for the rest. */
function isInOneFace(draft: Draft, opening: Stretch): boolean {
  const faces = facesAt(draft, opening);
  return faces.length > 0 && faces.every((face) => face.from <= opening.from && opening.to <= face.to);
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

/** The openings that still lie in a wall, moved along it or made narrower where it has become too short at their end, or where another wall now meets it. */
function settled(draft: Draft): Draft {
  const openings = draft.openings.reduce<readonly DraftOpening[]>((before, opening) => {
    const now = { ...draft, openings: before };
    if (isInOneFace(now, opening)) return before;
    const width = opening.to - opening.from;
    const least = Math.min(width, OPENING_SIZES[opening.kind].least);
    const [nearest] = facesAt(now, opening)
      .filter((face) => face.to - face.from >= least + 2 * JAMB)
      .map((face) => within(face, width, opening.from))
      .filter((place) => isFree(now, place, opening.id))
      .sort((a, b) => b.to - b.from - (a.to - a.from) || Math.abs(a.from - opening.from) - Math.abs(b.from - opening.from));
    if (nearest) return before.map((one) => (one.id === opening.id ? { ...one, from: nearest.from, to: nearest.to } : one));
    return wallsAt(now, opening).length > 0 ? before : before.filter((one) => one.id !== opening.id);
  }, draft.openings);
  return { ...draft, openings };
}

/** The plan, where rooms stay rooms; null where they do not. */
function tenable(draft: Draft): Draft | null {
  return isTenable(draft) ? settled(draft) : null;
}

export function withRoom(draft: Draft, corners: Corners, type: string | null = null): { readonly draft: Draft; readonly id: string } | null {
  const id = freeId("room", new Set(draft.rooms.map((room) => room.id)));
  const drawn = tenable({ ...draft, rooms: [...draft.rooms, { id, type, name: "", outdoor: false, corners, from: null }] });
  return drawn && { draft: drawn, id };
}

function withChanged(draft: Draft, id: string, change: (room: DraftRoom) => DraftRoom): Draft {
  return { ...draft, rooms: draft.rooms.map((room) => (room.id === id ? change(room) : room)) };
}

export function withType(draft: Draft, id: string, type: string | null, outdoor = false): Draft {
  return withChanged(draft, id, (room) => ({ ...room, type, outdoor }));
}

export function withName(draft: Draft, id: string, name: string): Draft {
  return withChanged(draft, id, (room) => ({ ...room, name }));
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
  return tenable({ ...draft, rooms, openings });
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
  return tenable({ ...draft, rooms, openings: draft.openings.map((opening) => (goesAlong(opening) ? { ...opening, line } : opening)) });
}

/** The place of a width in a face, of less where it is shorter, that is nearest to a beginning. */
function within({ axis, line, from, to }: Stretch, most: number, wanted: number): Stretch {
  const width = Math.min(most, to - from - 2 * JAMB);
  const begin = Math.round(Math.max(from + JAMB, Math.min(to - JAMB - width, wanted)));
  return { axis, line, from: begin, to: begin + width };
}

/** Where an opening of a width comes to lie in the face nearest to a point, within reach [mm], down to its least width; null where none takes it. */
function placeInWall(draft: Draft, at: Point, sizes: { readonly width: number; readonly least: number }, reach: number): (Stretch & { readonly wall: RoomWall }) | null {
  const awayFrom = ({ axis, line, from, to }: Stretch): number => {
    const [across, along] = axis === "x" ? [at.z, at.x] : [at.x, at.z];
    return Math.hypot(across - line, Math.max(0, from - along, along - to));
  };
  const [nearest] = allWalls(draft).filter((wall) => awayFrom(wall) <= reach).flatMap((wall) => facesOf(draft, wall))
    .filter((face) => face.to - face.from >= sizes.least + 2 * JAMB)
    .map((face) => ({ face, off: awayFrom(face) }))
    .filter(({ off }) => off <= reach)
    .sort((a, b) => a.off - b.off || a.face.to - a.face.from - (b.face.to - b.face.from) || a.face.wall.to - a.face.wall.from - (b.face.wall.to - b.face.wall.from));
  if (!nearest) return null;
  const { face } = nearest;
  return { ...within(face, sizes.width, (face.axis === "x" ? at.x : at.z) - sizes.width / 2), wall: face.wall };
}

function isFree(draft: Draft, place: Stretch, except: string): boolean {
  return !draft.openings.some((other) => other.id !== except && isOnSameLine(other, place) && other.from < place.to && place.from < other.to);
}

/** The plan with an opening put into the wall nearest to a point. */
export function withOpening(draft: Draft, kind: OpeningKind, at: Point, reach: number): { readonly draft: Draft; readonly id: string } | null {
  const size = OPENING_SIZES[kind];
  const place = placeInWall(draft, at, size, reach);
  if (!place || !isFree(draft, place, "")) return null;
  const id = freeId(kind, new Set(draft.openings.map((opening) => opening.id)));
  const { axis, line, from, to } = place;
  const { height, sill } = size;
  const isFirstWayOut = kind === "door" && wallsAt(draft, place).length === 1 && !draft.openings.some((opening) => opening.isMainEntrance);
  const opening: DraftOpening = { id, kind, axis, line, from, to, height, sill, hinge: "start", swing: place.wall.inward, isMainEntrance: isFirstWayOut };
  return { draft: { ...draft, openings: [...draft.openings, opening] }, id };
}

/** The plan with an opening in the middle of the longest stretch, between walls that meet there and other openings, of a room's walls that are as asked for. */
export function withOpeningAt(draft: Draft, kind: OpeningKind, room: string, asked: Partial<Wall>): ReturnType<typeof withOpening> {
  const isMeant = (wall: RoomWall): boolean => wall.room.id === room && (asked.index ?? wall.index) === wall.index && asked.axis === wall.axis && asked.inward === wall.inward;
  const stretches = allWalls(draft).filter(isMeant).flatMap((wall) => {
    const taken = draft.openings.filter((one) => isOnSameLine(one, wall));
    const cuts = [wall.from, ...[...taken, ...facesOf(draft, wall)].flatMap(({ from, to }) => [from, to]), wall.to]
      .filter((at) => at >= wall.from && at <= wall.to).sort((a, b) => a - b);
    return cuts.slice(1).map((to, i) => ({ ...wall, from: cuts[i] as number, to })).filter((one) => one.to - one.from >= OPENING_SIZES[kind].least && isFree(draft, one, ""));
  }).sort((a, b) => b.to - b.from - (a.to - a.from));
  for (const { axis, line, from, to } of stretches) {
    const middle = Math.round((from + to) / 2);
    const put = withOpening(draft, kind, axis === "x" ? { x: middle, z: line } : { x: line, z: middle }, 1);
    if (put) return put;
  }
  return null;
}

/** An opening in the wall nearest to a point. */
export function openingMoved(draft: Draft, id: string, at: Point, reach: number): Draft | null {
  const opening = draft.openings.find((one) => one.id === id);
  const width = opening ? opening.to - opening.from : 0;
  const place = opening && placeInWall(draft, at, { width, least: width }, reach);
  if (!place || !isFree(draft, place, id)) return null;
  const { axis, line, from, to } = place;
  return withOpeningChanged(draft, id, { axis, line, from, to });
}

/** An opening with other properties; null where it would leave its wall or meet another, or another wall that meets its own. */
export function withOpeningChanged(draft: Draft, id: string, change: Partial<DraftOpening>): Draft | null {
  const changed = draft.openings.map((one) => (one.id === id ? { ...one, ...change } : change.isMainEntrance ? { ...one, isMainEntrance: false } : one));
  const opening = changed.find((one) => one.id === id);
  const next = { ...draft, openings: changed };
  if (!opening || opening.from >= opening.to || wallsAt(next, opening).length === 0 || !isFree(next, opening, id)) return null;
  const isMoved = change.from !== undefined || change.to !== undefined;
  return !isMoved || isInOneFace(next, opening) ? next : null;
}

export function withoutOpening(draft: Draft, id: string): Draft {
  return { ...draft, openings: draft.openings.filter((opening) => opening.id !== id) };
}

/** How many openings went with the wall that they were in: neither by themselves nor with their room. */
export function openingsLost(before: Draft, after: Draft): number {
  return after.rooms === before.rooms || after.rooms.length < before.rooms.length ? 0 : Math.max(0, before.openings.length - after.openings.length);
}

/** A wall of a length [mm]: the wall at its eastern or southern end moves. */
export function wallLengthened(draft: Draft, id: string, index: number, length: number): Draft | null {
  const walls = wallsOf(draft.rooms.find((room) => room.id === id)?.corners ?? []);
  const wall = walls[index];
  const ends = wall ? [walls.at(index - 1), walls[(index + 1) % walls.length]] : [];
  const end = ends.find((other) => other?.line === wall?.to);
  return wall && end ? wallMoved(draft, id, end.index, wall.from + length) : null;
}
