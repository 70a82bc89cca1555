/** The bodies of a house that are shown as own assets: of each part of an asset one draw call for all bodies that show it. */
import { Group, InstancedMesh, Matrix4, Quaternion, Vector3, type Material } from "three";
import type { AssetLibrary } from "./asset_library";
import type { AssetPart } from "./asset_model";
import type { PlacedBody } from "./frame";

/** So many triangles of assets are drawn in a house; what goes beyond keeps its shape, the largest first. */
export const MOST_DRAWN = 4e6;
const UP = new Vector3(0, 1, 0);
const NOWHERE = new Matrix4().makeScale(0, 0, 0);

/** What brings a box of size 1 into a body's. */
export function boxMatrix({ x, y, z, turn, width, height, depth }: PlacedBody): Matrix4 {
  return new Matrix4().compose(new Vector3(x, y, z), new Quaternion().setFromAxisAngle(UP, turn), new Vector3(width, height, depth));
}

/** The numbers of the bodies that show each asset, as far as they are not too much together. */
function wantedBy(bodies: readonly PlacedBody[], library: AssetLibrary): Map<string, number[]> {
  const wanted = new Map<string, number[]>();
  bodies.forEach(({ asset }, number) => {
    if (asset && library.find(asset)) wanted.set(asset, [...(wanted.get(asset) ?? []), number]);
  });
  const cost = ([name, numbers]: readonly [string, readonly number[]]): number => (library.find(name)?.triangles ?? 0) * numbers.length;
  let drawn = 0;
  return new Map([...wanted].sort((a, b) => cost(a) - cost(b)).filter((one) => (drawn += cost(one)) <= MOST_DRAWN));
}

interface Shown {
  readonly meshes: readonly InstancedMesh[];
  readonly parts: readonly AssetPart[];
  readonly instance: number;
}

export class AssetMeshes {
  readonly root = new Group();
  readonly #shown = new Map<number, Shown>();
  #disposed = false;

  /** `arrived` is told the numbers of the bodies whose asset has come: place them. */
  constructor(bodies: readonly PlacedBody[], library: AssetLibrary, arrived: (numbers: readonly number[]) => void) {
    for (const [name, numbers] of wantedBy(bodies, library)) {
      void library.model(name).then((parts) => {
        if (!parts || this.#disposed) return;
        this.#show(parts, numbers);
        arrived(numbers);
      });
    }
  }

  #show(parts: readonly AssetPart[], numbers: readonly number[]): void {
    const meshes = parts.map(({ geometry, material }) => {
      const mesh = new InstancedMesh(geometry, material as Material, numbers.length);
      const clear = [material].flat().some((one) => one.transparent);
      Object.assign(mesh, { castShadow: !clear, receiveShadow: true, frustumCulled: false });
      return mesh;
    });
    numbers.forEach((number, instance) => this.#shown.set(number, { meshes, parts, instance }));
    this.root.add(...meshes);
  }

  /** Whether a body, by its number, is shown as its asset. */
  shows(number: number): boolean {
    return this.#shown.has(number);
  }

  /** Puts a body's asset into its box; null hides it. */
  place(number: number, body: PlacedBody | null): void {
    const shown = this.#shown.get(number);
    if (!shown) return;
    const box = body && boxMatrix(body);
    shown.meshes.forEach((mesh, i) => {
      mesh.setMatrixAt(shown.instance, box ? box.clone().multiply(shown.parts[i]?.place ?? NOWHERE) : NOWHERE);
      mesh.instanceMatrix.needsUpdate = true;
    });
  }

  /** What comes from now on is not shown. */
  dispose(): void {
    this.#disposed = true;
  }
}
