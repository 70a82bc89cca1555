// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import type { Furniture } from "../src/contract";
import { Places } from "../src/edit/places";
import { bench, CRATE, ONE, OTHER, placing, turn } from "./edit_bench";
import { piece } from "./rooms";

const NEW = "den/crate_1";

describe("a new piece", () => {
  it("for which no place is found goes beside the others if they can stay, else makes them give way", async () => {
    const { editor, call, home } = bench();
    placing(editor).add(["den"], CRATE);
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
    placing(editor, () => new Promise((resolve) => { answer = resolve; })).add(["den"], CRATE);
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
    places.add(["den"], CRATE);
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

  it("goes to the first of rooms that has a place for it, and where none has says that it only finds room", async () => {
    const asked: string[] = [];
    const host = document.createElement("section");
    const { editor, call, home, at } = bench();
    const places = new Places(host, editor, (_, room) => {
      asked.push(room);
      return Promise.resolve(room === "hall" && asked.length === 2 ? [piece("hall/crate_1", { x: 1, z: 1 })] : []);
    });
    home.on("shown", () => { places.shown(home.scene); });
    places.add(["den", "hall"], CRATE);
    await turn();
    expect([asked, call(0).request.scene.rooms.map(({ furniture }) => furniture.some(({ id }) => id === "hall/crate_1"))]).toEqual([["den", "hall"], [false, true]]);
    await call(0).answer();
    expect([at("hall/crate_1"), host.hidden]).toEqual([[1, 1], true]);
    places.add(["den", "hall"], CRATE);
    await turn();
    expect([asked, host.hidden]).toEqual([["den", "hall", "den", "hall"], true]);
    await call(1).answer();
    expect([home.find(NEW)?.room.id, host.hidden, host.textContent]).toEqual(["den", false, expect.stringMatching(/^No place where it belongs is free/)]);
    home.undo();
    expect(host.hidden).toBe(true);
  });

  it("of which nobody can say where it goes is said to have failed", async () => {
    const { editor, said, calls } = bench();
    placing(editor, () => Promise.reject(new Error("lost"))).add(["den"], CRATE);
    await turn();
    expect([said.failed.length, calls.length, editor.busy]).toEqual([1, 0, false]);
  });
});
