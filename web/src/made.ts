/** Elements, made of properties, attributes and text nodes only: nothing that is said in one is ever read as markup. */

type Child = Node | string;
/** What has no property of its own everywhere. */
type Attributes = { readonly role?: string; readonly [name: `aria-${string}` | `data-${string}`]: string | number | boolean };

const SVG = "http://www.w3.org/2000/svg";

/** An element with its properties and attributes, and what it holds. */
export function made<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag, said?: Omit<Partial<HTMLElementTagNameMap[Tag]>, "role"> & Attributes, ...children: readonly Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(said ?? {})) {
    if (name === "role" || name.includes("-")) element.setAttribute(name, String(value));
    else Object.assign(element, { [name]: value });
  }
  element.append(...children);
  return element;
}

/** A button that does something. */
export function button(words: string, act: () => void, said: Parameters<typeof made<"button">>[1] = {}): HTMLButtonElement {
  const element = made("button", { type: "button", textContent: words, ...said });
  element.addEventListener("click", () => act());
  return element;
}

/** An element of a drawing. */
export function drawn<Tag extends keyof SVGElementTagNameMap>(tag: Tag, attributes: Readonly<Record<string, string | number>> = {}, ...children: readonly Child[]): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS(SVG, tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}
