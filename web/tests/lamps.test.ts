import { describe, expect, it } from "vitest";
import { lampsOf, lampUniforms, lightLamps, type Lamp } from "../src/house/lamps";
import { bodiesOf } from "../src/house/frame";
import { ShapeBook } from "../src/house/shapes";
import { Daylight } from "../src/view/daylight";
import { piece, room, scene } from "./rooms";

const BOOK = new ShapeBook({
  furniture: { floor_lamp: { size: [0.4, 0.4, 1.6], category: "lighting" }, oven: { size: [0.6, 0.6, 0.9], category: "appliance" } },
  decorations: { table_lamp: { size: [0.2, 0.2, 0.4], group: "lighting" } },
  shapes: {
    floor_lamp: [{ form: "box", x: [0, 1], y: [0, 0.1], z: [0, 1], material: "metal" }, { form: "box", x: [0, 1], y: [0.8, 1], z: [0, 1], material: "glow" }],
    oven: [{ form: "box", x: [0, 1], y: [0, 1], z: [0, 1], material: "glow" }],
  },
  materials: { glow: { glow: 0.8 } },
});
const STOREY = { elevation: 0, height: 2.8 };

function lamps(rooms: Parameters<typeof scene>[0]): Lamp[] {
  return lampsOf(rooms, STOREY, bodiesOf(scene(rooms)), (body) => (BOOK.isLamp(body) ? BOOK.partsOf(body, null) : null));
}

/** The lamps that a place of the ground is lit by, as a shader reads it. */
function lighting(x: number, z: number): number[] {
  const { lampMap, lampGround: { value: ground } } = lampUniforms;
  const { width, height, data } = lampMap.value.image as { width: number; height: number; data: Uint8Array };
  const [u, v] = [Math.floor(((x - ground.x) / ground.z) * width), Math.floor(((z - ground.y) / ground.w) * height)];
  const [first, count] = [data[(v * width + u) * 2] ?? 0, data[(v * width + u) * 2 + 1] ?? 0];
  return Array.from({ length: count }, (_, i) => first + i);
}

describe("lamps", () => {
  it("are under every ceiling, in a row in a long room, and where a lamp glows, not where anything else does", () => {
    const standing = piece("lamp", { kind: "floor_lamp", x: 1, z: 2, width: 0.4, depth: 0.4, height: 1.6 });
    const rooms = [
      room("a", [0, 0, 4, 4], { furniture: [standing, piece("oven", { kind: "oven", x: 3, z: 3 })] }), room("long", [0, 4, 14, 1.5]),
      room("garden", [4, 0, 10, 4], { outdoor: true }),
    ];
    const found = lamps(rooms);
    expect(found.map((lamp) => lamp.room.id)).toEqual(["a", "a", "long", "long", "long"]);
    expect(found[0]?.at[1]).toBeCloseTo(2.45);
    expect(found[1]?.at).toEqual([1, expect.closeTo(1.44), 2]);
    expect(new Set(found.slice(2).map(({ at }) => at[2]))).toEqual(new Set([4.75]));
  });

  it("light the places of their room, as far as its outline goes, and no other's", () => {
    const outline = [[0, 0], [6, 0], [6, 3], [3, 3], [3, 6], [0, 6]] as const;
    const rooms = [room("l", [0, 0, 6, 6], { outline: outline.map(([x, z]) => [x, z]) }), room("b", [3, 3, 3, 3])];
    const found = lamps(rooms);
    lightLamps(found, 1);
    const of = (x: number, z: number): (string | undefined)[] => lighting(x, z).map((i) => found[i]?.room.id);
    for (const [x, z] of [[1, 1], [5.9, 2.9], [2.9, 5.9], [0.1, 0.1]] as const) expect(new Set(of(x, z)), `${x} ${z}`).toEqual(new Set(["l"]));
    for (const [x, z] of [[3.1, 3.1], [5.9, 5.9]] as const) expect(new Set(of(x, z)), `${x} ${z}`).toEqual(new Set(["b"]));
    for (const [x, z] of [[-0.1, 1], [6.1, 1]] as const) expect(of(x, z), `${x} ${z}`).toEqual([]);
  });

  it("are dark by day, are lit in the morning and the evening, and are never more than a shader has places for", () => {
    const many = Array.from({ length: 120 }, (_, i) => room(`r${i}`, [i, 0, 1, 1]));
    lightLamps(lamps(many), 1);
    expect(lampUniforms.lampLight.value).toBe(1);
    expect(lamps(many).length).toBeLessThanOrEqual(lampUniforms.lampAt.value.length);
    const daylight = new Daylight();
    const lit = [6, 9, 12, 15, 17.5, 19].map((hour) => { daylight.turnTo(hour); return daylight.lamps; });
    expect(lit.map((share) => share > 0)).toEqual([true, false, false, false, true, true]);
    lightLamps([], 1);
    expect(lampUniforms.lampLight.value).toBe(0);
  });
});
