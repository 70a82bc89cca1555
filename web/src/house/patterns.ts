/**
 * Patterns made in code, in greys: what is drawn multiplies its colour by them. Each repeats without a seam and is the same
 * every time. Made once for the life of the page, as the layers of one texture.
 */
import { DataArrayTexture, LinearFilter, LinearMipmapLinearFilter, RedFormat, RepeatWrapping, UnsignedByteType } from "three";

const SIZE = 256;

/** A pattern's brightness at every place of a square of so many places a side, row by row, `u` along the grain. */
type Grid = Float32Array;
type Pattern = (size: number) => Grid;

function hash(x: number, y: number, seed: number): number {
  let state = Math.imul(x, 374761393) + Math.imul(y, 668265263) + Math.imul(seed, 974634541);
  state = Math.imul(state ^ (state >>> 13), 1274126177);
  return ((state ^ (state >>> 16)) >>> 0) / 4294967296;
}

const ease = (t: number): number => t * t * (3 - 2 * t);

/** Which waves a row of places lies between, and how far along. */
function between(size: number, waves: number): { readonly low: Int32Array; readonly high: Int32Array; readonly share: Float32Array } {
  const places = Array.from({ length: size }, (_, i) => (i * waves) / size);
  return {
    low: Int32Array.from(places, Math.floor),
    high: Int32Array.from(places, (place) => (Math.floor(place) + 1) % waves),
    share: Float32Array.from(places, (place) => ease(place - Math.floor(place))),
  };
}

/** Adds smooth noise with whole numbers of waves along both sides, so that it repeats: between two rows of waves, then along them. */
function addNoise(grid: Grid, size: number, [wavesU, wavesV, seed]: Waves, weight: number): Grid {
  const { low, high, share } = between(size, wavesU);
  const along = between(size, wavesV);
  const row = new Float32Array(wavesU);
  for (let j = 0; j < size; j += 1) {
    const t = along.share[j] as number;
    for (let k = 0; k < wavesU; k += 1) row[k] = weight * (hash(k, along.low[j] as number, seed) * (1 - t) + hash(k, along.high[j] as number, seed) * t);
    const start = j * size;
    for (let i = 0; i < size; i += 1) {
      const left = row[low[i] as number] as number;
      grid[start + i] = (grid[start + i] as number) + left + ((row[high[i] as number] as number) - left) * (share[i] as number);
    }
  }
  return grid;
}

type Waves = readonly [wavesU: number, wavesV: number, seed: number];

/** The waves of noise of three sizes, and how much each counts. */
function rough(wavesU: number, wavesV: number, seed: number, weight = 1): readonly (readonly [weight: number, waves: Waves])[] {
  return [0.5, 0.3, 0.2].map((share, i) => [weight * share, [wavesU * 2 ** i, wavesV * 2 ** i, seed + i]]);
}

/** A sum of noises upon what is the same everywhere. */
function mixed(whole: number, ...noises: readonly (readonly [weight: number, waves: Waves])[]): Pattern {
  return (size) => {
    const grid = new Float32Array(size * size).fill(whole);
    for (const [weight, waves] of noises) addNoise(grid, size, waves, weight);
    return grid;
  };
}

function noise(size: number, ...waves: Waves): Grid {
  return addNoise(new Float32Array(size * size), size, waves, 1);
}

/** How dark a joint is at a distance from an edge, in shares of the square. */
function joint(distance: number, half: number): number {
  return Math.max(0, Math.min(1, (half * 1.8 - distance) / (half * 0.8)));
}

function edge(x: number): number {
  const inside = x - Math.floor(x);
  return Math.min(inside, 1 - inside);
}

const grains = new Map<number, Grid>();

/** Wood along `u`: rings, fibres that bend with them, pale streaks. Made once for all that is made of wood. */
function grainOf(size: number): Grid {
  const known = grains.get(size);
  if (known) return known;
  const [bend, swell, depth, streaks] = [noise(size, 3, 6, 11), noise(size, 2, 4, 12), noise(size, 4, 12, 13), noise(size, 3, 5, 15)] as const;
  const fibres = noise(size, 5, 90, 14);
  const made = new Float32Array(size * size);
  for (let at = 0; at < made.length; at += 1) {
    const row = Math.floor(at / size) + 0.02 * size * (bend[at] as number);
    const above = Math.floor(row);
    const upper = fibres[(above % size) * size + (at % size)] as number;
    const fibre = upper + ((fibres[((above + 1) % size) * size + (at % size)] as number) - upper) * (row - above);
    const rings = 0.5 + 0.5 * Math.sin(2 * Math.PI * ((9 * row) / size + 0.9 * (swell[at] as number)));
    made[at] = 1 - 0.13 * rings * (depth[at] as number) - 0.2 * fibre * fibre - 0.05 * (streaks[at] as number);
  }
  grains.set(size, made);
  return made;
}

