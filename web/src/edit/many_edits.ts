/** A scene with several things changed at once, as a new scene. Pure. */
import type { Body, Decoration, Dynamic, Furniture, OtherWay, Room, Scene } from "../contract";
import { footprint } from "./gaps";
import { carriedBy, companionsOf, freshId, moved, without } from "./scene_edits";

/** What was copied: a piece and all that it carries, in its room. */
export interface Clip {
  readonly furniture: readonly Furniture[];
  readonly decorations: readonly Decoration[];
}

export type Alignment = "west" | "east" | "north" | "south" | "across" | "along";

function tidy(metres: number): number {
  return Math.round(metres * 1e4) / 1e4;
}

/** All that goes along with things: what they carry, chairs at them, what lies on what lies. */
function allWith(scene: Scene, ids: readonly string[]): Set<string> {
  const pieces = new Set(scene.rooms.flatMap((room) => room.furniture.map((piece) => piece.id)));
  const all = new Set(ids);
  for (const id of ids) if (pieces.has(id)) for (const rider of [...carriedBy(scene, id), ...companionsOf(scene, id)]) all.add(rider);
  const decorations = scene.rooms.flatMap((room) => room.decorations);
  for (let before = 0; before < all.size;) {
    before = all.size;
    for (const thing of decorations) if (thing.parent && all.has(thing.parent) && !thing.mounted_on_wall && !pieces.has(thing.parent)) all.add(thing.id);
  }
  return all;
}

/** Several things moved by as much [m], each with all that goes along; none of them need stand at a wall. What hangs stays on its wall's line. */
export function shifted(scene: Scene, ids: readonly string[], dx: number, dz: number): Scene {
  const [all, chosen] = [allWith(scene, ids), new Set(ids)];
  const move = <Of extends Body>(body: Of): Of => (all.has(body.id) ? { ...body, x: tidy(body.x + dx), z: tidy(body.z + dz) } : body);
  const slide = (thing: Decoration): Decoration => {
    const wall = thing.mounted_on_wall;
    if (!wall || !all.has(thing.id)) return move(thing);
    return wall === "north" || wall === "south" ? { ...thing, x: tidy(thing.x + dx) } : { ...thing, z: tidy(thing.z + dz) };
  };
  const rooms = scene.rooms.map((room) => ({
    ...room,
    furniture: room.furniture.map((piece) => (chosen.has(piece.id) ? { ...move(piece), wall: null } : move(piece))),
    decorations: room.decorations.map(slide),
  }));
  return { ...scene, rooms, dynamic: (scene.dynamic ?? []).map(move) };
}

/** Without several things and all that lies on them. */
export function withoutThing(scene: Scene, id: string): Scene {
  const gone = allWith(scene, [id]);
  return { ...scene, rooms: scene.rooms.map((room) => ({ ...room, decorations: room.decorations.filter((thing) => !gone.has(thing.id)) })) };
}

/** A decoration changed, what lies on it with it. */
export function changedThing(scene: Scene, id: string, change: Partial<Decoration>): Scene {
  const thing = scene.rooms.flatMap((room) => room.decorations).find((one) => one.id === id);
  if (!thing) return scene;
  const [dx, dz] = [(change.x ?? thing.x) - thing.x, (change.z ?? thing.z) - thing.z];
  const all = allWith(scene, [id]);
  const carried = (one: Decoration): Decoration => (all.has(one.id) ? { ...one, x: tidy(one.x + dx), z: tidy(one.z + dz), y: tidy(one.y + (change.y ?? thing.y) - thing.y) } : one);
  const rooms = scene.rooms.map((room) => ({ ...room, decorations: room.decorations.map((one) => (one.id === id ? { ...one, ...change } : carried(one))) }));
  return { ...scene, rooms };
}

/** Furniture lined up with the first of them: by an edge, or by their centres across or along the house. Each stays in its room. */
export function aligned(scene: Scene, ids: readonly string[], how: Alignment): Scene {
  const places = new Map(scene.rooms.flatMap((room) => room.furniture.map((piece) => [piece.id, { room, piece }] as const)));
  const first = places.get(ids[0] ?? "");
  if (!first) return scene;
  const axis = how === "west" || how === "east" || how === "across" ? "x" : "z";
  const line = ({ room, piece }: { room: Room; piece: Furniture }): number => {
    const [low, high] = footprint(piece)[axis];
    const at = how === "west" || how === "north" ? low : how === "east" || how === "south" ? high : (low + high) / 2;
    return room[axis] + at / 1000;
  };
  return ids.slice(1).reduce((before, id) => {
    const place = places.get(id);
    if (!place || place.piece.locked) return before;
    const by = tidy(line(first) - line(place));
    return by === 0 ? before : shifted(before, [id], axis === "x" ? by : 0, axis === "z" ? by : 0);
  }, scene);
}

