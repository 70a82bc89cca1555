/** The row of buttons over the canvas: what can be done to the piece in hand, and to the home. */
import { button, made } from "../made";
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
    const words = say(tool.words);
    const control = button("", () => tool.act(), {
      title: tool.keys ? `${words} (${keyWords(tool.keys.split(" ")[0] ?? "")})` : words,
      "data-tool": tool.name, "aria-label": words, ...(tool.keys ? { "aria-keyshortcuts": tool.keys } : {}),
    });
    control.append(made("span", { "aria-hidden": true }, say(tool.sign)));
    return control;
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