function boards(count: number, gap: number): Pattern {
  return (size) => {
    const grid = grainOf(size).slice();
    for (let at = 0; at < grid.length; at += 1) {
      const along = (Math.floor(at / size) * count) / size;
      const board = Math.floor(along);
      const dark = Math.max(joint(edge(along) / count, gap), joint(edge((at % size) / size + hash(board, 0, 21)), gap * 0.5));
      grid[at] = ((grid[at] as number) - 0.12 * hash(board, 1, 22)) * (1 - 0.6 * dark);
    }
    return grid;
  };
}

interface Tiles {
  readonly across: number;
  /** Half of a joint, in shares of the square. */
  readonly half: number;
  readonly spread: number;
  readonly relief: number;
  readonly depth?: number;
}

function tiles({ across, half, spread, relief, depth = 0.28 }: Tiles): Pattern {
  return (size) => {
    const grid = mixed(1, ...rough(12, 12, 32, -relief))(size);
    for (let at = 0; at < grid.length; at += 1) {
      const u = ((at % size) * across) / size;
      const v = (Math.floor(at / size) * across) / size;
      const dark = Math.max(joint(edge(u) / across, half), joint(edge(v) / across, half));
      grid[at] = ((grid[at] as number) - spread * hash(Math.floor(u), Math.floor(v), 31)) * (1 - depth * dark);
    }
    return grid;
  };
}

/** Brighter than this a pattern of bricks is mortar. */
export const MORTAR = 0.93;

function bricks(size: number): Grid {
  const grid = mixed(MORTAR - 0.05, ...rough(24, 24, 42, -0.14))(size);
  for (let at = 0; at < grid.length; at += 1) {
    const up = (Math.floor(at / size) * 8) / size;
    const row = Math.floor(up);
    const along = ((at % size) * 4) / size + (row % 2) * 0.5;
    const dark = Math.max(joint(edge(along) / 4, 0.011), joint(edge(up) / 8, 0.011));
    grid[at] = ((grid[at] as number) - 0.26 * hash(Math.floor(along) % 4, row, 41)) * (1 - dark) + dark;
  }
  return grid;
}

function slabs(size: number): Grid {
  const [bendU, bendV, grid] = [noise(size, 8, 8, 51), noise(size, 8, 8, 52), mixed(1, ...rough(9, 9, 54, -0.22))(size)] as const;
  for (let at = 0; at < grid.length; at += 1) {
    const up = 4 * (Math.floor(at / size) / size + 0.012 * ((bendV[at] as number) - 0.5));
    const row = Math.floor(up);
    const along = 3 * ((at % size) / size + 0.012 * ((bendU[at] as number) - 0.5)) + (row & 1) * 0.5;
    const dark = Math.max(joint(edge(along) / 3, 0.012), joint(edge(up) / 4, 0.012));
    grid[at] = ((grid[at] as number) - 0.22 * hash((Math.floor(along) + 3) % 3, row & 3, 53)) * (1 - 0.5 * dark);
  }
  return grid;
}

/** Boards that stand side by side. */
function panelling(size: number): Grid {
  const [grain, grid] = [grainOf(size), new Float32Array(size * size)];
  for (let at = 0; at < grid.length; at += 1) {
    const across = ((at % size) * 8) / size;
    const upright = grain[(at % size) * size + Math.floor(at / size)] as number;
    grid[at] = (upright - 0.07 * hash(Math.floor(across), 0, 23)) * (1 - 0.32 * joint(edge(across) / 8, 0.0045));
  }
  return grid;
}

/** Broad stripes with a leaf on every other one. */
function wallpaper(size: number): Grid {
  const grid = mixed(1, [-0.02, [90, 90, 25]])(size);
  for (let at = 0; at < grid.length; at += 1) {
    const across = ((at % size) * 4) / size;
    const column = Math.floor(across);
    const up = (Math.floor(at / size) * 4) / size + (column % 2) * 0.5;
    const x = edge(across) * 2 - 1 + 0.35;
    const y = edge(up) * 2 - 1 + 0.35;
    const leaf = Math.max(0, 1 - 9 * Math.abs(x * x + y * y * 0.6 - 0.1)) * (0.8 + 0.2 * hash(column, Math.floor(up), 24));
    grid[at] = (grid[at] as number) - 0.035 * (column % 2) - 0.075 * leaf;
  }
  return grid;
}

/** Concrete as it came from its boards, with the holes of the ties. */
function cast(size: number): Grid {
  const grid = mixed(1, ...rough(6, 6, 26, -0.13), [-0.05, [110, 110, 27]])(size);
  for (let at = 0; at < grid.length; at += 1) {
    const u = (at % size) / size;
    const v = Math.floor(at / size) / size;
    const seam = Math.max(joint(edge(u), 0.002), joint(edge(v * 2) / 2, 0.002));
    const hole = joint(Math.hypot(edge(u * 2 + 0.5) / 2, edge(v * 2 + 0.5) / 2), 0.008);
    grid[at] = (grid[at] as number) * (1 - 0.22 * seam) * (1 - 0.4 * hole);
  }
  return grid;
}

