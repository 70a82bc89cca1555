/** Requests drawn by a seed, for properties that must hold of any. */
import type { HouseRequest } from "../src/contract";

/** Numbers in [0, 1) that are the same for the same seed (mulberry32). */
export function drawing(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), state | 1);
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

const WORDS = ["bedrooms", "bathrooms", "office", "garage", "a b&c=d", "<i>"];
const TYPES = ["kitchen", "wine cellar", "ß+%20", "__proto__"];

/** A request that an address can hold: as the page makes them, with names of every sort. */
export function randomRequest(draw: () => number): HouseRequest {
  const chance = (share: number): boolean => draw() < share;
  const pick = <Thing>(things: readonly Thing[]): Thing => things[Math.floor(draw() * things.length)] as Thing;
  const metres = (most: number): number => Math.round(draw() * most * 100) / 100 + 0.1;
  const planned = chance(0.5);
  const counts = Object.fromEntries(WORDS.filter(() => chance(0.4)).map((word) => [word, Math.floor(draw() * 5)]));
  const program = chance(0.5) && Object.keys(counts).length > 0 ? counts : pick(["family", "my own & <b>"]);
  const plan = planned
    ? { program, ...(chance(0.5) ? { area: metres(300) } : {}), ...(chance(0.3) ? { width: metres(30) } : {}) }
    : {
      width: metres(40), depth: metres(30), min_room_size: metres(6), max_depth: Math.floor(draw() * 10), use_spine: chance(0.5),
      ...(chance(0.3) ? { force_types: { [String(Math.floor(draw() * 9))]: pick(TYPES) } } : {}),
    };
  const outline = planned ? pick(["rectangle", "L", "T", "U", undefined]) : undefined;
  return {
    seed: Math.floor(draw() * 2 ** 53), outdoor: chance(0.5), ...plan,
    ...(outline ? { outline } : {}), ...(chance(0.5) ? { decorate: true } : {}),
    ...(chance(0.5) ? { style: pick(["scandi", "ma façon"]) } : {}),
    ...(chance(0.3) ? { robot_width: metres(1) } : {}),
    ...(chance(0.2) ? { wall_thickness: metres(0.24), outer_wall_thickness: metres(0.6) } : {}),
    ...(chance(0.3) ? { people: false } : {}),
  };
}
