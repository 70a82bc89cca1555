/** Solids with fewer faces are as round as they are said to be. */
import { describe, expect, it, vi } from "vitest";
import { solidGeometry, solidOf, SOLIDS } from "../src/house/part_geometry";

const LARGEST_SMALL = 0.06;
const ALLOWED = 0.0025;

/** Points of every triangle of a solid, drawn with this size across [m]. */
function pointsOf(name: (typeof SOLIDS)[number], size: number): number[][] {
  const { attributes, index } = solidGeometry(name);
  const at = (k: number): number[] => [attributes.position?.getX(k) ?? 0, attributes.position?.getY(k) ?? 0, attributes.position?.getZ(k) ?? 0].map((value) => value * size);
  return Array.from({ length: (index?.count ?? 0) / 3 }, (_, t) => [0, 1, 2].map((k) => at(index?.getX(3 * t + k) ?? 0))).flatMap(([a, b, c]) => [
    [1 / 3, 1 / 3, 1 / 3], [0.5, 0.5, 0], [0.5, 0, 0.5], [0, 0.5, 0.5],
  ].map((weights) => [0, 1, 2].map((k) => [a, b, c].reduce((sum, corner, i) => sum + (corner?.[k] ?? 0) * (weights[i] ?? 0), 0))));
}

describe("solids", () => {
  it("have fewer faces where nobody sees it", () => {
    for (const [small, whole] of [["bead", "ball"], ["stick", "round"]] as const) {
      expect(solidGeometry(small).index?.count).toBeLessThan(0.6 * (solidGeometry(whole).index?.count ?? 0));
    }
    for (const [x, y, z] of pointsOf("bead", LARGEST_SMALL)) {
      const off = LARGEST_SMALL / 2 - Math.hypot(x ?? 0, y ?? 0, z ?? 0);
      expect(off).toBeGreaterThan(-1e-6);
      expect(off).toBeLessThan(ALLOWED);
    }
    const mantle = pointsOf("stick", LARGEST_SMALL).filter(([, y]) => Math.abs(y ?? 0) < LARGEST_SMALL / 2 - 1e-6);
    expect(mantle.length).toBeGreaterThan(0);
    for (const [x, , z] of mantle) expect(LARGEST_SMALL / 2 - Math.hypot(x ?? 0, z ?? 0)).toBeLessThan(ALLOWED);
  });

  it("have no triangle that is a line, and none is missing: every edge is met from both its sides", () => {
    for (const name of SOLIDS) {
      const { attributes, index } = solidGeometry(name);
      const lift = name === "rounded" || name === "capsule" ? 1 : 0;
      const corner = (k: number): string => ["X", "Y", "Z"].map((axis) => {
        const [at, lean] = [attributes.position, attributes.normal].map((one) => one?.[`get${axis}` as "getX"](k) ?? 0) as [number, number];
        return (at + lift * lean + 0).toFixed(3).replace("-0.000", "0.000");
      }).join(" ");
      const edges = new Map<string, number>();
      for (let t = 0; t < (index?.count ?? 0); t += 3) {
        const corners = [0, 1, 2].map((i) => corner(index?.getX(t + i) ?? 0));
        expect(new Set(corners).size, name).toBe(3);
        corners.forEach((from, i) => {
          const to = corners[(i + 1) % 3] ?? "";
          const edge = [from, to].sort().join(" | ");
          edges.set(edge, (edges.get(edge) ?? 0) + (from < to ? 1 : -1));
        });
      }
      expect(edges.size, name).toBeGreaterThan(10);
      expect([...edges.values()].filter((sum) => sum !== 0), name).toEqual([]);
    }
  });

  it("are chosen by what is round of a part, whichever way it lies", () => {
    const [small, wide] = [LARGEST_SMALL, LARGEST_SMALL + 0.001];
    expect(solidOf({ form: "ball", size: [small, small, small], axis: "y" })).toBe("bead");
    expect(solidOf({ form: "ball", size: [small, wide, small], axis: "y" })).toBe("ball");
    for (const form of ["cylinder", "cone"] as const) {
      expect(solidOf({ form, size: [small, 1, small], axis: "y" })).toBe("stick");
      expect(solidOf({ form, size: [1, small, small], axis: "x" })).toBe("stick");
      expect(solidOf({ form, size: [small, small, 1], axis: "z" })).toBe("stick");
      expect(solidOf({ form, size: [small, wide, 1], axis: "z" })).toBe("round");
    }
    expect(solidOf({ form: "box", size: [small, small, small], axis: "y" })).toBe("box");
  });

  it("have fewer faces where a processor draws, and are as large", async () => {
    vi.resetModules();
    const coarse = await import("../src/house/part_geometry");
    coarse.makeCoarsely();
    for (const name of SOLIDS) {
      const [all, fewer] = [solidGeometry(name), coarse.solidGeometry(name)];
      const isRound = name !== "box" && name !== "rounded";
      const share = (fewer.index?.count ?? 0) / (all.index?.count ?? 1);
      if (isRound) expect(share, name).toBeLessThan(0.85);
      else expect(share, name).toBe(1);
      for (const geometry of [all, fewer]) geometry.computeBoundingBox();
      expect(fewer.boundingBox?.min.y, name).toBeCloseTo(all.boundingBox?.min.y ?? 0, 9);
      expect(fewer.boundingBox?.max.toArray().map((side) => side.toFixed(1)), name).toEqual(all.boundingBox?.max.toArray().map((side) => side.toFixed(1)));
    }
  });
});
