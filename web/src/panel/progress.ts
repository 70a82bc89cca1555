/** That work is under way, and for how long: what is done at once is not worth a word. */

/** When the bar comes, and when the words do [ms]. */
const [BAR_AFTER_MS, WORDS_AFTER_MS] = [150, 1000];

export class Progress {
  #since: number | null = null;
  #ticking = 0;
  #waiting = 0;
  readonly #words: HTMLElement;

  constructor(readonly host: HTMLElement, readonly busy: HTMLElement) {
    this.#words = host.querySelector("span") as HTMLElement;
    this.#hide(); // until now the page itself was under way
  }

  start(what: string): void {
    this.stop();
    this.#since = performance.now();
    this.#waiting = window.setTimeout(() => { this.host.hidden = false; }, BAR_AFTER_MS);
    this.host.setAttribute("aria-label", what);
    this.busy.setAttribute("aria-busy", "true");
    this.#ticking = window.setInterval(() => this.#say(what), WORDS_AFTER_MS);
  }

  stop(): void {
    clearTimeout(this.#waiting);
    clearInterval(this.#ticking);
    this.#since = null;
    this.#hide();
    this.busy.setAttribute("aria-busy", "false");
  }

  #hide(): void {
    this.#words.textContent = "";
    this.host.hidden = true;
  }

  #say(what: string): void {
    if (this.#since !== null) this.#words.textContent = `${what}… ${Math.round((performance.now() - this.#since) / 1000)} s`;
  }
}
