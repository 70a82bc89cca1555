/** A scene with one thing changed, as a new scene: what a person wishes, for the service to judge. */
import type { Body, Dynamic, Furniture, Pose, Repair, Room, Scene } from "../contract";

export interface Wish {
  readonly x: number;
  readonly z: number;
  readonly rotation: number;
}

/** A kind of the catalog, as far as a piece of it needs. */
export interface FurnitureKind {
  readonly key: string;
  readonly name: string;
  readonly category: string;
  readonly size: readonly [number, number, number];
  readonly color: string | null;
  /** The own asset that it is shown as. */
  readonly asset?: string;
}

/** Offsets that differ by no more are the same [m]: a centre may end in half a millimetre. */
const SAME = 0.002;

function millimetres(metres: number): number {
  return Math.round(metres * 1000) / 1000;
}

function mapRoom(scene: Scene, id: string, change: (room: Room) => Room): Scene {
  return { ...scene, rooms: scene.rooms.map((room) => (room.id === id ? change(room) : room)) };
}

function roomOf(scene: Scene, piece: string): Room {
  const room = scene.rooms.find((one) => one.furniture.some((other) => other.id === piece));
  if (!room) throw new Error(`No room holds ${piece}`);
  return room;
}

function mapPiece(scene: Scene, id: string, change: (piece: Furniture) => Furniture): Scene {
  return mapRoom(scene, roomOf(scene, id).id, (room) => ({
    ...room, furniture: room.furniture.map((piece) => (piece.id === id ? change(piece) : piece)),
  }));
}

/** The ids of a piece and of all that stands, lies or sits on it; what hangs on a wall stays there. */
export function carriedBy(scene: Scene, id: string): Set<string> {
  const room = roomOf(scene, id);
  const carried = new Set([id]);
  const rests = [
    ...room.furniture.map((piece) => ({ id: piece.id, on: piece.on })),
    ...room.decorations.filter((piece) => !piece.mounted_on_wall).map((piece) => ({ id: piece.id, on: piece.parent })),
    ...(scene.dynamic ?? []).map((body) => ({ id: body.id, on: body.on })),
  ];
  for (let before = 0; before < carried.size;) {
    before = carried.size;
    for (const { id: rider, on } of rests) if (on && carried.has(on)) carried.add(rider);
  }
  return carried;
}

/**
 * Who goes along with a piece but is not carried by it: the chairs at it and what lies or sits on them. What is locked stays.
 */
export function companionsOf(scene: Scene, id: string): Set<string> {
  const carried = carriedBy(scene, id);
  const chairs = roomOf(scene, id).furniture.filter((piece) => piece.under && carried.has(piece.under) && !piece.locked && !carried.has(piece.id));
  return new Set(chairs.flatMap((chair) => [...carriedBy(scene, chair.id)]));
}

/** Of those who go along with a piece, the ones that stand to it in one scene as in another. */
export function keptCompanions(before: Scene, after: Scene, id: string): Set<string> {
  const offsets = (scene: Scene): Map<string, readonly [number, number]> => {
    const room = roomOf(scene, id);
    const held = room.furniture.find((one) => one.id === id) as Furniture;
    const bodies = [...room.furniture, ...room.decorations, ...(scene.dynamic ?? [])];
    return new Map(bodies.map((body) => [body.id, [body.x - held.x, body.z - held.z]]));
  };
  const [was, is] = [offsets(before), offsets(after)];
  return new Set([...companionsOf(before, id)].filter((rider) => {
    const [from, to] = [was.get(rider), is.get(rider)];
    return from && to && Math.abs(from[0] - to[0]) <= SAME && Math.abs(from[1] - to[1]) <= SAME;
  }));
}

/** Moves a body with the piece that carries it: about its centre by a turn [degrees], then to its new centre. */
function carry<Rider extends Body>(rider: Rider, from: Furniture, to: Wish): Rider {
  const turn = ((to.rotation - (from.rotation ?? 0)) * Math.PI) / 180;
  const [dx, dz] = [rider.x - from.x, rider.z - from.z];
  const [cos, sin] = [Math.round(Math.cos(turn) * 1e9) / 1e9, Math.round(Math.sin(turn) * 1e9) / 1e9];
  return {
    ...rider,
    x: Math.round((to.x + dx * cos + dz * sin) * 1e4) / 1e4,
    z: Math.round((to.z - dx * sin + dz * cos) * 1e4) / 1e4,
    rotation: ((rider.rotation ?? 0) + to.rotation - (from.rotation ?? 0) + 720) % 360,
  };
}

/** A footprint's centre whose edges lie on whole millimetres. */
function centre(metres: number, extent: number): number {
  return Math.round((millimetres(metres - extent / 2) + extent / 2) * 1e4) / 1e4;
}

