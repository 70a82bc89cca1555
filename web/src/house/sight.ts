/** Whether walls hide one point from another. Pure. */
import type { PlacedOpening } from "./openings";
import type { Run } from "./wall_runs";
import type { Point } from "./wall_faces";
import type { Storey } from "./walls";

/** What stands between points. */
export interface Walled {
  readonly runs: readonly Run[];
  readonly openings: readonly PlacedOpening[];
  readonly storeys: ReadonlyMap<number, Storey>;
  /** Whether a door's leaf is out of the way. */
  isOpen(id: string): boolean;
}

/** Where a line crosses a wall's line: along it and above its floor [m]; null where it does not cross the wall. */
function crossing(from: Point, to: Point, { axis, line, from: start, to: end }: Run, floor: Storey): { along: number; up: number } | null {
  const [across, along] = axis === "x" ? ([2, 0] as const) : ([0, 2] as const);
  const share = (line - from[across]) / (to[across] - from[across]);
  if (!(share > 0 && share < 1)) return null;
  const at = from[along] + (to[along] - from[along]) * share;
  const up = from[1] + (to[1] - from[1]) * share - floor.elevation;
  return at >= start && at <= end && up >= 0 && up <= floor.height ? { along: at, up } : null;
}

/** Whether no wall is between two points; passages, windows and open doors are no wall. */
export function isInSight(from: Point, to: Point, { runs, openings, storeys, isOpen }: Walled): boolean {
  return runs.every((run) => {
    const met = run.kind === "wall" ? crossing(from, to, run, storeys.get(run.level) ?? { elevation: 0, height: Infinity }) : null;
    return !met || openings.some((one) => one.level === run.level && one.axis === run.axis && one.line === run.line
      && one.from <= met.along && met.along <= one.to && one.sill <= met.up && met.up <= one.head
      && (one.kind === "passage" || one.kind === "window" || isOpen(one.id)));
  });
}
