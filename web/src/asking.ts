/** What the page asks of the service: its progress, its refusal, and trying it again. */
import type { Progress } from "./panel/progress";
import { isAbort, LOST, onceAnswered, ServiceProblem, useKey } from "./service";
import { Notice } from "./panel/notice";

/** Does something beside the question, `of` what is given once at a time. */
export type Beside = (what: string, act: () => Promise<void>, of?: unknown) => Promise<void>;

/** What a question is of: another home, what is wished of the one shown, or a plan that is being drawn. */
type Kind = "home" | "wish" | "drawn";

export class Asking {
  /** Called before a question about the home that is shown, or about another one. */
  onBegin: () => void = () => undefined;
  /** Called with what went wrong, null once a question went well. */
  onEnd: (reason: unknown) => void = () => undefined;
  readonly notice: Notice;
  #pending = new AbortController();
  #kind: Kind = "home";

  constructor(host: HTMLElement, readonly progress: Progress) {
    this.notice = new Notice(host, useKey);
  }

  /** Asks one question at a time: a newer one withdraws an older one, but a wish no other wish. What is shown of the answer hides the notice. */
  async run(what: string, ask: (signal: AbortSignal) => Promise<void>, kind: Kind = "home"): Promise<void> {
    if (kind !== "drawn") this.onBegin();
    if (kind !== "wish" || this.#kind !== "wish") {
      this.#pending.abort();
      this.notice.takeBack(this.#pending);
      this.#pending = new AbortController();
    }
    this.#kind = kind;
    const question = this.#pending;
    const { signal } = question;
    const end = this.progress.start(what);
    signal.addEventListener("abort", end, { once: true });
    try {
      await ask(signal);
      if (!signal.aborted) this.onEnd(null);
    } catch (reason) {
      if (isAbort(reason) || signal.aborted) return;
      this.notice.show(reason, () => void this.run(what, ask, kind), { what: question, of: ask });
      this.onEnd(reason);
    } finally {
      end();
    }
  }

  /** Says why a part of what is shown did not come: it is asked for again where that is wished, or, if it may come yet, once the service answers. */
  readonly missed = (reason: unknown, ask: () => void): void => {
    const again = (): void => {
      forget();
      this.notice.takeBack(again);
      ask();
    };
    const forget = reason instanceof ServiceProblem && reason.isFinal ? (): void => undefined : onceAnswered(again);
    this.notice.show(reason, again, reason === LOST ? { what: again } : { what: again, forget }); // a service that is there would refuse it again
  };

  /** Does something beside that, such as a file; what is under way already is not begun again, which is said. */
  readonly beside: Beside = async (what, act, of) => {
    if (this.progress.saysAgain(what, of)) return;
    const end = this.progress.start(what, of);
    try {
      await act();
      this.notice.takeBack(what, of ?? null);
    } catch (reason) {
      if (!isAbort(reason)) this.notice.show(reason, () => void this.beside(what, act, of), { what, of: of ?? null });
    } finally {
      end();
    }
  };
}
