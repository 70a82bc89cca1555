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

  constructor(readonly button: HTMLButtonElement, readonly said: HTMLElement) {
    button.addEventListener("click", () => void this.#copy());
  }

  /** What is shown is what the address asks for, or else a file's scene, which no address can. */
  holds(request: boolean): void {
    this.button.disabled = !request;
    this.said.textContent = request ? "" : OF_FILE;
  }

  /** What is shown was changed since it was made, or not. */
  edited(edited: boolean): void {
    if (edited !== this.#edited && !this.button.disabled) this.said.textContent = "";
    this.#edited = edited;
  }

  async #copy(): Promise<void> {
    const copied = await copy(location.href);
    if (!copied) this.said.textContent = `Copy this link: ${location.href}`;
    else this.said.textContent = this.#edited ? WITHOUT_EDITS : COPIED;
    this.button.focus();
  }
}
