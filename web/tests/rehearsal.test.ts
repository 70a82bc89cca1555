// @vitest-environment happy-dom
import { describe, expect, it, vi } from "vitest";
import { InstancedMesh, Mesh, type Object3D } from "three";
import type { Catalog } from "../src/contract";
import { rehearsalOf, rehearse } from "../src/house/rehearsal";

const CATALOG: Catalog = {
  furniture: { bed: { size: [1.6, 2, 0.9] }, king_bed: { name: "bed", size: [1.8, 2, 0.9] } },
  decorations: { vase: { size: [0.1, 0.1, 0.3] } },
  shapes: { vase: [{ form: "cylinder", x: [0, 1], y: [0, 1], z: [0, 1], material: "glass" }] },
  materials: { glass: { opacity: 0.3 } },
};

describe("the rehearsal", () => {
  it("has everything of the catalog, of its size", () => {
    const [room] = rehearsalOf(CATALOG).rooms;
    expect(room?.furniture.map(({ name, width }) => [name, width])).toEqual([["bed", 1.6], ["bed", 1.8]]);
    expect(room?.decorations.map(({ name, height }) => [name, height])).toEqual([["vase", 0.3]]);
  });

  it("prepares walls, floors, doors and both what is solid and what is seen through", async () => {
    const prepared: Object3D[] = [];
    await rehearse((root) => root.traverse((node) => prepared.push(node)), () => true);
    const materials = new Set(prepared.flatMap((node) => (node instanceof Mesh ? [node.material] : [])));
    expect(materials.size).toBeGreaterThanOrEqual(7);
    const clear = prepared.flatMap((node) => (node instanceof InstancedMesh ? [node.material].flat().map(({ transparent }) => transparent) : []));
    expect(new Set(clear)).toEqual(new Set([true, false]));
  });

  it("ends when a house is there", async () => {
    vi.resetModules(); // no pattern is made yet
    const anew = await import("../src/house/rehearsal");
    let asked = 0;
    await anew.rehearse(() => undefined, () => (asked += 1) < 3);
    expect(asked).toBe(3);
  });
});
