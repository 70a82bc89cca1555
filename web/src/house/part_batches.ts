/** Parts drawn in few batches: one a solid, those that are seen through apart. Each part is an instance with its own size and paint. */
import {
  BufferGeometry, Color, InstancedBufferAttribute, InstancedInterleavedBuffer, InstancedMesh, InterleavedBufferAttribute, Sphere, Vector3,
} from "three";
import type { PlacedBody } from "./frame";
import { movedWith, turnedWith, type Swing } from "./fronts";
import type { Paint } from "./paints";
import { solidGeometry, solidOf, SOLIDS, type Solid } from "./part_geometry";
import { partMaterials } from "./part_shader";
import { patternLayer } from "./patterns";
import type { Part } from "./parts";

/** Roundings [m]: of a soft-edged block, never more than this share of its thinnest side. */
const ROUNDING = 0.035;
const ROUNDING_SHARE = 0.42;
/** Every solid can be drawn twice: solid, and seen through. */
const BATCHES = SOLIDS.length * 2;
const MATRIX = 16;
/** The numbers of an instance's look: span, tint and finish, as the shader has them. */
const LOOK = 12;
const LOOKS = ["span", "tint", "finish"] as const;

function batchOf(part: Part): number {
  return SOLIDS.indexOf(solidOf(part)) * 2 + (part.paint.opacity < 1 ? 1 : 0);
}

function shapeNumber({ form, size, taper }: Part): number {
  if (form === "rounded") return Math.min(ROUNDING, Math.min(size[0], size[1], size[2]) * ROUNDING_SHARE);
  return form === "cylinder" || form === "cone" ? taper : 0;
}

/** What is nearly black is lifted: else its shape is lost in the shade. */
function lifted(color: Color): number[] {
  const lift = 0.032 * Math.exp(-16 * (0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b));
  return color.toArray().map((share) => share + lift);
}

/** A paint's tint and finish. */
function painted({ color, opacity, roughness, metalness, glow, texture }: Paint): number[] {
  return [...lifted(new Color(color)), opacity, Math.max(0.05, roughness), metalness, glow, patternLayer(texture)];
}

const paints = new WeakMap<Paint, readonly number[]>();

/** Writes a part's size as its solid has it, before it is laid along its axis, and its shape's number. */
function writeSpan(into: Float32Array, offset: number, part: Part): void {
  const { axis, size: [x, y, z] } = part;
  into[offset] = axis === "x" ? y : x;
  into[offset + 1] = axis === "x" ? x : axis === "z" ? z : y;
  into[offset + 2] = axis === "z" ? y : z;
  into[offset + 3] = shapeNumber(part);
}

function writeLook(into: Float32Array, offset: number, part: Part): void {
  writeSpan(into, offset, part);
  const known = paints.get(part.paint) ?? painted(part.paint);
  paints.set(part.paint, known);
  for (let i = 0; i < known.length; i += 1) into[offset + 4 + i] = known[i] ?? 0;
}

const looks = new WeakMap<readonly Part[], Float32Array>();

/** The looks of a body's parts, kept for as long as its parts are. */
function looksOf(parts: readonly Part[]): Float32Array {
  const known = looks.get(parts);
  if (known) return known;
  const made = new Float32Array(parts.length * LOOK);
  for (let i = 0; i < parts.length; i += 1) writeLook(made, i * LOOK, parts[i] as Part);
  looks.set(parts, made);
  return made;
}

function writeColumn(into: Float32Array, offset: number, x: number, y: number, z: number): void {
  into[offset] = x;
  into[offset + 1] = y;
  into[offset + 2] = z;
  into[offset + 3] = 0;
}

/** Which of a body's axes, and which way, the columns of a part's matrix are that lies along an axis. */
const LAID = { x: [[0, -1, 0], [1, 0, 0], [0, 0, 1]], y: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], z: [[1, 0, 0], [0, 0, 1], [0, -1, 0]] } as const;

/** Writes the place of a part that has moved with a front of its body. */
function writeSwung(into: Float32Array, offset: number, { axis, at }: Part, body: PlacedBody, swing: Swing): void {
  const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
  LAID[axis].forEach((column, k) => {
    const [x, y, z] = turnedWith(column, swing);
    writeColumn(into, offset + 4 * k, x * cos + z * sin, y, z * cos - x * sin);
  });
  const [x, y, z] = movedWith(at, swing);
  writeColumn(into, offset + 12, body.x + x * cos + z * sin, body.y + y, body.z - x * sin + z * cos);
  into[offset + 15] = 1;
}

/** Writes the place of a part of a body into the sixteen numbers of its matrix. */
export function writePlace(into: Float32Array, offset: number, part: Part, body: PlacedBody, swing?: Swing): void {
  if (swing) {
    writeSwung(into, offset, part, body, swing);
    return;
  }
  const { axis, at } = part;
  const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
  if (axis === "x") {
    writeColumn(into, offset, 0, -1, 0);
    writeColumn(into, offset + 4, cos, 0, -sin);
  } else writeColumn(into, offset, cos, 0, -sin);
  if (axis === "y") writeColumn(into, offset + 4, 0, 1, 0);
  if (axis === "z") {
    writeColumn(into, offset + 4, sin, 0, cos);
    writeColumn(into, offset + 8, 0, -1, 0);
  } else writeColumn(into, offset + 8, sin, 0, cos);
  writeColumn(into, offset + 12, body.x + at[0] * cos + at[2] * sin, body.y + at[1], body.z - at[0] * sin + at[2] * cos);
  into[offset + 15] = 1;
}

