// @vitest-environment happy-dom
/** Lists of lines, the legend, the link, the notice, and names that would be markup. */
import { afterEach, describe, expect, it, vi } from "vitest";
import { drawing } from "./random_requests";
import { opening, piece, room, scene } from "./rooms";
import { showFindings } from "../src/panel/found";
import { tokensOf, writeHighlighted } from "../src/panel/highlight";
import { ImportReport, offeringUnits } from "../src/panel/imported";
import { Legend, roomColors } from "../src/panel/legend";
import { LineList, type Line } from "../src/panel/line_list";
import type { Found } from "../src/memory/carrying";
import { Link } from "../src/panel/link";
import { Notice } from "../src/panel/notice";
import { roomNames } from "../src/panel/room";
import { optimalityOf, showShown } from "../src/panel/status";
import { ServiceProblem } from "../src/service";
import { times } from "./sweeps";

const line = (text: string, id: string | null): Line => ({ text, id, className: "line" });

function listed(): { list: LineList; host: HTMLElement; chosen: string[] } {
  document.body.innerHTML = "<div></div>";
  const host = document.querySelector("div") as HTMLElement;
  const list = new LineList(host);
  const chosen: string[] = [];
  list.onChoose = (id) => chosen.push(id);
  return { list, host, chosen };
}

function noticed(): { notice: Notice; again: HTMLButtonElement; key: HTMLFormElement; keys: string[] } {
  document.body.innerHTML = '<div hidden><strong class="notice-title"></strong><p class="notice-detail"></p><form class="notice-key" hidden><input />'
    + '</form><button class="notice-again"></button><button class="notice-close"></button></div>';
  const keys: string[] = [];
  const host = document.querySelector("div") as HTMLElement;
  return { notice: new Notice(host, (key) => keys.push(key)), keys, again: host.querySelector(".notice-again") as HTMLButtonElement, key: host.querySelector("form") as HTMLFormElement };
}

describe("a list of lines", () => {
  it("shows any lines after any others, in order", () => {
    const draw = drawing(7);
    const { list, host } = listed();
    const some = (): Line[] => Array.from({ length: Math.floor(draw() * 9) }, () => {
      const which = Math.floor(draw() * 4);
      return line(`text ${which}`, which % 2 ? `id ${which}` : null);
    });
    for (let i = 0; i < times(300, 80); i += 1) {
      const lines = some();
      list.show(lines);
      expect([...host.children].map((one) => [one.textContent, (one as HTMLElement).dataset.id ?? null])).toEqual(lines.map(({ text, id }) => [text, id]));
      expect([...host.children]).toEqual(list.elements);
      expect(list.buttons).toEqual([...host.querySelectorAll("button")]);
      expect(list.buttons.filter(({ tabIndex }) => tabIndex === 0)).toHaveLength(list.buttons.length > 0 ? 1 : 0);
    }
  });

  it("goes by keys no further than its ends, and chooses what is clicked", () => {
    const { list, host, chosen } = listed();
    list.show([line("head", null), ...Array.from({ length: 15 }, (_, i) => line(`piece ${i}`, `id ${i}`))]);
    const press = (key: string): boolean => document.activeElement?.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true, cancelable: true })) ?? false;
    list.buttons[0]?.focus();
    const reached = (key: string): string | null | undefined => (press(key), document.activeElement?.textContent);
    expect(["ArrowUp", "ArrowDown", "PageDown", "PageDown", "ArrowDown", "PageUp", "ArrowUp"].map(reached)).toEqual(
      ["piece 0", "piece 1", "piece 11", "piece 14", "piece 14", "piece 4", "piece 3"],
    );
    expect(press("a")).toBe(true);
    host.querySelector<HTMLElement>("div")?.click();
    list.buttons[3]?.click();
    expect(chosen).toEqual(["id 3"]);
  });
});

