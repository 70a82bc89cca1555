/** Where a dragged piece comes to lie: its edges and centre on those of others, at walls, else on a grid of five centimetres. Pure. */
import type { Furniture, Room, Scene } from "../contract";
import { facesOf, footprint } from "./gaps";

/** What is nearer than this is lined up with [mm]. */
const REACH = 60;
const GRID = 50;
/** The back of a piece that stands at a wall is so far from its face [mm]. */
const BEHIND = 30;

/** A line that the piece was brought onto, in its room [mm]: along which axis it is measured, and from where to where it is drawn. */
export interface Guide {
  readonly axis: "x" | "z";
  readonly at: number;
  readonly reach: readonly [number, number];
}

export interface Snapped {
  readonly x: number;
  readonly z: number;
  readonly guides: readonly Guide[];
}

/** A line to be on, the place of the piece's centre that is, and how much it is liked: less is more. */
interface Line {
  readonly guide: Guide;
  readonly centre: number;
  readonly rank: number;
}

/** The lines along one axis for a piece of that extent: where its centre would have to be. */
function linesFor(axis: "x" | "z", scene: Pick<Scene, "wall_thickness">, room: Room, piece: Furniture, standsAtWall: boolean): Line[] {
  const own = footprint(piece);
  const across = axis === "x" ? "z" : "x";
  const half = (own[axis][1] - own[axis][0]) / 2;
  const back = { 0: ["z", true], 90: ["x", true], 180: ["z", false], 270: ["x", false] }[(piece.rotation ?? 0) % 360] ?? [];
  const walls = facesOf(room, scene.wall_thickness).filter((face) => face.axis === axis).map(({ at, isLow, reach }): Line => {
    const away = standsAtWall && back[0] === axis && back[1] === isLow ? BEHIND : 0;
    return { guide: { axis, at, reach }, centre: isLow ? at + away + half : at - away - half, rank: 0 };
  });
  const others = room.furniture.filter((one) => one.id !== piece.id && one.on !== piece.id && one.under !== piece.id).flatMap((one): Line[] => {
    const span = footprint(one);
    const reach = [Math.min(span[across][0], own[across][0]), Math.max(span[across][1], own[across][1])] as const;
    const [low, high] = span[axis];
    const edges = [low, high].flatMap((at) => [at + half, at - half].map((centre): Line => ({ guide: { axis, at, reach }, centre, rank: 1 })));
    return [...edges, { guide: { axis, at: (low + high) / 2, reach }, centre: (low + high) / 2, rank: 2 }];
  });
  const size = (axis === "x" ? room.width : room.depth) * 1000;
  const middle: Line = { guide: { axis, at: size / 2, reach: [0, (across === "x" ? room.width : room.depth) * 1000] }, centre: size / 2, rank: 3 };
  return [...walls, ...others, middle];
}

/** The centre on the grid: the lower edge in steps of five centimetres from the first wall's face. */
function onGrid(centre: number, half: number, thickness: number): number {
  const from = (thickness * 1000) / 2 + half;
  return Math.round((centre - from) / GRID) * GRID + from;
}

function along(axis: "x" | "z", scene: Pick<Scene, "wall_thickness">, room: Room, piece: Furniture, standsAtWall: boolean): { centre: number; guide: Guide | null } {
  const wished = piece[axis] * 1000;
  const near = linesFor(axis, scene, room, piece, standsAtWall).filter(({ centre }) => Math.abs(centre - wished) <= REACH);
  const [best] = near.sort((a, b) => Math.abs(a.centre - wished) - Math.abs(b.centre - wished) || a.rank - b.rank);
  const [low, high] = footprint(piece)[axis];
  return best ? { centre: best.centre, guide: best.guide } : { centre: onGrid(wished, (high - low) / 2, scene.wall_thickness), guide: null };
}

/** Where a piece comes to lie that is wished at its place in a room [m]. */
export function snapped(scene: Pick<Scene, "wall_thickness">, room: Room, piece: Furniture, standsAtWall = false): Snapped {
  const [x, z] = [along("x", scene, room, piece, standsAtWall), along("z", scene, room, piece, standsAtWall)];
  return { x: x.centre / 1000, z: z.centre / 1000, guides: [x.guide, z.guide].filter((guide) => guide !== null) };
}
