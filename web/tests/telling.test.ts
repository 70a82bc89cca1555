// @vitest-environment happy-dom
/** What the service says, in German by the forms it says things in, and in English with things called as one calls them. */
import { afterAll, afterEach, describe, expect, it, vi } from "vitest";
import own from "../src/words/de.json";
import forms from "../src/words/told.de.json";

const HOME = { rooms: [{ id: "foyer_1", type: "foyer" }, { id: "kitchen_2", type: "kitchen" }, { id: "bathroom_3", type: "bathroom" }, { id: "bathroom_4", type: "bathroom" }] };

async function spokenIn(language: string) {
  vi.resetModules();
  vi.stubGlobal("navigator", { language });
  return import("../src/words/telling");
}

afterEach(() => { vi.unstubAllGlobals(); });
afterAll(() => { vi.resetModules(); }); // all files share their modules: none may go on in German

const holesIn = (words: string): Set<string> => new Set([...words.matchAll(/\{\w+\}/g)].map(([hole]) => hole));

describe("a room with a name of its own", () => {
  const home = { rooms: [...HOME.rooms, { id: "bedroom_5", type: "bedroom", name: "Aunt May's bedroom" }, { id: "r0", type: "hallway" }, { id: "r10", type: "office", name: "Den" }, { id: "m2", type: "attic", name: "Loft" }] };
  it.each([
    ["en", "no place for a bed in bedroom_5, beside kitchen_2", "no place for a bed in Aunt May's bedroom, beside the kitchen"],
    ["en", "r0 has no door or passage; it shares 4.00 m of its north wall with r10, 15.2 m2 of 106 m2", "the hallway has no door or passage; it shares 4.00 m of its north wall with Den, 15.2 m² of 106 m²"],
    ["de", "r0 has no door or passage; it shares 4.00 m of its north wall with r10", "Keine Tür und kein Durchgang: Flur; 4,00 m der Wand im Norden grenzen an: Den"],
    ["de", "bedroom_5 has 9.6 m2, more than 8", "Aunt May's bedroom hat 9,6 m², mehr als 8"],
  ])("is called so in %s", async (language, said, told) => {
    const { tell } = await spokenIn(language);
    expect(tell(said, home)).toBe(told);
  });
});

