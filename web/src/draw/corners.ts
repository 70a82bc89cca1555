/** Rooms as corners: polygons of north-south and east-west lines on the millimetre lattice, clockwise as seen from above (x east, z south). */

/** A point of the plan [mm]. */
export interface Point {
  readonly x: number;
  readonly z: number;
}

/** A rectangle of the plan [mm]: `x0 < x1`, `z0 < z1`. */
export interface Box {
  readonly x0: number;
  readonly z0: number;
  readonly x1: number;
  readonly z1: number;
}

export type Corners = readonly Point[];
export type Axis = "x" | "z";

/** One wall of a room: a stretch of a line, from its lesser end to its greater [mm]. */
export interface Wall {
  /** The corner it starts from. */
  readonly index: number;
  /** Along which axis it runs; `line` is the other coordinate. */
  readonly axis: Axis;
  readonly line: number;
  readonly from: number;
  readonly to: number;
  /** On which side of the line the room lies: 1 towards greater coordinates. */
  readonly inward: 1 | -1;
}

export function boxOf(corners: Corners): Box {
  const [xs, zs] = [corners.map(({ x }) => x), corners.map(({ z }) => z)];
  return { x0: Math.min(...xs), z0: Math.min(...zs), x1: Math.max(...xs), z1: Math.max(...zs) };
}

export function cornersOfBox({ x0, z0, x1, z1 }: Box): Corners {
  return [{ x: x0, z: z0 }, { x: x1, z: z0 }, { x: x1, z: z1 }, { x: x0, z: z1 }];
}

/** The rectangle that two points span. */
export function boxBetween(a: Point, b: Point): Box {
  return { x0: Math.min(a.x, b.x), z0: Math.min(a.z, b.z), x1: Math.max(a.x, b.x), z1: Math.max(a.z, b.z) };
}

export function shifted(corners: Corners, dx: number, dz: number): Corners {
  return corners.map(({ x, z }) => ({ x: x + dx, z: z + dz }));
}

function after<Thing>(list: readonly Thing[], index: number): Thing {
  return list[(index + 1) % list.length] as Thing;
}

/** Twice the area within [mm²]: positive where the corners go clockwise. */
export function doubleArea(corners: Corners): number {
  return corners.reduce((sum, { x, z }, i) => sum + x * after(corners, i).z - after(corners, i).x * z, 0);
}

/** The floor within [mm²]. */
export function areaOf(corners: Corners): number {
  return Math.abs(doubleArea(corners)) / 2;
}

export function wallsOf(corners: Corners): Wall[] {
  return corners.map((a, index) => {
    const b = after(corners, index);
    const alongX = a.z === b.z;
    const [start, end] = alongX ? [a.x, b.x] : [a.z, b.z];
    const forwards = end > start;
    return {
      index, axis: alongX ? "x" : "z", line: alongX ? a.z : a.x,
      from: Math.min(start, end), to: Math.max(start, end), inward: alongX === forwards ? 1 : -1,
    };
  });
}

/** The corners without those on a straight line or twice in a place, begun at the westernmost of the northernmost. */
export function tidied(corners: Corners): Corners {
  let kept = [...corners];
  for (let before = -1; before !== kept.length;) {
    before = kept.length;
    kept = kept.filter((b, i) => {
      const [a, c] = [kept.at(i - 1) as Point, after(kept, i)];
      return !((a.x === b.x && b.x === c.x) || (a.z === b.z && b.z === c.z));
    });
  }
  const first = kept.reduce((best, { x, z }, i) => {
    const least = kept[best] as Point;
    return z < least.z || (z === least.z && x < least.x) ? i : best;
  }, 0);
  return [...kept.slice(first), ...kept.slice(0, first)];
}

/** Whether the walls meet at corners only, and go clockwise around some floor. */
export function isSound(corners: Corners): boolean {
  if (corners.length < 4 || doubleArea(corners) <= 0) return false;
  const walls = wallsOf(corners);
  if (walls.some(({ from, to }, i) => from === to || after(walls, i).axis === walls[i]?.axis)) return false;
  return walls.every((a, i) => walls.every((b, k) => {
    const areNeighbours = Math.abs(i - k) <= 1 || Math.abs(i - k) === walls.length - 1;
    if (areNeighbours) return true;
    if (a.axis === b.axis) return a.line !== b.line || a.to < b.from || b.to < a.from;
    return !(a.from <= b.line && b.line <= a.to && b.from <= a.line && a.line <= b.to);
  }));
}

