/** One menu over the house for what leaves it and comes to it: files, exports, pictures, plans, links, homes that are kept. */

import { button, made } from "../made";
import { fold } from "./preferences";
import { say, type Words } from "../words/language";

/** What an entry does: presses a control of the page, or brings a part of it into view. */
interface Entry {
  readonly words: Words;
  readonly presses?: string;
  readonly shows?: string;
  /** What comes of it is said in the menu, which stays. */
  readonly stays?: boolean;
}

const ENTRIES: readonly (readonly [Words, readonly Entry[]])[] = [
  ["Open", [
    { words: "A scene or plan from a file…", presses: "open_file" },
    { words: "Recent homes", shows: "recent" },
    { words: "Saved homes", shows: "saved" },
  ]],
  ["Save", [
    { words: "Save this home", shows: "saved_name" },
    { words: "JSON", presses: "download_json" },
    { words: "YAML", presses: "download_yaml" },
    { words: "For simulators, editors, training…", shows: "export_format" },
  ]],
  ["Picture and plan", [
    { words: "Picture of the view, 4K", presses: "picture" },
    { words: "Plan as SVG", presses: "plan_svg" },
    { words: "Plan as PNG", presses: "plan_png" },
    { words: "Print the plan", presses: "print_plan" },
    { words: "Change this plan", presses: "draw_this" },
    { words: "Draw a new plan", presses: "draw_new" },
  ]],
  ["Share", [
    { words: "Copy the link", presses: "copy_link", stays: true },
    { words: "Copy a frame for your own page", presses: "copy_frame", stays: true },
  ]],
  ["Help", [
    { words: "Diagnose", presses: "diagnose" },
    { words: "Tour in four steps", presses: "tour_again" },
    { words: "Keys", presses: "keys" },
  ]],
];

/** How wide the menu is at most, how far it stays from the window's edges, and from its button [CSS pixels]. */
const [WIDTH, MARGIN, GAP] = [560, 12, 6];

/** Brings a control or a section into view, opened, and gives it the focus. */
function show(id: string): void {
  const target = document.getElementById(id);
  fold("controls", false);
  for (let around: Element | null = target; around; around = around.parentElement) {
    if (around instanceof HTMLDetailsElement) around.open = true;
  }
  const focused = target?.querySelector<HTMLElement>(":scope > summary") ?? target;
  focused?.focus();
  focused?.scrollIntoView({ block: "nearest" });
}

export class Menu {
  readonly #host = made("div", { id: "menu", className: "menu", popover: "auto", role: "group", "aria-label": say("Menu") });
  /** The page's own buttons that entries press. */
  readonly #pressing = new Map<HTMLButtonElement, HTMLButtonElement>();

  /** `tools` holds the button that opens it; what is `said` of links is said in it, too. */
  constructor(tools: Element, said: Element) {
    const opener = tools.querySelector<HTMLButtonElement>("[data-tool=menu]") as HTMLButtonElement;
    const told = made("p", { role: "status" });
    this.#host.append(...ENTRIES.map(([title, entries]) => this.#section(title, entries)), told);
    tools.after(this.#host);
    new MutationObserver(() => { told.textContent = said.textContent; }).observe(said, { childList: true, characterData: true });
    opener.setAttribute("aria-haspopup", "true");
    opener.setAttribute("aria-expanded", "false");
    opener.popoverTargetElement = this.#host;
    this.#host.addEventListener("beforetoggle", () => this.#standUnder(opener));
    this.#host.addEventListener("toggle", () => {
      const isOpen = this.#host.matches(":popover-open");
      opener.setAttribute("aria-expanded", String(isOpen));
      if (!isOpen) return;
      told.textContent = "";
      for (const [entry, target] of this.#pressing) entry.disabled = target.disabled;
      this.#host.querySelector<HTMLButtonElement>("button:enabled")?.focus();
    });
    this.#host.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Stands under its button, within the window; its greatest height leaves the button in view. */
  #standUnder(opener: HTMLElement): void {
    const { left, bottom } = opener.getBoundingClientRect();
    const width = Math.min(WIDTH, window.innerWidth - 2 * MARGIN);
    const { style } = this.#host;
    style.left = `${Math.max(MARGIN, Math.min(left, window.innerWidth - width - MARGIN))}px`;
    style.top = `${bottom + GAP}px`;
    style.maxHeight = `${window.innerHeight - bottom - GAP - MARGIN}px`;
  }

  #section(title: Words, entries: readonly Entry[]): HTMLElement {
    return made("section", {}, made("h2", {}, say(title)), ...entries.map((entry) => this.#entry(entry)));
  }

  #entry({ words, presses, shows, stays }: Entry): HTMLButtonElement {
    const target = presses === undefined ? null : document.getElementById(presses);
    const entry = button(say(words), () => {
      if (!stays) this.#host.hidePopover();
      if (shows !== undefined) show(shows);
      target?.click();
    });
    if (target instanceof HTMLButtonElement) this.#pressing.set(entry, target);
    return entry;
  }

  /** Keys act on the menu alone while it has the focus; arrows go from entry to entry. */
  #key(event: KeyboardEvent): void {
    event.stopPropagation();
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const all = [...this.#host.querySelectorAll<HTMLButtonElement>("button:enabled")];
    const at = all.findIndex((one) => one === document.activeElement);
    all[(at + step + all.length) % all.length]?.focus();
  }
}
