import { describe, expect, it } from "vitest";
import type { Decoration, Scene } from "../src/contract";
import { footprint } from "../src/edit/gaps";
import { aligned, changedThing, clipped, hungOver, laidAs, pasted, resizedIn, shifted, stoodSo, transferred, withoutThing, type Alignment } from "../src/edit/many_edits";
import { drawing } from "./random_requests";
import { piece, room, scene } from "./rooms";

const thing = (id: string, more: Partial<Decoration> = {}): Decoration =>
  ({ id, name: "vase", parent: null, mounted_on_wall: null, x: 1, y: 0, z: 1, rotation: 0, width: 0.2, depth: 0.2, height: 0.3, color: "#fff", ...more });

function house(): Scene {
  const table = piece("den/table_1", { name: "table", x: 2, z: 2, width: 1.6, depth: 0.9 });
  const chair = piece("den/chair_1", { name: "chair", x: 2, z: 1.2, width: 0.5, depth: 0.5, under: "den/table_1" });
  const tv = piece("den/tv_1", { name: "tv", x: 2.2, z: 2, y: 0.8, width: 0.4, depth: 0.2, on: "den/table_1" });
  const bed = piece("den/bed_1", { name: "bed", x: 5, z: 3, width: 1.6, depth: 2, rotation: 90, locked: true });
  const things = [thing("den/tray_1", { parent: "den/table_1", x: 1.8, z: 2, y: 0.8 }), thing("den/cup_1", { parent: "den/tray_1", x: 1.8, z: 2, y: 0.83 }), thing("den/art_1", { mounted_on_wall: "north", y: 1.5, z: 0.07 })];
  return scene([room("den", [0, 0, 7, 5], { furniture: [table, chair, tv, bed], decorations: things }), room("hall", [7, 1, 4, 4], { furniture: [piece("hall/rack_1", { name: "rack", width: 0.6, depth: 0.4 })] })], {
    dynamic: [{ id: "ann", kind: "person", room: "den", x: 2, y: 0.45, z: 1.2, rotation: 0, width: 0.4, depth: 0.4, height: 1.2, on: "den/chair_1" }],
  });
}

/** Where every body is in the house, by id [m]. */
function places(all: Scene): Map<string, readonly [number, number]> {
  const rooms = new Map(all.rooms.map((one) => [one.id, one]));
  const bodies = all.rooms.flatMap((one) => [...one.furniture, ...one.decorations].map((body) => [body.id, [body.x + one.x, body.z + one.z]] as const));
  const people = all.dynamic.map((body) => [body.id, [body.x + (rooms.get(body.room)?.x ?? 0), body.z + (rooms.get(body.room)?.z ?? 0)]] as const);
  return new Map([...bodies, ...people]);
}

describe("several things", () => {
  it("move by as much, each once, with all that goes along; what is not theirs stays", () => {
    const [before, after] = [places(house()), places(shifted(house(), ["den/table_1", "den/chair_1", "hall/rack_1"], 0.3, -0.2))];
    const goes = new Set(["den/table_1", "den/chair_1", "den/tv_1", "den/tray_1", "den/cup_1", "ann", "hall/rack_1"]);
    for (const [id, [x, z]] of before) {
      expect([id, ...(after.get(id) ?? [])]).toEqual([id, expect.closeTo(goes.has(id) ? x + 0.3 : x, 9), expect.closeTo(goes.has(id) ? z - 0.2 : z, 9)]);
    }
    expect(places(shifted(house(), ["den/art_1"], 0.5, 0.5)).get("den/art_1")).toEqual([1.5, 0.07]);
  });

  it("go there and back to the byte, whatever is chosen", () => {
    const draw = drawing(3);
    const ids = [...places(house()).keys()].filter((id) => id !== "ann");
    for (let i = 0; i < 200; i += 1) {
      const some = ids.filter(() => draw() < 0.4);
      const [dx, dz] = [Math.round(draw() * 2000) / 1000, Math.round(draw() * 2000) / 1000];
      const free = shifted(house(), some, 0, 0);
      expect(JSON.stringify(shifted(shifted(house(), some, dx, dz), some, -dx, -dz))).toBe(JSON.stringify(free));
    }
  });

  it("line up with the first, by edges or middles, in the house's frame; what is locked stays", () => {
    const edge = (all: Scene, id: string, how: Alignment): number => {
      for (const one of all.rooms) for (const body of one.furniture) {
        if (body.id !== id) continue;
        const axis = how === "west" || how === "east" || how === "across" ? "x" as const : "z" as const;
        const [low, high] = footprint(body)[axis];
        return one[axis] * 1000 + (how === "west" || how === "north" ? low : how === "east" || how === "south" ? high : (low + high) / 2);
      }
      return NaN;
    };
    for (const how of ["west", "east", "north", "south", "across", "along"] as const) {
      const after = aligned(house(), ["den/table_1", "hall/rack_1", "den/bed_1"], how);
      expect(edge(after, "hall/rack_1", how)).toBeCloseTo(edge(house(), "den/table_1", how), 6);
      expect(places(after).get("den/bed_1")).toEqual(places(house()).get("den/bed_1"));
    }
  });
});

