// @vitest-environment happy-dom
/** Pictures are drawn over, other files read; a sheet that shows all still does when its size changes. */
import { afterEach, expect, it, vi } from "vitest";
import { cornersOfBox } from "../src/draw/corners";
import { EMPTY, withRoom, type Draft } from "../src/draw/draft";
import { DrawnPlan } from "../src/draw/drawn_plan";
import { Pencil } from "../src/draw/pencil";
import { Sheet, type Marks, type Picture } from "../src/draw/sheet";
import { fileName, Files } from "../src/panel/files";

afterEach(() => { vi.unstubAllGlobals(); });

it("hands on pictures to be drawn over, and reads drawings that are called images", async () => {
  vi.stubGlobal("fetch", () => Promise.reject(new Error("nobody is asked")));
  document.body.innerHTML = '<div id="files"><input id="file" type="file" /><div class="export"><select id="export_format"></select></div></div><div id="drop"></div>';
  const files = new Files(document.querySelector("#files") as HTMLElement, document.querySelector("#drop") as HTMLElement, () => Promise.resolve(null), (_, act) => act());
  const [over, read]: [string[], string[]] = [[], []];
  files.onPicture = ({ name }) => { over.push(name); };
  files.onOpen = ({ name }) => { read.push(name); };
  for (const [name, type] of [["scan.png", "image/png"], ["photo.jpg", "image/jpeg"], ["plan.svg", "image/svg+xml"], ["plan.dxf", "image/vnd.dxf"], ["home.yaml", ""]] as const) {
    const drop = new Event("drop", { cancelable: true });
    Object.assign(drop, { dataTransfer: { files: [new File(["x"], name, { type })], types: ["Files"] } });
    window.dispatchEvent(drop);
  }
  await vi.waitFor(() => { expect(read).toHaveLength(3); });
  expect([over, read]).toEqual([["scan.png", "photo.jpg"], ["plan.svg", "plan.dxf", "home.yaml"]]);
});

it("names files by the seed, and those of a plan, which has none, as that", () => {
  const names = [7, null].map((seed) => fileName({ seed }, "json"));
  expect(names).toEqual(["house_7.json", "house.json"]);
});

const PICTURE: Picture = { url: "data:,", width: 1000, height: 3000, scale: 12, opacity: 0.5 };
const MARKS: Marks = {
  room: null, opening: null, ghost: null, wrong: new Set(), furnished: new Map(), measured: [], picture: null,
  names: () => "", areas: new Map(), colors: () => "#ffffff",
};

/** A sheet of a size that changes, and what of the plan is seen of it [mm]. */
function laid(): { sheet: Sheet; resize: (width: number, height: number, of?: "window" | "sheet") => void; seen: () => { x0: number; z0: number; x1: number; z1: number } } {
  let resized = (): void => undefined;
  vi.stubGlobal("ResizeObserver", class { constructor(told: () => void) { resized = told; } observe(): void { /* told by `resize` */ } });
  document.body.innerHTML = "<div></div>";
  const sheet = new Sheet(document.querySelector("div") as HTMLElement);
  let size = { left: 0, top: 0, width: 800, height: 600 };
  sheet.svg.getBoundingClientRect = () => size as DOMRect;
  Object.defineProperty(sheet.svg, "clientWidth", { get: () => size.width });
  const resize = (width: number, height: number, of: "window" | "sheet" = "window"): void => {
    size = { ...size, width, height };
    if (of === "window") window.dispatchEvent(new Event("resize"));
    resized();
  };
  const seen = () => {
    const [x = 0, z = 0, width = 0, height = 0] = (sheet.svg.getAttribute("viewBox") ?? "").split(" ").map(Number);
    return { x0: x, z0: z, x1: x + width, z1: z + height };
  };
  return { sheet, resize, seen };
}

