/** Names of rooms with their areas: over the middle of each; who walks reads those near and ahead. */
import { Vector3 } from "three";
import type { Room } from "../contract";
import { storeysOf, words, type PlacedBody } from "../house/frame";
import { holds } from "../house/finishes";
import type { House } from "../house/house";
import { clearFloorOf } from "../house/clear_floor";
import { cornersOf } from "../house/plan";
import type { Point } from "../house/wall_faces";
import { hang, labelElement, type LabelElement } from "./label_elements";
import { areaWithin, clearest, type Kept, type LabelPlace } from "./label_layout";
import { RANK, roomsAhead, type Asked } from "./label_wishes";
import type { Viewport } from "./viewport";
import { sayArea } from "../words/language";

interface RoomLabel extends LabelElement {
  readonly room: Room;
  readonly elevation: number;
  readonly area: number;
  readonly at: Point;
  /** Where over its floor the name may be, the middle first: shares of its sides. */
  readonly spots: readonly Spot[];
  /** Where it was last. */
  spot: Spot;
}

type Spot = readonly [number, number];
/** Tried beside the middle, in shares of a room's sides. */
const SHARES = [0.5, 0.35, 0.65, 0.2, 0.8];
const SPOTS = SHARES.flatMap((across) => SHARES.map((along): Spot => [across, along]))
  .sort((a, b) => Math.hypot(a[0] - 0.5, a[1] - 0.5) - Math.hypot(b[0] - 0.5, b[1] - 0.5));
/** What is lower is no piece that a name hides [m]. */
const LOWEST = 0.1;

/** Over the heads of who walks [m]. */
const WALK_HEIGHT = 2.2;
/** How much of its room's width a name with its area may take. */
const SHARE = 0.9;
/** How much of a home's floor, as it is seen, names may cover: the smallest rooms keep their dots until one comes nearer. */
const COVERED = 0.15;

export class RoomLabels {
  #labels: RoomLabel[] = [];
  #height = 0;
  #house: House | null = null;

  constructor(readonly layer: HTMLElement, readonly viewport: Viewport) {}

  show(house: House): void {
    const storeys = storeysOf(house.scene);
    const highest = Math.max(...house.scene.rooms.map(({ level }) => storeys.get(level)?.elevation ?? 0));
    const rooms = house.scene.rooms.filter(({ level }) => (storeys.get(level)?.elevation ?? 0) === highest); // those beneath are not looked at
    this.#house = house;
    for (const { element } of this.#labels) element.remove();
    this.#labels = rooms.map((room) => {
      const { area } = clearFloorOf(room, house.runs, house.scene.wall_thickness);
      const label = labelElement("room-label", room.name || words(room.type), { dot: room.accent, second: sayArea(area) });
      const elevation = storeys.get(room.level)?.elevation ?? 0;
      const spots = SPOTS.filter(([u, v]) => holds(room, room.x + u * room.width, room.z + v * room.depth));
      return Object.assign(label, { room, elevation, area, spots, spot: SPOTS[0] as Spot, at: [room.x + room.width / 2, elevation, room.z + room.depth / 2] as Point });
    });
    hang(this.layer, this.#labels);
  }

  /** Puts the names where walls end [m]. */
  raiseTo(height: number): void {
    this.#height = height;
  }

  get all(): readonly LabelElement[] {
    return this.#labels;
  }

