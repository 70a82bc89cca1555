/** The plan beside the house: its rooms, as large as there is room for, without the dimensions outside; in it a click chooses what it chooses in the house, and what is chosen is framed. */
import { remember, remembered } from "../panel/preferences";
import type { Scene } from "../contract";
import { DrawnSheet, type DrawPlan } from "./drawn_sheet";

const NAME = "split";
const MM = 1000;
/** What is seen beyond the lines of the outermost walls [m]. */
const ROUND = 0.7;

export class PlanBeside extends DrawnSheet {
  /** Called with the body clicked, or null for a click beside all. */
  onSelect: (id: string | null) => void = () => undefined;
  /** Called with the body that was clicked with Shift. */
  onAlso: (id: string) => void = () => undefined;
  /** Called when it is wished for, before it is shown. */
  onWished: () => void = () => undefined;
  #chosen: readonly string[] = [];

  /** `button` shows it and puts it away; which of the two is remembered. */
  constructor(within: HTMLElement, readonly button: HTMLElement, draw: DrawPlan, failed: DrawnSheet["failed"]) {
    super(draw, failed);
    within.append(this.host);
    this.onDrawn = () => { this.select(this.#chosen); };
    new ResizeObserver(() => this.resized()).observe(this.host);
    this.host.addEventListener("click", (event) => this.#click(event));
    button.addEventListener("click", () => this.toggle());
    this.#split(remembered(NAME) === "shown");
  }

  toggle(): void {
    const isShown = this.button.ariaPressed !== "true";
    remember(NAME, isShown ? "shown" : "away");
    if (isShown) this.onWished();
    this.#split(isShown);
  }

  override pixels(scene: Scene): number {
    const [, , wide, high] = this.#box(scene);
    return Math.min(this.host.clientWidth / wide, this.host.clientHeight / high);
  }

  /** What of the house is shown [mm]. */
  #box({ rooms }: Scene): readonly [number, number, number, number] {
    const [west, north] = [Math.min(...rooms.map(({ x }) => x)) - ROUND, Math.min(...rooms.map(({ z }) => z)) - ROUND];
    const [east, south] = [Math.max(...rooms.map(({ x, width }) => x + width)) + ROUND, Math.max(...rooms.map(({ z, depth }) => z + depth)) + ROUND];
    return [west * MM, north * MM, (east - west) * MM, (south - north) * MM];
  }

  override resized(): void {
    const [drawn, scene] = [this.shown, this.scene];
    if (drawn && scene) {
      const [box, pixels] = [this.#box(scene), this.pixels(scene)];
      drawn.setAttribute("viewBox", box.join(" "));
      drawn.classList.add("inner"); // of a small home they lie so near that they were half in it
      drawn.style.width = `${box[2] * pixels}px`;
      drawn.style.height = `${box[3] * pixels}px`;
    }
    super.resized();
  }

  #split(isShown: boolean): void {
    this.button.ariaPressed = String(isShown);
    document.body.classList.toggle("split", isShown);
    this.turn(isShown);
  }

  select(ids: readonly string[]): void {
    this.#chosen = ids;
    if (this.shown) this.mark(ids);
  }

  override turn(isShown: boolean): void {
    super.turn(isShown);
    this.select(this.#chosen);
  }

  #click(event: MouseEvent): void {
    const [target] = event.composedPath();
    const id = target instanceof SVGElement ? target.closest<SVGElement>("use[data-id]")?.dataset.id : undefined;
    if (!event.shiftKey) this.onSelect(id ?? null);
    else if (id !== undefined) this.onAlso(id);
  }
}
