/** Turning the house, tilting it and coming nearer by steps, as keys ask for it: each glides, and none goes beyond the controls' limits. */
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";

/** To the right and up around the house [rad], and nearer by a factor. */
export interface OrbitStep {
  readonly right?: number;
  readonly up?: number;
  readonly nearer?: number;
}

/** How fast what is asked for is done [1/s]. */
const HASTE = 14;
/** Less than this is left undone no longer [rad, or a logarithm]. */
const REST = 1e-3;

const clamp = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value));

export class Orbiting {
  /** What is asked for and not yet done; nearness as a logarithm. */
  #right = 0;
  #up = 0;
  #nearer = 0;

  constructor(readonly controls: OrbitControls) {}

  /** Asks for a step more; tells whether there is anything to do. */
  ask({ right = 0, up = 0, nearer = 1 }: OrbitStep): boolean {
    const { minPolarAngle, maxPolarAngle, minDistance, maxDistance } = this.controls;
    const [polar, distance] = [this.controls.getPolarAngle(), this.controls.getDistance()];
    this.#right += right;
    this.#up = clamp(this.#up + up, polar - maxPolarAngle, polar - minPolarAngle);
    this.#nearer = clamp(this.#nearer + Math.log(nearer), Math.log(distance / maxDistance), Math.log(distance / minDistance));
    return this.#isLeft;
  }

  /** Forgets what is not yet done. */
  stop(): void {
    [this.#right, this.#up, this.#nearer] = [0, 0, 0];
  }

  /** Does what is due after some seconds; false when nothing is left. */
  step(seconds: number): boolean {
    if (!this.#isLeft) return false;
    const due = 1 - Math.exp(-seconds * HASTE);
    const [right, up, nearer] = [this.#right, this.#up, this.#nearer].map((left) => (Math.abs(left) < REST ? left : left * due)) as [number, number, number];
    this.#turn(right, up, nearer);
    this.#right -= right;
    this.#up -= up;
    this.#nearer -= nearer;
    return this.#isLeft;
  }

  get #isLeft(): boolean {
    return this.#right !== 0 || this.#up !== 0 || this.#nearer !== 0;
  }

  /** At once and in full: the controls' own damping would go on after it. */
  #turn(right: number, up: number, nearer: number): void {
    this.controls.enableDamping = false;
    this.controls.rotateLeft(right);
    this.controls.rotateUp(up);
    this.controls.dollyIn(Math.exp(-nearer));
    this.controls.enableDamping = true;
  }
}
