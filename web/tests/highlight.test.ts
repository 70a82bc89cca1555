// @vitest-environment happy-dom
import { describe, expect, it, vi } from "vitest";
import { Reading } from "../src/panel/reading";
import { tokensOf, writeHighlighted } from "../src/panel/highlight";

const LINES = [
  "# Compose house: seed 42",
  "floor_plan:",
  "  size: 20 × 15m",
  "    position: [5.7, 0.0]",
  "    size: 5.7 × 5.6m   # 31.4 m² clear",
  "      - wall: south    # → hallway_0",
  "      - sofa: [2.85, 0.50]   # 2.2×0.9×0.85m",
  "  - hallway_0 ↔ living_room_8",
  "    name: \"a # in quotes\"",
  "",
  "   ",
  "-",
  "  odd: {a: <img src=x onerror=alert(1)>}",
];

const kinds = (line: string): string[] => tokensOf(line).filter((token) => token.kind !== "space").map(({ kind, text }) => `${kind} ${text}`);

describe("tokens", () => {
  it("joined are the line", () => {
    for (const line of LINES) expect(tokensOf(line).map((token) => token.text).join("")).toBe(line);
  });

  it("tell keys, numbers, marks and comments", () => {
    expect(kinds("      - sofa: [2.85, 0.50]   # 2.2×0.9×0.85m")).toEqual([
      "punctuation - ", "key sofa", "punctuation :", "punctuation [", "number 2.85", "punctuation ,", "number 0.50", "punctuation ]",
      "comment # 2.2×0.9×0.85m",
    ]);
    expect(kinds("  size: 20 × 15m")).toEqual(["key size", "punctuation :", "number 20", "punctuation ×", "number 15m"]);
    expect(kinds("    type: living_room")).toEqual(["key type", "punctuation :", "text living_room"]);
  });
});

describe("writing", () => {
  it("never makes markup of a line", () => {
    const line = document.createElement("div");
    writeHighlighted("  - <img src=x onerror=alert(1)>: [1, 2]   # <b>bold</b>", line);
    expect(line.textContent).toBe("  - <img src=x onerror=alert(1)>: [1, 2]   # <b>bold</b>");
    expect([...line.querySelectorAll("*")].every((node) => node.tagName === "SPAN")).toBe(true);
  });
});

describe("the reading panel", () => {
  const text = "rooms:\n  - sofa: [1, 2]\n\n  - bed: [3, 4]\n";
  const lines = [null, "a/sofa_1", null, "a/bed_1"];

  function panel(): { host: HTMLElement; reading: Reading; chosen: string[] } {
    vi.stubGlobal("requestAnimationFrame", (act: FrameRequestCallback) => (act(0), 0));
    vi.stubGlobal("ResizeObserver", class { observe = (): void => undefined; });
    document.body.innerHTML =
      '<aside id="reading"><button id="flag"></button><button id="reading_toggle" aria-expanded="true"></button>' +
      '<input id="find" /><span id="find_words"></span><div id="yaml"></div></aside>';
    const host = document.getElementById("yaml") as HTMLElement;
    vi.spyOn(host, "clientHeight", "get").mockReturnValue(400);
    const reading = new Reading(host);
    const chosen: string[] = [];
    reading.onChoose = (id) => chosen.push(id);
    reading.show({ text, lines });
    return { host, reading, chosen };
  }

  it("makes no lines while it is folded away, and those of the last text once it is seen", () => {
    let [height, seen] = [0, (): void => undefined];
    const { host } = panel();
    vi.stubGlobal("ResizeObserver", class { constructor(act: () => void) { seen = act; } observe = (): void => undefined; });
    vi.spyOn(host, "clientHeight", "get").mockImplementation(() => height);
    host.replaceChildren();
    const folded = new Reading(host);
    folded.show({ text: "rooms:\n", lines: [null] });
    folded.show({ text, lines });
    seen();
    expect(host.children).toHaveLength(0);
    height = 400;
    seen();
    expect(host.children).toHaveLength(4);
    expect(host.textContent).toContain("sofa");
  });

  it("shows every line, those of bodies as buttons", () => {
    const { host } = panel();
    expect(host.children).toHaveLength(4);
    expect([...host.querySelectorAll("button")].map((button) => button.dataset.id)).toEqual(["a/sofa_1", "a/bed_1"]);
  });

  it("says which line was clicked, also on a token of it", () => {
    const { host, chosen } = panel();
    host.querySelector<HTMLElement>("button .yaml-key")?.click();
    expect(chosen).toEqual(["a/sofa_1"]);
  });

  it("marks the selected body's line and only that", () => {
    const { host, reading } = panel();
    reading.select("a/bed_1");
    const pressed = (): string[] => [...host.querySelectorAll("button")].map((button) => button.getAttribute("aria-pressed") ?? "");
    expect(pressed()).toEqual(["false", "true"]);
    reading.select(null);
    expect(pressed()).toEqual(["false", "false"]);
  });

  it("brings a line into view as it lies once the lines around it have their colours", () => {
    const { host, reading } = panel();
    vi.stubGlobal("requestAnimationFrame", () => 0); // the frame that gives them comes later
    reading.show({ text: text.replaceAll(",", ", 7,"), lines });
    const [, sofa, , bed] = [...host.children] as HTMLElement[];
    const lies = (): number => 385 + (sofa?.querySelector(".yaml-key") ? 20 : 0); // coloured, the sofa's line breaks
    vi.spyOn(bed as HTMLElement, "getBoundingClientRect").mockImplementation(() => new DOMRect(0, lies(), 100, 10));
    reading.select("a/bed_1");
    expect(host.scrollTop).toBe(15);
  });

  it("keeps what has not changed, and the flags on what has", () => {
    const { host, reading } = panel();
    reading.flag(new Set(["a/bed_1"]));
    const [title, , , bed] = [...host.children];
    reading.show({ text: "rooms:\n  - sofa: [1, 5]\n\n  - bed: [3, 4]\n", lines });
    expect([host.children[0], host.children[3]]).toEqual([title, bed]);
    expect(host.children[1]?.textContent).toBe("  - sofa: [1, 5]");
    reading.show({ text: "rooms:\n  - bed: [9, 9]\n", lines: [null, "a/bed_1"] });
    expect([...host.children].map((line) => line.hasAttribute("data-flagged"))).toEqual([false, true]);
  });

  it("flags the selected body, by the button", () => {
    const { reading } = panel();
    const asked: string[] = [];
    reading.onFlag = (id) => asked.push(id);
    const flag = document.getElementById("flag") as HTMLButtonElement;
    expect(flag.disabled).toBe(true);
    flag.click();
    reading.select("a/bed_1");
    flag.click();
    flag.click();
    expect(asked).toEqual(["a/bed_1", "a/bed_1"]);
    reading.flag(new Set(["a/bed_1"]));
    expect(flag.getAttribute("aria-pressed")).toBe("true");
    reading.select("a/sofa_1");
    expect(flag.getAttribute("aria-pressed")).toBe("false");
  });

  it("has one stop for the Tab key and goes on with the arrows", () => {
    const { host } = panel();
    const [first, second] = [...host.querySelectorAll("button")];
    expect([first?.tabIndex, second?.tabIndex]).toEqual([0, -1]);
    first?.focus();
    first?.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowDown", bubbles: true }));
    expect(document.activeElement).toBe(second);
    expect([first?.tabIndex, second?.tabIndex]).toEqual([-1, 0]);
  });
});
