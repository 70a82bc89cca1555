import { describe, expect, it } from "vitest";
import { areaOf, areOverlapping, boxOf, combined, cornersOfBox, isSound, wallsOf, type Corners } from "../src/draw/corners";
import { EMPTY, openingMoved, openingsLost, reshaped, roomMoved, wallLengthened, wallMoved, withOpening, withOpeningAt, withOpeningChanged, withoutOpening, withoutRoom, withRoom, withType, type Draft } from "../src/draw/draft";
import { DrawnPlan } from "../src/draw/drawn_plan";
import { PictureBeneath } from "../src/draw/picture_beneath";
import { reshapedRooms } from "../src/draw/reflow";
import { atOrigin, draftOf, sceneOf } from "../src/draw/scene_draft";
import { linesOf, snapped, snappedShift } from "../src/draw/snapping";
import { opening, piece, room, scene } from "./rooms";
import { times } from "./sweeps";

const box = (x0: number, z0: number, x1: number, z1: number) => ({ x0, z0, x1, z1 });

/** A plan of rectangles [mm]. */
function drawn(...boxes: readonly (readonly [number, number, number, number])[]): Draft {
  return boxes.reduce((draft, [x0, z0, x1, z1]) => {
    const made = withRoom(draft, cornersOfBox(box(x0, z0, x1, z1)));
    if (!made) throw new Error("no such room");
    return made.draft;
  }, EMPTY);
}

/** Two rooms side by side over a hall that is as long as both. */
const three = (): Draft => drawn([0, 0, 4000, 3000], [4000, 0, 7000, 3000], [0, 3000, 7000, 5000]);
const boxes = (draft: Draft) => draft.rooms.map(({ corners }) => Object.values(boxOf(corners)));

