/** Turning the house, tilting it, coming nearer and looking further aside by steps, as keys ask: each glides, none beyond the limits. */
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";

/** To the right and up around the house [rad], nearer by a factor, and what is looked at to the east and north of the screen [CSS pixels]. */
export interface OrbitStep {
  readonly right?: number;
  readonly up?: number;
  readonly nearer?: number;
  readonly east?: number;
  readonly north?: number;
}

/** How fast what is asked for is done [1/s]. */
const HASTE = 14;
/** Less than this is left undone no longer: rad, a logarithm, CSS pixels. */
const REST = [1e-3, 1e-3, 1e-3, 0.5, 0.5] as const;

const clamp = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value));

/** To the right, up, nearer as a logarithm, east, north. */
type Way = [number, number, number, number, number];

export class Orbiting {
  /** What is asked for and not yet done. */
  #left: Way = [0, 0, 0, 0, 0];

  constructor(readonly controls: OrbitControls) {}

  /** Asks for a step more; tells whether there is anything to do. */
  ask({ right = 0, up = 0, nearer = 1, east = 0, north = 0 }: OrbitStep): boolean {
    const { minPolarAngle, maxPolarAngle, minDistance, maxDistance } = this.controls;
    const [polar, distance] = [this.controls.getPolarAngle(), this.controls.getDistance()];
    const [turn, tilt, zoom, across, along] = this.#left;
    this.#left = [
      turn + right,
      clamp(tilt + up, polar - maxPolarAngle, polar - minPolarAngle),
      clamp(zoom + Math.log(nearer), Math.log(distance / maxDistance), Math.log(distance / minDistance)),
      across + east,
      along + north,
    ];
    return this.#isLeft;
  }

  /** Forgets what is not yet done. */
  stop(): void {
    this.#left = [0, 0, 0, 0, 0];
  }

  /** Does what is due after some seconds; false when nothing is left. */
  step(seconds: number): boolean {
    if (!this.#isLeft) return false;
    const due = 1 - Math.exp(-seconds * HASTE);
    const done = this.#left.map((left, i) => (Math.abs(left) < (REST[i] ?? 0) ? left : left * due)) as Way;
    this.#move(done);
    this.#left = this.#left.map((left, i) => left - (done[i] ?? 0)) as Way;
    return this.#isLeft;
  }

  get #isLeft(): boolean {
    return this.#left.some((left) => left !== 0);
  }

  /** At once and in full: the controls' own damping would go on after it. */
  #move([right, up, nearer, east, north]: Way): void {
    this.controls.enableDamping = false;
    this.controls.rotateLeft(right);
    this.controls.rotateUp(up);
    this.controls.dollyIn(Math.exp(-nearer));
    if (east !== 0 || north !== 0) this.controls.pan(-east, north);
    this.controls.enableDamping = true;
  }
}
