/** Keys press the control that says it has them (`aria-keyshortcuts`): what they do is said once. */
import { isText } from "./typing";

/** The keys that press again while they are held. */
const REPEATED: ReadonlySet<string> = new Set(["Q", "E", "Control+Z", "Control+Shift+Z", "Control+Y"]);

/** A key as controls name it; Shift counts with letters and keys that have a name, elsewhere it is what makes the sign. */
function nameOf({ key, ctrlKey, metaKey, shiftKey }: KeyboardEvent): string {
  const isNamed = key.length > 1 || key.toLowerCase() !== key.toUpperCase();
  return [...(ctrlKey || metaKey ? ["Control"] : []), ...(shiftKey && isNamed ? ["Shift"] : []), key.length > 1 ? key : key.toUpperCase()].join("+");
}

/** Whether a control is nowhere: it is put away, or has no place in a window of this width. What is off, or folded away, is there. */
function isAway(control: HTMLElement): boolean {
  return control.closest("[hidden]") !== null || (!control.matches(":disabled") && getComputedStyle(control).display === "none");
}

/** What presses the control of a key, and nothing more where that is off; null where no control that is there has it. */
export function pressing(event: KeyboardEvent, within: ParentNode): (() => void) | null {
  const name = nameOf(event);
  const all = within.querySelectorAll<HTMLElement>(`:is(button, input)[aria-keyshortcuts~="${CSS.escape(name)}"]`);
  const control = [...all].find((one) => !isAway(one));
  return control ? () => { if (!event.repeat || REPEATED.has(name)) control.click(); } : null;
}

export function listenToShortcuts(): void {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.altKey || isText(event.target)) return;
    const isCopied = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "c" && getSelection()?.isCollapsed === false;
    const press = isCopied ? null : pressing(event, document);
    if (!press) return;
    event.preventDefault();
    press();
  });
}
