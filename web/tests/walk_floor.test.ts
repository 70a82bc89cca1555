import { describe, expect, it } from "vitest";
import type { RoomFloor, Scene } from "../src/contract";
import { openingsOf } from "../src/house/openings";
import { runsOf } from "../src/house/wall_runs";
import { HALF_BODY, leftOf, WalkFloor, type Place, type Rectangle } from "../src/view/walk_floor";
import { routeOver } from "../src/view/walk_route";
import { opening, room } from "./rooms";

const HALF_WALL = 0.05;
/** Two rooms beside each other, a door at x = 4 between z 1.05 and 1.95, a cupboard in the west one. */
const ROOMS = [
  room("west", [0, 0, 4, 3], { openings: [opening({ id: "door", wall: "east", position: 1.5 })] }),
  room("east", [4, 0, 4, 3]),
];
const CUPBOARD: Rectangle = [1.5, HALF_WALL, 2, 2];

function floorOf(isOpen: () => boolean, thickness = 2 * HALF_WALL): WalkFloor {
  const clear: Rectangle = [HALF_WALL, HALF_WALL, 4 - HALF_WALL, 3 - HALF_WALL];
  const floors = ROOMS.map(({ id }) => ({ room: id, free: id === "west" ? leftOf(clear, [CUPBOARD]) : [clear] }) as unknown as RoomFloor);
  const plan = { runs: runsOf(ROOMS, thickness), openings: openingsOf(ROOMS, thickness) };
  return new WalkFloor({ rooms: ROOMS, wall_thickness: thickness } as unknown as Scene, floors, plan, isOpen);
}

const SHUT = floorOf(() => false);
const OPEN = floorOf(() => true);

describe("the floor one walks on", () => {
  it("is what rectangles leave of one, to the edge", () => {
    const area = (parts: readonly Rectangle[]): number => parts.reduce((sum, [a, b, c, d]) => sum + (c - a) * (d - b), 0);
    expect(leftOf([0, 0, 4, 4], [[1, 1, 2, 3]]).length).toBe(4);
    expect(area(leftOf([0, 0, 4, 4], [[1, 1, 2, 3], [0, 0, 1, 4]]))).toBeCloseTo(16 - 2 - 4, 9);
    expect(leftOf([0, 0, 4, 4], [[-1, -1, 2, 5], [2, 0, 4, 4]])).toEqual([]);
    expect(leftOf([0, 0, 4, 4], [[4, 0, 5, 4]])).toEqual([[0, 0, 4, 4]]);
  });

  it("ends at walls and furniture, half a body before them, and lets one slide along", () => {
    const ahead = SHUT.step([1, 2.5], [1, 9]);
    expect(ahead[1]).toBeLessThanOrEqual(3 - HALF_WALL - HALF_BODY + 1e-6);
    expect(ahead[1]).toBeGreaterThan(3 - HALF_WALL - HALF_BODY - 0.06);
    const [x, z] = SHUT.step([1, 1], [3, 1.4]);
    expect(x).toBeLessThanOrEqual(1.5 - HALF_BODY + 1e-6);
    expect(x).toBeGreaterThan(1.2);
    expect(z).toBeCloseTo(1.4, 6);
  });

  it("goes on through a door that is open, and through no other", () => {
    expect(SHUT.step([3, 1.5], [5, 1.5])[0]).toBeLessThan(4 - HALF_WALL - HALF_BODY + 1e-6);
    expect(OPEN.step([3, 1.5], [5, 1.5])[0]).toBeCloseTo(5, 6);
    expect(OPEN.step([3, 2.5], [5, 2.5])[0]).toBeLessThan(4 - HALF_WALL);
    expect(floorOf(() => false, 0).step([3, 2.5], [5, 2.5])[0]).toBeLessThan(4);
  });

  it("puts whom a door was shut on, or furniture put on, to the nearest free place", () => {
    let open = true;
    const floor = floorOf(() => open);
    const within = floor.step([3, 1.5], [4, 1.5]);
    expect(within[0]).toBeCloseTo(4, 6);
    open = false;
    expect(floor.holds(within)).toBe(false);
    const beside = floor.step(within, within);
    expect(floor.holds(beside)).toBe(true);
    expect(Math.abs(beside[0] - 4)).toBeCloseTo(HALF_WALL + HALF_BODY, 6);
  });

  it("never lets any walk leave it, whatever way is wished", () => {
    let seed = 7;
    const chance = (): number => (seed = (seed * 48271) % 2147483647) / 2147483647;
    for (const floor of [SHUT, OPEN]) {
      let at: Place = [1, 2.5];
      for (let i = 0; i < 2000; i += 1) {
        at = floor.step(at, [at[0] + chance() - 0.5, at[1] + chance() - 0.5]);
        expect(floor.holds(at)).toBe(true);
      }
    }
  });
});

describe("the way to a place that is clicked", () => {
  it("leads around what is in the way and through open doors", () => {
    const far: Place = [7, 0.5];
    for (const [floor, reached] of [[OPEN, far], [SHUT, [3.7, 0.5]]] as const) {
      const route = routeOver(floor.rectangles, [0.5, 0.5], far);
      expect(route.length).toBeGreaterThan(1);
      let at: Place = [0.5, 0.5];
      for (const corner of route) {
        at = floor.step(at, corner);
        expect(Math.hypot(at[0] - corner[0], at[1] - corner[1])).toBeLessThan(1e-6);
      }
      expect(Math.hypot(at[0] - reached[0], at[1] - reached[1])).toBeLessThan(0.2);
    }
  });

  it("is none where there is no floor", () => {
    expect(routeOver([], [0, 0], [1, 1])).toEqual([]);
  });
});
