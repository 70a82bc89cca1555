import { describe, expect, it } from "vitest";
import type { OpeningKind } from "../src/contract";
import { openingsOf } from "../src/house/openings";
import { runsOf } from "../src/house/wall_runs";
import { liesFlat } from "../src/house/room_at";
import { isInSight } from "../src/house/sight";
import type { Point } from "../src/house/wall_faces";
import { roomsAhead } from "../src/view/label_wishes";
import { opening, room } from "./rooms";

/** Sight in two rooms side by side with an opening from 1.55 m to 2.45 m in the wall between them at x = 4. */
function sightWith(kind: OpeningKind, more: object = {}, open: readonly string[] = []): (from: Point, to: Point) => boolean {
  const rooms = [room("a", [0, 0, 4, 4], { openings: [opening({ kind, wall: "east", position: 2, ...more })] }), room("b", [4, 0, 4, 4])];
  const storeys = new Map([[0, { elevation: 0, height: 2.8 }]]);
  const walled = { runs: runsOf(rooms, 0.1), openings: openingsOf(rooms, 0.1), storeys, isOpen: (id: string) => open.includes(id) };
  return (from, to) => isInSight(from, to, walled);
}

describe("sight", () => {
  it("goes through a passage below its head, not beside or above it", () => {
    const sees = sightWith("passage", { height: 2 });
    expect(sees([1, 1.6, 2], [6, 1.6, 2])).toBe(true);
    expect(sees([1, 1.6, 2], [6, 2.6, 2])).toBe(false);
    expect(sees([1, 1.6, 0.5], [6, 1.6, 0.5])).toBe(false);
    expect(sees([1, 1.6, 0.5], [3, 1.6, 3.5])).toBe(true);
  });

  it("goes through a door when its leaf is open", () => {
    expect(sightWith("door", { id: "d" })([1, 1.6, 2], [6, 1.6, 2])).toBe(false);
    expect(sightWith("door", { id: "d" }, ["d"])([1, 1.6, 2], [6, 1.6, 2])).toBe(true);
  });

  it("goes through a window over its sill, and over a wall", () => {
    const sees = sightWith("window", { sill: 0.9, height: 1.4 });
    expect(sees([1, 1.6, 2], [6, 1.6, 2])).toBe(true);
    expect(sees([1, 0.5, 2], [6, 0.5, 2])).toBe(false);
    expect(sees([1, 3, 2], [6, 3, 2])).toBe(true);
  });

  it("decides which rooms are named to who walks", () => {
    const rooms = [{ at: [2, 0, 2] as const, seen: true }, { at: [2, 0, 1] as const, seen: false }];
    const pose = { eye: [2, 1.6, 4], yaw: 0, pitch: 0 } as const;
    expect(roomsAhead(pose, rooms, ({ seen }) => seen)).toEqual([rooms[0]]);
  });
});

describe("what lies flat", () => {
  it("is on a floor, not on a table", () => {
    const storeys = new Map([[0, { elevation: 0, height: 2.8 }], [1, { elevation: 3, height: 2.8 }]]);
    expect([0, 3, 0.75, 2.4].map((y) => liesFlat({ y, height: 0.012 }, storeys))).toEqual([true, true, false, false]);
    expect(liesFlat({ y: 0, height: 0.4 }, storeys)).toBe(false);
  });
});
