// @vitest-environment happy-dom
/** A plan's drawing in the reader's words: its numbers stay what they are, and the rooms are called what the page calls them. */
import { afterAll, afterEach, expect, it, vi } from "vitest";

const SHEET = '<svg><g><text class="name" x="1" y="2" font-size="200">1.5 rooms</text><text x="1" y="3" font-size="172">13.7 m²</text></g><text class="number" x="5" y="6">1.12</text>'
  + '<text class="left name" font-size="375">House 5</text><text class="left">12 rooms, 112.4 m² indoors.</text><text class="left scale">Scale 1:75 as printed.</text></svg>';
const HOME = { rooms: [{ type: "bedroom_master" }, { type: "kids_bedroom" }, { type: "a_<b>" }] } as never;

async function wordedIn(language: string): Promise<{ said: string[]; called: unknown }> {
  vi.resetModules();
  vi.stubGlobal("navigator", { language });
  const { inPageWords, roomsCalled } = await import("../src/plan/plan_words");
  return { said: [...inPageWords(SHEET).matchAll(/<text[^>]*>([^<]*)/g)].map(([, words = ""]) => words), called: roomsCalled(HOME) };
}

afterEach(() => { vi.unstubAllGlobals(); });
afterAll(() => { vi.resetModules(); }); // all files share their modules: none may go on in German

it("is German on a German page", async () => {
  expect(await wordedIn("de")).toEqual({
    said: ["1.5 rooms", "13,7 m²", "1,12", "Haus 5", "12 Räume, 112,4 m² innen.", "Gedruckt im Maßstab 1:75."],
    called: { bedroom_master: "Elternschlafzimmer", kids_bedroom: "Kinderzimmer", "a_<b>": "A <b>" },
  });
});

it("stays as it came on an English one", async () => {
  expect(await wordedIn("en")).toEqual({
    said: ["1.5 rooms", "13.7 m²", "1.12", "House 5", "12 rooms, 112.4 m² indoors.", "Scale 1:75 as printed."],
    called: { bedroom_master: "Master bedroom", kids_bedroom: "Kids' bedroom", "a_<b>": "A <b>" },
  });
});
