/** Door leaves: all in one instanced mesh, opened and closed by a click. */
import { BoxGeometry, Color, InstancedMesh, Matrix4, MeshStandardMaterial, Quaternion, Vector3 } from "three";
import { LEAF_THICKNESS, type Leaf } from "./door_leaves";
import { keptMaterial } from "./kept";

const UP = new Vector3(0, 1, 0);
export const DOOR_COLORS = { entrance: "#c0392b", inner: "#96683f", garage: "#aab3bd" } as const;
const SECONDS = 0.45;
/** What stays visible of a rolled-up panel. */
const ROLLED = 0.06;

function colorOf(leaf: Leaf): string {
  if (leaf.mainEntrance) return DOOR_COLORS.entrance;
  return leaf.motion === "roll" ? DOOR_COLORS.garage : DOOR_COLORS.inner;
}

/** Slow at both ends. */
function eased(share: number): number {
  return share * share * (3 - 2 * share);
}

/** A leaf's place, `open` from 0 to 1, with what is above `cut` [m] taken off. */
export function leafMatrix(leaf: Leaf, open: number, cut: number): Matrix4 {
  const swung = leaf.motion === "swing" ? open : 0;
  const lifted = leaf.motion === "roll" ? open * (1 - ROLLED) * leaf.height : 0;
  const bottom = leaf.hinge.y + lifted;
  const top = Math.min(leaf.hinge.y + leaf.height, cut);
  const turn = new Quaternion().setFromAxisAngle(UP, leaf.closedAngle + swung * leaf.turn);
  const size = top > bottom ? new Vector3(leaf.width, top - bottom, LEAF_THICKNESS) : new Vector3(0, 0, 0);
  return new Matrix4().compose(new Vector3(leaf.hinge.x, bottom, leaf.hinge.z), turn, size);
}

/** The doors of a house; `step` moves those under way. */
export class Doors {
  readonly mesh: InstancedMesh;
  readonly #wanted: number[];
  readonly #open: number[];
  #cut = Number.POSITIVE_INFINITY;

  constructor(readonly leaves: readonly Leaf[]) {
    const unit = new BoxGeometry(1, 1, 1).translate(0.5, 0.5, 0);
    this.mesh = new InstancedMesh(unit, keptMaterial("door", () => new MeshStandardMaterial({ roughness: 0.6 })), leaves.length);
    this.#wanted = leaves.map(() => 0);
    this.#open = leaves.map(() => 0);
    leaves.forEach((leaf, i) => this.mesh.setColorAt(i, new Color(colorOf(leaf))));
    this.mesh.castShadow = true;
    this.mesh.receiveShadow = true;
    this.#place();
  }

  /** Cuts the leaves at the height of the walls [m]. */
  cutAt(height: number): void {
    this.#cut = height;
    this.#place();
  }

  /** Opens a closed leaf, closes an open one. */
  toggle(index: number | undefined): void {
    if (index !== undefined && this.#wanted[index] !== undefined) this.#wanted[index] = 1 - this.#wanted[index];
  }

  /** The ids of the leaves that are open or opening. */
  get open(): string[] {
    return this.leaves.filter((_, i) => this.#wanted[i] === 1).map((leaf) => leaf.id);
  }

  /** How far a leaf is turned from the direction of +x now [rad]. */
  angleOf(index: number): number {
    const leaf = this.leaves[index];
    const open = leaf?.motion === "swing" ? eased(this.#open[index] ?? 0) : 0;
    return leaf ? leaf.closedAngle + open * leaf.turn : 0;
  }

  /** Moves the leaves by `seconds`; true while one is under way. */
  step(seconds: number): boolean {
    let moving = false;
    this.#wanted.forEach((goal, i) => {
      const now = this.#open[i] ?? goal;
      if (now === goal) return;
      const travel = Math.min(Math.abs(goal - now), seconds / SECONDS);
      this.#open[i] = now + Math.sign(goal - now) * travel;
      moving = true;
    });
    if (moving) this.#place();
    return moving;
  }

  #place(): void {
    this.leaves.forEach((leaf, i) => this.mesh.setMatrixAt(i, leafMatrix(leaf, eased(this.#open[i] ?? 0), this.#cut)));
    this.mesh.instanceMatrix.needsUpdate = true;
    this.mesh.computeBoundingSphere();
  }
}
