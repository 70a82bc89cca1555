import { BoxGeometry, Group, Matrix4, Mesh, MeshStandardMaterial, Vector3, type InstancedMesh } from "three";
import { describe, expect, it } from "vitest";
import type { CatalogAsset, Scene } from "../src/contract";
import { ownKindsOf } from "../src/edit/palette";
import { added } from "../src/edit/scene_edits";
import { AssetLibrary, MOST_BYTES, type AssetCount } from "../src/house/asset_library";
import { AssetMeshes, boxMatrix, MOST_DRAWN } from "../src/house/asset_meshes";
import { MOST_PARTS, partsOf, unitOf, type AssetPart } from "../src/house/asset_model";
import { BodyMeshes } from "../src/house/body_meshes";
import type { PlacedBody } from "../src/house/frame";
import { cutAll } from "../src/house/wall_cut";
import { wordsOf } from "../src/panel/asset_count";

function asset(more: Partial<CatalogAsset> = {}): CatalogAsset {
  return { kinds: ["sofa"], front: "+z", size: [2, 1, 0.8], low: [-1, 0, -0.5], high: [1, 0.8, 0.5], bytes: 1000, triangles: 12, license: "MIT", ...more };
}

function body(id: string, name: string | null, more: Partial<PlacedBody> = {}): PlacedBody {
  return { id, name: "sofa", kind: "furniture", asset: name, x: 3, y: 0, z: 2, turn: 0, width: 2, depth: 1, height: 0.8, color: "#888888", ...more };
}

const part = (): AssetPart => ({ geometry: new BoxGeometry(), material: new MeshStandardMaterial(), place: new Matrix4() });

function library(assets: Record<string, CatalogAsset>, fetch: (name: string) => Promise<ArrayBuffer> = () => Promise.resolve(new ArrayBuffer(0))) {
  return new AssetLibrary(assets, fetch, () => Promise.resolve([part()]));
}

const settled = (): Promise<void> => new Promise((done) => { setTimeout(done, 0); });

describe("an asset's place", () => {
  it.each([["+z", [0, 0, 1]], ["-z", [0, 0, -1]], ["+x", [1, 0, 0]], ["-x", [-1, 0, 0]]] as const)("turns a front at %s to +z", (front, towards) => {
    const [low, high] = [[2, 1, -3], [5, 4, 6]] as const;
    const unit = unitOf({ low: [...low], high: [...high], front });
    const middle = new Vector3(3.5, 1, 1.5);
    const face = middle.clone().add(new Vector3(...towards).multiply(new Vector3(1.5, 0, 4.5)));
    expect(middle.applyMatrix4(unit).length()).toBeCloseTo(0, 9);
    expect(face.applyMatrix4(unit).toArray().map((value) => Math.round(value * 1e6) / 1e6 + 0)).toEqual([0, 0, 0.5]);
    const corners = [low, high].map(([x, y, z]) => new Vector3(x, y, z).applyMatrix4(unit).toArray().map(Math.abs));
    for (const [x, y, z] of corners) expect([x, z, y === 0 || y]).toEqual([expect.closeTo(0.5, 9), expect.closeTo(0.5, 9), y === 0 ? true : expect.closeTo(1, 9)]);
  });

  it("keeps what it draws for the next house, and refuses too many parts", () => {
    const root = new Group();
    root.add(new Mesh(new BoxGeometry(), new MeshStandardMaterial()));
    const [one] = partsOf(root, asset());
    expect(one?.geometry.userData.kept).toBe(true);
    for (let i = 0; i < MOST_PARTS; i += 1) root.add(new Mesh(new BoxGeometry(), new MeshStandardMaterial()));
    expect(() => partsOf(root, asset())).toThrow("parts");
    expect(() => partsOf(new Group(), asset())).toThrow("0 parts");
  });
});

