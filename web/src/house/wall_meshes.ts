/** Draws walls cut at a height: one mesh for all that is solid, one for the glass. */
import { Group, Mesh, MeshStandardMaterial } from "three";
import { clipBelow } from "./boxes";
import { mergeQuads, quadsOf, type ColoredQuad } from "./quad_mesh";
import type { Room } from "../contract";
import { finishOf } from "./finishes";
import { keptMaterial } from "./kept";
import { facesOf, type Face } from "./wall_faces";
import { fittingsOf, wallPanelsOf, type Surface, type WallPanel, type WallPart, type WallPlan } from "./walls";

const WALL = "#dcd5c9";
/** The cut through a wall is drawn darker than its face, as in a section drawing. */
const CUT = "#454b55";
const COLORS: Readonly<Record<Surface, string>> = { railing: "#8a7a66", frame: "#f1ede4", glass: "#9fd0ee" };

function glass(): MeshStandardMaterial {
  return new MeshStandardMaterial({ vertexColors: true, transparent: true, opacity: 0.38, roughness: 0.15, depthWrite: false });
}

/** A house's walls, to be drawn at any height. */
export class Walls {
  readonly #rooms: readonly Room[];
  readonly #panels: readonly WallPanel[];
  readonly #fittings: readonly WallPart[];

  constructor(plan: WallPlan) {
    this.#rooms = plan.rooms ?? [];
    this.#panels = wallPanelsOf(plan);
    this.#fittings = fittingsOf(plan);
  }

  /** Meshes of the walls up to `height` [m] above the ground: what is solid, then the glass. The caller disposes of them. */
  meshes(height: number): Group {
    const stone = this.#panels.flatMap((panel) => facesOf(panel, height).map((face) => this.#colored(face, panel)));
    const solid = new Mesh(
      mergeQuads([...stone, ...this.#boxes(height, ["railing", "frame"])]),
      keptMaterial("wall", () => new MeshStandardMaterial({ vertexColors: true, roughness: 0.95 })),
    );
    solid.castShadow = true;
    solid.receiveShadow = true;
    const panes = new Mesh(
      mergeQuads(this.#boxes(height, ["glass"])),
      keptMaterial("glass", glass),
    );
    return new Group().add(solid, panes);
  }

  #colored(face: Face, panel: WallPanel): ColoredQuad {
    const color = face.cut ? CUT : (finishOf(face, panel, this.#rooms) ?? WALL);
    return { corners: face.corners, normal: face.normal, color };
  }

  #boxes(height: number, surfaces: readonly Surface[]): ColoredQuad[] {
    return this.#fittings.filter(({ surface }) => surfaces.includes(surface)).flatMap(({ surface, box }) => {
      const low = clipBelow(box, height);
      return low ? quadsOf(low, COLORS[surface]) : [];
    });
  }
}
