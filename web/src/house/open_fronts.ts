/** Which fronts of a house's furniture are open, how far, and what moves with them. */
import type { Scene } from "../contract";
import { liesIn, movedWith, type Front, type Swing } from "./fronts";
import type { PlacedBody } from "./frame";
import type { Part } from "./parts";

type Certificate = Scene["certificate"];

const SECONDS = 0.5;

/** Slow at both ends. */
function eased(share: number): number {
  return share * share * (3 - 2 * share);
}

interface Moving {
  readonly front: Front;
  /** How far it can be opened, 0 to 1: until it meets something. */
  readonly most: number;
  wanted: 0 | 1;
  now: number;
}

/** How far a front opens by a scene's certificate; all its way where that does not say. */
function mostOf(said: Certificate, piece: string, front: string): number {
  const rooms = Object.values(said?.rooms ?? {});
  const found = rooms.map((room) => room.fronts?.[piece]?.[front]).find((one) => one !== undefined);
  return typeof found === "object" && typeof found.opens === "number" ? Math.min(1, Math.max(0, found.opens)) : 1;
}

/** The fronts of a house; `step` moves those under way. */
export class OpenFronts {
  readonly #fronts: ReadonlyMap<number, readonly Moving[]>;
  /** Bodies whose fronts are moved against where they are drawn when shut. */
  readonly #ajar = new Set<number>();

  constructor(said: Certificate, bodies: readonly PlacedBody[], frontsOf: (body: PlacedBody) => readonly Front[]) {
    this.#fronts = new Map(bodies.flatMap((body, number) => {
      const found = body.kind === "furniture" ? frontsOf(body) : [];
      const moving = found.map((front): Moving => ({ front, most: mostOf(said, body.id, front.name), wanted: 0, now: 0 }));
      return moving.length > 0 ? [[number, moving] as const] : [];
    }));
  }

  /** Opens one front of a body, or shuts it. */
  toggle(number: number, name: string): void {
    for (const one of this.#fronts.get(number) ?? []) if (one.front.name === name) one.wanted = one.wanted === 1 ? 0 : 1;
  }

  /** Opens all fronts of some bodies; where any is open, shuts them. */
  toggleAll(numbers: Iterable<number> = this.#fronts.keys()): void {
    const all = [...numbers].flatMap((number) => this.#fronts.get(number) ?? []);
    const wanted = all.some((one) => one.wanted === 1) ? 0 : 1;
    for (const one of all) one.wanted = wanted;
  }

  has(number: number): boolean {
    return this.#fronts.has(number);
  }

  /** The fronts that are open or opening, by body. */
  get open(): (readonly [number, string])[] {
    return [...this.#fronts].flatMap(([number, fronts]) =>
      fronts.filter((one) => one.wanted === 1).map((one) => [number, one.front.name] as const));
  }

  /** How a front's parts are moved now; undefined where it is shut. */
  swingOf(number: number, name: string | undefined): Swing | undefined {
    if (name === undefined || !this.#ajar.has(number)) return undefined;
    const found = this.#fronts.get(number)?.find((one) => one.front.name === name);
    return found && found.now > 0 ? { front: found.front, amount: found.front.end * eased(found.now) * found.most } : undefined;
  }

  /** Moves fronts by `seconds`; returns the numbers of the bodies that moved. */
  step(seconds: number): number[] {
    const moved: number[] = [];
    for (const [number, fronts] of this.#fronts) {
      let moving = false;
      for (const one of fronts) {
        if (one.now === one.wanted) continue;
        one.now += Math.sign(one.wanted - one.now) * Math.min(Math.abs(one.wanted - one.now), seconds / SECONDS);
        moving = true;
      }
      if (!moving) continue;
      moved.push(number);
      if (fronts.some((one) => one.now > 0)) this.#ajar.add(number);
      else this.#ajar.delete(number);
    }
    return moved;
  }

  /** Where a small thing is drawn that lies in a drawer of a piece; itself where it lies in none that is open. */
  carried(thing: PlacedBody, number: number, piece: PlacedBody, parts: readonly Part[]): PlacedBody {
    for (const { front } of this.#fronts.get(number) ?? []) {
      const swing = front.slides ? this.swingOf(number, front.name) : undefined;
      if (!swing || !liesIn(thing, piece, parts.filter((part) => part.front === front.name))) continue;
      const [x, y, z] = movedWith([0, 0, 0], swing);
      const [cos, sin] = [Math.cos(piece.turn), Math.sin(piece.turn)];
      return { ...thing, x: thing.x + x * cos + z * sin, y: thing.y + y, z: thing.z - x * sin + z * cos };
    }
    return thing;
  }
}
