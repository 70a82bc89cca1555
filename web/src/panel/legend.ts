/** What colours and marks mean: those of the canvas, and the rooms shown, each as its floor and accent are drawn. */
import type { Scene } from "../contract";
import { ENTRANCE_COLOR } from "../house/door_shapes";
import { MARK_COLORS } from "../house/house";
import { made } from "../made";
import { inWords } from "./programme";
import { say, type Words } from "../words/language";

/** How a colour is drawn: as a frame around a body, or as a surface. */
type Drawn = "frame" | "zone" | "surface";

const MARKS: readonly (readonly [string, Drawn, Words])[] = [
  [MARK_COLORS.selected, "frame", "Selected"],
  [MARK_COLORS.error, "frame", "Has an issue, or is in conflict"],
  [MARK_COLORS.locked, "frame", "Locked: stays where it is"],
  [MARK_COLORS.settles, "frame", "Where a dragged piece will stand"],
  [ENTRANCE_COLOR, "surface", "Main entrance"],
];

/** A colour and what it means. */
export function legendItem(drawn: string, words: string, fill: string, line: string): HTMLLIElement {
  const swatch = made("span", { className: `swatch swatch-${drawn}` });
  swatch.style.backgroundColor = fill;
  swatch.style.borderColor = line;
  return made("li", {}, swatch, words);
}

export interface RoomColors {
  readonly type: string;
  readonly floor: string;
  readonly accent: string;
}

/** The floor and accent of the rooms of a scene, by type, once each. */
export function roomColors(scene: Scene): RoomColors[] {
  const colors = scene.rooms.map(({ type, flooring, accent }): RoomColors => ({ type, floor: flooring.color, accent }));
  const once = new Map(colors.map((one) => [JSON.stringify(one), one]));
  return [...once.values()].sort((a, b) => a.type.localeCompare(b.type));
}

export class Legend {
  constructor(marks: HTMLElement, readonly rooms: HTMLElement) {
    marks.replaceChildren(...MARKS.map(([color, drawn, words]) => legendItem(drawn, say(words), drawn === "frame" ? "" : color, color)));
  }

  show(scene: Scene): void {
    this.rooms.replaceChildren(...roomColors(scene).map(({ type, floor, accent }) => legendItem("room", inWords(type), floor, accent)));
  }
}
