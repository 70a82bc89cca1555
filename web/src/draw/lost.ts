/** What goes with a step of the plan that nobody asked to go, in words. */
import { inWords } from "../panel/programme";
import { capital, say, sayName } from "../words/language";
import { openingsLost, type Draft, type DraftRoom } from "./draft";
import { draftNames } from "./inspector";

/** What went with a wall, or stood in a room that is gone. */
export function lostWords(before: Draft, after: Draft): string {
  const stays = new Set(after.rooms.map(({ id }) => id));
  const gone = before.rooms.find(({ id, from }) => !stays.has(id) && from && from.furniture.length > 0);
  const names = draftNames(before);
  if (gone) return say("{room} is gone, and all that stood in it; undo brings it back.", { room: capital(inWords(names.get(gone.id) ?? gone.id)) });
  const count = openingsLost(before, after);
  if (count <= 1) return count < 1 ? "" : say("1 door or window no longer fits and is gone; undo brings it back.");
  return say("{count} doors or windows no longer fit and are gone; undo brings them back.", { count });
}

function piecesOf({ rooms }: Draft): string[] {
  return rooms.flatMap(({ from }: DraftRoom) => from?.furniture.map(({ name }) => name) ?? []);
}

/** The furniture of which a plan has less since its reshaped rooms were arranged anew. */
export function leftOutWords(before: Draft, after: Draft): string {
  const left = piecesOf(before);
  for (const name of piecesOf(after)) if (left.includes(name)) left.splice(left.indexOf(name), 1);
  return left.length === 0 ? "" : say("Left out for want of room: {pieces}; undo brings back what stood here.", { pieces: left.map((name) => sayName(name)).sort().join(", ") });
}
