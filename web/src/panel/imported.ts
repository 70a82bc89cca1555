/** What became of a file that was read: what was changed, guessed and left out, each in the service's words. */
import type { ImportAnswer } from "../contract";
import { say } from "../words/language";

/** The list's parts, those with nothing to say left out. */
export function importLines({ changes, guesses, unread }: ImportAnswer): { readonly title: string; readonly lines: readonly string[] }[] {
  const parts = [
    { title: say("Guessed"), lines: guesses.map(({ of, what, taken, message }) => `${of}, ${what}: ${taken}; ${message}`) },
    { title: say("Left out"), lines: unread.map(({ place, reason }) => `${place}: ${reason}`) },
    { title: say("Changed"), lines: changes.map(({ of, message }) => (message.split(" ").includes(of) || of === "plan" ? message : `${of}: ${message}`)) },
  ];
  return parts.filter(({ lines }) => lines.length > 0);
}

export class ImportReport {
  constructor(readonly host: HTMLElement, readonly list: HTMLElement) {}

  /** Shows what there is to say of a file; null: nothing was read. */
  show(answer: ImportAnswer | null): void {
    const parts = answer ? importLines(answer) : [];
    this.host.hidden = parts.length === 0;
    this.list.replaceChildren(...parts.flatMap(({ title, lines }) => {
      const [head, list] = [document.createElement("h3"), document.createElement("ul")];
      head.textContent = `${title} (${lines.length})`;
      list.append(...lines.map((line) => {
        const item = document.createElement("li");
        item.textContent = line;
        return item;
      }));
      return [head, list];
    }));
  }
}