/** What is copied of several things: each with all that it carries, once. */
export function clipped(scene: Scene, ids: readonly string[]): Clip[] {
  const chosen = new Set(ids);
  return scene.rooms.flatMap((room) => room.furniture.filter((piece) => chosen.has(piece.id)).flatMap((piece): Clip[] => {
    const carried = carriedBy(scene, piece.id);
    const furniture = room.furniture.filter((one) => one.id !== piece.id && carried.has(one.id));
    return [{ furniture: [piece, ...furniture], decorations: room.decorations.filter((one) => carried.has(one.id)) }];
  })).concat(scene.rooms.flatMap((room) => room.decorations.filter((thing) => chosen.has(thing.id)).map((thing): Clip => ({ furniture: [], decorations: [thing] }))));
}

/** Puts copies into a room, moved by as much [m]; every body has a new id. Returns the scene and the ids of the copied things. */
export function pasted(scene: Scene, roomId: string, clips: readonly Clip[], dx: number, dz: number): { readonly scene: Scene; readonly ids: readonly string[] } {
  const ids: string[] = [];
  const whole = clips.reduce((before, clip) => {
    const room = before.rooms.find((one) => one.id === roomId);
    if (!room) return before;
    const names = new Map<string, string>();
    const taken: Scene = before;
    const isIn = (id: string | null | undefined): boolean => room.furniture.some((piece) => piece.id === id);
    for (const body of [...clip.furniture, ...clip.decorations]) names.set(body.id, freshId(taken, `${roomId}/${body.name}`, new Set(names.values())));
    const own = (id: string | null | undefined): string | null => (id ? names.get(id) ?? (isIn(id) ? id : null) : null);
    const move = <Of extends Body>(body: Of): Of => ({ ...body, id: names.get(body.id) ?? body.id, x: tidy(body.x + dx), z: tidy(body.z + dz) });
    const furniture = clip.furniture.map((piece): Furniture => ({ ...move(piece), wall: null, under: null, on: own(piece.on), locked: false }));
    const decorations = clip.decorations.map((thing): Decoration => ({ ...move(thing), parent: own(thing.parent) }));
    const [first] = [...furniture, ...decorations];
    if (first) ids.push(first.id);
    return { ...before, rooms: before.rooms.map((one) => (one.id === roomId ? { ...one, furniture: [...one.furniture, ...furniture], decorations: [...one.decorations, ...decorations] } : one)) };
  }, scene);
  return { scene: whole, ids };
}

/** A piece taken into another room, with all that goes along, where it is in the house. */
export function transferred(scene: Scene, id: string, roomId: string): Scene {
  const [from, to] = [scene.rooms.find((room) => room.furniture.some((piece) => piece.id === id)), scene.rooms.find((room) => room.id === roomId)];
  if (!from || !to || from.id === to.id) return scene;
  const all = allWith(scene, [id]);
  const goes = (body: { readonly id: string }): boolean => all.has(body.id);
  const move = <Of extends Body>(body: Of): Of => ({ ...body, x: tidy(body.x + from.x - to.x), z: tidy(body.z + from.z - to.z) });
  const loose = (piece: Furniture): Furniture => (piece.id === id ? { ...move(piece), wall: null, under: null, on: null } : move(piece));
  const stays = (piece: Furniture): Furniture => (piece.under && all.has(piece.under) ? { ...piece, under: null } : piece);
  const rooms = scene.rooms.map((room) => {
    if (room.id === from.id) return { ...room, furniture: room.furniture.filter((one) => !goes(one)).map(stays), decorations: room.decorations.filter((one) => !goes(one)) };
    if (room.id !== to.id) return room;
    return { ...room, furniture: [...room.furniture, ...from.furniture.filter(goes).map(loose)], decorations: [...room.decorations, ...from.decorations.filter(goes).map(move)] };
  });
  return { ...scene, rooms, dynamic: (scene.dynamic ?? []).map((body: Dynamic) => (goes(body) ? { ...move(body), room: to.id } : body)) };
}

