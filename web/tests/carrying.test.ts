import { describe, expect, it } from "vitest";
import type { Scene } from "../src/contract";
import { carriedIn, carriedTo, linkTo, LONGEST_LINK } from "../src/memory/carrying";
import { markOf, packed, unpacked } from "../src/memory/packing";
import type { Shown } from "../src/state/home";
import { drawing } from "./random_requests";
import { piece, room, scene } from "./rooms";

const BASE = "http://localhost/";

function house(pieces: number): Scene {
  return scene([room("den", [0, 0, 6, 4], { furniture: Array.from({ length: pieces }, (_, k) => piece(`den/${k}`, { x: k / 8 })) })], { seed: 5 });
}

function moved(home: Scene, count: number): Shown {
  const draw = drawing(3);
  const rooms = home.rooms.map((one) => ({ ...one, furniture: one.furniture.map((body, k) => (k < count ? { ...body, x: draw(), z: draw(), id: `${body.id}${draw()}` } : body)) }));
  return { scene: { ...home, rooms }, issues: [], conflicts: [], timing: 0 };
}

const made = (home: Scene) => () => Promise.resolve({ scene: home });

describe("a link to an edited home", () => {
  it("opens it to the byte", async () => {
    const home = house(30);
    const shown = moved(home, 3);
    const { link, isWhole } = await linkTo(shown, { seed: 5, width: 12 }, true, BASE, made(home));
    expect([isWhole, link.startsWith("http://localhost/?seed=5&width=12#changes=")]).toEqual([true, true]);
    expect(new URL(link).hash).toMatch(/^#changes=[\w-]+$/);
    const after = await carriedTo(carriedIn(new URL(link).hash) ?? "", home);
    expect(JSON.stringify(after)).toBe(JSON.stringify(shown.scene));
  });

  it("is the plain one for a home as its request makes it, and for too many changes", async () => {
    const home = house(400);
    const plain = `${BASE}?seed=5`;
    expect(await linkTo(moved(home, 0), { seed: 5 }, true, BASE, made(home))).toMatchObject({ link: plain, isWhole: true });
    expect(await linkTo(moved(home, 0), { seed: 5 }, false, BASE, () => Promise.reject(new Error("asked")))).toMatchObject({ link: plain, isWhole: true });
    const long = await linkTo(moved(home, 400), { seed: 5 }, true, BASE, made(home));
    expect(long).toMatchObject({ link: plain, isWhole: false });
    expect(long.length).toBeGreaterThan(LONGEST_LINK);
  });

  it("that is damaged, of another home or no link at all is refused in words", async () => {
    const home = house(3);
    const good = await packed({ of: markOf(home), change: { keys: { seed: { is: 6 } }, without: [] } });
    const wrong = await packed({ of: markOf(home), change: { keys: { rooms: { runs: [{ from: 7, count: 1 }] } }, without: [] } });
    await expect(carriedTo(good, home)).resolves.toMatchObject({ seed: 6 });
    for (const text of [good.slice(0, -4), "!", "", wrong, btoa("no json")]) await expect(carriedTo(text, home)).rejects.toThrow("The link is damaged");
    await expect(carriedTo(good, house(4))).rejects.toThrow("another version");
    expect([carriedIn(""), carriedIn("#stage"), carriedIn("#changes=a")]).toEqual([null, null, "a"]);
  });

  it("never unfolds to more than a home can be", async () => {
    const bomb = await packed({ of: "a", change: { is: "0".repeat(9_000_000) } });
    expect(bomb.length).toBeLessThan(20_000);
    await expect(unpacked(bomb)).rejects.toThrow("too much");
  });

  it("marks homes apart", () => {
    const marks = new Set(Array.from({ length: 2000 }, (_, k) => markOf(house(1 + (k % 40)).rooms.concat(house(k % 50).rooms))));
    expect(marks.size).toBe(200);
    expect(markOf(house(3))).toBe(markOf(house(3)));
  });
});
