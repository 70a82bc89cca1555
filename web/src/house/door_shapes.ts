/** What door leaves are made of: parts in a leaf's own frame, hinge at the west end, its middle at the footprint's centre. Pure. */
import type { Leaf } from "./door_leaves";
import { LEAF_THICKNESS } from "./door_leaves";
import { plainPaint, shade, type Paint } from "./paints";
import { part, type Part } from "./parts";

/** What the leaves of a house are painted with. */
export interface DoorPaints {
  readonly wood: Paint;
  readonly metal: Paint;
}

export const ENTRANCE_COLOR = "#c0392b";
const ENTRANCE: Paint = { ...plainPaint(ENTRANCE_COLOR), roughness: 0.55 };
const TERRACE: Paint = { ...plainPaint("#e6e2d9"), roughness: 0.55 };
const GARAGE: Paint = { ...plainPaint("#c3c9ce"), roughness: 0.5 };
const GATE = plainPaint("#8a7a66", "wood");
const GLASS: Paint = { ...plainPaint("#bfe0f0"), roughness: 0.08, opacity: 0.4 };
export const PLAIN_PAINTS: DoorPaints = { wood: plainPaint("#a87f55", "wood"), metal: { ...plainPaint("#b4b8bc"), roughness: 0.35, metalness: 0.6 } };

/** All lengths [m]. */
const STILE = 0.11;
const TOP_RAIL = 0.12;
const BOTTOM_RAIL = 0.2;
const LOCK_RAIL = [0.88, 1.06] as const;
const HANDLE_HEIGHT = 1.0;
const FROM_EDGE = 0.06;
/** With half a leaf no more than a frame is wide, so that an open leaf stays over the floor kept free at a door. */
const HANDLE_PROUD = 0.04;
const LEVER = 0.016;
const INSET = 0.012;
const MOULDING = 0.05;
const SECTION = 0.55;
const GROOVE = 0.012;
const SLAT = 0.05;
/** In what is less wide or high the rails, mouldings and handles of a leaf do not fit beside each other; nor in a gate less than 0.3 m high. */
const NARROWEST = 0.3;
const LOWEST = 1.4;

type Reach = readonly [number, number];

/** A box between two corners of the leaf's plane, so thick. */
function board(x: Reach, y: Reach, thick: number, paint: Paint): Part {
  return part("box", [x[1] - x[0], y[1] - y[0], thick], [(x[0] + x[1]) / 2, (y[0] + y[1]) / 2, 0], paint);
}

/** Stiles and rails round fields of these heights, and what fills a field. */
function framed({ width, height }: Leaf, fields: readonly Reach[], paint: Paint, fill: (x: Reach, y: Reach) => Part[]): Part[] {
  const [half, inner] = [width / 2, width / 2 - Math.min(STILE, width * 0.17)];
  const rails = [0, ...fields.flat(), height];
  return [
    board([-half, -inner], [0, height], LEAF_THICKNESS, paint),
    board([inner, half], [0, height], LEAF_THICKNESS, paint),
    ...fields.flatMap((_, i) => board([-inner, inner], [rails[2 * i] ?? 0, rails[2 * i + 1] ?? 0], LEAF_THICKNESS, paint)),
    board([-inner, inner], [rails.at(-2) ?? 0, height], LEAF_THICKNESS, paint),
    ...fields.flatMap((field) => fill([-inner, inner], field)),
  ];
}

/** A lever on both sides, at the end away from the hinge. */
function handles({ width, height }: Leaf, metal: Paint): Part[] {
  const [x, y, neck] = [width / 2 - FROM_EDGE, Math.min(HANDLE_HEIGHT, height * 0.8), HANDLE_PROUD - LEVER];
  return [-1, 1].flatMap((side) => {
    const at = (out: number): number => side * (LEAF_THICKNESS / 2 + out);
    return [
      part("box", [0.045, 0.17, 0.008], [x, y - 0.03, at(0.004)], metal),
      part("box", [0.02, 0.02, neck], [x, y, at(neck / 2)], metal),
      part("box", [0.13, 0.022, LEVER], [x - 0.055, y, at(neck + LEVER / 2)], metal),
    ];
  });
}

