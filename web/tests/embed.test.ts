import { describe, expect, it } from "vitest";
import { frameLine, frameOf, framedIn, pageOf } from "../src/embed/embed_address";

describe("the address of a home in a frame", () => {
  it("holds request, changes and view behind its #, and opens the same home in the page", () => {
    const framed = framedIn("#seed=7&program=family&view=walk&changes=ab-_9");
    expect(framed).toEqual({ query: "seed=7&program=family", changes: "ab-_9", view: "walk" });
    expect(pageOf(framed)).toBe("./?seed=7&program=family#changes=ab-_9");
    expect(framedIn("")).toEqual({ query: "", changes: null, view: "corner" });
    expect(framedIn("#?view=<b>").view).toBeNull();
  });

  it("is made of a link, and comes back from its line of HTML", () => {
    const link = "https://homes.example/rooms/?seed=7&program.bedrooms=2#changes=ab-_9";
    expect(frameOf(link)).toBe("https://homes.example/rooms/embed#seed=7&program.bedrooms=2&changes=ab-_9");
    expect(framedIn(new URL(frameOf(link)).hash)).toMatchObject({ query: "seed=7&program.bedrooms=2", changes: "ab-_9" });
    expect(frameOf("https://homes.example/?seed=1")).toBe("https://homes.example/embed#seed=1");
  });

  it("is text in the line, whatever the link holds", () => {
    const line = frameLine('https://homes.example/?style="><script>&seed=1');
    expect(line).not.toContain("<script");
    expect(line.match(/"/g)?.length).toBe(12);
  });
});
