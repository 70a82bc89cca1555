/**
 * Patterns made in code, in greys: what is drawn multiplies its colour by them. Each repeats without a seam and is the same
 * every time. Made once for the life of the page, as the layers of one texture.
 */
import { DataArrayTexture, LinearFilter, LinearMipmapLinearFilter, RedFormat, RepeatWrapping, UnsignedByteType } from "three";

const SIZE = 256;

/** A pattern's brightness at a place of its square, `u` along the grain; both 0 to 1. */
type Pattern = (u: number, v: number) => number;

function hash(x: number, y: number, seed: number): number {
  let state = Math.imul(x, 374761393) + Math.imul(y, 668265263) + Math.imul(seed, 974634541);
  state = Math.imul(state ^ (state >>> 13), 1274126177);
  return ((state ^ (state >>> 16)) >>> 0) / 4294967296;
}

const ease = (t: number): number => t * t * (3 - 2 * t);

/** Smooth noise with whole numbers of waves along both sides, so that it repeats; what it is where waves meet is calculated once. */
function noise(wavesU: number, wavesV: number, seed: number): Pattern {
  let knots: Float64Array | undefined;
  const make = (): Float64Array => Float64Array.from({ length: wavesU * wavesV }, (_, i) => hash(i % wavesU, Math.floor(i / wavesU), seed));
  return (u, v) => {
    const at = (knots ??= make());
    const x = u * wavesU;
    const y = v * wavesV;
    const i = Math.floor(x);
    const j = Math.floor(y);
    const s = ease(x - i);
    const t = ease(y - j);
    const [left, right] = [i % wavesU, (i + 1) % wavesU];
    const [low, high] = [(j % wavesV) * wavesU, ((j + 1) % wavesV) * wavesU];
    return ((at[low + left] as number) * (1 - s) + (at[low + right] as number) * s) * (1 - t)
      + ((at[high + left] as number) * (1 - s) + (at[high + right] as number) * s) * t;
  };
}

/** Noise of three sizes. */
function rough(wavesU: number, wavesV: number, seed: number): Pattern {
  const [large, middle, small] = [noise(wavesU, wavesV, seed), noise(wavesU * 2, wavesV * 2, seed + 1), noise(wavesU * 4, wavesV * 4, seed + 2)];
  return (u, v) => large(u, v) * 0.5 + middle(u, v) * 0.3 + small(u, v) * 0.2;
}

/** How dark a joint is at a distance from an edge, in shares of the square. */
function joint(distance: number, half: number): number {
  return Math.max(0, Math.min(1, (half * 1.8 - distance) / (half * 0.8)));
}

function edge(x: number): number {
  const inside = x - Math.floor(x);
  return Math.min(inside, 1 - inside);
}

/** Each by its kind and its seed. */
const noise11 = noise(3, 6, 11);
const noise12 = noise(2, 4, 12);
const noise13 = noise(4, 12, 13);
const noise14 = noise(5, 90, 14);
const noise15 = noise(3, 5, 15);
const noise25 = noise(90, 90, 25);
const rough26 = rough(6, 6, 26);
const noise27 = noise(110, 110, 27);
const rough32 = rough(12, 12, 32);
const rough42 = rough(24, 24, 42);
const noise51 = noise(8, 8, 51);
const noise52 = noise(8, 8, 52);
const rough54 = rough(9, 9, 54);
const rough61 = rough(16, 16, 61);
const noise71 = noise(22, 22, 71);
const noise72 = noise(44, 44, 72);
const noise81 = noise(90, 24, 81);
const noise82 = noise(24, 90, 82);
const rough83 = rough(5, 5, 83);
const noise91 = noise(3, 128, 91);
const rough95 = rough(6, 6, 95);
const noise96 = noise(100, 100, 96);
const rough97 = rough(10, 10, 97);
const noise98 = noise(70, 70, 98);