/** A batch's geometry; the solid's own attributes outlive it. */
class PartGeometry extends BufferGeometry {
  constructor(readonly solid: BufferGeometry, ofAll: InstancedInterleavedBuffer) {
    super();
    for (const [name, attribute] of Object.entries(solid.attributes)) this.setAttribute(name, attribute);
    this.setIndex(solid.index);
    LOOKS.forEach((name, i) => this.setAttribute(name, new InterleavedBufferAttribute(ofAll, 4, i * 4)));
  }

  override dispose(): void {
    for (const name of Object.keys(this.solid.attributes)) this.deleteAttribute(name);
    this.setIndex(null);
    super.dispose();
  }
}

/** One batch, and the numbers of its instances: to be written before it is first drawn. */
interface Batch {
  readonly mesh: InstancedMesh;
  readonly places: Float32Array;
  readonly looks: InstancedInterleavedBuffer;
}

function batchFor(number: number, count: number): Batch {
  const clear = number % 2 === 1;
  const places = new Float32Array(count * MATRIX);
  const ofAll = new InstancedInterleavedBuffer(new Float32Array(count * LOOK), LOOK);
  const materials = partMaterials();
  const geometry = new PartGeometry(solidGeometry(SOLIDS[number >> 1] as Solid), ofAll);
  // Made for none: three would write every matrix once, only to have it written again.
  const mesh = new InstancedMesh(geometry, clear ? materials.clear : materials.solid, 0);
  mesh.instanceMatrix = new InstancedBufferAttribute(places, MATRIX);
  mesh.count = count;
  Object.assign(mesh, { castShadow: !clear, receiveShadow: true, frustumCulled: false, customDepthMaterial: materials.shadow });
  mesh.boundingSphere = new Sphere(new Vector3(), 1);
  if (clear) mesh.renderOrder = 2;
  return { mesh, places, looks: ofAll };
}

/** The parts of bodies, drawn. Of a body's parts those of one batch are neighbours there. */
export class PartBatches {
  readonly meshes: readonly InstancedMesh[];
  readonly #batches: readonly (Batch | undefined)[];
  readonly #parts: readonly (readonly Part[])[];
  /** Which of a batch's instances is a body's first; body by body the number for each batch. */
  readonly #firsts: Int32Array;
  /** Where the parts of the body in hand go next. */
  readonly #next = new Int32Array(BATCHES);

  constructor(bodies: readonly PlacedBody[], parts: readonly (readonly Part[])[]) {
    this.#parts = parts;
    this.#firsts = new Int32Array(bodies.length * BATCHES);
    this.#batches = Array.from(this.#count(), (count, number) => (count > 0 ? batchFor(number, count) : undefined));
    this.meshes = this.#batches.flatMap((batch) => batch?.mesh ?? []);
    bodies.forEach((body, number) => this.#write(number, body));
  }

  /** How many instances every batch has. */
  #count(): Int32Array {
    const counts = new Int32Array(BATCHES);
    this.#parts.forEach((own, body) => {
      this.#firsts.set(counts, body * BATCHES);
      for (const part of own) counts[batchOf(part)] = (counts[batchOf(part)] as number) + 1;
    });
    return counts;
  }

  #each(body: number, visit: (part: Part, number: number, batch: Batch, instance: number) => void): void {
    const [next, own] = [this.#next, this.#parts[body] ?? []];
    for (let i = 0; i < BATCHES; i += 1) next[i] = this.#firsts[body * BATCHES + i] as number;
    for (let i = 0; i < own.length; i += 1) {
      const number = batchOf(own[i] as Part);
      visit(own[i] as Part, i, this.#batches[number] as Batch, next[number] as number);
      next[number] = (next[number] as number) + 1;
    }
  }

  #write(number: number, body: PlacedBody): void {
    const own = looksOf(this.#parts[number] ?? []);
    this.#each(number, (part, i, { places, looks: { array } }, instance) => {
      writePlace(places, instance * MATRIX, part, body);
      for (let k = 0; k < LOOK; k += 1) array[instance * LOOK + k] = own[i * LOOK + k] as number;
    });
  }

  /** Puts a body's parts anew, as large as they now are; of a part that is not there all points coincide. */
  place(number: number, body: PlacedBody, shown: readonly (Part | null)[] = [], swingOf?: (front: string | undefined) => Swing | undefined): void {
    this.#each(number, (own, i, { mesh, places, looks: spans }, instance) => {
      const part = shown[i];
      if (part) writePlace(places, instance * MATRIX, part, body, swingOf?.(part.front));
      else places.fill(0, instance * MATRIX, instance * MATRIX + MATRIX - 1);
      mesh.instanceMatrix.needsUpdate = true;
      if (!part || part === own) return;
      writeSpan(spans.array as Float32Array, instance * LOOK, part);
      spans.needsUpdate = true;
    });
  }
}
