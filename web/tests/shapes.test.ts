import { describe, expect, it } from "vitest";
import type { Catalog, CatalogPart } from "../src/contract";
import type { PlacedBody } from "../src/house/frame";
import { layerOf, makeNextPattern, patternGreys, patternLayer, patternUniform } from "../src/house/patterns";
import { ShapeBook } from "../src/house/shapes";

const solid = (material: string, more: Partial<CatalogPart> = {}): CatalogPart => ({
  form: "box", x: [0, 1], y: [0, 1], z: [0, 1], axis: "y", taper: 1, material, ...more,
});

const CATALOG: Catalog = {
  furniture: {
    bed: { size: [1.6, 2, 0.9] },
    king_bed: { name: "bed", size: [1.8, 2, 0.9] },
    stool: { size: [0.4, 0.4, 0.5] },
  },
  decorations: { rug: { size: [2, 1.4, 0.02] } },
  shapes: {
    bed: [solid("oak", { x: [0, 0.25], y: [0.5, 1], z: [0.5, 1] })],
    king_bed: [solid("own"), solid("glass")],
    rug: [solid("rug_border")],
    dog: [solid("own", { form: "ball" })],
  },
  materials: {
    oak: { color: "#a08050", roughness: 0.6, texture: "wood" },
    own: { color: null, shade: -0.5, metalness: 0.25 },
    glass: { color: "#d0e0f0", opacity: 0.3 },
    rug_border: { roughness: 0.9 },
  },
  styles: { dark: { materials: { oak: { color: "#302010" } } } },
};

function body(name: string, more: Partial<PlacedBody> = {}): PlacedBody {
  return { id: "b", name, shape: name, kind: "furniture", x: 0, y: 0, z: 0, turn: 0, width: 1.6, depth: 2, height: 0.9, color: "#804020", ...more };
}

describe("shapes", () => {
  const book = new ShapeBook(CATALOG);

  it("come from the catalog in shares of the body's own box", () => {
    const [part, ...others] = book.partsOf(body("bed", { width: 2, height: 1 }), null).slice(0, 1);
    expect(others).toEqual([]);
    expect(new ShapeBook(CATALOG).partsOf(body("bed"), null)[0]?.at).toEqual([-0.6000000000000001, 0.675, 0.5]);
    expect(part?.paint.opacity).toBe(1);
  });

  it("are those of the kind that the scene names, whatever it calls the thing", () => {
    expect(book.partsOf(body("bed"), null)).toHaveLength(1);
    expect(book.partsOf(body("bed", { shape: "king_bed" }), null)).toHaveLength(2);
  });

  it("are boxes for things that name no kind, or one that is not known, for kinds without a shape and without a catalog", () => {
    for (const [from, shape] of [[book, null], [book, "toString"], [book, "stool"], [new ShapeBook(null), "bed"]] as const) {
      const [block, arrow] = from.partsOf(body("bed", { shape }), null);
      expect(block).toMatchObject({ form: "rounded", size: [1.6, 0.9, 2], at: [0, 0.45, 0] });
      expect(arrow?.at[2]).toBeGreaterThan(0);
    }
  });

  it("are made of the slots' materials, of a style's where it has its own, in the body's or the room's colour", () => {
    const color = (name: string, style: string | null, more: Partial<PlacedBody> = {}): string | undefined =>
      book.partsOf(body(name, more), style)[0]?.paint.color;
    expect(color("bed", null)).toBe("#a08050");
    expect(color("bed", "dark")).toBe("#302010");
    expect(color("bed", "no such style")).toBe("#a08050");
    expect(book.partsOf(body("bed"), "dark")[0]?.paint).toMatchObject({ roughness: 0.6, texture: "wood" });
    expect(color("bed", null, { shape: "king_bed" })).toBe("#402010");
    expect(color("rug", null, { kind: "decoration", accent: "#336699" })).toBe("#336699");
  });

  it("of people and pets stand within their boxes; who sits has feet towards the floor", () => {
    const plain = new ShapeBook(null);
    for (const [name, height] of [["person", 1.7], ["dog", 0.6], ["cat", 0.3]] as const) {
      const parts = plain.partsOf(body(name, { kind: "dynamic", width: 0.3, depth: 0.5, height }), null);
      expect(Math.max(...parts.map(({ at, size }) => at[1] + size[1] / 2)), name).toBeCloseTo(height, 6);
      expect(Math.min(...parts.map(({ at, size }) => at[1] - size[1] / 2)), name).toBeGreaterThanOrEqual(-1e-9);
    }
    const sitting = plain.partsOf(body("person", { kind: "dynamic", y: 0.44, seat: 0.44, width: 0.46, depth: 0.5, height: 0.9 }), null);
    expect(Math.max(...sitting.map(({ at, size }) => at[1] + size[1] / 2))).toBeCloseTo(0.9, 6);
    expect(Math.min(...sitting.map(({ at, size }) => at[1] - size[1] / 2))).toBeCloseTo(-0.44, 6);
    for (const { at, size } of sitting) if (at[1] - size[1] / 2 < -0.01) expect(at[2]).toBeGreaterThanOrEqual(0.25);
    expect(book.partsOf(body("dog", { kind: "dynamic" }), null)[0]?.form).toBe("ball");
  });
});

describe("patterns", () => {
  it("repeat without a seam, differ, and are plain for a name that is not known", () => {
    const wood = patternGreys("wood", 64);
    expect(new Set(wood).size).toBeGreaterThan(20);
    expect(patternGreys("wood", 64)).toEqual(wood);
    const plaster = patternGreys("concrete", 256);
    const jump = (i: number, j: number): number => Math.max(...Array.from({ length: 256 }, (_, k) => Math.abs((plaster[k * 256 + i] ?? 0) - (plaster[k * 256 + j] ?? 0))));
    expect(jump(0, 255)).toBeLessThanOrEqual(jump(100, 101) + 12);
    expect(patternLayer("no such texture")).toBe(patternLayer(null));
    expect(patternLayer("brick")).toBeGreaterThan(0);
  });

  it("are made only when something is drawn with them, each once", () => {
    while (makeNextPattern()); // what tests before this asked for
    const texture = patternUniform.value;
    const layers = texture.image.depth;
    const isMade = (layer: number): boolean => (texture.image.data as Uint8Array).subarray(layer * 256 ** 2, (layer + 1) * 256 ** 2).some((grey) => grey > 0);
    const [unmade] = ["cast", "wallpaper", "panelling", "leather", "deck"].filter((name) => !isMade(layerOf(name)));
    const before = Array.from({ length: layers }, (_, layer) => isMade(layer)).filter(Boolean).length;
    expect(before).toBeLessThan(layers);
    texture.clearLayerUpdates();
    const asked = patternLayer(unmade ?? "");
    expect(isMade(asked)).toBe(false);
    expect(patternUniform.value).toBe(texture);
    expect(isMade(asked)).toBe(true);
    expect([...texture.layerUpdates]).toEqual([asked]);
    expect(Array.from({ length: layers }, (_, layer) => isMade(layer)).filter(Boolean).length).toBe(before + 1);
    expect(makeNextPattern()).toBe(false);
  });
});
