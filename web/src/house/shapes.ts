/** What a body is drawn as: a few parts in its own frame, front at +z, underside at y = 0. */
import type { PlacedBody } from "./frame";

export type PartShape = "block" | "capsule" | "ball" | "cone" | "arrow";

/** One part [m]: `size` is width, height, depth; `at` its centre relative to the body's footprint centre and underside. */
export interface Part {
  readonly shape: PartShape;
  readonly size: readonly [number, number, number];
  readonly at: readonly [number, number, number];
  readonly color: string;
}

/** Lower than this a body is a rug or a mat: it has no front to mark. */
const FLAT = 0.05;
const ARROW_HEIGHT = 0.006;
const SKIN = "#d9a98c";

function channels(color: string): [number, number, number] {
  const value = Number.parseInt(color.slice(1, 7), 16);
  return Number.isNaN(value) ? [128, 128, 128] : [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

/** A colour moved towards white (share > 0) or black (share < 0). */
export function shade(color: string, share: number): string {
  const goal = share > 0 ? 255 : 0;
  const mixed = channels(color).map((channel) => Math.round(channel + (goal - channel) * Math.abs(share)));
  return `#${mixed.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
}

function isLight(color: string): boolean {
  const [red, green, blue] = channels(color);
  return 0.299 * red + 0.587 * green + 0.114 * blue > 140;
}

/** A small arrow on top, at the front edge: which way a box looks. */
function frontArrow(body: PlacedBody): Part {
  const length = Math.min(0.2, body.depth * 0.32, body.width * 0.32);
  return {
    shape: "arrow",
    size: [length * 1.25, ARROW_HEIGHT, length],
    at: [0, body.height + ARROW_HEIGHT / 2, body.depth / 2 - length / 2 - Math.min(0.06, body.depth * 0.1)],
    color: shade(body.color, isLight(body.color) ? -0.45 : 0.5),
  };
}

function boxParts(body: PlacedBody): Part[] {
  const { width, height, depth, color } = body;
  const block: Part = { shape: "block", size: [width, height, depth], at: [0, height / 2, 0], color };
  return body.kind === "furniture" && height > FLAT ? [block, frontArrow(body)] : [block];
}

function personParts({ width, depth, height, color }: PlacedBody): Part[] {
  const head = Math.min(0.24, height * 0.15);
  const body = height - head * 0.9;
  return [
    { shape: "capsule", size: [width * 0.85, body, depth * 0.95], at: [0, body / 2, 0], color },
    { shape: "ball", size: [head, head, head], at: [0, height - head / 2, 0], color: SKIN },
    { shape: "block", size: [head * 0.7, head * 0.18, head * 0.3], at: [0, height - head * 0.48, head * 0.42], color: "#2a2f3a" },
  ];
}

function petParts({ width, depth, height, color }: PlacedBody): Part[] {
  const trunk = height * 0.45;
  const head = Math.min(width * 0.85, height * 0.5);
  const ear = head * 0.45;
  const front = depth / 2 - head / 2;
  const ears = [-1, 1].map((side): Part => ({
    shape: "cone", size: [ear * 0.7, ear, ear * 0.5], at: [side * head * 0.28, height - ear / 2, front], color: shade(color, -0.25),
  }));
  const legs = [-1, 1].flatMap((side) => [-1, 1].map((end): Part => ({
    shape: "block", size: [width * 0.24, height * 0.4, width * 0.24], at: [side * width * 0.3, height * 0.2, end * depth * 0.27], color: shade(color, -0.15),
  })));
  return [
    { shape: "block", size: [width * 0.9, trunk, depth * 0.75], at: [0, height * 0.3 + trunk / 2, -depth * 0.08], color },
    { shape: "ball", size: [head, head, head], at: [0, height - ear * 0.8 - head * 0.4, front], color },
    ...ears,
    ...legs,
  ];
}

/** The parts a body is drawn with. */
export function partsOf(body: PlacedBody): Part[] {
  if (body.kind !== "dynamic") return boxParts(body);
  return body.name === "person" ? personParts(body) : petParts(body);
}
