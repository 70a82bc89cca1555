/** Two saved homes side by side: their pictures, and what can be counted of them. */
import type { Scene } from "../contract";
import { clearFloorOf } from "../house/clear_floor";
import { drawable } from "../house/drawable";
import { runsOf } from "../house/wall_runs";
import { button, made } from "../made";
import { readSaved, savedPicture, type SavedHead, type SavedHome } from "./saved_calls";
import { say, sayArea, sayName } from "../words/language";

/** What is told of a home, row by row. */
export function factsOf({ head, scene }: SavedHome): Record<string, string> {
  const { rooms, wall_thickness: thickness } = drawable(scene);
  const runs = runsOf(rooms, thickness);
  const area = rooms.filter(({ outdoor }) => !outdoor).reduce((sum, room) => sum + clearFloorOf(room, runs, thickness).area, 0);
  return {
    [say("Rooms")]: String(scene.rooms.length),
    [say("Floor")]: say("{area} indoors", { area: sayArea(area) }),
    [say("Furniture")]: String(count(scene, "furniture")),
    [say("Decorations")]: String(count(scene, "decorations")),
    [say("Room types")]: scene.rooms.map(({ type }) => sayName(type)).sort().join(", "),
    [say("Tags")]: head.tags.join(", "),
    [say("Changed")]: head.changed,
  };
}

function count(scene: Scene, what: "furniture" | "decorations"): number {
  return scene.rooms.reduce((sum, room) => sum + room[what].length, 0);
}

export class Comparison {
  readonly #dialog = made("dialog", { className: "saved-comparison", "aria-label": say("Two homes side by side") });
  #first: SavedHead | null = null;
  #urls: string[] = [];

  constructor() {
    this.#dialog.addEventListener("close", () => { for (const url of this.#urls.splice(0)) URL.revokeObjectURL(url); });
    document.body.append(this.#dialog);
  }

  /** Takes a home; once there are two they are shown. */
  async add(head: SavedHead): Promise<void> {
    if (this.#first === null || this.#first.id === head.id) {
      this.#first = head;
      return;
    }
    const [one, other] = await Promise.all([readSaved(this.#first.id), readSaved(head.id)]);
    this.#first = null;
    const table = made("table");
    const facts = [factsOf(one), factsOf(other)] as const;
    table.append(row("", one.head.name, other.head.name), await this.#pictured(one, other));
    for (const name of Object.keys(facts[0])) table.append(row(name, facts[0][name] ?? "", facts[1][name] ?? ""));
    this.#dialog.replaceChildren(table, button(say("Close"), () => this.#dialog.close()));
    this.#dialog.showModal();
  }

  async #pictured(one: SavedHome, other: SavedHome): Promise<HTMLElement> {
    this.#urls = await Promise.all([one, other].map(({ head }) => savedPicture(head.id)));
    const pictures = row(say("Picture"), "", "");
    this.#urls.forEach((src, i) => pictures.children[i + 1]?.append(made("img", { src, alt: "", width: 288 })));
    return pictures;
  }
}

function row(name: string, ...cells: readonly string[]): HTMLElement {
  return made("tr", {}, name ? made("th", { scope: "row" }, name) : made("td"), ...cells.map((words) => made("td", {}, words)));
}
