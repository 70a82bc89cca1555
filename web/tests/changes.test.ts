import { describe, expect, it } from "vitest";
import { changeBetween, changed, sharing, type Change } from "../src/memory/changes";
import { drawing } from "./random_requests";
import { times } from "./sweeps";

type Draw = () => number;
const pick = <Of>(draw: Draw, from: readonly Of[]): Of => from[Math.floor(draw() * from.length)] as Of;
const KEYS = ["a", "b", "id", "rooms", "__proto__", "constructor", "7", "", "länge", "x\u2028"];

/** A document of any shape, with ids here and there, twice sometimes. */
function anything(draw: Draw, depth: number): unknown {
  const kind = depth > 0 ? draw() : 0.5 + draw() / 2;
  if (kind < 0.25) return Array.from({ length: Math.floor(draw() * 5) }, () => anything(draw, depth - 1));
  if (kind < 0.55) {
    const pairs = Array.from({ length: Math.floor(draw() * 5) }, (): [string, unknown] => [pick(draw, KEYS), anything(draw, depth - 1)]);
    return Object.fromEntries([...(draw() < 0.6 ? [["id", `p${Math.floor(draw() * 6)}`] as [string, unknown]] : []), ...pairs]);
  }
  return pick(draw, [null, true, false, 0, 1.25, -3e-7, 1e21, "", "text", "\ud83d\ude00", "<b>"]);
}

/** Another document, like it in most. */
function edited(draw: Draw, document: unknown): unknown {
  if (draw() < 0.1) return anything(draw, 2);
  if (Array.isArray(document)) {
    const elements = document.map((one: unknown) => (draw() < 0.3 ? edited(draw, one) : one)).filter(() => draw() > 0.1);
    if (draw() < 0.2) elements.splice(Math.floor(draw() * elements.length), 0, anything(draw, 2));
    return draw() < 0.1 ? elements.reverse() : elements;
  }
  if (typeof document === "object" && document !== null) {
    const pairs = Object.entries(document).map(([key, value]): [string, unknown] => [key, draw() < 0.3 ? edited(draw, value) : value]);
    return Object.fromEntries(draw() < 0.1 ? pairs.reverse() : pairs.filter(() => draw() > 0.1));
  }
  return document;
}

const asJson = (document: unknown): unknown => JSON.parse(JSON.stringify(document));

describe("a change between documents", () => {
  it("makes the one of the other to the byte, from its own text", () => {
    const draw = drawing(11);
    let unchanged = 0;
    for (let i = 0; i < times(4000, 1000); i += 1) {
      const before = asJson(anything(draw, 4));
      const after = asJson(draw() < 0.1 ? before : edited(draw, before));
      const text = [JSON.stringify(before), JSON.stringify(after)];
      const change = changeBetween(before, after);
      expect(change === null).toBe(text[0] === text[1]);
      unchanged += Number(change === null);
      if (change) expect(JSON.stringify(changed(before, JSON.parse(JSON.stringify(change)) as Change))).toBe(text[1]);
      expect(JSON.stringify(sharing(before, after))).toBe(text[1]);
      expect([JSON.stringify(before), JSON.stringify(after)]).toEqual(text);
    }
    expect(unchanged).toBeGreaterThan(times(300, 75));
    expect(({} as Record<string, unknown>).a).toBeUndefined();
  });

  it("of one piece among many names only that, and shares the rest", () => {
    const rooms = Array.from({ length: 9 }, (_, i) => ({ id: `r${i}`, furniture: Array.from({ length: 20 }, (_, k) => ({ id: `r${i}/${k}`, x: k })) }));
    const before = { seed: 1, rooms };
    const after = asJson(before) as typeof before;
    (after.rooms[4]?.furniture[7] as { x: number }).x = 0.5;
    expect(JSON.stringify(changeBetween(before, after)).length).toBeLessThan(300);
    const shared = sharing(before, after);
    expect([shared.rooms[3] === rooms[3], shared.rooms[4] === rooms[4], shared.rooms[4]?.furniture[6] === rooms[4]?.furniture[6]]).toEqual([true, false, true]);
  });

  it("of another document is refused", () => {
    const wrong: [unknown, Change][] = [
      [[1], { runs: [{ from: 0, count: 2 }] }], [[1], { runs: [{ at: 3, to: { is: 1 } }] }], [{}, { runs: [] }], [3, { keys: {}, without: [] }],
      [[1], { runs: [{ from: -1, count: 1 }] }], [{}, { keys: { a: { runs: [] } }, without: [] }],
    ];
    for (const [document, change] of wrong) expect(() => changed(document, change)).toThrow(/what is no|that are not there/);
  });
});
