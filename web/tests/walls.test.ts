import { Box3 } from "three";
import { describe, expect, it } from "vitest";
import type { Room, Side } from "../src/contract";
import { clipBelow } from "../src/house/boxes";
import { finishOf, outerPiecesOf } from "../src/house/finishes";
import { openingsOf } from "../src/house/openings";
import { runsOf } from "../src/house/wall_runs";
import { heightAt, LOW, sidesBefore, sidesOf } from "../src/house/wall_cut";
import { facesOf, type Face } from "../src/house/wall_faces";
import { Walls } from "../src/house/wall_meshes";
import type { WallPanel } from "../src/house/wall_panel";
import { between, fittingsOf, wallPanelsOf, type WallPlan } from "../src/house/walls";
import { opening, room } from "./rooms";

function planOf(...rooms: Room[]): WallPlan {
  return { runs: runsOf(rooms, 0.1), openings: openingsOf(rooms, 0.1), storeys: new Map([[0, { elevation: 0, height: 2.8 }]]) };
}

function panelOn(plan: WallPlan, axis: "x" | "z", line: number): WallPanel {
  const panel = wallPanelsOf(plan).find((one) => one.axis === axis && Math.abs((one.across.from + one.across.to) / 2 - line) < 1e-9);
  if (!panel) throw new Error(`no panel on ${axis}@${line}`);
  return panel;
}

function area(face: Face): number {
  const [a, b, , d] = face.corners;
  return Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) * Math.hypot(d[0] - a[0], d[1] - a[1], d[2] - a[2]);
}

function areaFacing(faces: readonly Face[], normal: readonly number[]): number {
  return faces.filter((face) => face.normal.every((value, i) => value === normal[i])).reduce((sum, face) => sum + area(face), 0);
}

describe("openings", () => {
  const a = room("a", [0, 0, 4, 3], { openings: [opening({ wall: "east", position: 1.5, swing: "in", render_panel: false })] });
  const b = room("b", [4, 1, 4, 3], { openings: [opening({ wall: "west", position: 0.5, swing: "out", hinge: "end", render_panel: true })] });

  it("listed by both rooms are placed once, as the room that draws the leaf tells it", () => {
    const [door, ...others] = openingsOf([a, b], 0.1);
    expect(others).toEqual([]);
    expect(door).toMatchObject({ axis: "z", line: 4, from: 1.05, to: 1.95, hinge: "end", opensTowards: -1 });
  });

  it("lie on an outline's edge when they name one", () => {
    const l = room("l", [10, 0, 4, 4], {
      outline: [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]],
      openings: [opening({ wall: null, edge: 3, position: 1 })],
    });
    expect(openingsOf([l], 0.1)[0]).toMatchObject({ axis: "z", line: 12, from: 2.55, to: 3.45 });
  });

  it.each([[false], [true]])("on a wall lie on its outermost edge at their position, whichever way round the outline runs", (reversed) => {
    const corners: [number, number][] = [[0, 0], [4, 0], [4, 2], [2, 2], [2, 4], [0, 4]];
    const at = (wall: "east" | "south", position: number): object | undefined => openingsOf([room("l", [10, 20, 4, 4], {
      outline: reversed ? [...corners].reverse() : corners, openings: [opening({ wall, position })],
    })], 0.1)[0];
    expect(at("east", 1)).toMatchObject({ axis: "z", line: 14, from: 20.55, to: 21.45 });
    expect(at("east", 3)).toMatchObject({ axis: "z", line: 12, from: 22.55, to: 23.45 });
    expect(at("south", 3)).toMatchObject({ axis: "x", line: 22, from: 12.55, to: 13.45 });
    expect(at("south", 1)).toMatchObject({ axis: "x", line: 24, from: 10.55, to: 11.45 });
  });
});

describe("between gaps", () => {
  it("is what no gap covers, gaps overlapping or not", () => {
    expect(between(0, 10, [{ from: 6, to: 7 }, { from: 2, to: 4 }, { from: 3, to: 5 }])).toEqual([
      { from: 0, to: 2 }, { from: 5, to: 6 }, { from: 7, to: 10 },
    ]);
    expect(between(0, 2, [{ from: -1, to: 3 }])).toEqual([]);
  });
});

