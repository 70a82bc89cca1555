/** How people and pets look: capsules with heads, and ears. Who sits, sits on the seat with the feet towards the floor. Pure. */
import type { PlacedBody } from "./frame";
import { plainPaint, shade } from "./paints";
import { part, type Part } from "./parts";

const SKIN = plainPaint("#d9a98c");
const HAIR = plainPaint("#4a3428");
const EYES = plainPaint("#262a33");
const CLOTH = "fabric";
/** Shins and feet of somebody who sits reach no further down than a leg is long [m]. */
const SHIN = 0.5;

function head(size: number, x: number, top: number, z: number): Part[] {
  return [
    part("ball", [size * 0.92, size, size], [x, top - size / 2, z], SKIN),
    part("ball", [size * 0.98, size * 0.62, size * 0.98], [x, top - size * 0.31, z - size * 0.07], HAIR),
    part("rounded", [size * 0.56, size * 0.12, size * 0.2], [x, top - size * 0.56, z + size * 0.4], EYES),
  ];
}

function personParts({ width, depth, height, color }: PlacedBody): Part[] {
  const size = Math.min(0.24, height * 0.15);
  const [hip, shoulder] = [height * 0.5, height - size * 1.05];
  const trousers = plainPaint(shade(color, -0.55), CLOTH);
  const shirt = plainPaint(color, CLOTH);
  const arm = Math.min(0.1, width * 0.18);
  return [
    ...[-1, 1].map((side) => part("capsule", [width * 0.36, hip * 1.1, depth * 0.6], [side * width * 0.18, hip * 0.55, 0], trousers)),
    part("capsule", [width * 0.74, shoulder - hip * 0.9, depth * 0.92], [0, (shoulder + hip * 0.9) / 2, 0], shirt),
    ...[-1, 1].map((side) => part("capsule", [arm, (shoulder - hip) * 1.1, arm], [side * (width - arm) * 0.5, shoulder - (shoulder - hip) * 0.62, 0], shirt)),
    ...head(size, 0, height, 0),
  ];
}

/** Somebody who sits `seat` metres above the floor, the box from the seat up. */
export function seatedParts({ width, depth, height, color }: PlacedBody, seat: number): Part[] {
  const size = Math.min(0.24, height * 0.26);
  const trousers = plainPaint(shade(color, -0.55), CLOTH);
  const shirt = plainPaint(color, CLOTH);
  const thick = Math.min(0.15, height * 0.17);
  const [shoulder, trunk] = [height - size * 1.02, Math.min(0.26, depth * 0.52)];
  const shin = Math.min(seat, SHIN) + thick;
  const arm = Math.min(0.1, width * 0.2);
  const back = -depth / 2 + trunk / 2;
  const legs = [-1, 1].flatMap((side): Part[] => [
    { ...part("capsule", [width * 0.34, thick, depth * 0.86], [side * width * 0.2, thick / 2, depth * 0.07], trousers), axis: "z" },
    part("capsule", [width * 0.27, shin, thick], [side * width * 0.2, thick - shin / 2, depth / 2 + thick * 0.1], trousers),
    part("capsule", [arm, shoulder * 0.62, arm], [side * (width - arm) / 2, shoulder * 0.66, back + trunk * 0.1], shirt),
  ]);
  return [...legs, part("capsule", [width * 0.78, shoulder, trunk], [0, shoulder / 2, back], shirt), ...head(size, 0, height, back)];
}

function petParts({ width, depth, height, color }: PlacedBody): Part[] {
  const coat = plainPaint(color, CLOTH);
  const dark = plainPaint(shade(color, -0.3));
  const size = Math.min(width * 0.9, height * 0.5);
  const ear = size * 0.45;
  const front = depth / 2 - size / 2;
  const trunk = height * 0.42;
  return [
    { ...part("capsule", [width * 0.9, trunk, depth * 0.72], [0, height * 0.33 + trunk / 2, -depth * 0.06], coat), axis: "z" },
    part("ball", [size, size, size], [0, height - ear * 0.7 - size * 0.42, front], coat),
    part("ball", [size * 0.45, size * 0.36, size * 0.4], [0, height - ear * 0.7 - size * 0.55, front + size * 0.34], dark),
    ...[-1, 1].map((side) => part("cone", [ear * 0.7, ear, ear * 0.5], [side * size * 0.28, height - ear / 2, front], dark)),
    ...[-1, 1].flatMap((side) => [-1, 1].map((end) =>
      part("capsule", [width * 0.26, height * 0.5, width * 0.26], [side * width * 0.28, height * 0.25, end * depth * 0.24 - depth * 0.05], coat))),
    { ...part("capsule", [width * 0.14, width * 0.14, depth * 0.22], [0, height * 0.62, -depth * 0.39], dark), axis: "z" },
  ];
}

/** The parts of somebody who stands. */
export function livingParts(body: PlacedBody): Part[] {
  return body.name === "person" ? personParts(body) : petParts(body);
}
