import { describe, expect, it } from "vitest";
import type { Catalog, CatalogPart } from "../src/contract";
import type { PlacedBody } from "../src/house/frame";
import { ShapeBook } from "../src/house/shapes";

const solid = (form: CatalogPart["form"]): CatalogPart => ({ form, x: [0, 1], y: [0, 1], z: [0, 1], axis: "y", taper: 1, material: "body" });

const CATALOG: Catalog = {
  furniture: {},
  decorations: { book: { size: [0.14, 0.2, 0.03] } },
  shapes: { book: [solid("box")], book_upright: [solid("rounded")], person: [solid("capsule")], person_seated: [solid("ball")] },
  materials: { body: {} },
  styles: {},
};

function formOf(name: string, more: Partial<PlacedBody>): string | undefined {
  const body: PlacedBody = { id: "b", name, kind: "decoration", x: 0, y: 0, z: 0, turn: 0, width: 0.14, depth: 0.2, height: 0.03, color: "#804020", ...more };
  return new ShapeBook(CATALOG).partsOf(body, null)[0]?.form;
}

describe("poses", () => {
  it("of things that are tipped onto an edge are drawn upright, at any scale", () => {
    expect(formOf("book", {})).toBe("box");
    expect(formOf("book", { width: 0.1, depth: 0.14 })).toBe("box");
    expect(formOf("book", { depth: 0.03, height: 0.2 })).toBe("rounded");
    expect(formOf("book", { width: 0.1, depth: 0.03, height: 0.14 })).toBe("rounded");
  });

  it("of people who sit on something are drawn seated", () => {
    expect(formOf("person", { kind: "dynamic" })).toBe("capsule");
    expect(formOf("person", { kind: "dynamic", seat: 0.45 })).toBe("ball");
  });
});
