/** Which storey of a home of several is looked at: it and those beneath it are drawn, and its plan. */
import type { Scene } from "../contract";
import { made } from "../made";
import { say } from "../words/language";

/** The levels that have rooms, the lowest first. */
export function levelsOf({ rooms, levels }: Scene): number[] {
  const elevations = new Map((levels ?? []).map(({ index, elevation }) => [index, elevation]));
  const found = [...new Set(rooms.map((room) => room.level ?? 0))];
  return found.sort((a, b) => (elevations.get(a) ?? a) - (elevations.get(b) ?? b) || a - b);
}

/** A scene with the rooms of some levels alone, and who is in them. */
export function onLevels(scene: Scene, levels: readonly number[]): Scene {
  const rooms = scene.rooms.filter((room) => levels.includes(room.level ?? 0));
  if (rooms.length === scene.rooms.length) return scene;
  const [ids, indices] = [new Set(rooms.map(({ id }) => id)), new Set(rooms.map(({ index }) => index))];
  const dynamic = (scene.dynamic ?? []).filter(({ room }) => !room || ids.has(room));
  const adjacency = ((scene as { adjacency?: readonly (readonly [number, number])[] }).adjacency ?? []).filter(([a, b]) => indices.has(a) && indices.has(b));
  return { ...scene, rooms, levels: scene.levels?.filter(({ index }) => levels.includes(index)) ?? [], dynamic, adjacency } as Scene;
}

export class Storeys {
  /** Told that another storey is to be looked at. */
  onChoose: () => void = () => undefined;
  #levels: readonly number[] = [0];

  /** `choice` is hidden for homes of one storey. */
  constructor(readonly choice: HTMLSelectElement) {
    choice.addEventListener("change", () => this.onChoose());
  }

  /** Another state of a home: the same storey is looked at while it has one, else the lowest. */
  learn(scene: Scene): void {
    const [levels, before] = [levelsOf(scene), this.chosen];
    if (levels.join() !== this.#levels.join()) {
      this.#levels = levels;
      const words = (i: number): string => say("Storey {number} of {count}", { number: i + 1, count: levels.length });
      this.choice.replaceChildren(...levels.map((level, i) => made("option", { value: String(level) }, words(i))));
      this.choice.value = String(levels.includes(before) ? before : (levels[0] ?? 0));
    }
    this.choice.hidden = levels.length < 2;
  }

  /** Looks at the storey of a room; tells whether that is another one. */
  goTo(level: number): boolean {
    if (level === this.chosen || !this.#levels.includes(level)) return false;
    this.choice.value = String(level);
    return true;
  }

  /** The level that is looked at. */
  get chosen(): number {
    return this.choice.value === "" ? (this.#levels[0] ?? 0) : Number(this.choice.value);
  }

  /** How high its floor lies [m]. */
  riseIn({ levels }: Scene): number {
    const at = (level: number | undefined): number => levels?.find(({ index }) => index === level)?.elevation ?? 0;
    return at(this.chosen);
  }

  /** What is drawn in 3D: the storey and all beneath it. */
  drawn(scene: Scene): Scene {
    return onLevels(scene, this.#levels.slice(0, this.#levels.indexOf(this.chosen) + 1));
  }

  /** What its plan shows. */
  planned(scene: Scene): Scene {
    return onLevels(scene, [this.chosen]);
  }
}
