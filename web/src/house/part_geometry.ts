/**
 * The solids that all parts are drawn with, of unit size; the shader gives them theirs (part_shader.ts).
 *
 * `position` and `normal` are what the shader mixes with the size: a block's and a capsule's positions are corners without
 * their rounding, which goes along the normal. `side` tells the shader which rule a vertex follows.
 */
import { BufferAttribute, BufferGeometry } from "three";
import type { Part } from "./parts";

export type Solid = "box" | "rounded" | "round" | "stick" | "ball" | "bead" | "capsule";
export const SOLIDS: readonly Solid[] = ["box", "rounded", "round", "stick", "ball", "bead", "capsule"];

/** Rules of vertices: faces of a block by their axis, then a ball, a cylinder's mantle and caps, a capsule. */
export const RULE = { block: 0, ball: 3, mantle: 4, cap: 5, capsule: 6 } as const;

/** What is round and no wider [m] has fewer faces, which are nowhere 2.5 mm off. */
const SMALL = 0.06;
/** How many faces what is round has about its axis, and a ball from its foot to its top. */
const FINE = { around: 18, aroundSmall: 10, ball: [10, 16], bead: [6, 10], capsule: [4, 14] } as const;
/** Where a processor draws: three tenths of a home's triangles less, for a quarter of what a frame with its shadows costs. */
const COARSE = { around: 12, aroundSmall: 8, ball: [7, 12], bead: [4, 8], capsule: [3, 10] } as const;
let faces: typeof FINE | typeof COARSE = FINE;

/** From now on what is round has fewer faces; to be called before anything is built. */
export function makeCoarsely(): void {
  faces = COARSE;
}

class Draft {
  readonly #rows: number[][] = [];
  readonly #index: number[] = [];

  /** A vertex: position, normal, how far around [0..1], rule; returns its number. */
  vertex(position: readonly number[], normal: readonly number[], around: number, rule: number): number {
    return this.#rows.push([...position, ...normal, around, rule]) - 1;
  }

