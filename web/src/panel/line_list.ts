/** Lines of text of which some speak of a body: those are buttons, one stop for the Tab key, with arrows between them. */

import { made } from "../made";

export interface Line {
  readonly text: string;
  readonly id: string | null;
  readonly className: string;
}

const STEPS: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10 };

const same = (a: Line, b: Line): boolean => a.text === b.text && a.id === b.id && a.className === b.className;

/** How many lines at the start and at the end two texts share. */
export function sharedEnds(before: readonly Line[], after: readonly Line[]): { start: number; end: number } {
  const least = Math.min(before.length, after.length);
  let start = 0;
  while (start < least && same(before[start] as Line, after[start] as Line)) start += 1;
  let end = 0;
  while (end < least - start && same(before[before.length - 1 - end] as Line, after[after.length - 1 - end] as Line)) end += 1;
  return { start, end };
}

export class LineList {
  /** Called with the id of the body whose line was chosen; `adds`: with Shift, to what is chosen already. */
  onChoose: (id: string, adds: boolean) => void = () => undefined;
  #lines: readonly Line[] = [];
  #elements: HTMLElement[] = [];
  #buttons: HTMLButtonElement[] = [];
  #reachable: HTMLButtonElement | undefined;
  /** What lines are copies of: copying is quicker than making. */
  readonly #plain = made("div");
  readonly #button = made("button", { type: "button", tabIndex: -1 });

  constructor(readonly host: HTMLElement) {
    host.addEventListener("click", (event) => this.#choose(event.target, event.shiftKey));
    host.addEventListener("keydown", (event) => this.#step(event));
  }

  /** All lines, in order. */
  get elements(): readonly HTMLElement[] {
    return this.#elements;
  }

  /** The lines that are buttons, in order. */
  get buttons(): readonly HTMLButtonElement[] {
    return this.#buttons;
  }

  /** Shows lines; only the stretch that differs from what is shown is built anew. */
  show(lines: readonly Line[]): void {
    const { start, end } = sharedEnds(this.#lines, lines);
    const made = lines.slice(start, lines.length - end).map((line) => this.#element(line));
    const fragment = document.createDocumentFragment();
    fragment.append(...made);
    const gone = this.#elements.splice(start, this.#elements.length - start - end, ...made);
    for (const element of gone) element.remove();
    this.host.insertBefore(fragment, this.#elements[start + made.length] ?? null);
    this.#lines = lines;
    this.#buttons = this.#elements.filter((element) => element instanceof HTMLButtonElement);
    if (!this.#reachable?.isConnected) this.reach(this.#buttons[0]);
  }

  linesOf(id: string): HTMLButtonElement[] {
    return this.#buttons.filter((button) => button.dataset.id === id);
  }

  /** Makes one button the Tab key's stop. */
  reach(chosen: HTMLButtonElement | undefined): void {
    if (this.#reachable) this.#reachable.tabIndex = -1;
    if (chosen) chosen.tabIndex = 0;
    this.#reachable = chosen;
  }

  #element({ text, id, className }: Line): HTMLElement {
    const line = (id === null ? this.#plain : this.#button).cloneNode() as HTMLElement;
    line.className = className;
    line.textContent = text;
    line.style.setProperty("--indent", String(/^(?:>>|!!)?\s*/.exec(text)?.[0].length));
    if (id !== null) line.dataset.id = id;
    return line;
  }

  #choose(target: EventTarget | null, adds: boolean): void {
    const id = target instanceof Element ? target.closest<HTMLElement>("button[data-id]")?.dataset.id : undefined;
    if (id !== undefined) this.onChoose(id, adds);
  }

  #step(event: KeyboardEvent): void {
    const step = STEPS[event.key];
    const at = this.#buttons.indexOf(document.activeElement as HTMLButtonElement);
    if (step === undefined || at < 0) return;
    event.preventDefault();
    event.stopPropagation();
    const goal = this.#buttons[Math.max(0, Math.min(this.#buttons.length - 1, at + step))];
    this.reach(goal);
    goal?.focus();
  }
}
