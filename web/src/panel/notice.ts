/** What the service refuses, or that it is gone, in words over the canvas. */
import { ServiceProblem } from "../service";

export class Notice {
  readonly #title: HTMLElement;
  readonly #detail: HTMLElement;
  readonly #again: HTMLElement;

  constructor(readonly host: HTMLElement, tryAgain: () => void) {
    this.#title = host.querySelector<HTMLElement>(".notice-title") as HTMLElement;
    this.#detail = host.querySelector<HTMLElement>(".notice-detail") as HTMLElement;
    this.#again = host.querySelector<HTMLElement>(".notice-again") as HTMLElement;
    this.#again.addEventListener("click", tryAgain);
    host.querySelector(".notice-close")?.addEventListener("click", () => this.hide());
  }

  show(reason: unknown): void {
    const problem = reason instanceof ServiceProblem ? reason : new ServiceProblem("The page failed", String(reason));
    this.#title.textContent = problem.title;
    this.#detail.textContent = problem.detail;
    this.#again.hidden = problem.fields.length > 0;
    this.host.hidden = false;
  }

  hide(): void {
    this.host.hidden = true;
  }
}
