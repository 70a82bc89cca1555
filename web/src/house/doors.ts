/** The doors of a house: leaves of a few parts each, drawn in one batch, opened and closed by a click. */
import type { Group } from "three";
import { LEAF_THICKNESS, type Leaf } from "./door_leaves";
import { partsOfLeaf, PLAIN_PAINTS, shown, type DoorPaints } from "./door_shapes";
import type { PlacedBody } from "./frame";
import { HitGroup } from "./hit_group";
import { PartBatches } from "./part_batches";
import type { Part } from "./parts";

const SECONDS = 0.45;
/** What stays visible of a rolled-up panel. */
const ROLLED = 0.06;
/** How far a leaf's handles reach on both sides of it together [m]. */
const HANDLES = 0.13;

/** Slow at both ends. */
function eased(share: number): number {
  return share * share * (3 - 2 * share);
}

/** When a leaf on its way is so far open: what `eased` undoes. */
function momentOf(open: number): number {
  if (open <= 0 || open >= 1) return open;
  return 0.5 - Math.sin(Math.asin(1 - 2 * open) / 3);
}

/** A leaf as a body: where its middle is, `open` from 0 to 1. */
export function bodyOfLeaf(leaf: Leaf, open: number): PlacedBody {
  const turn = leaf.closedAngle + (leaf.motion === "swing" ? open * leaf.turn : 0);
  const { id, hinge, width, height } = leaf;
  return {
    id, name: "door", kind: "furniture", turn, width, height, depth: LEAF_THICKNESS + HANDLES, color: "",
    x: hinge.x + (Math.cos(turn) * width) / 2, y: hinge.y, z: hinge.z - (Math.sin(turn) * width) / 2,
  };
}

/** What shows of a leaf's parts under `cut` [m]: a panel that rolls up goes into its lintel. */
export function shownOfLeaf(leaf: Leaf, parts: readonly Part[], open: number, cut: number): (Part | null)[] {
  const lift = leaf.motion === "roll" ? open * (1 - ROLLED) * leaf.height : 0;
  return parts.map((part) => shown(part, lift, Math.min(leaf.height, cut - leaf.hinge.y)));
}

/** The doors of a house; `step` moves those under way. */
export class Doors {
  readonly root: Group;
  readonly #wanted: number[];
  readonly #open: number[];
  readonly #parts: readonly (readonly Part[])[];
  readonly #drawn: PartBatches;
  readonly #bodies: PlacedBody[];
  readonly #shown: (readonly Part[])[];
  #cut = Number.POSITIVE_INFINITY;

  constructor(readonly leaves: readonly Leaf[], paints: DoorPaints = PLAIN_PAINTS) {
    this.#wanted = leaves.map(({ open = 0 }) => momentOf(open));
    this.#open = [...this.#wanted];
    this.#bodies = leaves.map((leaf) => bodyOfLeaf(leaf, leaf.open ?? 0));
    this.#parts = leaves.map((leaf) => partsOfLeaf(leaf, paints));
    this.#shown = [...this.#parts];
    this.#drawn = new PartBatches(this.#bodies, this.#parts);
    this.root = new HitGroup(this.#drawn, this.#bodies, (number) => this.#shown[number] ?? []);
  }

  /** Cuts the leaves at the height of the walls [m]. */
  cutAt(height: number): void {
    this.#cut = height;
    this.leaves.forEach((_, i) => this.#place(i));
  }

  /** Opens the closed door of a leaf, closes an open one. */
  toggle(index: number | undefined): void {
    const door = this.leaves[index ?? -1]?.opening;
    this.leaves.forEach(({ opening }, i) => {
      if (opening === door) this.#wanted[i] = (this.#wanted[i] ?? 0) > 0 ? 0 : 1;
    });
  }

  /** The ids of the doors, each once. */
  get ids(): string[] {
    return [...new Set(this.leaves.map((leaf) => leaf.opening))];
  }

  /** The ids of the doors that are open or opening. */
  get open(): string[] {
    return [...new Set(this.leaves.filter((_, i) => (this.#wanted[i] ?? 0) > 0).map((leaf) => leaf.opening))];
  }

  /** How far a leaf is turned from the direction of +x now [rad]. */
  angleOf(index: number): number {
    return this.#bodies[index]?.turn ?? 0;
  }

  /** Moves the leaves by `seconds`; true while one is under way. */
  step(seconds: number): boolean {
    let moving = false;
    this.#wanted.forEach((goal, i) => {
      const now = this.#open[i] ?? goal;
      if (now === goal) return;
      const travel = Math.min(Math.abs(goal - now), seconds / SECONDS);
      this.#open[i] = now + Math.sign(goal - now) * travel;
      this.#place(i);
      moving = true;
    });
    return moving;
  }

  #place(index: number): void {
    const leaf = this.leaves[index];
    if (!leaf) return;
    const open = eased(this.#open[index] ?? 0);
    const body = (this.#bodies[index] = bodyOfLeaf(leaf, open));
    const parts = shownOfLeaf(leaf, this.#parts[index] ?? [], open, this.#cut);
    this.#shown[index] = parts.filter((part) => part !== null);
    this.#drawn.place(index, body, parts);
  }
}
