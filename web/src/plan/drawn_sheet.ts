/** The service's drawing of a storey, as SVG in a root of its own: asked for again with each state of the home, moved along with an edit. */
import type { Scene } from "../contract";
import type { PlacedBody } from "../house/frame";
import { drawn, made } from "../made";
import { Newest } from "../newest";
import { isAbort } from "../service";
import { LEAST, readableAt } from "./readable";

/** Asks for a scene's plan as SVG text, in millimetres of the house, its letters as large as on paper at 1 to `scale`. */
export type DrawPlan = (scene: Scene, scale: number, signal: AbortSignal) => Promise<string>;

const MM = 1000;
const RULES = ":host{position:absolute;inset:0}svg{display:block;width:100%;height:100%;pointer-events:none}use[data-id]{pointer-events:auto;cursor:pointer}"
  + ".unsized :is(.lengths,.size,.bar),.inner .lengths,.foot,.frame{display:none}.bar,.lengths.cut{visibility:hidden}svg>rect{fill:none}"
  + ".unsized text{fill:#333}.unsized .name{font-weight:normal}"
  + ".chosen{fill:#ffb000;fill-opacity:.18;stroke:#b36b00;stroke-width:3;vector-effect:non-scaling-stroke}";

/** The `transform` of a body on the sheet. */
export function transformOf({ x, z, turn }: Pick<PlacedBody, "x" | "z" | "turn">): string {
  const rounded = (value: number): number => Math.round(value * 10) / 10;
  return `translate(${rounded(x * MM)} ${rounded(z * MM)})rotate(${rounded((-turn * 180) / Math.PI)})`;
}

export abstract class DrawnSheet {
  readonly root: ShadowRoot;
  readonly host = made("div", { className: "plan-sheet", hidden: true, "aria-hidden": true });
  /** Told when another drawing is there. */
  onDrawn: () => void = () => undefined;
  #drawn: SVGSVGElement | null = null;
  #bodies: ReadonlyMap<string, SVGElement> = new Map();
  #frames: ReadonlyMap<string, SVGElement> = new Map();
  readonly #asked = new Newest();
  #scene: Scene | null = null;
  #isShown = false;
  #text = "";
  #scale = 0;

  constructor(readonly draw: DrawPlan, readonly failed: (reason: unknown, again: () => void) => void) {
    this.root = this.host.attachShadow({ mode: "open" });
  }

  turn(isShown: boolean): void {
    this.#isShown = isShown;
    this.host.hidden = !isShown;
    if (isShown && this.#scene) this.show(this.#scene);
  }

  /** Another state of the home: it is drawn when it is looked at. */
  show(scene: Scene): void {
    this.#scene = scene;
    if (!this.#isShown) return;
    const signal = this.#asked.next();
    this.host.ariaBusy = "true";
    this.#scale = readableAt(this.pixels(scene)).scale;
    this.draw(scene, this.#scale, signal).then((text) => { if (!signal.aborted) this.#take(text); }, (reason: unknown) => {
      if (!isAbort(reason)) this.failed(reason, () => { if (!signal.aborted) this.again(); });
    }).finally(() => { if (!signal.aborted) this.host.ariaBusy = "false"; });
  }

  /** How many pixels a millimetre of a home is on this sheet. */
  abstract pixels(scene: Scene): number;

  /** The sheet is seen at another size: it is drawn anew for that, lengths are left out where there is no room for them, and so are small words. */
  resized(): void {
    if (!this.#scene || !this.#isShown) return;
    const pixels = this.pixels(this.#scene);
    const { scale, lengths } = readableAt(pixels);
    if (scale !== this.#scale) this.again();
    this.#drawn?.classList.toggle("unsized", !lengths);
    for (const words of this.#drawn?.querySelectorAll<SVGTextElement>("text:not(.number, .name)") ?? []) {
      words.style.visibility = Number(words.getAttribute("font-size")) * pixels < LEAST ? "hidden" : "";
    }
  }

  /** Asks for the same home again: it is to be drawn otherwise. */
  again(): void {
    if (this.#scene) this.show(this.#scene);
  }

  /** Moves what an edit under way moves. */
  place(bodies: readonly PlacedBody[]): void {
    if (!this.#isShown) return;
    for (const body of bodies) {
      const transform = transformOf(body);
      for (const drawn of [this.#bodies.get(body.id), this.#frames.get(body.id)]) {
        if (drawn && drawn.getAttribute("transform") !== transform) drawn.setAttribute("transform", transform);
      }
    }
  }

  /** Frames what is chosen. */
  mark(ids: readonly string[]): void {
    for (const frame of this.#frames.values()) frame.remove();
    this.#frames = new Map(ids.flatMap((id) => {
      const body = this.#bodies.get(id);
      return body instanceof SVGGraphicsElement ? [[id, this.#framed(body)] as const] : [];
    }));
  }

  /** The home that is drawn, or will be once it is looked at. */
  get scene(): Scene | null {
    return this.#scene;
  }

  /** The drawing, once it is there and looked at. */
  get shown(): SVGSVGElement | null {
    return this.#isShown ? this.#drawn : null;
  }

  #framed(body: SVGGraphicsElement): SVGElement {
    const { x, y, width, height } = body.getBBox();
    const frame = drawn("rect", { class: "chosen", "data-of": body.dataset.id ?? "", transform: body.getAttribute("transform") ?? "", x, y, width, height });
    this.#drawn?.append(frame);
    return frame;
  }

  #take(text: string): void {
    if (text === this.#text && this.#drawn) return;
    this.#text = text;
    const [style = "", own = ""] = /<style>([^<]*)<\/style>/.exec(text) ?? []; // parsed with it, the page's policy would refuse it aloud
    const read = new DOMParser().parseFromString(text.replace(style, ""), "image/svg+xml").documentElement;
    if (!(read instanceof SVGSVGElement)) return;
    const rules = new CSSStyleSheet();
    rules.replaceSync(`${RULES}${own}`);
    read.removeAttribute("width");
    read.removeAttribute("height");
    this.root.adoptedStyleSheets = [rules];
    this.root.replaceChildren(read);
    this.#drawn = read;
    this.#bodies = new Map([...read.querySelectorAll<SVGElement>("use[data-id]")].map((use) => [use.dataset.id ?? "", use]));
    this.onDrawn();
    this.resized();
  }
}
