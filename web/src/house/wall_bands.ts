/**
 * Where the walls along rooms' edges stand. A room's face lies half the scene's thickness inside its line: two rooms whose lines
 * lie apart have a wall that is thicker by as much, and an outer wall has its own thickness where its room says one. Pure.
 */
import type { Room } from "../contract";
import type { Axis } from "./boxes";
import { edgesOf, type Edge } from "./plan";

/** How far apart the lines of two rooms may be that have a wall in common [m]. */
const THICKEST = 0.6;
export const NEGLIGIBLE = 1e-6;
/** Scenes that say no thickness have walls of none; a line must still be seen. */
const THINNEST = 0.02;

/** A piece of an edge on its wall's middle line, and how thick that wall is [m]. */
export interface BandedEdge extends Edge {
  readonly thickness: number;
}

/** From, to, and how far the line of the room on the other side is away; null where there is none [m]. */
type Stretch = readonly [number, number, number | null];
type Faced = readonly [gap: number, from: number, to: number];

/** How thick a wall is drawn [m]. */
export function thick(thickness: number): number {
  return Math.max(thickness, THINNEST);
}

function rounded(metres: number): number {
  return Math.round(metres * 1e6) / 1e6;
}

function overlap(a: Edge, b: Edge): number {
  return Math.min(a.to, b.to) - Math.max(a.from, b.from);
}

/** The stretches of an edge that have the same room on the other side; the nearest room counts. */
function stretchesOf(edge: Edge, near: readonly Faced[]): Stretch[] {
  const ends = near.flatMap(([, low, high]) => [low, high]).map((end) => Math.min(Math.max(end, edge.from), edge.to));
  const cuts = [...new Set([edge.from, edge.to, ...ends])].sort((a, b) => a - b);
  const found: Stretch[] = [];
  cuts.slice(1).forEach((to, i) => {
    const from = cuts[i] ?? to;
    const facing = near.find(([, low, high]) => low <= from && to <= high);
    const gap = facing ? Math.max(facing[0], 0) : null;
    const last = found.at(-1);
    if (last?.[2] === gap) found[found.length - 1] = [last[0], to, gap];
    else found.push([from, to, gap]);
  });
  return found.length > 0 ? found : [[edge.from, edge.to, null]];
}

/** Fills what lies between two rooms, where the wall that parts them ends, as thick as the thinner on either side. */
function filled(stretches: readonly Stretch[]): Stretch[] {
  return stretches.map(([from, to, gap], i) => {
    const [before, after] = [stretches[i - 1]?.[2] ?? null, stretches[i + 1]?.[2] ?? null];
    if (gap !== null || before === null || after === null || to - from > THICKEST + NEGLIGIBLE) return [from, to, gap];
    return [from, to, Math.min(before, after)];
  });
}

/** The walls along the edges of rooms; `thickness` is the scene's [m]. */
export class WallBands {
  readonly edges: readonly Edge[];
  readonly #facing = new Map<string, Edge[]>();

  constructor(rooms: readonly Room[], readonly thickness: number) {
    this.edges = rooms.flatMap(edgesOf);
    for (const edge of this.edges) {
      const key = `${edge.level}:${edge.axis}:${edge.inward}`;
      const group = this.#facing.get(key);
      if (group) group.push(edge);
      else this.#facing.set(key, [edge]);
    }
  }

  #across(edge: Edge): readonly Edge[] {
    return this.#facing.get(`${edge.level}:${edge.axis}:${-edge.inward}`) ?? [];
  }

  /** An edge cut where its wall changes, each piece on its wall's middle line. */
  pieces(edge: Edge): BandedEdge[] {
    const near = this.#across(edge)
      .filter((other) => other.room !== edge.room && overlap(edge, other) > NEGLIGIBLE)
      .map((other): Faced => [(edge.line - other.line) * edge.inward, other.from, other.to])
      .filter(([gap]) => -NEGLIGIBLE <= gap && gap <= THICKEST + NEGLIGIBLE)
      .sort((a, b) => a[0] - b[0] || a[1] - b[1] || a[2] - b[2]);
    const own = edge.room.wall_thickness?.[edge.number] ?? this.thickness;
    if (own === this.thickness && !near.some(([gap]) => gap > NEGLIGIBLE)) return [{ ...edge, thickness: this.thickness }];
    return filled(stretchesOf(edge, near)).map(([from, to, gap]) => {
      const thickness = gap === null ? own : rounded(this.thickness + gap);
      const line = thickness === this.thickness ? edge.line : rounded(edge.line - (edge.inward * (thickness - this.thickness)) / 2);
      return { ...edge, from, to, line, thickness };
    });
  }

  /** The piece of an edge at a coordinate along it. */
  at(edge: Edge, along: number): BandedEdge {
    const pieces = this.pieces(edge);
    return pieces.find(({ to }) => along <= to) ?? (pieces.at(-1) as BandedEdge);
  }

  /** What the walls between rooms take of the lines that end at them. */
  bridges(): Set<string> {
    return new Set(this.edges.filter(({ inward }) => inward === -1).flatMap((edge) => this.#across(edge)
      .filter((other) => other.line - edge.line > NEGLIGIBLE && other.line - edge.line <= THICKEST + NEGLIGIBLE && overlap(edge, other) > NEGLIGIBLE)
      .map((other) => bridge({ level: edge.level, axis: edge.axis === "x" ? "z" : "x" }, edge.line, other.line))));
  }
}

/** A stretch of the lines along an axis, as `bridges` keeps it. */
export function bridge({ level, axis }: { level: number; axis: Axis }, from: number, to: number): string {
  return `${level}:${axis}:${from}:${to}`;
}
