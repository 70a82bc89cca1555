/**
 * How one JSON document becomes another, exact to the byte of its text: values, and the order of keys. What stays is named, not repeated,
 * so that an edit of a house is some hundred bytes. Documents are those that JSON.parse makes.
 */

type Fields = Readonly<Record<string, unknown>>;
/** Elements of the array before, as they were or changed; or new ones. */
export type Run = { readonly from: number; readonly count: number } | { readonly at: number; readonly to: Change } | { readonly new: readonly unknown[] };
/** Another value; or an object whose keys change, some of them gone; or an array of which elements stay. */
export type Change =
  | { readonly is: unknown }
  | { readonly keys: Readonly<Record<string, Change>>; readonly without: readonly string[] }
  | { readonly runs: readonly Run[] };

function isObject(value: unknown): value is Fields {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

/** What makes the one of the other; null where both are the same. */
export function changeBetween(before: unknown, after: unknown): Change | null {
  if (before === after) return null;
  if (Array.isArray(before) && Array.isArray(after)) return changeOfArrays(before, after);
  if (isObject(before) && isObject(after)) return changeOfObjects(before, after);
  return { is: after };
}

function changeOfObjects(before: Fields, after: Fields): Change | null {
  const [was, is] = [Object.keys(before), Object.keys(after)];
  const [old, now] = [new Set(was), new Set(is)];
  const order = [...was.filter((key) => now.has(key)), ...is.filter((key) => !old.has(key))];
  if (order.some((key, i) => key !== is[i])) return { is: after };
  const without = was.filter((key) => !now.has(key));
  const keys = is.flatMap((key): [string, Change][] => {
    const change = old.has(key) ? changeBetween(before[key], after[key]) : { is: after[key] };
    return change ? [[key, change]] : [];
  });
  return keys.length + without.length > 0 ? { keys: Object.fromEntries(keys), without } : null;
}

/** What an element is known by: its id, where it has one. */
function idOf(element: unknown): string | undefined {
  return isObject(element) && typeof element.id === "string" ? element.id : undefined;
}

/** Where each element with an id stands; null where two share one, or one has none. */
function placesOf(elements: readonly unknown[]): ReadonlyMap<string | undefined, number> | null {
  const places = new Map(elements.map((element, i) => [idOf(element), i]));
  return places.size === elements.length && !places.has(undefined) ? places : null;
}

function changeOfArrays(before: readonly unknown[], after: readonly unknown[]): Change | null {
  const places = placesOf(before);
  const runs: Run[] = [];
  after.forEach((element, i) => {
    const id = idOf(element);
    const from = places && id !== undefined ? places.get(id) : i;
    if (from === undefined || from >= before.length) append(runs, { new: [element] });
    else {
      const change = changeBetween(before[from], element);
      append(runs, change ? { at: from, to: change } : { from, count: 1 });
    }
  });
  const [only, ...more] = runs;
  const same = more.length === 0 && (only ? "count" in only && only.from === 0 && only.count === before.length : before.length === 0);
  return same ? null : { runs };
}

/** Adds a run to the others: to the last one, where it goes on from it. */
function append(runs: Run[], run: Run): void {
  const last = runs.at(-1);
  if (last && "new" in last && "new" in run) runs[runs.length - 1] = { new: [...last.new, ...run.new] };
  else if (last && "count" in last && "count" in run && last.from + last.count === run.from) {
    runs[runs.length - 1] = { from: last.from, count: last.count + run.count };
  } else runs.push(run);
}

/**
 * The document that a change makes of another; what stays is shared with that.
 * Throws a TypeError or RangeError where the change speaks of what the document does not have.
 */
export function changed(before: unknown, change: Change): unknown {
  if ("is" in change) return change.is;
  if ("runs" in change) return changedArray(before, change.runs);
  if (!isObject(before)) throw new TypeError("keys of what is no object");
  const gone = new Set(change.without);
  const { keys } = change;
  const stay = Object.entries(before).filter(([key]) => !gone.has(key));
  const own = (key: string): Change | undefined => (Object.hasOwn(keys, key) ? keys[key] : undefined);
  const kept = stay.map(([key, value]): [string, unknown] => { const to = own(key); return [key, to ? changed(value, to) : value]; });
  const fresh = Object.entries(keys).filter(([key]) => !Object.hasOwn(before, key)).map(([key, to]): [string, unknown] => [key, changed(undefined, to)]);
  return Object.fromEntries([...kept, ...fresh]);
}

function changedArray(before: unknown, runs: readonly Run[]): unknown[] {
  if (!Array.isArray(before)) throw new TypeError("elements of what is no array");
  const elements: readonly unknown[] = before;
  return runs.flatMap((run) => {
    if ("new" in run) return run.new;
    const [from, count] = "count" in run ? [run.from, run.count] : [run.at, 1];
    if (!(from >= 0 && from + count <= elements.length)) throw new RangeError("elements that are not there");
    return "count" in run ? elements.slice(from, from + count) : [changed(elements[from], run.to)];
  });
}

/** A document like another, which shares with an earlier one whatever is the same: so that many of them cost little memory. */
export function sharing<Document>(before: Document, after: Document): Document {
  const change = changeBetween(before, after);
  return change ? (changed(before, change) as Document) : before;
}
