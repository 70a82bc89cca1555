import { describe, expect, it } from "vitest";
import type { Catalog } from "../src/contract";
import { readWish } from "../src/panel/plain_wishes";

const CATALOG = {
  presets: { family: { rooms: { bedrooms: 3, bathrooms: 2 } }, one_bed: { rooms: { bedrooms: 1 } }, studio: { rooms: {} } },
  rooms: { bedroom: { home: { word: "bedrooms" } }, bathroom: { home: { word: "bathrooms" } }, office: { home: {} }, laundry_room: { home: {} }, hallway: {} },
} as unknown as Catalog;

describe("a line of plain words", () => {
  it.each([
    ["3 bedrooms, 2 baths, 120 m²", { program: { bedrooms: 3, bathrooms: 2 }, area: 120 }],
    ["two bedrooms and an office", { program: { bedrooms: 2, office: 1 } }],
    ["Laundry room + 1 bed", { program: { laundry_room: 1, bedrooms: 1 } }],
    ["90,5 m2", { area: 90.5 }],
    ["1000 sq ft", { area: 92.9 }],
    ["Family home, 140 sqm", { program: "family", area: 140 }],
    ["one bed", { program: "one_bed" }],
    ["1 bed", { program: { bedrooms: 1 } }],
    ["family with 5 bedrooms", { program: { bedrooms: 5, bathrooms: 2 } }],
    ["4x bedrooms; ", { program: { bedrooms: 4 } }],
    ["zwei Schlafzimmer, ein Bad und Arbeitszimmer, 90 Quadratmeter", { program: { bedrooms: 2, bathrooms: 1, office: 1 }, area: 90 }],
    ["2 bed 1 bath office 90m2", { program: { bedrooms: 2, bathrooms: 1, office: 1 }, area: 90 }],
    ["two bedrooms and a study", { program: { bedrooms: 2, office: 1 } }],
    ["2bd/1ba 1,000 sq ft", { program: { bedrooms: 2, bathrooms: 1 }, area: 92.9 }],
    ["2 Schlafzimmer 1 Bad Laundry room 90,5 Quadratmeter", { program: { bedrooms: 2, bathrooms: 1, laundry_room: 1 }, area: 90.5 }],
    ["family home 140 sqm", { program: "family", area: 140 }],
    ["2 bed 2 bed", { program: { bedrooms: 4 } }],
    ["bedroom, bedroom and a bath", { program: { bedrooms: 2, bathrooms: 1 } }],
    ["3 Zimmer, 80 m²", { program: { bedrooms: 2 }, area: 80 }],
    ["Vier-Zimmer-Wohnung mit Bad", { program: { bedrooms: 3, bathrooms: 1 } }],
    ["1 Zimmer", { program: "studio" }],
    ["3 Schlafzimmer, 120 m²", { program: { bedrooms: 3 }, area: 120 }],
  ])("%s", (text, wish) => {
    expect(readWish(text, CATALOG)).toEqual({ wish });
  });

  it.each([["3 swimming halls", "3 swimming halls"], ["2 bedrooms, a hallway", "a hallway"], ["<b>", "<b>"], ["12", "12"], ["3 m", "3 m"], ["2 bed 3 swimming halls 90 m2", "3 swimming halls"], ["2 bed 1", "1"], ["2 bed gym 1 bath", "gym"], ["0 Zimmer and 12", "12"], [",", ","]])("%s is not understood", (text, unread) => {
    expect(readWish(text, CATALOG)).toEqual({ unread });
  });
});
