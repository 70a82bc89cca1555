/** The homes that the browser keeps: each with its picture, opened as it was left; and forgotten, where that is wished. */
import type { Head } from "../memory/store";
import { button, made } from "../made";
import { say } from "../words/language";
import { replaceKeepingFocus } from "./focus";

const MOST_SHOWN = 24;
const MINUTE = 60_000;

/** How long ago, in words. */
export function agoWords(ms: number): string {
  const minutes = Math.floor(ms / MINUTE);
  if (minutes < 1) return say("just now");
  const [hours, days] = [Math.floor(minutes / 60), Math.floor(minutes / 1440)];
  if (hours < 1) return minutes === 1 ? say("1 minute ago") : say("{count} minutes ago", { count: minutes });
  if (days < 1) return hours === 1 ? say("1 hour ago") : say("{count} hours ago", { count: hours });
  return days === 1 ? say("1 day ago") : say("{count} days ago", { count: days });
}

/** How far a home was edited, in words. */
export function changesWords({ count }: Head): string {
  if (count === 1) return say("as it was made");
  return count === 2 ? say("1 change") : say("{count} changes", { count: count - 1 });
}

/** The homes worth listing: of those never edited that one address makes, the newest. */
export function listed(heads: readonly Head[], current: string | null): Head[] {
  const seen = new Set<string>();
  const isNew = ({ count, query, id }: Head): boolean => {
    if (count > 1 || query === null || id === current) return true;
    if (seen.has(query)) return false;
    seen.add(query);
    return true;
  };
  return heads.filter(isNew).slice(0, MOST_SHOWN);
}

export interface RecentSource {
  heads(): Promise<readonly Head[]>;
  picture(id: string): Promise<string | null>;
  current(): string | null;
}

export class Recent {
  onOpen: (id: string) => void = () => undefined;
  onForget: (ids: ReadonlySet<string>) => void = () => undefined;
  readonly #list: HTMLElement;
  readonly #said: HTMLElement;
  readonly #clear: HTMLButtonElement;
  #isStale = true;
  #isAsked = false;
  #heads: readonly Head[] = [];

  constructor(readonly host: HTMLDetailsElement, readonly source: RecentSource, readonly now: () => number = Date.now) {
    this.#list = host.querySelector("#recent_list") as HTMLElement;
    this.#said = host.querySelector("#recent_said") as HTMLElement;
    this.#clear = host.querySelector("#recent_clear") as HTMLButtonElement;
    host.addEventListener("toggle", () => this.#refresh());
    this.#clear.addEventListener("click", () => this.#forgetAll());
    this.#clear.addEventListener("blur", () => this.#ask(false));
  }

  /** What is kept has changed; it is read when it is looked at. */
  changed(): void {
    this.#isStale = true;
    this.#refresh();
  }

  /** The browser keeps nothing beyond this page. */
  sayLost(): void {
    this.#said.textContent = say("This browser keeps no homes beyond this page, or is full: what you change here is lost when you leave. Save it as a file.");
  }

  /** Forgets all but the home shown, once that is said twice. */
  #forgetAll(): void {
    if (this.#isAsked) this.onForget(new Set(this.#heads.map(({ id }) => id)));
    this.#ask(!this.#isAsked);
  }

  #ask(isAsked: boolean): void {
    this.#isAsked = isAsked;
    this.#clear.textContent = isAsked ? say("Really forget {count}?", { count: this.#heads.length - 1 }) : say("Forget all but this one");
  }

  #refresh(): void {
    if (!this.host.open || !this.#isStale) return;
    this.#isStale = false;
    void this.#show();
  }

  async #show(): Promise<void> {
    const heads = await this.source.heads();
    const current = this.source.current();
    const shown = listed(heads, current);
    const pictures = await Promise.all(shown.map(({ id }) => this.source.picture(id)));
    this.#heads = heads;
    this.#clear.disabled = heads.length < 2;
    replaceKeepingFocus(this.#list, shown.map((head, i) => this.#item(head, pictures[i] ?? null, head.id === current)));
  }

  #item(head: Head, picture: string | null, isCurrent: boolean): HTMLElement {
    const open = button("", () => this.onOpen(head.id), { className: "recent-home", "data-home": head.id, ...(isCurrent ? { "aria-current": true } : {}) });
    const image = made("img", { alt: "", width: 72, height: 45, ...(picture ? { src: picture } : {}) });
    const more = made("small", {}, `${head.size}, ${changesWords(head)}, ${agoWords(this.now() - head.touched)}`);
    open.append(image, made("span", {}, made("b", {}, head.title), more));
    const forget = button("✕", () => this.onForget(new Set([head.id])), {
      className: "recent-forget", disabled: isCurrent, "aria-label": say("Forget {home}", { home: head.title }),
    });
    return made("li", {}, open, forget);
  }
}
