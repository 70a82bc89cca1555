/** The link to what is shown, copied; and what it cannot hold. */

/** What is shown: what a request makes, that with a person's edits, or a file's scene. */
export type Shows = "a request" | "edits" | "a file";

const WORDS: Readonly<Record<Shows, string>> = {
  "a request": "Link copied: it opens this house.",
  edits: "Link copied: it opens the house as it was made; your changes go with a saved file.",
  "a file": "A link cannot hold a scene from a file; save it and send the file.",
};

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
  #shows: Shows = "a request";

  constructor(button: HTMLElement, readonly said: HTMLElement) {
    button.addEventListener("click", () => void this.#copy(button));
  }

  holds(shows: Shows): void {
    if (shows === "edits" && this.#shows === "a file") return;
    this.#shows = shows;
    this.said.textContent = "";
  }

  async #copy(button: HTMLElement): Promise<void> {
    const copied = this.#shows === "a file" || (await copy(location.href));
    this.said.textContent = copied ? WORDS[this.#shows] : `Copy this link: ${location.href}`;
    button.focus();
  }
}
