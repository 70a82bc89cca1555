import { describe, expect, it } from "vitest";
import type { Decoration, Dynamic, Scene } from "../src/contract";
import { added, alone, carriedBy, companionsOf, keptCompanions, moved, posesOf, repaired, withRoom, without } from "../src/edit/scene_edits";
import { opening, piece, room, scene } from "./rooms";

const thing = (id: string, more: Partial<Decoration> = {}): Decoration => ({
  id, name: "vase", x: 1, y: 0.75, z: 1, rotation: 0, width: 0.2, depth: 0.2, height: 0.3, ...more,
});
const person = (id: string, more: Partial<Dynamic> = {}): Dynamic => ({
  id, kind: "person", room: "den", x: 1, y: 0.4, z: 1, rotation: 0, width: 0.5, depth: 0.3, height: 1.2, ...more,
});

/** A table with two chairs, one locked, and somebody on a chair; a vase on a tray on the table, a picture over it. */
function diner(): Scene {
  const furniture = [
    piece("table", { x: 2, z: 2, width: 1.6, depth: 0.9, wall: "north" }),
    piece("near", { x: 2, z: 2.55, width: 0.46, depth: 0.5, rotation: 180, under: "table" }),
    piece("held", { x: 2, z: 1.45, width: 0.46, depth: 0.5, under: "table", locked: true }),
    piece("sofa", { x: 4.5, z: 4 }),
  ];
  const decorations = [
    thing("tray", { x: 2.3, z: 2, parent: "table" }), thing("vase", { x: 2.3, z: 2.1, rotation: 10, parent: "tray" }),
    thing("picture", { x: 2, z: 0.1, parent: "table", mounted_on_wall: "north" }), thing("plant", { x: 5, z: 1, y: 0 }),
  ];
  const den = room("den", [0, 0, 6, 5], { furniture, decorations, openings: [opening({ connects_to: "hall" }), opening({ id: "pane", kind: "window" })] });
  return scene([den, room("hall", [0, 5, 6, 2])], { dynamic: [person("eater", { x: 2, z: 2.55, on: "near" }), person("other", { room: "hall" })] });
}

const spots = (shown: Scene): Record<string, readonly number[]> => Object.fromEntries(
  [...shown.rooms.flatMap((one) => [...one.furniture, ...one.decorations]), ...shown.dynamic].map(({ id, x, z, rotation }) => [id, [x, z, rotation]]),
);

describe("a piece in hand", () => {
  it("takes along what it carries and its chairs, with who sits on them, and nothing else", () => {
    const before = diner();
    expect(carriedBy(before, "table")).toEqual(new Set(["table", "tray", "vase"]));
    expect(companionsOf(before, "table")).toEqual(new Set(["near", "eater"]));
    const after = spots(moved(before, "table", { x: 3, z: 2.5, rotation: 0 }));
    const was = spots(before);
    for (const id of ["table", "tray", "vase", "near", "eater"]) {
      expect(after[id]).toEqual([expect.closeTo((was[id]?.[0] ?? 0) + 1, 6), expect.closeTo((was[id]?.[1] ?? 0) + 0.5, 6), was[id]?.[2]]);
    }
    for (const id of ["held", "sofa", "picture", "plant", "other"]) expect(after[id]).toEqual(was[id]);
  });

  it("turns all of them about itself, counter-clockwise seen from above", () => {
    const after = spots(moved(diner(), "table", { x: 2, z: 2, rotation: 90 }));
    expect(after.table).toEqual([2, 2, 90]);
    expect(after.near).toEqual([expect.closeTo(2.55, 6), expect.closeTo(2, 6), 270]);
    expect(after.vase).toEqual([expect.closeTo(2.1, 6), expect.closeTo(1.7, 6), 100]);
  });

  it("need not stand at its wall, and has its edges on whole millimetres", () => {
    const { furniture } = moved(diner(), "near", { x: 1.23456, z: 2, rotation: 180 }).rooms[0] ?? room("none", [0, 0, 1, 1]);
    const chair = furniture.find(({ id }) => id === "near");
    expect(chair?.x).toBe(1.235);
    expect(moved(diner(), "table", { x: 3, z: 3, rotation: 0 }).rooms[0]?.furniture[0]?.wall).toBeNull();
  });

  it("leaves the scene it was moved in as it was", () => {
    const before = diner();
    const copy = structuredClone(before);
    moved(before, "table", { x: 3, z: 3, rotation: 90 });
    without(before, "table");
    expect(before).toEqual(copy);
  });
});

