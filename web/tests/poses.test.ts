import { describe, expect, it } from "vitest";
import type { Catalog, CatalogPart, Dynamic, Room, Scene } from "../src/contract";
import { bodiesOf } from "../src/house/frame";
import { ShapeBook } from "../src/house/shapes";

const solid = (form: CatalogPart["form"]): CatalogPart => ({ form, x: [0, 1], y: [0, 1], z: [0, 1], axis: "y", taper: 1, material: "body" });

const CATALOG: Catalog = {
  furniture: {},
  decorations: {},
  shapes: { person: [solid("capsule")], person_seated: [solid("ball")] },
  materials: { body: {} },
  styles: {},
};
const ROOM = { id: "den", x: 0, z: 0, width: 3, depth: 3, level: 0, furniture: [], decorations: [] } as unknown as Room;

function formOf(more: Partial<Dynamic>): string | undefined {
  const person = { id: "p", kind: "person", room: "den", x: 1, y: 0.4, z: 1, rotation: 0, width: 0.5, depth: 0.3, height: 1.2, ...more };
  const [body] = bodiesOf({ rooms: [ROOM], dynamic: [person], levels: [] } as unknown as Scene);
  return body && new ShapeBook(CATALOG).partsOf(body, null)[0]?.form;
}

describe("poses", () => {
  it("of people who sit on something are drawn seated", () => {
    expect(formOf({})).toBe("capsule");
    expect(formOf({ on: "sofa" })).toBe("ball");
  });
});
