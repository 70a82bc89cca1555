// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import type { Catalog, Furniture } from "../src/contract";
import { gapLines } from "../src/edit/gap_lines";
import { footprint, gapsOf } from "../src/edit/gaps";
import { lengthTyped, lengthWords } from "../src/edit/lengths";
import { PiecePanel } from "../src/edit/piece_panel";
import { isSizable, sizeRange, variantsOf } from "../src/edit/size_range";
import { snapped } from "../src/edit/snap";
import { Tape } from "../src/edit/tape";
import { awayWords, whyLines } from "../src/edit/why_lines";
import { drawing } from "./random_requests";
import { piece, room } from "./rooms";
import { times } from "./sweeps";

const HOUSE = { wall_thickness: 0.1 };
const kinds: Catalog = {
  decorations: {},
  furniture: {
    sofa: { size: [2, 0.9, 0.85], color: "#112233", variants: ["#445566"] }, small_sofa: { name: "sofa", size: [1.4, 0.9, 0.85] },
    desk: { size: [1.2, 0.6, 0.75], stands: "wall" },
  },
};

describe("lengths", () => {
  it("are read with any unit, in whole millimetres, and written so that they are read again", () => {
    expect(["45 cm", "0.45", "0,45 m", "450mm", ".45", "1.2M", "-3 cm"].map(lengthTyped)).toEqual([450, 450, 450, 450, 450, 1200, -30]);
    expect(["", "wide", "1 2", "3 ft", "1e3", "0x10", "Infinity"].map(lengthTyped)).toEqual([null, null, null, null, null, null, null]);
    for (const length of [0, 1, 10, 123, 4567, 99999]) expect(lengthTyped(lengthWords(length))).toBe(length);
  });
});

describe("a dragged piece", () => {
  const other = piece("other", { x: 3, z: 2, width: 1, depth: 0.6 });
  const den = room("den", [0, 0, 6, 5], { furniture: [piece("own", { width: 1, depth: 1 }), other] });
  const at = (x: number, z: number, more: Partial<Furniture> = {}, wall = false) => snapped(HOUSE, den, piece("own", { width: 1, depth: 1, x, z, ...more }), wall);

  it("comes to lie at a wall, on an edge or a centre of another, or on the grid", () => {
    expect(at(0.58, 4.11)).toMatchObject({ x: 0.55, guides: [{ axis: "x", at: 50 }] });
    expect(at(3.03, 3.9)).toMatchObject({ x: 3, guides: [{ axis: "x", at: 2500 }] });
    expect(at(1.97, 3.9).x).toBe(2); // its east edge on the other's west edge
    expect(at(1.2, 4.12)).toEqual({ x: 1.2, z: 4.1, guides: [] });
    expect(at(4.813, 4.12).x).toBe(4.8);
    expect([at(0.61, 4.11).x, at(0.611, 4.11).x]).toEqual([0.55, 0.6]); // lined up from 6 cm away, no farther
  });

  it("keeps its back clear of its wall as its kind stands", () => {
    expect(at(2.2, 0.41, { width: 1.2, depth: 0.6 }, true).z).toBeCloseTo(0.38, 9);
    expect(at(2.2, 0.37, { width: 1.2, depth: 0.6 }, false).z).toBeCloseTo(0.35, 9);
    expect(at(5.6, 4.1, { width: 1.2, depth: 0.6, rotation: 270 }, true).x).toBeCloseTo(5.62, 9);
  });

  it("is never more than half a grid or the reach from where it is wished, and any guide is truly met", () => {
    const draw = drawing(11);
    for (let i = 0; i < times(3000, 800); i += 1) {
      const own = piece("own", { width: 0.3 + Math.round(draw() * 150) / 100, depth: 0.3 + Math.round(draw() * 90) / 100, rotation: Math.floor(draw() * 4) * 90, x: 0.9 + draw() * 4.2, z: 0.9 + draw() * 3.2 });
      const { x, z, guides } = snapped(HOUSE, den, own, draw() < 0.5);
      expect(Math.max(Math.abs(x - own.x), Math.abs(z - own.z))).toBeLessThanOrEqual(0.06 + 1e-9);
      const span = footprint({ ...own, x, z });
      for (const guide of guides) {
        const [low, high] = span[guide.axis];
        const off = [low, high, (low + high) / 2, low - 30, high + 30].map((edge) => Math.abs(edge - guide.at));
        expect(Math.min(...off)).toBeLessThanOrEqual(1);
      }
    }
  });
});

describe("distances in the house", () => {
  it("are lines as long as the numbers on them, from the piece's edge on", () => {
    const draw = drawing(5);
    for (let i = 0; i < 300; i += 1) {
      const own = piece("own", { width: 1, depth: 0.6, x: 1 + Math.round(draw() * 3000) / 1000, z: 1 + Math.round(draw() * 2000) / 1000 });
      const den = room("den", [3, 7, 6, 5], { furniture: [own, piece("b", { x: 5.2, z: 2, width: 0.5, depth: 2 })] });
      const lines = gapLines(gapsOf(HOUSE, den, own), den, own, 0);
      for (const { from, to, words = "" } of lines) {
        expect(Math.abs(from[0] - to[0]) + Math.abs(from[2] - to[2])).toBeCloseTo((lengthTyped(words) ?? NaN) / 1000, 9);
        expect(Math.min(Math.abs(from[0] - 3 - own.x), Math.abs(from[2] - 7 - own.z))).toBeLessThan(0.5);
      }
      expect(lines.length).toBeGreaterThanOrEqual(3);
    }
  });
});

