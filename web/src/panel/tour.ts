/** A tour of four steps over the house: shown by itself on a first visit that asks for no home of its own, started again by a button; it ends when somebody begins without it. */
import type { Showing } from "../state/home";
import { button, made } from "../made";
import { say, type Words } from "../words/language";
import { putAway } from "./focus";
import { remember, remembered } from "./preferences";

interface Step {
  readonly title: Words;
  readonly words: Words;
  /** What of the page the step speaks of. */
  readonly of: string;
}

const NAME = "tour";
const STEPS: readonly [Step, ...Step[]] = [
  { title: "Ask for a home", words: "Say rooms and area, or begin with one of the three pictures. Random draws another.", of: "#starts" },
  { title: "Look around", words: "Drag to turn, scroll or pinch to come nearer. Here are the plan, 3D and a walk.", of: ".views" },
  { title: "Change it", words: "Click a piece and drag it: what stands beside it gives way, and a line says why where it cannot. + adds a piece.", of: "#tools" },
  { title: "Keep it", words: "Every step is kept in this browser. The menu saves, prints, shares and exports; this tour is in it, too.", of: "[data-tool=menu]" },
];

/** Whether somebody comes for the first time, to the page itself and not by a link to a home. */
function isFirstVisit(address: Pick<Location, "search" | "hash">): boolean {
  return remembered(NAME) === null && address.search === "" && address.hash === "";
}

export class Tour {
  readonly #title = made("h2", { tabIndex: -1 });
  readonly #words = made("p");
  readonly #back = button(say("Back"), () => this.#show(this.#at - 1));
  readonly #next = button(say("Next"), () => this.#show(this.#at + 1));
  readonly #skip = button(say("Skip the tour"), () => this.#end());
  #at = 0;

  /** `host` shows it, `again` starts it; `onShown` is given what to call whenever a home is shown. */
  constructor(readonly host: HTMLElement, again: HTMLElement, onShown: (greet: (how: Showing) => void) => void) {
    let greets = isFirstVisit(location);
    onShown((how) => {
      if (greets) this.start();
      else if (how === "new") this.#end();
      greets = false;
    });
    document.addEventListener("click", ({ target }) => {
      if (target instanceof Element && !target.closest("#tour, [data-toured], canvas")) this.#end();
    }, true);
    host.append(made("div", { "aria-live": "polite" }, this.#title, this.#words), made("div", { className: "buttons" }, this.#skip, this.#back, this.#next));
    host.addEventListener("keydown", (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      this.#end();
    });
    again.addEventListener("click", () => {
      this.start();
      this.#title.focus();
    });
  }

  /** Shows the first step; whatever has the focus keeps it. */
  start(): void {
    remember(NAME, "seen");
    this.host.hidden = false;
    this.#show(0);
  }

  #show(at: number): void {
    const step = STEPS[at];
    if (!step) return this.#end();
    this.#at = at;
    this.#mark(step.of);
    this.#title.textContent = `${at + 1}/${STEPS.length} · ${say(step.title)}`;
    this.#words.textContent = say(step.words);
    if (at === 0 && document.activeElement === this.#back) this.#next.focus();
    this.#back.hidden = at === 0;
    this.#skip.hidden = at === STEPS.length - 1;
    this.#next.textContent = at === STEPS.length - 1 ? say("Done") : say("Next");
  }

  #mark(selector: string | null): void {
    for (const marked of document.querySelectorAll("[data-toured]")) marked.removeAttribute("data-toured");
    if (selector !== null) document.querySelector(selector)?.setAttribute("data-toured", "");
  }

  /** Puts the tour away; the focus, if the tour had it, goes to the house. */
  #end(): void {
    if (this.host.hidden) return;
    putAway(this.host);
    this.#mark(null);
  }
}
