/** A .glb as the page draws it: its meshes, placed in a box of size 1 around the middle of its footprint at its underside, front at +z. */
import { Matrix4, Mesh, Vector3, type BufferGeometry, type Material, type Object3D } from "three";
import type { CatalogAsset } from "../contract";

/** More parts than this are too many draw calls for one asset. */
export const MOST_PARTS = 64;

export interface AssetPart {
  readonly geometry: BufferGeometry;
  readonly material: Material | Material[];
  readonly place: Matrix4;
}

/** How far each front is turned about +y to look to +z, in quarters. */
const QUARTERS: Readonly<Record<CatalogAsset["front"], number>> = { "+z": 0, "-x": 1, "-z": 2, "+x": 3 };

/** What brings an asset's own box into the box of size 1. */
export function unitOf({ low, high, front }: Pick<CatalogAsset, "low" | "high" | "front">): Matrix4 {
  const middle = new Vector3((low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2);
  const quarters = QUARTERS[front];
  const extents: readonly [number, number, number] = [high[0] - low[0], high[1] - low[1], high[2] - low[2]];
  const [across, along] = quarters % 2 === 0 ? [extents[0], extents[2]] : [extents[2], extents[0]];
  return new Matrix4().makeScale(1 / across, 1 / extents[1], 1 / along)
    .multiply(new Matrix4().makeRotationY((quarters * Math.PI) / 2))
    .multiply(new Matrix4().makeTranslation(middle.negate()));
}

/** The meshes below a node; they and their materials outlive the houses that show them. */
export function partsOf(scene: Object3D, asset: CatalogAsset): AssetPart[] {
  const unit = unitOf(asset);
  const parts: AssetPart[] = [];
  scene.updateMatrixWorld(true);
  scene.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const { geometry, material } = node as Mesh<BufferGeometry, Material | Material[]>;
    geometry.userData.kept = true;
    for (const one of [material].flat()) one.userData.kept = true;
    parts.push({ geometry, material, place: unit.clone().multiply(node.matrixWorld) });
  });
  if (parts.length === 0 || parts.length > MOST_PARTS) throw new Error(`has ${parts.length} parts`);
  return parts;
}

/** Reads a .glb; the reader is fetched when the first one is. */
export async function readAsset(content: ArrayBuffer, asset: CatalogAsset): Promise<AssetPart[]> {
  const { GLTFLoader } = await import("three/addons/loaders/GLTFLoader.js");
  const { scene } = await new GLTFLoader().parseAsync(content, "");
  return partsOf(scene, asset);
}
