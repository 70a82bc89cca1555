/** The service's report, line by line: what begins with its marks, and the body a line speaks of. Pure. */
import type { ViewAnswer } from "../contract";

export type ReportKind = "head" | "wrong" | "flagged" | "plain";

export interface ReportLine {
  readonly text: string;
  readonly kind: ReportKind;
  readonly id: string | null;
}

const STARTS: readonly (readonly [string, ReportKind])[] = [["#", "head"], [">>", "wrong"], ["!!", "flagged"]];

/** What a line is by what it begins with; a mark further in is somebody's name. */
export function kindOf(text: string): ReportKind {
  return STARTS.find(([start]) => text.startsWith(start))?.[1] ?? "plain";
}

/** The report's lines; joined with line ends they are its text again. */
export function reportLines({ text, lines }: ViewAnswer): ReportLine[] {
  return text.replace(/\n$/, "").split("\n").map((line, i) => ({ text: line, kind: kindOf(line), id: lines[i] ?? null }));
}
