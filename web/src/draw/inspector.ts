/** The panel beside the sheet: the chosen room or opening in exact numbers, all rooms, and the picture beneath. */
import type { Catalog, OpeningKind } from "../contract";
import { inWords } from "../panel/programme";
import { button, made } from "../made";
import { roomNames } from "../panel/room";
import { wallsOf, type Wall } from "./corners";
import { OPENING_SIZES, wallLengthened, wallsAt, withOpeningAt, withOpeningChanged, withoutOpening, withName, withoutRoom, withType, type Draft, type DraftOpening, type DraftRoom } from "./draft";
import type { DrawnPlan } from "./drawn_plan";
import { choiceField, group, hint, lengthField, row, switchField, textField } from "./elements";
import { UNTYPED } from "./scene_draft";
import { inMetres } from "./sheet";
import { capital, say, sayArea, type Words } from "../words/language";

const GUESS = say("Guess it");

const WALL_WORDS: Readonly<Record<string, Words>> = { "x1": "north", "x-1": "south", "z1": "west", "z-1": "east" };
const KIND_WORDS: readonly (readonly [OpeningKind, string])[] = [["door", say("Door")], ["passage", say("Passage")], ["window", say("Window")], ["garage_door", say("Garage door")]];

/** What each room is called. */
export function draftNames({ rooms }: Draft): ReadonlyMap<string, string> {
  return roomNames({ rooms: rooms.map((room) => ({ ...room, type: room.type ?? UNTYPED })) });
}

/** The walls of a room with words for them: where there are several on a side, numbered. */
function namedWalls({ corners }: DraftRoom): { readonly wall: Wall; readonly words: string }[] {
  const walls = wallsOf(corners);
  const side = (wall: Wall): string => say(WALL_WORDS[`${wall.axis}${wall.inward}`] ?? "north");
  return walls.map((wall) => {
    const same = walls.filter((other) => side(other) === side(wall));
    return { wall, words: same.length > 1 ? say("{side} wall {number}", { side: side(wall), number: same.indexOf(wall) + 1 }) : say("{side} wall", { side: side(wall) }) };
  });
}

export class Inspector {
  /** The types that a room can be of. */
  types: NonNullable<Catalog["rooms"]> = {};
  #areas: ReadonlyMap<string, number> = new Map();
  /** The id of the room or opening that is shown. */
  #shown: string | undefined;

  constructor(readonly host: HTMLElement, readonly plan: DrawnPlan, readonly said: (words: string) => void) {}

  /** Shows what is chosen; `beneath` are the picture's own controls, `areas` the rooms' clear floors [m²]. What has the focus keeps it; chosen from here, another room's name has it, or an opening's first field. */
  show(beneath: readonly HTMLElement[], areas: ReadonlyMap<string, number>): void {
    this.#areas = areas;
    const { draft, chosen } = this.plan;
    const room = draft.rooms.find(({ id }) => id === chosen.room);
    const opening = draft.openings.find(({ id }) => id === chosen.opening);
    const focused = this.#focused();
    const isOther = focused >= 0 && this.#shown !== (opening?.id ?? room?.id);
    this.#shown = opening?.id ?? room?.id;
    this.host.replaceChildren(...(room ? this.#room(room) : opening ? this.#opening(opening) : []), this.#rooms(draft), ...beneath);
    if (isOther && (opening || room)) this.host.querySelector<HTMLElement>(opening ? "select" : ".drawing-rooms [aria-pressed=true]")?.focus({ preventScroll: true });
    else this.#focus(focused);
  }

  /** The place of the focused field among all, to find it again among those that take their place. */
  #focused(): number {
    return [...this.host.querySelectorAll("input, select, button")].indexOf(document.activeElement as Element);
  }

  #focus(index: number): void {
    const field = [...this.host.querySelectorAll<HTMLElement>("input, select, button")][index];
    field?.focus({ preventScroll: true });
  }