describe("wall panels", () => {
  it("fill a corner once and do not poke through it", () => {
    const plan = planOf(room("a", [0, 0, 4, 3]));
    expect(panelOn(plan, "x", 0).along).toEqual({ from: -0.05, to: 4.05 });
    expect(panelOn(plan, "z", 0).along).toEqual({ from: 0, to: 3 });
    expect(panelOn(plan, "z", 0)).toMatchObject({ openStart: false, openEnd: false });
  });

  it("end inside a wall that goes on", () => {
    const plan = planOf(room("a", [0, 0, 4, 3]), room("b", [4, 0, 4, 3]));
    expect(panelOn(plan, "x", 0).along).toEqual({ from: -0.05, to: 8.05 });
    expect(panelOn(plan, "z", 4)).toMatchObject({ along: { from: 0, to: 3 }, openStart: false, openEnd: false });
  });

  it("look outside where one side is indoors and the other is not: beside a yard, and past the end of a room next door", () => {
    const [den, hall] = [room("den", [0, 0, 4, 3]), room("hall", [4, 0, 4, 5])];
    const plan = { ...planOf(den, hall), rooms: [den, hall, room("yard", [0, 3, 4, 2], { outdoor: true })] };
    const outwards = (axis: "x" | "z", line: number): unknown[] => outerPiecesOf(panelOn(plan, axis, line), plan.rooms)
      .map(({ along, outward }) => [along.from, along.to, outward]);
    expect(outwards("z", 4)).toEqual([[0, 3, null], [3, 5, "west"]]);
    expect(outwards("x", 0)).toEqual([[-0.05, 8.05, "north"]]);
    expect(outwards("x", 3)).toEqual([[-0.05, 4, "south"]]);
  });

  it("have a hole for each opening on them", () => {
    const plan = planOf(room("a", [0, 0, 4, 3], {
      openings: [opening({ position: 1 }), opening({ id: "w", kind: "window", position: 3, width: 1.2, height: 1.4, sill: 0.9 })],
    }));
    expect(panelOn(plan, "x", 3).holes.map(({ along, up }) => [along.from, along.to, up.from, up.to])).toEqual([
      [0.55, 1.45, 0, 2.1], [2.4, 3.6, 0.9, 2.3],
    ]);
    expect(panelOn(plan, "x", 0).holes).toEqual([]);
  });
});

describe("faces of a panel", () => {
  const panel: WallPanel = {
    axis: "x", along: { from: 0, to: 4 }, across: { from: -0.05, to: 0.05 }, elevation: 0, height: 2.8, openStart: true, openEnd: true,
    level: 0, seams: [],
    holes: [{ along: { from: 0.5, to: 1.4 }, up: { from: 0, to: 2.1 } }, { along: { from: 2, to: 3.2 }, up: { from: 0.9, to: 2.3 } }],
  };

  it("show the wall less its holes on both sides", () => {
    const faces = facesOf(panel, 10);
    const shown = 4 * 2.8 - 0.9 * 2.1 - 1.2 * 1.4;
    expect(areaFacing(faces, [0, 0, 1])).toBeCloseTo(shown, 9);
    expect(areaFacing(faces, [0, 0, -1])).toBeCloseTo(shown, 9);
  });

  it("close the wall: as much looks up as down but for its foot, as much east as west", () => {
    const faces = facesOf(panel, 10);
    expect(areaFacing(faces, [0, 1, 0])).toBeCloseTo(0.1 * (4 + 1.2), 9);
    expect(areaFacing(faces, [0, -1, 0])).toBeCloseTo(0.1 * (0.9 + 1.2), 9);
    expect(areaFacing(faces, [1, 0, 0])).toBeCloseTo(0.1 * (2.8 + 2.1 + 1.4), 9);
    expect(areaFacing(faces, [-1, 0, 0])).toBeCloseTo(areaFacing(faces, [1, 0, 0]), 9);
  });

  it("wind counter-clockwise around their normals", () => {
    for (const { corners: [a, b, c], normal } of facesOf({ ...panel, axis: "z" }, 1.2)) {
      const [u, v] = [[b[0] - a[0], b[1] - a[1], b[2] - a[2]], [c[0] - b[0], c[1] - b[1], c[2] - b[2]]] as const;
      const cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
      expect(cross.reduce((sum, value, i) => sum + value * (normal[i] ?? 0), 0)).toBeGreaterThan(0);
    }
  });

  it("cut at 1.2 m leave no lintel, and mark where the cut goes through stone", () => {
    const faces = facesOf(panel, 1.2);
    expect(Math.max(...faces.flatMap((face) => face.corners.map((corner) => corner[1])))).toBe(1.2);
    const cut = faces.filter((face) => face.cut);
    expect(cut.reduce((sum, face) => sum + area(face), 0)).toBeCloseTo(0.1 * (4 - 0.9 - 1.2), 9);
  });

  it("of an uncut wall mark no cut, of a storey above the cut are none", () => {
    expect(facesOf(panel, 2.8).some((face) => face.cut)).toBe(false);
    expect(facesOf({ ...panel, elevation: 3 }, 1.2)).toEqual([]);
  });
});

describe("walls before the viewer", () => {
  it("are those that look outside towards the eye, none from above", () => {
    expect([...sidesOf(sidesBefore({ x: 1, y: 2, z: 2 }))]).toEqual(["east", "south"]);
    expect([...sidesOf(sidesBefore({ x: -0.1, y: 1, z: -1 }))]).toEqual(["north"]);
    expect(sidesBefore({ x: 0, y: 10, z: 0.001 })).toBe(0);
  });

  it("are low with their windows and what hangs on them; others and doors stay", () => {
    const cut = { height: 1.2, before: new Set(["south"] as const) };
    expect([heightAt(cut, "south", 0), heightAt(cut, "north", 0), heightAt(cut, null, 0), heightAt(cut, "south", 2)]).toEqual([LOW, 1.2, 1.2, 1.2]);
    const den = room("den", [0, 0, 4, 3], { openings: [opening({ id: "w", kind: "window", position: 2, width: 1.2, height: 1.4, sill: 0.9 })] });
    const walls = new Walls({ ...planOf(den), rooms: [den] });
    const tops = (before: readonly Side[]): number[] => walls.meshes({ height: 1.2, before: new Set(before) }).children.map((mesh) => {
      const { max } = new Box3().setFromObject(mesh);
      return Math.round(1000 * max.y) / 1000;
    });
    expect(tops([])).toEqual([1.2, 1.2]);
    expect(tops(["north", "east", "south", "west"])).toEqual([LOW, Number.NEGATIVE_INFINITY]);
  });
});