it("knows which chairs an answer left at their table", () => {
  const before = diner();
  const wished = moved(before, "table", { x: 3, z: 2.5, rotation: 0 });
  expect(keptCompanions(before, wished, "table")).toEqual(new Set(["near", "eater"]));
  const parted = moved(wished, "near", { x: 1, z: 4, rotation: 180 });
  expect(keptCompanions(before, parted, "table")).toEqual(new Set());
});

describe("a room alone", () => {
  it("has its people, its doors as ways in, and the windows it had", () => {
    const asked = alone(diner(), "den");
    expect(asked.rooms.map(({ id }) => id)).toEqual(["den"]);
    expect(asked.dynamic.map(({ id }) => id)).toEqual(["eater"]);
    expect(asked.rooms[0]?.openings.map((one) => one.connects_to)).toEqual(["EXTERIOR", "hallway_0"]);
  });

  it("goes back into its house with the doors the house has", () => {
    const before = diner();
    const answer = moved(alone(before, "den"), "sofa", { x: 4, z: 4, rotation: 0 });
    const after = withRoom(before, answer);
    expect(after).toEqual(moved(before, "sofa", { x: 4, z: 4, rotation: 0 }));
    expect(after.rooms[0]?.openings).toBe(before.rooms[0]?.openings);
  });

  it("says where its furniture and what stands on its floor is", () => {
    expect(posesOf(diner(), "den").map(({ id }) => id)).toEqual(["table", "near", "held", "sofa", "plant"]);
  });
});

describe("what is taken away and added", () => {
  it("goes with all that lies on it; its chairs stay, and who sat on it stands", () => {
    const bare = without(diner(), "table");
    expect(Object.keys(spots(bare)).sort()).toEqual(["eater", "held", "near", "other", "picture", "plant", "sofa"]);
    expect(bare.rooms[0]?.furniture.map(({ under }) => under)).toEqual([null, null, undefined]);
    expect(without(diner(), "near").dynamic[0]).toMatchObject({ id: "eater", on: null, y: 0 });
  });

  it("gets the next free number", () => {
    const kind = { key: "crate", name: "crate", category: "storage", size: [1, 0.5, 0.5] as const, color: null };
    const once = added(diner(), "den", kind);
    const twice = added(once.scene, "den", kind);
    expect([once.id, twice.id]).toEqual(["den/crate_1", "den/crate_2"]);
    expect(twice.scene.rooms[0]?.furniture.at(-1)).toMatchObject({ id: "den/crate_2", x: 3, z: 2.5, width: 1, depth: 0.5, wall: null });
  });
});

it("does what each repair says", () => {
  const of = (after: Scene, id: string) => after.rooms[0]?.furniture.find((one) => one.id === id);
  const before = diner();
  expect(of(repaired(before, { action: "move", id: "table", wall: null, dx: 0, dz: 0, rotation: 0 }), "table")?.wall).toBeNull();
  expect(of(repaired(before, { action: "unlock", id: "held", dx: 0, dz: 0, rotation: 0 }), "held")?.locked).toBe(false);
  expect(of(repaired(before, { action: "turn", id: "sofa", rotation: 90 }), "sofa")?.rotation).toBe(90);
  expect(of(repaired(before, { action: "shrink", id: "sofa", width: 1.5, depth: 0.8 }), "sofa")).toMatchObject({ width: 1.5, depth: 0.8 });
  expect(of(repaired(before, { action: "leave_out", id: "sofa" }), "sofa")).toBeUndefined();
});
