/** The ground and the sun's shadows reach as far as something casts them, whatever the hour, and no further. */
import { Box3, DirectionalLight, Mesh, ShadowMaterial, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { Daylight } from "../src/view/daylight";

const HOUSE = new Box3(new Vector3(-3, 0, 2), new Vector3(11, 1, 9));
const HOURS = [7, 9, 12, 15, 18];

function lit(top: number, hour: number): { daylight: Daylight; ground: Mesh; sun: DirectionalLight } {
  const daylight = new Daylight();
  daylight.around(HOUSE, top);
  daylight.turnTo(hour);
  daylight.root.updateMatrixWorld(true);
  const found: { ground?: Mesh; sun?: DirectionalLight } = {};
  daylight.root.traverse((one) => {
    if (one instanceof Mesh && one.material instanceof ShadowMaterial) found.ground = one;
    if (one instanceof DirectionalLight && one.castShadow) found.sun = one;
  });
  return { daylight, ...found } as ReturnType<typeof lit>;
}

/** The corners of the house's box, up to a height. */
function corners(top: number): Vector3[] {
  const { min, max } = HOUSE;
  return [min.x, max.x].flatMap((x) => [0, top].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z))));
}

/** Where a line from the sun through a point meets the ground: its sides are found by halving, not by the sun's slope. */
function shadowOf(point: Vector3, sun: Vector3, ground: number): Vector3 {
  let [near, far] = [0, 1e4];
  for (let i = 0; i < 80; i += 1) {
    const middle = (near + far) / 2;
    if (point.clone().addScaledVector(sun, -middle).y > ground) near = middle;
    else far = middle;
  }
  return point.clone().addScaledVector(sun, -near);
}

describe("daylight", () => {
  for (const top of [1.2, 2.8, 6]) {
    it(`lays the ground under all shadows of what is ${top} m high, and looks at all that casts them`, () => {
      for (const hour of HOURS) {
        const { daylight, ground, sun } = lit(top, hour);
        const box = new Box3().setFromObject(ground).expandByScalar(1e-3);
        sun.shadow.updateMatrices(sun);
        for (const corner of corners(top)) {
          expect(box.containsPoint(shadowOf(corner, daylight.direction, box.min.y + 1e-3))).toBe(true);
          const seen = corner.clone().project(sun.shadow.camera);
          expect(Math.max(Math.abs(seen.x), Math.abs(seen.y), Math.abs(seen.z))).toBeLessThan(1);
        }
      }
    });
  }

  it("lays less ground round what is lower", () => {
    const areas = [2.8, 6].map((top) => { const { x, z } = new Box3().setFromObject(lit(top, 15).ground).getSize(new Vector3()); return x * z; });
    expect(areas[0]).toBeLessThan((areas[1] as number) * 0.9);
  });
});
