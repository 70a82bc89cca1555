import { describe, expect, it } from "vitest";
import type { Opening, Side } from "../src/contract";
import { leavesOf, type Leaf } from "../src/house/door_leaves";
import { partsOfLeaf } from "../src/house/door_shapes";
import { bodyOfLeaf, Doors, shownOfLeaf } from "../src/house/doors";
import { openingsOf } from "../src/house/openings";
import { runsOf } from "../src/house/wall_runs";
import { opening, room } from "./rooms";

function leafOf(more: Partial<Opening>): Leaf {
  const rooms = [room("a", [10, 20, 4, 4], { openings: [opening(more)] })];
  const [leaf] = leavesOf({ runs: runsOf(rooms, 0.1), openings: openingsOf(rooms, 0.1), storeys: new Map() });
  if (!leaf) throw new Error("no leaf");
  return leaf;
}

/** How low and how high what shows of a leaf reaches above its underside [m]; null where nothing shows. */
function reachOf(leaf: Leaf, open: number, cut: number): [number, number] | null {
  const parts = shownOfLeaf(leaf, partsOfLeaf(leaf), open, cut).flatMap((part) => part ?? []);
  const ends = parts.flatMap(({ at, size }) => [at[1] - size[1] / 2, at[1] + size[1] / 2]);
  return ends.length > 0 ? [Math.min(...ends), Math.max(...ends)] : null;
}

/** Where the leaf's free edge is, [x, z]. */
function tip(leaf: Leaf, open: number): [number, number] {
  const body = bodyOfLeaf(leaf, open);
  return [2 * body.x - leaf.hinge.x, 2 * body.z - leaf.hinge.z];
}

describe("a door that the scene has open", () => {
  for (const open of [0, 0.2, 0.5, 1]) {
    it(`stands ${open} open, and a toggle shuts it`, () => {
      const leaf = leafOf({ open, hinge: "start", swing: "in" });
      const doors = new Doors([leaf]);
      expect(doors.angleOf(0)).toBeCloseTo(leaf.closedAngle + open * leaf.turn, 9);
      doors.cutAt(3);
      expect(doors.angleOf(0)).toBeCloseTo(leaf.closedAngle + open * leaf.turn, 9);
      expect(doors.open).toEqual(open > 0 ? [leaf.id] : []);
      doors.toggle(0);
      while (doors.step(0.1)) continue;
      expect(doors.angleOf(0)).toBeCloseTo(leaf.closedAngle + (open > 0 ? 0 : 1) * leaf.turn, 9);
    });
  }
});

const HINGES = ["start", "end"] as const;
const SIDES: readonly Side[] = ["north", "south", "east", "west"];

