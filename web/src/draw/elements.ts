/** Elements of the inspector: groups, rows and fields. */
import { made } from "../made";

type Child = Node | string;

export function group(title: string, ...children: readonly Child[]): HTMLElement {
  return made("section", {}, made("h3", {}, title), ...children);
}

export function row(...children: readonly Child[]): HTMLElement {
  return made("div", { className: "row" }, ...children);
}

export function hint(words: string): HTMLElement {
  return made("p", { className: "hint" }, words);
}

function labelled(words: string, field: HTMLElement): HTMLElement {
  return made("label", {}, words, " ", field);
}

/** A length in metres; what is typed is taken when the field is left or Enter is pressed, and refused where it is no length. */
export function lengthField(words: string, millimetres: number, take: (millimetres: number) => boolean): HTMLElement {
  const input = made("input", { type: "number", step: "0.01", inputMode: "decimal", value: (millimetres / 1000).toFixed(2) });
  input.addEventListener("change", () => {
    const wanted = Math.round(input.valueAsNumber * 1000);
    const isTaken = Number.isFinite(wanted) && take(wanted);
    input.setAttribute("aria-invalid", String(!isTaken));
  });
  return labelled(words, input);
}

export function textField(words: string, value: string, take: (words: string) => void): HTMLElement {
  const input = made("input", { type: "text", value, maxLength: 100 });
  input.addEventListener("change", () => take(input.value.trim()));
  return labelled(words, input);
}

export function choiceField(words: string, options: readonly (readonly [value: string, words: string])[], value: string, take: (value: string) => void): HTMLElement {
  const select = made("select", {}, ...options.map(([key, text]) => new Option(text, key)));
  select.value = value;
  select.addEventListener("change", () => take(select.value));
  return labelled(words, select);
}

export function switchField(words: string, isOn: boolean, take: (isOn: boolean) => void): HTMLElement {
  const input = made("input", { type: "checkbox", checked: isOn });
  input.addEventListener("change", () => take(input.checked));
  return made("label", { className: "switch" }, input, " ", words);
}
