// @vitest-environment happy-dom
/** The form of the page itself: what it shows it reads again, whatever request it was shown. */
import { readFileSync } from "node:fs";
import { beforeEach, describe, expect, it, vi } from "vitest";
import { DEFAULTS } from "../src/address";
import { drawing, randomRequest } from "./random_requests";
import type { Catalog, HouseRequest } from "../src/contract";
import { Controls } from "../src/panel/controls";

const FORM = /<form id="request"[\s\S]*?<\/form>/.exec(readFileSync("index.html", "utf8"))?.[0] ?? "";
const CATALOG: Catalog = {
  furniture: {}, decorations: {},
  presets: { family: { rooms: { bedrooms: 3, bathrooms: 2 }, description: "three bedrooms" }, studio: { rooms: { bathrooms: 1 } } },
  rooms: { office: { accent: "#000000", home: {} }, garage: { accent: "#000000", home: { word: "garage" } }, hallway: { accent: "#000000" } },
  styles: { scandi: { walls: { bath: [{ type: "tile" }], rest: [{ type: "plaster" }, { type: "tile" }] } }, rustic: {} },
};

function field<Kind extends HTMLElement = HTMLInputElement>(name: string): Kind {
  return document.querySelector(`[name="${name}"]`) as Kind;
}

function choose(name: string, value: string): void {
  const select = field<HTMLSelectElement>(name);
  select.value = value;
  select.dispatchEvent(new Event("change", { bubbles: true }));
}

/** As browsers have it; the document of these tests has not. */
class NewOption {
  constructor(text: string, value: string) {
    return Object.assign(document.createElement("option"), { textContent: text, value });
  }
}

vi.stubGlobal("Option", NewOption);
let controls: Controls;
beforeEach(() => {
  document.body.innerHTML = FORM;
  controls = new Controls(document.querySelector("form") as HTMLFormElement);
});

