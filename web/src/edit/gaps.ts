/** How far a piece stands from the walls and from what is next to it, in whole millimetres: what the scene's own numbers say. */
import type { Furniture, Room, Scene, Side } from "../contract";

export interface Gap {
  readonly side: Side;
  /** To the face of the wall; null where there is none on that side. */
  readonly wall: number | null;
  /** To the nearest piece before the wall. */
  readonly piece: { readonly mm: number; readonly name: string } | null;
}

/** From west to east, from north to south [mm]. */
interface Span {
  readonly x: readonly [number, number];
  readonly z: readonly [number, number];
}

/** Each side: along which axis it lies, and whether towards its lower end. */
const SIDES: readonly (readonly [Side, "x" | "z", boolean])[] = [["north", "z", true], ["east", "x", false], ["south", "z", false], ["west", "x", true]];

function mm(metres: number): number {
  return Math.round(metres * 1000);
}

/** A piece's footprint; of one at an odd angle the rectangle around it. */
export function footprint({ x, z, width, depth, rotation }: Furniture): Span {
  const turn = ((rotation ?? 0) * Math.PI) / 180;
  const isSquare = (rotation ?? 0) % 90 === 0;
  const [cos, sin] = isSquare ? [Math.abs(Math.round(Math.cos(turn))), Math.abs(Math.round(Math.sin(turn)))] : [Math.abs(Math.cos(turn)), Math.abs(Math.sin(turn))];
  const [across, along] = [width * cos + depth * sin, width * sin + depth * cos];
  return { x: [mm(x - across / 2), mm(x + across / 2)], z: [mm(z - along / 2), mm(z + along / 2)] };
}

function overlap(a: readonly [number, number], b: readonly [number, number]): boolean {
  return a[0] < b[1] && b[0] < a[1];
}

/** The faces of a room's walls, each a line at a place along one axis, with its reach along the other [mm]. */
function facesOf(room: Room, thickness: number): { axis: "x" | "z"; at: number; isLow: boolean; reach: readonly [number, number] }[] {
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
      return overlap(span[across], own[across]) && gap >= 0 && (wall === null || gap < wall) ? [{ mm: gap, name: one.name.replaceAll("_", " ") }] : [];
    });
    return { side, wall, piece: near.sort((a, b) => a.mm - b.mm)[0] ?? null };
  });
}

/** A length as it is read: metres, to the millimetre where it is not of whole centimetres. */
export function lengthWords(gap: number): string {
  return `${(gap / 1000).toFixed(gap % 10 === 0 ? 2 : 3)} m`;
}

export class GapPanel {
  readonly #rows: HTMLElement;

  constructor(readonly host: HTMLElement) {
    this.#rows = host.querySelector("dl") as HTMLElement;
  }

  /** Shows the distances around a piece of a scene, `held` where it is in hand; hides them where the scene has none of that id. */
  show(scene: Scene | null, id: string | null, held: Furniture | null = null): void {
    const room = scene?.rooms.find((one) => one.furniture.some((piece) => piece.id === id));
    const piece = held ?? room?.furniture.find((one) => one.id === id);
    this.host.hidden = !room || !piece;
    if (scene && room && piece) this.#rows.replaceChildren(...gapsOf(scene, room, piece).flatMap((gap) => this.#row(gap)));
  }

  #row({ side, wall, piece }: Gap): HTMLElement[] {
    const said = [...(wall === null ? [] : [`${lengthWords(wall)} to the wall`]), ...(piece ? [`${lengthWords(piece.mm)} to ${piece.name}`] : [])];
    const term = Object.assign(document.createElement("dt"), { textContent: side });
    return [term, Object.assign(document.createElement("dd"), { textContent: said.join(", ") || "open" })];
  }
}