function panelled(leaf: Leaf, paint: Paint, metal: Paint): Part[] {
  const sunk = { ...paint, color: shade(paint.color, -0.14) };
  const fields = [[BOTTOM_RAIL, LOCK_RAIL[0]], [LOCK_RAIL[1], leaf.height - TOP_RAIL]] as const;
  const fill = (x: Reach, y: Reach): Part[] => [
    board(x, y, LEAF_THICKNESS - 2 * INSET, sunk),
    board([x[0] + MOULDING, x[1] - MOULDING], [y[0] + MOULDING, y[1] - MOULDING], LEAF_THICKNESS - INSET, paint),
  ];
  return [...framed(leaf, fields, paint, fill), ...handles(leaf, metal)];
}

function glazed(leaf: Leaf, metal: Paint): Part[] {
  const fields = [[0.3, 1.1], [1.16, leaf.height - TOP_RAIL]] as const;
  return [...framed(leaf, fields, TERRACE, (x, y) => [board(x, y, 0.012, GLASS)]), ...handles(leaf, metal)];
}

/** Sections one above the other, each with a row of raised fields. */
function sectional({ width, height }: Leaf, metal: Paint): Part[] {
  const count = Math.max(2, Math.round(height / SECTION));
  const [step, fields] = [height / count, Math.max(2, Math.round(width / 0.7))];
  const [half, pitch] = [width / 2, width / fields];
  const rows = Array.from({ length: count }, (_, i) => i * step);
  const [groove, raised] = [-0.5, 0.2].map((share): Paint => ({ ...GARAGE, color: shade(GARAGE.color, share) })) as [Paint, Paint];
  const columns = Array.from({ length: fields }, (_, j): Reach => [j * pitch - half + 0.07, (j + 1) * pitch - half - 0.07]);
  return [
    board([-half, half], [0, height], 0.02, groove),
    ...rows.map((low) => board([-half, half], [low, low + step - GROOVE], LEAF_THICKNESS, GARAGE)),
    ...rows.flatMap((low) => columns.map((x) => board(x, [low + 0.1, low + step - 0.1 - GROOVE], LEAF_THICKNESS + 0.016, raised))),
    board([-0.1, 0.1], [0.04, 0.07], LEAF_THICKNESS + 0.06, metal),
  ];
}

/** Slats between two rails. */
function gate({ width, height }: Leaf): Part[] {
  const half = width / 2;
  const slats = Math.max(3, Math.round(width / (2.4 * SLAT)));
  const pitch = (width - SLAT) / (slats - 1);
  return [
    ...Array.from({ length: slats }, (_, i) => board([i * pitch - half, i * pitch - half + SLAT], [0.03, height], 0.022, GATE)),
    board([-half, half], [0.1, 0.16], LEAF_THICKNESS, GATE),
    board([-half, half], [height - 0.13, height - 0.07], LEAF_THICKNESS, GATE),
  ];
}

/** A leaf's parts, closed and whole; a leaf too small for its rails is a larger one, made smaller. */
export function partsOfLeaf(leaf: Leaf, paints: DoorPaints = PLAIN_PAINTS): Part[] {
  const width = Math.max(leaf.width, NARROWEST);
  const height = Math.max(leaf.height, leaf.look === "gate" ? NARROWEST : LOWEST);
  const [across, up] = [leaf.width / width, leaf.height / height];
  const made = madeParts({ ...leaf, width, height }, paints);
  if (across === 1 && up === 1) return made;
  return made.map((one) => ({ ...one, size: [one.size[0] * across, one.size[1] * up, one.size[2]], at: [one.at[0] * across, one.at[1] * up, one.at[2]] }));
}

function madeParts(leaf: Leaf, paints: DoorPaints): Part[] {
  if (leaf.look === "sectional") return sectional(leaf, paints.metal);
  if (leaf.look === "gate") return gate(leaf);
  if (leaf.look === "glazed") return glazed(leaf, paints.metal);
  return panelled(leaf, leaf.look === "entrance" ? ENTRANCE : paints.wood, paints.metal);
}

/** What shows of a part that is lifted so far, under a height [m]; null where nothing does. */
export function shown(whole: Part, lift: number, top: number): Part | null {
  const [x, y, z] = whole.at;
  const low = y + lift - whole.size[1] / 2;
  const high = Math.min(low + whole.size[1], top);
  if (high <= low) return null;
  return { ...whole, size: [whole.size[0], high - low, whole.size[2]], at: [x, (low + high) / 2, z] };
}
