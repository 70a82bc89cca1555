/** Many rectangles as one geometry with colour and pattern a vertex: one draw call for all walls of a house. */
import { BufferAttribute, BufferGeometry, Color } from "three";
import type { Box } from "./boxes";
import { patternLayer, patternSpans } from "./patterns";
import type { Face, Point } from "./wall_faces";

export interface ColoredQuad {
  readonly corners: Face["corners"];
  readonly normal: Point;
  readonly color: string;
  /** The pattern laid over the colour, in metres of the house; none leaves it plain. */
  readonly pattern?: string;
  readonly roughness?: number;
}

const PLAIN = { pattern: "plain", roughness: 0.95 } as const;

type Corner = readonly [0 | 1, 0 | 1, 0 | 1];

const BOX_FACES: readonly { readonly normal: Point; readonly corners: readonly [Corner, Corner, Corner, Corner] }[] = [
  { normal: [1, 0, 0], corners: [[1, 0, 1], [1, 0, 0], [1, 1, 0], [1, 1, 1]] },
  { normal: [-1, 0, 0], corners: [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]] },
  { normal: [0, 1, 0], corners: [[0, 1, 1], [1, 1, 1], [1, 1, 0], [0, 1, 0]] },
  { normal: [0, -1, 0], corners: [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]] },
  { normal: [0, 0, 1], corners: [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] },
  { normal: [0, 0, -1], corners: [[1, 0, 0], [0, 0, 0], [0, 1, 0], [1, 1, 0]] },
];
const TRIANGLES = [0, 1, 2, 0, 2, 3];

/** The six faces of a box. */
export function quadsOf(box: Box, color: string): ColoredQuad[] {
  const at = ([i, j, k]: Corner): Point => [i ? box.x1 : box.x0, j ? box.y1 : box.y0, k ? box.z1 : box.z0];
  return BOX_FACES.map(({ normal, corners: [a, b, c, d] }) => ({ corners: [at(a), at(b), at(c), at(d)], normal, color }));
}

function write(into: Float32Array, at: number, values: Point): void {
  into[at] = values[0];
  into[at + 1] = values[1];
  into[at + 2] = values[2];
}

/** Writes where on its pattern a point of a face lies: along the face and up, in squares of the pattern. */
function writeWoven(into: Float32Array, at: number, [x, y, z]: Point, [nx, ny]: Point, span: number): void {
  into[at] = (ny !== 0 || nx === 0 ? x : z) / span;
  into[at + 1] = (ny !== 0 ? z : y) / span;
}

type Arrays = readonly [position: Float32Array, normal: Float32Array, color: Float32Array, weave: Float32Array];

function writeQuad([position, normals, colors, weave]: Arrays, i: number, quad: ColoredQuad, tint: Point): void {
  const { corners, normal, pattern = PLAIN.pattern, roughness = PLAIN.roughness } = quad;
  const layer = patternLayer(pattern);
  const span = patternSpans[layer] ?? 1;
  for (let j = 0; j < 4; j += 1) {
    const [at, woven, corner] = [i * 12 + j * 3, i * 16 + j * 4, corners[j] as Point];
    write(position, at, corner);
    write(normals, at, normal);
    write(colors, at, tint);
    writeWoven(weave, woven, corner, normal, span);
    weave[woven + 2] = layer;
    weave[woven + 3] = roughness;
  }
}

/** Merges rectangles into one indexed geometry; `weave` is the place on the pattern, its layer, the roughness. */
export function mergeQuads(quads: readonly ColoredQuad[]): BufferGeometry {
  const tints = new Map<string, Point>();
  const numbers = (each: number): Float32Array<ArrayBuffer> => new Float32Array(quads.length * 4 * each);
  const arrays = [numbers(3), numbers(3), numbers(3), numbers(4)] as const;
  const index = new Uint32Array(quads.length * 6);
  quads.forEach((quad, i) => {
    const tint = tints.get(quad.color) ?? (new Color(quad.color).toArray() as number[] as [number, number, number]);
    tints.set(quad.color, tint);
    writeQuad(arrays, i, quad, tint);
    for (let j = 0; j < 6; j += 1) index[i * 6 + j] = i * 4 + (TRIANGLES[j] as number);
  });
  const geometry = new BufferGeometry();
  ["position", "normal", "color", "weave"].forEach((name, k) => geometry.setAttribute(name, new BufferAttribute(arrays[k] as Float32Array, k < 3 ? 3 : 4)));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}
