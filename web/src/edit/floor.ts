/** The floor as the service sees it, shown while something is dragged or on demand: what is free, what is kept free. */
import { DoubleSide, Mesh, MeshBasicMaterial } from "three";
import type { FloorAnswer, RoomFloor, Scene } from "../contract";
import { element } from "../element";
import { disposeOf } from "../house/dispose";
import { storeysOf } from "../house/frame";
import { sharedMaterial } from "../house/shared_materials";
import { mergeQuads, type ColoredQuad } from "../house/quad_mesh";
import { Newest } from "../newest";
import { legendItem } from "../panel/legend";
import { isAbort } from "../service";
import type { Stage } from "../stage";
import { say, type Words } from "../words/language";

export type AskFloor = (scene: Scene, rooms: readonly string[], signal: AbortSignal) => Promise<FloorAnswer>;

/** What each kind of floor is drawn in; squares to turn in where a profile of access asks for them, and those that are too small. */
export const ZONE_COLORS = { free: "#35d07f", doors: "#ff9f43", windows: "#6cb6ff", turning: "#14a05a", short: "#e5484d" } as const;
type Zone = keyof typeof ZONE_COLORS;
const ZONE_WORDS: Readonly<Record<Zone, Words>> = {
  free: "Floor that is free", doors: "Before a door: kept clear", windows: "Before a window: only what is low",
  turning: "Space to turn in, as the access profile asks", short: "The largest space there is to turn in: too small",
};
/** How far over the floor the zones lie, each kind over the one before, so that none fights for a pixel [m]. */
const RISE: Readonly<Record<Zone, number>> = { free: 0.02, windows: 0.024, doors: 0.028, turning: 0.032, short: 0.032 };

/** What is drawn with an edge: where it ends counts. */
const EDGED: readonly Zone[] = ["turning", "short"];
/** How wide that edge is [m]. */
const EDGE = 0.05;

function zoneMaterial(opacity: number): MeshBasicMaterial {
  return new MeshBasicMaterial({ vertexColors: true, transparent: true, opacity, depthWrite: false, side: DoubleSide, toneMapped: false });
}

/** The edges of squares to turn in, as level strips in house coordinates [m]. */
export function edgesOf(scene: Scene, floors: readonly RoomFloor[]): ColoredQuad[] {
  const edged = floors.map((floor): RoomFloor => {
    const strips = (zone: Zone): RoomFloor[Zone] => floor[zone].flatMap(([x0, z0, x1, z1]): RoomFloor[Zone] => [
      [x0, z0, x1, z0 + EDGE], [x0, z1 - EDGE, x1, z1], [x0, z0 + EDGE, x0 + EDGE, z1 - EDGE], [x1 - EDGE, z0 + EDGE, x1, z1 - EDGE],
    ]);
    return { ...floor, turning: strips("turning"), short: strips("short") };
  });
  return zonesOf(scene, edged, EDGED);
}

/** The zones of rooms as level rectangles in house coordinates [m]. */
export function zonesOf(scene: Scene, floors: readonly RoomFloor[], zones = Object.keys(ZONE_COLORS) as readonly Zone[]): ColoredQuad[] {
  const storeys = storeysOf(scene);
  return floors.flatMap((floor) => {
    const room = scene.rooms.find((one) => one.id === floor.room);
    if (!room) return [];
    const ground = storeys.get(room.level)?.elevation ?? 0;
    return zones.flatMap((zone) => floor[zone].map(([x0, z0, x1, z1]): ColoredQuad => {
      const y = ground + RISE[zone];
      const [west, east, north, south] = [room.x + x0, room.x + x1, room.z + z0, room.z + z1];
      return { corners: [[west, y, north], [west, y, south], [east, y, south], [east, y, north]], normal: [0, 1, 0], color: ZONE_COLORS[zone] };
    }));
  });
}

export class FloorZones {
  #floors: readonly RoomFloor[] = [];
  #mesh: Mesh | null = null;
  readonly #pending = new Newest();
  readonly #legend = element("floor_legend");

  constructor(readonly stage: Stage, readonly ask: AskFloor, readonly failed: (reason: unknown) => void) {}

  /** Asks for the zones of rooms, all where none are named, and shows them. */
  async show(scene: Scene, rooms: readonly string[]): Promise<void> {
    const signal = this.#pending.next();
    try {
      this.#floors = (await this.ask(scene, rooms, signal)).rooms;
      this.draw(scene);
    } catch (reason) {
      if (!isAbort(reason)) this.failed(reason);
    }
  }

  hide(): void {
    this.#pending.stop();
    this.#floors = [];
    this.draw(null);
  }

  /** Draws what is known again, for a house drawn anew. */
  draw(scene: Scene | null): void {
    if (this.#mesh) disposeOf(this.#mesh);
    this.#mesh = null;
    const seen = scene && this.stage.storeys.drawn(scene);
    const quads = seen ? zonesOf(seen, this.#floors) : [];
    this.stage.floorZones = quads.length;
    const meant = Object.keys(ZONE_COLORS).filter((zone): zone is Zone => quads.some(({ color }) => color === ZONE_COLORS[zone as Zone]));
    this.#legend.replaceChildren(...meant.map((zone) => legendItem("zone", say(ZONE_WORDS[zone]), ZONE_COLORS[zone], ZONE_COLORS[zone])));
    this.stage.viewport.invalidate();
    if (quads.length === 0) return;
    this.#mesh = new Mesh(mergeQuads(quads), sharedMaterial("floor zone", () => zoneMaterial(0.3)));
    const edges = seen ? edgesOf(seen, this.#floors) : [];
    if (edges.length > 0) this.#mesh.add(new Mesh(mergeQuads(edges), sharedMaterial("floor zone's edge", () => zoneMaterial(0.9))));
    this.stage.house?.root.add(this.#mesh);
  }
}
