/** What light falls on: where a processor draws, without highlights. They cost a fifth of a frame, and from outside next to nothing of them is seen. */
import { MeshLambertMaterial, MeshStandardMaterial, type MeshStandardMaterialParameters } from "three";

export type LitMaterial = MeshLambertMaterial | MeshStandardMaterial;

let isPlain = false;

/** From now on highlights are left out; to be called before anything is built. */
export function lightPlainly(): void {
  isPlain = true;
}

export function litMaterial({ roughness = 1, ...look }: MeshStandardMaterialParameters): LitMaterial {
  return isPlain ? new MeshLambertMaterial(look) : new MeshStandardMaterial({ roughness, ...look });
}
