import { expect, it } from "vitest";
import type { FixAnswer, GenerateAnswer, Scene } from "../src/contract";
import { reshaped, withRoom, type Draft } from "../src/draw/draft";
import { Reflow } from "../src/draw/reflow";
import { draftOf } from "../src/draw/scene_draft";
import { piece, room, scene } from "./rooms";

const den = () => draftOf(scene([room("den", [0, 0, 6, 3], { furniture: [piece("sofa", { x: 5, z: 0.5 })] })]));
const cut = (draft: Draft) => reshaped(draft, "den", { x0: 4000, z0: 0, x1: 6000, z1: 3000 }, "cut") as Draft;
const parted = (draft: Draft) => (withRoom(draft, [{ x: 4000, z: 0 }, { x: 6000, z: 0 }, { x: 6000, z: 3000 }, { x: 4000, z: 3000 }]) as { draft: Draft }).draft;

/** A reflow whose questions are answered when one says so; the sofa then stands where it is told to, in a room of the width that is told. */
function asked() {
  const [furnished, settled, failed]: [(readonly string[])[], Draft[], unknown[]] = [[], [], []];
  const waiting: (() => void)[] = [];
  const fix = (request: { scene: Scene }, signal: AbortSignal) => new Promise<FixAnswer>((done, fail) => {
    waiting.push(() => (signal.aborted ? fail(new Error("given up")) : done({ scene: request.scene } as FixAnswer)));
  });
  let width: number | null = null;
  const furnish = async (given: Scene, rooms: readonly string[]) => {
    furnished.push(rooms);
    const inside = given.rooms.map((one) => ({ ...one, width: one.id === "den" && width !== null ? width : one.width, furniture: one.furniture.map((sofa) => ({ ...sofa, x: 1 })) }));
    return { scene: { ...given, rooms: inside } } as unknown as GenerateAnswer;
  };
  const reflow = new Reflow({ fix, furnish }, { seen: () => undefined, settled: (_of, becomes) => settled.push(becomes), failed: (reason) => failed.push(reason) });
  const answer = async () => {
    for (const one of waiting.splice(0)) one();
    for (let turn = 0; turn < 9; turn += 1) await Promise.resolve();
  };
  return { reflow, answer, furnished, settled, failed, answerIn: (metres: number) => { width = metres; } };
}

it("furnishes a room that a step has changed, also where the next step came before the answer", async () => {
  const { reflow, answer, furnished, settled, failed } = asked();
  const first = cut(den());
  void reflow.step(first);
  const second = parted(first);
  void reflow.step(second);
  await answer();
  expect([furnished, failed]).toEqual([[["den"]], []]);
  expect(settled.map(({ rooms }) => rooms.map(({ id, from }) => [id, from?.furniture[0]?.x]))).toEqual([[["den", 1], ["room_1", undefined]]]);
  void reflow.step(settled[0] as Draft);
  await answer();
  expect(furnished).toHaveLength(1);
});

it("asks nothing for a step back to what was furnished", async () => {
  const { reflow, answer, furnished, settled, failed } = asked();
  void reflow.step(cut(den()));
  void reflow.step(den());
  await answer();
  expect([furnished, settled, failed]).toEqual([[], [], []]);
});

it("takes no answer in which the room has another shape than it was drawn in", async () => {
  const { reflow, answer, answerIn, settled } = asked();
  answerIn(3);
  void reflow.step(cut(den()));
  await answer();
  expect(settled).toEqual([]);
});
