/** Rooms for tests, made by hand. */
import type { Furniture, Opening, Room, Scene } from "../src/contract";

export function room(id: string, [x, z, width, depth]: readonly [number, number, number, number], more: Partial<Room> = {}): Room {
  return {
    id, index: 0, type: "bedroom", level: 0, x, z, width, depth, outline: null, outdoor: false,
    flooring: { type: "wood", color: "#c49a6c" }, accent: "#336699",
    wall_flags: { north: true, south: true, east: true, west: true },
    openings: [], furniture: [], decorations: [], ...more,
  };
}

export function opening(more: Partial<Opening>): Opening {
  return {
    id: "door_1", kind: "door", wall: "south", position: 2, width: 0.9, height: 2.1, sill: 0, connects_to: "hallway_0",
    hinge: "start", swing: "in", main_entrance: false, render_panel: true, ...more,
  };
}

export function piece(id: string, more: Partial<Furniture> = {}): Furniture {
  return { id, name: "sofa", category: "seating", x: 1, y: 0, z: 1, rotation: 0, width: 2, depth: 0.9, height: 0.85, color: "#2e8b57", ...more };
}

export function scene(rooms: readonly Room[], more: Partial<Scene> = {}): Scene {
  return {
    seed: 1, size: { width: 10, depth: 10, height: 2.8 }, wall_thickness: 0.1,
    levels: [{ index: 0, elevation: 0, height: 2.8 }], rooms, dynamic: [], ...more,
  };
}
