/** How far a piece stands from the walls and from what is next to it, in whole millimetres: what the scene's own numbers say. */
import type { Body, Furniture, Room, Scene, Side } from "../contract";

export interface Gap {
  readonly side: Side;
  /** To the face of the wall; null where there is none on that side. */
  readonly wall: number | null;
  /** To the nearest piece before the wall; `at`: the middle of the stretch along which they face each other. */
  readonly piece: { readonly mm: number; readonly name: string; readonly at: number } | null;
}

/** From west to east, from north to south [mm]. */
export interface Span {
  readonly x: readonly [number, number];
  readonly z: readonly [number, number];
}

/** Each side: along which axis it lies, and whether towards its lower end. */
export const SIDES: readonly (readonly [Side, "x" | "z", boolean])[] = [["north", "z", true], ["east", "x", false], ["south", "z", false], ["west", "x", true]];

function mm(metres: number): number {
  return Math.round(metres * 1000);
}

/** A piece's footprint; of one at an odd angle the rectangle around it. */
export function footprint({ x, z, width, depth, rotation }: Pick<Body, "x" | "z" | "width" | "depth" | "rotation">): Span {
  const turn = ((rotation ?? 0) * Math.PI) / 180;
  const isSquare = (rotation ?? 0) % 90 === 0;
  const [cos, sin] = isSquare ? [Math.abs(Math.round(Math.cos(turn))), Math.abs(Math.round(Math.sin(turn)))] : [Math.abs(Math.cos(turn)), Math.abs(Math.sin(turn))];
  const [across, along] = [width * cos + depth * sin, width * sin + depth * cos];
  return { x: [mm(x - across / 2), mm(x + across / 2)], z: [mm(z - along / 2), mm(z + along / 2)] };
}

function overlap(a: readonly [number, number], b: readonly [number, number]): boolean {
  return a[0] < b[1] && b[0] < a[1];
}

/** A wall's face: `isLow` where the room lies on the side of greater coordinates. */
export interface Face {
  readonly axis: "x" | "z";
  readonly at: number;
  readonly isLow: boolean;
  readonly reach: readonly [number, number];
}

/** The faces of a room's walls, each a line at a place along one axis, with its reach along the other [mm]. */
export function facesOf(room: Room, thickness: number): Face[] {
  const { width, depth } = room;
  const corners = room.outline && room.outline.length > 2 ? room.outline : [[0, 0], [width, 0], [width, depth], [0, depth]] as const;
  const area = corners.reduce((sum, [x, z], i) => { const [nextX, nextZ] = corners[(i + 1) % corners.length] ?? [x, z]; return sum + x * nextZ - nextX * z; }, 0);
  return corners.flatMap(([x, z], i) => {
    const [nextX, nextZ] = corners[(i + 1) % corners.length] ?? [x, z];
    const isAlongX = z === nextZ;
    if (!isAlongX && x !== nextX) return []; // a slanting wall has no one distance
    const isLow = (isAlongX ? nextX > x : nextZ < z) === area > 0;
    const line = isAlongX ? z : x;
    const ends = isAlongX ? [x, nextX] : [z, nextZ];
    return [{ axis: isAlongX ? "z" as const : "x" as const, at: mm(line + (isLow ? thickness : -thickness) / 2), isLow, reach: [mm(Math.min(...ends)), mm(Math.max(...ends))] as const }];
  });
}

/** The middle of what two stretches have in common. */
function middle(a: readonly [number, number], b: readonly [number, number]): number {
  return (Math.max(a[0], b[0]) + Math.min(a[1], b[1])) / 2;
}

/** How far a piece is from what is around it in its room, side by side. */
export function gapsOf(scene: Pick<Scene, "wall_thickness">, room: Room, piece: Furniture): Gap[] {
  const own = footprint(piece);
  const faces = facesOf(room, scene.wall_thickness);
  const isLevel = (other: Furniture): boolean => overlap([mm(piece.y), mm(piece.y + piece.height)], [mm(other.y), mm(other.y + other.height)]);
  const others = room.furniture.filter((one) => one.id !== piece.id && one.on !== piece.id && piece.on !== one.id && isLevel(one));
  return SIDES.map(([side, axis, isLow]) => {
    const across = axis === "x" ? "z" : "x";
    const edge = own[axis][isLow ? 0 : 1];
    const to = (line: number): number => (isLow ? edge - line : line - edge);
    const walls = faces.filter((face) => face.axis === axis && face.isLow === isLow && overlap(face.reach, own[across])).map(({ at }) => to(at));
    const ahead = walls.filter((gap) => gap >= -scene.wall_thickness * 1000);
    const wall = ahead.length > 0 ? Math.min(...ahead) : null;
    const near = others.flatMap((one) => {
      const span = footprint(one);
      const gap = to(span[axis][isLow ? 1 : 0]);
      return overlap(span[across], own[across]) && gap >= 0 && (wall === null || gap < wall) ? [{ mm: gap, name: one.name, at: middle(span[across], own[across]) }] : [];
    });
    return { side, wall, piece: near.sort((a, b) => a.mm - b.mm)[0] ?? null };
  });
}
