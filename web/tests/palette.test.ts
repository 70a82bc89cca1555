// @vitest-environment happy-dom
import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Catalog } from "../src/contract";
import { Favourites } from "../src/edit/favourites";
import { inStyle, roomsFor } from "../src/edit/adding";
import { Palette } from "../src/edit/palette";
import { piece, room, scene } from "./rooms";

const CATALOG = { furniture: { sofa: { category: "seating", size: [2, 0.9, 0.8] } }, decorations: {} } as unknown as Catalog;
let host: HTMLElement;
let palette: Palette;

/** What is said in place of kinds; nothing where that is hidden. */
function said(): string {
  const words = host.querySelector<HTMLElement>("p");
  return words && !words.hidden ? (words.textContent ?? "") : "";
}

beforeEach(() => {
  document.body.innerHTML = "<section hidden></section>";
  host = document.querySelector("section") as HTMLElement;
  palette = new Palette(host);
});

describe("the palette", () => {
  it("has its categories at one stop of the Tab key, arrows between them; closed, the house has the focus where nothing had it", async () => {
    document.body.innerHTML = '<main tabindex="0"><section hidden></section></main>';
    host = document.querySelector("section") as HTMLElement;
    palette = new Palette(host);
    await palette.await(Promise.resolve(CATALOG));
    palette.open(true);
    const chips = [...host.querySelectorAll<HTMLElement>("[role=group] button")];
    expect(chips.map(({ tabIndex }) => tabIndex)).toEqual([0, -1, -1]);
    chips[0]?.focus();
    const pieces = vi.fn();
    document.addEventListener("keydown", pieces);
    const walked = ["ArrowLeft", "ArrowRight", "ArrowRight", "End", "Home"].map((key) => {
      document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true }));
      return chips.indexOf(document.activeElement as HTMLElement);
    });
    expect([walked, pieces.mock.calls]).toEqual([[2, 0, 1, 2, 0], []]);
    document.removeEventListener("keydown", pieces);
    chips[2]?.click();
    expect(chips.map(({ tabIndex }) => tabIndex)).toEqual([-1, -1, 0]);
    palette.open(false);
    expect(document.activeElement?.tagName).toBe("MAIN");
  });

  it("says that kinds are on their way, and only then that there is none", async () => {
    let come: (catalog: Catalog) => void = () => undefined;
    const filled = palette.await(new Promise<Catalog>((resolve) => { come = resolve; }));
    palette.open(true);
    expect(said()).toBe("Loading…");
    come(CATALOG);
    await filled;
    expect(said()).toBe("");
    expect(host.querySelectorAll("li button[data-kind]")).toHaveLength(1);
    const search = host.querySelector("input") as HTMLInputElement;
    search.value = "piano";
    search.dispatchEvent(new Event("input"));
    expect(said()).toBe("No such kind.");
  });

  it("says that they did not come, and says so to who asked", async () => {
    palette.open(true);
    await expect(palette.await(Promise.reject(new Error("gone")))).rejects.toThrow("gone");
    expect(said()).toBe("The kinds could not be loaded.");
  });

  it("is filled with what the page was told already, without another question", async () => {
    vi.resetModules();
    const { catalog } = await import("../src/service");
    const answers = [new Response("{}", { status: 503 }), new Response(JSON.stringify(CATALOG))];
    const fetched = vi.fn(async () => answers.shift() as Response);
    vi.stubGlobal("fetch", fetched);
    const { signal } = new AbortController();
    await expect(catalog(signal)).rejects.toMatchObject({ status: 503 });
    for (let i = 0; i < 3; i += 1) expect(await catalog(signal)).toEqual(CATALOG);
    expect(fetched).toHaveBeenCalledTimes(2);
    vi.unstubAllGlobals();
  });

  it("shows the kinds of a category, and those that are liked, which are kept", async () => {
    const shown = () => [...host.querySelectorAll<HTMLElement>("li")].filter((item) => !item.hidden).map((item) => item.querySelector<HTMLElement>("[data-kind]")?.dataset.kind);
    const known = { furniture: { sofa: { category: "seating", size: [2, 0.9, 0.8] }, desk: { category: "table", size: [1.2, 0.6, 0.8] } }, decorations: {} } as unknown as Catalog;
    const filled = async () => {
      await new Palette(host, { favourites: new Favourites(), portray: () => undefined, over: () => undefined, drop: () => undefined }).await(Promise.resolve(known));
    };
    const press = (selector: string) => host.querySelector<HTMLElement>(selector)?.click();
    await filled();
    expect(shown()).toEqual(["desk", "sofa"]);
    press("[data-category=seating]");
    expect(shown()).toEqual(["sofa"]);
    press("[data-category=all]");
    press("[aria-label='Favourite: desk']");
    press("[data-category=favourites]");
    expect(shown()).toEqual(["desk"]);
    await filled();
    press("[data-category=favourites]");
    expect(shown()).toEqual(["desk"]);
    press("[aria-label='Favourite: desk']");
    press("[data-category=favourites]");
    expect([shown(), said()]).toEqual([[], "Nothing is starred yet: the ★ at a kind puts it here."]);
    press("[aria-label='Close']");
  });

  it("finds a kind by what others call it, where none is called so", async () => {
    const furniture = Object.fromEntries(["sofa", "sofa_bed", "bookcase"].map((key) => [key, { category: "seating", size: [2, 0.9, 0.8] }]));
    const synonyms = { sofa: { known_as: ["couch", "canape"] }, bookcase: { known_as: ["etagere", "couches", "sofa cupboard"] } };
    await palette.await(Promise.resolve({ furniture, decorations: {}, synonyms } as unknown as Catalog));
    const found = (words: string) => {
      const search = host.querySelector("input") as HTMLInputElement;
      search.value = words;
      search.dispatchEvent(new Event("input"));
      return [...host.querySelectorAll<HTMLElement>("li:not([hidden]) [data-kind]")].map((one) => one.dataset.kind);
    };
    expect([found("Couch"), found("Canapé"), found("étag"), found("sofa"), found("tagere")]).toEqual([["sofa", "bookcase"], ["sofa"], ["bookcase"], ["sofa", "sofa_bed"], []]);
  });

  it("has what is called as was searched first, which Enter takes, and presses nothing else", async () => {
    const kinds = ["armchair", "loveseat_sofa", "sofa", "sofa_bed"].map((key) => [key, { category: "seating", size: [2, 0.9, 0.8] }]);
    await palette.await(Promise.resolve({ furniture: Object.fromEntries(kinds), decorations: {} } as unknown as Catalog));
    const chosen: string[] = [];
    palette.onChoose = ({ key }) => chosen.push(key);
    const search = host.querySelector("input") as HTMLInputElement;
    const shown = () => [...host.querySelectorAll<HTMLElement>("li:not([hidden]) [data-kind]")].map((one) => one.dataset.kind);
    search.value = "sofa";
    search.dispatchEvent(new Event("input"));
    expect(shown()).toEqual(["sofa", "sofa_bed", "loveseat_sofa"]);
    const enter = new KeyboardEvent("keydown", { key: "Enter", cancelable: true });
    search.dispatchEvent(enter);
    expect([chosen, enter.defaultPrevented]).toEqual([["sofa"], true]);
    search.value = "";
    search.dispatchEvent(new Event("input"));
    expect(shown()).toEqual(["armchair", "loveseat_sofa", "sofa", "sofa_bed"]);
  });
});

