import { describe, expect, it, vi } from "vitest";
import type { Scene } from "../src/contract";
import type { Frames } from "../src/edit/frames";
import { bench, house, ONE, OTHER, pushed, turn } from "./edit_bench";

/** Frames that the page answers: the neighbour goes on by a tenth each time, up to a place. */
class Page implements Frames {
  asked = 0;
  constructor(readonly upTo: number, readonly broken = false) {}

  frame(wished: Scene): Promise<Scene | null> {
    this.asked += 1;
    if (this.broken) return Promise.reject(new Error("a trap"));
    return Promise.resolve(this.upTo === 0 ? null : pushed(Math.min(this.upTo, 3 + 0.1 * this.asked))(wished));
  }
}

describe("a drag with the core in the page", () => {
  vi.stubGlobal("requestAnimationFrame", (act: () => void) => setTimeout(act, 0));
  const rest = async (): Promise<void> => { for (let k = 0; k < 40; k += 1) await turn(); };

  it("asks the service for nothing until it is let go", async () => {
    const page = new Page(3.1);
    const { editor, calls, call, at, home } = bench(page);
    editor.lift(ONE);
    await turn();
    editor.drag({ x: 1.2, z: 1 });
    await rest();
    expect([calls.length, at(OTHER)]).toEqual([0, [3.1, 2]]);
    expect(home.settled?.scene).toEqual(house());
    editor.drop();
    expect(call(0).request.dragging).toBeUndefined();
    expect(call(0).request.scene.rooms).toHaveLength(2);
    expect(call(0).request.previous?.find(({ id }) => id === OTHER)).toMatchObject({ x: 3.1 });
  });

  it("goes on until nothing moves any more, and no longer", async () => {
    const page = new Page(3.5);
    const { editor, at } = bench(page);
    editor.lift(ONE);
    await turn();
    editor.drag({ x: 1.2, z: 1 });
    await rest();
    expect(at(OTHER)).toEqual([3.5, 2]);
    expect(page.asked).toBe(6);
  });

  it("says so where no place is known, and offers nothing", async () => {
    const { editor, said, at } = bench(new Page(0));
    editor.lift(ONE);
    await turn();
    editor.drag({ x: 1.2, z: 1 });
    await rest();
    expect(said.refused.at(-1)).toMatchObject({ live: true, conflicts: [{ ids: [ONE], repairs: [] }] });
    expect(at(OTHER)).toEqual([3, 2]);
  });

  it("asks the service where the core fails, and never the core again", async () => {
    const page = new Page(3.1, true);
    const { editor, calls, call } = bench(page);
    editor.lift(ONE);
    await turn();
    editor.drag({ x: 1.2, z: 1 });
    await turn();
    expect(call(0).request).toMatchObject({ dragging: true, moved: [ONE] });
    await call(0).answer();
    editor.drag({ x: 1.3, z: 1 });
    await turn();
    expect([page.asked, calls.length]).toEqual([1, 2]);
  });
});
