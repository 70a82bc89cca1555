/**
 * Asks a slow service about a thing that changes fast: one question in flight, the newest waiting, the newest answer told.
 * Questions in between are never sent.
 */

export interface LiveWords<Question, Answer> {
  ask(question: Question, signal: AbortSignal): Promise<Answer>;
  answered(answer: Answer, question: Question): void;
  failed(reason: unknown): void;
}

export class Live<Question, Answer> {
  #waiting: Question | null = null;
  #inFlight = false;
  #round = new AbortController();

  constructor(readonly words: LiveWords<Question, Answer>) {}

  get busy(): boolean {
    return this.#inFlight;
  }

  /** Whether a newer question waits. */
  get waits(): boolean {
    return this.#waiting !== null;
  }

  /** Wants an answer to this; replaces what still waits. */
  want(question: Question): void {
    this.#waiting = question;
    if (!this.#inFlight) void this.#send();
  }

  /** Drops what waits; what is in flight is no longer told. */
  stop(): void {
    this.#waiting = null;
    this.#round.abort();
    this.#round = new AbortController();
  }

  async #send(): Promise<void> {
    this.#inFlight = true;
    while (this.#waiting !== null) {
      const question = this.#waiting;
      this.#waiting = null;
      await this.#exchange(question, this.#round.signal);
    }
    this.#inFlight = false;
  }

  async #exchange(question: Question, signal: AbortSignal): Promise<void> {
    try {
      const answer = await this.words.ask(question, signal);
      if (!signal.aborted) this.words.answered(answer, question);
    } catch (reason) {
      if (signal.aborted) return;
      this.stop();
      this.words.failed(reason);
    }
  }
}
