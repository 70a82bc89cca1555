/** What the page asks of the service: its progress, its refusal, and trying it again. */
import type { Progress } from "./panel/progress";
import { isAbort, useKey } from "./service";
import { Notice } from "./panel/notice";

/** Does something beside the question, `of` what is given once at a time. */
export type Beside = (what: string, act: () => Promise<void>, of?: unknown) => Promise<void>;

export class Asking {
  /** Called before a question about the home that is shown, or about another one. */
  onBegin: () => void = () => undefined;
  /** Called with what went wrong, null once a question went well. */
  onEnd: (reason: unknown) => void = () => undefined;
  readonly notice: Notice;
  #pending = new AbortController();
  #end = (): void => undefined;
  /** What was refused last beside the question. */
  #refused: string | null = null;

  constructor(host: HTMLElement, readonly progress: Progress) {
    this.notice = new Notice(host, useKey);
  }

  /** Asks one question at a time: a newer one withdraws an older one. What is shown of the answer hides the notice. One `ofDrawn` is of a plan that is being drawn. */
  async run(what: string, ask: (signal: AbortSignal) => Promise<void>, ofDrawn = false): Promise<void> {
    if (!ofDrawn) this.onBegin();
    this.#pending.abort();
    this.#end();
    const { signal } = (this.#pending = new AbortController());
    const end = (this.#end = this.progress.start(what));
    try {
      await ask(signal);
      if (!signal.aborted) this.onEnd(null);
    } catch (reason) {
      if (isAbort(reason)) return;
      this.notice.show(reason, () => void this.run(what, ask, ofDrawn));
      this.onEnd(reason);
    } finally {
      end();
    }
  }

  /** Does something beside that, such as a file; what is under way already is not begun again, which is said. */
  readonly beside: Beside = async (what, act, of) => {
    if (this.progress.saysAgain(what, of)) return;
    const end = this.progress.start(what, of);
    try {
      await act();
      if (this.#refused === what) this.notice.hide();
    } catch (reason) {
      if (isAbort(reason)) return;
      this.#refused = what;
      this.notice.show(reason, () => void this.beside(what, act, of));
    } finally {
      end();
    }
  };
}
