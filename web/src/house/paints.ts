/** What parts are painted with: a catalog's material slots with a style's changes, in a body's own colour where they have none. Pure. */
import type { Catalog, CatalogMaterial } from "../contract";
import type { PlacedBody } from "./frame";

export interface Paint {
  readonly color: string;
  readonly roughness: number;
  readonly metalness: number;
  readonly opacity: number;
  readonly glow: number;
  readonly texture: string | null;
}

/** The slot that is drawn in the accent of the room a body is in: the hem of rugs. */
const ACCENT_SLOT = "rug_border";

function channels(color: string): [number, number, number] {
  const value = Number.parseInt(color.slice(1, 7), 16);
  return Number.isNaN(value) ? [128, 128, 128] : [(value >> 16) & 255, (value >> 8) & 255, value & 255];
}

function hex(values: readonly number[]): string {
  return `#${values.map((value) => Math.round(value).toString(16).padStart(2, "0")).join("")}`;
}

/** A colour moved towards white (share > 0) or black (share < 0). */
export function shade(color: string, share: number): string {
  const goal = share > 0 ? 255 : 0;
  return hex(channels(color).map((channel) => channel + (goal - channel) * Math.abs(share)));
}

export function isLight(color: string): boolean {
  const [red, green, blue] = channels(color);
  return 0.299 * red + 0.587 * green + 0.114 * blue > 140;
}

export function plainPaint(color: string, texture: string | null = null): Paint {
  return { color, roughness: 0.8, metalness: 0, opacity: 1, glow: 0, texture };
}

/** The paints of one style. */
export class Paints {
  readonly #slots = new Map<string, CatalogMaterial>();
  readonly #mixed = new Map<string, Paint>();

  constructor(catalog: Catalog | null, style: string | null) {
    for (const [slot, material] of Object.entries(catalog?.materials ?? {})) this.#slots.set(slot, material);
    const styles = catalog?.styles ?? {};
    const changes = style !== null && Object.hasOwn(styles, style) ? (styles[style]?.materials ?? {}) : {};
    for (const [slot, change] of Object.entries(changes)) this.#slots.set(slot, { ...this.#slots.get(slot), ...change });
  }

  /** The paint of a slot on a body; an unknown slot is the body's own colour. */
  of(slot: string, body: Pick<PlacedBody, "color" | "accent">): Paint {
    const own = slot === ACCENT_SLOT ? (body.accent ?? body.color) : body.color;
    const key = `${slot} ${own}`;
    const known = this.#mixed.get(key) ?? this.#mix(this.#slots.get(slot) ?? {}, own);
    this.#mixed.set(key, known);
    return known;
  }

  #mix(material: CatalogMaterial, own: string): Paint {
    return {
      color: shade(material.color ?? own, material.shade ?? 0),
      roughness: material.roughness ?? 0.8,
      metalness: material.metalness ?? 0,
      opacity: material.opacity ?? 1,
      glow: material.glow ?? 0,
      texture: material.texture ?? null,
    };
  }
}
