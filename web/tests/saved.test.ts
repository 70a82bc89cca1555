// @vitest-environment happy-dom
/** Homes that the service keeps: what is saved is what was shown, whatever is shown once the answer comes. */
import { afterEach, expect, it, vi } from "vitest";
import { SavedPanel } from "../src/saved/saved_panel";
import type { SavedHead } from "../src/saved/saved_calls";
import type { Shown } from "../src/state/home";
import { room, scene } from "./rooms";

afterEach(() => { vi.unstubAllGlobals(); });

const headOf = (id: string) => ({ id, name: id, tags: [], revision: 1, rooms: 1, version: 1 }) as unknown as SavedHead;
const shownOf = (id: string): Shown => ({ scene: scene([room(id, [0, 0, 4, 3])], { seed: 1 }), issues: [], conflicts: [], timing: 0, file: id });

/** A panel over a service whose answers to saving come when that is said; all else is refused where it `is away`. */
function panel() {
  const saved: string[] = [];
  const [waiting, said]: [(() => void)[], { failed: number; isAway: boolean }] = [[], { failed: 0, isAway: false }];
  vi.stubGlobal("fetch", (_: URL, init: RequestInit) => new Promise((done, fail) => {
    if (!init.method) return said.isAway ? fail(new Error("gone")) : done(Response.json({ homes: [], after: null }));
    const { name } = JSON.parse(init.body as string) as { name: string };
    saved.push(name);
    waiting.push(() => done(Response.json(headOf(name))));
  }));
  let shown: Promise<Shown> = Promise.resolve(shownOf("den"));
  const host = document.body.appendChild(document.createElement("details"));
  const refused: unknown[] = [];
  const made = new SavedPanel(host, { shown: () => shown, picture: () => Promise.resolve(null) }, (_, act) => act().catch((reason: unknown) => { refused.push(reason); }));
  made.onFailure = () => { said.failed += 1; };
  const press = (words: string) => [...host.querySelectorAll("button")].find(({ textContent }) => textContent?.startsWith(words))?.click();
  const update = () => [...host.querySelectorAll("button")].find(({ textContent, hidden }) => !hidden && textContent?.startsWith("Save changes"))?.textContent;
  const answer = () => vi.waitFor(() => { expect(waiting).not.toHaveLength(0); for (const one of waiting.splice(0)) one(); });
  const status = () => host.querySelector("[role=status]")?.textContent;
  return { made, press, update, answer, status, saved, said, refused, show: (next: Promise<Shown>) => { shown = next; } };
}

it("goes on with the home that was saved, unless another is shown by then", async () => {
  const { made, press, update, answer, status, saved } = panel();
  press("Save this home");
  await answer();
  await vi.waitFor(() => { expect(status()).toBe("Saved “den”."); });
  expect(update()).toBe("Save changes to “den”");
  press("Save changes");
  await vi.waitFor(() => { expect(saved).toHaveLength(2); });
  made.holds(headOf("villa"));
  await answer();
  await vi.waitFor(() => { expect(status()).toBe("Saved the changes of “den”."); });
  expect(update()).toBe("Save changes to “villa”");
});

it("saves the home with the edits that are under way", async () => {
  const { press, saved, answer, show } = panel();
  let land = (_: Shown): void => undefined;
  show(new Promise((done) => { land = done; }));
  press("Save this home");
  await Promise.resolve();
  expect(saved).toEqual([]);
  land(shownOf("den_edited"));
  await answer();
  expect(saved).toEqual(["den_edited"]);
});

it("does not fail where the list that is asked for after it does", async () => {
  const { press, answer, status, said, refused } = panel();
  said.isAway = true;
  press("Save this home");
  await answer();
  await vi.waitFor(() => { expect(status()).toBe("Saved “den”."); });
  expect([said.failed > 0, refused]).toEqual([true, []]);
});