describe("hostile names", () => {
  const NAMES = ["<img src=x onerror=alert(1)>", "</span><script>1</script>", "a: b # c", "\"'`&lt;", "- [x]: {y}", "\u202Egnp", "${x}", "↔ → ×", "__proto__"];

  it("come out of the highlighting as they went in, as text", () => {
    const draw = drawing(11);
    for (let i = 0; i < 400; i += 1) {
      const text = Array.from({ length: 1 + Math.floor(draw() * 4) }, () => NAMES[Math.floor(draw() * NAMES.length)]).join(draw() < 0.5 ? " " : ": ");
      const into = document.createElement("div");
      writeHighlighted(text, into);
      expect(into.textContent).toBe(text);
      expect(tokensOf(text).map((token) => token.text).join("")).toBe(text);
      expect([...into.querySelectorAll("*")].filter((one) => one.tagName !== "SPAN" || one.children.length > 0)).toEqual([]);
    }
  });

  it("are text in lists and the legend too", () => {
    const { list, host } = listed();
    list.show(NAMES.map((name) => line(name, name)));
    expect(host.textContent).toBe(NAMES.join(""));
    expect(list.linesOf(NAMES[0] ?? "")).toEqual([list.buttons[0]]);
    const [marks, rooms] = [document.createElement("ul"), document.createElement("ul")];
    new Legend(marks, rooms).show(scene(NAMES.map((name, i) => room(`r${i}`, [0, 0, 1, 1], { type: name }))));
    expect([marks, rooms].flatMap((one) => [...one.querySelectorAll("*")]).every(({ tagName }) => ["LI", "SPAN"].includes(tagName))).toBe(true);
  });
});

describe("the legend", () => {
  const flooring = { type: "tile", color: "#cccccc" };
  const home = scene([
    room("b", [0, 0, 2, 2], { type: "kitchen", accent: "#ff0000" }), room("a", [2, 0, 2, 2], { type: "bathroom", flooring }),
    room("c", [4, 0, 2, 2], { type: "kitchen", accent: "#ff0000" }), room("d", [6, 0, 2, 2], { type: "kitchen", accent: "#00ff00" }),
  ]);

  it("names each type once for each floor and accent it is drawn with", () => {
    expect(roomColors(home)).toEqual([
      { type: "bathroom", floor: "#cccccc", accent: "#336699" },
      { type: "kitchen", floor: "#c49a6c", accent: "#ff0000" }, { type: "kitchen", floor: "#c49a6c", accent: "#00ff00" },
    ]);
  });

  it("forgets the rooms of the house before", () => {
    const rooms = document.createElement("ul");
    const legend = new Legend(document.createElement("ul"), rooms);
    legend.show(home);
    legend.show(scene([room("a", [0, 0, 2, 2], { type: "home_office" })]));
    expect(rooms.textContent).toBe("Home office");
  });
});

describe("the link", () => {
  afterEach(() => vi.unstubAllGlobals());

  it("holds the changes of an edited house up to a length, and says so; of a file there is none", async () => {
    document.body.innerHTML = "<button></button><p></p><button hidden></button>";
    const [button, said, saving] = ["button", "p", "p + button"].map((one) => document.querySelector(one)) as [HTMLButtonElement, HTMLElement, HTMLButtonElement];
    const copied: string[] = [];
    vi.stubGlobal("navigator", { clipboard: { writeText: (text: string) => (copied.push(text), Promise.resolve()) } });
    const found: (Found | null)[] = [{ link: "whole", isWhole: true, length: 5 }, { link: "plain", isWhole: false, length: 12345 }, null];
    const link = new Link(button, said, saving, (_, act) => act(), () => { const one = found.shift(); return one ? Promise.resolve(one) : Promise.reject(new Error("lost")); });
    const words = async (): Promise<string | null> => (button.click(), await new Promise((done) => setTimeout(done)), said.textContent);
    expect(button.disabled).toBe(true);
    link.opens("?seed=5");
    expect(await words()).toBe("Link copied: it opens this house.");
    link.edited(true);
    expect([said.textContent, saving.hidden]).toEqual(["", true]);
    expect([await words(), saving.hidden]).toEqual(["Link copied: it opens this house with your changes.", true]);
    expect([await words(), saving.hidden]).toEqual([expect.stringContaining("12,345 letters; 8,000 go everywhere"), false]);
    expect([await words(), saving.hidden]).toEqual([expect.stringContaining("as it was made"), false]);
    link.opens(null);
    expect([button.disabled, said.textContent, saving.hidden]).toEqual([true, expect.stringContaining("file"), true]);
    link.opens("?seed=6");
    link.edited(false);
    expect([button.disabled, said.textContent]).toEqual([false, ""]);
    await words();
    const address = (query: string): string => new URL(query, location.href).href;
    expect(copied).toEqual([address("?seed=5"), "whole", "plain", address("?seed=5"), address("?seed=6")]);
  });
});

