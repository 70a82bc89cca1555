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

/** Where on its pattern a point of a face lies: along the face and up, in squares of the pattern. */
function wovenAt([x, y, z]: Point, [nx, ny]: Point, span: number): [number, number] {
  if (ny !== 0) return [x / span, z / span];
  return [(nx === 0 ? x : z) / span, y / span];
}

/** Merges rectangles into one indexed geometry; `weave` is the place on the pattern, its layer, the roughness. */
export function mergeQuads(quads: readonly ColoredQuad[]): BufferGeometry {
  const colors = new Map([...new Set(quads.map((quad) => quad.color))].map((color) => [color, new Color(color).toArray()]));
  const points = (): Float32Array<ArrayBuffer> => new Float32Array(quads.length * 12);
  const [position, normals, tints, weave] = [points(), points(), points(), new Float32Array(quads.length * 16)];
  const index = new Uint32Array(quads.length * 6);
  quads.forEach(({ corners, normal, color, pattern = PLAIN.pattern, roughness = PLAIN.roughness }, i) => {
    const layer = patternLayer(pattern);
    const [tint, span] = [colors.get(color) ?? [], patternSpans[layer] ?? 1];
    corners.forEach((corner, j) => {
      const at = i * 12 + j * 3;
      position.set(corner, at);
      normals.set(normal, at);
      tints.set(tint, at);
      weave.set([...wovenAt(corner, normal, span), layer, roughness], i * 16 + j * 4);
    });
    TRIANGLES.forEach((corner, j) => (index[i * 6 + j] = i * 4 + corner));
  });
  const geometry = new BufferGeometry();
  for (const [name, array] of Object.entries({ position, normal: normals, color: tints })) geometry.setAttribute(name, new BufferAttribute(array, 3));
  geometry.setAttribute("weave", new BufferAttribute(weave, 4));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}
