/** That work is under way, and for how long: what is done at once is not worth a word. */

/** When the bar comes, and when the words do [ms]. */
const [BAR_AFTER_MS, WORDS_AFTER_MS] = [150, 1000];

interface Work {
  readonly what: string;
  /** What it is done with. */
  readonly of: unknown;
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

  #find(what: string, of: unknown = null): Work | undefined {
    return this.#works.find((work) => work.what === what && work.of === of);
  }

  /** Whether something called so is under way, which is said at once and before all else then. */
  saysAgain(what: string, of: unknown = null): boolean {
    const work = this.#find(what, of);
    if (!work) return false;
    this.#set([work, ...this.#works.filter((one) => one !== work)]);
    this.host.hidden = false;
    this.#say(work);
    return true;
  }

  /** Shows that something is under way, of several the first, until what is returned is called. */
  start(what: string, of: unknown = null): () => void {
    const work: Work = { what, of, since: performance.now() };
    this.#set([...this.#works, work]);
    return () => { this.#set(this.#works.filter((one) => one !== work)); };
  }

  /** Shows that something is under way, or no longer, which tells so itself. */
  turn(what: string, isOn: boolean): void {
    const others = this.#works.filter((work) => work.what !== what);
    this.#set(!isOn ? others : this.#find(what) ? this.#works : [...others, { what, of: null, since: performance.now() }]);
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
