/** What became of a file that was read: what was changed, guessed and left out, each in the service's words. */
import type { ImportAnswer } from "../contract";
import { say, sayDecimals } from "../words/language";
import { tell, tellPlainly, tellSentence } from "../words/telling";

/** The list's parts, those with nothing to say left out. */
export function importLines({ scene, changes, guesses, unread }: ImportAnswer): { readonly title: string; readonly lines: readonly string[] }[] {
  const known = new Set(scene.rooms.flatMap((room) => [room, ...room.furniture, ...room.decorations, ...room.openings].map(({ id }) => id)));
  const called = (of: string): string => (known.has(of) ? tellSentence(of, scene) : tellPlainly(of));
  const told = (words: string): string => tell(words, scene);
  const parts = [
    { title: say("Guessed"), lines: guesses.map(({ of, what, taken, message }) => `${called(of)}, ${told(what)}: ${sayDecimals(told(taken))}; ${told(message)}`) },
    { title: say("Left out"), lines: unread.map(({ place, reason }) => `${called(place)}: ${told(reason)}`) },
    { title: say("Changed"), lines: changes.map(({ of, message }) => (message.split(" ").includes(of) || of === "plan" ? tellSentence(message, scene) : `${called(of)}: ${told(message)}`)) },
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
