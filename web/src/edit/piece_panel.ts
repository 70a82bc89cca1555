/** What is chosen in numbers: its size, angle, kind and colour; of several, how they are lined up. */
import type { Body, Catalog, Furniture } from "../contract";
import { words } from "../house/frame";
import { lengthTyped, lengthWords } from "./lengths";
import type { Alignment } from "./many_edits";
import { EXTENTS, isSizable, sizeRange, variantsOf } from "./size_range";
import { button, made } from "../made";
import { replaceKeepingFocus } from "../panel/focus";
import { say, sayNumber, type Words } from "../words/language";

export interface PieceWords {
  change(id: string, change: Partial<Furniture>): void;
  paint(id: string, color: string): void;
  turnTo(id: string, rotation: number): void;
  align(how: Alignment): void;
}

const ALIGNMENTS: readonly (readonly [Alignment, Words])[] = [
  ["west", "West edges"], ["across", "Middles, west to east"], ["east", "East edges"], ["north", "North edges"], ["along", "Middles, north to south"], ["south", "South edges"],
];
const FALLBACK_COLOR = "#8b949e";

export class PiecePanel {
  readonly #body = made("div", { className: "piece-fields" });
  readonly #title = made("summary");
  #shown = "";

  constructor(readonly host: HTMLDetailsElement, readonly say: PieceWords) {
    host.replaceChildren(this.#title, this.#body);
  }

  /** Shows what is chosen: a piece of furniture, a decoration, or several; who changes it by keys goes on with them. */
  show(catalog: Catalog | null, piece: Furniture | null, thing: Body | null, count: number): void {
    const shown = JSON.stringify([piece, thing?.id, thing?.color, count, catalog !== null]);
    if (shown === this.#shown) return;
    this.#shown = shown;
    this.host.hidden = count === 0 || (!piece && !thing);
    this.#title.textContent = count > 1 ? say("{count} chosen: line up", { count }) : say("Size, angle, colour");
    replaceKeepingFocus(this.#body, (count > 1 ? this.#alignments() : piece ? this.#ofPiece(catalog, piece) : thing ? [this.#colors(catalog, thing, null)] : []));
  }

  #alignments(): HTMLElement[] {
    return ALIGNMENTS.map(([how, said]) => button(say(said), () => this.say.align(how), { "data-align": how }));
  }

  #ofPiece(catalog: Catalog | null, piece: Furniture): HTMLElement[] {
    const variants = catalog ? variantsOf(catalog, piece) : [];
    return [
      ...EXTENTS.map((extent) => this.#size(catalog, piece, extent)),
      this.#angle(piece),
      ...(catalog && variants.length > 1 && !piece.asset ? [this.#kind(catalog, piece, variants)] : []),
      this.#colors(catalog, piece, piece.kind ?? null),
    ];
  }

  #size(catalog: Catalog | null, piece: Furniture, extent: (typeof EXTENTS)[number]): HTMLElement {
    const range = catalog ? sizeRange(catalog, piece)[extent] : [piece[extent], piece[extent]] as const;
    const input = made("input", {
      name: extent, value: lengthWords(Math.round(piece[extent] * 1000)), disabled: !isSizable(range) || piece.locked === true,
      title: isSizable(range) ? say("{from} to {to} m", { from: sayNumber(range[0], 2), to: sayNumber(range[1], 2) }) : say("This kind has one size"),
    });
    input.addEventListener("keydown", (event) => { if (event.key === "Escape") input.blur(); });
    input.addEventListener("change", () => {
      const typed = lengthTyped(input.value);
      const isTaken = typed !== null && typed / 1000 >= range[0] && typed / 1000 <= range[1];
      input.setAttribute("aria-invalid", String(!isTaken));
      if (isTaken && typed / 1000 !== piece[extent]) this.say.change(piece.id, { [extent]: typed / 1000 });
    });
    return labelled(extent, input);
  }

  #angle(piece: Furniture): HTMLElement {
    const degrees = [...new Set([0, 90, 180, 270, piece.rotation ?? 0])].map((one) => made("option", { value: String(one) }, `${one}°`));
    const select = made("select", { name: "angle", disabled: piece.locked === true }, ...degrees);
    select.value = String(piece.rotation ?? 0);
    select.addEventListener("change", () => this.say.turnTo(piece.id, Number(select.value)));
    return labelled("angle", select);
  }

  #kind(catalog: Catalog, piece: Furniture, variants: readonly string[]): HTMLElement {
    const select = made("select", { name: "kind", disabled: piece.locked === true }, ...variants.map((key) => made("option", { value: key }, words(key))));
    select.value = piece.kind ?? "";
    select.addEventListener("change", () => {
      const [width, depth, height] = catalog.furniture[select.value]?.size ?? [piece.width, piece.depth, piece.height];
      this.say.change(piece.id, { kind: select.value, width, depth, height });
    });
    return labelled("kind", select);
  }

  #colors(catalog: Catalog | null, body: Body, kind: string | null): HTMLElement {
    const known = kind === null ? undefined : catalog?.furniture[kind];
    const colour = /^#[0-9a-f]{6}$/i.test(body.color ?? "") ? (body.color as string) : FALLBACK_COLOR;
    const own = made("input", { type: "color", name: "color", value: colour, "aria-label": say("Any colour") });
    own.addEventListener("change", () => this.say.paint(body.id, own.value));
    const offered = [...new Set([known?.color, ...(known?.variants ?? [])].filter((color) => typeof color === "string"))];
    return made("div", { className: "swatches", role: "group", "aria-label": say("Colour") }, ...offered.map((color) => this.#swatch(body, color)), own);
  }

  #swatch(body: Body, color: string): HTMLElement {
    const isWorn = body.color?.toLowerCase() === color.toLowerCase();
    const swatch = button("", () => this.say.paint(body.id, color), { "aria-label": say("Colour {colour}", { colour: color }), "aria-pressed": isWorn });
    swatch.style.backgroundColor = color;
    return swatch;
  }
}

function labelled(said: Words, field: HTMLElement): HTMLElement {
  return made("label", {}, say(said), field);
}