function cloth(size: number): Grid {
  const grid = mixed(0.95, ...rough(16, 16, 61, -0.12))(size);
  const thread = Float32Array.from({ length: size }, (_, i) => Math.sin((2 * Math.PI * 32 * i) / size));
  for (let at = 0; at < grid.length; at += 1) grid[at] = (grid[at] as number) + 0.07 * (thread[at % size] as number) * (thread[Math.floor(at / size)] as number);
  return grid;
}

function hide(size: number): Grid {
  const [grid, small] = [noise(size, 22, 22, 71), noise(size, 44, 44, 72)] as const;
  for (let at = 0; at < grid.length; at += 1) {
    const folds = Math.abs((grid[at] as number) - 0.5) + Math.abs((small[at] as number) - 0.5) * 0.6;
    grid[at] = 0.84 + 0.22 * Math.min(0.7, folds);
  }
  return grid;
}

interface Layer {
  /** How many metres the square covers. */
  readonly span: number;
  readonly pattern: Pattern;
}

const plain = mixed(1);

const LAYERS: Readonly<Record<string, Layer>> = {
  plain: { span: 1, pattern: plain },
  wood: { span: 0.8, pattern: grainOf },
  fabric: { span: 0.22, pattern: cloth },
  leather: { span: 0.4, pattern: hide },
  metal: { span: 0.5, pattern: mixed(0.88, [0.12, [3, 128, 91]]) },
  tile: { span: 0.9, pattern: tiles({ across: 6, half: 0.006, spread: 0.05, relief: 0.03 }) },
  concrete: { span: 1.6, pattern: mixed(1, ...rough(6, 6, 95, -0.16), [-0.08, [100, 100, 96]]) },
  stone: { span: 1.8, pattern: slabs },
  grass: { span: 0.9, pattern: mixed(0.54, [0.22, [90, 24, 81]], [0.2, [24, 90, 82]], ...rough(5, 5, 83, 0.16)) },
  deck: { span: 1.1, pattern: boards(8, 0.006) },
  planks: { span: 1.2, pattern: boards(8, 0.002) },
  plaster: { span: 1.4, pattern: mixed(1, ...rough(10, 10, 97, -0.05), [-0.035, [70, 70, 98]]) },
  brick: { span: 0.8, pattern: bricks },
  wall_tile: { span: 0.8, pattern: tiles({ across: 4, half: 0.003, spread: 0.03, relief: 0.015, depth: 0.2 }) },
  panelling: { span: 1.0, pattern: panelling },
  wallpaper: { span: 0.9, pattern: wallpaper },
  cast: { span: 2.4, pattern: cast },
};
const NAMES = Object.keys(LAYERS);

/** The metres that each layer's square covers. */
export const patternSpans: readonly number[] = Object.values(LAYERS).map(({ span }) => span);

/** The layer of a pattern. */
export function layerOf(name: string): number {
  return NAMES.indexOf(name);
}

/** The layers that something is drawn with, and how many of them are made. */
const wanted = new Set<number>();
let countMade = 0;

/** The layer of a texture's name, which something is now drawn with; the plain one for a name that is not known. */
export function patternLayer(name: string | null): number {
  const layer = Math.max(0, name === null ? 0 : layerOf(name));
  wanted.add(layer);
  return layer;
}

/** A layer's greys, row by row. */
export function patternGreys(name: string, size = SIZE): Uint8Array<ArrayBuffer> {
  const grid = (LAYERS[name]?.pattern ?? plain)(size);
  const greys = new Uint8Array(grid.length);
  for (let at = 0; at < greys.length; at += 1) greys[at] = Math.max(0, Math.min(255, (grid[at] as number) * 255 + 0.5));
  return greys;
}

const texture = new DataArrayTexture(new Uint8Array(SIZE * SIZE * NAMES.length), SIZE, SIZE, NAMES.length);
Object.assign(texture, {
  format: RedFormat, type: UnsignedByteType, wrapS: RepeatWrapping, wrapT: RepeatWrapping,
  magFilter: LinearFilter, minFilter: LinearMipmapLinearFilter, generateMipmaps: true, anisotropy: 4,
});

/** Makes the next pattern that something is drawn with; false when all these are made. */
export function makeNextPattern(): boolean {
  const layer = [...wanted][countMade];
  if (layer === undefined) return false;
  (texture.image.data as Uint8Array).set(patternGreys(NAMES[layer] ?? ""), layer * SIZE * SIZE);
  texture.addLayerUpdate(layer);
  texture.needsUpdate = true;
  countMade += 1;
  return true;
}

/** All patterns as one texture, for shaders: what is now drawn is made. */
export const patternUniform = {
  get value(): DataArrayTexture {
    while (makeNextPattern());
    return texture;
  },
};