describe("the notice", () => {
  it("does again what was refused, and nothing else", () => {
    const { notice, again } = noticed();
    const done: string[] = [];
    notice.show(new ServiceProblem("a", "b"), () => done.push("first"));
    notice.show(new ServiceProblem("a", "b"), () => done.push("second"));
    again.click();
    notice.show(new ServiceProblem("a", "b"));
    expect(again.hidden).toBe(true);
    again.click();
    expect(done).toEqual(["second"]);
  });

  it.each([[401, true], [413, true], [429, false], [503, false], [0, false]])("offers to try again what %i refused: hidden is %s", (status, hidden) => {
    const { notice, again, key } = noticed();
    notice.show(new ServiceProblem("a", "b", { status }), () => undefined);
    expect([again.hidden, key.hidden]).toEqual([hidden, status !== 401]);
  });

  it("takes a key and then does again what was refused", () => {
    const { notice, key, keys } = noticed();
    let done = 0;
    notice.show(new ServiceProblem("a", "b", { status: 401 }), () => { done += 1; });
    key.dispatchEvent(new Event("submit", { cancelable: true }));
    (key.querySelector("input") as HTMLInputElement).value = " sesame ";
    key.dispatchEvent(new Event("submit", { cancelable: true }));
    expect([keys, done]).toEqual([["sesame"], 1]);
  });
});

