// @vitest-environment happy-dom
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Asking } from "../src/asking";
import { Progress } from "../src/panel/progress";
import { exportFormats, LOST, problemFrom } from "../src/service";

/** The page's places, and something that ends when it is told to. */
function page() {
  document.body.innerHTML = '<main></main><div id="bar"><span></span></div>'
    + '<div id="notice"><b class="notice-title"></b><i class="notice-detail"></i><form class="notice-key"><input></form><button class="notice-again"></button><button class="notice-close"></button></div>';
  const [stage, bar, notice] = ["main", "#bar", "#notice"].map((one) => document.querySelector<HTMLElement>(one) as HTMLElement) as [HTMLElement, HTMLElement, HTMLElement];
  const progress = new Progress(bar, stage);
  const seen = (): readonly (string | null)[] => [stage.getAttribute("aria-busy"), bar.getAttribute("aria-label"), bar.hidden ? null : bar.textContent];
  return { asking: new Asking(notice, progress), progress, notice, seen };
}

function held() {
  let [end, fail]: [() => void, (reason: unknown) => void] = [() => undefined, () => undefined];
  let times = 0;
  const act = (): Promise<void> => new Promise((resolve, reject) => { [end, fail, times] = [resolve, reject, times + 1]; });
  return { act, end: () => end(), fail: (reason: unknown) => fail(reason), times: () => times };
}

