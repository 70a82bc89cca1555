// @vitest-environment happy-dom
import { expect, it, vi } from "vitest";
import type { Catalog, FixAnswer, GenerateAnswer, Scene } from "../src/contract";
import { Board, type Drawn } from "../src/draw/board";
import { reshaped, withoutRoom, withRoom, type Draft } from "../src/draw/draft";
import { leftOutWords, lostWords } from "../src/draw/lost";
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
    waiting.push(() => (signal.aborted || refuses ? fail(new Error("given up")) : done({ scene: request.scene } as FixAnswer)));
  });
  let [width, refuses]: [number | null, boolean] = [null, false];
  const furnish = async (given: Scene, rooms: readonly string[]) => {
    furnished.push(rooms);
    const inside = given.rooms.map((one) => ({ ...one, width: one.id === "den" && width !== null ? width : one.width, furniture: one.furniture.map((sofa) => ({ ...sofa, x: 1 })) }));
    return { scene: { ...given, rooms: inside } } as unknown as GenerateAnswer;
  };
  const reflow = new Reflow({ fix, furnish }, { seen: () => undefined, settled: (_of, becomes) => settled.push(becomes) });
  const step = (draft: Draft) => void reflow.step(draft).catch((reason: unknown) => failed.push(reason));
  const answer = async () => {
    for (const one of waiting.splice(0)) one();
    for (let turn = 0; turn < 9; turn += 1) await Promise.resolve();
    refuses = false;
  };
  return { step, refuse: () => { refuses = true; }, answer, furnished, settled, failed, answerIn: (metres: number) => { width = metres; } };
}

it("furnishes a room that a step has changed, also where the next step came before the answer", async () => {
  const { step, answer, furnished, settled, failed } = asked();
  const first = cut(den());
  step(first);
  const second = parted(first);
  step(second);
  await answer();
  expect([furnished, failed]).toEqual([[["den"]], []]);
  expect(settled.map(({ rooms }) => rooms.map(({ id, from }) => [id, from?.furniture[0]?.x]))).toEqual([[["den", 1], ["room_1", undefined]]]);
  step(settled[0] as Draft);
  await answer();
  expect(furnished).toHaveLength(1);
});

it("asks nothing for a step back to what was furnished", async () => {
  const { step, answer, furnished, settled, failed } = asked();
  step(cut(den()));
  step(den());
  await answer();
  expect([furnished, settled, failed]).toEqual([[], [], []]);
});

it("takes no answer in which the room has another shape than it was drawn in", async () => {
  const { step, answer, answerIn, settled } = asked();
  answerIn(3);
  step(cut(den()));
  await answer();
  expect(settled).toEqual([]);
});

it("waits for what was asked of the same step, and asks once more where that failed", async () => {
  const { step, answer, furnished, failed, refuse } = asked();
  const first = cut(den());
  refuse();
  step(first);
  step(first);
  await answer();
  expect([furnished.length, failed.length]).toEqual([0, 2]);
  step(first);
  await answer();
  expect([furnished.length, failed.length]).toEqual([1, 2]);
});

it("tells what is left out of a room for want of room, and what goes with a room", () => {
  const before = den();
  const [room] = before.rooms;
  const emptied = { ...before, rooms: before.rooms.map((one) => ({ ...one, from: one.from && { ...one.from, furniture: [] } })) };
  expect(leftOutWords(before, emptied)).toBe("Left out for want of room: sofa; undo brings back what stood here.");
  expect([leftOutWords(before, before), leftOutWords(emptied, before)]).toEqual(["", ""]);
  expect(lostWords(before, withoutRoom(before, room?.id ?? ""))).toBe("Bedroom is gone, and all that stood in it; undo brings it back.");
  expect([lostWords(emptied, withoutRoom(emptied, room?.id ?? "")), lostWords(before, parted(cut(before)))]).toEqual(["", ""]);
});

it("is shown arranged, and not at all once it was drawn on meanwhile", async () => {
  vi.stubGlobal("ResizeObserver", class { observe(): void {} });
  vi.stubGlobal("Option", function option(textContent: string, value: string) { return Object.assign(document.createElement("option"), { textContent, value }); });
  const [shown, host]: [Drawn[], HTMLElement] = [[], document.body.appendChild(document.createElement("div"))];
  const [sent, waiting]: [Scene[], (() => void)[]] = [[], []];
  const board = new Board(host, {
    catalog: () => Promise.resolve({ furniture: {} } as unknown as Catalog),
    validate: () => new Promise(() => undefined),
    fix: ({ scene: given }) => new Promise((done) => waiting.push(() => done({ scene: given } as FixAnswer))),
    furnish: (given) => Promise.resolve({ scene: { ...given, rooms: given.rooms.map((one) => ({ ...one, furniture: [] })) } } as unknown as GenerateAnswer),
  }, { furnish: () => undefined, show: (drawn) => shown.push(drawn), failed: () => undefined, closed: () => undefined });
  board.open(scene([room("den", [0, 0, 6, 3], { furniture: [piece("sofa", { x: 5, z: 0.5 })] })]));
  const [chosen] = [...host.querySelectorAll<HTMLElement>(".drawing-side button")].filter(({ textContent }) => textContent?.startsWith("Bedroom"));
  chosen?.click();
  const width = (metres: string): void => {
    const field = [...host.querySelectorAll<HTMLInputElement>(".drawing-side input")].find(({ value }) => value === "6.00" || value === "4.00") as HTMLInputElement;
    field.value = metres;
    field.dispatchEvent(new Event("change"));
  };
  width("4");
  [...host.querySelectorAll<HTMLElement>(".drawing-tools button")].find(({ textContent }) => textContent === "Show")?.click();
  void shown[0]?.().then((one) => sent.push(one));
  await Promise.resolve();
  expect(sent).toEqual([]);
  for (const one of waiting.splice(0)) one();
  await vi.waitFor(() => { expect(sent).toHaveLength(1); });
  expect(sent[0]?.rooms.map((one) => [one.width, one.furniture.length])).toEqual([[4, 0]]);
  width("5");
  expect([board.finish(), board.isOpen]).toEqual([null, true]);
  await shown[0]?.();
  expect([board.finish(), board.isOpen]).toEqual(["Left out for want of room: sofa; undo brings back what stood here.", false]);
});