describe("fittings", () => {
  it("are glass at a window, a frame at a door, nothing at a passage", () => {
    const of = (kind: "door" | "window" | "passage"): string[] => {
      const plan = planOf(room("a", [0, 0, 4, 3], { openings: [opening({ kind, sill: kind === "window" ? 0.9 : 0, height: 1.4 })] }));
      return [...new Set(fittingsOf(plan).map((part) => part.surface))].sort();
    };
    expect(of("window")).toEqual(["frame", "glass"]);
    expect(of("door")).toEqual(["frame", "threshold"]);
    expect(of("passage")).toEqual([]);
  });

  it("put glass between sill and head", () => {
    const plan = planOf(room("a", [0, 0, 4, 3], { openings: [opening({ kind: "window", wall: "west", position: 1.5, width: 1.2, height: 1.4, sill: 0.9 })] }));
    const glass = fittingsOf(plan).find((part) => part.surface === "glass")?.box;
    expect(glass?.y0).toBeGreaterThanOrEqual(0.9);
    expect(glass?.y1).toBeLessThanOrEqual(2.3);
    expect([glass?.z0, glass?.z1]).toEqual([0.9, 2.1]);
  });

  it("make railings no higher than 0.6 m that stop at a wall's face", () => {
    const plan = planOf(room("a", [0, 0, 4, 3]), room("b", [4, 0, 4, 3], { outdoor: true }));
    const rails = fittingsOf(plan).filter((part) => part.surface === "railing").map((part) => part.box);
    expect(rails.length).toBeGreaterThan(0);
    expect(Math.max(...rails.map((box) => box.y1))).toBeCloseTo(0.6, 9);
    expect(Math.min(...rails.map((box) => box.x0))).toBeCloseTo(4.05, 9);
  });
});

describe("clipping", () => {
  const box = { x0: 0, x1: 1, y0: 1, y1: 2, z0: 0, z1: 1 };
  it("keeps what is below", () => {
    expect(clipBelow(box, 3)).toBe(box);
    expect(clipBelow(box, 1.5)).toEqual({ ...box, y1: 1.5 });
    expect(clipBelow(box, 1)).toBeNull();
  });
});

describe("finishes", () => {
  const white = room("white", [0, 0, 4, 3], { walls: { type: "plaster", color: "#fafaf7" } });
  const brick = room("brick", [4, 0, 4, 3], { walls: { type: "brick", color: "#a1583f" } });
  const bare = room("bare", [0, 3, 8, 3]);

  it("are each room's own on its side of a wall, and nobody's outside", () => {
    const rooms = [white, brick, bare];
    const panel = panelOn({ ...planOf(...rooms), rooms }, "x", 3);
    const sides = facesOf(panel, 9).filter((face) => face.normal[2] !== 0);
    const areas = new Map<string | null, number>();
    const colorOf = (face: Face): string | null => finishOf(face, panel, rooms)?.color ?? null;
    for (const face of sides) areas.set(colorOf(face), (areas.get(colorOf(face)) ?? 0) + area(face));
    expect([...areas.keys()].sort()).toEqual(["#a1583f", "#fafaf7", null].sort());
    expect(areas.get("#a1583f")).toBeCloseTo(areas.get("#fafaf7") ?? 0);
    expect(areas.get(null)).toBeCloseTo(areaFacing(sides, [0, 0, 1]));
    const outside = panelOn({ ...planOf(...rooms), rooms }, "x", 0);
    const along = facesOf(outside, 9).filter(({ corners: [a, , c] }) => a[0] + c[0] > 0 && a[0] + c[0] < 16);
    const looks = along.map((face) => [face.normal[2], finishOf(face, outside, rooms)]);
    expect(looks.filter(([towards]) => towards === -1).every(([, color]) => color === null)).toBe(true);
    expect(looks.filter(([towards]) => towards === 1).every(([, color]) => color !== null)).toBe(true);
  });

  it("leave the area of a wall as it is", () => {
    const rooms = [white, brick, bare];
    const [plain, finished] = [planOf(...rooms), { ...planOf(...rooms), rooms }].map((plan) => wallPanelsOf(plan).flatMap((panel) => facesOf(panel, 1.2)));
    const total = (faces: readonly Face[] = []): number => faces.reduce((sum, face) => sum + area(face), 0);
    expect(total(finished)).toBeCloseTo(total(plain));
  });
});