describe("a file that was read", () => {
  const answer = (more: object) => ({ scene: scene([]), format: "svg", changes: [], guesses: [], unread: [], issues: [], understood_as: {}, ...more });

  const told = (list: HTMLElement): (string | null)[] => [...list.querySelectorAll("h3, li")].map((one) => one.textContent);

  function reported(): { host: HTMLElement; list: HTMLElement; report: ImportReport } {
    document.body.innerHTML = "<details hidden><div></div></details>";
    const [host, list] = [document.querySelector("details"), document.querySelector("div")] as [HTMLElement, HTMLElement];
    return { host, list, report: new ImportReport(host, list) };
  }

  it("is told of by what was guessed, left out and changed, as text", () => {
    const { host, list, report } = reported();
    report.show(answer({
      changes: [{ step: "straighten", of: "a", amount: 0.01, message: "was moved" }],
      unread: [{ place: "objects[2]", reason: "<b>is unknown</b>" }],
    }));
    expect(host.hidden).toBe(false);
    expect(told(list)).toEqual(["Left out (1)", "objects[2]: <b>is unknown</b>", "Changed (1)", "a: was moved"]);
    report.show(answer({}));
    expect(host.hidden).toBe(true);
    report.show(null);
    expect(list.children).toHaveLength(0);
  });

  it("may be read in another unit than was guessed or asked for", () => {
    const { list, report } = reported();
    const asked: unknown[] = [];
    const offered = (): (string | null)[] => [...list.querySelectorAll("button")].map((one) => one.textContent);
    report.show(answer({ guesses: [{ of: "plan", what: "unit", taken: "cm", message: "the file does not say its unit" }] }), {}, (one) => asked.push(one));
    expect(offered()).toEqual(["Read it in metres", "Read it in millimetres", "Read it in inches", "Read it in feet"]);
    list.querySelector("button")?.click();
    expect(asked).toEqual([{ unit: "m" }]);
    report.show(answer({}), { unit: "m" });
    expect(offered()[0]).toBe("Read it in centimetres");
    report.show(answer({}));
    expect(offered()).toEqual([]);
  });

  it("is refused with the units it may be read in where it was for the want of one, and with nothing where not", () => {
    const { notice } = noticed();
    const asked: unknown[] = [];
    const offered = (): HTMLElement[] => [...notice.host.querySelectorAll<HTMLElement>(":scope > div button")];
    for (const [field, allowed, units] of [
      ["unit", "m, cm, or a number of metres", 5], ["rooms", "0.5 to 1000 m: `unit` says how long the file's unit is", 5], ["rooms", "at least one room with an outline", 0],
    ] as const) {
      notice.show(offeringUnits(new ServiceProblem("a cannot be read", "", { fields: [{ field, problem: "", allowed }] }), (one) => asked.push(one)));
      expect(offered()).toHaveLength(units);
      offered()[3]?.click();
    }
    expect(asked).toEqual([{ unit: "in" }, { unit: "in" }]);
  });

  it("calls the plan so, and what was left out of a room as things are called", () => {
    const { list, report } = reported();
    report.show(answer({
      scene: scene([room("a", [0, 0, 4, 4], { openings: [opening({ connects_to: "EXTERIOR" })] })]),
      guesses: [{ of: "plan", what: "wall thickness", taken: "0.1", message: "the file does not say how thick walls are" }],
      unread: [{ place: "a/table_2", reason: "cannot stand" }],
    }));
    expect(told(list)).toEqual(["Guessed (1)", "Plan, wall thickness: 0.1; the file does not say how thick walls are", "Left out (1)", "Table 2: cannot stand"]);
  });

  it("names rooms that share floor, and says that no door leads outside, of a file and of a plan that was furnished", () => {
    const { host, list, report } = reported();
    const plan = scene([room("kitchen_1", [0, 0, 4, 4], { type: "kitchen" }), room("bedroom_2", [3, 0, 4, 4])]);
    const message = "kitchen_1 and bedroom_2 are rooms that share floor: 90 cm from west to east, 3.9 m from north to south";
    const issues = [{ rule: "rooms_overlap", severity: "warning" as const, room: "kitchen_1", ids: [], message, amount: 0.9 }, { rule: "missing_required", severity: "warning" as const, room: "bedroom_2", ids: [], message: "no bed", amount: 0 }];
    const lines = ["To be checked (3)", "The kitchen and the bedroom are rooms that share floor: 90 cm from west to east, 3.9 m from north to south", "No room has a door", "No door leads outside: ways are judged from the largest piece of free floor"];
    report.show(answer({ scene: plan, issues }));
    expect(told(list)).toEqual(lines);
    report.show(null);
    report.guessed({ guesses: [], entrance: null, issues }, plan);
    expect([host.hidden, ...told(list)]).toEqual([false, ...lines]);
    const outside = room("a", [0, 0, 4, 4], { openings: [opening({ connects_to: "EXTERIOR" })] });
    report.show(answer({ scene: scene([outside, room("b", [4, 0, 4, 4], { openings: [opening({ kind: "window" })] }), room("c", [8, 0, 4, 4], { outdoor: true })]) }));
    expect(told(list)).toEqual(["To be checked (1)", "Bedroom 2 has no door"]);
    report.show(answer({ scene: scene([outside, room("b", [4, 0, 4, 4], { openings: [opening({ connects_to: "a" })] })]) }));
    expect(host.hidden).toBe(true);
  });

  it("says what a plan's rooms were taken for once they are furnished, before the rest of its file", () => {
    const { host, list, report } = reported();
    const plan = scene([room("a", [0, 0, 4, 4], { type: "room", openings: [opening({ connects_to: "EXTERIOR" })] }), room("b", [4, 0, 4, 4], { type: "room", openings: [opening({ connects_to: "a" })] })]);
    const kitchen = { guesses: [{ room: "a", type: "kitchen", by: "form" as const, sent: "room", instead: null, message: "" }], entrance: null, issues: [] };
    const unsaid = { what: "type", taken: "room", message: "the file does not say what it is" };
    report.show(answer({ scene: plan, guesses: [{ of: "a", ...unsaid }, { of: "b", ...unsaid }], unread: [{ place: "objects[2]", reason: "is unknown" }] }));
    report.guessed(kitchen, plan);
    const second = "B, type: room; the file does not say what it is";
    expect(told(list)).toEqual(["Guessed (2)", "Room 1: Kitchen, told by its form", second, "Left out (1)", "objects[2]: is unknown"]);
    report.guessed({ guesses: [], entrance: null, issues: [] }, plan);
    expect(told(list)).toHaveLength(5);
    report.show(null); // another home
    expect(host.hidden).toBe(true);
    report.guessed(kitchen, plan);
    expect(told(list)).toEqual(["Guessed (1)", "Room 1: Kitchen, told by its form"]);
    report.show(null);
    report.guessed({ guesses: [], entrance: null, issues: [] }, plan, "sofa: no room");
    expect([host.hidden, ...told(list)], "what went with a wall that was moved").toEqual([false, "Left out (1)", "sofa: no room"]);
  });
});

