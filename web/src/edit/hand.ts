/** A pointer that takes hold of a piece of furniture and drags it on its floor. */
import { Plane, Vector3, type Raycaster } from "three";

export interface Point {
  readonly x: number;
  readonly z: number;
}

/** A piece to be held: where its centre is, and how high it is held [m]. */
export interface Grasp {
  readonly id: string;
  readonly at: Point;
  readonly height: number;
}

export interface HandWords {
  /** What can be held at a point of the window. */
  grasp(clientX: number, clientY: number): Grasp | null;
  rayAt(clientX: number, clientY: number): Raycaster;
  /** The house must not turn meanwhile. */
  hold(held: boolean): void;
  lift(id: string): void;
  /** Where the held piece's centre is wanted, in the house. */
  drag(at: Point): void;
  drop(): void;
  cancel(): void;
}

/** Further than this [CSS pixels] a press is a drag, as for clicks. */
const STILL = 5;

interface Grip {
  readonly id: string;
  readonly pointer: number;
  readonly from: { readonly x: number; readonly y: number };
  readonly plane: Plane;
  /** From the point held to the piece's centre. */
  readonly offset: Point;
  lifted: boolean;
}

export class Hand {
  #grip: Grip | null = null;

  constructor(readonly canvas: HTMLCanvasElement, readonly words: HandWords) {
    // Before the canvas' own listeners: they must not begin to turn the house.
    canvas.parentElement?.addEventListener("pointerdown", (event) => this.#press(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.#move(event));
    canvas.addEventListener("pointerup", (event) => this.#release(event));
    canvas.addEventListener("pointercancel", () => this.cancel());
    canvas.addEventListener("lostpointercapture", () => this.cancel());
  }

  get holds(): boolean {
    return this.#grip?.lifted ?? false;
  }

  /** Lets go and puts everything back. */
  cancel(): void {
    if (this.#end()) this.words.cancel();
  }

  #press(event: PointerEvent): void {
    if (event.target !== this.canvas || event.button !== 0 || !event.isPrimary || event.shiftKey || event.ctrlKey) return;
    const held = this.words.grasp(event.clientX, event.clientY);
    if (!held) return;
    const plane = new Plane(new Vector3(0, 1, 0), -held.height);
    const point = this.#onPlane(event, plane);
    if (!point) return;
    this.#grip = {
      id: held.id, pointer: event.pointerId, from: { x: event.clientX, y: event.clientY }, plane,
      offset: { x: held.at.x - point.x, z: held.at.z - point.z }, lifted: false,
    };
    this.words.hold(true);
    this.canvas.setPointerCapture(event.pointerId);
  }

  #onPlane(event: PointerEvent, plane: Plane): Point | null {
    return this.words.rayAt(event.clientX, event.clientY).ray.intersectPlane(plane, new Vector3());
  }

  #move(event: PointerEvent): void {
    const grip = this.#grip;
    if (!grip || event.pointerId !== grip.pointer) return;
    if (!grip.lifted) {
      if (Math.hypot(event.clientX - grip.from.x, event.clientY - grip.from.y) <= STILL) return;
      grip.lifted = true;
      this.words.lift(grip.id);
    }
    const point = this.#onPlane(event, grip.plane);
    if (point) this.words.drag({ x: point.x + grip.offset.x, z: point.z + grip.offset.z });
  }

  #release(event: PointerEvent): void {
    if (event.pointerId === this.#grip?.pointer && this.#end()) this.words.drop();
  }

  /** Lets go; tells whether anything was lifted. */
  #end(): boolean {
    const grip = this.#grip;
    this.#grip = null;
    if (!grip) return false;
    this.words.hold(false);
    return grip.lifted;
  }
}
