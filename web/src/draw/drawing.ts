/** Drawing a plan: the board is loaded when it is first opened. */
import type { Beside } from "../asking";
import type { Scene } from "../contract";
import { catalog, fix, furnish, LOST, report } from "../service";
import { say } from "../words/language";
import type { Board, Drawn } from "./board";

export class Drawing {
  /** Called with a plan whose empty rooms are to be furnished. */
  onFurnish: (drawn: Drawn) => void = () => undefined;
  /** Called with a plan to be shown as it is. */
  onShow: (drawn: Drawn) => void = () => undefined;
  #board: Board | null = null;

  /** What had the focus before. */
  #before: Element | null = null;
  /** After which what is told has its place while the board is closed. */
  readonly #places: readonly Comment[];

  /** `covered` is what lies under the board, out of reach while it is open, but for what is `told` in it: that lies over the board then. */
  constructor(readonly host: HTMLElement, readonly covered: readonly HTMLElement[], readonly told: readonly HTMLElement[], readonly beside: Beside, readonly failed: (reason: unknown, again?: () => void) => void) {
    this.#places = told.map(() => document.createComment(""));
    told.forEach((one, at) => one.before(this.#places[at]!));
  }

  /** Opens the board on a home; null: on an empty sheet. */
  open(scene: Scene | null): Promise<void> {
    this.#before = document.activeElement;
    return this.beside(say("Opening the drawing board"), async () => {
      const board = await this.#load();
      for (const element of this.covered) element.inert = true;
      this.host.append(...this.told);
      board.open(scene);
    });
  }

  /** Lays a picture beneath what is drawn: on an empty sheet, where the board is not open. */
  async openPicture(file: File): Promise<void> {
    if (this.#board?.isOpen !== true) await this.open(null);
    await this.#board?.lay(file);
  }

  /** Closes the board, where it is open, before another home. */
  close(): void {
    if (this.#board?.isOpen) this.#board.close();
  }

  /** Closes the board on what is shown now, and tells what was left out of it; null: that is no longer what is drawn. */
  finish(): string | null {
    return this.#board ? this.#board.finish() : "";
  }

  async #load(): Promise<Board> {
    if (this.#board) return this.#board;
    const { Board: Made } = await import("./board").catch(() => { throw LOST; });
    const calls = { catalog, fix, furnish, validate: (scene: Scene, signal: AbortSignal) => report(scene, [], signal) };
    return (this.#board ??= new Made(this.host, calls, {
      furnish: (drawn) => this.onFurnish(drawn),
      show: (drawn) => this.onShow(drawn),
      failed: (reason, again) => this.failed(reason, again),
      closed: () => this.#uncover(),
    }));
  }

  #uncover(): void {
    for (const element of this.covered) element.inert = false;
    this.told.forEach((one, at) => this.#places[at]?.after(one));
    const isLeft = this.host.contains(document.activeElement) || document.activeElement === document.body;
    if (isLeft && this.#before instanceof HTMLElement) this.#before.focus();
  }
}
