import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { readableAt } from "../src/plan/readable";
import { blend, frame, PRESETS, windowOf, type Vector, type Window } from "../src/view/cameras";

const CORNERS: Vector[] = [0, 20].flatMap((x) => [0, 1].flatMap((y) => [0, 15].map((z): Vector => [x, y, z])));

function seen(preset: keyof typeof PRESETS, aspect: number, covered: Omit<Window, "aspect"> = {}): Vector3[] {
  const { eye, target, fov } = frame(CORNERS, PRESETS[preset], { aspect, ...covered });
  const camera = new PerspectiveCamera(fov, aspect, 0.1, 1000);
  camera.position.set(...eye);
  camera.lookAt(new Vector3(...target));
  camera.updateMatrixWorld();
  return CORNERS.map((corner) => new Vector3(...corner).project(camera));
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

  it("leaves room around the house for the lengths of its plan, where they can be read, and else for nothing", () => {
    for (const [width, height, isSized] of [[1800, 1200, true], [1136, 815, true], [1136, 680, false], [700, 500, false]] as const) {
      const { aspect, ...covered } = windowOf({ width, height });
      const at = seen("plan", aspect, covered).map(({ x, y }) => [((1 + x) / 2) * width, ((1 - y) / 2) * height] as const);
      const [xs, ys] = [at.map(([x]) => x), at.map(([, y]) => y)];
      const free = [Math.min(...ys) - 52, Math.min(...xs), height - 60 - Math.max(...ys), width - Math.max(...xs)]; // under the toolbar, over the view's buttons
      const pixels = (Math.max(...xs) - Math.min(...xs)) / 20 / 1000;
      expect(readableAt(pixels).lengths, `${width}`).toBe(isSized);
      const wanted = isSized ? [124, 124, 90, 90] : [10, 10, 10, 10];
      free.forEach((one, side) => expect(one, `${width}, side ${side}`).toBeGreaterThan(wanted[side] ?? 0));
      if (!isSized) expect(readableAt(pixels * 1.6).lengths, `${width}`).toBe(true);
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
    const [width, height] = [390, 505];
    const { aspect, ...covered } = windowOf({ width, height });
    const ys = seen("corner", aspect, covered).map(({ y }) => ((1 - y) / 2) * height);
    expect(Math.min(...ys)).toBeGreaterThan(52);
    expect(Math.max(...ys)).toBeLessThan(height - 60);
    expect(windowOf({ width: 1176, height: 845 }).beneath).toBe(0);
  });

  it("fills a phone's canvas with the plan's rooms, without the sheet round them", () => {
    const { aspect, ...covered } = windowOf({ width: 390, height: 505 });
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
