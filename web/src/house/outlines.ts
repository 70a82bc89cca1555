/** Frames of thin bars around bodies: what is selected, pointed at, or in error. */
import { Mesh, MeshBasicMaterial } from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { bodyMatrix } from "./body_meshes";
import type { Box } from "./boxes";
import type { PlacedBody } from "./frame";
import { sharedMaterial } from "./shared_materials";
import { mergeQuads, quadsOf } from "./quad_mesh";

const BAR = 0.024;
const CLEARANCE = 0.02;

function bars(body: PlacedBody): Box[] {
  const [w, d, t] = [body.width / 2 + CLEARANCE, body.depth / 2 + CLEARANCE, BAR / 2];
  const [low, high] = [0, body.height + CLEARANCE];
  const boxes: Box[] = [];
  for (const y of [low + t, high]) {
    for (const z of [-d, d]) boxes.push({ x0: -w - t, x1: w + t, y0: y - t, y1: y + t, z0: z - t, z1: z + t });
    for (const x of [-w, w]) boxes.push({ x0: x - t, x1: x + t, y0: y - t, y1: y + t, z0: -d - t, z1: d + t });
  }
  for (const x of [-w, w]) {
    for (const z of [-d, d]) boxes.push({ x0: x - t, x1: x + t, y0: low, y1: high, z0: z - t, z1: z + t });
  }
  return boxes;
}

function lines(): MeshBasicMaterial {
  return new MeshBasicMaterial({ vertexColors: true, depthTest: false, transparent: true, toneMapped: false });
}

/** One mesh that frames all of the bodies, seen through what stands before them; null for none. */
export function outlinesOf(bodies: readonly PlacedBody[], color: string): Mesh | null {
  if (bodies.length === 0) return null;
  const frames = bodies.map((body) => mergeQuads(bars(body).flatMap((box) => quadsOf(box, color))).applyMatrix4(bodyMatrix(body)));
  const mesh = new Mesh(mergeGeometries(frames), sharedMaterial("outline", lines));
  for (const frame of frames) frame.dispose();
  mesh.renderOrder = 10;
  return mesh;
}
