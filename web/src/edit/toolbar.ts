/** The row of buttons over the canvas: what can be done to the piece in hand, and to the home. */
import { keyWords } from "../panel/key_list";
import { say, type Words } from "../words/language";

export interface Tool {
  readonly name: string;
  readonly words: Words;
  readonly sign: Words;
  /** As `aria-keyshortcuts` wants it. */
  readonly keys?: string;
  act(): void;
}

export class Toolbar {
  readonly #buttons = new Map<string, HTMLButtonElement>();

  constructor(readonly host: HTMLElement, tools: readonly Tool[]) {
    for (const tool of tools) this.#buttons.set(tool.name, this.#button(tool));
    host.replaceChildren(...this.#buttons.values());
    host.hidden = false;
  }

  #button(tool: Tool): HTMLButtonElement {
    const button = document.createElement("button");
    button.type = "button";
    button.dataset.tool = tool.name;
    const words = say(tool.words);
    button.title = tool.keys ? `${words} (${keyWords(tool.keys.split(" ")[0] ?? "")})` : words;
    button.setAttribute("aria-label", words);
    if (tool.keys) button.setAttribute("aria-keyshortcuts", tool.keys);
    const sign = document.createElement("span");
    sign.textContent = say(tool.sign);
    sign.setAttribute("aria-hidden", "true");
    button.append(sign);
    button.addEventListener("click", () => tool.act());
    return button;
  }

  enable(name: string, enabled: boolean): void {
    const button = this.#buttons.get(name);
    if (!button) return;
    const hadFocus = document.activeElement === button;
    button.disabled = !enabled;
    if (hadFocus && !enabled) this.host.closest<HTMLElement>("[tabindex]")?.focus(); // it is seen no more
  }

  press(name: string, pressed: boolean): void {
    this.#buttons.get(name)?.setAttribute("aria-pressed", String(pressed));
  }

  name(name: string, words: string): void {
    const button = this.#buttons.get(name);
    button?.setAttribute("aria-label", words);
    if (button) button.title = words;
  }
}
