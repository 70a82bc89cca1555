// @vitest-environment happy-dom
/** What is said of a plan's rooms that were guessed, in both languages. */
import { afterAll, afterEach, expect, it, vi } from "vitest";

const PLAN = { rooms: [{ id: "a", type: "room" }, { id: "b", type: "room" }, { id: "c", type: "room" }, { id: "d", type: "hallway" }] } as never;
const GUESSES = [
  { room: "a", type: "kitchen", by: "name", sent: "Küche <1.5>", instead: null, message: "" },
  { room: "b", type: "bedroom", by: "form", sent: "room", instead: "office", message: "" },
  { room: "c", type: "bathroom", by: "pieces", sent: "room", instead: null, message: "" },
] as const;

async function said(language: string): Promise<string[]> {
  vi.resetModules();
  vi.stubGlobal("navigator", { language });
  const { guessLines } = await import("../src/panel/imported");
  return guessLines({ guesses: GUESSES, entrance: { id: "door_1", room: "d", message: "" } }, PLAN);
}

afterEach(() => { vi.unstubAllGlobals(); });
afterAll(() => { vi.resetModules(); }); // all files share their modules: none may go on in German

it("names every room, its type and what told it", async () => {
  expect(await said("en")).toEqual([
    "Room 1: Kitchen, told by its name, Küche <1.5>", "Room 2: Bedroom, told by its form; next best: Office",
    "Room 3: Bathroom, told by what stands in it", "One comes in by door_1: Hallway",
  ]);
  expect(await said("de")).toEqual([
    "Raum 1: Küche, nach dem Namen, Küche <1.5>", "Raum 2: Schlafzimmer, nach der Form; am zweitbesten: Arbeitszimmer",
    "Raum 3: Bad, nach dem, was darin steht", "Man kommt durch door_1 herein: Flur",
  ]);
});