describe("in German", () => {
  it.each([
    ["kitchen_2/stove_1 leaves the clear floor of kitchen_2 to the north by 23.1 cm", "Herd ragt nach Norden um 23,1 cm aus der freien Fläche: Küche"],
    ["bathroom_4/vanity_1's door_2 opens 0 of 90 degrees: then it meets a wall", "Waschtisch: Tür 2 öffnet sich 0 von 90 Grad, dann stößt an: eine Wand"],
    ["bathroom_3 has 9.6 m2, more than 8", "Bad 1 hat 9,6 m², mehr als 8"],
    ["with its back at the west wall: 2.12 less; bathroom_3/toilet_1, bathroom_3/shower_1 and bathroom_3/plant_2 would stand elsewhere; bathroom_3/washer_1 would be left out",
      "mit dem Rücken zur Wand im Westen: um 2,12 besser; anders steht dann: WC, Dusche und Pflanze 2; weg fällt: Waschmaschine"],
    ["locked where it cannot stand: foyer_1/bench_1 leaves the clear floor of foyer_1 to the east by 2.9 cm and foyer_1/bench_1 stands 22 cm from the south wall of foyer_1, at most 20 cm is allowed",
      "festgehalten, wo es nicht stehen kann: Bank ragt nach Osten um 2,9 cm aus der freien Fläche: Diele und Bank steht 22 cm von der Wand im Süden, erlaubt sind höchstens 20 cm: Diele"],
    ["bed cannot stand and be used anywhere: bed 1.40 + to stand 0.60 = 2.00 > 1.50 m along the west wall: 50 cm short; no place was found for it beside the pieces before it; the smallest, small_bed, needs 1.40 x 2.00 m and a free way to it; the room is 1.50 x 3.00 m clear and holds 2 pieces",
      "Bett kann nirgends stehen und benutzt werden: Bett 1,40 + zum Stehen 0,60 = 2,00 > 1,50 m an der Wand im Westen: es fehlen 50 cm; neben den Möbeln davor fand sich kein Platz; das kleinste (kleines Bett) braucht 1,40 × 2,00 m und einen freien Weg dorthin; im Raum sind 1,50 × 3,00 m frei und 2 Möbel"],
    ["sofa 2.20 x 0.90 m and desk 1.40 x 0.70 m cannot stand together in the 2.87 x 2.77 m of kitchen_2, clear of its doors and windows, with sofa and desk at walls",
      "Sofa 2,20 × 0,90 m und Schreibtisch 1,40 × 0,70 m können nicht zusammen stehen: Küche, 2,87 × 2,77 m, frei von Türen und Fenstern, mit Sofa und Schreibtisch an Wänden"],
    ["desk 1.20 x 0.60 m cannot stand in kitchen_2: it stays as sent, 20 cm in the floor before door_1",
      "Schreibtisch 1,20 × 0,60 m kann dort nicht stehen: Küche; es bleibt, wo es ist, 20 cm in der Fläche vor Tür"],
  ])("says %s", async (english, german) => {
    const { tell } = await spokenIn("de");
    expect(tell(english, HOME)).toBe(german);
  });

  it("leaves what it has no form for as it came, ids called by name", async () => {
    const { tell } = await spokenIn("de");
    expect(tell("kitchen_2 sings <b>1.5</b> times", HOME)).toBe("Küche sings <b>1.5</b> times");
  });

  it("takes names as text, however they look", async () => {
    const { tell } = await spokenIn("de");
    expect(tell("$& has 9.6 m2, more than 8")).toBe("$& hat 9,6 m², mehr als 8");
    expect(tell(`${"a and ".repeat(400)}b share space: 1 m from west to east, 1 m from north to south, 1 m in height`)).toContain("stehen ineinander");
  });

  it("says what the page says of its own as the page has it, whatever forms it fits", async () => {
    const { tellPlainly } = await spokenIn("de");
    const whole = Object.entries(own).filter(([english]) => holesIn(english).size === 0);
    expect(whole.length).toBeGreaterThan(100);
    expect(whole.filter(([english, german]) => tellPlainly(english) !== german)).toEqual([]);
  });

  it("has no hole that the service does not fill", () => {
    const wrong = Object.entries(forms).filter(([english, german]) => german.trim() === "" || [...holesIn(german)].some((hole) => !holesIn(english).has(hole)));
    expect(wrong).toEqual([]);
  });
});

describe("in English", () => {
  it("calls rooms and pieces as a person does and leaves the rest", async () => {
    const { tell, tellSentence } = await spokenIn("en-GB");
    expect(tell("desk 1.40 x 0.70 m and console_table 1.20 x 0.34 m cannot stand together in foyer_1: 4 cm short", HOME))
      .toBe("desk 1.40 x 0.70 m and console table 1.20 x 0.34 m cannot stand together in the foyer: 4 cm short");
    expect(tellSentence("bathroom_4 can only be entered through bathroom_3/door", HOME)).toBe("Bathroom 2 can only be entered through bathroom_3/door");
    expect(tell("kitchen_2/stove_1 stands 35 cm in the way of the door door_2 in kitchen_2", HOME)).toBe("the stove stands 35 cm in the way of door 2 in the kitchen");
    expect(tell("person_1 stands 5 cm in the way of the garage_door garage_door_1", HOME)).toBe("the person stands 5 cm in the way of the garage door");
    expect(tellSentence("kitchen_2 (kitchen) has no stove: it was not asked for", HOME)).toBe("The kitchen has no stove: it was not asked for");
    expect(tell("kitchen_2 (open) and bathroom_3 (bathroom)", HOME)).toBe("the kitchen (open) and bathroom 1");
    expect(tell("kept from going further east by the floor before passage_13: 3.83 a metre", HOME)).toBe("kept from going further east by the floor before passage 13: 3.83 a metre");
  });
});
