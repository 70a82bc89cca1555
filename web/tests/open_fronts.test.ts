import { describe, expect, it } from "vitest";
import type { PlacedBody } from "../src/house/frame";
import type { Front } from "../src/house/fronts";
import { OpenFronts } from "../src/house/open_fronts";
import type { Paint } from "../src/house/paints";
import { part, type Part } from "../src/house/parts";

const PAINT: Paint = { color: "#808080", opacity: 1, roughness: 1, metalness: 0, glow: 0, texture: null };

function body(id: string, kind: PlacedBody["kind"], x: number, y: number, z: number, turn: number): PlacedBody {
  return { id, kind, x, y, z, turn, width: 0.2, height: 0.1, depth: 0.2 } as PlacedBody;
}

/** A chest turned by a right angle, so that its front looks east, with one drawer: a panel and the bottom of its tray. */
const CHEST = { ...body("chest", "furniture", 2, 0, 3, Math.PI / 2), width: 1, height: 1, depth: 0.5 };
const DRAWER: Front = { name: "drawer", slides: true, axis: "z", hinge: [0, 0.5, 0.25], end: 0.4 };
const PARTS: Part[] = [
  { ...part("box", [0.9, 0.2, 0.02], [0, 0.5, 0.24], PAINT), front: "drawer" },
  { ...part("box", [0.9, 0.02, 0.45], [0, 0.42, 0], PAINT), front: "drawer" },
];
const INSIDE = body("shirt", "decoration", 2, 0.43, 3.1, 0);
const ON_TOP = body("vase", "decoration", 2, 1, 3.1, 0);

function opened(said: ConstructorParameters<typeof OpenFronts>[0] = null): OpenFronts {
  const fronts = new OpenFronts(said, [CHEST], () => [DRAWER]);
  fronts.toggle(0, "drawer");
  for (let k = 0; k < 4; k += 1) fronts.step(0.25);
  return fronts;
}

describe("what lies in a drawer", () => {
  it("goes with it, out to the front of the piece, and what lies on top stays", () => {
    const moved = opened().carried(INSIDE, 0, CHEST, PARTS);
    expect([moved.x, moved.y, moved.z].map((one) => Number(one.toFixed(6)))).toEqual([2.4, 0.43, 3.1]);
    expect(opened().carried(ON_TOP, 0, CHEST, PARTS)).toBe(ON_TOP);
  });

  it("comes as far as the certificate lets its drawer, and back with it", () => {
    const said = { rooms: { den: { fronts: { chest: { drawer: { opens: 0.5, meets: "wall" } } } } } };
    const fronts = opened(said as unknown as ConstructorParameters<typeof OpenFronts>[0]);
    expect(fronts.carried(INSIDE, 0, CHEST, PARTS).x).toBeCloseTo(2.2);
    fronts.toggle(0, "drawer");
    fronts.step(1);
    expect(fronts.carried(INSIDE, 0, CHEST, PARTS)).toBe(INSIDE);
  });
});
