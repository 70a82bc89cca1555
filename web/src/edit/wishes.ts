/** What the editor has in hand, asks and wishes for. */
import type { FixRequest, Pose, Room, Scene } from "../contract";
import type { Frames } from "./frames";
import type { Wish } from "./scene_edits";

/** A piece in hand. */
export interface Held {
  readonly id: string;
  /** Who is dragged along beside it. */
  readonly group: readonly string[];
  /** The rooms that the drag is about. */
  readonly rooms: readonly string[];
  room: Room;
  /** The house before the drag, the piece in the room that it was dragged to. */
  whole: Scene;
  /** What frames are asked of: the room before the drag, alone; the house for a group. */
  base: Scene;
  wish: Wish;
  previous: readonly Pose[];
  /** Who answers frames in the page, once it is ready. */
  frames: Frames | null;
}

export interface Question {
  readonly held: Held;
  readonly request: FixRequest;
  /** The last of a drag, for the whole house. */
  readonly last: boolean;
  /** How often it was asked before. */
  readonly round: number;
}

/** A scene that is wished for: which piece it is about, in which room, and what is chosen once it is shown. */
export interface Draft {
  readonly scene: Scene;
  readonly id: string;
  readonly room: string;
  /** The other rooms that it changes. */
  readonly rooms?: readonly string[];
  readonly chosen?: readonly string[];
  readonly locked?: readonly string[];
  readonly moved?: readonly string[];
}

/** What a change makes; null: nothing is wished for. */
export type Drafted = Draft | null | Promise<Draft | null>;

/** How far a piece is moved [m] and turned, counter-clockwise seen from above [degrees]. */
export interface Shift {
  readonly id: string;
  dx: number;
  dz: number;
  degrees: number;
}

/** A place along a wall-to-wall length for something of that extent. */
export function within(value: number, extent: number, whole: number): number {
  return Math.max(Math.min(extent, whole) / 2, Math.min(whole - Math.min(extent, whole) / 2, value));
}
