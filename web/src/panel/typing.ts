/** Where keys are text or a choice, and no shortcuts; those pressed in a dialog are none of the page behind it. */
const TYPING = "input:not([type=range], [type=checkbox]), select, textarea, dialog[open], dialog[open] *";

/** Whether a key is typed into something. */
export function isText(target: EventTarget | null): boolean {
  return target instanceof Element && target.matches(TYPING);
}

/** Whether a key is typed into something, or belongs to the browser. */
export function isTyped({ target, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return ctrlKey || metaKey || altKey || isText(target);
}
