import { Matrix4, Raycaster, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { BodyMeshes, bodyMatrix } from "../src/house/body_meshes";
import { bodiesOf, words, type PlacedBody } from "../src/house/frame";
import { shade } from "../src/house/paints";
import { writePlace } from "../src/house/part_batches";
import { ShapeBook } from "../src/house/shapes";
import { cutAll } from "../src/house/wall_cut";
import { piece, room, scene } from "./rooms";

const placed = (rotation: number): PlacedBody => {
  const [body] = bodiesOf(scene([room("a", [5, 7, 4, 4], { furniture: [piece("a/sofa_1", { x: 1, z: 0.5, y: 0.2, rotation })] })]));
  if (!body) throw new Error("no body");
  return body;
};

/** Where a body's front looks, from its middle. */
function front(rotation: number): number[] {
  const matrix = bodyMatrix(placed(rotation));
  const forward = new Vector3(0, 0, 1).applyMatrix4(matrix).sub(new Vector3(0, 0, 0).applyMatrix4(matrix));
  return forward.toArray().map((value) => Math.round(value * 1e6) / 1e6 + 0);
}

describe("the frame", () => {
  it("puts a body at its room's corner plus its own place, by footprint centre and underside", () => {
    expect(placed(0)).toMatchObject({ x: 6, y: 0.2, z: 7.5 });
  });

  it("turns counter-clockwise seen from above: 0 looks south, 90 east, 180 north, 270 west", () => {
    expect(front(0)).toEqual([0, 0, 1]);
    expect(front(90)).toEqual([1, 0, 0]);
    expect(front(180)).toEqual([0, 0, -1]);
    expect(front(270)).toEqual([-1, 0, 0]);
  });

  it("raises what is on a higher level, and knows people by their room", () => {
    const upstairs = room("up", [0, 0, 4, 4], { level: 1, furniture: [piece("up/sofa_1")] });
    const person = { id: "person_1", kind: "person", room: "up", x: 1, y: 0, z: 2, rotation: 0, width: 0.5, depth: 0.3, height: 1.7 };
    const levels = [{ index: 1, elevation: 3, height: 2.8 }];
    const bodies = bodiesOf(scene([upstairs], { levels, dynamic: [person] }));
    expect(bodies.map(({ id, y, kind }) => [id, y, kind])).toEqual([["up/sofa_1", 3, "furniture"], ["person_1", 3, "dynamic"]]);
  });

  it("knows at which height hangs what hangs on a wall, and what lies on that; the page hides both where the wall is cut below", () => {
    const size = { x: 1, z: 0, rotation: 0, width: 0.6, depth: 0.2, height: 0.2 };
    const shelf = { ...size, id: "a/shelf_1", name: "wall_shelf", y: 1.5, mounted_on_wall: "north" as const };
    const book = { ...size, id: "a/book_1", name: "book", y: 1.7, parent: "a/shelf_1" };
    const vase = { ...size, id: "a/vase_1", name: "vase", y: 0.9, parent: "a/sofa_1" };
    const bodies = bodiesOf(scene([room("a", [0, 0, 4, 4], { decorations: [book, shelf, vase] })]));
    expect(bodies.map((body) => body.hung)).toEqual([1.6, 1.6, undefined]);
    const meshes = new BodyMeshes(bodies);
    meshes.cutAt(cutAll(1.4));
    expect(bodies.map(({ id }) => meshes.isDrawn(id))).toEqual([false, false, true]);
    meshes.cutAt(cutAll(2.8));
    expect(bodies.map(({ id }) => meshes.isDrawn(id))).toEqual([true, true, true]);
  });

  it("writes names in words", () => {
    expect(words("dining_table")).toBe("dining table");
  });
});

describe("colours", () => {
  it("take shades", () => {
    expect(shade("#000000", 0.5)).toBe("#808080");
    expect(shade("#ffffff", -1)).toBe("#000000");
  });
});

describe("drawn bodies", () => {
  const two = bodiesOf(scene([room("a", [0, 0, 4, 4], { furniture: [piece("one"), piece("two", { x: 3, rotation: 90 })] })]));

  /** The bodies that a ray straight down at a place meets. */
  function under(meshes: BodyMeshes, x: number, z: number): (string | undefined)[] {
    const ray = new Raycaster(new Vector3(x, 9, z), new Vector3(0, -1, 0));
    return ray.intersectObject(meshes.root, false).map((hit) => meshes.bodyAt(hit.instanceId)?.id);
  }

  it("are few batches that know whom a ray meets, by where and how each stands", () => {
    const meshes = new BodyMeshes(two, new ShapeBook(null));
    expect(meshes.batches).toBe(2);
    expect(under(meshes, 1.9, 1.3)).toEqual(["one"]);
    expect(under(meshes, 3.3, 1.9)).toEqual(["two"]);
    expect(under(meshes, 3.9, 1.3)).toEqual([]);
  });

  it("move and turn without being built anew", () => {
    const meshes = new BodyMeshes(two, new ShapeBook(null));
    expect(meshes.place("one", { x: 1, z: 3, turn: Math.PI / 2 })).toMatchObject({ x: 1, z: 3 });
    expect(under(meshes, 1, 1)).toEqual([]);
    expect(under(meshes, 1.3, 3.9)).toEqual(["one"]);
    expect(meshes.place("nobody", { x: 1 })).toBeUndefined();
  });

  it("are drawn where they are", () => {
    const into = new Float32Array(16);
    const paint = { color: "#ffffff", roughness: 1, metalness: 0, opacity: 1, glow: 0, texture: null };
    const leg = { form: "cylinder" as const, size: [0.1, 0.4, 0.2] as const, at: [0.8, 0.2, 0.3] as const, axis: "z" as const, taper: 1, paint };
    writePlace(into, 0, leg, placed(90));
    const drawn = new Matrix4().fromArray(into);
    const along = new Vector3(0, 0.1, 0).applyMatrix4(drawn);
    const expected = new Vector3(0.8, 0.2, 0.4).applyMatrix4(bodyMatrix(placed(90)));
    expect(along.distanceTo(expected)).toBeLessThan(1e-6);
  });

  it("may be none", () => {
    expect(new BodyMeshes([]).bodyAt(0)).toBeUndefined();
  });
});
