import { Raycaster, Vector3 } from "three";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { Hand, type Point } from "../src/edit/hand";
import { LONG_PRESS } from "../src/view/pointer";

/** A canvas seen from straight above, a hundred pixels a metre, and what a hand on it says. */
function table(locked = false, isChosen = false) {
  const host = new EventTarget();
  const captured: number[] = [];
  const canvas = Object.assign(new EventTarget(), { parentElement: host, setPointerCapture: (pointer: number) => captured.push(pointer) });
  const length = Object.assign(new EventTarget(), { matches: (which: string) => which === ".ruler-words" });
  const said: string[] = [];
  const wanted: Point[] = [];
  const hand = new Hand(canvas as unknown as HTMLCanvasElement, {
    grasp: (x) => (x < 300 && !locked ? { id: "sofa", at: { x: 1, z: 1 }, height: 0.4, isChosen } : null),
    rayAt: (x, y) => new Raycaster(new Vector3(x / 100, 10, y / 100), new Vector3(0, -1, 0)),
    hold: (held) => said.push(held ? "hold" : "free"),
    lift: (id) => said.push(`lift ${id}`),
    drag: (at) => wanted.push(at),
    drop: () => said.push("drop"),
    cancel: () => said.push("cancel"),
  });
  const pointer = (type: string, clientX: number, clientY: number, more: object = {}, target: EventTarget = canvas): void => {
    const event = Object.assign(new Event(type), { clientX, clientY, button: 0, isPrimary: true, pointerId: 7, shiftKey: false, ctrlKey: false, ...more });
    Object.defineProperty(event, "target", { value: target });
    (type === "lostpointercapture" ? canvas : host).dispatchEvent(event); // all others bubble
  };
  return { hand, said, wanted, pointer, length, captured };
}

describe("a hand", () => {
  it("takes hold, lifts with the first real move, drags by the point held, and drops", () => {
    const { hand, said, wanted, pointer } = table();
    pointer("pointerdown", 120, 110);
    pointer("pointermove", 123, 112);
    expect([said, wanted, hand.holds]).toEqual([["hold"], [], false]);
    pointer("pointermove", 220, 160);
    expect(hand.holds).toBe(true);
    expect(wanted).toEqual([{ x: expect.closeTo(2, 9), z: expect.closeTo(1.5, 9) }]);
    pointer("pointerup", 220, 160);
    pointer("pointermove", 250, 160);
    expect([said, wanted.length, hand.holds]).toEqual([["hold", "lift sofa", "free", "drop"], 1, false]);
  });

  it("takes a press that stays for a click", () => {
    const { said, pointer } = table();
    pointer("pointerdown", 120, 110);
    pointer("pointerup", 121, 111);
    expect(said).toEqual(["hold", "free"]);
  });

  it("puts back when it is given up, and when the pointer is lost", () => {
    for (const end of ["cancel", "pointercancel", "lostpointercapture"]) {
      const { hand, said, pointer } = table();
      pointer("pointerdown", 120, 110);
      pointer("pointermove", 220, 160);
      if (end === "cancel") hand.cancel();
      else pointer(end, 0, 0);
      pointer("pointerup", 220, 160);
      expect(said).toEqual(["hold", "lift sofa", "free", "cancel"]);
    }
  });

  it("leaves other buttons, other fingers, keys held and empty places to the camera", () => {
    for (const more of [{ button: 2 }, { isPrimary: false }, { shiftKey: true }, { ctrlKey: true }]) {
      const { said, pointer } = table();
      pointer("pointerdown", 120, 110, more);
      pointer("pointermove", 220, 160);
      expect(said).toEqual([]);
    }
    const { said, pointer } = table();
    pointer("pointerdown", 400, 110);
    pointer("pointermove", 220, 160);
    expect(said).toEqual([]);
  });

  it("follows the pointer that took hold and no other", () => {
    const { said, wanted, pointer } = table();
    pointer("pointerdown", 120, 110);
    pointer("pointermove", 220, 160, { pointerId: 8 });
    pointer("pointerup", 220, 160, { pointerId: 8 });
    expect([said, wanted]).toEqual([["hold"], []]);
  });
});

describe("a finger", () => {
  beforeEach(() => { vi.useFakeTimers(); });
  afterEach(() => { vi.useRealTimers(); });
  const finger = { pointerType: "touch" };

  it("turns the house where it moves on from a piece, and clicks where it does not stay", () => {
    for (const to of [160, 122]) {
      const { said, pointer } = table();
      pointer("pointerdown", 120, 110, finger);
      pointer("pointermove", to, 110, finger);
      if (to === 122) pointer("pointerup", to, 110, finger);
      vi.advanceTimersByTime(2 * LONG_PRESS);
      expect(said).toEqual([]);
    }
  });

  it("takes hold of a piece that it stays on, and drags it", () => {
    const { said, wanted, pointer } = table();
    pointer("pointerdown", 120, 110, finger);
    vi.advanceTimersByTime(LONG_PRESS - 1);
    expect(said).toEqual([]);
    vi.advanceTimersByTime(1);
    expect(said).toEqual(["hold", "lift sofa"]);
    pointer("pointermove", 220, 160, finger);
    expect(wanted).toEqual([{ x: expect.closeTo(2, 9), z: expect.closeTo(1.5, 9) }]);
    pointer("pointerup", 220, 160, finger);
    expect(said).toEqual(["hold", "lift sofa", "free", "drop"]);
  });

  it("drags what is chosen at once, and moves nothing that is only taken up", () => {
    const chosen = table(false, true);
    chosen.pointer("pointerdown", 120, 110, finger);
    chosen.pointer("pointermove", 220, 160, finger);
    expect(chosen.said).toEqual(["hold", "lift sofa"]);
    const { said, pointer } = table();
    pointer("pointerdown", 120, 110, finger);
    vi.advanceTimersByTime(LONG_PRESS);
    pointer("pointerup", 121, 110, finger);
    expect(said).toEqual(["hold", "lift sofa", "free", "cancel"]);
  });

  it("drags what lies beneath a length, and leaves a tap there to the length", () => {
    const { said, pointer, length, captured } = table(false, true);
    pointer("pointerdown", 120, 110, finger, length);
    pointer("pointerup", 121, 110, finger, length);
    expect([said, captured]).toEqual([["hold", "free"], []]);
    pointer("pointerdown", 120, 110, finger, length);
    pointer("pointermove", 220, 160, finger, length);
    pointer("pointerup", 220, 160, finger);
    expect([said.slice(2), captured]).toEqual([["hold", "lift sofa", "free", "drop"], [7]]);
    pointer("pointerdown", 120, 110, {}, length);
    expect(said.length).toBe(6);
  });

  it("gives up what it waits for, or holds, to a second finger", () => {
    const waits = table();
    waits.pointer("pointerdown", 120, 110, finger);
    waits.pointer("pointerdown", 220, 110, { ...finger, isPrimary: false, pointerId: 8 });
    vi.advanceTimersByTime(2 * LONG_PRESS);
    expect(waits.said).toEqual([]);
    const holds = table(false, true);
    holds.pointer("pointerdown", 120, 110, finger);
    holds.pointer("pointermove", 220, 160, finger);
    holds.pointer("pointerdown", 220, 110, { ...finger, isPrimary: false, pointerId: 8 });
    expect(holds.said).toEqual(["hold", "lift sofa", "free", "cancel"]);
  });
});