describe("the library", () => {
  it("fetches each asset once, one after another, and counts", async () => {
    const asked: string[] = [];
    let release: (content: ArrayBuffer) => void = () => undefined;
    const known = library({ a: asset(), b: asset() }, (name) => { asked.push(name); return new Promise((resolve) => { release = resolve; }); });
    const counts: AssetCount[] = [];
    known.onCount = (count) => counts.push(count);
    const [first, again, second] = [known.model("a"), known.model("a"), known.model("b")];
    await settled();
    expect(asked).toEqual(["a"]);
    release(new ArrayBuffer(0));
    await settled();
    expect(asked).toEqual(["a", "b"]);
    release(new ArrayBuffer(0));
    expect(await first).toBe(await again);
    expect(await second).toHaveLength(1);
    expect(counts.at(-1)).toEqual({ wanted: 2, come: 2, missing: 0 });
    expect(counts.map(wordsOf)).toEqual(["Assets: 0 of 1 loaded…", "Assets: 0 of 2 loaded…", "Assets: 1 of 2 loaded…", ""]);
  });

  it("does without what does not come, is unknown or too much", async () => {
    const known = library({ a: asset(), huge: asset({ bytes: MOST_BYTES + 1 }), b: asset() }, (name) => (name === "a" ? Promise.reject(new Error("gone")) : Promise.resolve(new ArrayBuffer(0))));
    expect(await Promise.all(["a", "nobody", "__proto__", "huge"].map((name) => known.model(name)))).toEqual([null, null, null, null]);
    expect(await known.model("b")).toHaveLength(1);
    expect(wordsOf(known.count)).toBe("4 of 5 assets could not be loaded: plain shapes stand for them.");
  });
});

describe("bodies shown as assets", () => {
  it("stand in their boxes, one draw call a part, and their shapes are gone", async () => {
    const bodies = [body("one", "a", { turn: 0.3 }), body("two", null), body("three", "a", { x: 7, hung: 2 })];
    let arrivals = 0;
    const meshes = new BodyMeshes(bodies, undefined, null, { library: library({ a: asset() }), onArrival: () => { arrivals += 1; } });
    const at = (instance: number): number[] => {
      const [mesh] = (meshes.root.children.at(-1)?.children ?? []) as InstancedMesh[];
      const matrix = new Matrix4();
      mesh?.getMatrixAt(instance, matrix);
      return matrix.elements.map((value) => Math.round(value * 1e5) / 1e5 + 0);
    };
    const rounded = (matrix: Matrix4): number[] => matrix.elements.map((value) => Math.round(value * 1e5) / 1e5 + 0);
    await settled();
    expect(arrivals).toBe(1);
    expect(at(0)).toEqual(rounded(boxMatrix(bodies[0] as PlacedBody)));
    const moved = meshes.place("one", { x: 5, z: 1 }) as PlacedBody;
    expect(at(0)).toEqual(rounded(boxMatrix(moved)));
    meshes.cutAt(cutAll(1.5));
    expect(at(1).slice(0, 15).every((value) => value === 0)).toBe(true);
    meshes.cutAt(cutAll(3));
    expect(at(1)).toEqual(rounded(boxMatrix(bodies[2] as PlacedBody)));
  });

  it("keep their shapes where the house is gone before the asset comes, or is too much to draw", async () => {
    const arrived: (readonly number[])[] = [];
    const known = library({ a: asset(), heavy: asset({ triangles: MOST_DRAWN }) });
    new AssetMeshes([body("one", "a")], known, (numbers) => arrived.push(numbers)).dispose();
    const kept = new AssetMeshes([body("one", "a"), body("two", "heavy"), body("three", "unknown")], known, (numbers) => arrived.push(numbers));
    await settled();
    expect(arrived).toEqual([[0]]);
    expect([0, 1, 2].map((number) => kept.shows(number))).toEqual([true, false, false]);
  });
});

describe("the palette", () => {
  const catalog = {
    furniture: { sofa: { size: [2.2, 0.9, 0.85], category: "seating" }, loveseat: { name: "sofa", size: [1.5, 0.84, 0.85] } } as const,
    decorations: { vase: { size: [0.2, 0.2, 0.3] } } as const,
    assets: { oak: asset({ size: [1.52, 0.8, 0.8] }), pot: asset({ kinds: ["vase"] }) },
  };

  it("offers assets as pieces of the nearest kind, in their own size", () => {
    expect(ownKindsOf(catalog)).toEqual([{ key: "oak", kind: { key: "loveseat", name: "sofa", category: "", size: [1.52, 0.8, 0.8], color: null, asset: "oak" } }]);
    const scene = { seed: 1, size: { width: 5, depth: 5, height: 2.8 }, dynamic: [], rooms: [{ id: "den", width: 5, depth: 5, furniture: [], decorations: [], openings: [] }] } as unknown as Scene;
    const [{ kind }] = ownKindsOf(catalog) as [ReturnType<typeof ownKindsOf>[number]];
    expect(added(scene, "den", kind).scene.rooms[0]?.furniture[0]).toMatchObject({ asset: "oak", kind: "loveseat", width: 1.52 });
  });
});
