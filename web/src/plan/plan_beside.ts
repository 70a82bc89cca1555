/** The plan beside the house: the whole sheet, in which a click chooses what it chooses in the house, and what is chosen is framed. */
import { remember, remembered } from "../panel/preferences";
import { DrawnSheet, type DrawPlan } from "./drawn_sheet";

const NAME = "split";

export class PlanBeside extends DrawnSheet {
  /** Called with the body clicked, or null for a click beside all. */
  onSelect: (id: string | null) => void = () => undefined;
  /** Called with the body that was clicked with Shift. */
  onAlso: (id: string) => void = () => undefined;
  /** Called when it is wished for, before it is shown. */
  onWished: () => void = () => undefined;
  #chosen: readonly string[] = [];

  /** `button` shows it and puts it away; which of the two is remembered. */
  constructor(within: HTMLElement, readonly button: HTMLElement, draw: DrawPlan, failed: (reason: unknown) => void) {
    super(draw, failed);
    within.append(this.host);
    this.onDrawn = () => { this.select(this.#chosen); };
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
