/** What to write at the bodies and rooms in question: the rules' own words, as the list of issues has them. Pure. */
import type { Issue } from "../contract";
import { tell } from "../words/telling";

export interface MarkWords {
  /** A body's id; a room's where an issue names no body. */
  readonly id: string;
  readonly words: string;
}

/** One mark for each body and room with an error, with every rule it breaks once; warnings are in the list alone. */
export function marksOf(issues: readonly Issue[]): MarkWords[] {
  const rules = new Map<string, Set<string>>();
  for (const { rule, room, ids } of issues.filter(({ severity }) => severity === "error")) {
    for (const id of ids.length > 0 || !room ? ids : [room]) {
      rules.set(id, (rules.get(id) ?? new Set()).add(tell(rule.replaceAll("_", " ")).toUpperCase()));
    }
  }
  return [...rules].map(([id, words]) => ({ id, words: [...words].join(", ") }));
}
