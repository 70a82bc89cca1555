/**
 * The coordinate frame. The scene's is three.js's own: right-handed, x east, y up, z south, so a rotation in
 * degrees about +y needs only radians. Bodies are room-relative; here they get their place in the house.
 */
import type { Body, Decoration, Dynamic, Room, Scene, Side } from "../contract";
import type { Storey } from "./walls";
import { sayName } from "../words/language";

export type BodyKind = "furniture" | "decoration" | "dynamic";

/** A body in the house: `x`, `z` its footprint's centre, `y` its underside [m], `turn` about +y [rad], front at +z. */
export interface PlacedBody {
  readonly id: string;
  readonly name: string;
  readonly kind: BodyKind;
  /** The catalog's key of its shape; none where the scene names no kind. */
  readonly shape?: string | null;
  /** The name of the own asset that it is shown as. */
  readonly asset?: string | null;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly turn: number;
  readonly width: number;
  readonly depth: number;
  readonly height: number;
  readonly color: string;
  /** It hangs on a wall, or lies on what does: its middle or its carrier's, above the ground [m]. */
  readonly hung?: number;
  /** Towards which side the wall looks outside that it hangs on; none between rooms. */
  readonly outward?: Side;
  /** It sits, so high above the floor [m]. */
  readonly seat?: number;
  /** The accent of its room. */
  readonly accent?: string;
}

const UNSAID_COLOR = "#8b949e";

export function radians(degrees: number): number {
  return (degrees * Math.PI) / 180;
}

/** Words for an identifier: `dining_table` reads as "dining table". */
export function words(name: string): string {
  return sayName(name);
}

/** A storey of which nothing is said [m]. */
export const STOREY: Storey = { elevation: 0, height: 2.8 };

/** Each level's floor height and storey height [m]; one not listed is on what is beneath it, and as high as the house is said to be where it is alone. */
export function storeysOf({ rooms, levels, size }: Scene): Map<number, Storey> {
  const storeys = new Map((levels ?? []).map(({ index, elevation, height }): [number, Storey] => [index, { elevation, height }]));
  const indices = [...new Set(rooms.map(({ level }) => level))].sort((a, b) => a - b);
  const height = storeys.size === 0 && indices.length === 1 ? size?.height ?? STOREY.height : STOREY.height;
  for (const index of indices.filter((one) => !storeys.has(one))) {
    const tops = [...storeys].filter(([one]) => one < index).map(([, beneath]) => beneath.elevation + beneath.height);
    storeys.set(index, { elevation: Math.max(STOREY.elevation, ...tops), height });
  }
  return storeys;
}

/** The style that a scene is furnished in; null where it does not say. */
export function styleOf(scene: Scene): string | null {
  return scene.style ?? scene.request?.style ?? null;
}

/** What a scene calls a body, and the key of its shape. */
interface Called {
  readonly name: string;
  readonly shape: string | null | undefined;
  readonly asset?: string | null | undefined;
}

function place(body: Body, { name, shape, asset }: Called, kind: BodyKind, room: Room, elevation: number): PlacedBody {
  return {
    id: body.id,
    name,
    kind,
    shape: shape ?? null,
    asset: asset ?? null,
    x: room.x + body.x,
    y: elevation + (body.y ?? 0),
    z: room.z + body.z,
    turn: radians(body.rotation ?? 0),
    width: body.width,
    depth: body.depth,
    height: body.height,
    color: body.color ?? UNSAID_COLOR,
    accent: room.accent,
  };
}

/** A decoration in the house; what hangs on a wall, or lies on what does, knows at which height. */
function placeDecoration(piece: Decoration, others: ReadonlyMap<string, Decoration>, room: Room, elevation: number): PlacedBody {
  const body = place(piece, { name: piece.name, shape: piece.kind, asset: piece.asset }, "decoration", room, elevation);
  let carrier: Decoration | undefined = piece;
  for (let step = 0; carrier && !carrier.mounted_on_wall && step < room.decorations.length; step += 1) {
    carrier = others.get(carrier.parent ?? "");
  }
  const wall = carrier?.mounted_on_wall;
  if (!carrier || !wall) return body;
  const hung = { ...body, hung: elevation + carrier.y + carrier.height / 2 };
  return room.exterior_walls?.[wall] ? { ...hung, outward: wall } : hung;
}

function placeDecorations(room: Room, elevation: number): PlacedBody[] {
  const others = new Map(room.decorations.map((piece) => [piece.id, piece]));
  return room.decorations.map((piece) => placeDecoration(piece, others, room, elevation));
}

/** Every body of a scene in house coordinates. */
export function bodiesOf(scene: Scene): PlacedBody[] {
  const storeys = storeysOf(scene);
  const elevation = (room: Room): number => storeys.get(room.level)?.elevation ?? 0;
  const rooms = new Map(scene.rooms.map((room) => [room.id, room]));
  const standing = scene.rooms.flatMap((room) => [
    ...room.furniture.map((piece) => place(piece, { name: piece.name, shape: piece.kind, asset: piece.asset }, "furniture", room, elevation(room))),
    ...placeDecorations(room, elevation(room)),
  ]);
  const living = (scene.dynamic ?? []).flatMap((body: Dynamic) => {
    const room = rooms.get(body.room);
    if (!room) return [];
    const called = { name: body.kind, shape: body.on ? `${body.kind}_seated` : body.kind };
    const placed = place(body, called, "dynamic", room, elevation(room));
    return [body.on ? { ...placed, seat: body.y } : placed];
  });
  return [...standing, ...living];
}

/** Whether a place of the house is over a body's footprint [m]. */
export function isOver({ x, z, turn, width, depth }: PlacedBody, atX: number, atZ: number): boolean {
  const [cos, sin, dx, dz] = [Math.cos(turn), Math.sin(turn), atX - x, atZ - z];
  return Math.abs(dx * cos - dz * sin) <= width / 2 && Math.abs(dx * sin + dz * cos) <= depth / 2;
}
