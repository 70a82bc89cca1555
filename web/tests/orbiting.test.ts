// @vitest-environment happy-dom
import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { beforeEach, describe, expect, it } from "vitest";
import { Orbiting } from "../src/view/orbiting";

const degrees = (angle: number): number => (angle * 180) / Math.PI;
const TEN = Math.PI / 18;
let controls: OrbitControls;
let camera: PerspectiveCamera;
let orbiting: Orbiting;

/** Goes on to the end; how many frames that took. */
function finish(seconds = 1 / 60): number {
  for (let frames = 1; frames < 1000; frames += 1) if (!orbiting.step(seconds)) return frames;
  throw new Error("it never ends");
}

beforeEach(() => {
  camera = new PerspectiveCamera(30, 1, 0.1, 500);
  camera.position.set(10, 10, 0);
  controls = new OrbitControls(camera, document.createElement("canvas"));
  Object.assign(controls, { enableDamping: true, maxPolarAngle: Math.PI * 0.49, minDistance: 5, maxDistance: 20 });
  controls.update();
  orbiting = new Orbiting(controls);
});

describe("a step around the house", () => {
  it("turns by what was asked, however long frames take, and steps asked for meanwhile add up", () => {
    for (const seconds of [1 / 60, 0.25, Number.POSITIVE_INFINITY]) {
      const before = Math.atan2(camera.position.z, camera.position.x);
      orbiting.ask({ right: TEN });
      orbiting.step(1 / 60);
      orbiting.ask({ right: TEN });
      finish(seconds);
      const turned = Math.atan2(camera.position.z, camera.position.x) - before;
      expect(degrees(turned)).toBeCloseTo(20, 6);
      expect(camera.position.length()).toBeCloseTo(Math.hypot(10, 10), 6);
      expect(camera.position.y).toBeCloseTo(10, 6);
    }
  });

  it("goes higher and lower as far as the controls let it, and back from there at once", () => {
    for (let i = 0; i < 20; i += 1) orbiting.ask({ up: -TEN });
    finish();
    expect(degrees(controls.getPolarAngle())).toBeCloseTo(0.49 * 180, 3);
    expect(orbiting.ask({ up: -TEN })).toBe(false);
    orbiting.ask({ up: TEN });
    finish();
    expect(degrees(controls.getPolarAngle())).toBeCloseTo(0.49 * 180 - 10, 3);
  });

  it("comes nearer by a factor, within the controls' limits, towards what it looks at", () => {
    const direction = camera.position.clone().normalize();
    orbiting.ask({ nearer: 1.2 });
    finish();
    expect(camera.position.length()).toBeCloseTo(Math.hypot(10, 10) / 1.2, 6);
    for (let i = 0; i < 30; i += 1) orbiting.ask({ nearer: 1.2 });
    finish();
    expect(camera.position.length()).toBeCloseTo(5, 3);
    for (let i = 0; i < 30; i += 1) orbiting.ask({ nearer: 1 / 1.2 });
    finish();
    expect(camera.position.length()).toBeCloseTo(20, 3);
    expect(new Vector3().crossVectors(direction, camera.position).length()).toBeLessThan(1e-6);
  });

  it("is soon done, and nothing moves after it or after it was forgotten", () => {
    orbiting.ask({ right: TEN, up: TEN, nearer: 1.2 });
    expect(finish()).toBeLessThan(60);
    orbiting.ask({ right: TEN });
    orbiting.stop();
    const before = camera.position.clone();
    expect(orbiting.step(1)).toBe(false);
    controls.update();
    expect(camera.position.distanceTo(before)).toBeLessThan(1e-9);
  });
});
