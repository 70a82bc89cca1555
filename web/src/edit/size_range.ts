/** How large a kind may be: between the least and the greatest of the sizes that the catalog knows of it. Pure. */
import type { Catalog, Furniture } from "../contract";

type Extent = "width" | "depth" | "height";
export type SizeRange = Readonly<Record<Extent, readonly [number, number]>>;
export const EXTENTS: readonly Extent[] = ["width", "depth", "height"];
/** What the catalog does not know may have any size of furniture [m]. */
const ANY: readonly [number, number] = [0.05, 6];

/** The kinds that are called as a piece is: its kind in other sizes. */
export function variantsOf(catalog: Catalog, piece: Furniture): readonly string[] {
  const own = piece.kind ? catalog.furniture[piece.kind] : undefined;
  const name = own?.name ?? piece.kind;
  return own ? Object.entries(catalog.furniture).filter(([key, kind]) => (kind.name ?? key) === name).map(([key]) => key) : [];
}

/** Between which sizes a piece may be [m]; an own asset has the size it has. */
export function sizeRange(catalog: Catalog, piece: Furniture): SizeRange {
  const kinds = variantsOf(catalog, piece).map((key) => catalog.furniture[key]?.size ?? [0, 0, 0]);
  const sizes = [[piece.width, piece.depth, piece.height] as const, ...kinds];
  const range = (at: 0 | 1 | 2): readonly [number, number] => {
    if (piece.asset) return [sizes[0]?.[at] ?? 0, sizes[0]?.[at] ?? 0];
    if (kinds.length === 0) return ANY;
    const extents = sizes.map((size) => size[at]);
    return [Math.min(...extents), Math.max(...extents)];
  };
  return { width: range(0), depth: range(1), height: range(2) };
}

export function isSizable([least, most]: readonly [number, number]): boolean {
  return most > least;
}
