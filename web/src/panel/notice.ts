/** What the service refuses, or that it is gone, in words over the canvas: all that was refused and is not done by now. */
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

/** What is known of what was refused beside the reason. */
interface Refused {
  /** What it is, and of what: a newer refusal of the same takes its place. */
  readonly what: unknown;
  readonly of: unknown;
  /** Does it again; without it a person does so by hand. */
  readonly again: Again | null;
  /** What is the case now. */
  readonly outcome: string | null;
  /** A person closes it: it is no more wished for. */
  forget(): void;
}

interface Told extends Refused {
  readonly problem: Partial<ServiceProblem>;
  readonly title: string;
  readonly lines: readonly string[];
  /** From when on it may be tried again. */
  readonly from: number;
}

const NOTHING_ELSE: Refused = { what: null, of: null, again: null, outcome: null, forget: () => undefined };

/** Whether the same may be done again: where a field is wrong, or it is too large, it would be refused again. */
function mayPass({ again, problem: { fields = [], status = null } }: Told): boolean {
  return again !== null && status !== 413 && (fields.length === 0 || status === 503 || status === 429);
}

function wantsKey({ problem }: Told): boolean {
  return problem.status === 401;
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
  /** What was refused, the newest last. */
  #told: readonly Told[] = [];

  constructor(readonly host: HTMLElement, readonly useKey: (key: string) => void) {
    this.#title = host.querySelector<HTMLElement>(".notice-title") as HTMLElement;
    this.#detail = host.querySelector<HTMLElement>(".notice-detail") as HTMLElement;
    this.#again = host.querySelector<HTMLButtonElement>(".notice-again") as HTMLButtonElement;
    this.#key = host.querySelector<HTMLFormElement>(".notice-key") as HTMLFormElement;
    this.#detail.after(this.#ways);
    this.#again.addEventListener("click", () => this.#tryAgain());
    this.#key.addEventListener("submit", (event) => this.#submitKey(event));
    host.querySelector(".notice-close")?.addEventListener("click", () => {
      const told = this.#told;
      this.hide();
      for (const { forget } of told) forget();
    });
  }

  /** Says what went wrong, beside what else is refused. */
  show(reason: unknown, again: Again | null = null, more: Partial<Refused> = {}): void {
    const problem: Partial<ServiceProblem> = reason instanceof ServiceProblem ? reason : {};
    const ofForm = reason instanceof ServiceProblem ? this.inWords(reason) : null;
    const words = ofForm ? { title: wrongFields(ofForm.length), lines: ofForm } : refusalWords(reason);
    const refused: Told = { ...NOTHING_ELSE, ...more, ...words, again, problem, from: performance.now() + (problem.retryAfter ?? 0) * 1000 };
    this.#tell([...this.#without(refused.what, refused.of), refused]);
    if (wantsKey(refused)) this.#field().focus();
  }

  get isShown(): boolean {
    return !this.host.hidden;
  }

  hide(): void {
    this.#tell([]);
  }

  /** What was refused is done, or done again, or no more wished for: it is told no longer. */
  takeBack(what: unknown, of?: unknown): void {
    const left = this.#without(what, of);
    if (left.length < this.#told.length) this.#tell(left);
  }

  /** What was refused but this; of whatever it is, where that is not said. */
  #without(what: unknown, of?: unknown): readonly Told[] {
    return this.#told.filter((one) => one.what !== what || (of !== undefined && one.of !== of));
  }

  /** Tells of all refusals, the newest first: what several say alike once. */
  #tell(told: readonly Told[]): void {
    this.#told = told;
    const [newest, ...others] = [...told].reverse();
    if (!newest) putAway(this.host);
    else {
      const first = [...newest.lines, ...(newest.outcome === null ? [] : [newest.outcome])];
      const more = others.filter(({ title, lines }) => title !== newest.title || lines.join() !== newest.lines.join());
      this.#title.textContent = newest.title;
      this.#detail.textContent = [...first, ...new Set(more.map(({ title, lines }) => [title, ...lines].join("\n")))].join("\n");
      this.#ways.replaceChildren(...told.flatMap(({ problem: { ways = [] } }) => ways.map(([words, act]) => button(words, act))));
      this.#key.hidden = !told.some(wantsKey);
      this.#again.hidden = !told.some((one) => mayPass(one) && !wantsKey(one));
      this.host.hidden = false;
    }
    this.#countDown(Math.ceil((Math.max(0, ...told.map(({ from }) => from)) - performance.now()) / 1000));
  }

  /** Does again what may pass now, in the order in which it was asked for; what is refused anew is told anew. */
  #tryAgain(): void {
    const passing = this.#told.filter(mayPass);
    this.#tell(this.#told.filter((one) => !mayPass(one)));
    for (const { again } of passing) again?.();
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
    this.#tell(this.#told.filter((one) => !wantsKey(one) || one.again !== null));
    this.#tryAgain();
  }
}
