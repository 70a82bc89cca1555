import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { readableAt } from "../src/plan/readable";
import { blend, frame, PRESETS, windowOf, type Vector, type Window } from "../src/view/cameras";

const box = (wide: number, deep: number): Vector[] => [0, wide].flatMap((x) => [0, 1].flatMap((y) => [0, deep].map((z): Vector => [x, y, z])));
const CORNERS = box(20, 15);
/** The switch of views of a page. */
const VIEWS = { offsetLeft: 12, offsetWidth: 370, offsetHeight: 32 };

function seen(preset: keyof typeof PRESETS, aspect: number, covered: Omit<Window, "aspect"> = {}, points = CORNERS): Vector3[] {
  const { eye, target, fov } = frame(points, PRESETS[preset], { aspect, ...covered });
  const camera = new PerspectiveCamera(fov, aspect, 0.1, 1000);
  camera.position.set(...eye);
  camera.lookAt(new Vector3(...target));
  camera.updateMatrixWorld();
  return points.map((corner) => new Vector3(...corner).project(camera));
}

/** Whether something of a box is seen where the switch of views is: points all over its sides and within it are looked at; `about`: or so near to it [px]. */
function isBehind(corners: readonly Vector3[], width: number, height: number, about = 0): boolean {
  const shares = Array.from({ length: 41 }, (_, step) => step / 40);
  const between = corners.flatMap((one) => corners.flatMap((other) => shares.map((share) => one.clone().lerp(other, share))));
  return between.some(({ x, y }) => ((1 + x) / 2) * width < VIEWS.offsetLeft + VIEWS.offsetWidth + about && ((1 + y) / 2) * height < 48 + about);
}

