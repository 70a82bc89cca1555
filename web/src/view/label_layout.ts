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
/** Tried where it must be shown, along and up: in label widths and heights. */
const FURTHER = [...[-2.5, 3, -3, 3.5, -3.5, 4, -4].map((up) => [0, up] as const), ...[0, -1, 1, -2, 2, -3, 3, -4, 4].flatMap((up) => [[0.75, up], [-0.75, up]] as const)];

function covers(a: Kept, b: Kept): boolean {
  return Math.abs(a.x - b.x) < (a.width + b.width) / 2 + GAP && Math.abs(a.y - b.y) < (a.height + b.height) / 2 + GAP;
}


/** How wide and high the canvas is [CSS pixels]; null: it has no end. */
type Canvas = { readonly width: number; readonly height: number } | null;

/** Where a label is on the canvas as a whole. */
export function keptInside({ x, y, width, height }: Kept, canvas: Canvas): LabelPlace {
  if (!canvas) return { x, y };
  const within = (at: number, size: number, room: number): number => Math.max(size / 2 + GAP, Math.min(room - size / 2 - GAP, at));
  return { x: within(x, width, canvas.width), y: within(y, height, canvas.height) };
}

/** Places for the wishes, in their order, on the canvas; null where every nudge would cover another label or what is kept clear. */
export function layOut(wishes: readonly LabelWish[], kept: readonly Kept[] = [], canvas: Canvas = null): (LabelPlace | null)[] {
  const order = [...wishes.keys()].sort((a, b) => (wishes[b]?.importance ?? 0) - (wishes[a]?.importance ?? 0));
  const taken: Kept[] = [...kept];
  const places: (LabelPlace | null)[] = wishes.map(() => null);
  for (const i of order) {
    const wish = wishes[i];
    if (!wish) continue;
    const nudges = [...NUDGES.map((up) => [0, up] as const), ...(wish.stays ? FURTHER : [])];
    const tried = nudges.map(([along, up]) => keptInside({ ...wish, x: wish.x + along * wish.width, y: wish.y + up * (wish.height + GAP) }, canvas));
    const place = tried.find((one) => !taken.some((other) => covers({ ...wish, ...one }, other)));
    if (!place) continue;
    taken.push({ ...wish, ...place });
    places[i] = place;
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

/** Where along its line a label is tried, in shares of it from its wished place, and how far beside, above and beneath it, in label heights. */
const [ALONG, BESIDE] = [[0, -0.15, 0.15, -0.3, 0.3], [1, 2, 3, 4, 5]];

/** Where a label of a line goes: on it, as near its wished place as nothing lies over it; beside, above or beneath that place where all of the line is covered. */
export function onLine(
  [from, to]: readonly [LabelPlace, LabelPlace], at: number, extent: Pick<Kept, "width" | "height">, kept: readonly Kept[], canvas: Canvas = null,
): LabelPlace {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const long = Math.hypot(dx, dy) || 1;
  const on = (share: number): LabelPlace => ({ x: from.x + dx * share, y: from.y + dy * share });
  const middle = on(at);
  const aways = BESIDE.flatMap((step) => [step * extent.height, -step * extent.height]);
  const beside = aways.map((away): LabelPlace => ({ x: middle.x - (dy / long) * away, y: middle.y + (dx / long) * away }));
  const above = aways.map((away): LabelPlace => ({ x: middle.x, y: middle.y + away }));
  const places = [...ALONG.map((share) => at + share).filter((share) => share >= 0 && share <= 1).map(on), ...beside, ...above];
  const inside = [...places, middle].map((place) => keptInside({ ...place, ...extent }, canvas));
  return inside.find((place) => !kept.some((other) => covers({ ...place, ...extent }, other))) ?? (inside.at(-1) as LabelPlace);
}
