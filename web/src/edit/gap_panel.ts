/** The distances around a piece as text; one that is clicked is typed anew. */
import type { Furniture, Room, Scene, Side } from "../contract";
import { gapsOf, type Gap } from "./gaps";
import { lengthTyped, lengthWords } from "./lengths";
import { button, made } from "../made";
import { replaceKeepingFocus } from "../panel/focus";
import { say, sayName } from "../words/language";

/** What a distance is measured to. */
export type GapTo = "wall" | "piece";

/** Words around a length that is an element. */
function around(words: string, length: HTMLElement): (Node | string)[] {
  const [before = "", after = ""] = words.split("{length}");
  return [before, length, after];
}

export class GapPanel {
  /** Called with how much nearer the piece is to come to what is on a side of it [mm]. */
  onCloser: (side: Side, millimetres: number) => void = () => undefined;
  readonly #rows: HTMLElement;
  #shown = "";
  #gaps: readonly Gap[] = [];

  constructor(readonly host: HTMLElement) {
    this.#rows = host.querySelector("dl") as HTMLElement;
  }

  /** Shows the distances around a piece of a scene, `held` where it is in hand; hides them where there is none. Returns them. */
  show(scene: Scene | null, room: Room | undefined, id: string | null, held: Furniture | null = null): readonly Gap[] {
    const piece = held ?? room?.furniture.find((one) => one.id === id);
    this.host.hidden = !room || !piece;
    this.#gaps = scene && room && piece ? gapsOf(scene, room, piece) : [];
    const shown = JSON.stringify([id, this.#gaps]);
    if (shown !== this.#shown) replaceKeepingFocus(this.#rows, this.#gaps.flatMap((gap) => this.#row(gap)));
    this.#shown = shown;
    return this.#gaps;
  }

  /** Opens the field of a distance. */
  edit(side: Side, to: GapTo): void {
    this.#rows.querySelector<HTMLElement>(`[data-gap="${side} ${to}"]`)?.click();
  }

  #row({ side, wall, piece }: Gap): HTMLElement[] {
    const [term, said] = [made("dt", {}, say(side)), made("dd")];
    const toWall = wall !== null && wall < 0 ? say("{length} inside the wall") : say("{length} to the wall");
    if (wall !== null) said.append(...around(toWall, this.#length(side, "wall", wall, say("the wall"))));
    if (wall !== null && piece) said.append(", ");
    if (piece) said.append(...around(say("{length} to {piece}", { piece: sayName(piece.name) }), this.#length(side, "piece", piece.mm, sayName(piece.name))));
    if (wall === null && !piece) said.append(say("open"));
    return [term, said];
  }

  #length(side: Side, to: GapTo, millimetres: number, what: string): HTMLElement {
    const words = say("{length} {side} to {what}: type another length", { length: lengthWords(millimetres), side: say(side), what });
    const length = button(lengthWords(Math.abs(millimetres)), () => this.#type(length, side, millimetres), { "data-gap": `${side} ${to}`, "aria-label": words });
    return length;
  }

  #type(length: HTMLElement, side: Side, millimetres: number): void {
    const input = made("input", { value: lengthWords(millimetres), "aria-label": length.getAttribute("aria-label") ?? "" });
    let isOpen = true;
    const end = (): void => {
      const closes = isOpen && input.isConnected;
      isOpen = false; // to be taken out is to lose the focus
      if (closes) input.replaceWith(length);
    };
    input.addEventListener("blur", end);
    input.addEventListener("keydown", (event) => {
      event.stopPropagation();
      if (event.key === "Escape") end();
      if (event.key !== "Enter") return;
      const wanted = lengthTyped(input.value);
      input.setAttribute("aria-invalid", String(wanted === null));
      if (wanted === null) return;
      end();
      length.focus();
      if (wanted !== millimetres) this.onCloser(side, millimetres - wanted);
    });
    length.replaceWith(input);
    input.focus();
    input.select();
  }
}
