// @vitest-environment happy-dom
/** A plan's drawing in the reader's words: its numbers stay what they are, and names keep to their places. */
import { afterEach, expect, it, vi } from "vitest";

const named = (name: string, turn = ""): string => `<rect class="back" x="-100" y="0" width="1000" height="400" rx="6"/><g${turn}><text class="name" x="1" y="2" font-size="200">${name}</text>`
  + '<text x="1" y="3" font-size="172">13.7 m²</text></g>';
const SHEET = `<svg>${named("Master bedroom")}${named("Kids bedroom", ' transform="rotate(-90 1 2)"')}${named("A &lt;b&gt;")}<text class="number" x="5" y="6">1.12</text>`
  + '<text class="left name" font-size="375">House 5</text><text class="left">12 rooms, 112.4 m² indoors. Scale 1:75 as printed.</text></svg>';
const HOME = { rooms: [{ type: "bedroom_master" }, { type: "kids_bedroom" }, { type: "a_<b>" }] } as never;

let grounds: number[][] = [];

async function wordedIn(language: string): Promise<string[]> {
  vi.resetModules();
  vi.stubGlobal("navigator", { language });
  const { inPageWords } = await import("../src/plan/plan_words");
  const svg = inPageWords(SHEET, HOME);
  grounds = [...svg.matchAll(/<rect class="back" x="(-?\d+)" y="(-?\d+)" width="(\d+)" height="(\d+)"/g)].map((found) => found.slice(1).map(Number));
  return [...svg.matchAll(/<text([^>]*)>([^<]*)/g)].map(([, start = "", words = ""]) => `${/(?<=font-size=")\d+/.exec(start)?.[0] ?? ""} ${words}`.trim());
}

afterEach(() => { vi.unstubAllGlobals(); });

it("is German on a German page", async () => {
  expect(await wordedIn("de")).toEqual(["176 Elternschlafzimmer", "172 13,7 m²", "200 Kinderzimmer", "172 13,7 m²", "200 A &lt;b&gt;", "172 13,7 m²", "1,12", "375 Haus 5",
    "12 Räume, 112,4 m² innen. Gedruckt im Maßstab 1:75."]);
  expect(grounds).toEqual([[-167, 0, 1134, 400], [-100, 0, 1000, 400], [-100, 0, 1000, 400]]);
});

it("stays as it came on an English one, but for names that one says otherwise", async () => {
  expect(await wordedIn("en")).toEqual(["200 Master bedroom", "172 13.7 m²", "192 Kids' bedroom", "172 13.7 m²", "200 A &lt;b&gt;", "172 13.7 m²", "1.12", "375 House 5",
    "12 rooms, 112.4 m² indoors. Scale 1:75 as printed."]);
  expect(grounds).toEqual([[-100, 0, 1000, 400], [-100, -8, 1000, 416], [-100, 0, 1000, 400]]);
});
