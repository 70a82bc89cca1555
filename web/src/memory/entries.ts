/** Entries of the browser's history: each is of a home, which opens from it as it was left. */
import type { GivenFile } from "../service";

interface Held {
  readonly home?: string;
  /** A file's content, where the browser keeps no homes. */
  readonly file?: GivenFile;
}

/** What the entry that is open holds. */
export function entry(): Held {
  return (window.history.state as Held | null) ?? {};
}

export class Entries {
  #isNext = false;
  #file: GivenFile | null = null;

  /** What is shown next gets an entry of its own, unless it is the home and the address of this one. */
  expect(isNext: boolean, file: GivenFile | null = null): void {
    [this.#isNext, this.#file] = [isNext, file];
  }

  /** The home that is shown now has this address; `lasts`: it will be found by its id. */
  show(home: string | null, query: string | null, lasts: boolean): void {
    const url = query ?? location.pathname;
    const isNext = this.#isNext && !(entry().home === home && location.search === (query ?? ""));
    const file = this.#file ?? (entry().home === home ? entry().file : undefined);
    this.#isNext = false;
    this.#file = null;
    if (!isNext && entry().home === home && location.search === (query ?? "") && location.hash === "") return;
    const held: Held = { ...(home ? { home } : {}), ...(file && !lasts ? { file } : {}) };
    try {
      write(isNext, held, url);
    } catch {
      write(isNext, home ? { home } : {}, url); // the file is too large for that
    }
  }
}

function write(isNext: boolean, held: Held, url: string): void {
  if (isNext) window.history.pushState(held, "", url);
  else window.history.replaceState(held, "", url);
}