function grain(u: number, v: number): number {
  const bent = v + 0.02 * noise11(u, v);
  const rings = 0.5 + 0.5 * Math.sin(2 * Math.PI * (9 * bent + 0.9 * noise12(u, v)));
  return 1 - 0.13 * rings * noise13(u, v) - 0.2 * noise14(u, bent - Math.floor(bent)) ** 2 - 0.05 * noise15(u, v);
}

function boards(count: number, gap: number): Pattern {
  return (u, v) => {
    const board = Math.floor(v * count);
    const end = edge(u + hash(board, 0, 21));
    const dark = Math.max(joint(edge(v * count) / count, gap), joint(end, gap * 0.5));
    return (grain(u, v) - 0.12 * hash(board, 1, 22)) * (1 - 0.6 * dark);
  };
}

function tiles(across: number, half: number, spread: number, relief: number, depth = 0.28): Pattern {
  return (u, v) => {
    const [i, j] = [Math.floor(u * across), Math.floor(v * across)];
    const dark = Math.max(joint(edge(u * across) / across, half), joint(edge(v * across) / across, half));
    return (1 - spread * hash(i, j, 31) - relief * rough32(u, v)) * (1 - depth * dark);
  };
}

/** Brighter than this a pattern of bricks is mortar. */
export const MORTAR = 0.93;

function bricks(u: number, v: number): number {
  const row = Math.floor(v * 8);
  const along = u * 4 + (row % 2) * 0.5;
  const dark = Math.max(joint(edge(along) / 4, 0.011), joint(edge(v * 8) / 8, 0.011));
  const stone = MORTAR - 0.05 - 0.26 * hash(((Math.floor(along) % 4) + 4) % 4, row, 41) - 0.14 * rough42(u, v);
  return stone * (1 - dark) + 1.0 * dark;
}

function slabs(u: number, v: number): number {
  const bent: readonly [number, number] = [u + 0.012 * (noise51(u, v) - 0.5), v + 0.012 * (noise52(u, v) - 0.5)];
  const row = Math.floor(bent[1] * 4);
  const along = bent[0] * 3 + (row % 2) * 0.5;
  const dark = Math.max(joint(edge(along) / 3, 0.012), joint(edge(bent[1] * 4) / 4, 0.012));
  const stone = 1 - 0.22 * hash(((Math.floor(along) % 3) + 3) % 3, ((row % 4) + 4) % 4, 53) - 0.22 * rough54(u, v);
  return stone * (1 - 0.5 * dark);
}

/** Boards that stand side by side. */
function panelling(u: number, v: number): number {
  const board = Math.floor(u * 8);
  return (grain(v, u) - 0.07 * hash(board, 0, 23)) * (1 - 0.32 * joint(edge(u * 8) / 8, 0.0045));
}

/** Broad stripes with a leaf on every other one. */
function wallpaper(u: number, v: number): number {
  const [column, row] = [Math.floor(u * 4), Math.floor(v * 4 + (Math.floor(u * 4) % 2) * 0.5)];
  const [x, y] = [edge(u * 4) * 2 - 1, edge(v * 4 + (column % 2) * 0.5) * 2 - 1];
  const leaf = Math.max(0, 1 - 9 * Math.abs((x + 0.35) ** 2 + (y + 0.35) ** 2 * 0.6 - 0.1)) * (0.8 + 0.2 * hash(column, row, 24));
  return 1 - 0.035 * (column % 2) - 0.075 * leaf - 0.02 * noise25(u, v);
}

/** Concrete as it came from its boards, with the holes of the ties. */
function cast(u: number, v: number): number {
  const seam = Math.max(joint(edge(u), 0.002), joint(edge(v * 2) / 2, 0.002));
  const hole = joint(Math.hypot(edge(u * 2 + 0.5) / 2, edge(v * 2 + 0.5) / 2), 0.008);
  return (1 - 0.13 * rough26(u, v) - 0.05 * noise27(u, v)) * (1 - 0.22 * seam) * (1 - 0.4 * hole);
}