  /** Where a room's name would best be on the canvas [CSS pixels]. */
  middleOf(id: string): { x: number; y: number } | null {
    const label = this.#labels.find(({ room }) => room.id === id);
    return label ? this.viewport.project(new Vector3(label.at[0], this.#heightOf(label), label.at[2])) : null;
  }

  /** How wide a room is seen to be from outside [CSS pixels]; of what is no room there is no such width. */
  widthOf(id: string): number {
    const label = this.viewport.pose ? undefined : this.#labels.find(({ room }) => room.id === id);
    return label ? this.#widthSeen(label) : Number.POSITIVE_INFINITY;
  }

  /** The names wished for in this frame. */
  asked(): Asked[] {
    const { pose } = this.viewport;
    const pieces = pose ? [] : (this.#house?.bodies ?? []).flatMap((body) => this.#seenOf(body));
    const shown = pose ? roomsAhead(pose, this.#labels, (label) => this.#isSeen(pose.eye, label)) : this.#labels;
    const dots = pose ? new Set() : this.#dots();
    return shown.flatMap((label, i) => {
      const [x, , z] = label.at;
      const seen = pose ? this.viewport.project(new Vector3(x, this.#heightOf(label), z)) : this.#clearPlace(label, pieces);
      if (!seen) return [];
      const whole = this.#widthSeen(label) * SHARE > label.width;
      if (label.second) label.second.hidden = !whole;
      return [{
        label, x: seen.x, y: seen.y, width: label.width - (whole ? 0 : label.spare), height: label.height,
        importance: RANK.room + (pose ? shown.length - i : label.area), keepsDot: !pose, isDot: dots.has(label),
      }];
    });
  }

  /** How a piece of furniture lies on the canvas, about. */
  #seenOf(body: PlacedBody): Kept[] {
    if (body.kind !== "furniture" || body.height < LOWEST) return [];
    const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
    const seen = [0, body.height].flatMap((up) => [-1, 1].flatMap((i) => [-1, 1].flatMap((j) => {
      const [across, along] = [(i * body.width) / 2, (j * body.depth) / 2];
      return this.viewport.project(new Vector3(body.x + across * cos + along * sin, body.y + up, body.z - across * sin + along * cos)) ?? [];
    })));
    const [xs, ys] = [seen.map(({ x }) => x), seen.map(({ y }) => y)];
    if (seen.length === 0) return [];
    const [west, east, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    return [{ x: (west + east) / 2, y: (top + bottom) / 2, width: east - west, height: bottom - top }];
  }

  /** Where a room's name covers no piece of furniture, or the fewest; it stays where it was while that is as good. */
  #clearPlace(label: RoomLabel, pieces: readonly Kept[]): { x: number; y: number } | null {
    const { room: { x, z, width, depth } } = label;
    const y = this.#heightOf(label);
    const places = label.spots.flatMap((spot) => {
      const seen = this.viewport.project(new Vector3(x + spot[0] * width, y, z + spot[1] * depth));
      return seen ? [{ ...seen, spot }] : [];
    });
    const [west, east] = this.#acrossSeen(label);
    const within = places.filter((place) => place.x - label.width / 2 >= west && place.x + label.width / 2 <= east);
    const tried = within.length > 0 ? within : places.slice(0, 1); // too narrow: the middle
    const found = clearest(label, tried, pieces, tried.find(({ spot }) => spot === label.spot));
    if (found) label.spot = found.spot;
    return found ?? null;
  }

  /** Names are not seen through walls; that of the room one is in always is. */
  #isSeen(eye: Point, label: RoomLabel): boolean {
    const [x, , z] = label.at;
    return holds(label.room, eye[0], eye[2]) || this.#house?.sees(eye, [x, this.#heightOf(label), z]) === true;
  }

  #heightOf({ elevation }: RoomLabel): number {
    return this.viewport.pose ? elevation + WALK_HEIGHT : Math.max(elevation, this.#height);
  }

  #widthSeen(label: RoomLabel): number {
    const [west, east] = this.#acrossSeen(label);
    return east - west;
  }

  /** From where to where a room reaches across the canvas [CSS pixels]. */
  #acrossSeen(label: RoomLabel): readonly [number, number] {
    const xs = this.#cornersSeen(label).map(({ x }) => x);
    return xs.length < 2 ? [0, 0] : [Math.min(...xs), Math.max(...xs)];
  }

  /** The rooms that have no name while the home is seen so small that all names would hide what stands there. */
  #dots(): ReadonlySet<RoomLabel> {
    const bySize = [...this.#labels].sort((a, b) => b.area - a.area);
    let left = COVERED * bySize.reduce((sum, label) => sum + areaWithin(this.#cornersSeen(label)), 0);
    return new Set(bySize.filter((label) => (left -= (label.width - label.spare) * label.height) < 0));
  }

  #cornersSeen(label: RoomLabel): readonly LabelPlace[] {
    const y = this.#heightOf(label);
    return cornersOf(label.room).flatMap(([x, z]) => this.viewport.project(new Vector3(label.room.x + x, y, label.room.z + z)) ?? []);
  }
}
