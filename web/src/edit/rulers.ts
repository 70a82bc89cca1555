/** Lines and words drawn over the house: distances, guides, a tape, arrows. They follow the camera and cost no draw call. */
import { Vector3 } from "three";
import { drawn, made } from "../made";
import { onLine, type Kept, type LabelPlace } from "../view/label_layout";
import type { Viewport } from "../view/viewport";

export type RulerLook = "gap" | "guide" | "tape" | "hold" | "wish";
type Spot = readonly [number, number, number];

/** A line in the house [m], and what is written at a place along it. */
export interface RulerLine {
  readonly look: RulerLook;
  readonly from: Spot;
  readonly to: Spot;
  readonly words?: string;
  /** Where along the line the words are, from 0 to 1. */
  readonly at?: number;
  /** What a click on the words does. */
  readonly act?: () => void;
}

/** Words of a distance whose line is seen shorter than this would hide it [CSS pixels]: they are beside the house only. */
const SHORTEST = 26;
/** How high words are, how wide a letter about is, and what is beside them [CSS pixels]. */
const WORDS = { height: 18, letter: 6.8, beside: 12 } as const;

interface Drawn {
  readonly line: RulerLine;
  readonly stroke: SVGLineElement;
  readonly label: HTMLElement | null;
}

/** The heads of arrows, one a look that has them. */
function heads(): SVGElement {
  const head = { id: "ruler_head", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto-start-reverse" };
  return drawn("defs", {}, drawn("marker", head, drawn("path", { d: "M0 0 8 4 0 8z" })));
}

/** Does what a click asks for that was pressed here, too: a tap is a click on what has come under the finger since. */
function clickedFromPress(element: HTMLElement, act: () => void): void {
  let isPressed = false;
  element.addEventListener("pointerdown", () => { isPressed = true; });
  element.addEventListener("click", () => { if (isPressed) act(); });
}

export class Rulers {
  readonly #strokes = drawn("svg", { "aria-hidden": "true" }, heads());
  readonly #layer = made("div", { className: "rulers", "aria-hidden": true }, this.#strokes);
  #drawn: readonly Drawn[] = [];
  readonly #groups = new Map<string, readonly RulerLine[]>();

  constructor(host: HTMLElement, readonly viewport: Viewport) {
    host.append(this.#layer);
    viewport.onFrame(() => this.#place());
  }

  /** Shows a group's lines in place of those it had. */
  show(group: string, lines: readonly RulerLine[]): void {
    if (lines.length === 0 && !this.#groups.has(group)) return;
    if (lines.length > 0) this.#groups.set(group, lines);
    else this.#groups.delete(group);
    for (const { stroke, label } of this.#drawn) { stroke.remove(); label?.remove(); }
    this.#drawn = [...this.#groups.values()].flat().map((line) => this.#draw(line));
    this.#place();
  }

  #draw(line: RulerLine): Drawn {
    const stroke = drawn("line", { class: `ruler-${line.look}` });
    this.#strokes.append(stroke);
    if (line.words === undefined) return { line, stroke, label: null };
    const label = document.createElement(line.act ? "button" : "span");
    label.className = `ruler-words ruler-words-${line.look}`;
    label.textContent = line.words;
    if (label instanceof HTMLButtonElement) [label.type, label.tabIndex] = ["button", -1];
    if (line.act) clickedFromPress(label, line.act);
    this.#layer.append(label);
    return { line, stroke, label };
  }

  /** Whether a line lies beside the canvas as a whole: at its edge its words would tell of nothing. */
  #isAside(from: LabelPlace, to: LabelPlace): boolean {
    const { width, height } = this.viewport.size;
    return Math.max(from.x, to.x) < 0 || Math.min(from.x, to.x) > width || Math.max(from.y, to.y) < 0 || Math.min(from.y, to.y) > height;
  }

  #place(): void {
    const written: Kept[] = [];
    const above = ["tools", "handles"].flatMap((name) => this.viewport.overlaid.of(name));
    for (const { line, stroke, label } of this.#drawn) {
      const [from, to] = [line.from, line.to].map((spot) => this.viewport.project(new Vector3(...spot)));
      const isSeen = from !== null && to !== null && from !== undefined && to !== undefined;
      stroke.style.display = isSeen ? "" : "none";
      if (label) label.hidden = !isSeen;
      if (!isSeen) continue;
      for (const [key, value] of Object.entries({ x1: from.x, y1: from.y, x2: to.x, y2: to.y })) stroke.setAttribute(key, value.toFixed(1));
      if (label) label.hidden = this.#isAside(from, to) || (line.look === "gap" && Math.hypot(to.x - from.x, to.y - from.y) < SHORTEST);
      if (!label || label.hidden) continue;
      const extent = { width: (line.words?.length ?? 0) * WORDS.letter + WORDS.beside, height: WORDS.height };
      const place = onLine([from, to], line.at ?? 0.5, extent, [...above, ...written], this.viewport.size);
      label.style.transform = `translate(-50%, -50%) translate(${place.x.toFixed(1)}px, ${place.y.toFixed(1)}px)`;
      written.push({ ...place, ...extent });
    }
    this.viewport.overlaid.set("rulers", written);
  }
}
