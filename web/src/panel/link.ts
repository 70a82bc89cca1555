/** The link to what is shown, copied; and what it cannot hold. */
import { LONGEST_LINK, type Found } from "../memory/carrying";

const COPIED = "Link copied: it opens this house.";
const WITH_EDITS = "Link copied: it opens this house with your changes.";
const UNKNOWN = "Link copied: it opens the house as it was made; your changes go with a saved file.";
const OF_FILE = "No link holds a scene from a file: save it and send the file.";

/** Copies by the old way, which also works where the clipboard is not given to pages. */
function copyBySelection(text: string): boolean {
  const field = document.createElement("textarea");
  field.value = text;
  field.className = "unseen";
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
  return `Your changes make a link of ${length.toLocaleString("en")} letters; ${LONGEST_LINK.toLocaleString("en")} go everywhere. Send a file instead. `
    + "The link that was copied opens the house as it was made.";
}

export class Link {
  #isEdited = false;
  #query: string | null | undefined;

  /** `find` makes the link to a home that was changed; `saving` saves it as a file. */
  constructor(readonly button: HTMLButtonElement, readonly said: HTMLElement, readonly saving: HTMLButtonElement, readonly find: () => Promise<Found>) {
    button.disabled = true;
    button.addEventListener("click", () => void this.#copy());
  }

  /** The query that makes what is shown; null for a file's scene, which no query makes. */
  opens(query: string | null): void {
    if (query === this.#query) return;
    this.#query = query;
    this.button.disabled = query === null;
    this.#say(query === null ? OF_FILE : "");
  }

  /** What is shown was changed since it was made, or not. */
  edited(isEdited: boolean): void {
    if (!this.button.disabled) this.#say("");
    this.#isEdited = isEdited;
  }

  async #copy(): Promise<void> {
    const plain = new URL(this.#query ?? "", location.href.replace(/#.*/, "")).href;
    const found = this.#isEdited ? await this.find().catch(() => null) : { link: plain, isWhole: true, length: plain.length };
    const link = found?.link ?? plain;
    if (!(await copy(link))) this.#say(`Copy this link: ${link}`);
    else if (found && !found.isWhole) this.#say(tooLong(found.length), true);
    else this.#say(found ? (this.#isEdited ? WITH_EDITS : COPIED) : UNKNOWN, !found);
    this.button.focus();
  }

  #say(words: string, isFileBetter = false): void {
    this.said.textContent = words;
    this.saving.hidden = !isFileBetter;
  }
}
