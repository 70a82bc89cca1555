/** What holds a piece as arrows in the house, and where it was wished. Pure. */
import type { Explained, Furniture, Hold, Room } from "../contract";
import { footprint, SIDES } from "./gaps";
import { lengthWords } from "./lengths";
import type { RulerLine } from "./rulers";
import { idWords as pieceWords } from "../words/telling";
import { say, sayAny, sayNumber } from "../words/language";

/** An arrow that holds with a cost of one a metre is so long; none is shorter or longer than this [m]. */
const PER_COST = 0.35;
const SHORTEST = 0.3;
const LONGEST = 1.1;
/** Arrows on one side lie so far apart [m]. */
const APART = 0.22;
/** A wish nearer than this is where it stands [mm]. */
const THERE = 20;

function holderWords({ by, what, towards }: Hold): string {
  if (what === "piece" || what === "use_side" || what === "relation") {
    if (by === null) return say("its relations");
    return what === "use_side" ? say("room to use {piece}", { piece: pieceWords(by) }) : pieceWords(by);
  }
  if (what === "floor") return by === null ? say("floor kept free") : say("floor kept free at {piece}", { piece: pieceWords(by) });
  if (what === "wall") return say("wall in the {side}", { side: sayAny(towards) });
  return say(({ door: "the door's floor", window: "the window's floor", outline: "the outline", way: "a way" } as const)[what]);
}

/** How far from where it stands a piece was wished, in words; "": it stands there. */
export function awayWords({ wished, stands }: Pick<Explained, "wished" | "stands">): string {
  const away = wished ? Math.round(100 * Math.hypot(wished[0] - stands[0], wished[1] - stands[1])) * 10 : 0;
  return away < THERE ? "" : lengthWords(away);
}

/** The arrows, each pressing on the side towards which it keeps the piece from going; and a line to where it was wished. */
export function whyLines({ holds, wished, stands }: Pick<Explained, "holds" | "wished" | "stands">, room: Room, piece: Furniture, ground: number): RulerLine[] {
  const own = footprint(piece);
  const y = ground + piece.y + Math.min(piece.height, 1) / 2;
  const spot = (axis: "x" | "z", along: number, across: number) => (axis === "x" ? [room.x + along, y, room.z + across] as const : [room.x + across, y, room.z + along] as const);
  const arrows = SIDES.flatMap(([side, axis, isLow]) => {
    const across = axis === "x" ? "z" : "x";
    const edge = own[axis][isLow ? 0 : 1] / 1000;
    const middle = (own[across][0] + own[across][1]) / 2000;
    const mine = holds.filter(({ towards }) => towards === side);
    return mine.map((hold, number): RulerLine => {
      const length = Math.max(SHORTEST, Math.min(LONGEST, hold.cost_per_m * PER_COST));
      const beside = middle + (number - (mine.length - 1) / 2) * APART;
      return { look: "hold", from: spot(axis, isLow ? edge - length : edge + length, beside), to: spot(axis, edge, beside), words: `${holderWords(hold)} · ${sayNumber(hold.cost_per_m, 2)}/m`, at: 0 };
    });
  });
  const length = awayWords({ wished, stands });
  if (!wished || !length) return arrows;
  return [...arrows, { look: "wish", from: spot("x", stands[0], stands[1]), to: spot("x", wished[0], wished[1]), words: say("wished {length} from here", { length }), at: 1 }];
}
