/** The link to what is shown, copied; and what it cannot hold. */

const COPIED = "Link copied: it opens this house.";
const WITHOUT_EDITS = "Link copied: it opens the house as it was made; your changes go with a saved file.";
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

export class Link {
  #edited = false;
  #query: string | null = null;

  constructor(readonly button: HTMLButtonElement, readonly said: HTMLElement) {
    button.disabled = true;
    button.addEventListener("click", () => void this.#copy());
  }

  /** The query that makes what is shown; null for a file's scene, which no query makes. */
  opens(query: string | null): void {
    this.#query = query;
    this.button.disabled = query === null;
    this.said.textContent = query === null ? OF_FILE : "";
  }

  /** What is shown was changed since it was made, or not. */
  edited(edited: boolean): void {
    if (edited !== this.#edited && !this.button.disabled) this.said.textContent = "";
    this.#edited = edited;
  }

  async #copy(): Promise<void> {
    const link = new URL(this.#query ?? "", location.href).href;
    const copied = await copy(link);
    if (!copied) this.said.textContent = `Copy this link: ${link}`;
    else this.said.textContent = this.#edited ? WITHOUT_EDITS : COPIED;
    this.button.focus();
  }
}
