import { describe, expect, it } from "vitest";
import { floorUnder, roomHolding } from "../src/house/room_at";
import { room } from "./rooms";

const ROOMS = [
  room("a", [0, 0, 4, 3]),
  room("b", [4, 0, 4, 4], { outline: [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]] }),
  room("up", [0, 0, 4, 3], { level: 1 }),
];
const STOREYS = new Map([[0, { elevation: 0, height: 2.8 }], [1, { elevation: 3, height: 2.8 }]]);

describe("the room under a ray", () => {
  it("is the one whose outline holds the point", () => {
    expect(roomHolding(ROOMS, 0, 1, 1)?.id).toBe("a");
    expect(roomHolding(ROOMS, 0, 5, 3)?.id).toBe("b");
    expect(roomHolding(ROOMS, 0, 7, 3)).toBeUndefined();
    expect(roomHolding(ROOMS, 1, 1, 1)?.id).toBe("up");
  });

  it("is that of the highest floor under a ray from above", () => {
    expect(floorUnder(ROOMS, STOREYS, [1, 10, 1], [0, -1, 0])).toMatchObject({ room: { id: "up" }, distance: 7 });
    expect(floorUnder(ROOMS, STOREYS, [1, 2, 1], [0, -1, 0])).toMatchObject({ room: { id: "a" }, distance: 2 });
  });

  it("is met where a slanting ray comes down", () => {
    const down = Math.SQRT1_2;
    expect(floorUnder(ROOMS, STOREYS, [1, 2, 1], [down, -down, 0])?.room.id).toBe("a");
    expect(floorUnder(ROOMS, STOREYS, [3, 2, 1], [down, -down, 0])?.room.id).toBe("b");
  });

  it("is none for a ray that rises or leaves the house", () => {
    expect(floorUnder(ROOMS, STOREYS, [1, 2, 1], [0, 1, 0])).toBeNull();
    expect(floorUnder(ROOMS, STOREYS, [20, 5, 1], [0, -1, 0])).toBeNull();
  });
});
