/** The way around furniture and walls to a place that is clicked: breadth first over a lattice, then straightened. Pure. */
import { HALF_BODY, type Place, type Rectangle } from "./walk_floor";

/** The lattice's step [m]. */
const CELL = 0.05;
/** Cells around one's own that must be floor too: half a body, and one for what rounding to the lattice costs. */
const REACH = Math.ceil(HALF_BODY / CELL) + 1;

class Lattice {
  readonly x0: number;
  readonly z0: number;
  readonly columns: number;
  readonly lines: number;
  /** 1 where one may stand. */
  readonly free: Uint8Array;

  constructor(floor: readonly Rectangle[]) {
    const edge = (k: 0 | 1 | 2 | 3, most: 1 | -1): number => most * Math.max(...floor.map((one) => most * one[k]));
    [this.x0, this.z0] = [edge(0, -1), edge(1, -1)];
    [this.columns, this.lines] = [Math.ceil((edge(2, 1) - this.x0) / CELL) + 1, Math.ceil((edge(3, 1) - this.z0) / CELL) + 1];
    const covered = new Uint8Array(this.columns * this.lines);
    for (const [west, north, east, south] of floor) {
      const [from, to] = [Math.ceil((west - this.x0) / CELL), Math.floor((east - this.x0) / CELL)];
      for (let line = Math.ceil((north - this.z0) / CELL); line <= Math.floor((south - this.z0) / CELL); line += 1) {
        covered.fill(1, line * this.columns + from, line * this.columns + to + 1);
      }
    }
    this.free = this.#narrowed(this.#narrowed(covered, 1, this.columns), this.columns, this.lines);
  }

  /** What has only covered cells around it in one direction. */
  #narrowed(covered: Uint8Array, stride: number, length: number): Uint8Array {
    return covered.map((_, at) => {
      const along = Math.floor(at / stride) % length;
      if (along < REACH || along >= length - REACH) return 0;
      for (let k = -REACH; k <= REACH; k += 1) if (covered[at + k * stride] === 0) return 0;
      return 1;
    });
  }

  cellOf([x, z]: Place): number {
    return Math.round((z - this.z0) / CELL) * this.columns + Math.round((x - this.x0) / CELL);
  }

  placeOf(cell: number): Place {
    return [this.x0 + (cell % this.columns) * CELL, this.z0 + Math.floor(cell / this.columns) * CELL];
  }

  /** From every cell that is reached, the one before it. */
  flood(start: number): Int32Array {
    const before = new Int32Array(this.free.length).fill(-1);
    const queue = [start];
    before[start] = start;
    for (const cell of queue) {
      for (const next of [cell - 1, cell + 1, cell - this.columns, cell + this.columns]) {
        if (this.free[next] !== 1 || before[next] !== -1) continue;
        before[next] = cell;
        queue.push(next);
      }
    }
    return before;
  }

  /** The free cell nearest to a place for which something holds; null where there is none. */
  nearest([x, z]: Place, suits: (cell: number) => boolean): number | null {
    let [best, least] = [-1, Number.POSITIVE_INFINITY];
    for (let cell = 0; cell < this.free.length; cell += 1) {
      if (this.free[cell] !== 1 || !suits(cell)) continue;
      const at = this.placeOf(cell);
      const far = (at[0] - x) ** 2 + (at[1] - z) ** 2;
      if (far < least) [best, least] = [cell, far];
    }
    return best < 0 ? null : best;
  }

  /** Whether all is free straight from one cell to another. */
  isStraight(one: number, other: number): boolean {
    const [[x0, z0], [x1, z1]] = [this.placeOf(one), this.placeOf(other)];
    const count = Math.ceil((2 * Math.hypot(x1 - x0, z1 - z0)) / CELL);
    for (let i = 1; i < count; i += 1) {
      if (this.free[this.cellOf([x0 + ((x1 - x0) * i) / count, z0 + ((z1 - z0) * i) / count])] !== 1) return false;
    }
    return true;
  }
}

/**
 * The corners of a way over a floor, from beside where one stands to the place asked for, or as near as one comes to it.
 * Empty where one cannot move at all.
 */
export function routeOver(floor: readonly Rectangle[], from: Place, to: Place): Place[] {
  if (floor.length === 0) return [];
  const lattice = new Lattice(floor);
  const start = lattice.nearest(from, () => true);
  if (start === null) return [];
  const before = lattice.flood(start);
  const end = lattice.nearest(to, (cell) => before[cell] !== -1);
  if (end === null) return [];
  const cells = [end];
  while (cells.at(-1) !== start) cells.push(before[cells.at(-1) ?? start] ?? start);
  cells.reverse();
  const corners: number[] = [];
  for (let at = 0; at < cells.length - 1;) {
    let next = cells.length - 1;
    while (next > at + 1 && !lattice.isStraight(cells[at] ?? start, cells[next] ?? start)) next -= 1;
    corners.push(cells[next] ?? end);
    at = next;
  }
  return corners.map((cell) => lattice.placeOf(cell));
}