describe("copies", () => {
  it("bring all that a piece carries, with ids of their own, and stand on each other as it did", () => {
    const { scene: after, ids } = pasted(house(), "hall", clipped(house(), ["den/table_1"]), 0.1, 0);
    const hall = after.rooms[1];
    expect(ids).toEqual(["hall/table_1"]);
    expect(hall?.furniture.map(({ id, on }) => [id, on ?? null])).toEqual([["hall/rack_1", null], ["hall/table_1", null], ["hall/tv_1", "hall/table_1"]]);
    expect(hall?.decorations.map(({ id, parent }) => [id, parent])).toEqual([["hall/vase_1", "hall/table_1"], ["hall/vase_2", "hall/vase_1"]]);
    expect(after.rooms[0]).toEqual(house().rooms[0]);
    const all = [...places(after).keys()];
    expect(new Set(all).size).toBe(all.length);
  });

  it("of copies never share an id", () => {
    const clips = clipped(house(), ["den/table_1", "den/bed_1", "den/art_1"]);
    let all = house();
    for (let i = 0; i < 5; i += 1) all = pasted(all, "den", clips, 0.1, 0).scene;
    const ids = [...all.rooms.flatMap((one) => [...one.furniture, ...one.decorations].map(({ id }) => id))];
    expect([new Set(ids).size, ids.length]).toEqual([ids.length, 8 + 5 * 6]);
  });
});

describe("a piece dragged into another room", () => {
  it("belongs there with all that goes along, where it was in the house; back again it is as before", () => {
    const over = transferred(house(), "den/table_1", "hall");
    expect(places(over)).toEqual(new Map([...places(house())].map(([id, [x, z]]) => [id, [expect.closeTo(x, 9), expect.closeTo(z, 9)]])));
    expect(over.rooms[1]?.furniture.map(({ id }) => id)).toEqual(["hall/rack_1", "den/table_1", "den/chair_1", "den/tv_1"]);
    expect([over.rooms[0]?.decorations.map(({ id }) => id), over.dynamic[0]?.room]).toEqual([["den/art_1"], "hall"]);
    const sorted = (all: Scene) => all.rooms.map((one) => [...one.furniture, ...one.decorations].map((body) => JSON.stringify(body)).sort());
    expect(sorted(transferred(over, "den/table_1", "den"))).toEqual(sorted(changed(house())));
    expect(transferred(house(), "den/table_1", "den")).toEqual(house());
  });
});

/** As it is once the table was in hand: at no wall, under nothing, on nothing. */
function changed(all: Scene): Scene {
  return { ...all, rooms: all.rooms.map((one) => ({ ...one, furniture: one.furniture.map((body) => (body.id === "den/table_1" ? { ...body, wall: null, under: null, on: null } : body)) })) };
}

describe("a decoration", () => {
  it("takes along what lies on it, and goes with it", () => {
    const moved = changedThing(house(), "den/tray_1", { x: 2.1, y: 0.9, parent: null });
    expect(moved.rooms[0]?.decorations.map(({ id, x, y }) => [id, x, y])).toEqual([["den/tray_1", 2.1, 0.9], ["den/cup_1", 2.1, expect.closeTo(0.93, 9)], ["den/art_1", 1, 1.5]]);
    expect(withoutThing(house(), "den/tray_1").rooms[0]?.decorations.map(({ id }) => id)).toEqual(["den/art_1"]);
    expect(withoutThing(house(), "den/art_1").rooms[0]?.decorations).toHaveLength(2);
  });
});

