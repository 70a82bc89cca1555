/** A scene as a plan to be drawn on, and a drawn plan as a scene, what stood in its rooms where it stood. */
import type { Body, Opening, Room, Scene, Side } from "../contract";
import { clearFloorOf } from "../house/clear_floor";
import { drawable } from "../house/drawable";
import { openingsOf, type PlacedOpening } from "../house/openings";
import { cornersOf } from "../house/plan";
import { runsOf } from "../house/wall_runs";
import { boxOf, doubleArea, tidied, type Corners, type Wall } from "./corners";
import { wallsAt, type Draft, type DraftOpening, type DraftRoom } from "./draft";

const OUTSIDE = "EXTERIOR";
/** What a plan that is drawn from nothing is made of [m]. */
const WALL_THICKNESS = 0.1;
const STOREY = { index: 0, elevation: 0, height: 2.8 } as const;
/** Where a room without a type is said to be one: the service guesses. */
export const UNTYPED = "room";

function millimetres(metres: number): number {
  return Math.round(metres * 1000);
}

function metres(length: number): number {
  return Math.round(length) / 1000;
}

/** The corners of a room [mm], clockwise; null where one of its walls runs at an angle. */
export function draftCorners(room: Room): Corners | null {
  const corners = cornersOf(room).map(([x, z]) => ({ x: millimetres(room.x + x), z: millimetres(room.z + z) }));
  const turned = doubleArea(corners) < 0 ? corners.reverse() : corners;
  const isSquare = turned.every((a, i) => {
    const b = turned[(i + 1) % turned.length] ?? a;
    return a.x === b.x || a.z === b.z;
  });
  return isSquare ? tidied(turned) : null;
}

function draftOpening({ id, kind, axis, line, from, to, sill, head, hinge, opensTowards, mainEntrance }: PlacedOpening): DraftOpening {
  return {
    id, kind, axis, line: millimetres(line), from: millimetres(from), to: millimetres(to), height: millimetres(head - sill), sill: millimetres(sill),
    hinge, swing: opensTowards, isMainEntrance: mainEntrance,
  };
}

/** The storey of a scene that is drawn on: its lowest that has rooms. */
export function storeyDrawn(scene: Scene): number {
  return Math.min(...scene.rooms.map((room) => room.level ?? 0));
}

/** The lowest storey of a scene as a plan; rooms with walls at an angle are left as they are. */
export function draftOf(scene: Scene): Draft {
  const level = storeyDrawn(scene);
  const drawn = scene.rooms.flatMap((room) => {
    const corners = (room.level ?? 0) === level ? draftCorners(room) : null;
    return corners ? [{ room, corners }] : [];
  });
  const rooms = drawn.map(({ room, corners }): DraftRoom => ({ id: room.id, type: room.type === UNTYPED ? null : room.type, name: room.name ?? "", outdoor: room.outdoor, corners, from: room }));
  const draft = { rooms, openings: openingsOf(drawn.map(({ room }) => room), null).map(draftOpening), base: scene };
  return { ...draft, openings: draft.openings.filter((opening) => wallsAt(draft, opening).length > 0) };
}

function sideOf({ axis, inward }: Wall): Side {
  if (axis === "x") return inward === 1 ? "north" : "south";
  return inward === 1 ? "west" : "east";
}

/** An opening as one of its rooms lists it; the first of them draws the leaf. */
function listed(draft: Draft, opening: DraftOpening, room: DraftRoom): Opening | null {
  const walls = wallsAt(draft, opening);
  const own = walls.find((wall) => wall.room.id === room.id);
  if (!own) return null;
  const other = walls.find((wall) => wall.room.id !== room.id);
  const isRectangle = room.corners.length === 4;
  const place = isRectangle ? { wall: sideOf(own) } : { wall: null, edge: own.index };
  return {
    id: opening.id, kind: opening.kind, ...place, position: metres((opening.from + opening.to) / 2 - own.from),
    width: metres(opening.to - opening.from), height: metres(opening.height), sill: metres(opening.sill),
    connects_to: other?.room.id ?? OUTSIDE, hinge: opening.kind === "door" ? opening.hinge : null,
    swing: opening.kind === "door" ? (opening.swing === own.inward ? "in" : "out") : null,
    main_entrance: opening.isMainEntrance, render_panel: walls[0]?.room.id === room.id,
  };
}

function relative<Thing extends Body>(body: Thing, dx: number, dz: number): Thing {
  return { ...body, x: Math.round((body.x + dx) * 1e4) / 1e4, z: Math.round((body.z + dz) * 1e4) / 1e4 };
}

