/** What is chosen in numbers: its size, angle, kind and colour; of several, how they are lined up. */
import type { Body, Catalog, Furniture } from "../contract";
import { words } from "../house/frame";
import { lengthTyped, lengthWords } from "./lengths";
import type { Alignment } from "./many_edits";
import { EXTENTS, isSizable, sizeRange, variantsOf } from "./size_range";
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
  readonly #body = document.createElement("div");
  readonly #title = document.createElement("summary");
  #shown = "";

  constructor(readonly host: HTMLDetailsElement, readonly say: PieceWords) {
    this.#body.className = "piece-fields";
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
    return ALIGNMENTS.map(([how, said]) => {
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: say(said) });
      button.dataset.align = how;
      button.addEventListener("click", () => this.say.align(how));
      return button;
    });
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
    const input = document.createElement("input");
    input.name = extent;
    input.value = lengthWords(Math.round(piece[extent] * 1000));
    input.disabled = !isSizable(range) || piece.locked === true;
    input.title = isSizable(range) ? say("{from} to {to} m", { from: sayNumber(range[0], 2), to: sayNumber(range[1], 2) }) : say("This kind has one size");
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
    const select = document.createElement("select");
    select.name = "angle";
    for (const degrees of new Set([0, 90, 180, 270, piece.rotation ?? 0])) select.append(option(`${degrees}°`, String(degrees)));
    select.value = String(piece.rotation ?? 0);
    select.disabled = piece.locked === true;
    select.addEventListener("change", () => this.say.turnTo(piece.id, Number(select.value)));
    return labelled("angle", select);
  }

  #kind(catalog: Catalog, piece: Furniture, variants: readonly string[]): HTMLElement {
    const select = document.createElement("select");
    select.name = "kind";
    select.append(...variants.map((key) => option(words(key), key)));
    select.value = piece.kind ?? "";
    select.disabled = piece.locked === true;
    select.addEventListener("change", () => {
      const [width, depth, height] = catalog.furniture[select.value]?.size ?? [piece.width, piece.depth, piece.height];
      this.say.change(piece.id, { kind: select.value, width, depth, height });
    });
    return labelled("kind", select);
  }

  #colors(catalog: Catalog | null, body: Body, kind: string | null): HTMLElement {
    const known = kind === null ? undefined : catalog?.furniture[kind];
    const own = document.createElement("input");
    own.type = "color";
    own.name = "color";
    own.value = /^#[0-9a-f]{6}$/i.test(body.color ?? "") ? (body.color as string) : FALLBACK_COLOR;
    own.setAttribute("aria-label", say("Any colour"));
    own.addEventListener("change", () => this.say.paint(body.id, own.value));
    const row = document.createElement("div");
    row.className = "swatches";
    row.setAttribute("role", "group");
    row.setAttribute("aria-label", say("Colour"));
    const offered = [...new Set([known?.color, ...(known?.variants ?? [])].filter((color) => typeof color === "string"))];
    row.append(...offered.map((color) => this.#swatch(body, color)), own);
    return row;
  }

  #swatch(body: Body, color: string): HTMLElement {
    const button = document.createElement("button");
    button.type = "button";
    button.style.backgroundColor = color;
    button.setAttribute("aria-label", say("Colour {colour}", { colour: color }));
    button.setAttribute("aria-pressed", String(body.color?.toLowerCase() === color.toLowerCase()));
    button.addEventListener("click", () => this.say.paint(body.id, color));
    return button;
  }
}

function labelled(said: Words, field: HTMLElement): HTMLElement {
  const label = document.createElement("label");
  label.append(say(said), field);
  return label;
}

function option(textContent: string, value: string): HTMLOptionElement {
  return Object.assign(document.createElement("option"), { textContent, value });
}
