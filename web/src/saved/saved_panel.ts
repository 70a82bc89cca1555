/** The homes that the service keeps: saved, found, opened, renamed, tagged, removed, and two of them side by side. All names are texts. */
import type { Scene } from "../contract";
import { copy } from "../panel/link";
import { ServiceProblem } from "../service";
import { changeSaved, listSaved, pictureSaved, readSaved, removeSaved, saveNew, savedPicture, type SavedHead, type SavedTexts } from "./saved_calls";
import { Comparison } from "./saved_comparison";
import { say, type Words } from "../words/language";

export interface SavedSource {
  scene(): Scene | null;
  picture(): Promise<string | null>;
}

function button(words: string, act: () => void): HTMLButtonElement {
  const made = Object.assign(document.createElement("button"), { type: "button", textContent: words });
  made.addEventListener("click", act);
  return made;
}

function field(label: string): HTMLInputElement {
  const made = Object.assign(document.createElement("input"), { type: "text", placeholder: label, maxLength: 200 });
  made.setAttribute("aria-label", label);
  return made;
}

/** Tags as they are typed, with commas between. */
export function tagsIn(text: string): string[] {
  return [...new Set(text.split(",").map((tag) => tag.trim()).filter((tag) => tag !== ""))];
}

export class SavedPanel {
  /** Called with a home that is to be shown. */
  onOpen: (name: string, scene: Scene) => void = () => undefined;
  /** Called with what went wrong. */
  onFailure: (reason: unknown) => void = () => undefined;
  readonly #name = field(say("Name to save as"));
  readonly #tags = field(say("Tags, with commas between"));
  readonly #search = field(say("Search saved homes"));
  readonly #update = button(say("Save changes"), () => void this.#try(() => this.#saveChanges()));
  readonly #said = Object.assign(document.createElement("p"), { className: "hint", role: "status" });
  readonly #list = Object.assign(document.createElement("ul"), { className: "saved-list" });
  readonly #more = button(say("More"), () => void this.#try(() => this.#show(true)));
  readonly #comparison = new Comparison();
  #heads: SavedHead[] = [];
  #after: string | null = null;
  #opened: SavedHead | null = null;
  #asked = new AbortController();
  #pictures: string[] = [];
  #isOpening = false;

