import { describe, expect, it } from "vitest";
import { scrollToSee } from "../src/panel/scroll_within";

const SEEN = { top: 100, bottom: 300 };

describe("a region", () => {
  it.each([
    ["seen", 100, 300, 0],
    ["above", 40, 60, -60],
    ["cut at the top", 90, 110, -10],
    ["below", 400, 420, 120],
    ["cut at the bottom", 290, 310, 10],
    ["higher than the region, begun above, not yet at its end", 50, 350, 0],
    ["higher than the region, wholly below", 310, 610, 210],
    ["higher than the region, wholly above", -300, 20, -280],
  ])("scrolls for a stretch that is %s by no more than it must", (_, top, bottom, by) => {
    expect(scrollToSee({ top, bottom }, SEEN)).toBe(by);
  });
});
