/** Where labels go so that none covers another: the important first, the others nudged up or down. Pure. */

export interface LabelWish {
  /** Where the label's centre would best be [CSS pixels]. */
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  /** The more important is placed first. */
  readonly importance: number;
}

export interface LabelPlace {
  readonly x: number;
  readonly y: number;
}

const GAP = 3;
/** Tried in turn, in label heights. */
const NUDGES = [0, -0.5, 0.5, -1, 1, -1.5, 1.5, -2, 2];

function covers(a: LabelWish, y: number, b: LabelWish, at: LabelPlace): boolean {
  return Math.abs(a.x - at.x) < (a.width + b.width) / 2 + GAP && Math.abs(y - at.y) < (a.height + b.height) / 2 + GAP;
}

/** Places for the wishes, in their order; null where every nudge would cover another label. */
export function layOut(wishes: readonly LabelWish[]): (LabelPlace | null)[] {
  const order = [...wishes.keys()].sort((a, b) => (wishes[b]?.importance ?? 0) - (wishes[a]?.importance ?? 0));
  const taken: { readonly wish: LabelWish; readonly at: LabelPlace }[] = [];
  const places: (LabelPlace | null)[] = wishes.map(() => null);
  for (const i of order) {
    const wish = wishes[i];
    if (!wish) continue;
    const ys = NUDGES.map((nudge) => wish.y + nudge * (wish.height + GAP));
    const y = ys.find((tried) => !taken.some((other) => covers(wish, tried, other.wish, other.at)));
    if (y === undefined) continue;
    const at = { x: wish.x, y };
    taken.push({ wish, at });
    places[i] = at;
  }
  return places;
}
