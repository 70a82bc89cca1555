/** Handles at the chosen piece: one turns it, two make it wider and deeper where its kind allows that. What they do, keys and fields do too. */
import { Plane, Vector3 } from "three";
import type { Furniture } from "../contract";
import type { PlacedBody } from "../house/frame";
import { made } from "../made";
import type { Kept } from "../view/label_layout";
import type { Viewport } from "../view/viewport";
import { isSizable, type SizeRange } from "./size_range";

type Grip = "turn" | "width" | "depth";

export interface HandleWords {
  /** Where a piece is seen now: it may be on its way. */
  seen(id: string): PlacedBody | null;
  /** The piece as it would be, to be framed; null: as it is. */
  preview(body: PlacedBody | null): void;
  turn(id: string, degrees: number): void;
  /** Its new extent, and how far its centre goes in the house [m]. */
  resize(id: string, change: Partial<Pick<Furniture, "width" | "depth">>, dx: number, dz: number): void;
}

/** How far before the piece its handle to turn is, and how far a handle is beside an edge [m]. */
const BEFORE = 0.35;
const BESIDE = 0.08;
/** No handle is seen nearer to the piece's middle than this [CSS pixels]. */
const NEAREST: Readonly<Record<Grip, number>> = { turn: 62, width: 34, depth: 34 };
/** How large a handle is seen [CSS pixels]. */
const SEEN = 28;
/** Sizes go by this [m]. */
const STEP = 0.01;
const GRIPS: readonly (readonly [Grip, string])[] = [["turn", "⟳"], ["width", "↔"], ["depth", "↔"]];

interface Held {
  readonly grip: Grip;
  readonly pointer: number;
  result: (() => void) | null;
}

export class Handles {
  readonly #elements = new Map<Grip, HTMLElement>();
  #id: string | null = null;
  #range: SizeRange | null = null;
  #held: Held | null = null;

  constructor(host: HTMLElement, readonly viewport: Viewport, readonly say: HandleWords) {
    for (const [grip, sign] of GRIPS) {
      const element = made("div", { className: "handle", hidden: true, "data-grip": grip, "aria-hidden": true }, sign);
      element.addEventListener("pointerdown", (event) => this.#press(event, grip, element));
      element.addEventListener("pointermove", (event) => this.#move(event));
      element.addEventListener("pointerup", (event) => this.#release(event));
      element.addEventListener("pointercancel", () => this.cancel());
      this.#elements.set(grip, element);
      host.append(element);
    }
    viewport.onFrame(() => this.#place());
  }

  /** Shows the handles of a piece; of none for null. */
  show(id: string | null, range: SizeRange | null): void {
    if (this.#held) return;
    [this.#id, this.#range] = [id, range];
    this.#place();
  }

  get #body(): PlacedBody | null {
    return this.#id === null ? null : this.say.seen(this.#id);
  }

  /** Lets go; all is as it was. Tells whether anything was held. */
  cancel(): boolean {
    const held = this.#held;
    this.#held = null;
    if (held) this.say.preview(null);
    return held !== null;
  }

  #isOffered(grip: Grip): boolean {
    return this.#id !== null && (grip === "turn" || (this.#range !== null && isSizable(this.#range[grip])));
  }

  /** A point of the piece's own frame, at half its height, in the house [m]. */
  #spot(body: PlacedBody, across: number, along: number): Vector3 {
    const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
    return new Vector3(body.x + across * cos + along * sin, body.y + body.height / 2, body.z - across * sin + along * cos);
  }

  #place(): void {
    const body = this.#body;
    const seen: Kept[] = [];
    for (const [grip, element] of this.#elements) {
      const isOffered = this.#isOffered(grip) && this.viewport.pose === null;
      const at = body && isOffered ? this.#seen(grip, body) : null;
      element.hidden = at === null;
      if (at) seen.push({ ...at, width: SEEN, height: SEEN });
      if (at) element.style.transform = `translate(-50%, -50%) translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
    }
    this.viewport.overlaid.set("handles", seen);
  }

  /** Where a handle is seen [CSS pixels]: where it belongs, or further out. */
  #seen(grip: Grip, body: PlacedBody): { readonly x: number; readonly y: number } | null {
    const [middle, at] = [this.viewport.project(this.#spot(body, 0, 0)), this.viewport.project(this.#spotOf(grip, body))];
    if (!middle || !at) return null;
    const [dx, dy] = [at.x - middle.x, at.y - middle.y];
    const away = Math.hypot(dx, dy) || 1;
    const out = Math.max(away, NEAREST[grip]) / away;
    return { x: middle.x + dx * out, y: middle.y + dy * out };
  }

  #spotOf(grip: Grip, body: PlacedBody): Vector3 {
    if (grip === "turn") return this.#spot(body, 0, body.depth / 2 + BEFORE);
    return grip === "width" ? this.#spot(body, body.width / 2 + BESIDE, 0) : this.#spot(body, 0, body.depth / 2 + BESIDE);
  }

  #press(event: PointerEvent, grip: Grip, element: HTMLElement): void {
    if (event.button !== 0 || !this.#body) return;
    event.preventDefault();
    this.#held = { grip, pointer: event.pointerId, result: null };
    element.setPointerCapture(event.pointerId);
  }

  #move(event: PointerEvent): void {
    const [held, body] = [this.#held, this.#body];
    if (!held || !body || event.pointerId !== held.pointer) return;
    const plane = new Plane(new Vector3(0, 1, 0), -(body.y + body.height / 2));
    const at = this.viewport.rayAt(event.clientX, event.clientY).ray.intersectPlane(plane, new Vector3());
    if (!at) return;
    const [dx, dz] = [at.x - body.x, at.z - body.z];
    if (held.grip === "turn") this.#turn(held, body, dx, dz);
    else this.#resize(held, held.grip, body, dx, dz);
  }

  #turn(held: Held, body: PlacedBody, dx: number, dz: number): void {
    const quarters = Math.round(Math.atan2(dx, dz) / (Math.PI / 2));
    const turned = { ...body, turn: (quarters * Math.PI) / 2 };
    const degrees = ((Math.round(((turned.turn - body.turn) * 180) / Math.PI) % 360) + 360) % 360;
    held.result = degrees === 0 ? null : () => this.say.turn(body.id, degrees);
    this.say.preview(turned);
  }

  /** The far edge stays where it is. */
  #resize(held: Held, extent: "width" | "depth", body: PlacedBody, dx: number, dz: number): void {
    const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
    const out = extent === "width" ? dx * cos - dz * sin : dx * sin + dz * cos;
    const [least, most] = this.#range?.[extent] ?? [body[extent], body[extent]];
    const size = Math.round(Math.max(least, Math.min(most, Math.round((out + body[extent] / 2) / STEP) * STEP)) * 1000) / 1000;
    const by = (size - body[extent]) / 2;
    const centre = extent === "width" ? this.#spot(body, by, 0) : this.#spot(body, 0, by);
    held.result = size === body[extent] ? null : () => this.say.resize(body.id, { [extent]: size }, centre.x - body.x, centre.z - body.z);
    this.say.preview({ ...body, [extent]: size, x: centre.x, z: centre.z });
  }

  #release(event: PointerEvent): void {
    const held = this.#held;
    if (event.pointerId !== held?.pointer) return;
    this.cancel();
    held.result?.();
  }
}
