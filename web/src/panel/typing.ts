/** Where keys are text or a choice, and no shortcuts. */
const TYPING = "input:not([type=range], [type=checkbox]), select, textarea, dialog[open] *";

/** Whether a key is typed into something, or belongs to the browser. */
export function isTyped({ target, ctrlKey, metaKey, altKey }: KeyboardEvent): boolean {
  return ctrlKey || metaKey || altKey || (target instanceof Element && target.matches(TYPING));
}
