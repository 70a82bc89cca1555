// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { levelsOf, onLevels, Storeys } from "../src/view/storeys";
import { piece, room, scene } from "./rooms";

const LEVELS = [{ index: 0, elevation: 0, height: 2.8 }, { index: 1, elevation: 2.8, height: 2.6 }, { index: -1, elevation: -2.4, height: 2.4 }];
const HOUSE = scene([
  room("bed", [0, 0, 4, 3], { level: 1, index: 2, furniture: [piece("bed_1")] }), room("den", [0, 0, 4, 3], { index: 0 }), room("cellar", [0, 0, 4, 3], { level: -1, index: 1 }),
], { levels: LEVELS });

describe("the storeys of a home", () => {
  it("go from the lowest up, those with rooms alone", () => {
    expect(levelsOf(HOUSE)).toEqual([-1, 0, 1]);
    expect(levelsOf(scene([room("a", [0, 0, 4, 3])], { levels: LEVELS }))).toEqual([0]);
  });

  it("are taken with their rooms, levels, pairs and people; a home of one storey stays as it is", () => {
    const people = [{ id: "p", kind: "person", room: "den", x: 1, y: 0, z: 1, rotation: 0, width: 0.5, depth: 0.3, height: 1.7 }];
    const taken = onLevels({ ...HOUSE, dynamic: people, adjacency: [[0, 1], [0, 0]] } as never, [0]) as never as Record<string, unknown[]>;
    expect(taken.rooms).toEqual([HOUSE.rooms[1]]);
    expect([taken.levels, taken.dynamic, taken.adjacency]).toEqual([[LEVELS[0]], people, [[0, 0]]]);
    expect(onLevels({ ...HOUSE, dynamic: people } as never, [1]).dynamic).toEqual([]);
    const flat = scene([room("a", [0, 0, 4, 3])]);
    expect(onLevels(flat, [0])).toBe(flat);
  });

  it("are chosen: all beneath is drawn, the plan is of one, another state keeps the choice", () => {
    const choice = document.createElement("select");
    const storeys = new Storeys(choice);
    storeys.learn(scene([room("a", [0, 0, 4, 3])]));
    expect([choice.hidden, storeys.chosen]).toEqual([true, 0]);
    storeys.learn(HOUSE);
    expect([choice.hidden, choice.options.length, storeys.chosen]).toEqual([false, 3, 0]);
    expect(storeys.drawn(HOUSE).rooms.map(({ id }) => id)).toEqual(["den", "cellar"]);
    expect([storeys.goTo(1), storeys.goTo(1), storeys.goTo(7)]).toEqual([true, false, false]);
    storeys.learn({ ...HOUSE });
    expect(storeys.planned(HOUSE).rooms.map(({ id }) => id)).toEqual(["bed"]);
    expect(storeys.drawn(HOUSE)).toBe(HOUSE);
    expect(storeys.riseIn(HOUSE)).toBe(2.8);
    storeys.learn(scene([room("a", [0, 0, 4, 3])]));
    expect([choice.hidden, storeys.chosen]).toEqual([true, 0]);
  });
});
