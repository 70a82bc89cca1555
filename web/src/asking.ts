/** One question to the service at a time: its progress, its refusal, and trying it again. */
import type { Progress } from "./panel/progress";
import { isAbort, useKey } from "./service";
import { Notice } from "./panel/notice";

export class Asking {
  /** Called with what went wrong, null once a question went well. */
  onEnd: (reason: unknown) => void = () => undefined;
  readonly notice: Notice;
  #pending = new AbortController();

  constructor(host: HTMLElement, readonly progress: Progress) {
    this.notice = new Notice(host, useKey);
  }

  /** Asks; a newer question withdraws an older one. What is shown of the answer hides the notice. */
  async run(what: string, ask: (signal: AbortSignal) => Promise<void>): Promise<void> {
    this.#pending.abort();
    const { signal } = (this.#pending = new AbortController());
    this.progress.start(what);
    try {
      await ask(signal);
      if (signal.aborted) return; // it ended without an answer: the newer question's progress goes on
      this.onEnd(null);
    } catch (reason) {
      if (isAbort(reason)) return;
      this.notice.show(reason, () => void this.run(what, ask));
      this.onEnd(reason);
    }
    this.progress.stop();
  }
}
