/** The readable YAML: a line that speaks of a body is a button, reached with the arrow keys. */
import type { ViewAnswer } from "../contract";
import { writeHighlighted } from "./highlight";

export class Reading {
  /** Called with the id of the body whose line was chosen. */
  onChoose: (id: string) => void = () => undefined;
  #buttons: HTMLButtonElement[] = [];

  constructor(readonly host: HTMLElement) {
    host.addEventListener("click", (event) => this.#choose(event.target));
    host.addEventListener("keydown", (event) => this.#step(event));
  }

  show(answer: ViewAnswer): void {
    const lines = answer.text.replace(/\n$/, "").split("\n").map((text, i) => this.#line(text, answer.lines[i] ?? null));
    this.host.replaceChildren(...lines);
    this.host.scrollTop = 0;
    this.#buttons = [...this.host.querySelectorAll("button")];
    this.#makeReachable(this.#buttons[0]);
  }

  /** Marks the lines of the selected body and brings the first into view. */
  select(id: string | null): void {
    const chosen = this.#buttons.filter((button) => button.dataset.id === id);
    for (const button of this.#buttons) button.setAttribute("aria-pressed", String(chosen.includes(button)));
    const [first] = chosen;
    if (!first) return;
    first.scrollIntoView({ block: "nearest" });
    this.#makeReachable(first);
  }

  #line(text: string, id: string | null): HTMLElement {
    const line = document.createElement(id === null ? "div" : "button");
    line.className = "yaml-line";
    if (line instanceof HTMLButtonElement && id !== null) {
      line.type = "button";
      line.dataset.id = id;
      line.tabIndex = -1;
      line.setAttribute("aria-pressed", "false");
    }
    writeHighlighted(text, line);
    if (text === "") line.append("\u00a0");
    return line;
  }

  #choose(target: EventTarget | null): void {
    const id = target instanceof Element ? target.closest<HTMLElement>("button[data-id]")?.dataset.id : undefined;
    if (id !== undefined) this.onChoose(id);
  }

  /** One stop for the Tab key; the arrows go from line to line. */
  #step(event: KeyboardEvent): void {
    const steps: Readonly<Record<string, number>> = { ArrowDown: 1, ArrowUp: -1, PageDown: 10, PageUp: -10 };
    const step = steps[event.key];
    const at = this.#buttons.indexOf(document.activeElement as HTMLButtonElement);
    if (step === undefined || at < 0) return;
    event.preventDefault();
    const goal = this.#buttons[Math.max(0, Math.min(this.#buttons.length - 1, at + step))];
    this.#makeReachable(goal);
    goal?.focus();
  }

  #makeReachable(chosen: HTMLButtonElement | undefined): void {
    for (const button of this.#buttons) button.tabIndex = button === chosen ? 0 : -1;
  }
}
