/** Lamps that light when it grows dark: what gives light in a home, and lights under its ceilings. They light their room; nothing is drawn for them. */
import { DataTexture, RGFormat, Vector4, type Material } from "three";
import type { Room } from "../contract";
import type { PlacedBody } from "./frame";
import type { Part } from "./parts";
import { roomHolding } from "./room_at";
import type { Storey } from "./walls";

/** A light: where it is [m], how strong, and the room that it lights. */
export interface Lamp {
  readonly at: readonly [number, number, number];
  readonly strength: number;
  readonly room: Room;
}

/** As many as shaders have places for, and as many as light one room. */
const [MOST, MOST_IN_ROOM] = [96, 5];
/** How far under its ceiling a light is [m], and how strong it is for each metre of the room's shorter side, at least and at most. */
const [BELOW, A_METRE, FAINTEST, STRONGEST] = [0.35, 0.75, 1.7, 3];
/** About so far apart are lights under one ceiling [m]. */
const APART = 4.5;
/** How strong a lamp is at least and at most, and for each metre of what glows. */
const [FAINT, BRIGHTEST, STRENGTH] = [0.15, 0.9, 3];
const NEARLY = 0.01;
/** The map of rooms has places so wide: walls are as thick. Round the house none lie in a room [m]. */
const [PLACE, ROUND] = [0.1, 0.3];
/** No side of the map has more places. */
const LONGEST = 2048;

const lampMap = { value: mapOf(new Uint8Array(2), 1, 1) };

export const lampUniforms = {
  /** How bright they are; where none is lit, 0. */
  lampLight: { value: 0 },
  lampMap,
  lampGround: { value: new Vector4(0, 0, 1, 1) },
  lampAt: { value: Array.from({ length: MOST }, () => new Vector4()) },
};

/** What a fragment is lit by, in its own colour; for `normal`, `vViewPosition` and `diffuseColor` of three's shaders. */
export const LAMP_UNIFORMS = /* glsl */ `
#ifdef LAMPS
uniform float lampLight;
uniform sampler2D lampMap; // of each place the first lamp of its room, and how many it has
uniform vec4 lampGround; // the map's west and north end, its width and depth
uniform vec4 lampAt[${MOST}]; // where, how strong
#endif`;
export const LAMPLIGHT = /* glsl */ `
#ifdef LAMPS
if (lampLight > 0.0) {
  vec3 facing = normal * mat3(viewMatrix);
  vec3 here = cameraPosition - vViewPosition * mat3(viewMatrix) + facing * 0.03;
  ivec2 row = ivec2(texture(lampMap, (here.xz - lampGround.xy) / lampGround.zw).xy * 255.0 + 0.5);
  float light = 0.0;
  for (int i = row.x; i < row.x + row.y; i++) {
    vec3 way = lampAt[i].xyz - here;
    float far = dot(way, way);
    // What is as near as its shade is lit through that.
    float aimed = far < 0.06 ? 1.0 : 0.4 + 0.6 * max(0.0, dot(way, facing) * inversesqrt(far));
    light += lampAt[i].w * aimed / (0.5 + far);
  }
  totalEmissiveRadiance += diffuseColor.rgb * vec3(1.0, 0.74, 0.46) * (light * lampLight);
}
#endif`;

const lit = new Set<Material>();
let isDim = false;

function addLamps(material: Material): void {
  material.defines = { ...material.defines, LAMPS: "" };
  material.needsUpdate = true;
}

/** A material that lamps light, by the shader's parts above: with them only from the first dusk on, since to make them takes longer. */
export function litByLamps<Kind extends Material>(material: Kind): Kind {
  lit.add(material);
  if (isDim) addLamps(material);
  return material;
}

function mapOf(places: Uint8Array<ArrayBuffer>, wide: number, deep: number): DataTexture {
  const map = new DataTexture(places, wide, deep, RGFormat);
  map.unpackAlignment = 1;
  map.needsUpdate = true;
  return map;
}

