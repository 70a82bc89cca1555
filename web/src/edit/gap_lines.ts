/** Distances and guides of a room as lines in the house. Pure. */
import type { Furniture, Room, Side } from "../contract";
import type { GapTo } from "./gap_panel";
import { footprint, SIDES, type Gap } from "./gaps";
import { lengthWords } from "./lengths";
import type { RulerLine } from "./rulers";
import type { Guide } from "./snap";

/** So far above the floor, not to lie in it [m]. */
const RISE = 0.02;
/** Where on its line a wall's distance is written: behind that to a piece. */
const BEYOND = 0.75;

function spot(room: Room, ground: number, axis: "x" | "z", along: number, across: number): readonly [number, number, number] {
  const [x, z] = axis === "x" ? [along, across] : [across, along];
  return [room.x + x / 1000, ground + RISE, room.z + z / 1000];
}

/** The distances around a piece, from its edges on; a click on one tells which. */
export function gapLines(gaps: readonly Gap[], room: Room, piece: Furniture, ground: number, edit?: (side: Side, to: GapTo) => void): RulerLine[] {
  const own = footprint(piece);
  return SIDES.flatMap(([side, axis, isLow]): RulerLine[] => {
    const gap = gaps.find((one) => one.side === side);
    const across = axis === "x" ? "z" : "x";
    const edge = own[axis][isLow ? 0 : 1];
    const line = (to: GapTo, mm: number, middle: number, at: number): RulerLine => ({
      look: "gap", from: spot(room, ground, axis, edge, middle), to: spot(room, ground, axis, isLow ? edge - mm : edge + mm, middle),
      words: lengthWords(mm), at, ...(edit ? { act: () => edit(side, to) } : {}),
    });
    const mid = (own[across][0] + own[across][1]) / 2;
    return [
      ...(gap && gap.wall !== null && gap.wall > 0 ? [line("wall", gap.wall, mid, gap.piece ? BEYOND : 0.5)] : []),
      ...(gap?.piece && gap.piece.mm > 0 ? [line("piece", gap.piece.mm, gap.piece.at, 0.5)] : []),
    ];
  });
}

/** The lines that a piece was brought onto. */
export function guideLines(guides: readonly Guide[], room: Room, ground: number): RulerLine[] {
  return guides.map(({ axis, at, reach }) => ({
    look: "guide", from: spot(room, ground, axis, at, reach[0]), to: spot(room, ground, axis, at, reach[1]),
  }));
}
