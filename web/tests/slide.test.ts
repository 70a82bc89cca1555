import { describe, expect, it } from "vitest";
import type { PlacedBody } from "../src/house/frame";
import { shortestTurn, Slide, type Spot } from "../src/edit/slide";

const SECONDS = 0.12;
const FRAME = 0.01;

/** Bodies that are where they were put last. */
function floor(...bodies: (Spot & { readonly id: string })[]) {
  const at = new Map(bodies.map((body) => [body.id, body]));
  const slide = new Slide((id, spot) => at.set(id, { id, ...spot }), SECONDS);
  const to = (...goals: (Spot & { readonly id: string })[]): boolean => slide.to([...at.values()] as unknown as PlacedBody[], goals as unknown as PlacedBody[]);
  return { at, slide, to };
}

const body = (id: string, x: number, turn = 0): Spot & { readonly id: string } => ({ id, x, y: 0, z: 0, turn });

describe("a slide", () => {
  it("arrives exactly, without ever going back or beyond", () => {
    const { at, slide, to } = floor(body("chair", 0));
    expect(to(body("chair", 1))).toBe(true);
    let before = 0;
    for (let frame = 1; slide.step(FRAME); frame += 1) {
      const x = at.get("chair")?.x ?? 0;
      expect(x).toBeGreaterThan(before);
      expect(x).toBeLessThan(1);
      before = x;
      expect(frame).toBeLessThan(SECONDS / FRAME);
    }
    expect(at.get("chair")).toEqual(body("chair", 1));
  });

  it("does not jump when it is sent elsewhere on its way", () => {
    const { at, slide, to } = floor(body("chair", 0));
    to(body("chair", 1));
    let before = 0;
    const goals = [0.8, 0.2, 1.4, 0];
    const fastest = 1.4 * (2 / SECONDS) * FRAME;
    for (let frame = 0; frame < 40; frame += 1) {
      if (frame % 5 === 4) to(body("chair", goals[Math.floor(frame / 5)] ?? 0.5));
      expect(at.get("chair")?.x).toBe(before);
      slide.step(FRAME);
      const x = at.get("chair")?.x ?? 0;
      expect(Math.abs(x - before)).toBeLessThanOrEqual(fastest);
      before = x;
    }
  });

  it("leaves who is there already, and who belongs nowhere, alone", () => {
    const { at, slide, to } = floor(body("chair", 0), body("sofa", 2), body("gone", 3));
    expect(to(body("chair", 0), body("sofa", 2))).toBe(false);
    expect(to(body("chair", 0), body("sofa", 5))).toBe(true);
    while (slide.step(FRAME));
    expect([...at.values()].map(({ x }) => x)).toEqual([0, 5, 3]);
  });

  it("turns the shorter way round", () => {
    const quarter = Math.PI / 2;
    expect(shortestTurn(0, 3 * quarter)).toBeCloseTo(-quarter);
    expect(shortestTurn(3 * quarter, 0)).toBeCloseTo(quarter);
    const { at, slide, to } = floor(body("chair", 0, 3 * quarter));
    to(body("chair", 0, 0));
    slide.step(SECONDS / 2);
    expect(at.get("chair")?.turn).toBeGreaterThan(3 * quarter);
    expect(at.get("chair")?.turn).toBeLessThan(4 * quarter);
  });

  it("is there at once where nothing may move", () => {
    const placed: number[] = [];
    const still = new Slide((_, spot) => placed.push(spot.x), 0);
    still.to([body("chair", 0)] as unknown as PlacedBody[], [body("chair", 1)] as unknown as PlacedBody[]);
    expect(still.step(0)).toBe(false);
    expect(placed).toEqual([1]);
  });
});