  constructor(readonly host: HTMLDetailsElement, readonly source: SavedSource) {
    const save = button(say("Save this home"), () => void this.#try(() => this.#save()));
    for (const one of [save, this.#update, this.#more]) one.classList.add("wide");
    const buttons = document.createElement("div");
    buttons.className = "buttons";
    buttons.append(save, this.#update);
    host.append(this.#name, this.#tags, buttons, this.#said, this.#search, this.#list, this.#more);
    this.#update.hidden = this.#more.hidden = true;
    host.addEventListener("toggle", () => { if (host.open) void this.#try(() => this.#show(false)); });
    this.#search.addEventListener("input", () => void this.#try(() => this.#show(false)));
  }

  /** Opens a home by its id, as a link names it. */
  open(id: string): Promise<void> {
    return this.#try(async () => {
      const { head, scene } = await readSaved(id);
      this.#hold(head);
      this.#isOpening = true;
      this.onOpen(head.name, scene);
    });
  }

  /** Another home is shown: changes are no longer those of the one that was opened, unless it is just being opened. */
  shows(): void {
    if (!this.#isOpening) this.#hold(null);
    this.#isOpening = false;
  }

  #hold(head: SavedHead | null): void {
    this.#opened = head;
    this.#update.hidden = head === null;
    if (!head) return;
    this.#update.textContent = say("Save changes to “{home}”", { home: head.name });
    this.#name.value = head.name;
    this.#tags.value = head.tags.join(", ");
  }

  async #save(): Promise<void> {
    const scene = this.source.scene();
    if (!scene) return;
    const head = await saveNew({ ...this.#texts(), scene });
    await this.#saved(head, "Saved “{home}”.");
  }

  async #saveChanges(): Promise<void> {
    const [scene, before] = [this.source.scene(), this.#opened];
    if (!scene || !before) return;
    await this.#saved(await changeSaved(before.id, before.revision, { ...this.#texts(), scene }), "Saved the changes of “{home}”.");
  }

  #texts(): SavedTexts {
    const [name, tags] = [this.#name.value.trim(), tagsIn(this.#tags.value)];
    return { ...(name ? { name } : {}), tags };
  }

  async #saved(head: SavedHead, did: Words): Promise<void> {
    this.#hold(head);
    const picture = await this.source.picture();
    if (picture) await pictureSaved(head.id, picture);
    await this.#show(false);
    this.#said.textContent = say(did, { home: head.name });
  }

  /** Does something; a home that somebody else has changed is said here, all else where refusals are shown. */
  async #try(act: () => Promise<void>): Promise<void> {
    this.#said.textContent = "";
    try {
      await act();
    } catch (reason) {
      if (reason instanceof DOMException && reason.name === "AbortError") return;
      if (!(reason instanceof ServiceProblem && reason.status === 412)) return this.onFailure(reason);
      this.#said.textContent = say("Somebody has changed this home since you opened it: open it again, or save yours as another.");
    }
  }

  async #show(isMore: boolean): Promise<void> {
    this.#asked.abort();
    this.#asked = new AbortController();
    const found = await listSaved(this.#search.value.trim(), isMore ? this.#after : null, this.#asked.signal);
    this.#heads = isMore ? [...this.#heads, ...found.homes] : [...found.homes];
    this.#after = found.after;
    this.#more.hidden = found.after === null;
    for (const url of this.#pictures.splice(0)) URL.revokeObjectURL(url);
    this.#list.replaceChildren(...this.#heads.map((head) => this.#item(head)));
    if (this.#heads.length === 0) this.#said.textContent = say("No home is saved here yet.");
  }

  #item(head: SavedHead): HTMLElement {
    const item = document.createElement("li");
    item.dataset.saved = head.id;
    const image = Object.assign(document.createElement("img"), { alt: "", width: 72, height: 45 });
    void savedPicture(head.id).then((url) => { this.#pictures.push(url); image.src = url; }, () => undefined);
    const words = document.createElement("span");
    const title = Object.assign(document.createElement("b"), { textContent: head.name });
    const more = [say("{count} rooms", { count: head.rooms }), say("version {version}", { version: head.version }), ...head.tags].join(", ");
    words.append(title, Object.assign(document.createElement("small"), { textContent: more }));
    const acts = document.createElement("div");
    acts.append(
      button(say("Open"), () => void this.open(head.id)),
      button(say("Copy link"), () => void this.#try(() => this.#copyLink(head))),
      button(say("Rename"), () => this.#edit(item, head, "name")),
      button(say("Tag"), () => this.#edit(item, head, "tags")),
      button(say("Compare"), () => void this.#try(() => this.#comparison.add(head))),
      button(say("Remove"), () => void this.#try(() => this.#remove(head))),
    );
    for (const one of acts.querySelectorAll("button")) one.setAttribute("aria-label", `${one.textContent} ${head.name}`);
    item.append(image, words, acts);
    return item;
  }

  /** Lets the name or the tags of a home be typed, in place of its buttons. */
  #edit(item: HTMLElement, head: SavedHead, what: "name" | "tags"): void {
    const typed = field(what === "name" ? say("New name of {home}", { home: head.name }) : say("Tags of {home}", { home: head.name }));
    typed.value = what === "name" ? head.name : head.tags.join(", ");
    typed.addEventListener("keydown", (event) => {
      if (event.key === "Escape") void this.#try(() => this.#show(false));
      if (event.key === "Enter") void this.#try(() => this.#change(head, what === "name" ? { name: typed.value.trim() } : { tags: tagsIn(typed.value) }));
    });
    item.querySelector("div")?.replaceWith(typed);
    typed.select();
  }

  async #copyLink({ id }: SavedHead): Promise<void> {
    const link = new URL(`?home=${encodeURIComponent(id)}`, location.href.replace(/[?#].*/, "")).href;
    this.#said.textContent = (await copy(link)) ? say("Link copied: it opens this home as it is saved.") : say("Copy this link: {link}", { link });
  }

  async #change(head: SavedHead, texts: SavedTexts): Promise<void> {
    const changed = await changeSaved(head.id, head.revision, texts);
    if (this.#opened?.id === head.id) this.#hold(changed);
    await this.#show(false);
  }

  async #remove(head: SavedHead): Promise<void> {
    await removeSaved(head.id, head.revision);
    if (this.#opened?.id === head.id) this.#hold(null);
    await this.#show(false);
    this.#said.textContent = say("Removed “{home}”.", { home: head.name });
  }
}
