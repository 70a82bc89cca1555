/** Names over the canvas: every room's, and that of the body pointed at. Text only, never markup. */
import { Vector3 } from "three";
import type { Room, Scene } from "../contract";
import { storeysOf, words, type PlacedBody } from "../house/frame";
import { layOut } from "./label_layout";
import type { Viewport } from "./viewport";

interface RoomLabel {
  readonly element: HTMLElement;
  /** Its size when the name is shown [CSS pixels]. */
  width: number;
  height: number;
  readonly at: Vector3;
  readonly elevation: number;
  readonly area: number;
}

const TIP_LIFT = 22;

function moveTo(element: HTMLElement, x: number, y: number): void {
  element.style.transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
}

function roomLabel(room: Room, elevation: number): RoomLabel {
  const element = document.createElement("div");
  element.className = "room-label";
  const dot = document.createElement("span");
  dot.className = "dot";
  dot.style.backgroundColor = room.accent;
  const name = document.createElement("span");
  name.textContent = words(room.type);
  element.append(dot, name);
  return {
    element,
    width: 0,
    height: 0,
    at: new Vector3(room.x + room.width / 2, elevation, room.z + room.depth / 2),
    elevation,
    area: room.width * room.depth,
  };
}

function sizeWords({ width, depth, height }: PlacedBody): string {
  return [width, depth, height].map((metres) => String(Number(metres.toFixed(3)))).join(" × ");
}

export class Labels {
  readonly #tip = document.createElement("div");
  #rooms: RoomLabel[] = [];
  #pointed: PlacedBody | null = null;

  constructor(readonly layer: HTMLElement, readonly viewport: Viewport) {
    this.#tip.className = "body-tip";
    this.#tip.hidden = true;
    layer.append(this.#tip);
    viewport.onFrame(() => this.#follow());
  }

  /** Puts the rooms' names where their walls end [m]: there they are seen over the room they belong to. */
  raiseTo(height: number): void {
    for (const { at, elevation } of this.#rooms) at.y = Math.max(elevation, height);
    this.viewport.invalidate();
  }

  show(scene: Scene): void {
    const storeys = storeysOf(scene);
    for (const label of this.#rooms) label.element.remove();
    this.#rooms = scene.rooms.map((room) => roomLabel(room, storeys.get(room.level)?.elevation ?? 0));
    this.layer.append(...this.#rooms.map((label) => label.element));
    for (const label of this.#rooms) [label.width, label.height] = [label.element.offsetWidth, label.element.offsetHeight];
    this.point(null);
  }

  /** Names the body pointed at; tells whether that is another than before. */
  point(body: PlacedBody | null): boolean {
    if (body === this.#pointed) return false;
    this.#pointed = body;
    this.#tip.hidden = body === null;
    if (body) this.#tip.textContent = `${words(body.name)}  ${sizeWords(body)} m`;
    this.viewport.invalidate();
    return true;
  }

  #follow(): void {
    const seen = this.#rooms.map((label) => ({ label, at: this.viewport.project(label.at) }));
    const places = layOut(seen.map(({ label, at }) => ({
      x: at?.x ?? -1e6, y: at?.y ?? -1e6, width: label.width, height: label.height, importance: label.area,
    })));
    seen.forEach(({ label, at }, i) => {
      const place = places[i] ?? at;
      label.element.hidden = !at;
      label.element.classList.toggle("crowded-out", !places[i]);
      if (place) moveTo(label.element, place.x, place.y);
    });
    this.#followPointed();
  }

  #followPointed(): void {
    const body = this.#pointed;
    const at = body ? this.viewport.project(new Vector3(body.x, body.y + body.height, body.z)) : null;
    if (at) moveTo(this.#tip, at.x, at.y - TIP_LIFT);
  }
}
