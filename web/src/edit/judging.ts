/** What an answer of the service says of some rooms. Pure. */
import type { Conflict, FixAnswer, Scene } from "../contract";
import type { Shown } from "../state/home";

/** The conflicts of rooms; their errors, where nothing says which pieces are in conflict. */
export function conflictsIn(answer: FixAnswer, rooms: readonly string[], before: Shown): readonly Conflict[] {
  const own = answer.conflicts.filter(({ ids }) => ids.some((id) => isIn(answer.scene, rooms, id)));
  if (own.length > 0) return own;
  const known = new Set(before.issues.map((issue) => issue.message));
  const errors = answer.issues.filter((issue) => issue.severity === "error" && rooms.includes(issue.room ?? "") && !known.has(issue.message));
  return errors.map(({ ids, message }) => ({ ids, message, repairs: [] }));
}

function isIn(scene: Scene, rooms: readonly string[], id: string): boolean {
  return scene.rooms.some((one) => rooms.includes(one.id) && one.furniture.some((piece) => piece.id === id));
}
