/** Elements of the inspector: made of text nodes and properties only. */

type Child = Node | string;

export function group(title: string, ...children: readonly Child[]): HTMLElement {
  const [section, head] = [document.createElement("section"), document.createElement("h3")];
  head.textContent = title;
  section.append(head, ...children);
  return section;
}

export function button(words: string, act: () => void, more: { readonly label?: string; readonly disabled?: boolean; readonly className?: string } = {}): HTMLButtonElement {
  const element = document.createElement("button");
  element.type = "button";
  element.textContent = words;
  element.disabled = more.disabled === true;
  if (more.label) element.setAttribute("aria-label", more.label);
  if (more.className) element.className = more.className;
  element.addEventListener("click", act);
  return element;
}

export function row(...children: readonly Child[]): HTMLElement {
  const element = document.createElement("div");
  element.className = "row";
  element.append(...children);
  return element;
}

export function hint(words: string): HTMLElement {
  const element = document.createElement("p");
  element.className = "hint";
  element.textContent = words;
  return element;
}

function labelled(words: string, field: HTMLElement): HTMLElement {
  const label = document.createElement("label");
  label.append(words, " ", field);
  return label;
}

/** A length in metres; what is typed is taken when the field is left or Enter is pressed, and refused where it is no length. */
export function lengthField(words: string, millimetres: number, take: (millimetres: number) => boolean): HTMLElement {
  const input = document.createElement("input");
  input.type = "number";
  input.step = "0.01";
  input.inputMode = "decimal";
  input.value = (millimetres / 1000).toFixed(2);
  input.addEventListener("change", () => {
    const wanted = Math.round(input.valueAsNumber * 1000);
    const isTaken = Number.isFinite(wanted) && take(wanted);
    input.setAttribute("aria-invalid", String(!isTaken));
  });
  return labelled(words, input);
}

export function textField(words: string, value: string, take: (words: string) => void): HTMLElement {
  const input = Object.assign(document.createElement("input"), { type: "text", value, maxLength: 100 });
  input.addEventListener("change", () => take(input.value.trim()));
  return labelled(words, input);
}

export function choiceField(words: string, options: readonly (readonly [value: string, words: string])[], value: string, take: (value: string) => void): HTMLElement {
  const select = document.createElement("select");
  select.append(...options.map(([key, text]) => new Option(text, key)));
  select.value = value;
  select.addEventListener("change", () => take(select.value));
  return labelled(words, select);
}

export function switchField(words: string, isOn: boolean, take: (isOn: boolean) => void): HTMLElement {
  const input = document.createElement("input");
  input.type = "checkbox";
  input.checked = isOn;
  input.addEventListener("change", () => take(input.checked));
  const label = document.createElement("label");
  label.className = "switch";
  label.append(input, " ", words);
  return label;
}
