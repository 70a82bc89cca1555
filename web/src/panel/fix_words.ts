/** What a repair did, in words. Pure. */
import type { FixAnswer } from "../contract";

const counted = (count: number, one: string, many: string): string => `${count} ${count === 1 ? one : many}`;

/** How many moved, who was left out and why, what cannot stand together, and what is left. */
export function fixWords({ moves, removed, conflicts, issues }: FixAnswer): string[] {
  const errors = issues.filter((issue) => issue.severity === "error").length;
  return [
    `${moves.length === 0 ? "Nothing" : counted(moves.length, "body", "bodies")} moved; ${errors === 0 ? "no error is left" : `${counted(errors, "error is", "errors are")} left`}.`,
    ...removed.map(({ id, reason }) => `Left out ${id}: ${reason}`),
    ...conflicts.map(({ ids, message }) => `Cannot stand together: ${ids.join(", ")}. ${message}`),
  ];
}
