/** The kinds that a person likes to find again, kept in the browser. */

/** Where a word is kept under a name; null where none is. */
export interface Keeper {
  keepWord(name: string, word: string): Promise<void>;
  word(name: string): Promise<string | null>;
}

const NAME = "favourite kinds";

export class Favourites {
  #kinds: ReadonlySet<string> = new Set();

  constructor(readonly keeper: Keeper) {}

  /** Reads what is kept. */
  async read(): Promise<void> {
    const kept: unknown = JSON.parse((await this.keeper.word(NAME)) ?? "[]");
    if (Array.isArray(kept)) this.#kinds = new Set([...this.#kinds, ...kept.filter((kind) => typeof kind === "string")]);
  }

  has(kind: string): boolean {
    return this.#kinds.has(kind);
  }

  toggle(kind: string): void {
    const kinds = new Set(this.#kinds);
    if (!kinds.delete(kind)) kinds.add(kind);
    this.#kinds = kinds;
    void this.keeper.keepWord(NAME, JSON.stringify([...kinds]));
  }
}
