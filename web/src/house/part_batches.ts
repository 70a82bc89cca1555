/** Parts drawn in few batches: one a solid, those that are seen through apart. Each part is an instance with its own size and paint. */
import { Color, Group, InstancedBufferAttribute, InstancedMesh, Sphere, Vector3, BufferGeometry } from "three";
import type { PlacedBody } from "./frame";
import { solidGeometry, solidOf, type Solid } from "./part_geometry";
import { partMaterials } from "./part_shader";
import { patternLayer } from "./patterns";
import type { Part } from "./parts";

/** Roundings [m]: of a soft-edged block, never more than this share of its thinnest side. */
const ROUNDING = 0.035;
const ROUNDING_SHARE = 0.42;

/** A part of a body, and where it went. */
export interface DrawnPart {
  readonly part: Part;
  readonly batch: InstancedMesh;
  readonly instance: number;
}

interface Draft {
  readonly solid: Solid;
  readonly clear: boolean;
  readonly parts: { readonly part: Part; readonly body: number }[];
}

const linear = new Map<string, readonly [number, number, number]>();

function linearColor(color: string): readonly [number, number, number] {
  const known = linear.get(color) ?? new Color(color).toArray();
  linear.set(color, known as [number, number, number]);
  return known as [number, number, number];
}

function shapeNumber({ form, size, taper }: Part): number {
  if (form === "rounded") return Math.min(ROUNDING, Math.min(...size) * ROUNDING_SHARE);
  return form === "cylinder" || form === "cone" ? taper : 0;
}

/** A part's size as its solid has it, before it is laid along its axis. */
function standing({ axis, size: [x, y, z] }: Part): readonly [number, number, number] {
  if (axis === "x") return [y, x, z];
  return axis === "z" ? [x, z, y] : [x, y, z];
}

/** Writes the place of a part of a body into the sixteen numbers of its matrix. */
export function writePlace(into: Float32Array, offset: number, { axis, at: [x, y, z] }: Part, body: PlacedBody): void {
  const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
  const columns: readonly number[] =
    axis === "x" ? [0, -1, 0, cos, 0, -sin, sin, 0, cos] : axis === "z" ? [cos, 0, -sin, sin, 0, cos, 0, -1, 0] : [cos, 0, -sin, 0, 1, 0, sin, 0, cos];
  for (let column = 0; column < 3; column += 1) {
    for (let row = 0; row < 3; row += 1) into[offset + column * 4 + row] = columns[column * 3 + row] ?? 0;
    into[offset + column * 4 + 3] = 0;
  }
  into[offset + 12] = body.x + x * cos + z * sin;
  into[offset + 13] = body.y + y;
  into[offset + 14] = body.z - x * sin + z * cos;
  into[offset + 15] = 1;
}

/** Gives a drawn part another size; what it is made of stays. */
export function writeSize(batch: InstancedMesh, instance: number, part: Part): void {
  const spans = batch.geometry.getAttribute("span");
  spans.setXYZW(instance, ...standing(part), shapeNumber(part));
  spans.needsUpdate = true;
}

/** Draws nothing of a part: all of its points coincide. */
export function writeNothing(into: Float32Array, offset: number): void {
  into.fill(0, offset, offset + 15);
}

/** A batch's geometry; the solid's own attributes outlive it. */
class PartGeometry extends BufferGeometry {
  constructor(readonly solid: BufferGeometry) {
    super();
    for (const [name, attribute] of Object.entries(solid.attributes)) this.setAttribute(name, attribute);
    this.setIndex(solid.index);
  }

  override dispose(): void {
    for (const name of Object.keys(this.solid.attributes)) this.deleteAttribute(name);
    this.setIndex(null);
    super.dispose();
  }
}

function instanced({ solid, clear, parts }: Draft): InstancedMesh {
  const geometry = new PartGeometry(solidGeometry(solid));
  const arrays = { span: new Float32Array(parts.length * 4), tint: new Float32Array(parts.length * 4), finish: new Float32Array(parts.length * 4) };
  parts.forEach(({ part }, i) => {
    const { paint } = part;
    arrays.span.set([...standing(part), shapeNumber(part)], i * 4);
    arrays.tint.set([...linearColor(paint.color), paint.opacity], i * 4);
    arrays.finish.set([Math.max(0.05, paint.roughness), paint.metalness, paint.glow, patternLayer(paint.texture)], i * 4);
  });
  for (const [name, array] of Object.entries(arrays)) geometry.setAttribute(name, new InstancedBufferAttribute(array, 4));
  const materials = partMaterials();
  const mesh = new InstancedMesh(geometry, clear ? materials.clear : materials.solid, parts.length);
  Object.assign(mesh, { castShadow: !clear, receiveShadow: true, frustumCulled: false, customDepthMaterial: materials.shadow });
  mesh.boundingSphere = new Sphere(new Vector3(), 1);
  if (clear) mesh.renderOrder = 2;
  return mesh;
}

/** Draws the parts of bodies; returns the batches and, body by body, its drawn parts. */
export function batchesOf(bodies: readonly PlacedBody[], parts: readonly (readonly Part[])[]): { root: Group; drawn: DrawnPart[][] } {
  const drafts = new Map<string, Draft>();
  parts.forEach((ofBody, body) => {
    for (const part of ofBody) {
      const [solid, clear] = [solidOf(part.form), part.paint.opacity < 1];
      const key = `${solid} ${clear}`;
      const draft = drafts.get(key) ?? { solid, clear, parts: [] };
      drafts.set(key, draft);
      draft.parts.push({ part, body });
    }
  });
  const root = new Group();
  const drawn: DrawnPart[][] = bodies.map(() => []);
  for (const draft of drafts.values()) {
    const batch = instanced(draft);
    draft.parts.forEach(({ part, body }, instance) => {
      const placed = bodies[body];
      if (placed) writePlace(batch.instanceMatrix.array as Float32Array, instance * 16, part, placed);
      drawn[body]?.push({ part, batch, instance });
    });
    root.add(batch);
  }
  return { root, drawn };
}
