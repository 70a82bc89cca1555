// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from "vitest";
import { Asking } from "../src/asking";
import type { Scene } from "../src/contract";
import { Remaking } from "../src/edit/remaking";
import { Progress } from "../src/panel/progress";
import { bench, house, ONE, turn } from "./edit_bench";

interface Sent {
  readonly scene: Scene;
  readonly reroll?: readonly string[];
  readonly style?: string;
  readonly decorate?: boolean;
}

/** A home that is remade by a service that answers when told, its questions asked as the page asks them. */
function remade() {
  document.body.innerHTML = '<main></main><div id="bar"><span></span></div>'
    + '<div id="notice" hidden><b class="notice-title"></b><i class="notice-detail"></i><form class="notice-key"><input></form><button class="notice-again"></button></div>';
  const [stage, bar, notice, again] = ["main", "#bar", "#notice", ".notice-again"].map((one) => document.querySelector(one)) as [HTMLElement, HTMLElement, HTMLElement, HTMLElement];
  const asking = new Asking(notice, new Progress(bar, stage));
  const { home, editor, call } = bench();
  home.on("shown", () => asking.notice.hide());
  const [sent, answers]: [Sent[], ((response: Response) => void)[]] = [[], []];
  vi.stubGlobal("fetch", (_: URL, { body, signal }: RequestInit) => new Promise((resolve, reject) => {
    sent.push(JSON.parse(String(body)) as Sent);
    answers.push(resolve);
    signal?.addEventListener("abort", () => reject(signal.reason as Error));
  }));
  const remaking = new Remaking(home, asking, { editor: () => editor, read: () => Promise.resolve(), furnished: () => undefined });
  const rest = async (): Promise<void> => { for (let time = 0; time < 5; time += 1) await turn(); };
  /** Answers what was asked last: it is refused with a status, or done. */
  const answer = async (status = 200): Promise<void> => {
    await rest();
    const { scene, reroll, style, decorate } = sent.at(-1) as Sent;
    const made = { scene: { ...scene, style: [scene.style, reroll, style, decorate].flat().filter(Boolean).join() }, issues: [], timing_ms: 1 };
    answers.at(-1)?.(status === 200 ? new Response(JSON.stringify(made)) : new Response(JSON.stringify({ title: "no", status, detail: String(reroll) }), { status }));
    await rest();
  };
  const rooms = (): readonly unknown[] => sent.map(({ reroll }) => reroll?.join());
  return { home, editor, call, asking, remaking, sent, rooms, answer, rest, notice, again };
}

describe("a home that is remade", () => {
  afterEach(() => { vi.unstubAllGlobals(); });

  it("has all that was wished meanwhile, each a step, in the order of the wishes; of two for one thing the newer", async () => {
    const { home, remaking, sent, answer, rest } = remade();
    remaking.restyle({ style: "modern" });
    remaking.reroll("den");
    await rest();
    remaking.reroll("hall");
    remaking.restyle({ decorate: true });
    remaking.restyle({ style: "rustic" });
    for (let time = 0; time < 4; time += 1) await answer();
    expect([home.scene?.style, sent.length]).toEqual(["den,hall,true,rustic", 5]);
    home.undo();
    expect(home.scene?.style).toBe("den,hall,true");
  });

  it.each([["waits for an edit", true], ["is under way", false]])("has nothing of what was wished of another one, which %s", async (_, edited) => {
    const { home, editor, call, asking, remaking, rooms, answer, rest } = remade();
    if (edited) editor.rotate(ONE, 90);
    remaking.reroll("den");
    await rest();
    void asking.run("another", async () => {
      if (!edited) await editor.landed; // which the wish no longer holds up
      home.show({ scene: house(), issues: [], conflicts: [], timing: 1 }, "new");
      editor.forget();
    });
    await rest();
    if (edited) await call(0).answer();
    remaking.reroll("hall");
    await answer();
    expect([rooms(), home.scene?.style, editor.busy]).toEqual([edited ? ["hall"] : ["den", "hall"], "hall", false]);
  });

  it.each([[422], [503]])("has what is wished after what is refused (%i), which is said at the end, and of both may be wished again", async (status) => {
    const { home, remaking, rooms, answer, notice, again } = remade();
    remaking.reroll("den");
    remaking.reroll("hall");
    await answer(status);
    await answer();
    expect([rooms(), home.scene?.style, notice.hidden, notice.textContent?.includes("den")]).toEqual([["den", "hall"], "hall", false, true]);
    again.click();
    remaking.reroll("bath");
    for (const one of [status, status]) await answer(one);
    again.click();
    for (const one of [200, 200]) await answer(one);
    expect([rooms(), home.scene?.style, notice.hidden]).toEqual([["den", "hall", "den", "bath", "den", "bath"], "hall,den,bath", true]);
  });

  it("has no wish that undo took back, and nothing else less; what was done after a wish undo takes back first", async () => {
    const { home, editor, call, remaking, rooms, answer, rest } = remade();
    const step = { issues: [], conflicts: [], timing: 1 };
    home.show({ ...step, scene: { ...house(), style: "edited" } }, "step");
    remaking.reroll("den");
    await rest();
    editor.undo();
    remaking.reroll("hall");
    await answer();
    expect([rooms(), home.scene?.style]).toEqual([["den", "hall"], "edited,hall"]);
    remaking.reroll("den");
    editor.rotate(ONE, 90);
    editor.undo();
    await answer();
    await call(0).answer();
    expect([home.scene?.style, home.find(ONE)?.piece.rotation, home.canRedo]).toEqual(["edited,hall,den", 0, true]);
  });
});
