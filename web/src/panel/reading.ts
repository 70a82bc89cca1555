/** The readable YAML: lines that select their body, a search among them, and a flag for the selected one. */
import type { ViewAnswer } from "../contract";
import { made } from "../made";
import { timed } from "../timing";
import { writeHighlighted } from "./highlight";
import { LineList } from "./line_list";
import { bringIntoView } from "./scroll_within";
import { say } from "../words/language";
import { element } from "../element";

/** How many lines begin above a height under the first one [CSS pixels]. */
function lineAt(lines: readonly HTMLElement[], height: number): number {
  const top = lines[0]?.offsetTop ?? 0;
  let [first, last] = [0, lines.length];
  while (first < last) {
    const middle = (first + last) >> 1;
    if ((lines[middle] as HTMLElement).offsetTop - top < height) first = middle + 1;
    else last = middle;
  }
  return first;
}

function problematic(): HTMLElement {
  return made("span", { className: "problematic" }, "  ", made("mark", {}, "PROBLEMATIC"));
}

export class Reading {
  /** Called with the id of the body whose line was chosen. */
  onChoose: (id: string, adds: boolean) => void = () => undefined;
  /** Called with the id of the body to flag, or not any longer. */
  onFlag: (id: string) => void = () => undefined;
  readonly #list: LineList;
  readonly #flag = element<HTMLButtonElement>("flag");
  readonly #find = element<HTMLInputElement>("find");
  #selected: string | null = null;
  #flagged: ReadonlySet<string> = new Set();
  #found: HTMLButtonElement[] = [];
  readonly #coloured = new WeakSet<HTMLElement>();
  #asked = false;
  /** What comes to be shown with the text: folded away, a house's thousand lines would be made for nobody. */
  #waiting: ViewAnswer | null = null;

  constructor(readonly host: HTMLElement) {
    this.#list = new LineList(host);
    this.#list.onChoose = (id, adds) => this.onChoose(id, adds);
    host.addEventListener("scroll", () => this.#colourSoon(), { passive: true });
    new ResizeObserver(() => {
      this.#write();
      this.#colourSoon();
    }).observe(host);
    this.#flag.addEventListener("click", () => { if (this.#selected !== null) this.onFlag(this.#selected); });
    this.#find.addEventListener("input", () => this.#search());
    this.#find.addEventListener("keydown", (event) => this.#findKey(event));
    element("reading_toggle").addEventListener("click", () => this.#fold());
  }

  show(answer: ViewAnswer): void {
    this.#waiting = answer;
    this.#write();
  }

  #write(): void {
    const answer = this.#waiting;
    if (!answer || this.host.clientHeight === 0) return;
    this.#waiting = null;
    timed("text shown", () => this.#show(answer));
  }

  #show(answer: ViewAnswer): void {
    const texts = answer.text.replace(/\n$/, "").split("\n");
    this.#list.show(texts.map((text, i) => ({ text, id: answer.lines[i] ?? null, className: "yaml-line" })));
    this.flag(this.#flagged);
    this.select(this.#selected);
    if (this.#find.value !== "") this.#search();
    this.#colourSoon();
  }

  #colourSoon(): void {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame(() => {
      this.#asked = false;
      this.#colour();
    });
  }

  /** Highlights the lines in view and a screen around them: a house has thousands, of which few are ever read. */
  #colour(top = this.host.scrollTop): void {
    const { elements } = this.#list;
    const { clientHeight } = this.host;
    for (const line of elements.slice(lineAt(elements, top - clientHeight), lineAt(elements, top + 2 * clientHeight))) {
      if (this.#coloured.has(line)) continue;
      this.#coloured.add(line);
      const word = line.querySelector(".problematic");
      word?.remove();
      const text = line.textContent ?? "";
      line.replaceChildren();
      writeHighlighted(text, line);
      if (word) line.append(word);
    }
  }

  /** Marks the lines of the selected body and brings the first into view. */
  select(id: string | null): void {
    this.#selected = id;
    for (const button of this.#list.buttons) {
      const pressed = String(button.dataset.id === id);
      if (button.getAttribute("aria-pressed") !== pressed) button.setAttribute("aria-pressed", pressed);
    }
    this.#sayFlag();
    const [first] = id === null ? [] : this.#list.linesOf(id);
    if (!first) return;
    this.#bring(first);
    this.#list.reach(first);
  }

  /** Brings a line into view as it then is: lines around it that take colour change their height. */
  #bring(line: HTMLElement): void {
    this.#colour(line.offsetTop - (this.#list.elements[0]?.offsetTop ?? 0));
    bringIntoView(this.host, line);
  }

  /** Marks the lines of the flagged bodies PROBLEMATIC. */
  flag(ids: ReadonlySet<string>): void {
    this.#flagged = ids;
    for (const button of this.#list.buttons) this.#word(button, ids.has(button.dataset.id ?? ""));
    this.#sayFlag();
  }

  /** The word is text as the line is: to be copied, found and read out with it. */
  #word(line: HTMLElement, flagged: boolean): void {
    if (line.hasAttribute("data-flagged") === flagged) return;
    line.toggleAttribute("data-flagged", flagged);
    if (!flagged) line.querySelector(".problematic")?.remove();
    else line.append(problematic());
  }

  #sayFlag(): void {
    this.#flag.disabled = this.#selected === null;
    this.#flag.setAttribute("aria-pressed", String(this.#selected !== null && this.#flagged.has(this.#selected)));
  }

  #search(): void {
    const wanted = this.#find.value.trim().toLowerCase().replaceAll(" ", "_");
    for (const button of this.#found) button.classList.remove("found");
    const holds = (button: HTMLButtonElement): boolean => `${button.dataset.id} ${button.textContent}`.toLowerCase().includes(wanted);
    this.#found = wanted === "" ? [] : this.#list.buttons.filter(holds);
    for (const button of this.#found) button.classList.add("found");
    if (this.#found[0]) this.#bring(this.#found[0]);
    element("find_words").textContent = wanted === "" ? "" : say("{count} found", { count: this.#found.length });
  }

  /** Enter goes from one piece found to the next; keys typed here are no shortcuts. */
  #findKey(event: KeyboardEvent): void {
    event.stopPropagation();
    if (event.key === "Escape") {
      this.#find.value = "";
      this.#search();
    }
    if (event.key !== "Enter" || this.#found.length === 0) return;
    const at = this.#found.findIndex((button) => button.dataset.id === this.#selected);
    const next = this.#found[(at + (event.shiftKey ? this.#found.length - 1 : 1)) % this.#found.length];
    if (next?.dataset.id !== undefined) this.onChoose(next.dataset.id, false);
  }

  /** On a narrow screen the text can be folded away. */
  #fold(): void {
    const toggle = element("reading_toggle");
    const open = toggle.getAttribute("aria-expanded") !== "true";
    toggle.setAttribute("aria-expanded", String(open));
    element("reading").classList.toggle("folded", !open);
    if (open) this.select(this.#selected);
  }
}
