/** The newest of several questions: each withdraws the one before, whose answer is told nobody. */
export class Newest {
  #asked = new AbortController();

  /** Withdraws the question before; the signal of the next. */
  next(): AbortSignal {
    this.stop();
    this.#asked = new AbortController();
    return this.#asked.signal;
  }

  /** Withdraws the question. */
  stop(): void {
    this.#asked.abort();
  }
}
