/** The page's address holds the request, so a link is a house. */
import type { Counts, HouseRequest, Typed } from "./contract";

/** A plain request: the service's own defaults with outdoor rooms on, and one fixed house. */
export const DEFAULTS: Readonly<HouseRequest> = {
  seed: 42,
  width: 20,
  depth: 15,
  min_room_size: 3,
  max_depth: 5,
  use_spine: true,
  outdoor: true,
};

/** What a bare address asks for. */
export const FIRST: Readonly<HouseRequest> = { seed: 42, program: "family", outdoor: true, decorate: true };

export const NUMBERS = ["seed", "width", "depth", "min_room_size", "max_depth", "area", "robot_width", "wall_thickness", "outer_wall_thickness"] as const;
export const SWITCHES = ["use_spine", "outdoor", "decorate", "people"] as const;
export const TEXTS = ["program", "style", "access"] as const;
/** What says nothing where it stands at the service's own default, which is so for good. */
const UNSAID: Readonly<Partial<Record<string, boolean | string>>> = { decorate: false, people: true, outline: "any" };
/** What speaks of plain requests alone. */
export const OF_PLAIN_PLANS = ["min_room_size", "max_depth", "use_spine"] as const;
/** Mappings are written one entry a word: `program.bedrooms=3`. */
const MAPPINGS = ["program", "force_types"] as const;

/** A number where the text is one; else the text itself, so that the service can say what is wrong with it. */
export function numberOrText(text: string): Typed {
  const trimmed = text.trim();
  const value = Number(trimmed);
  return trimmed !== "" && Number.isFinite(value) ? value : trimmed;
}

function switchOrText(text: string): boolean | string {
  if (text === "true" || text === "1") return true;
  return text === "false" || text === "0" ? false : text;
}

function camelCase(name: string): string {
  return name.replace(/_([a-z])/g, (_, letter: string) => letter.toUpperCase());
}

/** A field's text under its own spelling, else in camelCase, which the service takes too. */
function textOf(given: URLSearchParams, name: string): string | null {
  return given.get(name) ?? given.get(camelCase(name));
}

function mappingOf(given: URLSearchParams, name: string): Record<string, string> | null {
  const entries = [...given].flatMap(([key, text]) => {
    const prefix = [`${name}.`, `${camelCase(name)}.`].find((start) => key.startsWith(start));
    return prefix ? [[key.slice(prefix.length), text] as const] : [];
  });
  return entries.length > 0 ? Object.fromEntries(entries) : null;
}

function programOf(given: URLSearchParams): string | Counts | undefined {
  const counts = mappingOf(given, "program");
  if (!counts) return given.get("program") || undefined;
  return Object.fromEntries(Object.entries(counts).map(([word, text]) => [word, numberOrText(text)]));
}

/** An outline as it is written: a word, or corners as the command line takes them, "0,0 8,0 8,6 0,6". */
export function outlineFrom(text: string): HouseRequest["outline"] {
  const corners = text.trim().split(/[\s+]+/).map((corner) => corner.split(",").map(Number));
  const isCorner = (corner: number[]): corner is [number, number] => corner.length === 2 && corner.every(Number.isFinite);
  return corners.every(isCorner) ? corners : text;
}

/** Writes what `outlineFrom` reads. */
export function outlineText(outline: NonNullable<HouseRequest["outline"]>): string {
  return typeof outline === "string" ? outline : outline.map((corner) => corner.join(",")).join(" ");
}

/** Reads a request from an address's query; what the query does not say is the default. */
export function requestFromQuery(query: string): HouseRequest {
  const given = new URLSearchParams(query);
  if (![...NUMBERS, ...SWITCHES, ...TEXTS, "outline"].some((name) => textOf(given, name) !== null) && MAPPINGS.every((name) => !mappingOf(given, name))) return { ...FIRST };
  const program = programOf(given);
  const planned = program !== undefined || (given.get("area") ?? "") !== "";
  const request: HouseRequest = planned ? { seed: DEFAULTS.seed, outdoor: DEFAULTS.outdoor, program } : { ...DEFAULTS };
  for (const name of NUMBERS) {
    const text = textOf(given, name);
    if (text) request[name] = numberOrText(text);
  }
  for (const name of SWITCHES) {
    const text = textOf(given, name);
    if (text) request[name] = switchOrText(text);
  }
  request.style = given.get("style") || undefined;
  request.access = given.get("access") || undefined;
  request.force_types = mappingOf(given, "force_types") ?? undefined;
  const outline = given.get("outline");
  request.outline = outline ? outlineFrom(outline) : undefined;
  if (typeof request.outline === "object") for (const name of ["width", "depth"] as const) if (!textOf(given, name)) delete request[name];
  if (planned) for (const name of OF_PLAIN_PLANS) delete request[name];
  return withoutGaps(request);
}

/** The words of a query that no request has, as they are. */
export function unreadIn(query: string): Readonly<Record<string, string>> {
  const read = [...NUMBERS, ...SWITCHES, ...TEXTS, ...MAPPINGS, "outline"].flatMap((name) => [name, camelCase(name)]);
  const isRead = (word: string): boolean => read.includes(word) || MAPPINGS.some((name) => [name, camelCase(name)].some((start) => word.startsWith(`${start}.`)));
  return Object.fromEntries([...new URLSearchParams(query)].filter(([word]) => !isRead(word)));
}

/** Leaves out what says nothing: no value, or one that is the service's own default for good. */
export function withoutGaps(request: HouseRequest): HouseRequest {
  const kept = Object.entries(request).filter(([name, value]) => value !== undefined && UNSAID[name] !== value);
  return Object.fromEntries(kept) as unknown as HouseRequest;
}

/** Writes every field that a request has, so that a link keeps its meaning when defaults change. */
export function queryFromRequest(request: HouseRequest): string {
  const query = new URLSearchParams();
  const said = withoutGaps(request);
  for (const name of [...NUMBERS, ...SWITCHES, ...TEXTS]) {
    const value = said[name];
    if (value !== undefined && typeof value !== "object") query.set(name, String(value));
  }
  if (said.outline) query.set("outline", outlineText(said.outline));
  for (const name of MAPPINGS) {
    const entries = said[name];
    if (typeof entries !== "object") continue;
    for (const [word, value] of Object.entries(entries)) query.set(`${name}.${word}`, String(value));
  }
  return `?${query.toString()}`;
}

export const SMALL_SEEDS = 1_000_000;

/** A new seed a person can read aloud, never the one before. */
export function anotherSeed(previous: Typed, draw: () => number = Math.random): number {
  const seed = Math.floor(draw() * SMALL_SEEDS);
  return seed === previous ? (seed + 1) % SMALL_SEEDS : seed;
}
