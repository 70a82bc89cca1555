import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { Opening, Side } from "../src/contract";
import { leavesOf, type Leaf } from "../src/house/door_leaves";
import { Doors, leafMatrix } from "../src/house/doors";
import { openingsOf } from "../src/house/openings";
import { runsOf } from "../src/house/plan";
import { opening, room } from "./rooms";

function leafOf(more: Partial<Opening>): Leaf {
  const rooms = [room("a", [10, 20, 4, 4], { openings: [opening(more)] })];
  const [leaf] = leavesOf({ runs: runsOf(rooms), openings: openingsOf(rooms), storeys: new Map(), thickness: 0.1 });
  if (!leaf) throw new Error("no leaf");
  return leaf;
}

/** Where the leaf's free edge is, [x, z]. */
function tip(leaf: Leaf, open: number): [number, number] {
  const at = new Vector3(1, 0.5, 0).applyMatrix4(leafMatrix(leaf, open, 10));
  return [at.x, at.z];
}

const HINGES = ["start", "end"] as const;
const SIDES: readonly Side[] = ["north", "south", "east", "west"];

describe("a leaf", () => {
  it("hangs at the hinge end and, closed, reaches the other jamb", () => {
    const start = leafOf({ wall: "south", hinge: "start" });
    expect(start.hinge.x).toBeCloseTo(10 + 2 - 0.45 + 0.04, 9);
    expect(tip(start, 0)[0]).toBeCloseTo(12.45 - 0.04, 9);
    const end = leafOf({ wall: "east", hinge: "end" });
    expect(end.hinge.z).toBeCloseTo(22.45 - 0.04, 9);
    expect(tip(end, 0)[1]).toBeCloseTo(21.55 + 0.04, 9);
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
    const top = new Vector3(0.5, 1, 0).applyMatrix4(leafMatrix(leaf, 0, 1.2));
    expect(top.y).toBeCloseTo(1.2, 9);
  });

  it("of a garage door rolls up in its wall", () => {
    const leaf = leafOf({ kind: "garage_door", width: 2.4, height: 2.2 });
    expect(leaf.motion).toBe("roll");
    expect(leafMatrix(leaf, 1, 1.2).determinant()).toBe(0);
    const raised = new Vector3(0.5, 0, 0).applyMatrix4(leafMatrix(leaf, 1, 2.8));
    expect(raised.y).toBeGreaterThan(2);
  });

  it("is not in a passage or a window", () => {
    const rooms = [room("a", [0, 0, 4, 4], { openings: [opening({ kind: "passage" }), opening({ id: "w", kind: "window" })] })];
    expect(leavesOf({ runs: runsOf(rooms), openings: openingsOf(rooms), storeys: new Map(), thickness: 0.1 })).toEqual([]);
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