/** Whether the middle of a cell is within the corners: a ray to the west crosses an odd number of walls. */
export function holds(corners: Corners, { x, z }: Point): boolean {
  const crossed = wallsOf(corners).filter((wall) => wall.axis === "z" && wall.line < x && wall.from <= z && z < wall.to);
  return crossed.length % 2 === 1;
}

function middlesOf(cuts: readonly number[]): number[] {
  return cuts.slice(1).map((cut, i) => (cut + (cuts[i] as number)) / 2);
}

function cutsOf(values: readonly number[]): number[] {
  return [...new Set(values)].sort((a, b) => a - b);
}

/** The outline of the floor where `isFloor` holds; null where it is in pieces, has holes, or is none. */
function outlineOf(xs: readonly number[], zs: readonly number[], isFloor: (at: Point) => boolean): Corners | null {
  const [columns, rows] = [middlesOf(xs), middlesOf(zs)];
  const floor = (column: number, row: number): boolean => {
    const [x, z] = [columns[column], rows[row]];
    return x !== undefined && z !== undefined && isFloor({ x, z });
  };
  const steps = new Map<string, Point[]>();
  const step = (x0: number, z0: number, x1: number, z1: number): void => {
    const key = `${xs[x0]} ${zs[z0]}`;
    steps.set(key, [...(steps.get(key) ?? []), { x: xs[x1] as number, z: zs[z1] as number }]);
  };
  for (const column of columns.keys()) {
    for (const row of rows.keys()) {
      if (!floor(column, row)) continue;
      if (!floor(column, row - 1)) step(column, row, column + 1, row);
      if (!floor(column + 1, row)) step(column + 1, row, column + 1, row + 1);
      if (!floor(column, row + 1)) step(column + 1, row + 1, column, row + 1);
      if (!floor(column - 1, row)) step(column, row + 1, column, row);
    }
  }
  return chained(steps);
}

/** One closed way of all steps; null where they make several, or meet in a point. */
function chained(steps: ReadonlyMap<string, readonly Point[]>): Corners | null {
  const [begin] = steps.keys();
  if (begin === undefined || [...steps.values()].some((ends) => ends.length > 1)) return null;
  const way: Point[] = [];
  for (let key = begin; way.length < steps.size;) {
    const next = steps.get(key)?.[0];
    if (!next) return null;
    way.push(next);
    key = `${next.x} ${next.z}`;
    if (key === begin) break;
  }
  return way.length === steps.size ? tidied(way) : null;
}

/** A room with a rectangle added to it or taken from it; null where that leaves no single floor without holes. */
export function combined(corners: Corners, box: Box, how: "add" | "cut"): Corners | null {
  const other = cornersOfBox(box);
  const all = [...corners, ...other];
  const inBox = ({ x, z }: Point): boolean => box.x0 < x && x < box.x1 && box.z0 < z && z < box.z1;
  const isFloor = (at: Point): boolean => (how === "add" ? holds(corners, at) || inBox(at) : holds(corners, at) && !inBox(at));
  return outlineOf(cutsOf(all.map(({ x }) => x)), cutsOf(all.map(({ z }) => z)), isFloor);
}

/** Whether two rooms are one and the same floor. */
export function areSame(a: Corners, b: Corners | null): boolean {
  return a.length === b?.length && a.every(({ x, z }, i) => b[i]?.x === x && b[i]?.z === z);
}

/** Whether two rooms share floor. */
export function areOverlapping(a: Corners, b: Corners): boolean {
  const all = [...a, ...b];
  const rows = middlesOf(cutsOf(all.map(({ z }) => z)));
  return middlesOf(cutsOf(all.map(({ x }) => x))).some((x) => rows.some((z) => holds(a, { x, z }) && holds(b, { x, z })));
}

/** The room with one wall moved to another line; null where no room is left. */
export function withWallAt(corners: Corners, index: number, line: number): Corners | null {
  const wall = wallsOf(corners)[index];
  if (!wall) return null;
  const next = (index + 1) % corners.length;
  const moved = corners.map((corner, i) => (i !== index && i !== next ? corner : wall.axis === "x" ? { ...corner, z: line } : { ...corner, x: line }));
  if (doubleArea(moved) <= 0) return null;
  const clean = tidied(moved);
  return isSound(clean) ? clean : null;
}
