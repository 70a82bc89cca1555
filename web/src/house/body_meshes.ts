/** Draws all bodies of a house in one batch, and tells which body a hit of a ray belongs to. */
import {
  BatchedMesh, BufferGeometry, CapsuleGeometry, Color, ConeGeometry, ExtrudeGeometry, Matrix4, MeshStandardMaterial,
  Quaternion, Shape, SphereGeometry, Vector3,
} from "three";
import { RoundedBoxGeometry } from "three/addons/geometries/RoundedBoxGeometry.js";
import type { PlacedBody } from "./frame";
import { partsOf, type Part, type PartShape } from "./shapes";

const UP = new Vector3(0, 1, 0);
const EDGE_RADIUS = 0.025;

/** A flat triangle of unit size that points to +z. */
function arrowGeometry(): BufferGeometry {
  const outline = new Shape().moveTo(-0.5, 0.5).lineTo(0, -0.5).lineTo(0.5, 0.5);
  return new ExtrudeGeometry(outline, { depth: 1, bevelEnabled: false }).translate(0, 0, -0.5).rotateX(-Math.PI / 2);
}

const UNIT_SHAPES: Readonly<Record<Exclude<PartShape, "block">, () => BufferGeometry>> = {
  capsule: () => new CapsuleGeometry(0.5, 1, 6, 14).scale(1, 0.5, 1),
  ball: () => new SphereGeometry(0.5, 16, 12),
  cone: () => new ConeGeometry(0.5, 1, 10),
  arrow: arrowGeometry,
};

/** A batch wants one layout: no index, positions and normals only. */
function plain(geometry: BufferGeometry): BufferGeometry {
  const loose = geometry.index ? geometry.toNonIndexed() : geometry;
  loose.deleteAttribute("uv");
  return loose;
}

/** A part's geometry: a block is built at its size, so that its rounding is not stretched; the rest is scaled. */
function geometryOf(part: Part): { key: string; build: () => BufferGeometry; scale: Vector3 } {
  const [width, height, depth] = part.size;
  if (part.shape !== "block") {
    return { key: part.shape, build: () => plain(UNIT_SHAPES[part.shape as keyof typeof UNIT_SHAPES]()), scale: new Vector3(...part.size) };
  }
  const radius = Math.min(EDGE_RADIUS, Math.min(width, height, depth) * 0.3);
  return {
    key: part.size.join(),
    build: () => plain(new RoundedBoxGeometry(width, height, depth, 1, radius)),
    scale: new Vector3(1, 1, 1),
  };
}

/** The place of a body in the house. */
export function bodyMatrix(body: PlacedBody): Matrix4 {
  const turn = new Quaternion().setFromAxisAngle(UP, body.turn);
  return new Matrix4().compose(new Vector3(body.x, body.y, body.z), turn, new Vector3(1, 1, 1));
}

function partMatrix(body: Matrix4, part: Part, scale: Vector3): Matrix4 {
  return new Matrix4().compose(new Vector3(...part.at), new Quaternion(), scale).premultiply(body);
}

/** Where a body is put: its footprint's centre and underside [m], its turn about +y [rad]; what is not said stays. */
export type BodyPose = Partial<Pick<PlacedBody, "x" | "y" | "z" | "turn">>;

interface Draft {
  readonly body: PlacedBody;
  readonly part: Part;
  readonly geometry: ReturnType<typeof geometryOf>;
}

/** The drawn bodies of a house. */
export class BodyMeshes {
  readonly mesh: BatchedMesh;
  readonly #owners: PlacedBody[] = [];

  constructor(bodies: readonly PlacedBody[]) {
    const drafts = bodies.flatMap((body) => partsOf(body).map((part): Draft => ({ body, part, geometry: geometryOf(part) })));
    const built = new Map<string, BufferGeometry>();
    for (const { geometry } of drafts) if (!built.has(geometry.key)) built.set(geometry.key, geometry.build());
    const vertices = [...built.values()].reduce((sum, geometry) => sum + (geometry.getAttribute("position")?.count ?? 0), 0);
    this.mesh = new BatchedMesh(Math.max(1, drafts.length), Math.max(1, vertices), 0, new MeshStandardMaterial({ roughness: 0.72 }));
    this.#fill(drafts, built);
    for (const geometry of built.values()) geometry.dispose();
  }

  #fill(drafts: readonly Draft[], built: ReadonlyMap<string, BufferGeometry>): void {
    const slots = new Map([...built].map(([key, geometry]) => [key, this.mesh.addGeometry(geometry)]));
    for (const { body, part, geometry } of drafts) {
      const instance = this.mesh.addInstance(slots.get(geometry.key) ?? 0);
      this.mesh.setMatrixAt(instance, partMatrix(bodyMatrix(body), part, geometry.scale));
      this.mesh.setColorAt(instance, new Color(part.color));
      this.#owners[instance] = body;
    }
    this.mesh.castShadow = true;
    this.mesh.receiveShadow = true;
    this.mesh.sortObjects = false;
    this.mesh.perObjectFrustumCulled = false;
  }

  /** Hides what hangs on walls where they are cut below its middle: nothing hangs in the air. */
  cutAt(height: number): void {
    this.#owners.forEach((body, instance) => {
      if (body.hung !== undefined) this.mesh.setVisibleAt(instance, body.hung <= height);
    });
  }

  /** Moves and turns a body without building anything anew; returns it in its new place, undefined where there is no such body. */
  place(id: string, pose: BodyPose): PlacedBody | undefined {
    let placed: PlacedBody | undefined;
    this.#owners.forEach((body, instance) => {
      if (body.id !== id) return;
      placed ??= { ...body, ...pose };
      const step = bodyMatrix(placed).multiply(bodyMatrix(body).invert());
      this.mesh.setMatrixAt(instance, step.multiply(this.mesh.getMatrixAt(instance, new Matrix4())));
      this.#owners[instance] = placed;
    });
    return placed;
  }

  /** The body that an instance of the batch is a part of. */
  bodyAt(instance: number | undefined): PlacedBody | undefined {
    return instance === undefined ? undefined : this.#owners[instance];
  }
}
