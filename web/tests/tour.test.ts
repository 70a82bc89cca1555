// @vitest-environment happy-dom
/** Whom the tour greets. */
import { afterEach, expect, it } from "vitest";
import { remember } from "../src/panel/preferences";
import { Tour } from "../src/panel/tour";

function greeted(address: string): boolean {
  document.body.innerHTML = "<main><section hidden></section></main><button></button>";
  history.replaceState(null, "", address);
  const listeners: (() => void)[] = [];
  const tour = new Tour(document.querySelector("section") as HTMLElement, document.querySelector("button") as HTMLElement, (greet) => listeners.push(greet));
  expect(tour.host.hidden).toBe(true);
  for (const listener of listeners) listener();
  const isGreeted = !tour.host.hidden;
  tour.host.hidden = true;
  for (const listener of listeners) listener();
  expect(tour.host.hidden).toBe(true);
  return isGreeted;
}

afterEach(() => {
  localStorage.clear();
  history.replaceState(null, "", "/");
});

it("greets who comes to the page itself for the first time, once", () => {
  expect(greeted("/")).toBe(true);
  expect(greeted("/")).toBe(false);
});

it("greets nobody who comes by a link to a home", () => {
  expect([greeted("/?seed=4"), greeted("/#changes=x")]).toEqual([false, false]);
  expect(greeted("/")).toBe(true);
  localStorage.clear();
  remember("tour", "seen");
  expect(greeted("/")).toBe(false);
});
