import { describe, expect, it } from "vitest";
import type { Furniture } from "../src/contract";
import { bench, CRATE, ONE, OTHER, placing, turn } from "./edit_bench";
import { piece } from "./rooms";

const NEW = "den/crate_1";

describe("a new piece", () => {
  it("for which no place is found goes beside the others if they can stay, else makes them give way", async () => {
    const { editor, call, home } = bench();
    placing(editor).add("den", CRATE);
    await turn();
    expect(call(0).request.locked).toEqual([ONE, OTHER, "den/held"]);
    await call(0).answer((sent) => sent, [{ ids: [NEW, ONE], message: "short", repairs: [] }]);
    expect(call(1).request.locked).toBeUndefined();
    await call(1).answer();
    expect([home.find(NEW)?.room.id, home.selected]).toEqual(["den", NEW]);
  });

  it("whose place is asked for is an edit under way, and what is asked meanwhile comes after it", async () => {
    const { editor, call, calls, home, at, said } = bench();
    let answer: (pieces: readonly Furniture[]) => void = () => undefined;
    placing(editor, () => new Promise((resolve) => { answer = resolve; })).add("den", CRATE);
    editor.nudge(ONE, 0.5, 0);
    await turn();
    expect([calls.length, editor.busy, said.busy]).toEqual([0, true, [true, true]]);
    answer([piece(NEW, { x: 5, z: 1 })]);
    await turn();
    expect([at(NEW), editor.busy]).toEqual([[NaN, NaN], true]);
    await call(0).answer();
    await call(1).answer();
    expect([at(NEW), at(ONE), editor.busy, said.busy.at(-1)]).toEqual([[5, 1], [1.5, 1], false, false]);
    home.undo();
    home.undo();
    expect([at(NEW), at(ONE)]).toEqual([[NaN, NaN], [1, 1]]);
  });

  it("flipped to another place leaves what was moved meanwhile where it is", async () => {
    const { editor, call, at } = bench();
    const places = placing(editor, () => Promise.resolve([piece(NEW, { x: 5, z: 1 })]));
    places.add("den", CRATE);
    await turn();
    await call(0).answer();
    editor.nudge(ONE, 0.5, 0);
    await turn();
    await call(1).answer();
    places.flip(1);
    await turn();
    expect(call(2).request.locked).toEqual([ONE, OTHER, "den/held"]);
    await call(2).answer();
    expect([at(NEW), at(ONE)]).toEqual([[5, 1], [1.5, 1]]);
  });

  it("of which nobody can say where it goes is said to have failed", async () => {
    const { editor, said, calls } = bench();
    placing(editor, () => Promise.reject(new Error("lost"))).add("den", CRATE);
    await turn();
    expect([said.failed.length, calls.length, editor.busy]).toEqual([1, 0, false]);
  });
});
