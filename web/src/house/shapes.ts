/** What a body is drawn as: a few parts in its own frame, front at +z, underside at y = 0. Pure. */
import type { Catalog, CatalogPart } from "../contract";
import type { PlacedBody } from "./frame";
import { frontsOf, type Front } from "./fronts";
import { livingParts, seatedParts } from "./living";
import { PLAIN_PAINTS, type DoorPaints } from "./door_shapes";
import { isLight, Paints, plainPaint, shade, type Paint } from "./paints";
import { part, type Part } from "./parts";

/** Lower than this a body is a rug or a mat: it has no front to mark. */
const FLAT = 0.05;
const ARROW_HEIGHT = 0.006;
/** The parts of this many bodies are remembered: those of several houses. */
const MOST_KNOWN = 5000;

/** A small arrow on top, at the front edge: which way a box looks. */
function frontArrow(body: PlacedBody): Part {
  const length = Math.min(0.2, body.depth * 0.32, body.width * 0.32);
  const at = [0, body.height + ARROW_HEIGHT / 2, body.depth / 2 - length / 2 - Math.min(0.06, body.depth * 0.1)] as const;
  const paint = plainPaint(shade(body.color, isLight(body.color) ? -0.45 : 0.5));
  return { ...part("cone", [length * 1.25, ARROW_HEIGHT, length], at, paint), axis: "z" };
}

/** How a body looks of which nothing is known: its box. */
function boxParts(body: PlacedBody): Part[] {
  const { width, height, depth, color } = body;
  const block = part("rounded", [width, height, depth], [0, height / 2, 0], plainPaint(color));
  return body.kind === "furniture" && height > FLAT ? [block, frontArrow(body)] : [block];
}

/** The catalog's shapes, found by the kinds that scenes name; without a catalog everything is its box. */
export class ShapeBook {
  readonly #paints = new Map<string, Paints>();
  readonly #known = new Map<string, readonly Part[]>();

  constructor(readonly catalog: Catalog | null) {}

  /** The parts that a body is drawn with in a house of this style; bodies that are alike share them. */
  partsOf(body: PlacedBody, style: string | null): readonly Part[] {
    const { kind, name, shape, seat, width, depth, height, color, accent } = body;
    const key = `${style} ${kind} ${name} ${shape} ${seat} ${width} ${depth} ${height} ${color} ${accent}`;
    const known = this.#known.get(key) ?? this.#make(body, style);
    if (this.#known.size > MOST_KNOWN) this.#known.clear();
    this.#known.set(key, known);
    return known;
  }

  #make(body: PlacedBody, style: string | null): Part[] {
    const parts = this.#solidsOf(body);
    if (!parts && body.kind === "dynamic") return body.seat === undefined ? livingParts(body) : seatedParts(body, body.seat);
    if (!parts) return boxParts(body);
    const paints = this.#paintsOf(style);
    return parts.map((solid) => sized(solid, body, paints));
  }

  /** Whether a body gives light. */
  isLamp({ shape }: PlacedBody): boolean {
    const { furniture = {}, decorations = {} } = this.catalog ?? {};
    const of = (kinds: Catalog["furniture"]) => (shape && Object.hasOwn(kinds, shape) ? kinds[shape] : undefined);
    return of(furniture)?.category === "lighting" || of(decorations)?.group === "lighting";
  }

  /** What opens of a body. */
  frontsOf(body: PlacedBody): readonly Front[] {
    return frontsOf(this.#solidsOf(body) ?? [], body);
  }

  /** What doors are painted with in a house of this style. */
  doorPaints(style: string | null): DoorPaints {
    if (!this.catalog) return PLAIN_PAINTS;
    const paints = this.#paintsOf(style);
    const of = (slot: keyof DoorPaints): Paint => paints.of(slot, PLAIN_PAINTS[slot]);
    return { wood: of("wood"), metal: of("metal") };
  }

  #paintsOf(style: string | null): Paints {
    const key = style ?? "";
    const known = this.#paints.get(key) ?? new Paints(this.catalog, style);
    this.#paints.set(key, known);
    return known;
  }

  #solidsOf({ shape }: PlacedBody): readonly CatalogPart[] | undefined {
    const shapes = this.catalog?.shapes ?? {};
    const solids = shape && Object.hasOwn(shapes, shape) ? shapes[shape] : undefined;
    return solids?.length ? solids : undefined;
  }
}

function sized({ form, x, y, z, axis, taper, material, front }: CatalogPart, body: PlacedBody, paints: Paints): Part {
  const { width, height, depth } = body;
  return {
    form,
    size: [(x[1] - x[0]) * width, (y[1] - y[0]) * height, (z[1] - z[0]) * depth],
    at: [((x[0] + x[1]) / 2 - 0.5) * width, ((y[0] + y[1]) / 2) * height, ((z[0] + z[1]) / 2 - 0.5) * depth],
    axis: axis ?? "y",
    taper: taper ?? (form === "cone" ? 0 : 1),
    paint: paints.of(material, body),
    ...(front ? { front } : {}),
  };
}