/** Draws numbers from 0 to 1, the same for a seed (mulberry32). */
function draws(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

describe("corners", () => {
  it("take rectangles away and add them, clockwise from the north-west", () => {
    const notched = combined(cornersOfBox(box(0, 0, 4000, 3000)), box(2000, 1000, 4000, 3000), "cut");
    expect(notched).toEqual([{ x: 0, z: 0 }, { x: 4000, z: 0 }, { x: 4000, z: 1000 }, { x: 2000, z: 1000 }, { x: 2000, z: 3000 }, { x: 0, z: 3000 }]);
    expect(combined(notched as Corners, box(2000, 1000, 4000, 3000), "add")).toEqual(cornersOfBox(box(0, 0, 4000, 3000)));
  });

  it("refuse what leaves a hole, two floors, or none", () => {
    const square = cornersOfBox(box(0, 0, 4000, 4000));
    expect(combined(square, box(1000, 1000, 2000, 2000), "cut")).toBeNull();
    expect(combined(square, box(1000, 0, 2000, 4000), "cut")).toBeNull();
    expect(combined(square, box(0, 0, 4000, 4000), "cut")).toBeNull();
    expect(combined(square, box(5000, 0, 6000, 4000), "add")).toBeNull();
  });

  it("are sound after any number of rectangles, and their areas add up cell by cell", () => {
    for (let seed = 0; seed < times(60, 15); seed += 1) {
      const draw = draws(seed);
      let corners = cornersOfBox(box(0, 0, 6, 6));
      for (let k = 0; k < 8; k += 1) {
        const [x, z] = [Math.floor(draw() * 8) - 1, Math.floor(draw() * 8) - 1];
        const next = combined(corners, box(x, z, x + 1 + Math.floor(draw() * 3), z + 1 + Math.floor(draw() * 3)), draw() < 0.5 ? "add" : "cut");
        corners = next ?? corners;
      }
      expect(isSound(corners)).toBe(true);
      let cells = 0;
      for (let x = -2; x < 12; x += 1) for (let z = -2; z < 12; z += 1) if (areOverlapping(corners, cornersOfBox(box(x, z, x + 1, z + 1)))) cells += 1;
      expect(areaOf(corners)).toBe(cells);
    }
  });
});

describe("a plan", () => {
  it("has no two rooms on one floor, and none that is no room", () => {
    expect(withRoom(three(), cornersOfBox(box(3000, 1000, 5000, 2000)))).toBeNull();
    expect(withRoom(EMPTY, cornersOfBox(box(0, 0, 400, 3000)))).toBeNull();
    expect(withRoom(three(), cornersOfBox(box(7000, 0, 9000, 3000)))?.id).toBe("room_4");
  });

  it("moves a wall for the rooms on both its sides, or for one alone", () => {
    const both = wallMoved(three(), "room_1", 2, 2500) as Draft;
    expect(boxes(both)).toEqual([[0, 0, 4000, 2500], [4000, 0, 7000, 2500], [0, 2500, 7000, 5000]]);
    const one = wallMoved(three(), "room_1", 1, 3500, true) as Draft;
    expect(boxes(one).slice(0, 2)).toEqual([[0, 0, 3500, 3000], [4000, 0, 7000, 3000]]);
    expect(wallMoved(three(), "room_1", 1, 4500, true)).toBeNull();
    expect(wallMoved(three(), "room_1", 2, 4800)).toBeNull(); // the hall would be 0.2 m wide
  });

  it("takes what is in a wall along with it, and drops what no longer fits", () => {
    const door = withOpening(three(), "door", { x: 2000, z: 3010 }, 300) as { draft: Draft; id: string };
    const moved = wallMoved(door.draft, "room_3", 0, 2600) as Draft;
    expect(moved.openings[0]).toMatchObject({ axis: "x", line: 2600, from: 1550, to: 2450 });
    const pushed = wallMoved(door.draft, "room_1", 1, 2000) as Draft;
    expect(pushed.openings[0]).toMatchObject({ from: 1050, to: 1950 }); // the wall that was moved meets it no more
    expect(wallMoved(pushed, "room_1", 1, 900)?.openings[0]).toMatchObject({ from: 1050, to: 1950 });
    expect(wallMoved(withOpening(three(), "window", { x: 700, z: 0 }, 100)?.draft as Draft, "room_1", 1, 700)?.openings[0]).toMatchObject({ from: 750, to: 2150 });
    const low = withOpening(drawn([0, 0, 2000, 3000]), "window", { x: 1000, z: 0 }, 100)?.draft as Draft;
    expect(withRoom(low, cornersOfBox(box(0, -2000, 1000, 0)))?.draft.openings[0]).toMatchObject({ from: 50, to: 950 });
    expect(withoutRoom(withoutRoom(pushed, "room_3"), "room_2").openings[0]).toMatchObject({ from: 1050, to: 1950 });
    expect(withoutRoom(withoutRoom(withoutRoom(pushed, "room_3"), "room_2"), "room_1").openings).toEqual([]);
  });

  it("makes a wall as long as was typed", () => {
    expect(boxes(wallLengthened(three(), "room_1", 0, 4500) as Draft).slice(0, 2)).toEqual([[0, 0, 4500, 3000], [4500, 0, 7000, 3000]]);
    expect(boxes(wallLengthened(three(), "room_1", 3, 2000) as Draft)[0]).toEqual([0, 0, 4000, 2000]);
    expect(wallLengthened(three(), "room_1", 0, 7000)).toBeNull();
  });

  it("puts openings where there is wall for them, never onto each other", () => {
    const { draft, id } = withOpening(three(), "window", { x: 1000, z: 20 }, 200) as { draft: Draft; id: string };
    expect(draft.openings[0]).toMatchObject({ kind: "window", from: 300, to: 1700, sill: 900 });
    expect(withOpening(draft, "door", { x: 1800, z: 0 }, 200)).toBeNull();
    expect(withOpening(draft, "door", { x: 2000, z: 1500 }, 200)).toBeNull();
    expect(openingMoved(draft, id, { x: 10, z: 1500 }, 200)?.openings[0]).toMatchObject({ axis: "z", line: 0, from: 800, to: 2200 });
    expect(openingMoved(draft, id, { x: 100_000, z: 0 }, 200)).toBeNull();
    expect(withOpeningChanged(draft, id, { to: 3950 })?.openings[0]).toMatchObject({ to: 3950 });
    expect(withOpeningChanged(draft, id, { to: 4050 })).toBeNull();
  });

  it("puts openings where most of a wall is free, of a side of a room", () => {
    const north = { axis: "x", inward: 1 } as const;
    const at = (draft: Draft, kind: "door" | "window", room: string, side: object) => withOpeningAt(draft, kind, room, side);
    const first = at(three(), "window", "room_1", north) as { draft: Draft };
    expect(first.draft.openings[0]).toMatchObject({ axis: "x", line: 0, from: 1300, to: 2700 });
    const second = at(first.draft, "door", "room_1", north) as { draft: Draft };
    expect(second.draft.openings[1]).toMatchObject({ line: 0, from: 200, to: 1100, swing: 1 });
    expect(at(second.draft, "window", "room_1", north)).toBeNull();
    expect(at(three(), "door", "room_3", north)?.draft.openings[0]).toMatchObject({ line: 3000, from: 1550, to: 2450 }); // to the wider of both rooms beyond
    const narrow = drawn([0, 0, 1600, 3000]); // a window leaves less on either side than it takes itself
    const taken = at(narrow, "window", "room_1", north) as { draft: Draft };
    expect([taken.draft.openings[0]?.to, at(taken.draft, "door", "room_1", north)]).toEqual([1500, null]);
    const shape = reshaped(drawn([0, 0, 4000, 4000]), "room_1", box(0, 0, 1000, 1000), "cut") as Draft;
    expect(at(shape, "door", "room_1", north)?.draft.openings[0]).toMatchObject({ line: 0, from: 2050 }); // the longer of two walls in the north
  });

  it("puts what is clicked where walls meet into the wall of one pair of rooms", () => {
    const rooms = drawn([0, 0, 5000, 4000], [5000, 0, 8000, 4000], [0, 4000, 4000, 7500], [4000, 4000, 5500, 7500], [5500, 4000, 8000, 7500]);
    const put = (x: number, z: number, kind: "door" | "window" = "door") => withOpening(rooms, kind, { x, z }, 300)?.draft as Draft;
    const door = put(4700, 4000);
    expect(door.openings[0]).toMatchObject({ axis: "x", line: 4000, from: 4050, to: 4950, isMainEntrance: false });
    const { rooms: made } = sceneOf(door);
    expect(made.map(({ id, openings }) => [id, openings.map(({ connects_to: to }) => to)])).toEqual([["room_1", ["room_4"]], ["room_2", []], ["room_3", []], ["room_4", ["room_1"]], ["room_5", []]]);
    expect(put(4050, 4000, "window").openings[0]).toMatchObject({ from: 4050, to: 4950 }); // narrower: there is no more wall
    expect(withOpening(rooms, "door", { x: 5250, z: 4000 }, 100)).toBeNull(); // these two share half a metre
    expect(openingMoved(door, "door_1", { x: 5100, z: 4000 }, 200)?.openings[0]).toMatchObject({ from: 4050, to: 4950 });
    expect(withOpeningChanged(door, "door_1", { to: 5100 })).toBeNull();
    expect(withOpeningChanged(door, "door_1", { height: 2000 })?.openings[0]).toMatchObject({ height: 2000 });
  });

  it("has every opening between the same two rooms all along, wherever it was clicked", () => {
    for (let seed = 0; seed < 40; seed += 1) {
      const draw = draws(seed);
      const cut = (): number => 1500 + 50 * Math.floor(draw() * 60);
      const [a, b, c] = [cut(), cut(), cut() + 500];
      let plan = drawn([0, 0, a, 3000], [a, 0, 7000, 3000], [0, 3000, b, 6000], [b, 3000, 7000, 6000], [0, 6200, c, 9000], [c, 6200, 7000, 9000]);
      for (let k = 0; k < 30; k += 1) plan = withOpening(plan, draw() < 0.7 ? "door" : "window", { x: draw() * 7000, z: draw() * 9000 }, 700)?.draft ?? plan;
      expect(plan.openings.length).toBeGreaterThan(5);
      for (const { axis, line, from, to } of plan.openings) {
        const beside = (along: number): string => [-350, 50].map((off) => {
          const across = line + (off < 0 ? Math.min(-1, off + 300) : off);
          const [x, z] = axis === "x" ? [along, across] : [across, along];
          return plan.rooms.find(({ corners }) => { const { x0, z0, x1, z1 } = boxOf(corners); return x0 < x && x < x1 && z0 < z && z < z1; })?.id ?? "outside";
        }).join();
        const seen = new Set(Array.from({ length: (to - from) / 50 - 1 }, (_, i) => beside(from + 25 + 50 * i)));
        expect(seen.size, `seed ${seed}: ${axis} ${line} ${from}-${to}: ${[...seen].join("; ")}`).toBe(1);
      }
    }
  });

  it("has one main entrance: the first door that leads outside", () => {
    const outside = withOpening(withOpening(three(), "door", { x: 2000, z: 3000 }, 100)?.draft as Draft, "door", { x: 1000, z: 5000 }, 100)?.draft as Draft;
    expect(outside.openings.map(({ isMainEntrance }) => isMainEntrance)).toEqual([false, true]);
    const third = withOpening(outside, "door", { x: 5000, z: 5000 }, 100) as { draft: Draft; id: string };
    const changed = withOpeningChanged(third.draft, third.id, { isMainEntrance: true }) as Draft;
    expect(changed.openings.map(({ isMainEntrance }) => isMainEntrance)).toEqual([false, false, true]);
  });

  it("tells what doors and windows went with a wall, not what was deleted", () => {
    const window = withOpening(three(), "window", { x: 5500, z: 0 }, 100) as { draft: Draft; id: string };
    const cut = reshaped(window.draft, "room_2", box(4000, 0, 7000, 2000), "cut") as Draft;
    expect([openingsLost(window.draft, cut), openingsLost(cut, window.draft), openingsLost(window.draft, withoutOpening(window.draft, window.id))]).toEqual([1, 0, 0]);
    expect(openingsLost(window.draft, withoutRoom(window.draft, "room_2"))).toBe(0);
  });

  it("adds to a room and cuts from it, but not onto another", () => {
    expect(reshaped(three(), "room_1", box(1000, -1000, 2000, 1000), "add")?.rooms[0]?.corners).toHaveLength(8);
    expect(reshaped(three(), "room_1", box(1000, 1000, 5000, 2000), "add")).toBeNull();
  });
});

describe("a scene", () => {
  const home = () => scene([
    room("den", [0, 0, 4, 3], { openings: [opening({ id: "way", wall: "east", position: 1.5, connects_to: "hall", swing: "in" })], furniture: [piece("sofa", { x: 2, z: 0.5 })] }),
    room("hall", [4, 0, 2, 3], { openings: [opening({ id: "way", wall: "west", position: 1.5, connects_to: "den", swing: "out", render_panel: false })] }),
  ]);

  it("comes back from the plan as it was", () => {
    const again = sceneOf(draftOf(home()));
    expect(again.rooms.map(({ id, x, z, width, depth }) => [id, x, z, width, depth])).toEqual([["den", 0, 0, 4, 3], ["hall", 4, 0, 2, 3]]);
    for (const [i, one] of again.rooms.entries()) {
      expect(one.openings).toEqual([{ ...home().rooms[i]?.openings[0], sill: 0 }]);
      expect(one.furniture).toEqual(home().rooms[i]?.furniture);
    }
  });

  it("keeps furniture where it stands in the house when a wall moves, and takes it along when the room does", () => {
    const draft = draftOf(home());
    const wider = wallMoved(draft, "den", 3, -1000) as Draft;
    expect(sceneOf(wider).rooms[0]).toMatchObject({ x: -1, width: 5, furniture: [{ x: 3, z: 0.5 }] });
    expect(reshapedRooms(wider)).toEqual(new Set(["den"]));
    const away = roomMoved(draft, "den", -1000, 500) as Draft;
    expect(sceneOf(away).rooms[0]).toMatchObject({ x: -1, z: 0.5, width: 4, furniture: [{ x: 2, z: 0.5 }] });
    expect(reshapedRooms(away)).toEqual(new Set());
    expect(atOrigin(sceneOf(away)).rooms.map(({ x, z }) => [x, z])).toEqual([[0, 0.5], [5, 0]]);
  });

  it("has outdoors what is drawn as a room of the outdoors, and indoors what becomes one of the inside", () => {
    const garden = withType(three(), "room_1", "backyard", true);
    expect(sceneOf(garden).rooms.map(({ outdoor }) => outdoor)).toEqual([true, false, false]);
    const again = withType(draftOf(sceneOf(garden)), "room_1", "kitchen", false);
    expect(sceneOf(again).rooms.map(({ outdoor }) => outdoor)).toEqual([false, false, false]);
  });

  it("says walls of rooms that are no rectangles by their corners", () => {
    const shape = reshaped(three(), "room_3", box(5000, 4000, 7000, 5000), "cut") as Draft;
    const door = withOpening(shape, "door", { x: 6000, z: 4000 }, 100)?.draft as Draft;
    const hall = sceneOf(door).rooms[2];
    expect(hall?.outline).toEqual([[0, 0], [7, 0], [7, 1], [5, 1], [5, 2], [0, 2]]);
    expect(hall?.openings[0]).toMatchObject({ wall: null, edge: 2, position: 1, connects_to: "EXTERIOR", main_entrance: true });
    expect(draftOf(sceneOf(door)).openings).toEqual(door.openings);
  });

  it("leaves other storeys and walls at an angle as they are", () => {
    const slanted = room("slanted", [6, 0, 2, 3], { outline: [[0, 0], [2, 1], [2, 3], [0, 3]] });
    const above = room("above", [0, 0, 4, 3], { level: 1 });
    const whole = scene([...home().rooms, slanted, above]);
    const draft = draftOf(whole);
    expect(draft.rooms.map(({ id }) => id)).toEqual(["den", "hall"]);
    expect(sceneOf(draft).rooms.slice(2)).toEqual([{ ...slanted, index: 2 }, { ...above, index: 3 }]);
  });
});

describe("drawing", () => {
  it("snaps to walls, else to five centimetres, and freely to one", () => {
    const lines = linesOf(three());
    expect(snapped(4033, lines.x, 60, false)).toBe(4000);
    expect(snapped(4133, lines.x, 60, false)).toBe(4150);
    expect(snapped(4033, lines.x, 60, true)).toBe(4030);
    expect(snappedShift(box(0, 0, 1000, 1000), { x: 2960, z: 333 }, lines, 60, false)).toEqual({ x: 3000, z: 350 });
    expect(wallsOf(three().rooms[0]?.corners ?? [])).toHaveLength(4);
  });

  it("undoes all the way back and forth again, and forgets a drag that was given up", () => {
    const plan = new DrawnPlan(EMPTY);
    const states = [EMPTY, drawn([0, 0, 2000, 2000]), three()];
    for (const state of states.slice(1)) plan.step(state);
    plan.show(EMPTY);
    plan.cancel();
    expect(plan.draft).toBe(states[2]);
    plan.choose({ room: "room_3" });
    plan.undo();
    expect(plan.chosen.room).toBeNull();
    plan.undo();
    expect([plan.draft, plan.canUndo]).toEqual([EMPTY, false]);
    plan.redo();
    plan.redo();
    expect([plan.draft, plan.canRedo]).toEqual([states[2], false]);
  });

  it("keeps what was drawn and never shown when another plan is begun", () => {
    const [plan, drew, other] = [new DrawnPlan(EMPTY), three(), drawn([0, 0, 2000, 2000])];
    plan.step(drew);
    for (const begun of [EMPTY, EMPTY, other]) plan.open(begun);
    expect(plan.draft).toBe(other);
    plan.undo();
    plan.undo();
    expect(plan.draft).toBe(drew);
    plan.finish();
    plan.open(EMPTY);
    expect([plan.draft, plan.canUndo, plan.canRedo]).toEqual([EMPTY, false, false]);
  });

  it("has no picture to scale before one is laid", () => {
    expect(new PictureBeneath().setScale(1000)).toBe(false);
  });
});
