/** The homes that the service keeps: saved, found, opened, renamed, tagged, removed, and two of them side by side. All names are texts. */
import type { Beside } from "../asking";
import { titleOf } from "../memory/kept_homes";
import { button, made } from "../made";
import { Newest } from "../newest";
import { copy } from "../panel/link";
import { isAbort, ServiceProblem } from "../service";
import type { Shown } from "../state/home";
import { changeSaved, listSaved, pictureSaved, removeSaved, saveNew, savedPicture, type SavedHead, type SavedTexts } from "./saved_calls";
import { Comparison } from "./saved_comparison";
import { say, type Words } from "../words/language";

export interface SavedSource {
  /** The home shown, once the edits that are under way have landed. */
  shown(): Promise<Shown | null>;
  picture(): Promise<string | null>;
}

/** What others did meanwhile, by the status of the refusal. */
const OF_OTHERS: Readonly<Record<number, string>> = {
  404: say("Somebody has removed this home since: yours can be saved as another."),
  412: say("Somebody has changed this home since you opened it: open it again, or save yours as another."),
};

/** A button that asks once more, until it loses the focus, before it acts. */
function sureButton(words: string, sure: string, of: string, act: () => void): HTMLButtonElement {
  const say = (told: string): void => { asks.textContent = told; asks.setAttribute("aria-label", `${told} ${of}`); };
  const asks = button(words, () => { if (asks.textContent === sure) act(); else say(sure); });
  asks.addEventListener("blur", () => { say(words); });
  return asks;
}

function field(label: string): HTMLInputElement {
  return made("input", { type: "text", placeholder: label, maxLength: 200, "aria-label": label });
}

/** Tags as they are typed, with commas between. */
export function tagsIn(text: string): string[] {
  return [...new Set(text.split(",").map((tag) => tag.trim()).filter((tag) => tag !== ""))];
}

export class SavedPanel {
  /** Called with the id of a home that is to be shown. */
  onOpen: (id: string) => void = () => undefined;
  /** Called with why homes are not listed, and with what tries again. */
  onFailure: (reason: unknown, again: () => void) => void = () => undefined;
  readonly #name = field(say("Name to save as"));
  readonly #tags = field(say("Tags, with commas"));
  readonly #search = field(say("Search saved homes"));
  readonly #update = button(say("Save changes"), () => this.#try(say("Saving the home"), () => this.#saveChanges()));
  readonly #said = made("p", { className: "hint", role: "status" });
  readonly #list = made("ul", { className: "saved-list" });
  readonly #more = button(say("More"), () => this.#look(true));
  readonly #comparison = new Comparison();
  #heads: SavedHead[] = [];
  #after: string | null = null;
  #opened: SavedHead | null = null;
  /** How many homes were shown: one that is saved may be no longer shown when the answer comes. */
  #homes = 0;
  readonly #asked = new Newest();
  #pictures: string[] = [];

