/** Every step of every home is kept, undo goes on from a home to the one before, and any of them opens as it was left. */
import { queryFromRequest } from "../address";
import type { Beyond, Home, Shown, Showing } from "../state/home";
import { changeBetween, changed, type Change } from "./changes";
import type { Head, KeptStep, Store } from "./store";
import { say, sayName, sayNumber } from "../words/language";

/** Homes that were never edited are kept up to this many: each can be made again. Our choice. */
const MOST_PLAIN = 60;

/** A step as a text that is read back to the very same: the change from the one before where that is shorter. */
export function keptStep(home: string, number: number, step: Shown, before: Shown | null): KeptStep {
  const whole = JSON.stringify(step);
  const change = before && changeBetween(before, step);
  const text = change ? JSON.stringify(change) : null;
  const isExact = text !== null && text.length * 2 < whole.length && JSON.stringify(changed(before, JSON.parse(text) as Change)) === whole;
  return isExact ? { home, number, whole: null, change: text } : { home, number, whole, change: null };
}

/** The steps of a home from their texts. */
export function stepsOf(kept: readonly KeptStep[]): Shown[] {
  const steps: Shown[] = [];
  for (const { whole, change } of kept) {
    const before = steps.at(-1) ?? null;
    if (whole !== null) steps.push(JSON.parse(whole) as Shown);
    else steps.push(changed(before, JSON.parse(change ?? "null") as Change) as Shown);
  }
  return steps;
}

/** A home as it was left. */
export interface LeftHome {
  readonly head: Head;
  readonly steps: readonly Shown[];
}

/** What a home is called in a list. */
export function titleOf({ scene, file, made }: Shown): string {
  if (file) return file;
  if (!made) return say("a plan of your own");
  const { program } = made;
  const { seed } = scene;
  return typeof program === "string" ? say("{program}, seed {seed}", { program: sayName(program), seed }) : say("seed {seed}", { seed });
}

function sizeOf({ scene }: Shown): string {
  const { size, rooms } = scene;
  const outer = size ? `${sayNumber(size.width, 1, "short")} × ${sayNumber(size.depth, 1, "short")} m, ` : "";
  return outer + (rooms.length === 1 ? say("1 room") : say("{count} rooms", { count: rooms.length }));
}

export class KeptHomes {
  /** Called with the id of a home that undo or redo leads to. */
  onLead: (id: string) => void = () => undefined;
  /** Called when what is kept has changed. */
  onChange: () => void = () => undefined;
  #head: Head | null = null;
  /** The steps that are kept, as they are in the home. */
  #kept: readonly Shown[] = [];
  #restoring = false;
  /** Another window has shown this very home, or forgotten it, and may have changed it since: whatever changes here is of a home of its own. */
  #isShared = false;
  /** Whether what was shown last began a home of its own so. */
  isFork = false;

