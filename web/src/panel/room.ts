/** The room in hand: what it is, what is in it, and furnishing it anew. */
import type { Home } from "../state/home";
import type { Opening, Room, Scene } from "../contract";
import { clearFloorOf } from "../house/clear_floor";
import { drawable } from "../house/drawable";
import { runsOf } from "../house/wall_runs";
import { made } from "../made";
import { inWords } from "./programme";
import { say, sayArea, sayName, sayNumber } from "../words/language";

function metres(length: number): string {
  return `${sayNumber(length, 2, "short")} m`;
}

function leadsTo({ connects_to: to, kind }: Opening, names: ReadonlyMap<string, string>): string {
  const goal = !to || to === "EXTERIOR" ? say("outside") : (names.get(to) ?? to);
  return kind === "door" ? goal : `${goal} (${sayName(kind)})`;
}

/** What to call each room: its name, else its type, numbered where there are several of it. */
export function roomNames(scene: { readonly rooms: readonly Pick<Room, "id" | "type" | "name">[] }): ReadonlyMap<string, string> {
  const seen = new Map<string, number>();
  const count = (type: string): number => scene.rooms.filter((room) => room.type === type).length;
  return new Map(scene.rooms.map((room) => {
    const number = (seen.get(room.type) ?? 0) + 1;
    seen.set(room.type, number);
    return [room.id, room.name || inWords(room.type) + (count(room.type) > 1 ? ` ${number}` : "")];
  }));
}

/** What there is to say of a room, as pairs of a word and what it is. */
export function factsOf(room: Room, scene: Scene): [string, string][] {
  const names = roomNames(scene);
  const clear = clearFloorOf(room, runsOf(scene.rooms, scene.wall_thickness), scene.wall_thickness);
  const windows = room.openings.filter(({ kind }) => kind === "window").length;
  const doors = room.openings.filter(({ kind }) => kind !== "window").map((door) => leadsTo(door, names));
  const people = scene.dynamic.filter((body) => body.room === room.id).map((body) => sayName(body.kind));
  const facts: [string, string][] = [
    [say("Type"), inWords(room.type)],
    [say("Size"), `${metres(clear.width)} × ${metres(clear.depth)}`],
    [say("Area"), sayArea(clear.area)],
    [say("Floor"), room.flooring ? sayName(room.flooring.type) : say("not said")],
    [say("Doors"), doors.length > 0 ? say("to {rooms}", { rooms: doors.join(", ") }) : say("none")],
    [say("Windows"), String(windows)],
    [say("Furniture"), String(room.furniture.length)],
    [say("Decorations"), String(room.decorations.length)],
  ];
  if (room.walls) facts.splice(4, 0, [say("Walls"), sayName(room.walls.type)]);
  if (people.length > 0) facts.push([say("At home"), people.join(", ")]);
  return facts;
}

export class RoomPanel {
  /** Called with the id of the room to furnish anew. */
  onReroll: (id: string) => void = () => undefined;
  /** Called with the id of the room of which other arrangements are wished. */
  onOthers: (id: string) => void = () => undefined;
  readonly #choice: HTMLSelectElement;
  readonly #facts: HTMLElement;
  readonly #reroll: HTMLButtonElement;
  readonly #others: HTMLButtonElement | null;

  constructor(host: HTMLElement, readonly home: Home) {
    this.#choice = host.querySelector("#room_choice") as HTMLSelectElement;
    this.#facts = host.querySelector("#room_facts") as HTMLElement;
    this.#reroll = host.querySelector("#reroll") as HTMLButtonElement;
    this.#others = host.querySelector("#others_now");
    this.#others?.addEventListener("click", () => { if (home.room !== null) this.onOthers(home.room); });
    this.#choice.addEventListener("change", () => home.selectRoom(this.#choice.value || null));
    this.#reroll.addEventListener("click", () => { if (home.room !== null) this.onReroll(home.room); });
    home.on("shown", (how) => { if (how !== "live") this.#list(); });
    home.on("room", () => this.#tell());
  }

  #list(): void {
    const { scene } = this.home;
    const rooms = scene ? [...roomNames(scene)].sort(([, a], [, b]) => a.localeCompare(b, "en", { numeric: true })) : [];
    this.#choice.replaceChildren(new Option(say("None chosen"), ""), ...rooms.map(([id, name]) => new Option(name, id)));
    this.#tell();
  }

  #tell(): void {
    const { scene: said, room: id } = this.home;
    const scene = said && drawable(said);
    const room = scene?.rooms.find((one) => one.id === id);
    this.#choice.value = room?.id ?? "";
    this.#reroll.disabled = !room;
    if (this.#others) this.#others.disabled = !room;
    this.#facts.hidden = !room;
    this.#facts.replaceChildren(...(room && scene ? factsOf(room, scene).flatMap(([word, what]) => [made("dt", {}, word), made("dd", {}, what)]) : []));
  }
}
