/** Where one may walk: the service's free floor, doorways that stand open, and the ground around the house. Pure; metres of the plan. */
import type { RoomFloor, Scene } from "../contract";
import type { PlacedOpening } from "../house/openings";
import type { Run } from "../house/wall_runs";
import { withinFrame, type WallPlan } from "../house/walls";
import { OUTSIDE } from "./walk";

/** West, north, east, south edge [m]. */
export type Rectangle = readonly [number, number, number, number];
export type Place = readonly [number, number];

/** Half the side of the square that one is while walking [m]: narrower than the person that the floor is certified for. */
export const HALF_BODY = 0.2;
/** No step is tried that is longer [m]: none goes through a wall. */
const STEP = 0.05;
/** So far a doorway reaches into the floor before it: the floor's edges are the walls' faces, to the millimetre [m]. */
const OVERLAP = 0.02;
/** Rounding of metres must shut no way [m]. */
const NEGLIGIBLE = 1e-6;
/** One walks on the ground floor. */
const GROUND = 0;

/** What is left of a rectangle where others lie over it. */
export function leftOf(whole: Rectangle, covers: readonly Rectangle[]): Rectangle[] {
  return covers.reduce<Rectangle[]>((parts, cover) => parts.flatMap((part) => cut(part, cover)), [whole]);
}

function cut(part: Rectangle, [west, north, east, south]: Rectangle): Rectangle[] {
  const [x0, z0, x1, z1] = part;
  if (west >= x1 || east <= x0 || north >= z1 || south <= z0) return [part];
  const [top, bottom] = [Math.max(z0, north), Math.min(z1, south)];
  const pieces: Rectangle[] = [[x0, z0, x1, north], [x0, south, x1, z1], [x0, top, west, bottom], [east, top, x1, bottom]];
  return pieces.filter((one) => one[2] - one[0] > NEGLIGIBLE && one[3] - one[1] > NEGLIGIBLE);
}

/** The floor of an opening, through its wall and a little beyond both faces. */
function doorway(opening: PlacedOpening): Rectangle {
  const { axis, line, thickness } = opening;
  const reach = thickness / 2 + OVERLAP;
  const { from: start, to: end } = withinFrame(opening);
  return axis === "x" ? [start, line - reach, end, line + reach] : [line - reach, start, line + reach, end];
}

function wallOf({ axis, line, thickness, shift, from, to }: Run): Rectangle {
  const half = thickness / 2;
  const [start, end] = [from - half + shift, to + half - shift];
  return axis === "x" ? [start, line - half, end, line + half] : [line - half, start, line + half, end];
}

export class WalkFloor {
  readonly #rooms: readonly Rectangle[];
  readonly #around: readonly Rectangle[];
  readonly #ways: readonly { readonly opening: PlacedOpening; readonly floor: Rectangle }[];

  /** `isOpen` tells whether a door's leaf stands open now: it is asked at every step. */
  constructor(scene: Scene, floors: readonly RoomFloor[], plan: Pick<WallPlan, "runs" | "openings">, readonly isOpen: (id: string) => boolean) {
    const here = scene.rooms.filter((room) => room.level === GROUND);
    const walls = plan.runs.filter(({ level }) => level === GROUND).map(wallOf);
    this.#rooms = floors.flatMap(({ room: id, free }) => {
      const room = here.find((one) => one.id === id);
      // Where nobody comes in by a door nothing is free: who looks at such a room walks through what stands there.
      const parts = free.length > 0 ? free : room ? [[0, 0, room.width, room.depth] as const] : [];
      const placed = room ? parts.map(([x0, z0, x1, z1]): Rectangle => [room.x + x0, room.z + z0, room.x + x1, room.z + z1]) : [];
      return placed.flatMap((one) => leftOf(one, walls));
    });
    const built = here.map(({ x, z, width, depth }): Rectangle => [x, z, x + width, z + depth]);
    this.#around = leftOf(extent(built), [...built, ...walls]);
    this.#ways = plan.openings.filter(({ kind, level }) => kind !== "window" && level === GROUND)
      .map((opening) => ({ opening, floor: doorway(opening) }));
  }

  /** All that may be walked on as the doors stand now. */
  get rectangles(): readonly Rectangle[] {
    const open = this.#ways.filter(({ opening }) => opening.kind === "passage" || this.isOpen(opening.id));
    return [...this.#rooms, ...this.#around, ...open.map(({ floor }) => floor)];
  }

  /** Whether one may stand at a place. */
  holds([x, z]: Place, floor = this.rectangles): boolean {
    const square: Rectangle = [x - HALF_BODY, z - HALF_BODY, x + HALF_BODY, z + HALF_BODY];
    return leftOf(square, floor).length === 0;
  }

  /** The nearest place at which one may stand; the place itself where there is none. */
  nearest(place: Place): Place {
    const floor = this.rectangles;
    if (this.holds(place, floor)) return place;
    const within = (at: number, low: number, high: number): number => Math.min(high - HALF_BODY, Math.max(low + HALF_BODY, at));
    const places = floor.filter(([x0, z0, x1, z1]) => Math.min(x1 - x0, z1 - z0) >= 2 * HALF_BODY)
      .map(([x0, z0, x1, z1]): Place => [within(place[0], x0, x1), within(place[1], z0, z1)]);
    const far = ([x, z]: Place): number => Math.hypot(x - place[0], z - place[1]);
    return places.reduce((best, one) => (far(one) < far(best) ? one : best), places[0] ?? place);
  }

  /** Where a step ends that was to lead from one place to another: at what is in the way, or along it. */
  step(from: Place, to: Place): Place {
    const reach = Math.hypot(to[0] - from[0], to[1] - from[1]) + HALF_BODY;
    const floor = this.rectangles.filter(([x0, z0, x1, z1]) =>
      x0 < from[0] + reach && x1 > from[0] - reach && z0 < from[1] + reach && z1 > from[1] - reach);
    if (!this.holds(from, floor)) return this.nearest(from); // a door was shut on one, or a piece put there
    const count = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / STEP));
    const [dx, dz] = [(to[0] - from[0]) / count, (to[1] - from[1]) / count];
    let at = from;
    for (let i = 0; i < count; i += 1) {
      const tries: readonly Place[] = [[at[0] + dx, at[1] + dz], [at[0] + dx, at[1]], [at[0], at[1] + dz]];
      const next = tries.find((one) => this.holds(one, floor));
      if (!next) break;
      at = next;
    }
    return at;
  }
}

/** What holds all rectangles, and the ground around them. */
function extent(all: readonly Rectangle[]): Rectangle {
  const edge = (k: 0 | 1 | 2 | 3, most: 1 | -1): number => most * Math.max(...all.map((one) => most * one[k])) + most * OUTSIDE;
  return all.length === 0 ? [-OUTSIDE, -OUTSIDE, OUTSIDE, OUTSIDE] : [edge(0, -1), edge(1, -1), edge(2, 1), edge(3, 1)];
}
