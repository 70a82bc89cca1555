/** Bodies on their way: every one goes from where it is seen to where it belongs, and never jumps. */
import type { PlacedBody } from "../house/frame";

export interface Spot {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly turn: number;
}

interface Way {
  readonly from: Spot;
  readonly to: Spot;
}

export type Put = (id: string, spot: Spot) => void;

const SLIDE_SECONDS = 0.12;
const HALF_TURN = Math.PI;

/** The turn between two angles that is the shorter way round [rad]. */
export function shortestTurn(from: number, to: number): number {
  const turn = (to - from) % (2 * HALF_TURN);
  return turn > HALF_TURN ? turn - 2 * HALF_TURN : turn < -HALF_TURN ? turn + 2 * HALF_TURN : turn;
}

export function spotOf({ x, y, z, turn }: Spot): Spot {
  return { x, y, z, turn };
}

function isSame(a: Spot, b: Spot): boolean {
  return a.x === b.x && a.y === b.y && a.z === b.z && a.turn === b.turn;
}

function between({ from, to }: Way, share: number): Spot {
  if (share >= 1) return to;
  const part = (a: number, b: number): number => a + (b - a) * share;
  return {
    x: part(from.x, to.x), y: part(from.y, to.y), z: part(from.z, to.z),
    turn: from.turn + shortestTurn(from.turn, to.turn) * share,
  };
}

export class Slide {
  #ways = new Map<string, Way>();
  #gone = 0;

  constructor(readonly put: Put, readonly seconds = SLIDE_SECONDS) {}

  /** Sends bodies to where the others belong; whoever is there already stays. Tells whether any goes. */
  to(seen: readonly PlacedBody[], belongs: readonly PlacedBody[]): boolean {
    const goals = new Map(belongs.map((body) => [body.id, spotOf(body)]));
    this.#ways = new Map();
    for (const body of seen) {
      const goal = goals.get(body.id);
      if (goal && !isSame(body, goal)) this.#ways.set(body.id, { from: spotOf(body), to: goal });
    }
    this.#gone = 0;
    return this.#ways.size > 0;
  }

  /** Goes on by a time; false when all have arrived. */
  step(seconds: number): boolean {
    this.#gone = this.seconds > 0 ? Math.min(1, this.#gone + seconds / this.seconds) : 1;
    const eased = 1 - (1 - this.#gone) ** 2;
    for (const [id, way] of this.#ways) this.put(id, between(way, this.#gone >= 1 ? 1 : eased));
    if (this.#gone >= 1) this.#ways.clear();
    return this.#ways.size > 0;
  }
}
