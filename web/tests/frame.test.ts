import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { BodyMeshes, bodyMatrix } from "../src/house/body_meshes";
import { bodiesOf, words, type PlacedBody } from "../src/house/frame";
import { partsOf, shade } from "../src/house/shapes";
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
    const shelf = { ...size, id: "a/shelf_1", name: "wall_shelf", y: 1.5, mounted_on_wall: "north" };
    const book = { ...size, id: "a/book_1", name: "book", y: 1.7, parent: "a/shelf_1" };
    const vase = { ...size, id: "a/vase_1", name: "vase", y: 0.9, parent: "a/sofa_1" };
    const bodies = bodiesOf(scene([room("a", [0, 0, 4, 4], { decorations: [book, shelf, vase] })]));
    expect(bodies.map((body) => body.hung)).toEqual([1.6, 1.6, undefined]);
    const meshes = new BodyMeshes(bodies);
    meshes.cutAt(1.4);
    expect([0, 1, 2].map((instance) => meshes.mesh.getVisibleAt(instance))).toEqual([false, false, true]);
    meshes.cutAt(2.8);
    expect([0, 1, 2].map((instance) => meshes.mesh.getVisibleAt(instance))).toEqual([true, true, true]);
  });

  it("writes names in words", () => {
    expect(words("dining_table")).toBe("dining table");
  });
});

describe("parts of a body", () => {
  it("of furniture fill its box, with an arrow on top at the front", () => {
    const [block, arrow] = partsOf(placed(90));
    expect(block).toMatchObject({ shape: "block", size: [2, 0.85, 0.9], at: [0, 0.425, 0] });
    expect(arrow?.shape).toBe("arrow");
    expect(arrow?.at[2]).toBeGreaterThan(0);
    expect((arrow?.at[2] ?? 0) + (arrow?.size[2] ?? 0) / 2).toBeLessThanOrEqual(0.45);
  });

  it("of a person, a dog and a cat stay within their boxes", () => {
    for (const name of ["person", "dog", "cat"]) {
      const body: PlacedBody = { ...placed(0), kind: "dynamic", name, width: 0.3, depth: 0.8, height: name === "person" ? 1.7 : 0.6 };
      const top = Math.max(...partsOf(body).map((part) => part.at[1] + part.size[1] / 2));
      const bottom = Math.min(...partsOf(body).map((part) => part.at[1] - part.size[1] / 2));
      expect(top, name).toBeCloseTo(body.height, 6);
      expect(bottom, name).toBeGreaterThanOrEqual(-1e-9);
    }
  });

  it("take shades of a colour", () => {
    expect(shade("#000000", 0.5)).toBe("#808080");
    expect(shade("#ffffff", -1)).toBe("#000000");
  });
});

describe("drawn bodies", () => {
  it("are one batch that knows whose each part is", () => {
    const bodies = bodiesOf(scene([room("a", [0, 0, 4, 4], { furniture: [piece("one"), piece("two", { x: 3 })] })]));
    const meshes = new BodyMeshes(bodies);
    expect(meshes.mesh.instanceCount).toBe(4);
    expect([0, 1, 2, 3].map((i) => meshes.bodyAt(i)?.id)).toEqual(["one", "one", "two", "two"]);
    meshes.mesh.computeBoundingBox();
    expect(meshes.mesh.boundingBox?.max.x).toBeCloseTo(4, 6);
  });

  it("may be none", () => {
    expect(new BodyMeshes([]).bodyAt(0)).toBeUndefined();
  });
});