describe("another way to stand", () => {
  it("puts all where they would stand, with what they carry, and leaves out who has no place", () => {
    const way = (id: string, x: number, z: number, rotation: number) => ({ id, kind: "table", x, y: 0, z, rotation, width: 1.6, depth: 0.9, height: 0.75, on: null });
    const after = stoodSo(house(), [way("den/table_1", 3, 3, 90)], ["den/bed_1"]).rooms[0];
    const at = (id: string) => [...(after?.furniture ?? []), ...(after?.decorations ?? [])].find((body) => body.id === id);
    expect(at("den/table_1")).toMatchObject({ x: 3, z: 3, rotation: 90, kind: "table", height: 0.75 });
    expect([at("den/tray_1")?.x, at("den/tray_1")?.z]).toEqual([expect.closeTo(3, 3), expect.closeTo(3.2, 3)]);
    expect(at("den/bed_1")).toBeUndefined();
  });

  it("has what lies on a piece that becomes smaller within it, wherever it is turned, and sets down what has its own place", () => {
    const way = (rotation: number) => [
      { id: "den/table_1", kind: "small_table", x: 3, y: 0, z: 3, rotation, width: 0.8, depth: 0.45, height: 0.7, on: null },
      { id: "den/tv_1", kind: "tv", x: 3.1, y: 0.7, z: 3, rotation, width: 0.4, depth: 0.2, height: 0.5, on: "den/table_1" },
    ];
    const before = house();
    const [den] = before.rooms;
    const table = den?.furniture.find(({ id }) => id === "den/table_1");
    const corner = { ...before, rooms: before.rooms.map((one) => ({ ...one, decorations: one.decorations.map((body) => (body.parent === null ? body : { ...body, x: 2.7, z: 2.4, y: body.y + (table?.height ?? 0) - 0.8 })) })) };
    for (const [rotation, x, z] of [[0, 3.35, 3.2], [90, 3.2, 2.65], [180, 2.65, 2.8], [270, 2.8, 3.35]] as const) {
      const after = stoodSo(corner, way(rotation), []).rooms[0];
      const at = (id: string) => [...(after?.furniture ?? []), ...(after?.decorations ?? [])].find((body) => body.id === id);
      for (const id of ["den/tray_1", "den/cup_1"]) expect([at(id)?.x, at(id)?.z], `${id} ${rotation}`).toEqual([expect.closeTo(x, 3), expect.closeTo(z, 3)]);
      expect([at("den/tray_1")?.y, at("den/cup_1")?.y]).toEqual([expect.closeTo(0.7, 3), expect.closeTo(0.73, 3)]);
      expect(at("den/tv_1")).toMatchObject({ x: 3.1, z: 3, y: 0.7 });
      expect(at("den/art_1")).toMatchObject({ z: 0.07, y: 1.5 });
    }
  });

  it("has on pieces of another size what lies on them elsewhere, under names of its own, and on the others what it had", () => {
    const way = { id: "den/table_1", kind: "table", x: 3, y: 0, z: 3, rotation: 0, width: 0.8, depth: 0.9, height: 0.75, on: null };
    const [before, there] = [house(), stoodSo(house(), [way], [])];
    expect([resizedIn(before, there), resizedIn(before, stoodSo(before, [{ ...way, width: 1.6, height: there.rooms[0]?.furniture[3]?.height ?? 0 }], []))]).toEqual([["den/table_1"], []]);
    const bowl = thing("den/bowl_1", { name: "bowl", parent: "den/table_1", x: 3, z: 3, y: 0.75 });
    const laid = [thing("den/art_1", { name: "art", parent: "den/table_1", x: 3.1, z: 3, y: 0.75 }), thing("den/apple_1", { name: "apple", parent: "den/art_1", x: 3.1, z: 3, y: 0.8 }), bowl, thing("den/clock_1", { mounted_on_wall: "east" })];
    const other = { ...there, rooms: there.rooms.map((one) => (one.id === "den" ? { ...one, decorations: laid } : one)) };
    const after = laidAs(there, other, ["den/table_1"]);
    expect(after.rooms[0]?.decorations.map(({ id, parent, x }) => [id, parent, x])).toEqual([
      ["den/art_1", null, there.rooms[0]?.decorations[2]?.x], ["den/art_2", "den/table_1", 3.1], ["den/apple_1", "den/art_2", 3.1], ["den/bowl_1", "den/table_1", 3],
    ]);
    expect({ ...after, rooms: after.rooms.map((one) => ({ ...one, decorations: [] })) }).toEqual({ ...there, rooms: there.rooms.map((one) => ({ ...one, decorations: [] })) });
  });

  it("has over pieces that moved, at the wall, what hangs over them elsewhere, and keeps what hangs over others", () => {
    const hung = (id: string, parent: string | null, wall: "east" | "north" | "south" | "west", x: number): Decoration => thing(id, { name: "art", parent, mounted_on_wall: wall, x });
    const hang = (all: readonly Decoration[]): Scene => {
      const scene = house();
      return { ...scene, rooms: scene.rooms.map((one) => (one.id === "den" ? { ...one, decorations: all } : one)) };
    };
    const before = hang([hung("den/art_1", "den/table_1", "north", 1), hung("den/art_2", "den/sofa_1", "east", 2), hung("den/art_3", null, "south", 3)]);
    const other = hang([hung("den/art_7", "den/table_1", "west", 4), hung("den/art_8", "den/sofa_1", "north", 5)]);
    expect(hungOver(before, new Set(["den/table_1", "den/rug_1"]))).toEqual(["den/art_1"]);
    const after = laidAs(before, other, [], new Set(["den/table_1"])).rooms.find(({ id }) => id === "den")?.decorations;
    expect(after?.map(({ parent, mounted_on_wall, x }) => [parent, mounted_on_wall, x])).toEqual([["den/sofa_1", "east", 2], [null, "south", 3], ["den/table_1", "west", 4]]);
  });
});
