// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { Matrix4, Vector3 } from "three";
import { bodyShade, Contacts, wallShades } from "../src/house/contacts";
import { bodiesOf } from "../src/house/frame";
import { ceilingMesh } from "../src/house/floors";
import { openingsOf } from "../src/house/openings";
import { runsOf } from "../src/house/wall_runs";
import type { WallPlan } from "../src/house/walls";
import { plainPaint } from "../src/house/paints";
import { part } from "../src/house/parts";
import { opening, piece, room, scene } from "./rooms";

function planOf(...rooms: ReturnType<typeof room>[]): WallPlan {
  return { runs: runsOf(rooms, 0.1), openings: openingsOf(rooms, 0.1), storeys: new Map([[0, { elevation: 0, height: 2.8 }]]) };
}

const UNKNOWN = (): null => null;

describe("shade where things meet the floor", () => {
  const doored = room("a", [0, 0, 4, 3], {
    openings: [opening({ position: 2 }), opening({ id: "window_1", kind: "window", wall: "north", position: 2, sill: 0.9, height: 1.2 })],
  });

  it("runs along every wall, past windows, and stops at doors", () => {
    const [north, south] = [0, 3].map((z) => wallShades(planOf(doored)).filter(({ at, turn, half }) => turn === 0 && at[2] === z && half[0] > half[1]));
    expect(north?.map(({ half }) => half[0])).toEqual([2]);
    expect(south?.map(({ at, half }) => [at[0] - half[0], at[0] + half[0]]).flat().map((x) => Number(x.toFixed(6)))).toEqual([0, 1.55, 2.45, 4]);
  });

  it("lies around what stands on a floor, and under nothing that lies flat, hangs or stands on furniture", () => {
    const home = scene([room("a", [0, 0, 4, 3], {
      furniture: [piece("sofa"), piece("shelf", { y: 1.4 }), piece("mat", { height: 0.02 })],
    })]);
    expect(bodiesOf(home).map((body) => bodyShade(body, [0], UNKNOWN) !== null)).toEqual([true, false, false]);
    const [sofa] = bodiesOf(home);
    expect(sofa && bodyShade({ ...sofa, y: 3 }, [0, 3], UNKNOWN)?.at[1]).toBeCloseTo(3.014, 9);
  });

  it("lies around the trunk of a tree and not beneath its crown, wherever that stands in it", () => {
    const [tree] = bodiesOf(scene([room("a", [0, 0, 4, 3], { furniture: [piece("tree", { x: 2, z: 1, width: 1.2, depth: 1, height: 3, rotation: 90 })] })]));
    if (!tree) throw new Error("no tree");
    const paint = plainPaint("#333333");
    const parts = [part("cylinder", [0.2, 1.6, 0.3], [0.1, 0.8, -0.2], paint), part("ball", [1.2, 2, 1], [0, 2, 0], paint)];
    const shade = bodyShade(tree, [0], () => parts);
    expect(shade?.half.map((side) => Number(side.toFixed(6)))).toEqual([0.06, 0.11]);
    expect([shade?.at[0], shade?.at[2]].map((at) => Number(at?.toFixed(6)))).toEqual([2 - 0.2, 1 - 0.1]); // turned to the east: its right is north, its back west
    expect(bodyShade(tree, [0], () => parts.slice(1))?.half).toEqual(bodyShade(tree, [0], UNKNOWN)?.half);
  });

  it("follows a body that moves, and is gone where it hangs", () => {
    const [sofa] = bodiesOf(scene([room("a", [0, 0, 4, 3], { furniture: [piece("sofa")] })]));
    if (!sofa) throw new Error("no sofa");
    const contacts = new Contacts(planOf(), [sofa], UNKNOWN);
    const seen = (): Matrix4 => { const matrix = new Matrix4(); contacts.root.getMatrixAt(0, matrix); return matrix; };
    contacts.place({ ...sofa, x: 2.5, turn: Math.PI / 2 });
    const corner = new Vector3(1, 0, 0).applyMatrix4(seen());
    expect([corner.x, corner.z].map((one) => Number(one.toFixed(5)))).toEqual([2.5, sofa.z - 1].map((one) => Number(one.toFixed(5))));
    contacts.place({ ...sofa, y: 1 });
    expect(seen().determinant()).toBe(0);
  });

  it("needs no walls and no bodies", () => {
    expect(new Contacts(planOf(), [], UNKNOWN).root.count).toBe(0);
  });
});

describe("ceilings", () => {
  it("lie where the walls of rooms inside end, as large as their floors", () => {
    const rooms = [room("a", [0, 0, 4, 3]), room("garden", [4, 0, 5, 3], { outdoor: true })];
    const { geometry } = ceilingMesh(rooms, new Map([[0, { elevation: 0, height: 2.5 }]]));
    geometry.computeBoundingBox();
    expect(geometry.boundingBox?.min.toArray()).toEqual([0, 2.5, 0]);
    expect(geometry.boundingBox?.max.toArray()).toEqual([4, 2.5, 3]);
  });
});
