/** Why the chosen piece stands where it does: what holds it back from where it was wished, in the service's words. */
import type { Explained, Hold, Scene } from "../contract";
import { isAbort } from "../service";
import { pieceWords } from "./words";

export type AskWhy = (scene: Scene, id: string, signal: AbortSignal) => Promise<Explained>;

export class WhyPanel {
  onChoose: (id: string) => void = () => undefined;
  #pending = new AbortController();

  constructor(readonly host: HTMLElement, readonly ask: AskWhy, readonly failed: (reason: unknown) => void) {}

  /** Asks about a piece and shows the answer. */
  async show(scene: Scene, id: string): Promise<void> {
    this.hide();
    const { signal } = this.#pending;
    try {
      const answer = await this.ask(scene, id, signal);
      this.host.replaceChildren(...this.#contents(answer));
      this.host.hidden = false;
    } catch (reason) {
      if (!isAbort(reason)) this.failed(reason);
    }
  }

  hide(): void {
    this.#pending.abort();
    this.#pending = new AbortController();
    this.host.hidden = true;
    this.host.replaceChildren();
  }

  #contents(answer: Explained): HTMLElement[] {
    const heading = document.createElement("strong");
    heading.textContent = `Why the ${pieceWords(answer.id)} stands here`;
    const notes = [...wishOf(answer), ...answer.notes].map((note) => {
      const words = document.createElement("p");
      words.textContent = `${note.charAt(0).toUpperCase()}${note.slice(1)}.`;
      return words;
    });
    const list = document.createElement("ul");
    list.append(...answer.holds.map((hold) => this.#line(hold)));
    const close = button("Close", () => this.hide());
    return [heading, ...notes, ...(answer.holds.length > 0 ? [list] : []), close];
  }

  /** What holds it; a piece that does can be chosen. */
  #line(hold: Hold): HTMLElement {
    const line = document.createElement("li");
    const { by } = hold;
    const isPiece = by !== null && (hold.what === "piece" || hold.what === "use_side" || hold.what === "relation");
    if (isPiece) line.append(button(hold.message, () => this.onChoose(by)));
    else line.textContent = hold.message;
    return line;
  }
}

/** How far it stands from where it was wished. */
function wishOf({ wished, stands }: Explained): string[] {
  const away = wished ? Math.hypot(wished[0] - stands[0], wished[1] - stands[1]) : 0;
  return away >= 0.02 ? [`it was wished ${away.toFixed(2)} m from here`] : [];
}

function button(words: string, act: () => void): HTMLButtonElement {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = words;
  made.addEventListener("click", act);
  return made;
}