describe("a leaf", () => {
  it("hangs at the hinge end and, closed, reaches the other jamb", () => {
    const start = leafOf({ wall: "south", hinge: "start" });
    expect(start.hinge.x).toBeCloseTo(10 + 2 - 0.45 + 0.06, 9);
    expect(tip(start, 0)[0]).toBeCloseTo(12.45 - 0.06, 9);
    const end = leafOf({ wall: "east", hinge: "end" });
    expect(end.hinge.z).toBeCloseTo(22.45 - 0.06, 9);
    expect(tip(end, 0)[1]).toBeCloseTo(21.55 + 0.06, 9);
  });

  it("swings into its room when it swings in and away from it when out, on every wall, by either hinge", () => {
    for (const wall of SIDES) {
      for (const hinge of HINGES) {
        const [x, z] = tip(leafOf({ wall, hinge, swing: "in" }), 1);
        expect(x > 10.3 && x < 13.7 && z > 20.3 && z < 23.7, `${wall} ${hinge} in`).toBe(true);
        const [ox, oz] = tip(leafOf({ wall, hinge, swing: "out" }), 1);
        expect(ox < 9.8 || ox > 14.2 || oz < 19.8 || oz > 24.2, `${wall} ${hinge} out`).toBe(true);
      }
    }
  });

  it("stands square to its wall when open", () => {
    const leaf = leafOf({ wall: "south", hinge: "start" });
    expect(tip(leaf, 1)[0]).toBeCloseTo(leaf.hinge.x, 9);
  });

  it("is cut with the walls", () => {
    const leaf = leafOf({});
    expect(reachOf(leaf, 0, 1.2)?.[1]).toBeCloseTo(1.2 - leaf.hinge.y, 9);
    expect(reachOf(leaf, 0, 9)).toEqual([0, expect.closeTo(leaf.height, 9)]);
  });

  it("of a garage door rolls up in its wall", () => {
    const leaf = leafOf({ kind: "garage_door", width: 2.4, height: 2.2 });
    expect(leaf.motion).toBe("roll");
    expect(reachOf(leaf, 1, 1.2)).toBeNull();
    expect(reachOf(leaf, 1, 2.8)?.[0]).toBeGreaterThan(2);
    expect(reachOf(leaf, 1, 2.8)?.[1]).toBeLessThanOrEqual(leaf.height + 1e-9);
  });

  it("of any kind fills its frame, its handles on both sides at the end away from the hinge", () => {
    for (const more of [{}, { main_entrance: true }, { kind: "garage_door", width: 2.4 }] as const) {
      const leaf = leafOf(more);
      const parts = partsOfLeaf(leaf);
      const xs = parts.flatMap(({ at, size }) => [at[0] - size[0] / 2, at[0] + size[0] / 2]);
      expect([Math.min(...xs), Math.max(...xs)]).toEqual([expect.closeTo(-leaf.width / 2, 9), expect.closeTo(leaf.width / 2, 9)]);
      if (leaf.motion === "roll") continue;
      const proud = parts.filter(({ at, size }) => Math.abs(at[2]) + size[2] / 2 > 0.03);
      expect(new Set(proud.map(({ at }) => Math.sign(at[2])))).toEqual(new Set([-1, 1]));
      for (const { at } of proud) expect(at[0] > leaf.width * 0.2 && Math.abs(at[1] - 1) < 0.1).toBe(true);
    }
  });

  it("between a room and a terrace is glazed, in a railing a gate", () => {
    const door = opening({ wall: "east", connects_to: "b" });
    const rooms = [room("a", [0, 0, 4, 4], { openings: [door] }), room("b", [4, 0, 4, 4], {
      outdoor: true, openings: [opening({ id: "gate", wall: "east" })],
    })];
    const leaves = leavesOf({ runs: runsOf(rooms, 0.1), openings: openingsOf(rooms, 0.1), storeys: new Map(), rooms });
    expect(leaves.map(({ look }) => look)).toEqual(["glazed", "gate"]);
    expect(partsOfLeaf(leaves[0] as Leaf).some(({ paint }) => paint.opacity < 1)).toBe(true);
  });

  it("is not in a passage or a window", () => {
    const rooms = [room("a", [0, 0, 4, 4], { openings: [opening({ kind: "passage" }), opening({ id: "w", kind: "window" })] })];
    expect(leavesOf({ runs: runsOf(rooms, 0.1), openings: openingsOf(rooms, 0.1), storeys: new Map() })).toEqual([]);
  });
});

describe("a door of two leaves", () => {
  const rooms = [room("a", [10, 20, 4, 4], { openings: [opening({ id: "wide", wall: "south", width: 1.8, hinge: "end" })] })];
  const leaves = leavesOf({ runs: runsOf(rooms, 0.1), openings: openingsOf(rooms, 0.1), storeys: new Map() });

  it("has them meet in its middle, the one at the hinge first", () => {
    expect(leaves.map(({ id, opening: door }) => [id, door])).toEqual([["wide", "wide"], ["wide/2", "wide"]]);
    expect(leaves.map((leaf) => leaf.hinge.x)).toEqual([expect.closeTo(12.9 - 0.06, 9), expect.closeTo(11.1 + 0.06, 9)]);
    for (const leaf of leaves) expect(tip(leaf, 0)[0]).toBeCloseTo(12, 9);
    const [first, second] = leaves.map((leaf) => tip(leaf, 1)[1]);
    expect(first).toBeCloseTo(second as number, 9);
  });

  it("opens and shuts both, whichever is clicked, and is one door", () => {
    const doors = new Doors(leaves);
    expect(doors.ids).toEqual(["wide"]);
    doors.toggle(1);
    while (doors.step(0.1)) continue;
    expect(doors.open).toEqual(["wide"]);
    leaves.forEach((leaf, i) => expect(doors.angleOf(i)).toBeCloseTo(leaf.closedAngle + leaf.turn, 9));
    doors.toggle(0);
    expect(doors.open).toEqual([]);
  });
});

describe("doors", () => {
  it("open in time and come to rest", () => {
    const doors = new Doors([leafOf({})]);
    expect(doors.step(0.1)).toBe(false);
    doors.toggle(0);
    expect(doors.step(0.1)).toBe(true);
    for (let i = 0; i < 10; i += 1) doors.step(0.1);
    expect(doors.step(0.1)).toBe(false);
    expect(doors.open).toEqual(["door_1"]);
    doors.toggle(0);
    expect(doors.open).toEqual([]);
  });
});