const drawn = (x1: number, z1: number): Draft => withRoom(EMPTY, cornersOfBox({ x0: 0, z0: 0, x1, z1 }))?.draft ?? EMPTY;
const holds = (box: { x0: number; z0: number; x1: number; z1: number }, x1: number, z1: number): boolean => box.x0 <= 0 && box.z0 <= 0 && box.x1 >= x1 && box.z1 >= z1;

it("keeps a plan in view when the window becomes smaller, until the sheet is moved", () => {
  const { sheet, resize, seen } = laid();
  sheet.draw(drawn(12_000, 9_000), MARKS);
  sheet.fit(drawn(12_000, 9_000), null);
  expect(holds(seen(), 12_000, 9_000)).toBe(true);
  sheet.draw(drawn(13_000, 9_000), MARKS); // drawn on since
  resize(300, 60);
  expect(holds(seen(), 13_000, 9_000)).toBe(true);
  const fitted = sheet.perPixel;
  resize(300, 90, "sheet"); // as by a row of tools more: what is being drawn stays where it is
  expect(sheet.perPixel).toBe(fitted);
  sheet.zoom(8, { clientX: 150, clientY: 60 });
  const scale = sheet.perPixel;
  resize(900, 700);
  expect(sheet.perPixel).toBe(scale);
});

it("shows all of a picture that lies on an empty sheet", () => {
  const { sheet, seen } = laid();
  sheet.draw(EMPTY, { ...MARKS, picture: PICTURE });
  sheet.fit(EMPTY, PICTURE);
  expect(holds(seen(), 12_000, 36_000)).toBe(true);
});

it("comes nearer and moves under two fingers, and forgets what the first one began", () => {
  const { sheet } = laid();
  sheet.svg.setPointerCapture = () => undefined;
  const plan = new DrawnPlan(EMPTY);
  plan.step(drawn(36_000, 24_000));
  sheet.draw(plan.draft, MARKS);
  sheet.fit(plan.draft, null);
  let measured: readonly unknown[] = [];
  const pencil = new Pencil(sheet, plan, { ghost: () => undefined, measured: (points) => { measured = points; }, said: () => undefined });
  const touch = (what: "down" | "move" | "up", pointerId: number, clientX: number, clientY: number): void => {
    sheet.svg.dispatchEvent(new PointerEvent(`pointer${what}`, { pointerId, clientX, clientY, button: 0, bubbles: true, cancelable: true }));
  };
  const before = plan.settled;
  const north = sheet.seen({ x: 18_000, z: 0 });
  for (const tool of ["room", "door", "measure", "choose"] as const) {
    pencil.tool = tool;
    const [held, perPixel] = [sheet.at({ clientX: 400, clientY: 300 }), sheet.perPixel];
    touch("down", 1, 350, tool === "door" ? sheet.seen({ x: 18_000, z: 0 }).y : 300);
    touch("move", 1, 350, 300);
    touch("down", 2, 450, 300);
    touch("move", 1, 300, 320);
    touch("move", 2, 500, 320);
    expect(sheet.perPixel / perPixel).toBeCloseTo(0.5, 6);
    expect(sheet.at({ clientX: 400, clientY: 320 })).toEqual({ x: expect.closeTo(held.x, 6), z: expect.closeTo(held.z, 6) });
    touch("up", 1, 300, 320);
    touch("move", 2, 700, 500);
    touch("up", 2, 700, 500);
    expect([plan.settled, measured, sheet.perPixel / perPixel]).toEqual([before, [], expect.closeTo(0.5, 6)]);
    sheet.fit(plan.draft, null);
  }
  expect(sheet.seen({ x: 18_000, z: 0 })).toEqual(north);
  touch("down", 1, 400, 300);
  touch("down", 1, 400, 300); // of one finger that was lifted unseen: it is no second one
  touch("move", 1, 420, 300);
  touch("up", 1, 420, 300);
  expect(sheet.seen({ x: 18_000, z: 0 })).toEqual({ x: expect.closeTo(north.x + 20, 6), y: expect.closeTo(north.y, 6) });
});
