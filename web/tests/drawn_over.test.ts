// @vitest-environment happy-dom
/** Pictures are drawn over, other files read; a sheet that shows all still does when its size changes. */
import { afterEach, expect, it, vi } from "vitest";
import { cornersOfBox } from "../src/draw/corners";
import { EMPTY, withRoom, type Draft } from "../src/draw/draft";
import { Sheet, type Marks, type Picture } from "../src/draw/sheet";
import { Files } from "../src/panel/files";

afterEach(() => { vi.unstubAllGlobals(); });

it("hands on pictures to be drawn over, and reads drawings that are called images", async () => {
  vi.stubGlobal("fetch", () => Promise.reject(new Error("nobody is asked")));
  document.body.innerHTML = '<div id="files"><input id="file" type="file" /><div class="export"><select id="export_format"></select></div></div><div id="drop"></div>';
  const files = new Files(document.querySelector("#files") as HTMLElement, document.querySelector("#drop") as HTMLElement, () => null, (_, act) => act());
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
