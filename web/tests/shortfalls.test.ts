// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import type { Scene } from "../src/contract";
import { sentence, shortfallLine, ShortfallPanel, shortfallsOf } from "../src/panel/shortfalls";
import { room, scene } from "./rooms";

const NONE = "none of the ways to stand it leaves the room valid and walkable; the smallest, small_desk, needs 1.00 x 0.50 m";
const FULL = "the floor is covered as densely as wished without it; the smallest, plant, needs 0.40 x 0.40 m";

function home(certificate: Scene["certificate"]): Scene {
  const rooms = [room("bed_1", [0, 0, 4, 4], { type: "bedroom" }), room("bed_2", [4, 0, 4, 4], { type: "bedroom" }), room("k", [0, 4, 4, 4], { type: "kitchen" })];
  return scene(rooms, { certificate: certificate ?? null });
}

describe("what fell short", () => {
  it("is nothing where all was met, or nothing is known", () => {
    for (const certificate of [null, {}, { notes: [], rooms: { k: { proven: true, left_out: [] } } }]) {
      const found = shortfallsOf(home(certificate));
      expect([found, shortfallLine(found)]).toEqual([{ asked: [], beside: [], leftOut: [], pieces: 0, spare: 0 }, ""]);
    }
  });

  it("is said of the plan, of rooms that are not proven, and of pieces by room and reason, in plain words", () => {
    const left = [{ piece: "desk_1", reason: NONE }, { piece: "second_armchair_1", reason: NONE.replace("small_desk", "armchair") }, { piece: "plant_1", reason: FULL }, { piece: "third_across_1", reason: FULL.replace("plant", "dining_chair") }];
    const found = shortfallsOf(home({
      notes: ["the house has 111 m2, not 40: its rooms would be too small", "left out, for want of space in 8 x 7 m: dining_room, foyer"],
      rooms: { bed_1: { proven: false }, bed_2: { proven: true, left_out: left, notes: ["an own_note."] }, k: {} },
    }));
    expect(found.asked.map(({ words, room: id }) => [words, id])).toEqual([
      ["The house has 111 m², not 40: its rooms would be too small.", null], ["Left out, for want of space in 8 x 7 m: dining room, foyer.", null],
      ["Bedroom 2: An own note.", "bed_2"], ["Bedroom 1: not proven to be the best. The search ended at its limit; there may be a better arrangement.", "bed_1"],
    ]);
    expect(found.leftOut.map(({ words, whys }) => [words, whys.length])).toEqual([
      ["Bedroom 2: full enough without plant and dining chair.", 2], ["Bedroom 2: no place found for desk and second armchair.", 2],
    ]);
    expect(found.leftOut[1]?.whys[0]).toBe("Desk: none of the ways to stand it leaves the room valid and walkable; the smallest, small desk, needs 1.00 x 0.50 m.");
    expect(shortfallLine(found)).toBe("The house has 111 m², not 40: its rooms would be too small. And 3 more. 2 more pieces were tried and found no place.");
    expect(sentence("beside it each half would be 2.85 m deep, less than min_room_size 3.0")).toBe("Beside it each half would be 2.85 m deep, less than the smallest room side of 3.0.");
  });

  it("is said without alarm where rooms are only full enough", () => {
    const found = shortfallsOf(home({ rooms: { k: { proven: true, left_out: [{ piece: "plant_1", reason: FULL }] } } }));
    expect([found.pieces, found.spare, shortfallLine(found)]).toEqual([0, 1, "The rooms are furnished as fully as wished."]);
  });

  it("is no alarm where a garden has no patio beside it: the home has all that was asked", () => {
    const notes = ["no patio: beside the backyard no living space or hallway leads to one"];
    const said = "No patio: beside the backyard no living space or hallway leads to one.";
    const bare = shortfallsOf(home({ notes }));
    expect([bare.asked, bare.beside.map(({ words }) => words), shortfallLine(bare)]).toEqual([[], [said], said]);
    const left = shortfallsOf(home({ notes, rooms: { k: { proven: true, left_out: [{ piece: "plant_1", reason: NONE }] } } }));
    expect([left.asked, shortfallLine(left)]).toEqual([[], "1 more piece was tried and found no place."]);
    expect(shortfallsOf(home({ notes: ["no backyard: the house takes the whole plot of 8 m", ...notes] })).asked).toHaveLength(1);
  });

  it("is shown as text, leads to its room, and is hidden where there is nothing", () => {
    document.body.innerHTML = "<details><summary></summary><ul></ul></details><button></button>";
    const [section, list, line] = ["details", "ul", "body > button"].map((one) => document.querySelector(one)) as [HTMLDetailsElement, HTMLElement, HTMLButtonElement];
    const panel = new ShortfallPanel(section, list, line);
    const chosen: string[] = [];
    panel.onChooseRoom = (id) => chosen.push(id);
    panel.show(home({ notes: ["<img src=x>"], rooms: { k: { left_out: [{ piece: "<b>_1", reason: NONE }] } } }));
    expect([section.hidden, line.hidden, list.querySelector("img, b"), line.textContent]).toEqual([false, false, null, "<img src=x>. 1 more piece was tried and found no place."]);
    line.click();
    expect([section.open, document.activeElement?.tagName]).toEqual([true, "SUMMARY"]);
    list.querySelector("button")?.click();
    expect(chosen).toEqual(["k"]);
    panel.show(home(null));
    expect([section.hidden, line.hidden, list.children.length]).toEqual([true, true, 0]);
  });
});
