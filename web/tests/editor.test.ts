import { describe, expect, it } from "vitest";
import type { Conflict } from "../src/contract";
import { Acts } from "../src/edit/acts";
import { bench, CRATE, house, ONE, OTHER, placing, pushed, turn } from "./edit_bench";
import { room, scene } from "./rooms";

const stuck: readonly Conflict[] = [{ ids: [ONE, OTHER], message: "10 cm short", repairs: [{ action: "leave_out", id: OTHER }] }] as const;

describe("a drag", () => {
  it("asks for its room alone, one question at a time, with where all stood last", async () => {
    const { editor, calls, call, home, at, said } = bench();
    expect(editor.lift(ONE)).toBe(true);
    for (const x of [1.2, 1.4, 1.6]) editor.drag({ x, z: 1 });
    expect(calls).toHaveLength(1);
    expect(call(0).request.scene.rooms.map(({ id }) => id)).toEqual(["den"]);
    expect(call(0).request).toMatchObject({ moved: [ONE], on_conflict: "report" });
    expect(call(0).request.previous?.find(({ id }) => id === OTHER)).toMatchObject({ x: 3, z: 2 });
    await call(0).answer(pushed(3.5));
    expect(at(OTHER)).toEqual([3.5, 2]);
    expect(home.settled?.scene).toEqual(house());
    expect(calls).toHaveLength(2);
    expect(call(1).request.scene.rooms[0]?.furniture[0]?.x).toBe(1.6);
    expect(call(1).request.scene.rooms[0]?.furniture[1]?.x).toBe(3);
    await call(1).answer(pushed(3.6));
    editor.drag({ x: 1.7, z: 1 });
    expect(call(2).request.previous?.find(({ id }) => id === OTHER)).toMatchObject({ x: 3.6 });
    expect([said.answered, said.lifted]).toEqual([2, 4]);
  });

  it("becomes one step when it is let go: the answer for the whole house", async () => {
    const { editor, call, at, said } = bench();
    editor.lift(ONE);
    editor.drag({ x: 2, z: 1 });
    await call(0).answer(pushed(3.5));
    editor.drop();
    editor.drag({ x: 5, z: 1 });
    expect(call(1).request.scene.rooms).toHaveLength(2);
    await call(1).answer(pushed(3.7));
    expect([at(ONE), at(OTHER)]).toEqual([[2, 1], [3.7, 2]]);
    expect([editor.busy, editor.dragged, said.settled, said.busy.at(-1)]).toEqual([false, null, 1, false]);
    editor.undo();
    expect([at(ONE), at(OTHER)]).toEqual([[1, 1], [3, 2]]);
    editor.redo();
    expect([at(ONE), at(OTHER)]).toEqual([[2, 1], [3.7, 2]]);
  });

  it("that is let go before the first answer shows only the last", async () => {
    const { editor, calls, call, at } = bench();
    editor.lift(ONE);
    editor.drag({ x: 2, z: 1 });
    editor.drop();
    expect(calls).toHaveLength(1);
    await call(0).answer(pushed(4));
    await call(1).answer(pushed(3.2));
    expect([at(ONE), at(OTHER), editor.busy]).toEqual([[2, 1], [3.2, 2], false]);
  });

  it("stays within its room", () => {
    const { editor, call } = bench();
    editor.lift(ONE);
    editor.drag({ x: 99, z: -99 });
    expect(call(0).request.scene.rooms[0]?.furniture[0]).toMatchObject({ x: 5.5, z: 0.5 });
  });

  it("that is refused says so, keeps what was shown, and ends where it began", async () => {
    const { editor, call, at, said, home } = bench();
    editor.lift(ONE);
    editor.drag({ x: 2, z: 1 });
    await call(0).answer(pushed(3.5));
    editor.drag({ x: 3, z: 2 });
    await call(1).answer(pushed(9), stuck);
    expect(at(OTHER)).toEqual([3.5, 2]);
    expect(said.refused.at(-1)).toMatchObject({ live: true, conflicts: stuck });
    editor.drop();
    await call(2).answer(pushed(9), stuck);
    expect([at(ONE), at(OTHER), home.canUndo]).toEqual([[1, 1], [3, 2], false]);
    expect(said.refused.at(-1)).toMatchObject({ live: false, conflicts: stuck });
  });

  it("that is given up ends where it began, whatever is answered later", async () => {
    const { editor, call, at, said, calls } = bench();
    editor.lift(ONE);
    editor.drag({ x: 2, z: 1 });
    editor.drag({ x: 3, z: 1 });
    editor.cancel();
    expect(call(0).signal.aborted).toBe(true);
    await call(0).answer(pushed(4));
    expect([at(ONE), at(OTHER), editor.busy, said.settled, calls.length]).toEqual([[1, 1], [3, 2], false, 1, 1]);
    expect(editor.lift(OTHER)).toBe(true);
  });

  it("goes on in the hand when the service is lost, and let go ends where it began, which is said once; tried again, it is one step", async () => {
    const { home, editor, call, calls, at, said } = bench();
    editor.lift(ONE);
    editor.drag({ x: 2, z: 1 });
    await call(0).answer(pushed(3.5));
    editor.drag({ x: 2.5, z: 1 });
    await call(1).lose();
    expect([editor.dragged, at(OTHER), said.failed.length]).toEqual([ONE, [3.5, 2], 0]);
    editor.drag({ x: 3, z: 1 });
    editor.drop();
    await call(2).lose();
    expect([at(ONE), at(OTHER), editor.busy, said.failed.length]).toEqual([[1, 1], [3, 2], false, 1]);
    said.again[0]?.();
    await turn();
    await call(3).lose();
    expect([at(ONE), said.failed.length]).toEqual([[1, 1], 2]);
    said.again[1]?.();
    await turn();
    await call(4).answer(pushed(3.5));
    expect([at(ONE), at(OTHER), home.steps.length]).toEqual([[3, 1], [3.5, 2], 2]);
    said.again[1]?.(); // the home is another by now
    await turn();
    expect([calls.length, editor.busy]).toEqual([5, false]);
  });

  it("takes nothing that is locked or not there, nor a second piece", () => {
    const { editor } = bench();
    expect([editor.lift("den/held"), editor.lift("den/none")]).toEqual([false, false]);
    expect([editor.lift(ONE), editor.lift(OTHER), editor.dragged]).toEqual([true, false, ONE]);
  });

  it("ends with another house, which stays as it came", async () => {
    const { editor, call, home } = bench();
    editor.lift(ONE);
    editor.drag({ x: 2, z: 1 });
    const next = { scene: scene([room("new", [0, 0, 3, 3])]), issues: [], conflicts: [], timing: 1 };
    home.show(next, "new");
    editor.forget();
    await call(0).answer();
    expect([home.shown, editor.dragged]).toEqual([next, null]);
  });
});

