/** Where a pointer is taken to be: on the wall lines of the plan where one is near, else on a grid of five centimetres. */
import { wallsOf, type Box, type Point } from "./corners";
import type { Draft } from "./draft";

/** The grid, and the finer one where snapping is put aside [mm]. */
export const GRID = 50;
export const FINE = 10;

/** The wall lines there are [mm]: `x` of those that run north-south, `z` of those that run east-west. */
export interface Lines {
  readonly x: readonly number[];
  readonly z: readonly number[];
}

/** The wall lines of a plan, of all rooms but some. */
export function linesOf({ rooms }: Draft, except: ReadonlySet<string> = new Set()): Lines {
  const walls = rooms.filter(({ id }) => !except.has(id)).flatMap(({ corners }) => wallsOf(corners));
  return { x: walls.filter(({ axis }) => axis === "z").map(({ line }) => line), z: walls.filter(({ axis }) => axis === "x").map(({ line }) => line) };
}

export function onGrid(value: number, grid: number): number {
  return Math.round(value / grid) * grid;
}

/** The nearest line within reach, else the grid; `isFree` puts the lines aside. */
export function snapped(value: number, lines: readonly number[], reach: number, isFree: boolean): number {
  if (isFree) return onGrid(value, FINE);
  const nearest = lines.reduce<number | null>((best, line) => (best === null || Math.abs(line - value) < Math.abs(best - value) ? line : best), null);
  return nearest !== null && Math.abs(nearest - value) <= reach ? nearest : onGrid(value, GRID);
}

export function snappedPoint(at: Point, lines: Lines, reach: number, isFree: boolean): Point {
  return { x: snapped(at.x, lines.x, reach, isFree), z: snapped(at.z, lines.z, reach, isFree) };
}

/** How far to move a room [mm] so that one of its sides comes to lie on a line; `wanted` is how far it was dragged. */
export function snappedShift(box: Box, wanted: Point, lines: Lines, reach: number, isFree: boolean): Point {
  const along = (low: number, high: number, by: number, known: readonly number[]): number => {
    if (isFree) return onGrid(by, FINE);
    const [best] = [low, high].flatMap((side) => known.map((line) => line - side)).sort((a, b) => Math.abs(a - by) - Math.abs(b - by));
    return best !== undefined && Math.abs(best - by) <= reach ? best : onGrid(low + by, GRID) - low;
  };
  return { x: along(box.x0, box.x1, wanted.x, lines.x), z: along(box.z0, box.z1, wanted.z, lines.z) };
}

