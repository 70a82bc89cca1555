/** That work is under way, and for how long: what is done at once is not worth a word. */

/** When the bar comes, and when the words do [ms]. */
const [BAR_AFTER_MS, WORDS_AFTER_MS] = [150, 1000];

interface Work {
  readonly what: string;
  readonly since: number;
}

export class Progress {
  #works: readonly Work[] = [];
  #ticking = 0;
  #waiting = 0;
  readonly #words: HTMLElement;

  constructor(readonly host: HTMLElement, readonly busy: HTMLElement) {
    this.#words = host.querySelector("span") as HTMLElement;
    this.#hide(); // until now the page itself was under way
  }

  /** Whether something called so is under way. */
  has(what: string): boolean {
    return this.#works.some((work) => work.what === what);
  }

  /** Shows that something is under way, of several the first, until what is returned is called. */
  start(what: string): () => void {
    const work: Work = { what, since: performance.now() };
    this.#set([...this.#works, work]);
    return () => { this.#set(this.#works.filter((one) => one !== work)); };
  }

  /** Shows that something is under way, or no longer, which tells so itself. */
  turn(what: string, isOn: boolean): void {
    const others = this.#works.filter((work) => work.what !== what);
    this.#set(!isOn ? others : this.has(what) ? this.#works : [...others, { what, since: performance.now() }]);
  }

  #set(works: readonly Work[]): void {
    const [was, is] = [this.#works[0], works[0]];
    this.#works = works;
    if (was === is) return;
    clearTimeout(this.#waiting);
    clearInterval(this.#ticking);
    this.busy.setAttribute("aria-busy", String(is !== undefined));
    if (!is) return this.#hide();
    this.#words.textContent = "";
    this.host.setAttribute("aria-label", is.what);
    this.#waiting = window.setTimeout(() => { this.host.hidden = false; }, BAR_AFTER_MS);
    this.#ticking = window.setInterval(() => { this.#say(is); }, WORDS_AFTER_MS);
  }

  #hide(): void {
    this.#words.textContent = "";
    this.host.hidden = true;
  }

  #say({ what, since }: Work): void {
    this.#words.textContent = `${what}… ${Math.round((performance.now() - since) / 1000)} s`;
  }
}
