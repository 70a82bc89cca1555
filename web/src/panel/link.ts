/** The link to what is shown, copied; and what it cannot hold. */
import type { Beside } from "../asking";
import { frameLine } from "../embed/embed_address";
import { made } from "../made";
import { LONGEST_LINK, type Found } from "../memory/carrying";
import { say } from "../words/language";

const COPIED = say("Link copied: it opens this house.");
const WITH_EDITS = say("Link copied: it opens this house with your changes.");
const UNKNOWN = say("Link copied: it opens the house as it was made; your changes go with a saved file.");
const OF_NO_REQUEST = say("No link holds this home: save it under Saved homes and copy its link there, or send it as a file.");

/** Copies by the old way, which also works where the clipboard is not given to pages. */
function copyBySelection(text: string): boolean {
  const field = made("textarea", { value: text, className: "unseen" });
  document.body.append(field);
  field.select();
  const done = document.execCommand("copy");
  field.remove();
  return done;
}

export async function copy(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyBySelection(text);
  }
}

/** What is said of a link that is too long for what it should hold. */
function tooLong(length: number): string {
  const values = { length: length.toLocaleString("en"), most: LONGEST_LINK.toLocaleString("en") };
  return say("Your changes make a link of {length} letters; {most} go everywhere. Send a file instead. The link that was copied opens the house as it was made.", values);
}

export class Link {
  #isEdited = false;
  #query: string | null | undefined;

  /** Copies the line of HTML that shows the home in another page. */
  readonly framing = document.getElementById("copy_frame") as HTMLButtonElement | null;

  /** `find` makes the link to a home that was changed; `saving` saves it as a file. */
  constructor(readonly button: HTMLButtonElement, readonly said: HTMLElement, readonly saving: HTMLButtonElement, beside: Beside, readonly find: () => Promise<Found>) {
    button.disabled = true;
    if (this.framing) this.framing.disabled = true;
    this.framing?.addEventListener("click", () => void beside(say("Making the frame"), () => this.#copyFrame()));
    button.addEventListener("click", () => void beside(say("Making the link"), () => this.#copy()));
  }

  /** The query that makes what is shown; null for a scene that was drawn or read from a file, which no query makes. */
  opens(query: string | null): void {
    if (query === this.#query) return;
    this.#query = query;
    this.button.disabled = query === null;
    if (this.framing) this.framing.disabled = query === null;
    this.#say(query === null ? OF_NO_REQUEST : "");
  }

  /** What is shown was changed since it was made, or not. */
  edited(isEdited: boolean): void {
    if (!this.button.disabled) this.#say("");
    this.#isEdited = isEdited;
  }

  get #plain(): string {
    return new URL(this.#query ?? "", location.href.replace(/#.*/, "")).href;
  }

  /** The link to what is shown; null where that of the changes could not be made. */
  async #found(): Promise<Found | null> {
    const plain = this.#plain;
    return this.#isEdited ? this.find().catch(() => null) : { link: plain, isWhole: true, length: plain.length };
  }

  async #copyFrame(): Promise<void> {
    const found = await this.#found();
    const line = frameLine(found?.link ?? this.#plain);
    if (!(await copy(line))) this.#say(say("Copy this line: {line}", { line }));
    else if (found && !found.isWhole) this.#say(tooLong(found.length), true);
    else this.#say(say("Copied: a line of HTML that shows this house in your page."));
  }

  async #copy(): Promise<void> {
    const [plain, found] = [this.#plain, await this.#found()];
    const link = found?.link ?? plain;
    if (!(await copy(link))) this.#say(say("Copy this link: {link}", { link }));
    else if (found && !found.isWhole) this.#say(tooLong(found.length), true);
    else this.#say(found ? (this.#isEdited ? WITH_EDITS : COPIED) : UNKNOWN, !found);
    this.button.focus();
  }

  #say(words: string, isFileBetter = false): void {
    this.said.textContent = words;
    this.saving.hidden = !isFileBetter;
  }
}
