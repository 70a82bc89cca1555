/** What home a line of plain words asks for: "3 bedrooms, 2 baths, 120 m²", "2 bed 1 bath office 90m2", "studio". Pure. */
import type { Catalog, Counts, HouseRequest } from "../contract";
import { wordsOf } from "./programme";

const AREA = /^(\d+(?:[.,]\d+)?)\s*(m²|m2|sqm|qm|square met(?:re|er)s?|quadratmeter|ft²|ft2|sq\.?\s*ft|sqft|square feet)$/;
const COUNTED = /^(\d+|(?:an?|one|two|three|four|five|eine?|zwei|drei|vier|fünf)\b)\s*[x×]?\s*([^\d].*)$/;
const NUMBERS: Readonly<Record<string, number>> = { a: 1, an: 1, one: 1, two: 2, three: 3, four: 4, five: 5, ein: 1, eine: 1, zwei: 2, drei: 3, vier: 4, fünf: 5 };
/** How people shorten, or say in German, what the catalogs call otherwise. */
const SHORT: Readonly<Record<string, string>> = {
  bed: "bedroom", bd: "bedroom", br: "bedroom", bath: "bathroom", ba: "bathroom", wc: "toilet", loo: "toilet", study: "office", schlafzimmer: "bedroom", bad: "bathroom", bäder: "bathroom", badezimmer: "bathroom",
  küche: "kitchen", wohnzimmer: "living_room", esszimmer: "dining_room", diele: "foyer", waschküche: "laundry", büro: "office", arbeitszimmer: "office", werkstatt: "workshop",
};
/** Germans count the rooms that one lives and sleeps in: of three, two are bedrooms. */
const ZIMMER = /^(\d+|eine?|zwei|drei|vier|fünf)[\s-]*zimmer(?:[\s-]*(?:wohnung|haus))?$/;
const M2_OF_FT2 = 0.09290304;

export type PlainWish = Pick<HouseRequest, "program" | "area">;

/** The wish, or the words that could not be read. */
export type ReadWish = { readonly wish: PlainWish } | { readonly unread: string };

/** A noun without its plural and its spaces, to compare. */
function bare(noun: string): string {
  const one = noun.trim().replace(/[\s-]+/g, "_").replace(/s$/, "");
  return SHORT[one] ?? one;
}

function areaIn(part: string): number | null {
  const [, number, unit] = AREA.exec(part) ?? [];
  if (number === undefined || unit === undefined) return null;
  const area = Number(number.replace(/[.,](?=\d{3}$)/, "").replace(",", "."));
  return /f/.test(unit) ? Math.round(area * M2_OF_FT2 * 10) / 10 : area;
}

/** One thing that is asked for. */
type Asked = { readonly area: number } | { readonly preset: string } | { readonly word: string; readonly count: number };

/** What the words of a part ask for, which need no commas between: from the left the longest that are understood; null where some are not. */
function askedIn(part: string, read: (words: string) => Asked | null): Asked[] | null {
  const words = part.split(/\s+/);
  for (let count = words.length; count > 0; count -= 1) {
    const first = read(words.slice(0, count).join(" "));
    const rest = first && (count === words.length ? [] : askedIn(words.slice(count).join(" "), read));
    if (first && rest) return [first, ...rest];
  }
  return null;
}

/** The words of a part that are not understood: without what is, from either end. */
function unreadOf(part: string, read: (words: string) => Asked | null): string {
  const words = part.split(/\s+/);
  for (let count = words.length - 1; count > 0; count -= 1) {
    if (askedIn(words.slice(0, count).join(" "), read)) return unreadOf(words.slice(count).join(" "), read);
    if (askedIn(words.slice(-count).join(" "), read)) return unreadOf(words.slice(0, -count).join(" "), read);
  }
  return part;
}

/** Reads a line with the words that the service's catalog knows. */
export function readWish(text: string, catalog: Catalog): ReadWish {
  const words = new Map(wordsOf(catalog).map((word) => [bare(word), word]));
  const presets = new Map(Object.keys(catalog.presets ?? {}).map((name) => [bare(name), name]));
  const counts: Record<string, number> = {};
  let [preset, area]: [string | undefined, number | undefined] = [undefined, undefined];
  const read = (part: string): Asked | null => {
    const square = areaIn(part);
    if (square !== null) return { area: square };
    const named = presets.get(bare(part.replace(/\b(home|house|flat|apartment)\b/, "")));
    if (named !== undefined) return { preset: named };
    const [, zimmer] = ZIMMER.exec(part) ?? [];
    const bedrooms = zimmer === undefined ? 0 : (NUMBERS[zimmer] ?? Number(zimmer)) - 1;
    if (zimmer !== undefined && bedrooms < 1) return presets.has("studio") ? { preset: "studio" } : null;
    if (zimmer !== undefined) return { word: words.get("bedroom") ?? "bedrooms", count: bedrooms };
    const [, number = "1", noun = part] = COUNTED.exec(part) ?? [];
    const word = words.get(bare(noun));
    return word === undefined ? null : { word, count: NUMBERS[number] ?? Number(number) };
  };
  for (const part of text.toLowerCase().split(/,(?!\d)|;|\+|\/|\b(?:and|with|und|mit)\b/).map((one) => one.trim()).filter(Boolean)) {
    const asked = askedIn(part, read);
    if (!asked) return { unread: unreadOf(part, read) };
    for (const one of asked) {
      if ("area" in one) area = one.area;
      else if ("preset" in one) preset = one.preset;
      else counts[one.word] = (counts[one.word] ?? 0) + one.count;
    }
  }
  const program: string | Counts | undefined = Object.keys(counts).length > 0 ? { ...(preset ? catalog.presets?.[preset]?.rooms : {}), ...counts } : preset;
  if (program === undefined && area === undefined) return { unread: text.trim() };
  return { wish: { ...(program === undefined ? {} : { program }), ...(area === undefined ? {} : { area }) } };
}