describe("a preset", () => {
  it("shows the whole house, filling the view, whatever the window's shape", () => {
    for (const preset of ["top", "corner"] as const) {
      for (const aspect of [0.5, 1, 1.8]) {
        const widest = Math.max(...seen(preset, aspect).flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]));
        expect(widest, `${preset} ${aspect}`).toBeLessThan(1);
        expect(widest, `${preset} ${aspect}`).toBeGreaterThan(0.85);
      }
    }
  });

  it("leaves room around the house for the lengths of its plan: on all sides, else on two, where they can be read, and else for nothing", () => {
    const cases = [
      [1800, 1200, CORNERS, true, true], [1136, 815, CORNERS, true, true], [1136, 680, CORNERS, false, true], [700, 500, CORNERS, false, false],
      [1016, 665, box(30, 9), true, false],
    ] as const;
    for (const [width, height, points, north, west] of cases) {
      const { aspect, ...covered } = windowOf({ width, height }, VIEWS);
      const at = seen("plan", aspect, covered, points).map(({ x, y }) => [((1 + x) / 2) * width, ((1 - y) / 2) * height] as const);
      const [xs, ys] = [at.map(([x]) => x), at.map(([, y]) => y)];
      const free = [Math.min(...ys) - 52, Math.min(...xs), height - 60 - Math.max(...ys), width - Math.max(...xs)]; // under the toolbar, over the view's buttons
      const pixels = (Math.max(...xs) - Math.min(...xs)) / Math.max(...points.map(([x]) => x)) / 1000;
      expect(readableAt(pixels).lengths, `${width}`).toBe(north || west);
      const wanted = [north ? 124 : 10, west ? 124 : 10, north ? 90 : 10, west ? 90 : 10];
      free.forEach((one, side) => expect(one, `${width}, side ${side}`).toBeGreaterThan(wanted[side] ?? 0));
      if (!north && !west) expect(readableAt(pixels * 1.6).lengths, `${width}`).toBe(true);
      if (north && !west) expect(Math.max(...xs) - Math.min(...xs), `${width}`).toBeGreaterThan(0.85 * width);
    }
  });

  it("leaves as much beside the house on both sides, and nothing of it under what lies over the top", () => {
    for (const aspect of [0.5, 1, 1.8]) {
      const at = seen("corner", aspect, { covered: 0.08 });
      const [xs, ys] = [at.map(({ x }) => x), at.map(({ y }) => y)];
      expect(Math.max(...ys), `${aspect}`).toBeLessThan(1 - 2 * 0.08);
      expect(Math.min(...ys), `${aspect}`).toBeGreaterThan(-1);
      const tight = Math.max(...xs.map(Math.abs)) > 0.9 || Math.max(...ys) - Math.min(...ys) > 2 * 0.92 * 0.9;
      expect(tight, `${aspect}`).toBe(true);
    }
  });

  it("shows nothing on a phone's canvas under the toolbar and the switch of views", () => {
    for (const [width, height] of [[390, 505], [390, 412]] as const) {
      const { aspect, ...covered } = windowOf({ width, height }, VIEWS);
      const ys = seen("corner", aspect, covered, box(6, 24)).map(({ y }) => ((1 - y) / 2) * height);
      expect(Math.min(...ys)).toBeGreaterThan(66);
      expect(Math.max(...ys)).toBeLessThan(height - 60);
    }
  });

  it("shows nothing under a switch of views that has rows of its own for storeys", () => {
    const [width, height, views] = [390, 505, { offsetLeft: 12, offsetWidth: 366, offsetHeight: 80 }];
    const { aspect, ...covered } = windowOf({ width, height }, views);
    for (const preset of ["corner", "top"] as const) expect(Math.max(...seen(preset, aspect, covered).map(({ y }) => ((1 - y) / 2) * height)), preset).toBeLessThan(height - 92);
  });

  it("shows nothing under the switch of views in the corner of a wider canvas, and is as near as without one where nothing would be", () => {
    const homes = [box(20, 15), box(10, 12), box(30, 9), box(9, 30)];
    const lower = homes.flatMap((home) => [[760, 713], [700, 500], [640, 354], [1016, 767], [1400, 900]].filter(([width = 1, height = 1]) => {
      const [{ aspect, ...window }, bare] = [windowOf({ width, height }, VIEWS), windowOf({ width, height }, null)];
      const [at, plain] = [seen("corner", aspect, window, home), seen("corner", aspect, bare, home)];
      expect(isBehind(at, width, height), `${width}`).toBe(false);
      if (!isBehind(plain, width, height, 20)) expect(at, `${width}`).toEqual(plain);
      return isBehind(plain, width, height);
    }));
    expect(lower.length).toBeGreaterThan(2);
    expect(lower.length).toBeLessThan(18);
  });

  it("fills a phone's canvas with the plan's rooms, without the sheet round them", () => {
    const { aspect, ...covered } = windowOf({ width: 390, height: 505 }, VIEWS);
    const at = seen("plan", aspect, covered);
    expect(Math.max(...at.map(({ x }) => Math.abs(x)))).toBeGreaterThan(0.9);
    expect(Math.max(...at.flatMap(({ x, y }) => [Math.abs(x), Math.abs(y)]))).toBeLessThan(1);
  });

  it("from the top has north up and east to the right", () => {
    const { eye, target, fov } = frame(CORNERS, PRESETS.top, { aspect: 1.5 });
    const camera = new PerspectiveCamera(fov, 1.5, 0.1, 1000);
    camera.position.set(...eye);
    camera.lookAt(new Vector3(...target));
    camera.updateMatrixWorld();
    const at = (x: number, z: number): Vector3 => new Vector3(x, 0, z).project(camera);
    expect(at(10, 0).y).toBeGreaterThan(at(10, 15).y);
    expect(at(20, 7).x).toBeGreaterThan(at(0, 7).x);
  });

  it("flies from one framing to the other", () => {
    const [a, b] = [frame(CORNERS, PRESETS.top, { aspect: 1 }), frame(CORNERS, PRESETS.corner, { aspect: 1 })];
    expect(blend(a, b, 0)).toEqual(a);
    expect(blend(a, b, 1).eye[0]).toBeCloseTo(b.eye[0], 9);
  });
});
