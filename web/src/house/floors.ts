/** Floors, one mesh a flooring type; ceilings; and the accents of rooms inside as a thin line along their walls. */
import {
  BufferGeometry, Color, Float32BufferAttribute, Group, Mesh, MeshBasicMaterial, ShapeUtils, Vector2,
} from "three";
import type { Room } from "../contract";
import { floorTexture, TEXTURE_SPAN } from "./floor_textures";
import { sharedMaterial } from "./shared_materials";
import { litMaterial, type LitMaterial } from "./lit";
import { cornersOf } from "./plan";
import { faceMaterial } from "./wall_shader";
import type { Storey } from "./walls";

const CEILING = "#f6f3ec";
/** What falls onto ceilings from the floor and from lamps: the sky above does not light them. */
const LAMPLIGHT = "#8f8b84";
const ACCENT_INSET = 0.14;
const ACCENT_WIDTH = 0.035;
const ACCENT_RISE = 0.004;
/** Drawn after what stands on it: a pixel that is hidden is not lit. */
const BEHIND = 1;

/** Triangles that all look up, or all down. */
class FloorDraft {
  readonly positions: number[] = [];
  readonly coordinates: number[] = [];
  readonly colors: number[] = [];

  constructor(readonly facing: 1 | -1 = 1) {}

  add(points: readonly Vector2[], y: number, color: string, alongZ = false): void {
    const tint = new Color(color);
    for (const triangle of ShapeUtils.triangulateShape([...points], [])) {
      const corners = triangle.flatMap((i) => points[i] ?? []);
      const [a, b, c] = corners;
      if (!a || !b || !c) continue;
      const turned = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      for (const corner of turned * this.facing > 0 ? [a, c, b] : [a, b, c]) {
        this.positions.push(corner.x, y, corner.y);
        this.coordinates.push(...(alongZ ? [corner.y, corner.x] : [corner.x, corner.y]).map((metres) => metres / TEXTURE_SPAN));
        this.colors.push(tint.r, tint.g, tint.b);
      }
    }
  }

  build(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(this.positions, 3));
    geometry.setAttribute("uv", new Float32BufferAttribute(this.coordinates, 2));
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

function floorMaterial(type: string): LitMaterial {
  const map = floorTexture(type);
  return sharedMaterial(`floor of ${map ? type : "nothing known"}`, () => litMaterial({ vertexColors: true, roughness: 0.9, map }));
}

/** The floors of a house. The caller disposes of them with `disposeOf`. */
export function floorMeshes(rooms: readonly Room[], storeys: ReadonlyMap<number, Storey>): Group {
  const group = new Group();
  const drafts = new Map<string, FloorDraft>();
  const accents = new FloorDraft();
  for (const room of rooms) {
    const y = storeys.get(room.level)?.elevation ?? 0;
    const draft = drafts.get(room.flooring.type) ?? new FloorDraft();
    drafts.set(room.flooring.type, draft);
    draft.add(outlineOf(room), y, room.flooring.color, room.depth > room.width);
    if (!room.outline && !room.outdoor && !hasRug(room)) for (const band of accentBands(room)) accents.add(band, y + ACCENT_RISE, room.accent);
  }
  for (const [type, draft] of drafts) {
    const mesh = new Mesh(draft.build(), floorMaterial(type));
    Object.assign(mesh, { receiveShadow: true, renderOrder: BEHIND });
    group.add(mesh);
  }
  group.add(new Mesh(accents.build(), sharedMaterial("accent", () => new MeshBasicMaterial({ vertexColors: true, transparent: true, opacity: 0.75 }))));
  return group;
}

/** The ceilings of the rooms inside, seen only from below. */
export function ceilingMesh(rooms: readonly Room[], storeys: ReadonlyMap<number, Storey>): Mesh {
  const draft = new FloorDraft(-1);
  for (const room of rooms) {
    const storey = storeys.get(room.level);
    if (!room.outdoor && storey) draft.add(outlineOf(room), storey.elevation + storey.height, CEILING);
  }
  return new Mesh(draft.build(), faceMaterial("ceiling", { emissive: LAMPLIGHT }));
}
