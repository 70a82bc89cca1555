/** What the service refuses, or that it is gone, in words over the canvas. */
import { button, made } from "../made";
import { ServiceProblem } from "../service";
import { say } from "../words/language";
import { refusalWords } from "./field_words";
import { putAway } from "./focus";

/** Does again what was refused. */
export type Again = () => void;

function againIn(seconds: number): string {
  return seconds === 1 ? say("Try again in 1 second") : say("Try again in {count} seconds", { count: seconds });
}

function wrongFields(count: number): string {
  return count === 1 ? say("A field needs another value") : say("{count} fields need another value", { count });
}

export class Notice {
  readonly #title: HTMLElement;
  readonly #detail: HTMLElement;
  readonly #again: HTMLButtonElement;
  readonly #key: HTMLFormElement;
  readonly #ways = made("div");
  /** The page's own words for wrong fields, a line each; null where it has none. */
  inWords: (problem: ServiceProblem) => readonly string[] | null = () => null;
  #counting = 0;
  #retry: Again | null = null;
  /** What is given up once a person closes it. */
  #forget: () => void = () => undefined;

  constructor(readonly host: HTMLElement, readonly useKey: (key: string) => void) {
    this.#title = host.querySelector<HTMLElement>(".notice-title") as HTMLElement;
    this.#detail = host.querySelector<HTMLElement>(".notice-detail") as HTMLElement;
    this.#again = host.querySelector<HTMLButtonElement>(".notice-again") as HTMLButtonElement;
    this.#key = host.querySelector<HTMLFormElement>(".notice-key") as HTMLFormElement;
    this.#detail.after(this.#ways);
    this.#again.addEventListener("click", () => this.#retry?.());
    this.#key.addEventListener("submit", (event) => this.#submitKey(event));
    host.querySelector(".notice-close")?.addEventListener("click", () => {
      this.hide();
      this.#forget();
    });
  }

  /** Says what went wrong, and what is the case now; without `again` a person does it again by hand. `forget`: it is closed, and no more wished for. */
  show(reason: unknown, again: Again | null = null, outcome: string | null = null, forget = (): void => undefined): void {
    [this.#retry, this.#forget] = [again, forget];
    const { fields = [], status = null, retryAfter = null, ways = [] }: Partial<ServiceProblem> = reason instanceof ServiceProblem ? reason : {};
    const ofForm = reason instanceof ServiceProblem ? this.inWords(reason) : null;
    const { title, lines } = ofForm ? { title: wrongFields(ofForm.length), lines: ofForm } : refusalWords(reason);
    this.#title.textContent = title;
    this.#detail.textContent = [...lines, ...(outcome === null ? [] : [outcome])].join("\n");
    this.#ways.replaceChildren(...ways.map(([words, act]) => button(words, act)));
    this.#key.hidden = status !== 401;
    const passes = fields.length === 0 || status === 503 || status === 429;
    this.#again.hidden = !again || !passes || status === 401 || status === 413;
    this.host.hidden = false;
    this.#countDown(retryAfter ?? 0);
    if (status === 401) this.#field().focus();
  }

  get isShown(): boolean {
    return !this.host.hidden;
  }

  /** What does again what is told of; null where nothing is. */
  get again(): Again | null {
    return this.isShown ? this.#retry : null;
  }

  hide(): void {
    putAway(this.host);
    this.#countDown(0);
  }

  /** Says how long to wait; until then there is nothing to try. */
  #countDown(seconds: number): void {
    clearInterval(this.#counting);
    let left = seconds;
    const tick = (): void => {
      this.#again.disabled = left > 0;
      this.#again.textContent = left > 0 ? againIn(left) : say("Try again");
      if (left <= 0) clearInterval(this.#counting);
      left -= 1;
    };
    if (left > 0) this.#counting = window.setInterval(tick, 1000);
    tick();
  }

  #field(): HTMLInputElement {
    return this.#key.querySelector("input") as HTMLInputElement;
  }

  #submitKey(event: Event): void {
    event.preventDefault();
    const key = this.#field().value.trim();
    this.#field().value = "";
    if (!key) return;
    this.useKey(key);
    if (this.#retry) this.#retry();
    else this.hide();
  }
}
