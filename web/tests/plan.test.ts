import { describe, expect, it } from "vitest";
import { edgesOf } from "../src/house/plan";
import { slab, stripsOf } from "../src/house/slab";
import { runsOf, type Run } from "../src/house/wall_runs";
import { room } from "./rooms";

const brief = (run: Run): string => `${run.axis}@${run.line} ${run.from}-${run.to} ${run.kind}`;
const runs = (...rooms: Parameters<typeof runsOf>[0][number][]): string[] => runsOf(rooms, 0.1).map(brief).sort();

describe("edges of a room", () => {
  it("are its four walls, each facing inwards", () => {
    const edges = edgesOf(room("a", [1, 2, 4, 3]));
    expect(edges.map(({ side, axis, line, from, to, inward }) => [side, axis, line, from, to, inward])).toEqual([
      ["north", "x", 2, 1, 5, 1],
      ["east", "z", 5, 2, 5, -1],
      ["south", "x", 5, 1, 5, -1],
      ["west", "z", 1, 2, 5, 1],
    ]);
  });

  it("follow an outline clockwise from the north-west", () => {
    const outline: [number, number][] = [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]];
    const backwards = edgesOf(room("a", [0, 0, 4, 4], { outline: [...outline].reverse() })).map(({ side }) => side);
    expect(backwards.sort()).toEqual(["east", "east", "north", "south", "south", "west"]);
    const sides = edgesOf(room("a", [0, 0, 4, 4], { outline })).map((edge) => edge.side);
    expect(sides).toEqual(["north", "east", "south", "east", "south", "west"]);
  });
});

describe("runs of wall", () => {
  it("go around one room", () => {
    expect(runs(room("a", [0, 0, 4, 3]))).toEqual(["x@0 0-4 wall", "x@3 0-4 wall", "z@0 0-3 wall", "z@4 0-3 wall"]);
  });

  it("draw a wall shared piece by piece with several rooms once", () => {
    const off = { north: true, south: true, east: true, west: false };
    const drawn = runs(
      room("a", [0, 0, 4, 6]),
      room("b", [4, 0, 3, 2.5], { wall_flags: off }),
      room("c", [4, 2.5, 3, 3.5], { wall_flags: off }),
    );
    expect(drawn).toContain("z@4 0-6 wall");
    expect(drawn.filter((run) => run.startsWith("z@4"))).toHaveLength(1);
  });

  it("leave no hole where one side of a wall is shared only in part", () => {
    const drawn = runs(
      room("a", [0, 0, 4, 3]),
      room("b", [4, 0, 4, 6], { wall_flags: { north: true, south: true, east: true, west: false } }),
    );
    expect(drawn).toContain("z@4 0-3 wall");
    expect(drawn).not.toContain("z@4 0-6 wall");
  });

  it("are railings outdoors, but not against a room indoors", () => {
    const drawn = runs(room("a", [0, 0, 4, 3]), room("b", [4, 0, 4, 3], { outdoor: true }));
    expect(drawn).toEqual([
      "x@0 0-4 wall", "x@0 4-8 railing", "x@3 0-4 wall", "x@3 4-8 railing", "z@0 0-3 wall", "z@4 0-3 wall", "z@8 0-3 railing",
    ]);
  });

  it("are railings between two rooms outdoors", () => {
    const drawn = runs(room("a", [0, 0, 4, 3], { outdoor: true }), room("b", [4, 0, 4, 3], { outdoor: true }));
    expect(drawn).toContain("z@4 0-3 railing");
    expect(drawn.filter((run) => run.endsWith("wall"))).toEqual([]);
  });

  it("meet although adding metres in binary does not", () => {
    const shared = runs(room("a", [0, 0, 0.1 + 0.2, 3]), room("b", [0.3, 0, 2, 3])).filter((run) => run.startsWith("z@0.3"));
    expect(shared).toEqual(["z@0.3 0-3 wall"]);
  });

  it("keep levels apart", () => {
    expect(runs(room("a", [0, 0, 4, 3]), room("b", [0, 0, 4, 3], { level: 1 }))).toHaveLength(8);
  });
});

describe("the slab", () => {
  it("lies under each room's floor, also of one that is no rectangle", () => {
    const outline = [[0, 0], [4, 0], [4, 1], [2, 1], [2, 3], [0, 3]] as const;
    expect(stripsOf(room("den", [1, 2, 4, 3], { outline }))).toEqual([{ x0: 1, x1: 5, z0: 2, z1: 3 }, { x0: 1, x1: 3, z0: 3, z1: 5 }]);
    expect(stripsOf(room("box", [0, 0, 4, 3]))).toEqual([{ x0: 0, x1: 4, z0: 0, z1: 3 }]);
    expect(slab([], 0)).toBeNull();
  });
});
