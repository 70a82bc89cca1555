/**
 * What is made while the first house is awaited, in short steps: patterns, and the shaders that everything is drawn
 * with. A house that comes earlier makes the rest itself.
 */
import type { Object3D } from "three";
import type { Body, Catalog, Opening, Room, Scene } from "../contract";
import { House } from "./house";
import { makeNextPattern } from "./patterns";
import { ShapeBook } from "./shapes";
import { cutAll } from "./wall_cut";

const SIDE = 10;
const HEIGHT = 2.8;
/** One thing that is solid, one that is seen through. */
const SAMPLE: Catalog = {
  furniture: { block: { size: [1, 1, 1] } },
  decorations: { pane: { size: [1, 1, 1] } },
  shapes: { pane: [{ form: "box", x: [0, 1], y: [0, 1], z: [0, 1], material: "clear" }] },
  materials: { clear: { opacity: 0.5 } },
};

function bodiesOf(kinds: Catalog["furniture"], prefix: string): (Body & { readonly name: string; readonly kind: string })[] {
  return Object.entries(kinds).map(([key, { name, color, size: [width, depth, height] }]) => ({
    id: `${prefix}/${key}`, name: name ?? key, kind: key, x: SIDE / 2, y: 0, z: SIDE / 2, rotation: 0, width, depth, height, color: color ?? null,
  }));
}

function opening(kind: Opening["kind"], position: number): Opening {
  return { id: kind, kind, wall: "north", position, width: 1, height: 1, sill: 1 };
}

/** A room of everything that the catalog has, with a door and a window. */
export function rehearsalOf(catalog: Catalog): Scene {
  const room: Room = {
    id: "all", index: 0, type: "all", level: 0, x: 0, z: 0, width: SIDE, depth: SIDE, outdoor: false, accent: "#808080",
    flooring: { type: "wood", color: "#808080" }, wall_flags: { north: true, south: true, east: true, west: true },
    openings: [opening("door", 2), opening("window", 4)],
    furniture: bodiesOf(catalog.furniture, "furniture"),
    decorations: bodiesOf(catalog.decorations, "decorations"),
  };
  const size = { width: SIDE, depth: SIDE, height: HEIGHT };
  return { seed: 0, size, wall_thickness: 0.1, levels: [{ index: 0, elevation: 0, height: HEIGHT }], rooms: [room], dynamic: [] };
}

function houseOf(catalog: Catalog): House {
  const house = new House(rehearsalOf(catalog), new ShapeBook(catalog));
  house.cutAt(cutAll(HEIGHT / 2));
  return house;
}

function* shadersAndPatterns(prepare: (root: Object3D) => void): Generator<void> {
  prepare(houseOf(SAMPLE).root);
  yield;
  while (makeNextPattern()) yield;
}

async function inSteps(steps: Iterable<void>, wanted: () => boolean): Promise<void> {
  for (const taken of steps) {
    await new Promise((resolve) => setTimeout(resolve, 0, taken));
    if (!wanted()) return;
  }
}

/** Makes as much as is wanted before a house comes; `prepare` has shaders made without waiting for them. */
export async function rehearse(prepare: (root: Object3D) => void, wanted: () => boolean): Promise<void> {
  await inSteps(shadersAndPatterns(prepare), wanted);
}
