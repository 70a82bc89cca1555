import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { inwardOf } from "../src/house/entrance";
import { openingsOf } from "../src/house/openings";
import { EYE_HEIGHT, firstPose, gazeOf, OUTSIDE, turned, turnedToSight, walked, walkedTo, type Pose } from "../src/view/walk";
import { opening, room } from "./rooms";

const BOUNDS = { min: [0, 0, 0], max: [4, 1, 3] } as const;
const CENTRE: Pose = { eye: [2, EYE_HEIGHT, 1.5], yaw: 0, pitch: 0 };
const still = { ahead: 0, aside: 0, hurried: false };

function entered(wall: "north" | "south" | "east" | "west"): Pose {
  const rooms = [room("a", [0, 0, 4, 3], { openings: [opening({ wall, position: 1.5, main_entrance: true, connects_to: null })] })];
  const [door] = openingsOf(rooms, 0.1);
  if (!door) throw new Error("no door");
  return firstPose({ opening: door, inward: inwardOf(rooms, door) }, BOUNDS);
}

describe("a walk", () => {
  it("starts within the entrance at eye height, looking across the room", () => {
    for (const wall of ["north", "south", "east", "west"] as const) {
      const pose = entered(wall);
      const [x, y, z] = pose.eye;
      expect(y).toBe(1.6);
      expect(x > 0 && x < 4 && z > 0 && z < 3, wall).toBe(true);
      const ahead = gazeOf(pose);
      expect(Math.hypot(x + ahead[0] - 2, z + ahead[2] - 1.5), wall).toBeLessThan(Math.hypot(x - 2, z - 1.5));
      const further = walked(pose, { ...still, ahead: 1 }, 0.5, BOUNDS).eye;
      expect(Math.abs(further[0] - x) + Math.abs(further[2] - z), wall).toBeCloseTo(0.85, 6);
    }
  });

  it("turns at first to where one sees farthest, and stays straight in a room that is as deep as wide", () => {
    const straight: Pose = { eye: [0.7, EYE_HEIGHT, 1], yaw: -Math.PI / 2, pitch: 0 }; // east, to a wall at 2 m
    const beyond = turnedToSight(straight, ([x, , z]) => x < 2 && z > 0 && z < 11); // a hall that runs south
    expect(gazeOf(beyond)[2]).toBeGreaterThan(0.9);
    const slit = ([x, , z]: readonly [number, number, number]): boolean => Math.hypot(x - 0.7, z - 1) < 1 || (z > 1 && Math.abs(x - 0.7) < 0.1) || (x > 0.7 && Math.hypot(x - 0.7, z - 1) < 4);
    expect(gazeOf(turnedToSight(straight, slit))[2]).toBeLessThan(0.75); // what is seen far away through a slit fills less of a view than the room ahead
    expect(turnedToSight(straight, ([x, , z]) => Math.hypot(x - 0.7, z - 1) < 5)).toEqual(straight);
    expect(turnedToSight(straight, () => false)).toEqual(straight);
  });

  it("goes where the camera looks, and its right is the picture's right", () => {
    const pose = turned(CENTRE, 0.7, -0.3);
    const camera = new PerspectiveCamera(65, 1.5, 0.05, 100);
    camera.position.set(...pose.eye);
    camera.rotation.set(pose.pitch, pose.yaw, 0, "YXZ");
    camera.updateMatrixWorld();
    expect(camera.getWorldDirection(new Vector3()).toArray()).toEqual(gazeOf(pose).map((part) => expect.closeTo(part, 9)));
    const right = walked(pose, { ...still, aside: 1 }, 0.1, BOUNDS).eye;
    expect(new Vector3(...right).applyMatrix4(camera.matrixWorldInverse).x).toBeGreaterThan(0.1);
  });

  it("is no faster aslant, twice as fast in a hurry, and stays near the house", () => {
    const way = (stride: object): number => {
      const { eye } = walked(CENTRE, { ...still, ...stride }, 0.1, BOUNDS);
      return Math.hypot(eye[0] - CENTRE.eye[0], eye[2] - CENTRE.eye[2]);
    };
    expect(way({ ahead: 1, aside: 1 })).toBeCloseTo(way({ ahead: 1 }), 9);
    expect(way({ ahead: 1, hurried: true })).toBeCloseTo(2 * way({ ahead: 1 }), 9);
    expect(walked(CENTRE, { ...still, ahead: 1 }, 1000, BOUNDS).eye[2]).toBe(-OUTSIDE);
  });

  it("never looks over backwards", () => {
    expect(turned(CENTRE, 0, 9).pitch).toBeLessThan(Math.PI / 2);
    expect(turned(CENTRE, 0, -9).pitch).toBeGreaterThan(-Math.PI / 2);
  });

  it("begins outside, looking at the house, where there is no entrance", () => {
    const pose = firstPose(null, BOUNDS);
    const gaze = gazeOf(pose);
    expect(gaze[0] * (2 - pose.eye[0]) + gaze[2] * (1.5 - pose.eye[2])).toBeGreaterThan(0);
  });

  it("goes straight to a place that is asked for and no further", () => {
    const first = walkedTo(CENTRE, [2, -8.5], 1);
    expect(first.arrived).toBe(false);
    expect(first.pose.eye[0]).toBeCloseTo(2, 9);
    expect(first.pose.eye[2]).toBeLessThan(0);
    expect(first.pose.eye[2]).toBeGreaterThan(-8.5);
    const last = walkedTo(first.pose, [2, -8.5], 60);
    expect(last).toEqual({ arrived: true, pose: { ...CENTRE, eye: [2, EYE_HEIGHT, -8.5] } });
    expect(walkedTo(last.pose, [2, -8.5], 0).arrived).toBe(true);
  });
});
