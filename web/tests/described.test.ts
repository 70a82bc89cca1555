/**
 * What the page builds of homes, written down for the test that compares it with what is exported of them.
 *
 * Not a test of its own: it runs where COMPOSE_DESCRIBE names a file of {catalog, scenes}, and writes beside it.
 */
import { readFileSync, writeFileSync } from "node:fs";
import { expect, it } from "vitest";
import type { Catalog, Scene } from "../src/contract";
import { clearFloorOf } from "../src/house/clear_floor";
import { leavesOf } from "../src/house/door_leaves";
import { partsOfLeaf } from "../src/house/door_shapes";
import { drawable } from "../src/house/drawable";
import { bodiesOf, storeysOf, styleOf } from "../src/house/frame";
import { openingsOf } from "../src/house/openings";
import { ShapeBook } from "../src/house/shapes";
import { runsOf } from "../src/house/wall_runs";
import { fittingsOf, wallPanelsOf, type WallPlan } from "../src/house/walls";

const given = process.env.COMPOSE_DESCRIBE;

function described(scene: Scene, book: ShapeBook): unknown {
  const plan: WallPlan = {
    runs: runsOf(scene.rooms, scene.wall_thickness), openings: openingsOf(scene.rooms, scene.wall_thickness), storeys: storeysOf(scene), rooms: scene.rooms,
  };
  const paints = book.doorPaints(styleOf(scene));
  return {
    floors: scene.rooms.map((room) => clearFloorOf(room, plan.runs, scene.wall_thickness)),
    panels: wallPanelsOf(plan),
    fittings: fittingsOf(plan),
    openings: plan.openings,
    leaves: leavesOf(plan).map((leaf) => ({ ...leaf, parts: partsOfLeaf(leaf, paints) })),
    bodies: bodiesOf(scene).map((body) => ({ ...body, parts: book.partsOf(body, styleOf(scene)) })),
  };
}

it.runIf(given)("describes homes", () => {
  const { catalog, scenes } = JSON.parse(readFileSync(given as string, "utf8")) as { catalog: Catalog; scenes: Scene[] };
  const book = new ShapeBook(catalog);
  writeFileSync(`${given}.page`, JSON.stringify(scenes.map((scene) => described(drawable(scene, catalog), book))));
  expect(scenes.length).toBeGreaterThan(0);
});