describe("the form", () => {
  it("keeps for another home the style that somebody asked for, not that of a home from a file", () => {
    const style = document.querySelector("#style") as HTMLSelectElement;
    controls.show({ seed: 1, style: "modern" });
    expect(controls.readForAnother().style).toBe("modern");
    controls.showFurnishing({ style: "rustic" }, false);
    expect([style.value, controls.read().style, controls.readForAnother().style]).toEqual(["rustic", "rustic", undefined]);
    style.dispatchEvent(new Event("change"));
    expect(controls.readForAnother().style).toBe("rustic");
    controls.showFurnishing({ style: "modern" }, true);
    expect(controls.readForAnother().style).toBe("modern");
  });

  it.each([["before", false], ["after", true]])("reads what it was shown, %s the service said what it knows", (_, known) => {
    if (known) controls.offer(CATALOG);
    const draw = drawing(5);
    for (let i = 0; i < 40; i += 1) {
      const request = randomRequest(draw);
      controls.show(request);
      expect(controls.read()).toEqual(request);
    }
  });

  it("asks for an outline where there is one to choose, and takes the size of a house from corners that a link gives", () => {
    const cut: HouseRequest = { seed: 3, outdoor: true, min_room_size: 3, max_depth: 5, use_spine: true, outline: [[0, 0], [9, 0], [9, 5], [5, 5], [5, 9], [0, 9]] };
    const choice = document.querySelector("#outline_field") as HTMLElement;
    controls.show(cut);
    expect([controls.read(), choice.hidden]).toEqual([cut, false]);
    controls.show({ seed: 3, program: "family", outline: "T" });
    expect([controls.read().outline, choice.hidden]).toEqual(["T", false]);
    choose("program", "");
    expect([controls.read().outline, choice.hidden]).toEqual([undefined, true]);
  });

  it("keeps what is shown when the service says what it knows", () => {
    const request = { seed: 3, outdoor: false, program: { office: 2, attic: 1 }, style: "baroque" };
    controls.show(request);
    controls.offer(CATALOG);
    expect(controls.read()).toEqual(request);
    expect([...field<HTMLSelectElement>("style").options].map((option) => option.value)).toEqual(["", "baroque", "scandi", "rustic"]);
  });

  it("shows text that is no number as it was sent, and sends it again", () => {
    controls.show({ ...DEFAULTS, style: "<img src=x onerror=alert(1)>" });
    expect(document.querySelector("img[src=x]")).toBeNull();
    expect(controls.read().style).toBe("<img src=x onerror=alert(1)>");
  });

  it("draws a seed where there is none, and fills an outline that a plain plan lacks", () => {
    controls.show(DEFAULTS);
    for (const name of ["seed", "width", "depth"]) field(name).value = "";
    const { seed, width, depth } = controls.read();
    expect(seed).toSatisfy((drawn: number) => Number.isInteger(drawn) && drawn >= 0);
    expect(field("seed").value).toBe(String(seed));
    expect([width, depth]).toEqual([20, 15]);
  });

  it("leaves out of a planned home what speaks of plain plans, and takes it up again", () => {
    controls.offer(CATALOG);
    controls.show({ ...DEFAULTS, min_room_size: 4 });
    choose("program", "preset:family");
    expect(controls.read()).toEqual({ seed: 42, outdoor: true, program: "family" });
    expect(document.querySelector("#program_words")?.textContent).toBe("Three bedrooms.");
    choose("program", "");
    expect(controls.read()).toEqual({ ...DEFAULTS, min_room_size: 4 });
  });

  it("counts one's own rooms from those of the home before", () => {
    controls.offer(CATALOG);
    choose("program", "preset:family");
    choose("program", "own");
    expect(controls.read().program).toEqual({ bedrooms: 3, bathrooms: 2 });
    field("program.office").value = "1";
    field("program.bathrooms").value = "";
    expect(controls.read().program).toEqual({ bedrooms: 3, office: 1 });
  });

  it("keeps the line of plain words while the home shown is what they ask for", () => {
    controls.offer(CATALOG);
    const asked = document.querySelector("#asked") as HTMLInputElement;
    asked.value = "a garage, an office, 80 m²";
    asked.dispatchEvent(new Event("change", { bubbles: true }));
    controls.show({ seed: 1, program: { office: 1, garage: 1 }, area: 80 });
    expect(asked.value).toBe("a garage, an office, 80 m²");
    controls.show({ seed: 1, program: "family" });
    expect(asked.value).toBe("");
  });

  it("says what a style's walls are of", () => {
    controls.offer(CATALOG);
    choose("style", "scandi");
    expect(document.querySelector("#style_words")?.textContent).toContain("tile, plaster");
    choose("style", "rustic");
    expect(document.querySelector("#style_words")?.textContent).toBe("");
  });

  it("says beside each field what is wrong with it, as text, and takes it back", () => {
    controls.show(DEFAULTS);
    controls.showProblems([
      { field: "width", problem: "is <b>wide</b>", allowed: "2 to 1000" }, { field: "request.max_depth", problem: "is 2.5", allowed: "" },
    ]);
    expect(document.querySelector("#width_problem")?.textContent).toBe("is <b>wide</b>; allowed: 2 to 1000");
    expect(document.querySelector("#max_depth_problem")?.textContent).toBe("is 2.5");
    expect(document.activeElement).toBe(field("width"));
    expect([...document.querySelectorAll("[aria-invalid=true]")]).toEqual([field("width"), field("max_depth")]);
    controls.showProblems([]);
    expect(document.querySelectorAll("[aria-invalid=true]")).toHaveLength(0);
  });

  it("names every wrong field in its own words, and leaves to the service what is not of the form", () => {
    controls.offer(CATALOG);
    controls.show({ seed: 1, program: { bedrooms: 99, office: 1 } });
    const wrong = [
      { field: "width", problem: "is 'wide'", allowed: "a number from 2 to 1000: m, 20 unless a programme or an area chooses it" },
      { field: "program.bedrooms", problem: "is 99", allowed: "a whole number from 0 to 12" },
      { field: "use_spine", problem: "is 'so'", allowed: "true, false" }, { field: "request.area", problem: "is 3", allowed: "a number from 15 to 1000" },
    ];
    expect(controls.inWords(wrong)).toEqual([
      "Width: enter a number from 2 to 1000 m", "Bedrooms: enter a whole number from 0 to 12", "Hallway through the house: is 'so'; allowed: true, false",
      "Floor area: enter a number from 15 to 1000 m²",
    ]);
    controls.showProblems(wrong);
    expect(document.querySelector("#width_problem")?.textContent).toBe("Enter a number from 2 to 1000 m");
    expect([controls.inWords([]), controls.inWords([...wrong, { field: "scene", problem: "is missing", allowed: "" }])]).toEqual([null, null]);
  });

  it("ties every slider to its number, both ways", () => {
    const sliders = [...document.querySelectorAll<HTMLInputElement>("input[type=range]")];
    expect(sliders.map((slider) => slider.dataset.for)).toEqual(["min_room_size", "max_depth"]);
    for (const slider of sliders) {
      const number = field(slider.dataset.for ?? "");
      slider.value = "4";
      slider.dispatchEvent(new Event("input"));
      expect(number.value).toBe("4");
      number.value = "2";
      number.dispatchEvent(new Event("input"));
      expect(slider.value).toBe("2");
    }
  });
});
