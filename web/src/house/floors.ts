/** Floors as one mesh, with the accents of rooms inside as a thin line along their walls; ceilings. */
import { BufferGeometry, Color, Float32BufferAttribute, Mesh, ShapeUtils, Vector2 } from "three";
import type { Room } from "../contract";
import { patternLayer } from "./patterns";
import { cornersOf } from "./plan";
import { faceMaterial } from "./wall_shader";
import type { Storey } from "./walls";

const CEILING = "#f6f3ec";
/** What falls onto ceilings from the floor and from lamps: the sky above does not light them. */
const LAMPLIGHT = "#8f8b84";
const ACCENT_INSET = 0.14;
const ACCENT_WIDTH = 0.035;
const ACCENT_RISE = 0.004;
/** How much of the floor an accent hides. */
const ACCENT_OPACITY = 0.75;
/** Drawn after what stands on it: a pixel that is hidden is not lit. */
const BEHIND = 1;
const ROUGHNESS = 0.9;
/** What each flooring is drawn with, and how much of it the pattern's square covers [m]; one that is not known is plain. */
const FLOORINGS: Readonly<Record<string, { readonly pattern: string; readonly span: number }>> = {
  wood: { pattern: "planks", span: 1.2 },
  deck: { pattern: "deck", span: 1.2 },
  tile: { pattern: "wall_tile", span: 1.6 },
  stone: { pattern: "stone", span: 1.8 },
  concrete: { pattern: "concrete", span: 1.6 },
  grass: { pattern: "grass", span: 0.9 },
};

interface FloorLook {
  readonly color: Color;
  /** None leaves it plain. */
  readonly flooring?: string;
  /** Whether boards run from north to south. */
  readonly alongZ?: boolean;
}

/** Triangles that all look up, or all down. */
class FloorDraft {
  readonly positions: number[] = [];
  readonly weave: number[] = [];
  readonly colors: number[] = [];

  constructor(readonly facing: 1 | -1 = 1) {}

  add(points: readonly Vector2[], y: number, { color, flooring = "", alongZ = false }: FloorLook): void {
    const { pattern = null, span = 1 } = FLOORINGS[flooring] ?? {};
    const layer = patternLayer(pattern);
    for (const triangle of ShapeUtils.triangulateShape([...points], [])) {
      const corners = triangle.flatMap((i) => points[i] ?? []);
      const [a, b, c] = corners;
      if (!a || !b || !c) continue;
      const turned = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      for (const corner of turned * this.facing > 0 ? [a, c, b] : [a, b, c]) {
        this.positions.push(corner.x, y, corner.y);
        this.weave.push((alongZ ? corner.y : corner.x) / span, (alongZ ? corner.x : corner.y) / span, layer, ROUGHNESS);
        this.colors.push(color.r, color.g, color.b);
      }
    }
  }

  build(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(this.positions, 3));
    geometry.setAttribute("weave", new Float32BufferAttribute(this.weave, 4));
    geometry.setAttribute("color", new Float32BufferAttribute(this.colors, 3));
    geometry.setAttribute("normal", new Float32BufferAttribute(this.positions.map((_, i) => (i % 3 === 1 ? this.facing : 0)), 3));
    return geometry;
  }
}

function outlineOf(room: Room): Vector2[] {
  return cornersOf(room).map(([x, z]) => new Vector2(room.x + x, room.z + z));
}

/** A room with a rug shows its accent there. */
function hasRug(room: Room): boolean {
  return room.decorations.some(({ name }) => name === "rug" || name === "runner");
}

function accentBands(room: Room): Vector2[][] {
  const [x0, z0] = [room.x + ACCENT_INSET, room.z + ACCENT_INSET];
  const [x1, z1] = [room.x + room.width - ACCENT_INSET, room.z + room.depth - ACCENT_INSET];
  const band = (xa: number, za: number, xb: number, zb: number): Vector2[] => [
    new Vector2(xa, za), new Vector2(xb, za), new Vector2(xb, zb), new Vector2(xa, zb),
  ];
  return [
    band(x0, z0, x1, z0 + ACCENT_WIDTH), band(x0, z1 - ACCENT_WIDTH, x1, z1),
    band(x0, z0 + ACCENT_WIDTH, x0 + ACCENT_WIDTH, z1 - ACCENT_WIDTH),
    band(x1 - ACCENT_WIDTH, z0 + ACCENT_WIDTH, x1, z1 - ACCENT_WIDTH),
  ];
}

/** The floors of a house. The caller disposes of them with `disposeOf`. */
export function floorMesh(rooms: readonly Room[], storeys: ReadonlyMap<number, Storey>): Mesh {
  const draft = new FloorDraft();
  for (const room of rooms) {
    const y = storeys.get(room.level)?.elevation ?? 0;
    const color = new Color(room.flooring.color);
    draft.add(outlineOf(room), y, { color, flooring: room.flooring.type, alongZ: room.depth > room.width });
    if (room.outline || room.outdoor || hasRug(room)) continue;
    const accent = color.lerp(new Color(room.accent), ACCENT_OPACITY);
    for (const band of accentBands(room)) draft.add(band, y + ACCENT_RISE, { color: accent });
  }
  const mesh = new Mesh(draft.build(), faceMaterial("floor"));
  Object.assign(mesh, { receiveShadow: true, renderOrder: BEHIND });
  return mesh;
}

/** The ceilings of the rooms inside, seen only from below. */
export function ceilingMesh(rooms: readonly Room[], storeys: ReadonlyMap<number, Storey>): Mesh {
  const draft = new FloorDraft(-1);
  const color = new Color(CEILING);
  for (const room of rooms) {
    const storey = storeys.get(room.level);
    if (!room.outdoor && storey) draft.add(outlineOf(room), storey.elevation + storey.height, { color });
  }
  return new Mesh(draft.build(), faceMaterial("ceiling", { emissive: LAMPLIGHT }));
}
