import { describe, expect, it } from "vitest";
import type { Catalog, Scene } from "../src/contract";
import { drawable } from "../src/house/drawable";
import { bodiesOf } from "../src/house/frame";
import { piece, room, scene } from "./rooms";

const bare = {
  seed: null, size: null, wall_thickness: 0, levels: [], dynamic: [],
  rooms: [{
    id: "den", index: 0, type: "storage", level: 0, x: 1, z: 2, width: 4, depth: 3, flooring: null, accent: null, wall_flags: null,
    openings: [], furniture: [], decorations: [],
  }],
} as unknown as Scene;

describe("a scene that leaves things unsaid", () => {
  it("is as large as its rooms reach, and has floors and walls", () => {
    const { size, levels, rooms } = drawable(bare);
    expect(size).toEqual({ width: 5, depth: 5, height: 2.8 });
    expect(levels).toHaveLength(1);
    expect(rooms[0]?.flooring.color).toMatch(/^#/);
    expect(Object.values(rooms[0]?.wall_flags ?? {})).toEqual([true, true, true, true]);
  });

  it("is as high as its size says, where it lists no storeys and has one", () => {
    const low = { ...bare, size: { width: 5, depth: 5, height: 2.3 } };
    expect(drawable(low).levels).toEqual([{ index: 0, elevation: 0, height: 2.3 }]);
    const [den] = bare.rooms;
    const above = { ...low, rooms: [{ ...den, level: 2 }] } as unknown as Scene;
    expect(drawable(above).levels).toMatchObject([{ index: 2, height: 2.3 }]);
  });

  it("has the storeys that it does not list one on another", () => {
    const [den] = bare.rooms;
    const on = (...levels: number[]): Scene => ({ ...bare, rooms: levels.map((level) => ({ ...den, id: `den_${level}`, level })) }) as unknown as Scene;
    const standing = (scene: Scene) => drawable(scene).levels?.map(({ index, elevation, height }) => [index, elevation, height]);
    expect(standing(on(1, 0, 2, 1))).toEqual([[0, 0, 2.8], [1, 2.8, 2.8], [2, 5.6, 2.8]]);
    const [body] = bodiesOf(scene([room("attic", [0, 0, 4, 3], { level: 1, furniture: [piece("trunk", { y: 0.5 })] }), room("den", [0, 0, 4, 3])], { levels: [] }));
    expect(body?.y, "also where it is edited").toBe(3.3);
    expect(standing({ ...on(0, 1), levels: [{ index: 0, elevation: -1, height: 4 }] } as unknown as Scene)).toEqual([[0, -1, 4], [1, 3, 2.8]]);
    expect(standing({ ...on(0, 1), levels: [{ index: 1, elevation: 3, height: 3 }] } as unknown as Scene)).toEqual([[1, 3, 3], [0, 0, 2.8]]);
  });

  it("has the plain floor and the colour of its rooms' types, where the catalog knows them", () => {
    const catalog = { rooms: { storage: { accent: "#123456", flooring: "tile" } }, floorings: { tile: { color: "#abcdef" } } } as unknown as Catalog;
    expect(drawable(bare, catalog).rooms[0]).toMatchObject({ flooring: { type: "tile", color: "#abcdef" }, accent: "#123456" });
    const [den] = bare.rooms;
    const laid = { ...bare, rooms: [{ ...den, flooring: { type: "wood", color: "#000001" } }] } as unknown as Scene;
    expect(drawable(laid, catalog).rooms[0]?.flooring).toEqual({ type: "wood", color: "#000001" });
    expect(drawable({ ...bare, rooms: [{ ...den, type: "crypt" }] } as unknown as Scene, catalog).rooms[0]?.flooring.type).toBe("plain");
  });

  it("has bodies in the colours of their kinds, and in their own where they say one", () => {
    const catalog = { furniture: { desk: { color: "#111111" } }, decorations: { vase: { color: "#222222" } } } as unknown as Catalog;
    const [den] = bare.rooms;
    const bodies = { furniture: [{ id: "a", kind: "desk", color: null }], decorations: [{ id: "b", kind: "vase", color: null }, { id: "c", kind: "vase", color: "#333333" }, { id: "d" }] };
    const [room] = drawable({ ...bare, rooms: [{ ...den, ...bodies }] } as unknown as Scene, catalog).rooms;
    expect(room?.furniture.map(({ color }) => color)).toEqual(["#111111"]);
    expect(room?.decorations.map(({ color }) => color)).toEqual(["#222222", "#333333", undefined]);
  });

  it("keeps what is said", () => {
    const said = { ...bare, size: { width: 9, depth: 8, height: 3 }, levels: [{ index: 0, elevation: 1, height: 3 }] };
    expect(drawable(said)).toMatchObject({ size: { width: 9 }, levels: [{ elevation: 1 }] });
  });

  it("is not changed itself", () => {
    const before = JSON.stringify(bare);
    drawable(bare);
    expect(JSON.stringify(bare)).toBe(before);
  });
});
