/** All kinds of furniture the service knows, to search and to choose from. */
import type { Catalog } from "../contract";
import { words } from "../house/frame";
import type { FurnitureKind } from "./scene_edits";

interface Entry {
  readonly kind: FurnitureKind;
  readonly text: string;
  readonly button: HTMLButtonElement;
}

const LOADING = "Loading…";
const NOT_LOADED = "The kinds could not be loaded.";
const NONE = "No such kind.";
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

export class Palette {
  onChoose: (kind: FurnitureKind) => void = () => undefined;
  readonly #search = document.createElement("input");
  readonly #list = document.createElement("ul");
  readonly #nothing = document.createElement("p");
  #entries: Entry[] = [];
  /** What had the focus before. */
  #before: Element | null = null;

  constructor(readonly host: HTMLElement) {
    const label = document.createElement("label");
    label.textContent = "Add a piece";
    label.htmlFor = "palette_search";
    this.#search.id = "palette_search";
    this.#search.type = "search";
    this.#search.placeholder = "sofa, lamp, desk…";
    this.#search.addEventListener("input", () => this.#filter());
    this.#search.addEventListener("keydown", (event) => this.#enter(event));
    this.#nothing.textContent = LOADING;
    this.#nothing.className = "hint";
    host.replaceChildren(this.#head(label), this.#search, this.#list, this.#nothing);
    host.addEventListener("keydown", (event) => this.#escape(event));
  }

  #head(label: HTMLElement): HTMLElement {
    const [head, close] = [document.createElement("div"), document.createElement("button")];
    head.className = "palette-head";
    close.type = "button";
    close.textContent = "✕";
    close.setAttribute("aria-label", "Close");
    close.addEventListener("click", () => this.open(false));
    head.append(label, close);
    return head;
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
    this.#nothing.textContent = NONE;
    this.#entries = [...ownKindsOf(catalog), ...kindsOf(catalog)].map(({ key, kind }) => this.#entry(key, kind));
    this.#list.replaceChildren(...this.#entries.map(({ button }) => {
      const item = document.createElement("li");
      item.append(button);
      return item;
    }));
    this.#filter();
  }

  get isOpen(): boolean {
    return !this.host.hidden;
  }

  /** Opens or closes; closed, the focus goes back to where it was. */
  open(isOpen: boolean): void {
    const held = this.host.contains(document.activeElement);
    if (isOpen && !held) this.#before = document.activeElement;
    this.host.hidden = !isOpen;
    if (!isOpen && held && this.#before instanceof HTMLElement) this.#before.focus();
    if (!isOpen) return;
    this.#search.value = "";
    this.#filter();
    this.#search.focus();
  }

  #entry(key: string, kind: FurnitureKind): Entry {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.kind = key;
    const size = document.createElement("small");
    size.textContent = `${kind.size.map((metres) => metres.toFixed(2)).join(" × ")} m`;
    button.append(words(key), " ", size);
    button.addEventListener("click", () => this.onChoose(kind));
    return { kind, button, text: `${words(key)} ${words(kind.name)} ${kind.category}`.toLowerCase() };
  }

  #filter(): void {
    const wanted = this.#search.value.trim().toLowerCase().replaceAll("_", " ");
    for (const { text, button } of this.#entries) if (button.parentElement) button.parentElement.hidden = !text.includes(wanted);
    this.#nothing.hidden = this.#shown().length > 0;
  }

  #shown(): Entry[] {
    return this.#entries.filter(({ button }) => !button.parentElement?.hidden);
  }

  #escape(event: KeyboardEvent): void {
    if (event.key !== "Escape") return;
    event.stopPropagation();
    this.open(false);
  }

  /** Enter takes the first that is found. */
  #enter(event: KeyboardEvent): void {
    const [first] = this.#shown();
    if (event.key === "Enter" && first) this.onChoose(first.kind);
  }
}
