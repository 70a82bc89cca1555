/** Where a new piece belongs in a room: the places that the service finds for it, to be flipped through. */
import type { Furniture, Scene } from "../contract";
import type { Editor } from "./editor";
import { freshId, type FurnitureKind } from "./scene_edits";
import { replaceKeepingFocus } from "../panel/focus";
import { say } from "../words/language";

/** How many places are asked for. */
export const PLACES = 3;

/** Asks where a piece of a kind belongs in a room; the pieces it would be, the best first. */
export type AskPlaces = (scene: Scene, room: string, kind: FurnitureKind, id: string) => Promise<readonly Furniture[]>;

interface Offer {
  readonly room: string;
  /** The house without the piece. */
  readonly before: Scene;
  readonly pieces: readonly Furniture[];
  at: number;
}

export class Places {
  #offer: Offer | null = null;
  #asked = 0;

  constructor(readonly host: HTMLElement, readonly editor: Editor, readonly ask: AskPlaces) {}

  /** Puts a piece where it belongs, else where it can stand. */
  async add(room: string, kind: FurnitureKind): Promise<void> {
    this.hide();
    const before = this.editor.home.settled?.scene;
    if (!before) return;
    const asked = ++this.#asked;
    const id = freshId(before, `${room}/${kind.name}`);
    const pieces = await this.ask(before, room, kind, id);
    if (asked !== this.#asked || this.editor.home.settled?.scene !== before) return;
    if (pieces.length === 0) {
      this.editor.add(room, kind);
      return;
    }
    this.#offer = { room, before, pieces: pieces.map((piece) => ({ ...piece, color: kind.color ?? piece.color ?? null })), at: 0 };
    this.#put(this.#offer);
  }

  /** Another of the places, the next or the one before. */
  flip(by: number): void {
    const offer = this.#offer;
    if (!offer) return;
    offer.at = (offer.at + by + offer.pieces.length) % offer.pieces.length;
    this.#put(offer);
  }

  /** The piece at the offer's place, what stands there kept where it is if that can be. */
  #put({ room, before, pieces, at }: Offer): void {
    const piece = pieces[at];
    if (!piece) return;
    const others = before.rooms.find(({ id }) => id === room)?.furniture.map(({ id }) => id) ?? [];
    const rooms = before.rooms.map((one) => (one.id === room ? { ...one, furniture: [...one.furniture, piece] } : one));
    this.editor.change(() => ({ scene: { ...before, rooms }, id: piece.id, room, locked: others, chosen: [piece.id] }));
    this.#show();
  }

  #show(): void {
    const offer = this.#offer;
    this.host.hidden = !offer || offer.pieces.length < 2;
    if (!offer || this.host.hidden) return;
    const words = document.createElement("span");
    words.textContent = say("Place {at} of {of}", { at: offer.at + 1, of: offer.pieces.length });
    words.setAttribute("role", "status");
    const buttons = [button("◀", say("The place before"), () => this.flip(-1)), button("▶", say("Another place"), () => this.flip(1)), button("✕", say("Keep it here"), () => this.hide())];
    replaceKeepingFocus(this.host, [words, ...buttons]);
  }

  /** Another thing was done: the places are no longer offered. Tells whether any were. */
  hide(): boolean {
    const was = !this.host.hidden;
    this.#offer = null;
    this.host.hidden = true;
    return was;
  }

  /** What is shown has changed, to this scene: the offer is over, unless it was taken just now. */
  shown(scene: Scene | null): void {
    const piece = this.#offer?.pieces[this.#offer.at];
    if (this.#offer && !scene?.rooms.some((room) => room.furniture.some(({ id }) => id === piece?.id))) this.hide();
  }
}

function button(sign: string, words: string, act: () => void): HTMLButtonElement {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = sign;
  made.setAttribute("aria-label", words);
  made.addEventListener("click", act);
  return made;
}
