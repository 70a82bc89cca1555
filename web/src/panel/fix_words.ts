/** What a repair did, in words. Pure. */
import type { FixAnswer } from "../contract";
import { say, type Words } from "../words/language";
import { idWords, tell, tellSentence } from "../words/telling";

const counted = (count: number, none: Words, one: Words, many: Words): string => (count === 0 ? say(none) : count === 1 ? say(one) : say(many, { count }));

/** How many moved, who was left out and why, what cannot stand together, and what is left. */
export function fixWords({ moves, removed, conflicts, issues, scene }: FixAnswer): string[] {
  const errors = issues.filter((issue) => issue.severity === "error").length;
  return [
    counted(moves.length, "Nothing moved; ", "1 piece moved; ", "{count} pieces moved; ") + counted(errors, "no error is left.", "1 error is left.", "{count} errors are left."),
    ...removed.map(({ id, reason }) => say("Left out {piece}: {reason}", { piece: idWords(id), reason: tell(reason, scene) })),
    ...conflicts.map(({ ids, message }) => say("Cannot stand together: {pieces}. {reason}", { pieces: ids.map(idWords).join(", "), reason: tellSentence(message, scene) })),
  ];
}
