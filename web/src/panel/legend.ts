/** What colours and marks mean: those of the canvas, and the accents of the rooms shown. */
import type { Scene } from "../contract";
import { inWords } from "./programme";

/** The marks on the canvas, by the class that draws their swatch. */
const MARKS: readonly (readonly [string, string])[] = [
  ["swatch-selected", "Selected"],
  ["swatch-error", "Has an issue"],
  ["swatch-locked", "Locked: stays where it is"],
  ["swatch-free", "Free floor, while dragging"],
  ["swatch-door", "Square of a door: must stay clear"],
  ["swatch-entrance", "Main entrance"],
];

function item(swatchClass: string, words: string, color = ""): HTMLLIElement {
  const line = document.createElement("li");
  const swatch = document.createElement("span");
  swatch.className = `swatch ${swatchClass}`;
  if (color) swatch.style.background = color;
  line.append(swatch, words);
  return line;
}

/** The accent of every type of room in a scene, once each. */
export function accentsOf(scene: Scene): [string, string][] {
  const accents = new Map(scene.rooms.map((room) => [room.type, room.accent]));
  return [...accents].sort(([a], [b]) => a.localeCompare(b));
}

export class Legend {
  constructor(marks: HTMLElement, readonly rooms: HTMLElement) {
    marks.replaceChildren(...MARKS.map(([name, words]) => item(name, words)));
  }

  show(scene: Scene): void {
    this.rooms.replaceChildren(...accentsOf(scene).map(([type, accent]) => item("swatch-room", inWords(type), accent)));
  }
}
