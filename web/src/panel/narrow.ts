/** On a narrow screen the house comes first: groups of controls below it start folded, but for the first. */

const NARROW = "(width < 900px)";

export function foldForNarrow(): void {
  if (!window.matchMedia(NARROW).matches) return;
  const groups = [...document.querySelectorAll<HTMLDetailsElement>("details.group")];
  for (const group of groups.slice(1)) group.open = false;
}
