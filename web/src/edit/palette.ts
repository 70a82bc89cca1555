/** All kinds of furniture the service knows, to search and to choose from. */
import type { Catalog } from "../contract";
import { words } from "../house/frame";
import { button, made } from "../made";
import { putAway } from "../panel/focus";
import type { Favourites } from "./favourites";
import { LONG_PRESS } from "../view/pointer";
import type { FurnitureKind } from "./scene_edits";
import { capital, say, sayNumber } from "../words/language";

interface Entry {
  readonly key: string;
  readonly kind: FurnitureKind;
  readonly text: string;
  /** What others call it, in letters without marks. */
  readonly known: readonly string[];
  readonly item: HTMLElement;
  readonly picture: HTMLCanvasElement;
}

/** What the palette needs of others: favourites that are kept, pictures, and where a kind is dragged. */
export interface PaletteWords {
  readonly favourites: Pick<Favourites, "has" | "toggle">;
  /** Draws a kind's picture, once it is seen. */
  portray(kind: FurnitureKind, into: HTMLCanvasElement): void;
  /** A kind is dragged over a point of the window; null: it is not any more. */
  over(kind: FurnitureKind, at: { readonly x: number; readonly y: number } | null): void;
  drop(kind: FurnitureKind, at: { readonly x: number; readonly y: number }): void;
}

const ALL = "all";
const LIKED = "favourites";
/** A picture's size [pixels]. */
const PICTURE = { width: 96, height: 72 } as const;
/** Further than this [CSS pixels] a press on a kind drags it. */
const STILL = 6;
const LOADING = say("Loading…");
const NOT_LOADED = say("The kinds could not be loaded.");
const NONE = say("No such kind.");
const NONE_LIKED = say("Nothing is starred yet: the ★ at a kind puts it here.");
/** What lives in a house is no piece of furniture. */
const LIVING = "dynamic";

/** The user's own assets that stand for furniture: pieces of the asset's size, of the kind that is nearest to it in size. */
export function ownKindsOf({ furniture, assets = {} }: Catalog): { readonly key: string; readonly kind: FurnitureKind }[] {
  return Object.entries(assets).flatMap(([asset, { kinds, size }]) => {
    const known = Object.entries(furniture).filter(([key, { name }]) => kinds.includes(key) || kinds.includes(name ?? key));
    const off = (other: readonly number[]): number => size.reduce((sum, extent, i) => sum + Math.abs(extent - (other[i] ?? 0)), 0);
    const [nearest] = known.sort(([, a], [, b]) => off(a.size) - off(b.size));
    if (!nearest) return [];
    const [key, { name, category, color }] = nearest;
    const [width, depth, height] = size.map((extent) => Math.round(extent * 1000) / 1000) as [number, number, number];
    return [{ key: asset, kind: { key, name: name ?? key, category: category ?? "", size: [width, depth, height], color: color ?? null, asset } }];
  });
}

/** The catalog's kinds of furniture as pieces of a scene call them. */
export function kindsOf(catalog: Catalog): { readonly key: string; readonly kind: FurnitureKind }[] {
  const furniture = Object.entries(catalog.furniture).filter(([, { category }]) => category !== LIVING);
  return furniture.map(([key, { name, category, size, color }]) => ({
    key, kind: { key, name: name ?? key, category: category ?? "", size, color: color ?? null },
  })).sort((a, b) => a.key.localeCompare(b.key));
}

/** Letters without marks, as the catalog has what others call a kind. */
function plain(written: string): string {
  return written.normalize("NFD").replace(/\p{M}/gu, "");
}

/** Nothing beside the kinds. */
const ALONE: PaletteWords = { favourites: { has: () => false, toggle: () => undefined }, portray: () => undefined, over: () => undefined, drop: () => undefined };

export class Palette {
  onChoose: (kind: FurnitureKind) => void = () => undefined;
  readonly #search = made("input", { id: "palette_search", type: "search", placeholder: say("sofa, lamp, desk…") });
  readonly #categories = made("div", { className: "palette-categories", role: "group", "aria-label": say("Categories") });
  readonly #list = made("ul");
  readonly #nothing = made("p", { className: "hint" }, LOADING);
  /** Pictures are drawn of what has come into view. */
  readonly #seen: IntersectionObserver | null;
  #entries: Entry[] = [];
  /** Those as they are listed. */
  #ranked: readonly Entry[] = [];
  #category = ALL;
  /** What had the focus before. */
  #before: Element | null = null;

