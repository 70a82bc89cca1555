/** Where labels go so that none covers another: the important first, the others nudged up or down. Pure. */

export interface LabelWish {
  /** Where the label's centre would best be [CSS pixels]. */
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
  /** The more important is placed first. */
  readonly importance: number;
  /** It is shown in any case: it goes further, where it must. */
  readonly stays?: boolean;
}

export interface LabelPlace {
  readonly x: number;
  readonly y: number;
}

/** What labels keep clear of: a rectangle around its centre [CSS pixels]. */
export type Kept = Omit<LabelWish, "importance" | "stays">;

/** How large what corners in turn enclose is. */
export function areaWithin(corners: readonly LabelPlace[]): number {
  const twice = corners.reduce((sum, { x, y }, i) => {
    const next = corners[(i + 1) % corners.length] as LabelPlace;
    return sum + x * next.y - next.x * y;
  }, 0);
  return Math.abs(twice) / 2;
}

const GAP = 3;
/** Tried in turn, in label heights. */
const NUDGES = [0, -0.5, 0.5, -1, 1, -1.5, 1.5, -2, 2, 2.5];
const FURTHER = [-2.5, 3, -3, 3.5, -3.5, 4, -4];

function covers(a: LabelWish, y: number, b: Kept): boolean {
  return Math.abs(a.x - b.x) < (a.width + b.width) / 2 + GAP && Math.abs(y - b.y) < (a.height + b.height) / 2 + GAP;
}

/** Where a label whose middle is on the canvas is on it as a whole. */
export function keptInside({ x, y, width, height }: Kept, canvas: { readonly width: number; readonly height: number }): LabelPlace {
  const within = (at: number, size: number, room: number): number => Math.max(size / 2 + GAP, Math.min(room - size / 2 - GAP, at));
  return { x: within(x, width, canvas.width), y: within(y, height, canvas.height) };
}

/** Places for the wishes, in their order; null where every nudge would cover another label or what is kept clear. */
export function layOut(wishes: readonly LabelWish[], kept: readonly Kept[] = []): (LabelPlace | null)[] {
  const order = [...wishes.keys()].sort((a, b) => (wishes[b]?.importance ?? 0) - (wishes[a]?.importance ?? 0));
  const taken: Kept[] = [...kept];
  const places: (LabelPlace | null)[] = wishes.map(() => null);
  for (const i of order) {
    const wish = wishes[i];
    if (!wish) continue;
    const ys = [...NUDGES, ...(wish.stays ? FURTHER : [])].map((nudge) => wish.y + nudge * (wish.height + GAP));
    const y = ys.find((tried) => !taken.some((other) => covers(wish, tried, other)));
    if (y === undefined) continue;
    taken.push({ ...wish, y });
    places[i] = { x: wish.x, y };
  }
  return places;
}

/** Of the places where a label may be, nearest first, the one at which it covers least of what lies there; `before`, where that is one of the best. */
export function clearest<Place extends LabelPlace>(
  { width, height }: Pick<Kept, "width" | "height">, places: readonly Place[], covered: readonly Kept[], before?: Place,
): Place | undefined {
  const near = (place: Place, other: Kept): boolean =>
    Math.abs(place.x - other.x) < (width + other.width) / 2 && Math.abs(place.y - other.y) < (height + other.height) / 2;
  const counted = (place: Place): number => covered.filter((other) => near(place, other)).length;
  const counts = new Map(places.map((place) => [place, counted(place)]));
  const least = Math.min(...counts.values());
  return before && counts.get(before) === least ? before : places.find((place) => counts.get(place) === least);
}

/** Where along its line a label is tried, in shares of it from its wished place, and how far beside it, in label heights. */
const [ALONG, BESIDE] = [[0, -0.15, 0.15, -0.3, 0.3], [1, 2, 3, 4, 5]];

/** Where a label of a line goes: on it, as near its wished place as nothing lies over it; beside that place where all of the line is covered. */
export function onLine(
  [from, to]: readonly [LabelPlace, LabelPlace], at: number, extent: Pick<Kept, "width" | "height">, kept: readonly Kept[],
): LabelPlace {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const long = Math.hypot(dx, dy) || 1;
  const on = (share: number): LabelPlace => ({ x: from.x + dx * share, y: from.y + dy * share });
  const middle = on(at);
  const beside = BESIDE.flatMap((step) => [1, -1].map((side): LabelPlace => {
    const away = (side * step * extent.height) / long;
    return { x: middle.x - dy * away, y: middle.y + dx * away };
  }));
  const places = [...ALONG.map((share) => at + share).filter((share) => share >= 0 && share <= 1).map(on), ...beside];
  return places.find((place) => !kept.some((other) => covers({ ...place, ...extent, importance: 0 }, place.y, other))) ?? middle;
}
