// @vitest-environment happy-dom
/** A plan's drawing in the reader's words: its numbers stay what they are, and names keep to their places. */
import { afterEach, expect, it, vi } from "vitest";

const SHEET = '<svg><text class="name" x="1" y="2" font-size="200">Master bedroom</text><text x="1" y="3" font-size="172">13.7 m²</text>'
  + '<text class="number" x="5" y="6">1.12</text><text class="left name" font-size="375">House 5</text>'
  + '<text class="left">12 rooms, 112.4 m² indoors. Scale 1:75 as printed.</text><text class="name" font-size="9">Kids bedroom</text><text class="name" font-size="9">A &lt;b&gt;</text></svg>';
const HOME = { rooms: [{ type: "bedroom_master" }, { type: "kids_bedroom" }, { type: "a_<b>" }] } as never;

async function wordedIn(language: string): Promise<string[]> {
  vi.resetModules();
  vi.stubGlobal("navigator", { language });
  const { inPageWords } = await import("../src/plan/plan_words");
  return [...inPageWords(SHEET, HOME).matchAll(/<text([^>]*)>([^<]*)/g)].map(([, start = "", words = ""]) => `${/font-size="\d+"/.exec(start)?.[0] ?? ""} ${words}`.trim());
}

afterEach(() => { vi.unstubAllGlobals(); });

it("is German on a German page", async () => {
  expect(await wordedIn("de")).toEqual(['font-size="156" Elternschlafzimmer', 'font-size="172" 13,7 m²', "1,12", 'font-size="375" Haus 5',
    "12 Räume, 112,4 m² innen. Gedruckt im Maßstab 1:75.", 'font-size="9" Kinderzimmer', 'font-size="9" A &lt;b&gt;']);
});

it("stays as it came on an English one, but for names that one says otherwise", async () => {
  expect(await wordedIn("en")).toEqual(['font-size="200" Master bedroom', 'font-size="172" 13.7 m²', "1.12", 'font-size="375" House 5',
    "12 rooms, 112.4 m² indoors. Scale 1:75 as printed.", 'font-size="8" Kids\' bedroom', 'font-size="9" A &lt;b&gt;']);
});