/** Where a body lies on a piece that has another size: at the same share of its width, depth and height; what is above its top stays as far above. */
function atShare<Of extends Body>(body: Of, from: Furniture, to: Furniture): Of {
  const turn = ((from.rotation ?? 0) * Math.PI) / 180;
  const [cos, sin, dx, dz] = [Math.cos(turn), Math.sin(turn), body.x - from.x, body.z - from.z];
  const [across, along] = [((dx * cos - dz * sin) * to.width) / from.width, ((dx * sin + dz * cos) * to.depth) / from.depth];
  const [above, high] = [body.y ?? 0, from.y ?? 0];
  const y = above >= high + from.height ? above + to.height - from.height : high + ((above - high) * to.height) / from.height;
  return { ...body, x: tidy(to.x + across * cos + along * sin), z: tidy(to.z - across * sin + along * cos), y: tidy(y) };
}

/** A piece with some of its keys changed, as its size or colour. Of another size, it has all that lies on it at the same share of it, but for those in `placed`. */
export function changedPiece(scene: Scene, id: string, change: Partial<Furniture>, placed: ReadonlySet<string> = new Set()): Scene {
  const piece = scene.rooms.flatMap(({ furniture }) => furniture).find((one) => one.id === id);
  if (!piece) return scene;
  const changed = { ...piece, ...change };
  const isResized = changed.width !== piece.width || changed.depth !== piece.depth || changed.height !== piece.height;
  const riders = isResized ? carriedBy(scene, id) : new Set<string>();
  const place = <Of extends Body>(body: Of): Of => (riders.has(body.id) && !placed.has(body.id) ? atShare(body, piece, changed) : body);
  const rooms = scene.rooms.map((room) => ({ ...room, furniture: room.furniture.map((one) => (one.id === id ? changed : place(one))), decorations: room.decorations.map(place) }));
  return { ...scene, rooms, dynamic: (scene.dynamic ?? []).map(place) };
}

/** Pieces that stand in another way, each with all that it carries; and without those for whom there is no place then. */
export function stoodSo(scene: Scene, moves: OtherWay["moves"], gone: readonly string[]): Scene {
  const left = gone.reduce((before, id) => without(before, id), scene);
  const carried = moves.reduce((before, { id, x, z, rotation }) => moved(before, id, { x, z, rotation }), left);
  const placed = new Set(moves.map(({ id }) => id));
  return moves.reduce((before, move) => changedPiece(before, move.id, move, placed), carried);
}

/** The pieces that things lie on and that have another size in another scene of the house. */
export function resizedIn(before: Scene, after: Scene): string[] {
  const was = new Map(before.rooms.flatMap(({ furniture }) => furniture.map((piece) => [piece.id, piece])));
  const isResized = (piece: Furniture): boolean => (["width", "depth", "height"] as const).some((side) => (was.get(piece.id) ?? piece)[side] !== piece[side]);
  return after.rooms.flatMap(({ furniture, decorations }) => furniture.filter((piece) => isResized(piece) && decorations.some(({ parent }) => parent === piece.id)).map(({ id }) => id));
}

/** What hangs at walls over some pieces. */
export function hungOver(scene: Scene, ids: ReadonlySet<string>): string[] {
  return scene.rooms.flatMap(({ decorations }) => decorations.filter((thing) => thing.mounted_on_wall && ids.has(thing.parent ?? "")).map(({ id }) => id));
}

/** A scene in which pieces have on them what they have in another scene of the house, and others over them at the wall what hangs there. */
export function laidAs(scene: Scene, other: Scene, ids: readonly string[], over: ReadonlySet<string> = new Set()): Scene {
  const lying = (of: Scene): ReadonlySet<string> => new Set([...ids.flatMap((id) => [...carriedBy(of, id)]), ...hungOver(of, over)]);
  const [gone, come] = [lying(scene), lying(other)];
  const names = new Map<string, string>();
  const bare = { ...scene, rooms: scene.rooms.map((room) => ({ ...room, decorations: room.decorations.filter(({ id }) => !gone.has(id)) })) };
  const own = (room: Room, thing: Decoration): Decoration => {
    const id = freshId(bare, `${room.id}/${thing.name}`, new Set(names.values()));
    names.set(thing.id, id);
    return { ...thing, id };
  };
  const rooms = bare.rooms.map((room) => {
    const things = (other.rooms.find(({ id }) => id === room.id)?.decorations ?? []).filter(({ id }) => come.has(id)).map((thing) => own(room, thing));
    return { ...room, decorations: [...room.decorations, ...things.map((thing) => ({ ...thing, parent: names.get(thing.parent ?? "") ?? thing.parent ?? null }))] };
  });
  return { ...bare, rooms };
}
