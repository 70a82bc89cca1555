/** The keys, told in a dialog. */
import { made } from "../made";
import { KEY_LIST, keyWords } from "./key_list";
import { say, type Words } from "../words/language";
import { element } from "../element";

/** A line of the list: its keys, parted by spaces, and what they do. */
function lineOf([keys, does]: readonly [string, Words]): HTMLElement {
  const pressed = keys.split(" ").flatMap((key, place) => [...(place > 0 ? [" "] : []), made("kbd", {}, keyWords(key))]);
  return made("div", {}, made("dt", {}, ...pressed), made("dd", {}, say(does)));
}

export class Keys {
  readonly #dialog = element<HTMLDialogElement>("keys_dialog");

  constructor() {
    element("keys_list").replaceChildren(...KEY_LIST.map(([heading, lines]) => made("section", {}, made("h3", {}, say(heading)), made("dl", {}, ...lines.map(lineOf)))));
    element("keys").addEventListener("click", () => this.#dialog.showModal());
    element("keys_close").addEventListener("click", () => this.#dialog.close());
  }
}