  /** A grid of rows of vertices, facing outside where rows run counter-clockwise up. */
  grid(rows: readonly (readonly number[])[]): void {
    for (let i = 0; i + 1 < rows.length; i += 1) {
      for (let j = 0; j + 1 < (rows[i]?.length ?? 0); j += 1) {
        const [a, b, c, d] = [rows[i]?.[j], rows[i]?.[j + 1], rows[i + 1]?.[j + 1], rows[i + 1]?.[j]] as [number, number, number, number];
        if (!this.#meet(a, b)) this.#index.push(a, b, c);
        if (!this.#meet(c, d)) this.#index.push(a, c, d);
      }
    }
  }

  /** Whether two vertices are one point of every part, as at a ball's pole: a triangle at both shows nothing. */
  #meet(one: number, other: number): boolean {
    const [from, to] = [this.#rows[one] ?? [], this.#rows[other] ?? []];
    return from.slice(0, 6).every((value, i) => Math.abs(value - (to[i] ?? 0)) < 1e-12);
  }

  fan(centre: number, ring: readonly number[], up: boolean): void {
    for (let i = 0; i + 1 < ring.length; i += 1) {
      const [a, b] = [ring[i] ?? 0, ring[i + 1] ?? 0];
      this.#index.push(centre, ...(up ? [a, b] : [b, a]));
    }
  }

  build(): BufferGeometry {
    const take = (from: number, to: number): BufferAttribute =>
      new BufferAttribute(new Float32Array(this.#rows.flatMap((row) => row.slice(from, to))), to - from);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", take(0, 3));
    geometry.setAttribute("normal", take(3, 6));
    geometry.setAttribute("rule", take(6, 8));
    geometry.setIndex(this.#index);
    return geometry;
  }
}

function unit(vector: readonly number[]): number[] {
  const length = Math.hypot(...vector);
  return vector.map((value) => value / length);
}

/** One face of a block: a grid of two columns (sharp) or four (rounded) each way. */
function face(draft: Draft, axis: 0 | 1 | 2, towards: 1 | -1, rounded: boolean): void {
  const stops: readonly (readonly [number, number])[] = rounded ? [[-0.5, -1], [-0.5, 0], [0.5, 0], [0.5, 1]] : [[-0.5, 0], [0.5, 0]];
  const [u, v] = towards > 0 ? [(axis + 1) % 3, (axis + 2) % 3] : [(axis + 2) % 3, (axis + 1) % 3];
  draft.grid(stops.map(([y, leanY]) => stops.map(([x, leanX]) => {
    const [position, normal] = [[0, 0, 0], [0, 0, 0]];
    position[axis] = towards / 2;
    normal[axis] = towards;
    [position[u as number], position[v as number]] = [x, y];
    [normal[u as number], normal[v as number]] = [leanX, leanY];
    return draft.vertex(position, unit(normal), 0, RULE.block + axis);
  })));
}

function block(rounded: boolean): BufferGeometry {
  const draft = new Draft();
  for (const axis of [0, 1, 2] as const) for (const towards of [1, -1] as const) face(draft, axis, towards, rounded);
  return draft.build();
}

/** A ring of vertices at a height; `make` gives position and normal for the ring's sine and cosine. */
function ring(draft: Draft, rule: number, make: (x: number, z: number) => readonly [readonly number[], readonly number[]], around: number): number[] {
  return Array.from({ length: around + 1 }, (_, i) => {
    const turn = (i / around) * 2 * Math.PI;
    return draft.vertex(...make(Math.sin(turn), Math.cos(turn)), i / around, rule);
  });
}

function round(around: number): BufferGeometry {
  const draft = new Draft();
  draft.grid([-0.5, 0.5].map((y) => ring(draft, RULE.mantle, (x, z) => [[x / 2, y, z / 2], [x, 0, z]], around)));
  for (const towards of [-1, 1]) {
    const normal = [0, towards, 0];
    const rim = ring(draft, RULE.cap, (x, z) => [[x / 2, towards / 2, z / 2], normal], around);
    draft.fan(draft.vertex([0, towards / 2, 0], normal, 0, RULE.cap), rim, towards > 0);
  }
  return draft.build();
}

function ball([rows, around]: readonly [number, number]): BufferGeometry {
  const draft = new Draft();
  draft.grid(Array.from({ length: rows + 1 }, (_, i) => {
    const [y, out] = [-Math.cos((i / rows) * Math.PI), Math.sin((i / rows) * Math.PI)];
    return ring(draft, RULE.ball, (x, z) => [[(x * out) / 2, y / 2, (z * out) / 2], [x * out, y, z * out]], around);
  }));
  return draft.build();
}

function capsule([rows, around]: readonly [number, number]): BufferGeometry {
  const draft = new Draft();
  const half = (end: number): number[][] => Array.from({ length: rows + 1 }, (_, i) => {
    const lift = (end < 0 ? i / rows - 1 : i / rows) * (Math.PI / 2);
    const [y, out] = [Math.sin(lift), Math.cos(lift)];
    return ring(draft, RULE.capsule, (x, z) => [[0, end / 2, 0], [x * out, y, z * out]], around);
  });
  draft.grid([...half(-1), ...half(1)]);
  return draft.build();
}

const MAKERS: Readonly<Record<Solid, () => BufferGeometry>> = {
  box: () => block(false), rounded: () => block(true), capsule: () => capsule(faces.capsule),
  round: () => round(faces.around), stick: () => round(faces.aroundSmall), ball: () => ball(faces.ball), bead: () => ball(faces.bead),
};
const made = new Map<Solid, BufferGeometry>();

/** A solid's geometry, made once for the life of the page; batches share its attributes. */
export function solidGeometry(solid: Solid): BufferGeometry {
  const geometry = made.get(solid) ?? MAKERS[solid]();
  made.set(solid, geometry);
  return geometry;
}

/** The solid that draws a part: a cone is a cylinder that tapers to nothing. */
export function solidOf({ form, size: [x, y, z], axis }: Pick<Part, "form" | "size" | "axis">): Solid {
  if (form === "ball") return Math.max(x, y, z) > SMALL ? "ball" : "bead";
  if (form !== "cylinder" && form !== "cone") return form;
  const across = { x: Math.max(y, z), y: Math.max(x, z), z: Math.max(x, y) }[axis];
  return across > SMALL ? "round" : "stick";
}
