// @vitest-environment happy-dom
import { afterEach, describe, expect, it, vi } from "vitest";
import type { Asking } from "../src/asking";
import type { Scene } from "../src/contract";
import { Remaking } from "../src/edit/remaking";
import { bench, house, turn } from "./edit_bench";

interface Sent {
  readonly scene: Scene;
  readonly reroll?: readonly string[];
  readonly style?: string;
  readonly decorate?: boolean;
}

/** A home that is remade by a service that answers when told, its questions asked as the page asks them. */
function remade(asked: Asking) {
  const { home, editor } = bench();
  const [sent, answers]: [Sent[], (() => void)[]] = [[], []];
  vi.stubGlobal("fetch", (_: URL, { body, signal }: RequestInit) => new Promise((resolve, reject) => {
    const one = JSON.parse(String(body)) as Sent;
    sent.push(one);
    const scene = { ...one.scene, style: [one.scene.style, one.reroll, one.style, one.decorate].flat().filter(Boolean).join() };
    answers.push(() => resolve(new Response(JSON.stringify({ scene, issues: [], timing_ms: 1 }))));
    signal?.addEventListener("abort", () => reject(signal.reason as Error));
  }));
  const remaking = new Remaking(home, asked, { inTurn: (change) => editor.inTurn(change), read: () => Promise.resolve(), furnished: () => undefined });
  const answer = async (): Promise<void> => { answers.at(-1)?.(); await turn(); await turn(); };
  return { home, remaking, sent, answer };
}

/** Asks one question at a time, a newer one in place of the older. */
function asking(): Asking & { leave(): void } {
  let pending = new AbortController();
  const run = async (_: string, ask: (signal: AbortSignal) => Promise<void>): Promise<void> => {
    pending.abort();
    pending = new AbortController();
    await ask(pending.signal).catch((reason: unknown) => { if ((reason as Error).name !== "AbortError") throw reason; });
  };
  return { run, leave: () => pending.abort() } as unknown as Asking & { leave(): void };
}

describe("a home that is remade", () => {
  afterEach(() => { vi.unstubAllGlobals(); });

  it("has all that was wished meanwhile, each a step, in the order of the wishes", async () => {
    const { home, remaking, sent, answer } = remade(asking());
    remaking.reroll("den");
    remaking.reroll("hall");
    remaking.restyle({ decorate: true });
    remaking.restyle({ style: "rustic" });
    for (let time = 0; time < 3; time += 1) {
      await turn();
      await answer();
    }
    expect(home.scene?.style).toBe("den,hall,rustic,true");
    expect(sent.at(-1), "two wishes for one look are one").toMatchObject({ style: "rustic", decorate: true });
    home.undo();
    expect(home.scene?.style).toBe("den,hall");
  });

  it("has nothing of what was wished of another one, or before that was shown", async () => {
    const questions = asking();
    const { home, remaking, sent, answer } = remade(questions);
    remaking.reroll("den");
    await turn();
    questions.leave();
    await turn();
    home.show({ scene: house(), issues: [], conflicts: [], timing: 1 }, "new");
    remaking.reroll("hall");
    await turn();
    await answer();
    expect(sent.slice(1).map(({ reroll }) => reroll)).toEqual([["hall"]]);
    expect(home.scene?.style).toBe("hall");
  });
});
