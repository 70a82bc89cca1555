/** The room in hand: what it is, what is in it, and furnishing it anew. */
import type { Home } from "../state/home";
import type { Opening, Room, Scene } from "../contract";
import { inWords } from "./programme";

function metres(length: number): string {
  return `${Number(length.toFixed(2))} m`;
}

/** The floor between a room's wall lines [m²]: of its outline, where it is not its rectangle. */
export function floorArea({ outline, width, depth }: Room): number {
  if (!outline || outline.length < 3) return width * depth;
  const doubled = outline.reduce((sum, [x, z], i) => {
    const [nextX, nextZ] = outline[(i + 1) % outline.length] ?? [x, z];
    return sum + x * nextZ - nextX * z;
  }, 0);
  return Math.abs(doubled) / 2;
}

function leadsTo({ connects_to: to, kind }: Opening, names: ReadonlyMap<string, string>): string {
  const goal = !to || to === "EXTERIOR" ? "outside" : (names.get(to) ?? to);
  return kind === "door" ? goal : `${goal} (${kind.replaceAll("_", " ")})`;
}

/** What to call each room: its type, numbered where there are several of it. */
export function roomNames(scene: { readonly rooms: readonly Pick<Room, "id" | "type">[] }): ReadonlyMap<string, string> {
  const seen = new Map<string, number>();
  const count = (type: string): number => scene.rooms.filter((room) => room.type === type).length;
  return new Map(scene.rooms.map((room) => {
    const number = (seen.get(room.type) ?? 0) + 1;
    seen.set(room.type, number);
    return [room.id, inWords(room.type) + (count(room.type) > 1 ? ` ${number}` : "")];
  }));
}

/** What there is to say of a room, as pairs of a word and what it is. */
export function factsOf(room: Room, scene: Scene): [string, string][] {
  const names = roomNames(scene);
  const windows = room.openings.filter(({ kind }) => kind === "window").length;
  const doors = room.openings.filter(({ kind }) => kind !== "window").map((door) => leadsTo(door, names));
  const people = scene.dynamic.filter((body) => body.room === room.id).map((body) => body.kind);
  const facts: [string, string][] = [
    ["Type", inWords(room.type)],
    ["Size", `${metres(room.width)} × ${metres(room.depth)}`],
    ["Area", `${floorArea(room).toFixed(1)} m²`],
    ["Floor", room.flooring?.type ?? "not said"],
    ["Doors", doors.length > 0 ? `to ${doors.join(", ")}` : "none"],
    ["Windows", String(windows)],
    ["Furniture", String(room.furniture.length)],
    ["Decorations", String(room.decorations.length)],
  ];
  if (room.walls) facts.splice(4, 0, ["Walls", room.walls.type]);
  if (people.length > 0) facts.push(["At home", people.join(", ")]);
  return facts;
}

export class RoomPanel {
  /** Called with the id of the room to furnish anew. */
  onReroll: (id: string) => void = () => undefined;
  readonly #choice: HTMLSelectElement;
  readonly #facts: HTMLElement;
  readonly #reroll: HTMLButtonElement;

  constructor(host: HTMLElement, readonly home: Home) {
    this.#choice = host.querySelector("#room_choice") as HTMLSelectElement;
    this.#facts = host.querySelector("#room_facts") as HTMLElement;
    this.#reroll = host.querySelector("#reroll") as HTMLButtonElement;
    this.#choice.addEventListener("change", () => home.selectRoom(this.#choice.value || null));
    this.#reroll.addEventListener("click", () => { if (home.room !== null) this.onReroll(home.room); });
    home.on("shown", (how) => { if (how !== "live") this.#list(); });
    home.on("room", () => this.#tell());
  }

  #list(): void {
    const { scene } = this.home;
    const rooms = scene ? [...roomNames(scene)].sort(([, a], [, b]) => a.localeCompare(b, "en", { numeric: true })) : [];
    this.#choice.replaceChildren(new Option("None chosen", ""), ...rooms.map(([id, name]) => new Option(name, id)));
    this.#tell();
  }

  #tell(): void {
    const { scene, room: id } = this.home;
    const room = scene?.rooms.find((one) => one.id === id);
    this.#choice.value = room?.id ?? "";
    this.#reroll.disabled = !room;
    this.#facts.hidden = !room;
    this.#facts.replaceChildren(...(room && scene ? factsOf(room, scene).flatMap(([word, what]) => this.#fact(word, what)) : []));
  }

  #fact(word: string, what: string): HTMLElement[] {
    const term = document.createElement("dt");
    const description = document.createElement("dd");
    term.textContent = word;
    description.textContent = what;
    return [term, description];
  }
}
