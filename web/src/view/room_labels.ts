/** Names of rooms with their areas: over the middle of each; who walks reads those near and ahead. */
import { Vector3 } from "three";
import type { Room } from "../contract";
import { storeysOf, words } from "../house/frame";
import { holds } from "../house/finishes";
import type { House } from "../house/house";
import { areaOf, cornersOf } from "../house/plan";
import type { Point } from "../house/wall_faces";
import { hang, labelElement, type LabelElement } from "./label_elements";
import { RANK, roomsAhead, type Asked } from "./label_wishes";
import type { Viewport } from "./viewport";

interface RoomLabel extends LabelElement {
  readonly room: Room;
  readonly elevation: number;
  readonly area: number;
  readonly at: Point;
}

/** Over the heads of who walks [m]. */
const WALK_HEIGHT = 2.2;
/** How much of its room's width a name may take. */
const SHARE = 0.9;

export class RoomLabels {
  #labels: RoomLabel[] = [];
  #height = 0;
  #house: House | null = null;

  constructor(readonly layer: HTMLElement, readonly viewport: Viewport) {}

  show(house: House): void {
    const { rooms } = house.scene;
    const storeys = storeysOf(house.scene);
    this.#house = house;
    for (const { element } of this.#labels) element.remove();
    this.#labels = rooms.map((room) => {
      const area = areaOf(room);
      const label = labelElement("room-label", words(room.type), { dot: room.accent, second: `${area.toFixed(1)} m²` });
      const elevation = storeys.get(room.level)?.elevation ?? 0;
      return Object.assign(label, { room, elevation, area, at: [room.x + room.width / 2, elevation, room.z + room.depth / 2] as Point });
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

  /** The names wished for in this frame. */
  asked(): Asked[] {
    const { pose } = this.viewport;
    const shown = pose ? roomsAhead(pose, this.#labels, (label) => this.#isSeen(pose.eye, label)) : this.#labels;
    return shown.flatMap((label, i) => {
      const [x, , z] = label.at;
      const seen = this.viewport.project(new Vector3(x, this.#heightOf(label), z));
      if (!seen) return [];
      const whole = this.#widthSeen(label) * SHARE > label.width;
      if (label.second) label.second.hidden = !whole;
      return [{
        label, ...seen, width: label.width - (whole ? 0 : label.spare), height: label.height,
        importance: RANK.room + (pose ? shown.length - i : label.area), keepsDot: !pose,
      }];
    });
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
    const y = this.#heightOf(label);
    const xs = cornersOf(label.room).flatMap(([x, z]) => this.viewport.project(new Vector3(label.room.x + x, y, label.room.z + z))?.x ?? []);
    return xs.length < 2 ? 0 : Math.max(...xs) - Math.min(...xs);
  }
}
