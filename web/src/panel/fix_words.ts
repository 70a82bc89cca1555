/** What a repair did, in words. Pure. */
import type { FixAnswer } from "../contract";
import { say, type Words } from "../words/language";
import { idWords, tell, tellSentence } from "../words/telling";

const counted = (count: number, one: Words, many: Words): string => (count === 1 ? say(one) : say(many, { count }));

/** How many moved, who was left out and why, what cannot stand together, what no piece is to blame for, and what is left. */
export function fixWords({ moves, removed, conflicts, issues, scene }: FixAnswer): string[] {
  const errors = issues.filter((issue) => issue.severity === "error").length;
  const small = new Set(scene.rooms.flatMap(({ decorations }) => decorations.map(({ id }) => id)));
  const things = moves.filter(({ id }) => small.has(id)).length;
  const pieces = moves.length - things;
  const what = [...(pieces > 0 ? [counted(pieces, "1 piece", "{count} pieces")] : []), ...(things > 0 ? [counted(things, "1 decoration", "{count} decorations")] : [])];
  const moved = what.length > 0 ? say("Moved: {what}", { what: what.join(", ") }) : say("Nothing moved");
  return [
    `${moved}; ${errors === 0 ? say("no error is left.") : counted(errors, "1 error is left.", "{count} errors are left.")}`,
    ...removed.map(({ id, reason }) => say("Left out {piece}: {reason}", { piece: idWords(id), reason: tell(reason, scene) })),
    ...conflicts.map(({ ids, message }) => {
      const reason = tellSentence(message, scene);
      return ids.length > 0 ? say("Cannot stand together: {pieces}. {reason}", { pieces: ids.map(idWords).join(", "), reason }) : reason;
    }),
  ];
}