  constructor(readonly host: HTMLDetailsElement, readonly source: SavedSource, readonly beside: Beside) {
    this.#name.id = "saved_name";
    const save = button(say("Save this home"), () => this.#try(say("Saving the home"), () => this.#save()));
    for (const one of [this.#name, this.#tags]) one.addEventListener("keydown", ({ key }) => { if (key === "Enter") (this.#opened?.name === this.#name.value.trim() ? this.#update : save).click(); });
    for (const one of [save, this.#update, this.#more]) one.classList.add("wide");
    host.append(this.#name, this.#tags, made("div", { className: "buttons" }, save, this.#update), this.#said, this.#search, this.#list, this.#more);
    this.#update.hidden = this.#more.hidden = true;
    host.addEventListener("toggle", () => { if (host.open) this.#look(false); });
    this.#search.addEventListener("input", () => this.#look(false));
  }

  /** A home is shown: this one of those that are kept, null for any other, whose changes are none of the one before. */
  holds(head: SavedHead | null): void {
    this.#homes += 1;
    if (head === null && this.#opened === null) return; // what was typed is for what is shown next
    this.#opened = head;
    this.#update.hidden = head === null;
    this.#update.textContent = say("Save changes to “{home}”", { home: head?.name ?? "" });
    this.#name.value = head?.name ?? "";
    this.#tags.value = head?.tags.join(", ") ?? "";
  }

  async #save(): Promise<void> {
    await this.#saved((shown) => saveNew({ name: titleOf(shown), ...this.#texts(), scene: shown.scene }), "Saved “{home}”.");
  }

  async #saveChanges(): Promise<void> {
    const before = this.#opened;
    if (before) await this.#saved(({ scene }) => changeSaved(before.id, before.revision, { ...this.#texts(), scene }), "Saved the changes of “{home}”.");
  }

  #texts(): SavedTexts {
    const [name, tags] = [this.#name.value.trim(), tagsIn(this.#tags.value)];
    return { ...(name ? { name } : {}), tags };
  }

  /** Once a home is saved, what fails of its picture and of the list is no reason to save it again. */
  async #saved(save: (shown: Shown) => Promise<SavedHead>, did: Words): Promise<void> {
    const homes = this.#homes;
    const shown = await this.source.shown();
    if (!shown || homes !== this.#homes) return;
    const picture = this.source.picture().catch(() => null);
    const head = await save(shown);
    if (homes === this.#homes) this.holds(head);
    const drawn = await picture;
    if (drawn) await pictureSaved(head.id, drawn).catch(() => undefined);
    await this.#listed(false);
    this.#said.textContent = say(did, { home: head.name });
  }

  /** Does something; what somebody else has done to the home is said here, all else where refusals are shown. */
  #try(what: string, act: () => Promise<void>): void {
    void this.beside(what, async () => {
      this.#said.textContent = "";
      try {
        await act();
      } catch (reason) {
        const words = reason instanceof ServiceProblem && reason.status ? OF_OTHERS[reason.status] : undefined;
        if (!words) throw reason;
        this.#said.textContent = words;
      }
    });
  }

  /** Lists the homes as they are now; each time anew, so that the last search is the one that is shown. */
  #look(isMore: boolean): void {
    this.#said.textContent = "";
    void this.#listed(isMore);
  }

  #listed(isMore: boolean): Promise<void> {
    return this.#show(isMore).catch((reason: unknown) => { if (!isAbort(reason)) this.onFailure(reason, () => this.#look(isMore)); });
  }

  async #show(isMore: boolean): Promise<void> {
    const found = await listSaved(this.#search.value.trim(), isMore ? this.#after : null, this.#asked.next());
    this.#heads = isMore ? [...this.#heads, ...found.homes] : [...found.homes];
    this.#after = found.after;
    this.#more.hidden = found.after === null;
    for (const url of this.#pictures.splice(0)) URL.revokeObjectURL(url);
    this.#list.replaceChildren(...this.#heads.map((head) => this.#item(head)));
    if (this.#heads.length === 0) this.#said.textContent = say(this.#search.value.trim() ? "No saved home is called or tagged so." : "No home is saved here yet.");
  }

  #item(head: SavedHead): HTMLElement {
    const image = made("img", { alt: "", width: 72, height: 45 });
    void savedPicture(head.id).then((url) => { this.#pictures.push(url); image.src = url; }, () => undefined);
    const more = [say("{count} rooms", { count: head.rooms }), say("version {version}", { version: head.version }), ...head.tags].join(", ");
    const words = made("span", {}, made("b", {}, head.name), made("small", {}, more));
    const acts = made("div", {},
      button(say("Open"), () => this.onOpen(head.id)),
      button(say("Copy link"), () => void this.#copyLink(head)),
      button(say("Rename"), () => this.#edit(item, head, "name")),
      button(say("Tag"), () => this.#edit(item, head, "tags")),
      button(say("Compare"), () => this.#try(say("Comparing homes"), () => this.#comparison.add(head))),
      sureButton(say("Remove"), say("Really remove?"), head.name, () => this.#try(say("Removing {home}", { home: head.name }), () => this.#remove(head))),
    );
    for (const one of acts.querySelectorAll("button")) one.setAttribute("aria-label", `${one.textContent} ${head.name}`);
    const item = made("li", { "data-saved": head.id }, image, words, acts);
    return item;
  }

  /** Lets the name or the tags of a home be typed, in place of its buttons. */
  #edit(item: HTMLElement, head: SavedHead, what: "name" | "tags"): void {
    const typed = field(what === "name" ? say("New name of {home}", { home: head.name }) : say("Tags of {home}", { home: head.name }));
    typed.value = what === "name" ? head.name : head.tags.join(", ");
    typed.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.#look(false);
      if (event.key === "Enter") this.#try(say("Saving the home"), () => this.#change(head, what === "name" ? { name: typed.value.trim() } : { tags: tagsIn(typed.value) }));
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
    if (this.#opened?.id === head.id) this.holds(changed);
    await this.#listed(false);
  }

  async #remove(head: SavedHead): Promise<void> {
    await removeSaved(head.id, head.revision);
    if (this.#opened?.id === head.id) this.holds(null);
    await this.#listed(false);
    this.#said.textContent = say("Removed “{home}”.", { home: head.name });
  }
}
