/** The kinds that a person likes to find again, remembered in this browser at once: a page that is left right after a click has kept it. */
import { remember, remembered } from "../panel/preferences";

const NAME = "favourites";

function read(): readonly string[] {
  try {
    const kept: unknown = JSON.parse(remembered(NAME) ?? "[]");
    return Array.isArray(kept) ? kept.filter((kind) => typeof kind === "string") : [];
  } catch {
    return []; // what somebody else wrote there
  }
}

export class Favourites {
  #kinds: ReadonlySet<string> = new Set(read());

  has(kind: string): boolean {
    return this.#kinds.has(kind);
  }

  toggle(kind: string): void {
    const kinds = new Set(this.#kinds);
    if (!kinds.delete(kind)) kinds.add(kind);
    this.#kinds = kinds;
    remember(NAME, JSON.stringify([...kinds]));
  }
}
