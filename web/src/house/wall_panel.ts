/** A piece of wall as a panel with holes: what walls are made of, and faces and finishes are found for. */
import type { Axis, Span } from "./boxes";

/** A hole in a panel: along the wall, and up from the storey's floor [m]. */
export interface Hole {
  readonly along: Span;
  readonly up: Span;
}

/** A straight piece of wall of one height with its holes [m]. */
export interface WallPanel {
  readonly axis: Axis;
  readonly along: Span;
  readonly across: Span;
  readonly elevation: number;
  readonly height: number;
  readonly level: number;
  readonly holes: readonly Hole[];
  /** Where its faces are parted, so that each looks into one room [m along]. */
  readonly seams: readonly number[];
  /** Whether an end is to be seen; one that runs into another wall is not. */
  readonly openStart: boolean;
  readonly openEnd: boolean;
}
