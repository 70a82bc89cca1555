/** The elements of labels: each made once and kept, measured together, touched only when something changes. */

import { made } from "../made";

export interface LabelElement {
  readonly element: HTMLElement;
  /** With all its words [CSS pixels]. */
  width: number;
  height: number;
  /** How much narrower it is without its second words [CSS pixels]. */
  spare: number;
  readonly second: HTMLElement | null;
}

const AWAY = "translate(-9999px, 0)";

/** A label in one of the looks that the style sheet knows; the words are text, never markup. */
export function labelElement(look: string, words: string, more: { dot?: string; second?: string } = {}): LabelElement {
  const second = more.second === undefined ? null : made("span", { className: "second" }, more.second);
  const dot = made("span", { className: "dot" });
  dot.style.backgroundColor = more.dot ?? "";
  const element = made("div", { className: look }, ...(more.dot ? [dot] : []), made("span", { className: "words" }, words), ...(second ? [second] : []));
  element.style.transform = AWAY;
  return { element, width: 0, height: 0, spare: 0, second };
}

/** Puts new labels on their layer and measures them, with one layout of the page for all. */
export function hang(layer: HTMLElement, labels: readonly LabelElement[]): void {
  layer.append(...labels.map(({ element }) => element));
  for (const label of labels) {
    const { element, second } = label;
    [label.width, label.height] = [element.offsetWidth, element.offsetHeight];
    const gap = second ? Number.parseFloat(getComputedStyle(element).columnGap) || 0 : 0;
    label.spare = second ? second.offsetWidth + gap : 0;
  }
}

export function hide({ element }: LabelElement): void {
  if (!element.hidden) element.hidden = true;
}

export function moveTo({ element }: LabelElement, x: number, y: number): void {
  const transform = `translate(-50%, -50%) translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
  if (element.style.transform !== transform) element.style.transform = transform;
  if (element.hidden) element.hidden = false;
}
