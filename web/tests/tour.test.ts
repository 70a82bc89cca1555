// @vitest-environment happy-dom
/** Whom the tour greets. */
import { afterEach, expect, it } from "vitest";
import { remember } from "../src/panel/preferences";
import { Tour } from "../src/panel/tour";

function greeted(address: string): boolean {
  document.body.innerHTML = "<main><section hidden></section></main><button></button>";
  history.replaceState(null, "", address);
  const listeners: ((how: "new") => void)[] = [];
  const tour = new Tour(document.querySelector("section") as HTMLElement, document.querySelector("button") as HTMLElement, (greet) => listeners.push(greet));
  expect(tour.host.hidden).toBe(true);
  for (const listener of listeners) listener("new");
  const isGreeted = !tour.host.hidden;
  for (const listener of listeners) listener("new");
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

it("goes on while what it speaks of is clicked, and ends by any other click or another home", () => {
  const listeners: ((how: "new" | "step") => void)[] = [];
  document.body.innerHTML = "<main><section id=tour hidden></section></main><div id=starts><a>a</a></div><canvas></canvas><button id=again></button><i></i>";
  const again = document.querySelector("#again") as HTMLElement;
  const tour = new Tour(document.querySelector("section") as HTMLElement, again, (greet) => listeners.push(greet));
  const click = (selector: string): boolean => (document.querySelector<HTMLElement>(selector)?.click(), tour.host.hidden === true);
  expect(["#again", "#starts a", "canvas", "#tour h2", "i"].map(click)).toEqual([false, false, false, false, true]);
  expect(document.querySelector("[data-toured]")).toBe(null);
  again.click();
  const shows = (how: "new" | "step"): boolean => { for (const listener of listeners) listener(how); return tour.host.hidden === true; };
  expect([shows("new"), shows("step"), shows("new")]).toEqual([false, false, true]); // the first home greets
});
