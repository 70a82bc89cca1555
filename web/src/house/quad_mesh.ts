/** Many rectangles as one geometry with a colour a vertex: one draw call for all walls of a house. */
import { BufferAttribute, BufferGeometry, Color } from "three";
import type { Box } from "./boxes";
import type { Face, Point } from "./wall_faces";

export interface ColoredQuad {
  readonly corners: Face["corners"];
  readonly normal: Point;
  readonly color: string;
}

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

/** Merges rectangles into one indexed geometry. */
export function mergeQuads(quads: readonly ColoredQuad[]): BufferGeometry {
  const colors = new Map([...new Set(quads.map((quad) => quad.color))].map((color) => [color, new Color(color).toArray()]));
  const arrays = { position: new Float32Array(quads.length * 12), normal: new Float32Array(quads.length * 12), color: new Float32Array(quads.length * 12) };
  const index = new Uint32Array(quads.length * 6);
  quads.forEach(({ corners, normal, color }, i) => {
    corners.forEach((corner, j) => {
      const at = i * 12 + j * 3;
      arrays.position.set(corner, at);
      arrays.normal.set(normal, at);
      arrays.color.set(colors.get(color) ?? [], at);
    });
    TRIANGLES.forEach((corner, j) => (index[i * 6 + j] = i * 4 + corner));
  });
  const geometry = new BufferGeometry();
  for (const [name, array] of Object.entries(arrays)) geometry.setAttribute(name, new BufferAttribute(array, 3));
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}