  /** Takes a changed plan, or says why not. */
  #take(draft: Draft | null, refusal: string): boolean {
    if (draft) this.plan.step(draft);
    else this.said(refusal);
    return draft !== null;
  }

  #room(room: DraftRoom): HTMLElement[] {
    const name = draftNames(this.plan.draft).get(room.id) ?? room.id;
    const types = [["", GUESS] as const, ...Object.keys(this.types).sort().map((type) => [type, inWords(type)] as const)];
    const title = `${capital(name)}, ${this.#area(room.id)}`;
    return [group(title,
      textField(say("Name"), room.name, (words) => this.plan.step(withName(this.plan.settled, room.id, words))),
      choiceField(say("Type"), types, room.type ?? "", (type) => this.plan.step(withType(this.plan.settled, room.id, type || null, this.types[type]?.outdoor))),
      ...namedWalls(room).map(({ wall, words }) => this.#wall(room, wall, words)),
      row(button(say("Delete the room"), () => this.plan.step(withoutRoom(this.plan.settled, room.id)))),
    )];
  }

  #wall(room: DraftRoom, wall: Wall, words: string): HTMLElement {
    const take = (length: number): boolean => this.#take(
      wallLengthened(this.plan.settled, room.id, wall.index, length), say("The wall cannot be so long: rooms would meet, or nothing would be left."));
    const puts = (["door", "window"] as const).map((kind) => button(say(kind === "door" ? "Door" : "Window"), () => this.put(kind, room, wall), { "aria-label": say(`Add a ${kind} to the {wall}`, { wall: words }) }));
    return row(lengthField(capital(words), wall.to - wall.from, take), ...puts);
  }

  /** Puts an opening into one of a room's walls, where most of it is free. */
  put(kind: OpeningKind, { id }: DraftRoom, side: Partial<Wall>): void {
    const put = withOpeningAt(this.plan.settled, kind, id, side);
    if (!this.#take(put?.draft ?? null, say("The wall is too short for it.")) || !put) return;
    this.plan.choose({ opening: put.id });
  }

  #opening(opening: DraftOpening): HTMLElement[] {
    const { id, kind, axis, from, to } = opening;
    const change = (more: Partial<DraftOpening>): boolean => this.#take(
      withOpeningChanged(this.plan.settled, id, more), say("It would leave its wall, or meet another opening."));
    const [wall] = wallsAt(this.plan.draft, opening);
    const corner = wall?.from ?? from;
    const isDoor = kind === "door";
    return [group(`${KIND_WORDS.find(([one]) => one === kind)?.[1] ?? kind}, ${inMetres(to - from)} m`,
      choiceField(say("Kind"), KIND_WORDS, kind, (other) => this.#changeKind(opening, other as OpeningKind)),
      lengthField(say("Width, m"), to - from, (width) => width > 0 && change({ to: from + width })),
      lengthField(say("Height, m"), opening.height, (height) => height > 0 && change({ height })),
      ...(kind === "window" ? [lengthField(say("Sill, m"), opening.sill, (sill) => sill >= 0 && change({ sill }))] : []),
      lengthField(say(axis === "x" ? "From the west corner, m" : "From the north corner, m"), from - corner, (off) => change({ from: corner + off, to: corner + off + to - from })),
      ...(isDoor ? [row(button(say("Hinge at the other end"), () => change({ hinge: opening.hinge === "start" ? "end" : "start" })),
        button(say("Opens to the other side"), () => change({ swing: opening.swing === 1 ? -1 : 1 })))] : []),
      ...(isDoor ? [switchField(say("Main entrance"), opening.isMainEntrance, (isMainEntrance) => change({ isMainEntrance }))] : []),
      row(button(say("Delete it"), () => this.plan.step(withoutOpening(this.plan.settled, id)))),
    )];
  }

  #changeKind(opening: DraftOpening, kind: OpeningKind): void {
    const { height, sill } = OPENING_SIZES[kind];
    this.#take(withOpeningChanged(this.plan.settled, opening.id, { kind, height, sill, isMainEntrance: false }), "");
  }

  #area(id: string): string {
    return sayArea(this.#areas.get(id) ?? 0);
  }

  #rooms(draft: Draft): HTMLElement {
    const indoors = draft.rooms.filter(({ outdoor }) => !outdoor);
    const total = sayArea(indoors.reduce((sum, { id }) => sum + (this.#areas.get(id) ?? 0), 0));
    const area = indoors.length < draft.rooms.length ? say("{area} indoors", { area: total }) : total;
    const names = draftNames(draft);
    const list = made("div", { className: "drawing-rooms" }, ...draft.rooms.map(({ id }) => {
      const choose = button(`, ${this.#area(id)}`, () => this.plan.choose({ room: id }), { "aria-pressed": this.plan.chosen.room === id });
      choose.prepend(made("bdi", {}, capital(names.get(id) ?? id))); // written from the right, it leaves the area where it is
      return choose;
    }));
    const words = draft.rooms.length === 0 ? say("Draw a rectangle for each room, or press “4 × 3 m”.") : say("A shared wall is one wall: dragged, both rooms follow; with Shift one alone. Alt: no snapping.");
    return group(say(draft.rooms.length === 1 ? "1 room, {area}" : "{count} rooms, {area}", { count: draft.rooms.length, area }), list, hint(words));
  }
}
