/** All kinds of furniture the service knows, to search and to choose from. */
import type { Catalog } from "../contract";
import { words } from "../house/frame";
import type { FurnitureKind } from "./scene_edits";

interface Entry {
  readonly kind: FurnitureKind;
  readonly text: string;
  readonly button: HTMLButtonElement;
}

/** The catalog's kinds as pieces of a scene call them. */
export function kindsOf(catalog: Catalog): { readonly key: string; readonly kind: FurnitureKind }[] {
  return Object.entries(catalog.furniture).map(([key, { name, category, size, color }]) => ({
    key, kind: { name: name ?? key, category: category ?? "", size, color: color ?? null },
  })).sort((a, b) => a.key.localeCompare(b.key));
}

export class Palette {
  onChoose: (kind: FurnitureKind) => void = () => undefined;
  readonly #search = document.createElement("input");
  readonly #list = document.createElement("ul");
  readonly #nothing = document.createElement("p");
  #entries: Entry[] = [];

  constructor(readonly host: HTMLElement) {
    const label = document.createElement("label");
    label.textContent = "Add a piece";
    label.htmlFor = "palette_search";
    this.#search.id = "palette_search";
    this.#search.type = "search";
    this.#search.placeholder = "sofa, lamp, desk…";
    this.#search.addEventListener("input", () => this.#filter());
    this.#search.addEventListener("keydown", (event) => this.#enter(event));
    this.#nothing.textContent = "No such kind.";
    this.#nothing.className = "hint";
    host.replaceChildren(label, this.#search, this.#list, this.#nothing);
    host.addEventListener("keydown", (event) => { if (event.key === "Escape") this.open(false); });
  }

  fill(catalog: Catalog): void {
    this.#entries = kindsOf(catalog).map(({ key, kind }) => this.#entry(key, kind));
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

  open(isOpen: boolean): void {
    this.host.hidden = !isOpen;
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
    return { kind, button, text: `${words(key)} ${kind.category}`.toLowerCase() };
  }

  #filter(): void {
    const wanted = this.#search.value.trim().toLowerCase().replaceAll("_", " ");
    for (const { text, button } of this.#entries) if (button.parentElement) button.parentElement.hidden = !text.includes(wanted);
    this.#nothing.hidden = this.#shown().length > 0;
  }

  #shown(): Entry[] {
    return this.#entries.filter(({ button }) => !button.parentElement?.hidden);
  }

  /** Enter takes the first that is found. */
  #enter(event: KeyboardEvent): void {
    const [first] = this.#shown();
    if (event.key === "Enter" && first) this.onChoose(first.kind);
  }
}
