/** What opens of a piece: its doors, flaps, lids and drawers. Pure; the catalog's data say which, docs/catalog.md how. */
import type { CatalogPart } from "../contract";
import type { PlacedBody } from "./frame";
import type { Part } from "./parts";

export type FrontAxis = "x" | "y" | "z";

/** A front in its body's frame: a point of its axis [m]; open it is at `end`: [rad] about the axis, from y to z and z to x, or [m] along it. */
export interface Front {
  readonly name: string;
  readonly slides: boolean;
  readonly axis: FrontAxis;
  readonly hinge: readonly [number, number, number];
  readonly end: number;
}

/** How a part is moved against its body: so far about or along the axis of its front. */
export interface Swing {
  readonly front: Front;
  readonly amount: number;
}

type Vector = readonly [number, number, number];

const TOWARDS = { left: ["y", -1], right: ["y", 1], up: ["x", -1], down: ["x", 1], lid: ["x", -1], drawer: ["z", 1] } as const;

/** The fronts of a kind's shape, at a body's size. */
export function frontsOf(solids: readonly CatalogPart[], { width, height, depth }: PlacedBody): Front[] {
  return solids.flatMap(({ front, opens, range, x, y, z }): Front[] => {
    if (!front || !opens) return [];
    const [axis, side] = TOWARDS[opens];
    const across = opens === "left" ? x[0] : opens === "right" ? x[1] : (x[0] + x[1]) / 2;
    const up = opens === "left" || opens === "right" || opens === "down" ? y[0] : y[1];
    const slides = opens === "drawer";
    return [{
      name: front, slides, axis,
      hinge: [(across - 0.5) * width, up * height, ((opens === "lid" ? z[0] : z[1]) - 0.5) * depth],
      end: side * (range ?? 0) * (slides ? depth : Math.PI / 180),
    }];
  });
}

/** A direction of the body, moved with a front. */
export function turnedWith([x, y, z]: Vector, { front, amount }: Swing): Vector {
  if (front.slides) return [x, y, z];
  const [cos, sin] = [Math.cos(amount), Math.sin(amount)];
  return front.axis === "y" ? [x * cos + z * sin, y, z * cos - x * sin] : [x, y * cos - z * sin, y * sin + z * cos];
}

/** A point of the body, moved with a front. */
export function movedWith(point: Vector, swing: Swing): Vector {
  const { front: { slides, hinge }, amount } = swing;
  if (slides) return [point[0], point[1], point[2] + amount];
  const [x, y, z] = turnedWith([point[0] - hinge[0], point[1] - hinge[1], point[2] - hinge[2]], swing);
  return [x + hinge[0], y + hinge[1], z + hinge[2]];
}

/** The swing that takes a front back. */
export function backwards({ front, amount }: Swing): Swing {
  return { front, amount: -amount };
}

/** A point of the house in a body's own frame. */
export function inFrameOf({ x, y, z, turn }: PlacedBody, at: Vector): Vector {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const [dx, dz] = [at[0] - x, at[2] - z];
  return [dx * cos - dz * sin, at[1] - y, dx * sin + dz * cos];
}

/** Whether a body lies within the room that the parts of a drawer take up. */
export function liesIn(body: PlacedBody, piece: PlacedBody, parts: readonly Part[]): boolean {
  const at = inFrameOf(piece, [body.x, body.y + body.height / 2, body.z]);
  return parts.length > 0 && [0, 1, 2].every((k) => {
    const ends = parts.map((part) => [part.at[k as 0] - part.size[k as 0] / 2, part.at[k as 0] + part.size[k as 0] / 2] as const);
    return Math.min(...ends.map(([low]) => low)) < (at[k] as number) && (at[k] as number) < Math.max(...ends.map(([, high]) => high));
  });
}
