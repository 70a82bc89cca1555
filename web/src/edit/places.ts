/** Where a new piece belongs in a room: the places that the service finds for it, to be flipped through. */
import type { Furniture, Room, Scene } from "../contract";
import type { Editor } from "./editor";
import { added, freshId, type FurnitureKind } from "./scene_edits";
import type { Draft } from "./wishes";
import { button, made } from "../made";
import { replaceKeepingFocus } from "../panel/focus";
import { say } from "../words/language";

/** How many places are asked for. */
export const PLACES = 3;

/** Asks where a piece of a kind belongs in a room; the pieces it would be, the best first. */
export type AskPlaces = (scene: Scene, room: string, kind: FurnitureKind, id: string, signal: AbortSignal) => Promise<readonly Furniture[]>;

interface Offer {
  readonly room: string;
  readonly pieces: readonly Furniture[];
  at: number;
  /** Whether it belongs there, and does not only find room. */
  readonly belongs: boolean;
}

export class Places {
  #offer: Offer | null = null;

  constructor(readonly host: HTMLElement, readonly editor: Editor, readonly ask: AskPlaces) {}

  /** Puts a piece where it belongs, in the first of rooms with such a place; else where it can stand in the first: beside what stands there if it can, else what stands there gives way. */
  add(rooms: readonly [string, ...string[]], kind: FurnitureKind): void {
    this.hide();
    this.editor.change(async (before, signal) => {
      const offer = await this.#found(before, rooms, kind, signal);
      if (this.editor.home.settled?.scene !== before) return null;
      this.#offer = offer ?? { room: rooms[0], pieces: [added(before, rooms[0], kind).piece], at: 0, belongs: false };
      return this.#taken(this.#offer, before);
    });
  }

  async #found(scene: Scene, rooms: readonly string[], kind: FurnitureKind, signal: AbortSignal): Promise<Offer | null> {
    for (const room of rooms) {
      const pieces = await this.ask(scene, room, kind, freshId(scene, `${room}/${kind.name}`), signal);
      if (pieces.length > 0) return { room, pieces: pieces.map((piece) => ({ ...piece, color: kind.color ?? piece.color ?? null })), at: 0, belongs: true };
    }
    return null;
  }

  /** Another of the places, the next or the one before. */
  flip(by: number): void {
    const offer = this.#offer;
    if (!offer) return;
    offer.at = (offer.at + by + offer.pieces.length) % offer.pieces.length;
    this.editor.change((scene) => this.#taken(offer, scene));
  }

  /** The piece at the offer's place, what stands there kept where it is if that can be. */
  #taken({ room, pieces, at }: Offer, scene: Scene): Draft | null {
    const piece = pieces[at];
    if (!piece) return null;
    const without = (one: Room): Furniture[] => one.furniture.filter(({ id }) => id !== piece.id);
    const rooms = scene.rooms.map((one) => (one.id === room ? { ...one, furniture: [...without(one), piece] } : one));
    return { scene: { ...scene, rooms }, id: piece.id, room, locked: standingIn(scene, room).filter((id) => id !== piece.id), chosen: [piece.id] };
  }

  #show(): void {
    const offer = this.#offer;
    this.host.hidden = !offer || (offer.belongs && offer.pieces.length < 2);
    if (!offer || this.host.hidden) return;
    const words = offer.belongs ? say("Place {at} of {of}", { at: offer.at + 1, of: offer.pieces.length }) : say("No place where it belongs is free: it stands where there is room.");
    const ways = [button("◀", () => this.flip(-1), { "aria-label": say("The place before") }), button("▶", () => this.flip(1), { "aria-label": say("Another place") })];
    const keep = button("✕", () => this.hide(), { "aria-label": say("Keep it here") });
    replaceKeepingFocus(this.host, [made("span", { role: "status" }, words), ...(offer.belongs ? ways : []), keep]);
  }

  /** Another thing was done: the places are no longer offered. Tells whether any were. */
  hide(): boolean {
    const was = !this.host.hidden;
    this.#offer = null;
    this.host.hidden = true;
    return was;
  }

  /** What is shown has changed, to this scene: the offer is over, unless it was taken. */
  shown(scene: Scene | null): void {
    const piece = this.#offer?.pieces[this.#offer.at];
    if (scene?.rooms.some((room) => room.furniture.some(({ id }) => id === piece?.id))) this.#show();
    else this.hide();
  }
}

function standingIn(scene: Scene, room: string): string[] {
  return scene.rooms.find(({ id }) => id === room)?.furniture.map(({ id }) => id) ?? [];
}