describe("a tape", () => {
  it("measures from click to click, begins anew, and is put away", () => {
    const tape = new Tape();
    const said: string[] = [];
    tape.onChange = (_, words) => said.push(words);
    expect(tape.click(null)).toBe(false);
    tape.toggle();
    tape.click({ kind: "room", room: room("den", [0, 0, 1, 1]), at: [1, 0, 1] });
    tape.lay([4, 0.7, 5]);
    expect(said.at(-1)).toBe("Tape: 5.00 m (3.00 m west to east, 4.00 m north to south)");
    expect(tape.click(null)).toBe(true);
    tape.lay([0, 0, 0]);
    expect(said.at(-1)).toContain("where it ends");
    tape.toggle();
    expect([said.at(-1), tape.isOut]).toEqual(["", false]);
  });
});

describe("the panel of a piece", () => {
  it("allows the sizes between those of its kind", () => {
    const sofa = piece("s", { kind: "sofa" });
    expect(variantsOf(kinds, sofa)).toEqual(["sofa", "small_sofa"]);
    expect(sizeRange(kinds, sofa)).toEqual({ width: [1.4, 2], depth: [0.9, 0.9], height: [0.85, 0.85] });
    expect(isSizable(sizeRange(kinds, piece("d", { name: "desk", kind: "desk", width: 1.2, depth: 0.6, height: 0.75 })).width)).toBe(false);
    expect(sizeRange(kinds, piece("c", { name: "crate" })).width).toEqual([0.05, 6]);
    expect(sizeRange(kinds, piece("c", { name: "crate", asset: "a" })).width).toEqual([2, 2]);
  });

  it("takes a size that the kind allows, refuses others, and paints", () => {
    document.body.innerHTML = "<details></details>";
    const host = document.querySelector("details") as HTMLDetailsElement;
    const said: unknown[] = [];
    const panel = new PiecePanel(host, {
      change: (id, change) => said.push([id, change]), paint: (id, color) => said.push([id, color]), turnTo: (id, degrees) => said.push([id, degrees]), align: (how) => said.push(how),
    });
    panel.show(kinds, piece("s", { kind: "sofa" }), null, 1);
    const width = host.querySelector<HTMLInputElement>("input[name=width]") as HTMLInputElement;
    const type = (text: string) => { width.value = text; width.dispatchEvent(new Event("change")); return width.getAttribute("aria-invalid"); };
    expect([type("3 m"), type("huge"), type("160 cm")]).toEqual(["true", "true", "false"]);
    host.querySelector<HTMLButtonElement>("[aria-label='Colour #445566']")?.click();
    expect(said).toEqual([["s", { width: 1.6 }], ["s", "#445566"]]);
    panel.show(kinds, piece("s", { kind: "sofa" }), null, 3);
    host.querySelector<HTMLButtonElement>("[data-align=west]")?.click();
    expect(said.at(-1)).toBe("west");
    panel.show(kinds, null, null, 0);
    expect(host.hidden).toBe(true);
  });
});

describe("what holds a piece", () => {
  it("presses as an arrow on the side it holds, as long as it is strong; a wish is pointed to", () => {
    const own = piece("own", { x: 2, z: 1.5, width: 1, depth: 0.6 });
    const den = room("den", [3, 7, 6, 5], { furniture: [own] });
    const hold = (towards: "north" | "east", cost: number) => ({ by: "den/desk_1", what: "piece", towards, cost_per_m: cost, message: "" }) as const;
    const lines = whyLines({ holds: [hold("east", 2), hold("north", 0.1), hold("east", 1)], wished: [2.4, 1.5], stands: [2, 1.5] }, den, own, 0);
    expect(lines.map(({ look, words }) => [look, words])).toEqual([["hold", "desk · 0.10/m"], ["hold", "desk · 2.00/m"], ["hold", "desk · 1.00/m"], ["wish", "wished 0.40 m from here"]]);
    const [north, strong, weak, wish] = lines;
    expect([north?.to[2], strong?.to[0], weak?.to[0]]).toEqual([expect.closeTo(8.2, 9), expect.closeTo(5.5, 9), expect.closeTo(5.5, 9)]);
    expect([(strong?.from[0] ?? 0) - 5.5, (weak?.from[0] ?? 0) - 5.5]).toEqual([expect.closeTo(0.7, 9), expect.closeTo(0.35, 9)]);
    expect([wish?.from[0], wish?.to[0]]).toEqual([5, expect.closeTo(5.4, 9)]);
    expect(whyLines({ holds: [], wished: [2.01, 1.5], stands: [2, 1.5] }, den, own, 0)).toEqual([]);
    const odd = { wished: [2.355, 1.5], stands: [2, 1.5] } as const; // a little less than 0.355 in binary, a little more in hundreds
    expect(whyLines({ holds: [], ...odd }, den, own, 0).map(({ words }) => words)).toEqual([`wished ${awayWords(odd)} from here`]);
  });
});