/** The piece in hand at another place, all that it carries and its chairs with it. In hand it need not stand at a wall. */
export function moved(scene: Scene, id: string, wish: Wish): Scene {
  const room = roomOf(scene, id);
  const piece = room.furniture.find((one) => one.id === id) as Furniture;
  const [across, along] = wish.rotation % 180 === 0 ? [piece.width, piece.depth] : [piece.depth, piece.width];
  const to: Wish = { rotation: (wish.rotation + 360) % 360, x: centre(wish.x, across), z: centre(wish.z, along) };
  const carried = new Set([...carriedBy(scene, id), ...companionsOf(scene, id)]);
  const place = <Rider extends Body>(rider: Rider): Rider => (carried.has(rider.id) && rider.id !== id ? carry(rider, piece, to) : rider);
  const changed = mapRoom(scene, room.id, (old) => ({
    ...old,
    furniture: old.furniture.map((one) => (one.id === id ? { ...one, ...to, wall: null } : place(one))),
    decorations: old.decorations.map(place),
  }));
  return { ...changed, dynamic: (scene.dynamic ?? []).map(place) };
}

/** Without a piece and all that lies and stands on it; who sat on it stands. */
export function without(scene: Scene, id: string): Scene {
  const gone = carriedBy(scene, id);
  const changed = mapRoom(scene, roomOf(scene, id).id, (room) => ({
    ...room,
    furniture: room.furniture
      .filter((piece) => !gone.has(piece.id))
      .map((piece) => (piece.under && gone.has(piece.under) ? { ...piece, under: null } : piece)),
    decorations: room.decorations.filter((piece) => !gone.has(piece.id)),
  }));
  const stand = (body: Dynamic): Dynamic => (body.on && gone.has(body.on) ? { ...body, on: null, y: 0 } : body);
  return { ...changed, dynamic: (scene.dynamic ?? []).map(stand) };
}

export function locked(scene: Scene, id: string, isLocked: boolean): Scene {
  return mapPiece(scene, id, (piece) => ({ ...piece, locked: isLocked }));
}

/** A new piece in the middle of a room; its id is the room's and the kind's, with the next free number. */
export function added(scene: Scene, roomId: string, kind: FurnitureKind): { readonly scene: Scene; readonly id: string; readonly piece: Furniture } {
  const room = scene.rooms.find((one) => one.id === roomId);
  if (!room) throw new Error(`No room is called ${roomId}`);
  const id = freshId(scene, `${roomId}/${kind.name}`);
  const [width, depth, height] = kind.size;
  const piece: Furniture = {
    id, name: kind.name, kind: kind.key, category: kind.category, x: centre(room.width / 2, width), y: 0, z: centre(room.depth / 2, depth),
    rotation: 0, width, depth, height, color: kind.color, wall: null, under: null, on: null, locked: false, ...(kind.asset ? { asset: kind.asset } : {}),
  };
  return { id, piece, scene: mapRoom(scene, roomId, (old) => ({ ...old, furniture: [...old.furniture, piece] })) };
}

/** An id that no body has, and that is none of some others. */
export function freshId(scene: Scene, stem: string, besides: ReadonlySet<string> = new Set()): string {
  const taken = new Set([...besides, ...scene.rooms.flatMap((room) => [...room.furniture, ...room.decorations].map((body) => body.id))]);
  for (let number = 1; ; number += 1) if (!taken.has(`${stem}_${number}`)) return `${stem}_${number}`;
}

/** What a repair changes in the scene: the table of what /fix answers. */
export function repaired(scene: Scene, repair: Repair): Scene {
  switch (repair.action) {
    case "move": return mapPiece(scene, repair.id, (piece) => ({ ...piece, wall: null }));
    case "unlock": return locked(scene, repair.id, false);
    case "turn": return mapPiece(scene, repair.id, (piece) => ({ ...piece, rotation: repair.rotation }));
    case "shrink": return mapPiece(scene, repair.id, (piece) => ({ ...piece, width: repair.width, depth: repair.depth }));
    case "leave_out": return without(scene, repair.id);
  }
}

/** The scene with one room only, and who is in it: what is repaired the quickest. Its doors are the ways into it. */
export function alone(scene: Scene, roomId: string): Scene {
  const ways = (room: Room): Room => ({
    ...room, openings: room.openings.map((one) => (one.kind === "window" ? one : { ...one, connects_to: "EXTERIOR" })),
  });
  return {
    ...scene,
    rooms: scene.rooms.filter((room) => room.id === roomId).map(ways),
    dynamic: (scene.dynamic ?? []).filter((body) => body.room === roomId),
  };
}

/** The house with one room, and who is in it, as an answer about that room alone has them. */
export function withRoom(scene: Scene, answer: Scene): Scene {
  const rooms = new Map(answer.rooms.map((room) => [room.id, room]));
  const people = new Map((answer.dynamic ?? []).map((body) => [body.id, body]));
  return {
    ...scene,
    rooms: scene.rooms.map((room) => ({ ...(rooms.get(room.id) ?? room), openings: room.openings })),
    dynamic: (scene.dynamic ?? []).map((body) => people.get(body.id) ?? body),
  };
}

/** Where all that stands on a room's floor, or on what stands there, is; and who stands there. */
export function posesOf(scene: Scene, roomId: string): Pose[] {
  const room = scene.rooms.find((one) => one.id === roomId);
  const loose = (room?.decorations ?? []).filter((thing) => !thing.parent && !thing.mounted_on_wall);
  const standing = (scene.dynamic ?? []).filter((body) => body.room === roomId && !body.on);
  return [...(room?.furniture ?? []), ...loose, ...standing].map(({ id, x, z, rotation }) => ({ id, x, z, rotation: rotation ?? 0 }));
}