  constructor(readonly host: HTMLElement, readonly others: PaletteWords = ALONE) {
    const label = made("label", { htmlFor: "palette_search" }, say("Add a piece"));
    this.#search.addEventListener("input", () => this.#filter());
    this.#search.addEventListener("keydown", (event) => this.#enter(event));
    this.#categories.addEventListener("keydown", (event) => this.#walk(event));
    this.#seen = typeof IntersectionObserver === "undefined" ? null : new IntersectionObserver((all) => this.#portray(all), { root: host, rootMargin: "80px" });
    host.replaceChildren(this.#head(label), this.#search, this.#categories, this.#list, this.#nothing);
    host.addEventListener("keydown", (event) => this.#escape(event));
  }

  #head(label: HTMLElement): HTMLElement {
    return made("div", { className: "palette-head" }, label, button("✕", () => this.open(false), { "aria-label": say("Close") }));
  }

  /** Offers the kinds of a catalog that is on its way, and says so meanwhile. */
  async await(coming: Promise<Catalog>): Promise<void> {
    this.#nothing.textContent = LOADING;
    try {
      this.#fill(await coming);
    } catch (reason) {
      this.#nothing.textContent = NOT_LOADED;
      throw reason;
    }
  }

  #fill(catalog: Catalog): void {
    this.#entries = [...ownKindsOf(catalog), ...kindsOf(catalog)].map(({ key, kind }) => this.#entry(key, kind, catalog.synonyms?.[kind.key]?.known_as));
    this.#list.replaceChildren();
    const categories = [...new Set(this.#entries.map(({ kind }) => kind.category).filter((category) => category !== ""))].sort();
    this.#categories.replaceChildren(...[ALL, LIKED, ...categories].map((category) => this.#chip(category)));
    for (const { picture } of this.#entries) this.#seen?.observe(picture);
    this.#filter();
  }

  #chip(category: string): HTMLElement {
    return button(capital(words(category)), () => {
      this.#category = category;
      this.#filter();
    }, { "data-category": category });
  }

  get isOpen(): boolean {
    return !this.host.hidden;
  }

  /** Opens or closes; closed, the focus goes back to where it was, or to the house. */
  open(isOpen: boolean): void {
    const held = this.host.contains(document.activeElement);
    if (!isOpen) {
      putAway(this.host);
      if (held && this.#before instanceof HTMLElement && this.#before !== document.body) this.#before.focus();
      return;
    }
    if (!held) this.#before = document.activeElement;
    this.host.hidden = false;
    this.#search.value = "";
    this.#category = ALL;
    this.#filter();
    this.#search.focus();
  }

  #entry(key: string, kind: FurnitureKind, known: readonly string[] = []): Entry {
    const picture = made("canvas", { ...PICTURE, "aria-hidden": true });
    const size = made("small", {}, `${kind.size.map((metres) => sayNumber(metres * 100, 0)).join("×")} cm`);
    const choose = made("button", { type: "button", "data-kind": key }, picture, capital(words(key)), " ", size);
    this.#listen(choose, kind);
    const item = made("li", {}, choose, this.#star(key));
    return { key, kind, item, picture, known, text: `${words(key)} ${words(kind.name)} ${kind.category}`.toLowerCase() };
  }

  #star(key: string): HTMLElement {
    const star = button("★", () => {
      this.others.favourites.toggle(key);
      star.setAttribute("aria-pressed", String(this.others.favourites.has(key)));
    }, { className: "star", "aria-label": say("Favourite: {piece}", { piece: words(key) }), "aria-pressed": this.others.favourites.has(key) });
    return star;
  }

  /** A click chooses the kind; pulled out with a mouse, or once a finger has stayed on it, it is dragged into the house. */
  #listen(choose: HTMLElement, kind: FurnitureKind): void {
    let from: PointerEvent | null = null;
    let isDragged = false;
    let staying: ReturnType<typeof setTimeout> | undefined;
    const at = (event: PointerEvent): { x: number; y: number } => ({ x: event.clientX, y: event.clientY });
    const begin = (event: PointerEvent): void => {
      isDragged = true;
      this.host.classList.add("aside");
      this.others.over(kind, at(event));
    };
    const end = (): void => {
      clearTimeout(staying);
      this.host.classList.remove("aside");
      from = null;
    };
    choose.addEventListener("click", () => {
      if (!isDragged) this.onChoose(kind);
      isDragged = false;
    });
    choose.addEventListener("pointerdown", (event) => {
      isDragged = false;
      from = event.button === 0 ? event : null;
      choose.setPointerCapture(event.pointerId); // a quick mouse has left the kind by its first move
      if (event.pointerType === "touch") staying = setTimeout(() => begin(event), LONG_PRESS);
    });
    choose.addEventListener("pointermove", (event) => {
      if (!from || (!isDragged && Math.hypot(event.clientX - from.clientX, event.clientY - from.clientY) <= STILL)) return;
      if (isDragged) this.others.over(kind, at(event));
      else if (event.pointerType === "touch") end(); // it scrolls the list
      else begin(event);
    });
    choose.addEventListener("touchmove", (event) => { if (isDragged) event.preventDefault(); }, { passive: false });
    choose.addEventListener("pointerup", (event) => {
      if (from && isDragged && this.isOpen) this.others.drop(kind, at(event));
      else if (from && isDragged) this.others.over(kind, null);
      end();
    });
    choose.addEventListener("pointercancel", () => {
      end();
      this.others.over(kind, null);
    });
  }

  /** Has each picture drawn again once it is seen: kinds look otherwise. */
  portrayAnew(): void {
    for (const { picture } of this.#entries) {
      this.#seen?.unobserve(picture);
      this.#seen?.observe(picture);
    }
  }

  #portray(all: readonly IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of all) {
      const entry = isIntersecting ? this.#entries.find(({ picture }) => picture === target) : undefined;
      if (!entry) continue;
      this.#seen?.unobserve(target);
      this.others.portray(entry.kind, entry.picture);
    }
  }

  #filter(): void {
    const wanted = this.#search.value.trim().toLowerCase().replaceAll("_", " ");
    const isOf = ({ key, kind }: Entry): boolean => this.#category === ALL || kind.category === this.#category || (this.#category === LIKED && this.others.favourites.has(key));
    const found = this.#entries.filter((entry) => entry.text.includes(wanted) && isOf(entry));
    const isOffered = new Set(found.length > 0 ? found : this.#entries.filter((entry) => isOf(entry) && entry.known.some((word) => word.startsWith(plain(wanted)))));
    for (const entry of this.#entries) entry.item.hidden = !isOffered.has(entry);
    // what is called just so comes first, then what begins so: Enter takes the first
    const off = ({ key, known }: Entry): number => {
      const called = found.length > 0 ? [words(key).toLowerCase()] : known;
      return called.includes(wanted) || called.includes(plain(wanted)) ? 0 : called.some((word) => word.startsWith(wanted)) ? 1 : 2;
    };
    this.#ranked = [...this.#entries].sort((one, other) => off(one) - off(other));
    this.#list.append(...this.#ranked.map(({ item }) => item));
    for (const chip of this.#chips) {
      chip.setAttribute("aria-pressed", String(chip.dataset.category === this.#category));
      chip.tabIndex = chip.dataset.category === this.#category ? 0 : -1;
    }
    this.#nothing.hidden = this.#shown().length > 0;
    if (this.#entries.length > 0) this.#nothing.textContent = this.#category === LIKED && wanted === "" ? NONE_LIKED : NONE;
  }

  get #chips(): HTMLElement[] {
    return [...this.#categories.querySelectorAll<HTMLElement>("button")];
  }

  /** Categories are one stop of the Tab key; arrows go from one to the next. */
  #walk(event: KeyboardEvent): void {
    const chips = this.#chips;
    const at = chips.indexOf(document.activeElement as HTMLElement);
    const to = { ArrowRight: at + 1, ArrowLeft: at - 1, Home: 0, End: -1 }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation(); // it moves no piece
    chips.at(to % chips.length)?.focus();
  }

  #shown(): Entry[] {
    return this.#ranked.filter(({ item }) => !item.hidden);
  }

  #escape(event: KeyboardEvent): void {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    this.open(false);
  }

  /** Enter takes the first that is found. */
  #enter(event: KeyboardEvent): void {
    const [first] = this.#shown();
    if (event.key !== "Enter" || !first) return;
    event.preventDefault(); // or it would press the button that the focus goes back to
    this.onChoose(first.kind);
  }
}
