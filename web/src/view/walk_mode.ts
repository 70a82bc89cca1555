/** Walking: keys held down or a floor clicked move the eyes where the floor is free, a drag on the canvas turns them, Escape ends it. */
import { turned, walked, walkedTo, type Pose, type Stride } from "./walk";
import type { Place, WalkFloor } from "./walk_floor";
import { routeOver } from "./walk_route";
import type { Bounds } from "./cameras";
import type { Viewport } from "./viewport";

/** Ahead, aside to the right, and a turn to the left. */
const STEPS: Readonly<Record<string, readonly [number, number, number]>> = {
  KeyW: [1, 0, 0], ArrowUp: [1, 0, 0], KeyS: [-1, 0, 0], ArrowDown: [-1, 0, 0],
  KeyA: [0, -1, 0], KeyD: [0, 1, 0], ArrowLeft: [0, 0, 1], ArrowRight: [0, 0, -1],
};
/** Where keys mean something else: fields, lines of text, questions that wait for an answer. */
const DEAF = "input, select, textarea, [contenteditable], .yaml, dialog[open]";
/** A drag across the canvas turns the head by about this much [rad]. */
const TURN = 2;
/** How fast a key held down turns the head [rad/s]. */
const TURNING = 1.6;

/** What keys ask for together, each from -1 to 1. */
function summed(codes: ReadonlySet<string>): [number, number, number] {
  const steps = [...codes].map((code) => STEPS[code] ?? [0, 0, 0]);
  const sum = (which: 0 | 1 | 2): number => Math.sign(steps.reduce((total, step) => total + step[which], 0));
  return [sum(0), sum(1), sum(2)];
}

/** Who goes to a place and comes no further than this share of a frame's way is stopped, however short the frame. */
const STOPPED = 1e-3;

function placeOf({ eye }: Pose): Place {
  return [eye[0], eye[2]];
}

export class WalkMode {
  /** Called with Escape. */
  onLeave: () => void = () => undefined;
  readonly #held = new Set<string>();
  /** Pressed since the last frame: a key counts also where it is let go before the next one. */
  readonly #pressed = new Set<string>();
  #pose: Pose | null = null;
  #bounds: Bounds = { min: [0, 0, 0], max: [1, 1, 1] };
  #hurried = false;
  #moving = false;
  #dragged: PointerEvent | null = null;
  /** The corners of the way to a place that was clicked. */
  #route: readonly Place[] = [];
  /** What one walks on; null where it is not known: then nothing is in the way. */
  #floor: WalkFloor | null = null;
  /** Until the floor is known one stays where one is. */
  #awaits = false;

  constructor(readonly viewport: Viewport) {
    const { canvas } = viewport;
    // Before all others: a key that walks does nothing else.
    window.addEventListener("keydown", (event) => this.#keyDown(event), { capture: true });
    window.addEventListener("keyup", (event) => this.#held.delete(event.code));
    window.addEventListener("blur", () => this.#letGo());
    canvas.addEventListener("pointerdown", (event) => {
      this.#dragged = event;
      if (this.#pose) canvas.setPointerCapture(event.pointerId); // the head turns on where the pointer leaves the canvas
    });
    canvas.addEventListener("pointermove", (event) => this.#drag(event));
    for (const end of ["pointerup", "pointercancel", "pointerleave"] as const) {
      canvas.addEventListener(end, () => { this.#dragged = null; });
    }
  }

  /** Where one stands; null for who does not walk. */
  get pose(): Pose | null {
    return this.#pose;
  }

  start(pose: Pose, bounds: Bounds): void {
    this.#route = [];
    this.#bounds = bounds;
    this.#letGo();
    this.#stand(pose);
  }

  /** Learns what one walks on: `awaited` before it is asked for. */
  walkOn(floor: WalkFloor | null | "awaited"): void {
    this.#awaits = floor === "awaited";
    this.#floor = floor === "awaited" ? null : floor;
    if (this.#pose && this.#floor) this.#stand(this.#at(this.#pose, this.#floor.nearest(placeOf(this.#pose))));
  }

  stop(): void {
    this.#pose = null;
    this.#letGo();
  }

  get knowsFloor(): boolean {
    return this.#floor !== null;
  }

  #letGo(): void {
    this.#held.clear();
    this.#pressed.clear();
  }

  /** Goes to a place of the plan [m], around what is in the way, unless a key or another place is asked for meanwhile. */
  goTo(place: Place): void {
    if (!this.#pose || this.#awaits) return;
    const route = this.#floor ? routeOver(this.#floor.rectangles, placeOf(this.#pose), place) : [place];
    this.#route = route;
    let corner = 0;
    this.viewport.move((seconds) => {
      const next = route[corner];
      if (!this.#pose || this.#route !== route || !next) return false;
      if (seconds === 0) return true; // two frames of one moment: nothing stops one
      const { pose, arrived } = walkedTo(this.#pose, next, seconds);
      if (arrived) corner += 1;
      return this.#go(pose) >= STOPPED || arrived;
    });
  }

  /** Goes towards where one wishes to be, as far as one comes; returns which share of the way that is. */
  #go(wished: Pose): number {
    if (!this.#pose) return 0;
    const [from, aim] = [placeOf(this.#pose), placeOf(wished)];
    const to = this.#floor ? this.#floor.step(from, aim) : aim;
    this.#stand(this.#at(wished, to));
    return Math.hypot(to[0] - from[0], to[1] - from[1]) / Math.hypot(aim[0] - from[0], aim[1] - from[1]);
  }

  #at(pose: Pose, [x, z]: Place): Pose {
    return { ...pose, eye: [x, pose.eye[1], z] };
  }

  #stand(pose: Pose): void {
    this.#pose = pose;
    this.viewport.stand(pose);
  }

  #keyDown(event: KeyboardEvent): void {
    if (!this.#pose || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target instanceof Element && event.target.closest(DEAF)) return;
    this.#hurried = event.shiftKey;
    if (event.code === "Escape") this.onLeave();
    else if (STEPS[event.code]) this.#hold(event.code);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  #hold(code: string): void {
    this.#route = [];
    this.#held.add(code);
    this.#pressed.add(code);
    if (this.#moving) return;
    this.#moving = true;
    this.viewport.move((seconds) => this.#step(seconds));
  }

  /** One frame's way; false when no key is held any more. */
  #step(seconds: number): boolean {
    const asked = new Set([...this.#held, ...this.#pressed]);
    this.#pressed.clear();
    this.#moving = this.#pose !== null && asked.size > 0;
    if (!this.#pose || !this.#moving) return false;
    const [ahead, aside, left] = summed(asked);
    const stride: Stride = { ahead, aside, hurried: this.#hurried };
    const aim = turned(this.#pose, left * TURNING * seconds, 0);
    if (this.#awaits) this.#stand(aim);
    else this.#go({ ...walked(this.#pose, stride, seconds, this.#bounds), yaw: aim.yaw });
    return true;
  }

  #drag(event: PointerEvent): void {
    const from = this.#dragged;
    if (!from || !this.#pose || event.pointerId !== from.pointerId) return;
    this.#dragged = event;
    const share = TURN / this.viewport.host.clientHeight;
    this.#stand(turned(this.#pose, (event.clientX - from.clientX) * share, (event.clientY - from.clientY) * share));
  }
}
