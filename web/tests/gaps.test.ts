// @vitest-environment happy-dom
import { describe, expect, it } from "vitest";
import { GapPanel } from "../src/edit/gap_panel";
import { footprint, gapsOf } from "../src/edit/gaps";
import { lengthWords } from "../src/edit/lengths";
import { drawing } from "./random_requests";
import { piece, room, scene } from "./rooms";

const OWN = piece("own", { x: 2, z: 1.5, width: 1, depth: 0.6, height: 0.8 });
const told = (pieces: Parameters<typeof gapsOf>[1]["furniture"], own = OWN, more: object = {}) => {
  const den = room("den", [3, 7, 5, 4], { furniture: [own, ...pieces], ...more });
  return Object.fromEntries(gapsOf({ wall_thickness: 0.1 }, den, own).map(({ side, wall, piece: near }) => [side, [wall, near?.mm ?? null, near?.name ?? null]]));
};

describe("distances around a piece", () => {
  it("are those to the walls' faces and to the nearest piece before them", () => {
    const others = [
      piece("a", { name: "coffee_table", x: 4, z: 1.5, width: 0.5, depth: 0.5 }), piece("b", { name: "plant", x: 3.2, z: 1.2, width: 0.4, depth: 0.4 }),
      piece("beside", { x: 2, z: 3.5, width: 0.4, depth: 0.4, rotation: 90 }), piece("over", { x: 0.5, z: 1.5, y: 1.9, width: 0.3, depth: 0.3 }),
      piece("apart", { x: 0.5, z: 0.3, width: 0.3, depth: 0.3 }), piece("carried", { x: 2, z: 1.5, y: 0.4, on: "own", width: 0.1, depth: 0.1 }),
    ];
    expect(told(others)).toEqual({ north: [1150, null, null], east: [2450, 500, "plant"], south: [2150, 1500, "sofa"], west: [1450, null, null] });
  });

  it("turn with the piece, and go to the notch of an L", () => {
    expect(told([], { ...OWN, rotation: 90 })).toEqual({ north: [950, null, null], east: [2650, null, null], south: [1950, null, null], west: [1650, null, null] });
    const outline = [[0, 0], [3, 0], [3, 2], [5, 2], [5, 4], [0, 4]] as const;
    expect(told([], OWN, { outline })).toMatchObject({ east: [450, null, null], west: [1450, null, null] });
    expect(footprint({ ...OWN, rotation: 45 }).x).toEqual([1434, 2566]);
  });

  it("add up to the room, wherever the piece stands", () => {
    const draw = drawing(4);
    for (let i = 0; i < 500; i += 1) {
      const [x, z] = [0.55 + Math.round(draw() * 3900) / 1000, 0.35 + Math.round(draw() * 3300) / 1000];
      const own = { ...OWN, x, z };
      const { north, east, south, west } = told([], own) as Record<string, [number]>;
      expect([(west?.[0] ?? NaN) + (east?.[0] ?? NaN), (north?.[0] ?? NaN) + (south?.[0] ?? NaN)]).toEqual([5000 - 100 - 1000, 4000 - 100 - 600]);
      expect(west?.[0]).toBe(Math.round(x * 1000) - 500 - 50);
    }
  });

  it("are shown of what is chosen or in hand, as text", () => {
    document.body.innerHTML = "<section hidden><dl></dl></section>";
    const host = document.querySelector("section") as HTMLElement;
    const panel = new GapPanel(host);
    const home = scene([room("den", [0, 0, 5, 4], { furniture: [OWN, piece("x", { name: "<b>x</b>", x: 4, z: 1.5, width: 0.5, depth: 0.5 })] })]);
    panel.show(home, home.rooms[0], "own");
    expect([host.hidden, host.textContent]).toEqual([false, "north1.15 m to the walleast2.45 m to the wall, 1.25 m to <b>x</b>south2.15 m to the wallwest1.45 m to the wall"]);
    panel.show(home, home.rooms[0], "own", { ...OWN, x: 2.003 });
    expect(host.textContent).toContain("west1.453 m to the wall");
    panel.show(home, home.rooms[0], "own", { ...OWN, x: 0.475 });
    expect(host.textContent).toContain("west0.075 m inside the wall");
    panel.show(home, home.rooms[0], "gone");
    expect([host.hidden, lengthWords(1450), lengthWords(0)]).toEqual([true, "1.45 m", "0.00 m"]);
  });
});
