/** Draws walls cut at a height: one mesh for all that is solid, one for the glass. */
import { Group, Mesh } from "three";
import { clipBelow } from "./boxes";
import { castingMaterial } from "./casting";
import { mergeQuads, quadsOf, type ColoredQuad } from "./quad_mesh";
import type { Room } from "../contract";
import { finishOf, outerPiecesOf, type Finish, type OuterPanel } from "./finishes";
import { facesOf, SKIRTING, type Face } from "./wall_faces";
import { faceMaterial } from "./wall_shader";
import type { WallPanel } from "./wall_panel";
import { heightAt, type WallCut } from "./wall_cut";
import { fittingsOf, wallPanelsOf, type Surface, type WallPart, type WallPlan } from "./walls";

/** Outside, and where a room does not say. */
const WALL: Finish = { type: "plaster", color: "#e3dfd8" };
const PLINTH = "#97938c";
const REVEAL = "#e9e4da";
const SKIRTING_BOARD = "#f3f0e9";
/** What each finish is drawn with; one that is not known is plain. */
const FINISHES: Readonly<Record<string, { readonly pattern: string; readonly roughness: number; readonly skirted: boolean }>> = {
  plaster: { pattern: "plaster", roughness: 0.95, skirted: true },
  wallpaper: { pattern: "wallpaper", roughness: 0.9, skirted: true },
  wood: { pattern: "panelling", roughness: 0.7, skirted: true },
  tile: { pattern: "wall_tile", roughness: 0.35, skirted: false },
  brick: { pattern: "brick", roughness: 0.95, skirted: false },
  concrete: { pattern: "cast", roughness: 0.9, skirted: false },
};
/** The cut through a wall is drawn darker than its face, as in a section drawing. */
const CUT = "#5b5f66";
const COLORS: Readonly<Record<Surface, string>> = { railing: "#8a7a66", frame: "#f1ede4", threshold: "#8a7152", glass: "#9fd0ee" };

const PANE_ROUGHNESS = 0.15;
const GLASS = { transparent: true, opacity: 0.38, depthWrite: false } as const;

/** A house's walls, to be drawn at any height. */
export class Walls {
  readonly #rooms: readonly Room[];
  readonly #panels: readonly OuterPanel[];
  readonly #fittings: readonly WallPart[];

  constructor(plan: WallPlan) {
    this.#rooms = plan.rooms ?? [];
    this.#panels = wallPanelsOf(plan).flatMap((panel) => outerPiecesOf(panel, this.#rooms));
    this.#fittings = fittingsOf(plan);
  }

  /** Meshes of the walls as they are cut: what is solid, then the glass. The caller disposes of them. */
  meshes(cut: WallCut): Group {
    // Where a wall is lower than the one that it runs into, or than its next piece, its end is seen.
    const ends = cut.before.size > 0 ? { openStart: true, openEnd: true } : {};
    const stone = this.#panels.flatMap((panel) => facesOf({ ...panel, ...ends }, heightAt(cut, panel.outward, panel.elevation))
      .map((face) => this.#colored(face, panel)));
    const solid = new Mesh(mergeQuads([...stone, ...this.#boxes(cut, ["railing", "frame", "threshold"])]), faceMaterial("wall"));
    Object.assign(solid, { castShadow: true, receiveShadow: true, customDepthMaterial: castingMaterial("wall shadow") });
    const panes = new Mesh(mergeQuads(this.#boxes(cut, ["glass"]).map((quad) => ({ ...quad, roughness: PANE_ROUGHNESS }))), faceMaterial("glass", GLASS));
    return new Group().add(solid, panes);
  }

  #colored(face: Face, panel: WallPanel): ColoredQuad {
    const { corners, normal, cut } = face;
    const isSide = normal[1] === 0 && normal[panel.axis === "x" ? 0 : 2] === 0;
    if (!isSide) return { corners, normal, color: cut || this.#isBared(face, panel) ? CUT : REVEAL };
    const finish = finishOf(face, panel, this.#rooms) ?? WALL;
    const look = FINISHES[finish.type];
    const low = Math.max(corners[0][1], corners[2][1]) <= panel.elevation + SKIRTING;
    if (low && finish === WALL) return { corners, normal, color: PLINTH };
    if (low && look?.skirted) return { corners, normal, color: SKIRTING_BOARD, roughness: 0.6 };
    return look ? { corners, normal, color: finish.color, pattern: look.pattern, roughness: look.roughness } : { corners, normal, color: finish.color };
  }

  /** Whether an end is seen only because what it runs into is lower: then it is cut as well. */
  #isBared({ corners, normal }: Face, { axis, along, openStart, openEnd }: WallPanel): boolean {
    const which = axis === "x" ? 0 : 2;
    const isAt = (end: number): boolean => corners[0][which] === end;
    return normal[which] < 0 ? !openStart && isAt(along.from) : normal[which] > 0 && !openEnd && isAt(along.to);
  }

  #boxes(cut: WallCut, surfaces: readonly Surface[]): ColoredQuad[] {
    return this.#fittings.filter(({ surface }) => surfaces.includes(surface)).flatMap(({ surface, box, window }) => {
      const low = clipBelow(box, heightAt(cut, window?.outward, window?.elevation ?? 0));
      return low ? quadsOf(low, COLORS[surface]) : [];
    });
  }
}
