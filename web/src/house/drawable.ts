/** A scene of somebody else's need not say all that is drawn; what it leaves unsaid is drawn like this. Never sent anywhere. */
import type { Catalog, Decoration, Furniture, Room, Scene, Sides } from "../contract";
import { STOREY, storeysOf } from "./frame";

const ALL: Sides = { north: true, south: true, east: true, west: true };
const FLOORING = { type: "plain", color: "#c9c2b6" } as const;
const ACCENT = "#9aa5b5";

/** What a foreign scene may leave unsaid, as the wire has it. */
type Unsaid<Whole> = { readonly [Key in keyof Whole]: Whole[Key] | null | undefined };

/** A body that says no colour, in that of its kind. */
function colored<Body extends Furniture | Decoration>(body: Body, kinds: Catalog["furniture"] | undefined): Body {
  const color = body.color ?? kinds?.[body.kind ?? ""]?.color;
  return color && body.color !== color ? { ...body, color } : body;
}

/** The plain floor of a room type; none for a type that is not known. */
function floorOfType(type: string, catalog: Catalog | null): { readonly type: string; readonly color: string } | undefined {
  const material = catalog?.rooms?.[type]?.flooring;
  const color = catalog?.floorings?.[material ?? ""]?.color;
  return material && color ? { type: material, color } : undefined;
}

function drawableRoom(room: Room, catalog: Catalog | null): Room {
  const said: Unsaid<Room> = room;
  return {
    ...room,
    furniture: room.furniture.map((piece) => colored(piece, catalog?.furniture)),
    decorations: room.decorations.map((thing) => colored(thing, catalog?.decorations)),
    level: said.level ?? 0,
    flooring: said.flooring ?? floorOfType(room.type, catalog) ?? FLOORING,
    accent: said.accent ?? catalog?.rooms?.[room.type]?.accent ?? ACCENT,
    wall_flags: said.wall_flags ?? ALL,
  };
}

/** The scene complete; with a catalog bodies take the colours of their kinds where they say none. */
export function drawable(scene: Scene, catalog: Catalog | null = null): Scene {
  const said: Unsaid<Scene> = scene;
  const rooms = scene.rooms.map((room) => drawableRoom(room, catalog));
  const levels = [...storeysOf({ ...scene, rooms })].map(([index, storey]) => ({ index, ...storey }));
  const size = said.size ?? {
    width: Math.max(0, ...rooms.map((room) => room.x + room.width)),
    depth: Math.max(0, ...rooms.map((room) => room.z + room.depth)),
    height: levels[0]?.height ?? STOREY.height,
  };
  return { ...scene, rooms, levels, size, wall_thickness: said.wall_thickness ?? 0, dynamic: said.dynamic ?? [] };
}
