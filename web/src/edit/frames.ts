/** Frames of a drag that the page answers itself: what they are to the editor. */
import type { Conflict, FixAnswer, Pose, Scene } from "../contract";

/** Frames of a drag that are answered without asking the service; null where it must be asked. */
export interface Frames {
  /** The scene with all where it goes; null where no valid place is known. */
  frame(wished: Scene): Promise<Scene | null>;
}
export type TakeInHand = (scene: Scene, id: string) => Promise<Frames | null>;

/** What is nearer than this has not moved [m]. */
const SAME_PLACE = 0.0005;

/** Waits until what was told is drawn. */
export function drawn(): Promise<void> {
  return new Promise((resolve) => { requestAnimationFrame(() => resolve()); });
}

/** What the core says of a frame, as the service would. */
export function answerOf(scene: Scene | null, held: string, sent: Scene): FixAnswer {
  const conflicts: readonly Conflict[] = scene ? [] : [{ ids: [held], message: `not found while it is dragged: a place for ${held} and those around it`, repairs: [] }];
  return { scene: scene ?? sent, conflicts: [...conflicts], issues: [], moves: [], removed: [], understood_as: {}, timing_ms: 0 };
}

export function samePlaces(before: readonly Pose[], after: readonly Pose[]): boolean {
  const was = new Map(before.map((pose) => [pose.id, pose]));
  return after.every(({ id, x, z }) => {
    const old = was.get(id);
    return old !== undefined && Math.abs(old.x - x) < SAME_PLACE && Math.abs(old.z - z) < SAME_PLACE;
  });
}