/** A room of the plan as a room of the scene; what stands in it stays where it is in the house. */
function roomOf(draft: Draft, room: DraftRoom): Room {
  const { x0, z0, x1, z1 } = boxOf(room.corners);
  const [x, z] = [metres(x0), metres(z0)];
  const [dx, dz] = room.from ? [room.from.x - x, room.from.z - z] : [0, 0];
  const outline = room.corners.length === 4 ? null : room.corners.map((corner) => [metres(corner.x - x0), metres(corner.z - z0)] as const);
  const { from } = room;
  const plain = { flooring: null, accent: null, wall_flags: null, exterior_walls: null, level: 0 };
  const sameWalls = from && cornersOf(from).length === room.corners.length;
  return {
    ...plain, ...from, ...(sameWalls ? {} : { wall_thickness: null }), ...(room.name || from ? { name: room.name || undefined } : {}), id: room.id, type: room.type ?? UNTYPED, outdoor: room.outdoor, x, z, width: metres(x1 - x0), depth: metres(z1 - z0), outline,
    exterior_walls: null, wall_flags: null,
    openings: draft.openings.flatMap((opening) => listed(draft, opening, room) ?? []),
    furniture: from?.furniture.map((piece) => relative(piece, dx, dz)) ?? [],
    decorations: from?.decorations.map((piece) => relative(piece, dx, dz)) ?? [],
  } as unknown as Room; // what is null is filled in by the service, and by `drawable`
}

/** The outer extents of rooms [m]. */
function sizeOf(rooms: readonly Room[], height: number): Scene["size"] {
  const extent = (from: readonly number[], to: readonly number[]): number => (rooms.length === 0 ? 0 : metres(millimetres(Math.max(...to) - Math.min(...from))));
  return {
    width: extent(rooms.map(({ x }) => x), rooms.map(({ x, width }) => x + width)),
    depth: extent(rooms.map(({ z }) => z), rooms.map(({ z, depth }) => z + depth)), height,
  };
}

/** A drawn plan as a scene, where it lies on the sheet; rooms of `base` that could not be drawn on are as they were. */
export function sceneOf(draft: Draft): Scene {
  const { base } = draft;
  const before = base ? new Set(draftOf(base).rooms.map(({ id }) => id)) : new Set<string>();
  const others = base?.rooms.filter((room) => !before.has(room.id)) ?? [];
  const rooms = [...draft.rooms.map((room) => roomOf(draft, room)), ...others].map((room, index) => ({ ...room, index }));
  const people = (base?.dynamic ?? []).filter((body) => rooms.some((room) => room.id === body.room));
  const size = sizeOf(rooms, base?.size.height ?? STOREY.height);
  const plain = { format: "compose-scene/1", seed: null, request: null, generator: null, wall_thickness: WALL_THICKNESS, levels: [STOREY] };
  const made = { ...plain, ...base, size, rooms, corridors: [], adjacency: [], dynamic: people.map((body) => withRoomMoved(body, draft)), certificate: null };
  return made as unknown as Scene;
}

function withRoomMoved<Person extends Scene["dynamic"][number]>(body: Person, draft: Draft): Person {
  const room = draft.rooms.find((one) => one.id === body.room);
  if (!room?.from) return body;
  const { x0, z0 } = boxOf(room.corners);
  return relative(body, room.from.x - metres(x0), room.from.z - metres(z0));
}


/** The clear floor of each room of a drawn plan [m²], by its id. */
export function clearAreas(draft: Draft): ReadonlyMap<string, number> {
  const bare = draft.rooms.map((room) => ({ ...room, from: room.from && { ...room.from, furniture: [], decorations: [] } }));
  const { rooms, wall_thickness: thickness } = drawable(sceneOf({ ...draft, rooms: bare }));
  const runs = runsOf(rooms, thickness);
  return new Map(rooms.map((room) => [room.id, clearFloorOf(room, runs, thickness).area]));
}

/** A scene with its north-western corner at nought, where houses begin. */
export function atOrigin(scene: Scene): Scene {
  const [x, z] = [Math.min(...scene.rooms.map((room) => room.x)), Math.min(...scene.rooms.map((room) => room.z))];
  if (scene.rooms.length === 0 || (x === 0 && z === 0)) return scene;
  const rooms = scene.rooms.map((room) => ({ ...room, x: metres(millimetres(room.x - x)), z: metres(millimetres(room.z - z)) }));
  return { ...scene, rooms, size: sizeOf(rooms, scene.size.height) };
}