function cloth(u: number, v: number): number {
  const [warp, weft] = [Math.sin(2 * Math.PI * 32 * u), Math.sin(2 * Math.PI * 32 * v)];
  return 0.9 + 0.07 * warp * weft - 0.12 * rough61(u, v) + 0.05;
}

function hide(u: number, v: number): number {
  const folds = Math.abs(noise71(u, v) - 0.5) + Math.abs(noise72(u, v) - 0.5) * 0.6;
  return 0.84 + 0.22 * Math.min(0.7, folds);
}

function blades(u: number, v: number): number {
  return 0.62 + 0.22 * noise81(u, v) + 0.2 * noise82(u, v) + 0.16 * rough83(u, v) - 0.08;
}

interface Layer {
  /** How many metres the square covers. */
  readonly span: number;
  readonly pattern: Pattern;
}

const LAYERS: Readonly<Record<string, Layer>> = {
  plain: { span: 1, pattern: () => 1 },
  wood: { span: 0.8, pattern: grain },
  fabric: { span: 0.22, pattern: cloth },
  leather: { span: 0.4, pattern: hide },
  metal: { span: 0.5, pattern: (u, v) => 0.88 + 0.12 * noise91(u, v) },
  tile: { span: 0.9, pattern: tiles(6, 0.006, 0.05, 0.03) },
  concrete: { span: 1.6, pattern: (u, v) => 1 - 0.16 * rough95(u, v) - 0.08 * noise96(u, v) },
  stone: { span: 1.8, pattern: slabs },
  grass: { span: 0.9, pattern: blades },
  deck: { span: 1.1, pattern: boards(8, 0.006) },
  plaster: { span: 1.4, pattern: (u, v) => 1 - 0.05 * rough97(u, v) - 0.035 * noise98(u, v) },
  brick: { span: 0.8, pattern: bricks },
  wall_tile: { span: 0.8, pattern: tiles(4, 0.003, 0.03, 0.015, 0.2) },
  panelling: { span: 1.0, pattern: panelling },
  wallpaper: { span: 0.9, pattern: wallpaper },
  cast: { span: 2.4, pattern: cast },
};
const NAMES = Object.keys(LAYERS);

/** The metres that each layer's square covers. */
export const patternSpans: readonly number[] = Object.values(LAYERS).map(({ span }) => span);

/** The layer of a texture's name; the plain one for a name that is not known. */
export function patternLayer(name: string | null): number {
  return Math.max(0, name === null ? 0 : NAMES.indexOf(name));
}

/** A layer's greys, row by row. */
export function patternGreys(name: string, size = SIZE): Uint8Array<ArrayBuffer> {
  const greys = new Uint8Array(size * size);
  const pattern = LAYERS[name]?.pattern ?? (() => 1);
  for (let i = 0; i < greys.length; i += 1) {
    greys[i] = Math.round(255 * Math.max(0, Math.min(1, pattern((i % size) / size, Math.floor(i / size) / size))));
  }
  return greys;
}

const greys: Uint8Array[] = [];

/** Makes the next pattern; false when all are made. */
export function makeNextPattern(): boolean {
  const name = NAMES[greys.length];
  if (name !== undefined) greys.push(patternGreys(name));
  return name !== undefined;
}

let made: DataArrayTexture | undefined;

function make(): DataArrayTexture {
  while (makeNextPattern());
  const layers = new Uint8Array(SIZE * SIZE * NAMES.length);
  greys.forEach((layer, i) => layers.set(layer, i * SIZE * SIZE));
  const texture = new DataArrayTexture(layers, SIZE, SIZE, NAMES.length);
  Object.assign(texture, {
    format: RedFormat, type: UnsignedByteType, wrapS: RepeatWrapping, wrapT: RepeatWrapping,
    magFilter: LinearFilter, minFilter: LinearMipmapLinearFilter, generateMipmaps: true, anisotropy: 4, needsUpdate: true,
  });
  return texture;
}

/** All patterns as one texture, for shaders: made when something is first drawn with it. */
export const patternUniform = {
  get value(): DataArrayTexture {
    return (made ??= make());
  },
};
