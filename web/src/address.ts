/** The page's address holds the request, so a link is a house. */
import type { HouseRequest } from "./contract";

/** What a bare address asks for: the service's own defaults with outdoor rooms on, and one fixed house. */
export const DEFAULTS: Readonly<HouseRequest> = {
  seed: 42,
  width: 20,
  depth: 15,
  min_room_size: 3,
  max_depth: 5,
  use_spine: true,
  outdoor: true,
};

const NUMBERS = ["seed", "width", "depth", "min_room_size", "max_depth"] as const;
const SWITCHES = ["use_spine", "outdoor"] as const;

/** A number where the text is one; else the text itself, so that the service can say what is wrong with it. */
export function numberOrText(text: string): number | string {
  const trimmed = text.trim();
  const value = Number(trimmed);
  return trimmed !== "" && Number.isFinite(value) ? value : trimmed;
}

/** Reads a request from an address's query; what the query does not say is the default. */
export function requestFromQuery(query: string): HouseRequest {
  const given = new URLSearchParams(query);
  const request: HouseRequest = { ...DEFAULTS };
  for (const name of NUMBERS) {
    const text = given.get(name);
    if (text !== null) request[name] = numberOrText(text);
  }
  for (const name of SWITCHES) {
    const text = given.get(name);
    if (text !== null) request[name] = text === "true" || text === "1";
  }
  return request;
}

/** Writes every field of a request, so that a link keeps its meaning when defaults change. */
export function queryFromRequest(request: HouseRequest): string {
  const query = new URLSearchParams();
  for (const name of [...NUMBERS, ...SWITCHES]) query.set(name, String(request[name]));
  return `?${query.toString()}`;
}

export const SMALL_SEEDS = 1_000_000;

/** A new seed a person can read aloud, never the one before. */
export function anotherSeed(previous: number | string, draw: () => number = Math.random): number {
  const seed = Math.floor(draw() * SMALL_SEEDS);
  return seed === previous ? (seed + 1) % SMALL_SEEDS : seed;
}