  /** `tabs` reaches the page's other windows, where there may be some. */
  constructor(readonly home: Home, readonly store: Store, readonly tabs: BroadcastChannel | null = null, readonly now: () => number = Date.now) {
    home.on("shown", (how) => this.#shown(how));
    home.lieBetween(() => this.#beyond());
    tabs?.addEventListener("message", ({ data }) => { if (data === this.#head?.id) this.#isShared = true; });
  }

  /** The id of the home shown. */
  get current(): string | null {
    return this.#head?.id ?? null;
  }

  /** Reads a home; null where it is not kept, or cannot be read any more. */
  async read(id: string): Promise<LeftHome | null> {
    try {
      const kept = await this.store.read(id);
      return kept && kept.head.at < kept.steps.length ? { head: kept.head, steps: stepsOf(kept.steps) } : null;
    } catch {
      return null;
    }
  }

  /** Shows a home as it was left. */
  open(kept: LeftHome): void {
    [this.#head, this.#kept, this.#restoring, this.#isShared] = [kept.head, kept.steps, true, false];
    try {
      this.home.restore(kept.steps, kept.head.at);
    } finally {
      this.#restoring = false;
    }
    this.tabs?.postMessage(kept.head.id);
  }

  /** Shows the home that undo or redo leads to; the one that undo leaves is what redo leads to. */
  follow(kept: LeftHome): void {
    const left = this.#head;
    const isBack = left !== null && left.from === kept.head.id;
    const ahead = isBack ? { at: kept.head.at, home: left.id } : kept.head.ahead;
    if (left?.ahead?.home === kept.head.id && !this.#isShared) this.#write({ ...left, ahead: null }, []);
    this.open({ ...kept, head: { ...kept.head, ahead } });
    if (this.#head && isBack) this.#write(this.#head, []);
  }

  #beyond(): Beyond {
    const { from = null, ahead = null } = this.#head ?? {};
    const lead = (id: string) => () => this.onLead(id);
    return { back: from === null ? null : lead(from), forth: ahead && ahead.at === this.home.at ? lead(ahead.home) : null };
  }

  #shown(how: Showing): void {
    if (how === "live") return;
    this.isFork = false;
    if (this.#restoring) return;
    const steps = this.home.steps;
    const isSame = how === "new" && this.#isSame(steps);
    if (how === "new" && !isSame) this.#begin(steps);
    else this.#go(steps, isSame);
  }

  /** Whether a home made is the one that is shown already, never edited. */
  #isSame(steps: readonly Shown[]): boolean {
    const [before, ...more] = this.#kept;
    return this.#head !== null && more.length === 0 && before !== undefined && JSON.stringify(asMade(before)) === JSON.stringify(asMade(steps[0] as Shown));
  }

  #begin(steps: readonly Shown[]): void {
    const first = steps[0] as Shown;
    const from = this.#head?.id ?? null;
    this.#isShared = false;
    this.#keep({ id: freshId(), from, ahead: null, count: 0, at: 0, ...this.#facts(first) }, steps, 0);
    void this.#prune();
  }

  /** Keeps the steps that are not kept yet, and which one is shown. */
  #go(steps: readonly Shown[], isSame: boolean): void {
    if (!this.#head) return;
    const other = steps.findIndex((step, i) => step !== this.#kept[i]);
    const from = other < 0 ? steps.length : other;
    const ahead = from < steps.length && !isSame ? null : this.#head.ahead;
    const shown = steps[this.home.at] as Shown;
    const [id, first] = this.#isShared ? [freshId(), 0] : [this.#head.id, from];
    [this.isFork, this.#isShared] = [this.#isShared, false];
    this.#keep({ ...this.#head, id, ahead, ...this.#facts(shown) }, steps, first);
  }

  #facts(shown: Shown): Pick<Head, "touched" | "title" | "size" | "query"> {
    return { touched: this.now(), title: titleOf(shown), size: sizeOf(shown), query: shown.made ? queryFromRequest(shown.made) : null };
  }

  #keep(head: Head, steps: readonly Shown[], from: number): void {
    this.#head = { ...head, count: steps.length, at: this.home.at };
    this.#kept = steps;
    this.#write(this.#head, steps.slice(from).map((step, i) => keptStep(head.id, from + i, step, steps[from + i - 1] ?? null)));
  }

  #write(head: Head, steps: readonly KeptStep[]): void {
    this.store.write(head, steps);
    this.onChange();
  }

  /** Forgets the oldest of the homes that were never edited, where there are many. */
  async #prune(): Promise<void> {
    const plain = (await this.store.heads()).filter(({ count, id }) => count === 1 && id !== this.#head?.id);
    if (plain.length > MOST_PLAIN) await this.forget(new Set(plain.slice(MOST_PLAIN).map(({ id }) => id)));
  }

  /** Forgets homes but for the one shown. */
  async forget(ids: ReadonlySet<string>): Promise<void> {
    const others = new Set([...ids].filter((id) => id !== this.#head?.id));
    await this.store.forget(others);
    for (const id of others) this.tabs?.postMessage(id);
    const own = this.#head && (await this.store.heads()).find(({ id }) => id === this.#head?.id);
    if (this.#head && own) this.#head = { ...this.#head, from: own.from, ahead: own.ahead };
    this.home.lieBetween(() => this.#beyond());
    this.onChange();
  }
}

/** An id that no other home has. */
function freshId(): string {
  return [...crypto.getRandomValues(new Uint32Array(3))].map((part) => part.toString(36)).join("");
}

/** A home without how long it took. */
function asMade({ scene, issues, made, file }: Shown): unknown {
  return [scene, issues, made ?? null, file ?? null];
}
