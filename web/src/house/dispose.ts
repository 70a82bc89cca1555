/** Gives back what a part of the scene holds on the graphics card. */
import { BatchedMesh, InstancedMesh, Mesh, type Object3D } from "three";

/** Disposes of every geometry and material below `root` and takes it out of its parent. What is kept for the next house stays. */
export function disposeOf(root: Object3D): void {
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    if (node instanceof BatchedMesh || node instanceof InstancedMesh) node.dispose();
    if (!node.geometry.userData.kept) node.geometry.dispose();
    for (const material of [node.material].flat()) if (!material.userData.kept) material.dispose();
  });
  root.removeFromParent();
}
