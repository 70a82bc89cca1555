/** A pointer that takes hold of a piece of furniture and drags it on its floor. */
import { Plane, Vector3, type Raycaster } from "three";
import { isStill, LONG_PRESS } from "../view/pointer";

export interface Point {
  readonly x: number;
  readonly z: number;
}

/** A piece to be held: where its centre is, and how high it is held [m]. */
export interface Grasp {
  readonly id: string;
  readonly at: Point;
  readonly height: number;
  /** Whether it is chosen: a finger drags it at once. */
  readonly isChosen: boolean;
}

export interface HandWords {
  /** What can be held at a point of the window. */
  grasp(clientX: number, clientY: number): Grasp | null;
  rayAt(clientX: number, clientY: number): Raycaster;
  /** The house must not turn meanwhile. */
  hold(held: boolean): void;
  lift(id: string): void;
  /** Where the held piece's centre is wanted, in the house; `isFree`: with Alt, lined up with nothing. */
  drag(at: Point, isFree: boolean): void;
  drop(): void;
  cancel(): void;
}

/** Lengths in the house are as large as a finger: one that goes on from there drags what lies beneath. */
const LENGTHS = ".ruler-words";

interface Grip {
  readonly id: string;
  readonly pointer: number;
  readonly from: PointerEvent;
  readonly plane: Plane;
  /** From the point held to the piece's centre. */
  readonly offset: Point;
  lifted: boolean;
  moved: boolean;
}

export class Hand {
  #grip: Grip | null = null;
  /** A finger that may become a hold: where it is, and what ends the wait. */
  #waiting: { readonly event: PointerEvent; readonly timer: ReturnType<typeof setTimeout> } | null = null;

  constructor(readonly canvas: HTMLCanvasElement, readonly words: HandWords) {
    const host = canvas.parentElement;
    // Before the canvas' own listeners: they must not begin to turn the house.
    host?.addEventListener("pointerdown", (event) => this.#press(event), { capture: true });
    host?.addEventListener("pointermove", (event) => this.#move(event));
    host?.addEventListener("pointerup", (event) => this.#release(event));
    host?.addEventListener("pointercancel", () => this.cancel());
    canvas.addEventListener("lostpointercapture", () => this.cancel());
  }

  get holds(): boolean {
    return this.#grip?.lifted ?? false;
  }

  /** Lets go and puts everything back. */
  cancel(): void {
    this.#wait(null);
    if (this.#end()?.lifted) this.words.cancel();
  }

  #press(event: PointerEvent): void {
    const isFinger = event.pointerType === "touch";
    if (isFinger && !event.isPrimary) this.cancel(); // two fingers are for the camera
    const isHere = event.target === this.canvas || (isFinger && (event.target as Element).matches(LENGTHS));
    if (!isHere || event.button !== 0 || !event.isPrimary || event.shiftKey || event.ctrlKey) return;
    const held = this.words.grasp(event.clientX, event.clientY);
    if (!held) return;
    if (isFinger && !held.isChosen) this.#wait(event, () => this.#pick(event));
    else this.#hold(event, held);
  }

  /** Waits with a finger, or no longer. */
  #wait(event: PointerEvent | null, then: () => void = () => undefined): void {
    if (this.#waiting) clearTimeout(this.#waiting.timer);
    this.#waiting = event && { event, timer: setTimeout(then, LONG_PRESS) };
  }

  /** Takes up what a finger has stayed on. */
  #pick(event: PointerEvent): void {
    this.#waiting = null;
    const held = this.words.grasp(event.clientX, event.clientY);
    if (held && this.#hold(event, held)) this.#lift();
  }

  #lift(): void {
    if (!this.#grip) return;
    this.#grip.lifted = true;
    this.canvas.setPointerCapture(this.#grip.pointer); // from a length, which goes now; a tap there is its own
    this.words.lift(this.#grip.id);
  }

  #hold(event: PointerEvent, held: Grasp): boolean {
    const plane = new Plane(new Vector3(0, 1, 0), -held.height);
    const point = this.#onPlane(event, plane);
    if (!point) return false;
    this.#grip = {
      id: held.id, pointer: event.pointerId, from: event, plane,
      offset: { x: held.at.x - point.x, z: held.at.z - point.z }, lifted: false, moved: false,
    };
    this.words.hold(true);
    if (event.target === this.canvas) this.canvas.setPointerCapture(event.pointerId);
    return true;
  }

  #onPlane(event: PointerEvent, plane: Plane): Point | null {
    return this.words.rayAt(event.clientX, event.clientY).ray.intersectPlane(plane, new Vector3());
  }

  #move(event: PointerEvent): void {
    const [grip, waiting] = [this.#grip, this.#waiting?.event];
    if (waiting && !isStill(waiting, event)) this.#wait(null);
    if (!grip || event.pointerId !== grip.pointer) return;
    if (!grip.moved) {
      if (isStill(grip.from, event)) return;
      grip.moved = true;
      if (!grip.lifted) this.#lift();
    }
    const point = this.#onPlane(event, grip.plane);
    if (point) this.words.drag({ x: point.x + grip.offset.x, z: point.z + grip.offset.z }, event.altKey);
  }

  #release(event: PointerEvent): void {
    this.#wait(null);
    if (event.pointerId !== this.#grip?.pointer) return;
    const grip = this.#end();
    if (grip?.moved) this.words.drop();
    else if (grip?.lifted) this.words.cancel(); // taken up and let go: chosen, not moved
  }

  /** Lets go of what is held. */
  #end(): Grip | null {
    const grip = this.#grip;
    this.#grip = null;
    if (grip) this.words.hold(false);
    return grip;
  }
}