describe("the colour of a new piece", () => {
  const kind = { key: "armchair", name: "armchair", category: "seating", size: [0.8, 0.8, 0.9] as const, color: "#00ff00" };
  const sofa = (color: string) => piece("sofa", { category: "seating", color });
  const home = (style: string, ...colors: readonly string[]) => scene(colors.map((color, at) => room(`room_${at}`, [0, 0, 4, 4], { furniture: [sofa(color)] })), { style });
  const palettes = (palette: Record<string, string[]>) => ({ furniture: {}, decorations: {}, styles: { calm: { palette } } }) as unknown as Catalog;

  it("is what the room, else the home, has of the style's palette for it, else the first of that", () => {
    const known = palettes({ seating: ["#111111", "#222222", "#333333"], lighting: ["#444444"] });
    expect(inStyle(kind, home("calm", "#222222", "#333333"), known, "room_1").color).toBe("#333333");
    expect(inStyle(kind, home("calm", "#222222", "#abcdef"), known, "room_1").color).toBe("#222222");
    expect(inStyle(kind, home("calm", "#abcdef"), known).color).toBe("#111111");
    const armchair = room("den", [0, 0, 4, 4], { furniture: [piece("armchair_1", { name: "armchair", category: "seating", color: "#333333" })] });
    expect(inStyle(kind, scene([...home("calm", "#222222").rooms, armchair], { style: "calm" }), known).color).toBe("#333333");
    expect(inStyle(kind, scene([...home("calm", "#222222").rooms, armchair], { style: "calm" }), known, "room_0").color).toBe("#222222");
  });

  it("is the kind's own where the style has none for it, or is not known", () => {
    expect(inStyle(kind, home("calm", "#222222"), palettes({ armchair: [], seating: ["#222222"] })).color).toBe("#00ff00");
    expect(inStyle(kind, home("toString", "#222222"), palettes({ seating: ["#222222"] })).color).toBe("#00ff00");
    expect(inStyle(kind, null, null).color).toBe("#00ff00");
  });
});

describe("the room that a new piece goes to", () => {
  const kinds = (...names: string[]) => ({ accent: "#fff", pieces: [{ piece: "first", kinds: names.map((kind) => ({ kind })) }, { piece: "toilet", kinds: [] }] });
  const home = { rooms: [room("foyer_1", [0, 0, 9, 9], { type: "foyer" }), room("office_1", [0, 0, 2, 2], { type: "office" }), room("office_2", [0, 0, 3, 2], { type: "office" })] };

  it("is of a type that the catalog furnishes with its kind, the largest first", () => {
    const types = { office: kinds("desk", "bookshelf"), foyer: kinds("bench") };
    expect(roomsFor({ key: "desk" }, home, types)).toEqual(["office_2", "office_1"]);
    expect(roomsFor({ key: "bench" }, home, types)).toEqual(["foyer_1"]);
    expect(roomsFor({ key: "toilet" }, home, types)).toEqual(["foyer_1", "office_2", "office_1"]);
    expect(roomsFor({ key: "first" }, home, types)).toEqual([]);
    expect(roomsFor({ key: "boat" }, home, types)).toEqual([]);
    expect(roomsFor({ key: "desk" }, home)).toEqual([]);
  });
});
