/** The focus stays where it was while what is around it is made anew. */

/** What tells one control of a panel from the others. */
const MARKS = ["name", "data-gap", "data-align", "aria-label"];

/** Gives a host other children; what had the focus among the old has it among the new, where there is such a one. */
export function replaceKeepingFocus(host: HTMLElement, children: readonly (Node | string)[]): void {
  const held = host.contains(document.activeElement) ? document.activeElement : null;
  const mark = MARKS.find((name) => held?.hasAttribute(name));
  const value = mark === undefined ? null : held?.getAttribute(mark);
  host.replaceChildren(...children);
  if (mark === undefined || value == null) return;
  [...host.querySelectorAll<HTMLElement>(`[${mark}]`)].find((one) => one.getAttribute(mark) === value)?.focus({ preventScroll: true });
}