describe("what is under way", () => {
  beforeEach(() => { vi.useFakeTimers(); });
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it("is the newer question, however the older one ends", async () => {
    const { asking, seen } = page();
    const [first, second] = [held(), held()];
    const one = asking.run("first", first.act);
    const other = asking.run("second", second.act);
    expect(seen()).toEqual(["true", "second", null]);
    first.end();
    await one;
    expect(seen()).toEqual(["true", "second", null]);
    vi.advanceTimersByTime(2000);
    expect(seen()).toEqual(["true", "second", "second… 2 s"]);
    second.end();
    await other;
    expect(seen()).toEqual(["false", "second", null]);
  });

  it("is a file beside a question, written once however often it is asked for, and neither ends the other", async () => {
    const { asking, seen } = page();
    const [question, file] = [held(), held()];
    const written = asking.beside("file", file.act);
    await asking.beside("file", file.act);
    expect(file.times()).toBe(1);
    expect(seen()[2], "which is said at once").toBe("file… 0 s");
    const answered = asking.run("question", question.act);
    expect(seen().slice(0, 2)).toEqual(["true", "file"]);
    file.end();
    await written;
    expect(seen().slice(0, 2)).toEqual(["true", "question"]);
    question.end();
    await answered;
    expect(seen()[0]).toBe("false");
    void asking.beside("file", file.act);
    expect(file.times()).toBe(2);
  });

  it("is a file of each home that it was asked for of", async () => {
    const { asking } = page();
    const file = held();
    for (const home of [1, 2, 2]) void asking.beside("file", file.act, home);
    expect(file.times()).toBe(2);
  });

  it("is said to have failed, is tried again where that is wished, and takes back what was said of itself alone", async () => {
    const { asking, notice } = page();
    const [file, other] = [held(), held()];
    notice.hidden = true;
    const written = asking.beside("file", file.act);
    file.fail(new Error("gone"));
    await written;
    expect([notice.hidden, notice.querySelector<HTMLElement>(".notice-again")?.hidden]).toEqual([false, false]);
    for (const [what, of] of [["other", undefined], ["file", "another home"]] as const) {
      const beside = asking.beside(what, other.act, of);
      other.end();
      await beside;
      expect(notice.hidden, "not what the other said").toBe(false);
    }
    notice.querySelector<HTMLElement>(".notice-again")?.click();
    expect(file.times()).toBe(2);
    file.end();
    await vi.advanceTimersByTimeAsync(0);
    expect(notice.hidden).toBe(true);
  });

  it("is told beside what else was refused, and all of it is done again, each until it is done", async () => {
    const { asking, notice } = page();
    const [question, file, other] = [held(), held(), held()];
    const fails = [[asking.run("question", question.act), question, 503], [asking.beside("file", file.act), file, 503], [asking.beside("other", other.act), other, 422]] as const;
    for (const [done, one, status] of fails) {
      one.fail(problemFrom(status, { title: `no ${one === question ? "home" : one === file ? "file" : "other"}`, detail: "why", errors: status === 422 ? [{ field: "a", problem: "b", allowed: "c" }] : [] }));
      await done;
    }
    const told = (): string => [".notice-title", ".notice-detail"].map((one) => notice.querySelector(one)?.textContent).join(" ");
    const has = (): boolean[] => ["no home", "no file", "no other"].map((one) => told().includes(one));
    expect(has()).toEqual([true, true, true]);
    notice.querySelector<HTMLElement>(".notice-again")?.click();
    expect([question.times(), file.times(), other.times()], "a wrong field would be refused again").toEqual([2, 2, 1]);
    file.fail(problemFrom(503, { title: "no file", detail: "why" }));
    await vi.advanceTimersByTimeAsync(0);
    expect(has()).toEqual([false, true, true]);
    const written = asking.beside("file", file.act);
    file.end();
    await written;
    expect(has()).toEqual([false, false, true]);
  });

  it.each([["it is told", null], ["another thing is told", "other"]])("asks again for what did not come, once the service answers anything, as %s", async (_, other) => {
    const { asking, notice } = page();
    let [asked, isThere] = [0, false];
    vi.stubGlobal("fetch", async () => new Response('{"formats":[]}', { status: isThere ? 200 : 503 }));
    const call = (): Promise<unknown> => exportFormats(new AbortController().signal);
    asking.missed(new Error("gone"), () => { asked += 1; });
    if (other !== null) await asking.beside(other, async () => { await call(); });
    await vi.advanceTimersByTimeAsync(1);
    expect([asked, notice.hidden]).toEqual([0, false]);
    isThere = true;
    for (const _again of [1, 2]) await call();
    await vi.advanceTimersByTimeAsync(1);
    expect([asked, notice.hidden], "and what was said of it goes, of it alone").toEqual([1, other === null]);
  });

  it.each([[422, false], [404, false], [401, true], [429, true], [503, true], [0, true]])("asks with each answer once for what did not come, and no more for what is refused: %i", async (status, mayCome) => {
    const { asking, notice } = page();
    let asked = 0;
    vi.stubGlobal("fetch", async () => new Response('{"formats":[]}'));
    const ask = (): void => { asked += 1; asking.missed(problemFrom(status, null), ask); };
    asking.missed(problemFrom(status, null), ask);
    for (const again of [true, false, false]) {
      if (again) notice.querySelector<HTMLElement>(".notice-again")?.click(); // what waits is not asked for twice
      notice.hidden = true;
      const before = asked;
      await exportFormats(new AbortController().signal);
      await vi.advanceTimersByTimeAsync(1);
      expect([asked - before, notice.hidden]).toEqual(mayCome ? [1, false] : [0, true]);
    }
  });

  it.each([[503, 0], [0, 1]])("does not come back to what was refused by %i and closed, unless nobody was there to refuse it", async (status, again) => {
    const { asking, notice } = page();
    let asked = 0;
    vi.stubGlobal("fetch", async () => new Response('{"formats":[]}'));
    asking.missed(status === 0 ? LOST : problemFrom(status, null), () => { asked += 1; });
    notice.querySelector<HTMLElement>(".notice-close")?.click();
    await exportFormats(new AbortController().signal);
    await vi.advanceTimersByTimeAsync(1);
    expect([asked, notice.hidden]).toEqual([again, true]);
  });

  it("tells itself of edits, whatever is told twice", () => {
    const { progress, seen } = page();
    for (const isOn of [true, true, false]) {
      progress.turn("edit", isOn);
      expect(seen()[0]).toBe(String(isOn));
    }
  });
});
