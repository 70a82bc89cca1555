/** What fell short of what was asked or wished, in plain words: of the plan, of rooms that are not proven, of pieces that were left out. */
import type { LeftOut, Scene } from "../contract";
import { button, made } from "../made";
import { roomNames } from "./room";
import { capital, say, sayName } from "../words/language";
import { tell } from "../words/telling";

/** One thing that fell short: in words, why for each piece, and the room it is about. */
export interface Shortfall {
  readonly words: string;
  readonly whys: readonly string[];
  readonly room: string | null;
}

export interface Shortfalls {
  /** What was asked and is otherwise, and what could not be proven. */
  readonly asked: readonly Shortfall[];
  /** What would have come with what was asked, and nobody misses. */
  readonly beside: readonly Shortfall[];
  /** What stands in no room for want of space, or because the room was full enough. */
  readonly leftOut: readonly Shortfall[];
  /** How many of those found no place, and how many a room that is full enough does without. */
  readonly pieces: number;
  readonly spare: number;
}

/** How a certificate begins to say that a room needed no more. */
const FULL = "the floor is covered as densely as wished";
/** How it begins to say that a home has a garden, and no more outdoors. */
const GARDEN_ALONE = "no patio";

/** A note as a sentence: ids and the request's keys in words. */
export function sentence(note: string, scene?: Scene): string {
  const words = tell(note.trim(), scene).replaceAll("min room size", "the smallest room side of").replaceAll(/\bm2\b/g, "m²").replaceAll("_", " ");
  return words === "" ? "" : `${capital(words)}${/[.!?]$/.test(words) ? "" : "."}`;
}

/** What a piece that was left out is called: `second_armchair_1` is a second armchair; `third_across_1` the dining chair that its reason names. */
function pieceWords({ piece, reason }: LeftOut): string {
  const own = piece.replace(/_\d+$/, "");
  const kind = /; the smallest, ([^,]+), needs/.exec(reason)?.[1];
  const last = (name: string): string | undefined => name.split("_").at(-1);
  return sayName(kind !== undefined && last(kind) !== last(own) ? kind : own);
}

/** Names in a row, each once, with how often it is meant. */
function listed(names: readonly string[]): string {
  const words = [...new Set(names)].map((name) => {
    const count = names.filter((one) => one === name).length;
    return count > 1 ? `${count} × ${name}` : name;
  });
  return words.length < 2 ? words.join("") : say("{some} and {last}", { some: words.slice(0, -1).join(", "), last: words.at(-1) ?? "" });
}

export function shortfallsOf(scene: Scene): Shortfalls {
  const names = roomNames(scene);
  const rooms = Object.entries(scene.certificate?.rooms ?? {}).map(([id, said]) => ({ id, name: names.get(id) ?? id, said }));
  const said = (scene.certificate?.notes ?? []).map((note) => ({ words: sentence(note, scene), whys: [], room: null, isBeside: note.startsWith(GARDEN_ALONE) }));
  const [notes, beside] = [said.filter(({ isBeside }) => !isBeside), said.filter(({ isBeside }) => isBeside)];
  const { profile = "", unmet = [] } = scene.certificate?.access ?? {};
  const access = unmet.map((one) => ({ words: say("Access, {profile}: {said}", { profile: sayName(profile), said: sentence(one, scene) }), whys: [], room: null }));
  const ofRooms = rooms.flatMap(({ id, name, said }) => (said.notes ?? []).map((note) => ({ words: `${name}: ${sentence(note, scene)}`, whys: [], room: id })));
  const open = rooms.filter(({ said }) => said.proven === false).map(({ id, name }) => ({
    words: say("{name}: not proven to be the best. The search ended at its limit; there may be a better arrangement.", { name }), whys: [], room: id,
  }));
  const leftOut = rooms.flatMap(({ id, name, said }) => [true, false].flatMap((isFull) => {
    const pieces = (said.left_out ?? []).filter(({ reason }) => reason.startsWith(FULL) === isFull);
    const things = listed(pieces.map(pieceWords));
    const words = isFull ? say("{name}: full enough without {things}.", { name, things }) : say("{name}: no place found for {things}.", { name, things });
    return pieces.length > 0 ? [{ words, whys: pieces.map((one) => `${capital(pieceWords(one))}: ${tell(one.reason, scene)}.`), room: id }] : [];
  }));
  const all = rooms.flatMap(({ said }) => said.left_out ?? []);
  const spare = all.filter(({ reason }) => reason.startsWith(FULL)).length;
  return { asked: [...notes, ...access, ...ofRooms, ...open], beside, leftOut, pieces: all.length - spare, spare };
}

/** What became of the pieces that do not stand, by their numbers: some were tried in vain, of others there is enough; where all stand, what nobody misses. */
function piecesLine({ beside, pieces, spare }: Shortfalls): string[] {
  return [
    ...(pieces === 0 && spare === 0 && beside.length > 0 ? beside.map(({ words }) => words) : []),
    ...(pieces === 1 ? [say("1 more piece was tried and found no place.")] : []),
    ...(pieces > 1 ? [say("{count} more pieces were tried and found no place.", { count: pieces })] : []),
    ...(spare > 0 && pieces === 0 ? [say("The rooms are furnished as fully as wished.")] : []),
  ];
}

/** All in one line: what was asked in full, then of the pieces; empty where there is nothing to say. */
export function shortfallLine(found: Shortfalls): string {
  const { asked } = found;
  const [first, ...more] = asked;
  const said = first ? [first.words + (more.length > 0 ? ` ${say("And {count} more.", { count: more.length })}` : "")] : [];
  return [...said, ...piecesLine(found)].join(" ");
}

export class ShortfallPanel {
  /** Called with a room's id. */
  onChooseRoom: (id: string) => void = () => undefined;

  constructor(readonly section: HTMLDetailsElement, readonly list: HTMLElement, readonly line: HTMLButtonElement) {
    line.addEventListener("click", () => this.#open());
  }

  show(scene: Scene): void {
    const found = shortfallsOf(scene);
    this.section.hidden = found.asked.length + found.beside.length + found.leftOut.length === 0;
    this.line.hidden = this.section.hidden;
    this.line.textContent = shortfallLine(found);
    this.line.classList.toggle("is-asked", found.asked.length > 0);
    this.line.parentElement?.querySelector(".verdict")?.classList.toggle("is-short", found.asked.length > 0);
    this.list.replaceChildren(...[...found.asked, ...found.beside, ...found.leftOut].map((one) => this.#item(one)));
  }

  #open(): void {
    this.section.open = true;
    const summary = this.section.querySelector("summary");
    summary?.scrollIntoView({ block: "nearest" });
    summary?.focus();
  }

  #item({ words, whys, room }: Shortfall): HTMLElement {
    if (room === null) return made("li", {}, words);
    const choose = button(words, () => this.onChooseRoom(room), { className: "shortfall" });
    return made("li", {}, choose, ...(whys.length > 0 ? [this.#whys(whys)] : []));
  }

  #whys(whys: readonly string[]): HTMLElement {
    return made("details", {}, made("summary", {}, say("Why")), ...whys.map((why) => made("p", { className: "hint" }, why)));
  }
}
