/** What small pictures show: a kind by itself, or a room with what stands in it. */
import type { Vector } from "../view/cameras";
import { PRESETS } from "../view/cameras";
import type { Sitter } from "../view/portraits";
import type { Scene } from "../contract";
import { BodyMeshes } from "./body_meshes";
import { disposeOf } from "./dispose";
import type { PlacedBody } from "./frame";
import { House } from "./house";
import type { ShapeBook } from "./shapes";
import { cutAll } from "./wall_cut";

/** So high above the house that none of its shadows falls on it [m]. */
const ALOFT = 400;
/** How high a pictured room's walls are [m]. */
const WALLS = 1;
const FALLBACK = "#8b949e";

/** A kind as far as its looks go: its key, its size [m] and colour. */
export interface Looks {
  readonly key: string;
  readonly name: string;
  readonly size: readonly [number, number, number];
  readonly color: string | null;
}

export function kindSitter({ key, name, size: [width, depth, height], color }: Looks, book: ShapeBook, style: string | null): Sitter {
  const body: PlacedBody = { id: key, name, kind: "furniture", shape: key, x: 0, y: ALOFT, z: 0, turn: 0, width, depth, height, color: color ?? FALLBACK };
  const { root } = new BodyMeshes([body], book, style);
  const outline = [-0.5, 0.5].flatMap((x) => [0, 1].flatMap((y) => [-0.5, 0.5].map((z): Vector => [x * width, ALOFT + y * height, z * depth])));
  return { root, outline, preset: PRESETS.corner, dispose: () => disposeOf(root) };
}

/** A scene of one room. */
export function roomSitter(scene: Scene, book: ShapeBook): Sitter | null {
  if (scene.rooms.length === 0) return null;
  const house = new House(scene, book);
  house.cutAt(cutAll(WALLS));
  house.root.position.y = ALOFT;
  const outline = house.outline.map(([x, y, z]): Vector => [x, y + ALOFT, z]);
  return { root: house.root, outline, preset: PRESETS.top, dispose: () => house.dispose() };
}
