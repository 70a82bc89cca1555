/** Links that skip to a region: they only move the focus, since an address that changes would open its house again. Buttons that press another. */

import { fold, type Panel } from "./preferences";

export function listenToSkips(): void {
  for (const link of document.querySelectorAll<HTMLAnchorElement>(".skips a")) {
    link.addEventListener("click", (event) => {
      event.preventDefault();
      if (link.hash === "#controls" || link.hash === "#reading") fold(link.hash.slice(1) as Panel, false);
      document.getElementById(link.hash.slice(1))?.focus();
    });
  }
  for (const button of document.querySelectorAll<HTMLElement>("[data-presses]")) {
    button.addEventListener("click", () => document.getElementById(button.dataset.presses ?? "")?.click());
  }
}
