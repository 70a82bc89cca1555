/**
 * Wall lines of a house: from rooms' edges the runs to draw, each once.
 *
 * A room's wall may be shared piece by piece with several rooms, so the walls are the union of all rooms' edges
 * on a line; `wall_flags` only takes away what no room on either side wants drawn.
 */
import type { Room } from "../contract";
import type { Axis } from "./boxes";
import { lineKey, type Edge } from "./plan";
import { bridge, thick, WallBands, type BandedEdge } from "./wall_bands";

export type RunKind = "wall" | "railing";

/** A stretch of wall of one kind and thickness on one line; `shift` is how far that lies from the lines of its rooms [m]. */
export interface Run {
  readonly level: number;
  readonly axis: Axis;
  readonly line: number;
  readonly from: number;
  readonly to: number;
  readonly kind: RunKind;
  readonly thickness: number;
  readonly shift: number;
}

/** What stands between two neighbouring cuts of a line, given the edges that cover that stretch. */
function kindOf(covering: readonly Edge[]): RunKind | null {
  if (!covering.some((edge) => edge.room.wall_flags[edge.side] !== false)) return null;
  return covering.every((edge) => edge.room.outdoor) ? "railing" : "wall";
}

function runsOnLine(edges: readonly BandedEdge[], usual: number, bridges: ReadonlySet<string>): Run[] {
  const cuts = [...new Set(edges.flatMap((edge) => [edge.from, edge.to]))].sort((a, b) => a - b);
  const runs: Run[] = [];
  for (const [i, from] of cuts.entries()) {
    const to = cuts[i + 1];
    if (to === undefined) break;
    const covering = edges.filter((edge) => edge.from <= from && to <= edge.to);
    const [first] = covering;
    const kind = first ? kindOf(covering) : null;
    if (!first || !kind) continue;
    const { level, axis, line, thickness } = first;
    const last = runs.at(-1);
    const goesOn = last?.kind === kind && (last.to === from || bridges.has(bridge(first, last.to, from)));
    if (goesOn) runs[runs.length - 1] = { ...last, to };
    else runs.push({ level, axis, line, from, to, kind, thickness: thick(thickness), shift: Math.abs(thickness - usual) / 2 });
  }
  return runs;
}

/** All stretches of wall and railing of a house, each once, longest possible; `thickness` is the scene's [m]. */
export function runsOf(rooms: readonly Room[], thickness: number): Run[] {
  const bands = new WallBands(rooms, thickness);
  const lines = new Map<string, BandedEdge[]>();
  for (const edge of bands.edges.flatMap((one) => bands.pieces(one))) {
    const key = `${lineKey(edge)}:${edge.thickness}`;
    const group = lines.get(key);
    if (group) group.push(edge);
    else lines.set(key, [edge]);
  }
  const bridges = bands.bridges();
  return [...lines.values()].flatMap((edges) => runsOnLine(edges, thickness, bridges));
}