describe("single edits", () => {
  it("are asked one after the other, each of what the one before left", async () => {
    const { editor, calls, call, home } = bench();
    editor.rotate(ONE, 90);
    await turn();
    editor.rotate(ONE, 90);
    await turn();
    expect(calls).toHaveLength(1);
    expect(call(0).request.previous?.find(({ id }) => id === OTHER)).toMatchObject({ x: 3, z: 2 });
    await call(0).answer();
    await call(1).answer();
    expect(home.find(ONE)?.piece.rotation).toBe(180);
    editor.undo();
    expect(home.find(ONE)?.piece.rotation).toBe(90);
  });

  it("add up the steps and turns of one piece while one is under way", async () => {
    const { editor, calls, call, at, home } = bench();
    editor.rotate(OTHER, 90);
    for (const dx of [0.05, 0.05, 0.05]) editor.nudge(ONE, dx, 0);
    for (let i = 0; i < 30; i += 1) editor.rotate(ONE, -90);
    await turn();
    await call(0).answer();
    await call(1).answer();
    expect([calls.length, at(ONE)[0], home.find(ONE)?.piece.rotation]).toEqual([2, 1.15, 180]);
  });

  it("do not add up over another edit, and undo waits for its turn", async () => {
    const { editor, calls, call, home } = bench();
    editor.rotate(OTHER, 90);
    editor.rotate(ONE, 90);
    editor.toggleLock(OTHER);
    editor.rotate(ONE, 90);
    editor.undo();
    await turn();
    for (let i = 0; i < 4; i += 1) await call(i).answer();
    expect([calls.length, home.find(ONE)?.piece.rotation, home.find(OTHER)?.piece.locked]).toEqual([4, 90, true]);
    expect([home.canRedo, editor.busy]).toEqual([true, false]);
  });

  it("of a house that is gone are not done to the next, whose pieces have the same ids", async () => {
    const { editor, calls, call, home, said } = bench();
    editor.rotate(ONE, 90);
    editor.remove(OTHER);
    await turn();
    home.show({ scene: house(), issues: [], conflicts: [], timing: 1 }, "new");
    editor.forget();
    await call(0).answer();
    expect([calls.length, home.find(OTHER)?.piece.x, home.find(ONE)?.piece.rotation, home.canUndo]).toEqual([1, 3, 0, false]);
    editor.remove(OTHER);
    await turn();
    await call(1).answer();
    expect([home.find(OTHER), said.busy.at(-1), said.failed]).toEqual([null, false, []]);
  });

  it("of a house that is gone are waited for by none of the next", async () => {
    const { editor, call, at, home, said } = bench();
    editor.nudge(ONE, 0.5, 0);
    await turn();
    home.show({ scene: house(), issues: [], conflicts: [], timing: 1 }, "new");
    editor.forget();
    expect([editor.busy, said.busy.at(-1), editor.lift(ONE)]).toEqual([false, false, true]);
    editor.cancel();
    editor.nudge(OTHER, 0.5, 0);
    await turn();
    await call(0).answer();
    expect([editor.busy, said.busy.at(-1), at(ONE)]).toEqual([true, true, [1, 1]]);
    await call(1).answer();
    expect([editor.busy, said.busy.at(-1), at(OTHER)]).toEqual([false, false, [3.5, 2]]);
  });

  it("whose answer does not come are given up once another home is shown, which is said, and hold up nothing there", async () => {
    const { editor, call, calls, said, home, at } = bench();
    editor.remove(ONE);
    editor.rotate(OTHER, 90);
    await turn();
    home.show({ scene: house(), issues: [], conflicts: [], timing: 1 }, "new");
    editor.forget();
    expect([call(0).signal.aborted, said.givenUp, editor.busy]).toEqual([true, 1, false]);
    call(0).withdrawn();
    await turn();
    expect([calls.length, said.failed, at(ONE)]).toEqual([1, [], [1, 1]]);
    editor.nudge(OTHER, 0.5, 0);
    await turn();
    await call(1).answer();
    expect(at(OTHER)).toEqual([3.5, 2]);
    editor.forget();
    expect(said.givenUp).toBe(1);
  });

  it("wait for other changes in their turn, and those for them", async () => {
    const { editor, calls, call } = bench();
    const done: string[] = [];
    let end = (): void => undefined;
    editor.rotate(ONE, 90);
    const first = editor.inTurn(async () => { done.push("begun"); await new Promise<void>((resolve) => { end = resolve; }); throw new Error("lost"); });
    editor.rotate(OTHER, 90);
    await turn();
    expect([calls.length, done]).toEqual([1, []]);
    await call(0).answer();
    expect([calls.length, done, editor.lift(ONE)]).toEqual([1, ["begun"], false]);
    end();
    await expect(first).rejects.toThrow("lost");
    await turn();
    await call(1).answer();
    expect([calls.length, editor.busy]).toEqual([2, false]);
  });

  it("wait for a piece that was let go to be judged, and a drop that is taken back holds up nothing", async () => {
    const { editor, calls, call, home, at, said } = bench();
    editor.lift(ONE);
    editor.drag({ x: 2, z: 1 });
    editor.drop();
    editor.remove(OTHER);
    await turn();
    expect(calls).toHaveLength(1);
    await call(0).answer();
    await call(1).answer();
    expect([at(ONE)[0], home.find(OTHER)?.piece.id]).toEqual([2, OTHER]);
    await call(2).answer();
    expect([home.find(OTHER), at(ONE)[0], said.busy.at(-1), editor.busy]).toEqual([null, 2, false, false]);
    editor.undo();
    editor.undo();
    expect([home.find(OTHER)?.piece.id, at(ONE)[0]]).toEqual([OTHER, 1]);
    editor.lift(ONE);
    editor.drag({ x: 3, z: 1 });
    editor.drop();
    editor.cancel();
    editor.remove(OTHER);
    await turn();
    expect([at(ONE)[0], editor.dragged]).toEqual([1, null]);
    await call(calls.length - 1).answer();
    expect([home.find(OTHER), editor.busy]).toEqual([null, false]);
  });

  it("that leave out what was never put in ask nothing", async () => {
    const { editor, calls, call, said, home } = bench();
    placing(editor).add(["den"], CRATE);
    await turn();
    await call(0).answer((sent) => sent, [{ ids: ["den/crate_1"], message: "short", repairs: [] }]);
    await call(1).answer((sent) => sent, [{ ids: ["den/crate_1"], message: "short", repairs: [{ action: "leave_out", id: "den/crate_1" }] }]);
    const refusal = said.refused.at(-1);
    const repair = refusal?.conflicts[0]?.repairs[0];
    if (!refusal || !repair) throw new Error("no repair was offered");
    editor.take(refusal, repair);
    await turn();
    expect([calls.length, home.canUndo, said.refused.at(-1)]).toEqual([2, false, null]);
  });

  it("that are refused change nothing, and a repair of theirs is asked of what was sent", async () => {
    const { editor, call, home, said, at } = bench();
    editor.rotate(ONE, 90);
    await turn();
    await call(0).answer(pushed(9), stuck);
    expect([at(OTHER), home.canUndo]).toEqual([[3, 2], false]);
    const refusal = said.refused.at(-1);
    const repair = refusal?.conflicts[0]?.repairs[0];
    if (!refusal || !repair) throw new Error("no repair was offered");
    editor.take(refusal, repair);
    await turn();
    await call(1).answer();
    expect([home.find(OTHER), home.find(ONE)?.piece.rotation, said.refused.at(-1)]).toEqual([null, 90, null]);
  });

  it("lock and unlock, leave what is locked alone, and take away", async () => {
    const { editor, call, calls, home } = bench();
    editor.toggleLock(ONE);
    await turn();
    await call(0).answer();
    expect(home.locked).toEqual(new Set([ONE, "den/held"]));
    editor.rotate(ONE, 90);
    editor.remove(ONE);
    await turn();
    expect([calls.length, editor.busy]).toEqual([1, false]);
    editor.remove(OTHER);
    await turn();
    await call(1).answer();
    expect(home.find(OTHER)).toBeNull();
  });

  it("of what is locked, and of nothing else, are refused with why and an unlocking, which asks for no move", async () => {
    const { editor, call, calls, home, said } = bench();
    const acts = new Acts(home, editor, (one) => Promise.resolve(one));
    home.choose(["den/held"]);
    for (const act of [() => acts.nudge(0.05, 0), () => acts.turn(90), () => acts.remove()]) {
      act();
      const refusal = said.refused.pop();
      expect(refusal?.conflicts.map(({ ids, message }) => [ids, message])).toEqual([[["den/held"], "the held is locked: it stays where it is"]]);
    }
    await turn();
    expect([calls.length, said.refused.length]).toEqual([0, 0]);
    acts.turn(90);
    const refusal = said.refused.pop();
    if (refusal?.conflicts[0]?.repairs[0]) editor.take(refusal, refusal.conflicts[0].repairs[0]);
    await turn();
    expect(call(0).request.moved).toEqual([]);
    await call(0).answer();
    expect([home.locked.size, home.find("den/held")?.piece.x]).toEqual([0, 5]);
    acts.turn(90);
    await turn();
    expect(call(1).request.moved).toEqual(["den/held"]);
  });

  it("of several, one of which is locked, change the others and say nothing", async () => {
    const { editor, call, home, said } = bench();
    home.choose(["den/held", ONE]);
    new Acts(home, editor, (one) => Promise.resolve(one)).nudge(0.05, 0);
    await turn();
    expect(call(0).request.moved).toEqual([ONE]);
    expect(said.refused.filter((refusal) => refusal !== null)).toEqual([]);
  });

  it("do not begin while a piece is in hand, and undo waits for what is under way", async () => {
    const { editor, calls, home } = bench();
    editor.lift(ONE);
    editor.rotate(OTHER, 90);
    await turn();
    expect(calls).toHaveLength(0);
    editor.cancel();
    editor.rotate(OTHER, 90);
    await turn();
    await calls[0]?.answer();
    editor.lift(ONE);
    editor.undo();
    expect(home.find(OTHER)?.piece.rotation).toBe(90);
  });
});
