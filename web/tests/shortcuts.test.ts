// @vitest-environment happy-dom
import { beforeAll, beforeEach, expect, test } from "vitest";
import { listenToShortcuts } from "../src/panel/shortcuts";

const pressed: string[] = [];

beforeAll(() => listenToShortcuts());
beforeEach(() => {
  pressed.length = 0;
  document.body.innerHTML = `
    <button aria-keyshortcuts="Q">left</button><button aria-keyshortcuts="Control+Shift+Z Control+Y">redo</button><button aria-keyshortcuts="Control+Z">undo</button>
    <button aria-keyshortcuts="?">keys</button><button aria-keyshortcuts="K" disabled>lock</button><button aria-keyshortcuts="M">tape</button>
    <div hidden><button aria-keyshortcuts="V">hidden</button></div><button aria-keyshortcuts="5" style="display: none">split</button><input type="text"><input type="range"><dialog open><a tabindex="0">in a dialog</a></dialog>`;
  for (const one of document.querySelectorAll("button")) one.addEventListener("click", () => pressed.push(one.textContent ?? ""));
});

function press(key: string, more: KeyboardEventInit = {}, on: Element = document.body): boolean {
  return on.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true, ...more }));
}

test("a key presses the control that has it, whatever case a letter comes in", () => {
  press("q");
  press("Q");
  press("z", { ctrlKey: true });
  press("z", { metaKey: true });
  press("Z", { ctrlKey: true, shiftKey: true });
  press("y", { ctrlKey: true });
  press("?", { shiftKey: true });
  expect(pressed).toEqual(["left", "left", "undo", "undo", "redo", "redo", "keys"]);
});

test("a key is another one with Shift, and none of what is off, away or unknown", () => {
  expect(press("k")).toBe(false); // the browser does nothing else with it
  expect([press("Q", { shiftKey: true }), press("v"), press("w"), press("5"), press("q", { altKey: true })]).toEqual([true, true, true, true, true]);
  expect(pressed).toEqual([]);
});

test("keys are text in a field, and none of the page's in a dialog", () => {
  for (const name of ["input[type=text]", "dialog a"]) press("q", {}, document.querySelector(name) as Element);
  expect(pressed).toEqual([]);
  press("q", {}, document.querySelector("input[type=range]") as Element);
  expect(pressed).toEqual(["left"]);
});

test("held down, a key that turns goes on, one that opens does not", () => {
  for (const key of ["q", "m"]) press(key, { repeat: true });
  expect(pressed).toEqual(["left"]);
});