/** The lights under the ceiling of a room: one, in a long room several in a row. */
function ceilingLamps(room: Room, { elevation, height }: Storey): Lamp[] {
  const { x, z, width, depth } = room;
  const strength = Math.max(FAINTEST, Math.min(STRONGEST, Math.min(width, depth) * A_METRE));
  const count = Math.max(1, Math.min(MOST_IN_ROOM, Math.round(Math.max(width, depth) / APART)));
  return Array.from({ length: count }, (_, i): Lamp => {
    const [along, across] = [(i + 0.5) / count, 0.5];
    const [u, v] = width > depth ? [along, across] : [across, along];
    return { at: [x + u * width, elevation + height - BELOW, z + v * depth], strength, room };
  });
}

/** A lamp's light: where it glows most; none where nothing of it does. */
function lampOf(body: PlacedBody, parts: readonly Part[], room: Room): Lamp[] {
  const [brightest] = parts.filter(({ paint }) => paint.glow > 0).sort((a, b) => b.paint.glow * Math.max(...b.size) - a.paint.glow * Math.max(...a.size));
  if (!brightest) return [];
  const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
  const { at: [x, y, z], size, paint } = brightest;
  const strength = Math.min(BRIGHTEST, FAINT + STRENGTH * paint.glow * Math.max(...size));
  return [{ at: [body.x + x * cos + z * sin, body.y + y, body.z - x * sin + z * cos], strength, room }];
}

/** The lamps of a storey, room by room; `partsOf` tells what a lamp is drawn as, null for what is none. */
export function lampsOf(
  rooms: readonly Room[], { elevation, height }: Storey, bodies: readonly PlacedBody[], partsOf: (body: PlacedBody) => readonly Part[] | null,
): Lamp[] {
  const standing = bodies.filter(({ y }) => elevation <= y + NEARLY && y < elevation + height).flatMap((body) => {
    const parts = partsOf(body);
    const room = parts && roomHolding(rooms, rooms[0]?.level ?? 0, body.x, body.z);
    return room ? lampOf(body, parts, room) : [];
  });
  const lamps = rooms.flatMap((room) => {
    const own = standing.filter((lamp) => lamp.room === room).sort((a, b) => b.strength - a.strength);
    return [...(room.outdoor ? [] : ceilingLamps(room, { elevation, height })), ...own].slice(0, MOST_IN_ROOM);
  });
  return lamps.slice(0, MOST);
}

/** Lights lamps, given room by room, by a share from 0, dark, to 1. */
export function lightLamps(lamps: readonly Lamp[], share: number): void {
  if (share > 0 && !isDim) {
    isDim = true;
    lit.forEach(addLamps);
  }
  lampUniforms.lampLight.value = lamps.length > 0 ? share : 0;
  if (lampUniforms.lampLight.value === 0) return;
  for (const [i, { at, strength }] of lamps.entries()) lampUniforms.lampAt.value[i]?.set(...at, strength);
  const rooms = [...new Set(lamps.map(({ room }) => room))];
  const ends = (low: (room: Room) => number, high: (room: Room) => number): readonly [number, number] =>
    [Math.min(...rooms.map(low)) - ROUND, Math.max(...rooms.map(high)) + ROUND];
  const [[west, east], [north, south]] = [ends(({ x }) => x, ({ x, width }) => x + width), ends(({ z }) => z, ({ z, depth }) => z + depth)];
  const [wide, deep] = [east - west, south - north].map((side) => Math.min(LONGEST, Math.ceil(side / PLACE))) as [number, number];
  const rows = new Map(rooms.map((room) => [room, [lamps.findIndex((lamp) => lamp.room === room), lamps.filter((lamp) => lamp.room === room).length] as const]));
  const places = new Uint8Array(wide * deep * 2);
  for (let i = 0; i < wide * deep; i += 1) {
    const room = roomHolding(rooms, rooms[0]?.level ?? 0, west + (i % wide + 0.5) * PLACE, north + (Math.floor(i / wide) + 0.5) * PLACE);
    places.set((room && rows.get(room)) ?? [0, 0], i * 2);
  }
  lampMap.value.dispose();
  lampMap.value = mapOf(places, wide, deep);
  lampUniforms.lampGround.value.set(west, north, wide * PLACE, deep * PLACE);
}
