import { describe, expect, it } from "vitest";
import { Live } from "../src/edit/live";

/** A service that answers when it is told to. */
function slow() {
  const calls: { question: number; signal: AbortSignal; resolve: (answer: string) => void; reject: (reason: unknown) => void }[] = [];
  const told: string[] = [];
  const failures: unknown[] = [];
  const live = new Live<number, string>({
    ask: (question, signal) => new Promise((resolve, reject) => { calls.push({ question, signal, resolve, reject }); }),
    answered: (answer) => told.push(answer),
    failed: (reason) => failures.push(reason),
  });
  return { calls, told, failures, live };
}

const turn = (): Promise<void> => new Promise((resolve) => { setTimeout(resolve, 0); });

describe("live questions", () => {
  it("has one in flight, and sends only the newest of those that waited", async () => {
    const { calls, told, live } = slow();
    for (const question of [1, 2, 3, 4]) live.want(question);
    expect(calls.map(({ question }) => question)).toEqual([1]);
    calls[0]?.resolve("one");
    await turn();
    expect(calls.map(({ question }) => question)).toEqual([1, 4]);
    calls[1]?.resolve("four");
    await turn();
    expect(told).toEqual(["one", "four"]);
    expect(live.busy).toBe(false);
  });

  it("tells nothing of what was in flight when it was stopped", async () => {
    const { calls, told, failures, live } = slow();
    live.want(1);
    live.want(2);
    live.stop();
    calls[0]?.resolve("late");
    await turn();
    expect([told, failures]).toEqual([[], []]);
    expect(calls).toHaveLength(1);
    live.want(3);
    expect(calls.map(({ question }) => question)).toEqual([1, 3]);
  });

  it("drops what waits when a question fails, says so once, and can be asked again", async () => {
    const { calls, failures, live } = slow();
    live.want(1);
    live.want(2);
    calls[0]?.reject("lost");
    await turn();
    expect(failures).toEqual(["lost"]);
    expect(calls).toHaveLength(1);
    live.want(3);
    expect(calls.map(({ question }) => question)).toEqual([1, 3]);
  });
});