describe("what is counted", () => {
  it("is said of one as of one", () => {
    document.body.innerHTML = '<p><span><b data-count="rooms">–</b> rooms</span> <span><b data-count="furniture">–</b> furniture</span> <span><b data-count="issues">–</b> broken rules</span></p>';
    const host = document.querySelector("p") as HTMLElement;
    const said = (rooms: number, broken: number, warned = 0): string | null => {
      const all = Array.from({ length: rooms }, (_, i) => room(`bedroom_${i}`, [i * 4, 0, 4, 4], { furniture: [piece(`bed_${i}`)] }));
      const issues = Array.from({ length: broken + warned }, (_, i) => ({ rule: "overlap", severity: i < broken ? "error" : "warning", message: "", ids: [], room: null }) as const);
      showShown(host, { scene: scene(all), issues, timing: 0, conflicts: [] });
      return host.textContent;
    };
    expect(said(1, 1)).toBe("1 room 1 piece of furniture 1 broken rule");
    expect(said(2, 0)).toBe("2 rooms 2 furniture 0 warnings");
    expect(said(1, 2)).toBe("1 room 1 piece of furniture 2 broken rules");
    expect(said(1, 0, 2), "no rule is broken").toBe("1 room 1 piece of furniture 2 warnings");
    expect(said(1, 3, 1), "a warning is no broken rule").toBe("1 room 1 piece of furniture 3 broken rules, 1 warning");
  });
});

describe("what is proven", () => {
  it("is said of every room, also of those whose search ended or that were changed", () => {
    const of = (rooms: object) => optimalityOf({ ...scene([]), certificate: { rooms } as never });
    expect(of({})).toBeNull();
    expect(of({ a: { proven: true } })?.full).toContain("for every room");
    const some = of({ a: { proven: true }, b: { proven: false }, c: { left_out: [] } });
    expect(some?.short).toBe("proven optimal in 1 of 3 rooms");
    expect(some?.full).toContain("ended at its limit in b.");
    expect(some?.full).toContain("Changed since: c.");
  });

  it("is not said of rooms that were only left as they were", () => {
    const rooms = [room("a", [0, 0, 4, 4]), room("b", [4, 0, 4, 4], { name: "Attic" })];
    const of = (certified: object) => optimalityOf({ ...scene(rooms), certificate: { rooms: certified } as never });
    const notes = ["no furniture is known for it"];
    expect(of({ a: { notes }, b: { notes } })).toEqual({ short: "2 rooms left as they were", full: `Left as they were: ${roomNames(scene(rooms)).get("a")}, Attic.` });
    expect(of({ b: { notes } })?.short).toBe("1 room left as it was");
    const both = of({ a: { proven: true, notes: [] }, b: { notes } });
    expect(both?.short).toBe("proven optimal in 1 of 1 rooms");
    expect(both?.full).toContain("for every room. Left as they were: Attic.");
  });
});

it("leads from each finding of the diagnosis to what it is about, a room where it names no body", () => {
  const host = document.createElement("div");
  const found = (ids: string[], of: string | null): never => ({ rule: "unreachable", severity: "error", room: of, ids, amount: 0, message: "no way" }) as never;
  const issues = [found([], "den"), found(["den/sofa_1"], "den"), found([], null)];
  const chosen: unknown[] = [];
  showFindings(host, issues, scene([room("den", [0, 0, 4, 3])]), (issue) => chosen.push(issue));
  for (const one of host.querySelectorAll("button")) one.click();
  expect(chosen).toEqual(issues.slice(0, 2));
});
