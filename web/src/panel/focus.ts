/** The focus stays where it was while what is around it is made anew, and is not lost with what goes away. */

/** What tells one control of a panel from the others. */
const MARKS = ["name", "data-gap", "data-align", "data-home", "aria-label"];

/** Gives a host other children; what had the focus among the old has it among the new, where there is such a one. */
export function replaceKeepingFocus(host: HTMLElement, children: readonly (Node | string)[]): void {
  const held = host.contains(document.activeElement) ? document.activeElement : null;
  const mark = MARKS.find((name) => held?.hasAttribute(name));
  const value = mark === undefined ? null : held?.getAttribute(mark);
  host.replaceChildren(...children);
  if (mark === undefined || value == null) return;
  [...host.querySelectorAll<HTMLElement>(`[${mark}]`)].find((one) => one.getAttribute(mark) === value)?.focus({ preventScroll: true });
}

/** Hides what lies over the house; the focus, if it had it, goes to the house. */
export function putAway(host: HTMLElement): void {
  const held = host.contains(document.activeElement);
  host.hidden = true;
  if (held) (host.closest("main") ?? document.body).focus({ preventScroll: true });
}
