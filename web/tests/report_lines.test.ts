import { expect, test } from "vitest";
import { fixWords } from "../src/panel/fix_words";
import { grouped } from "../src/panel/issues";
import { sharedEnds, type Line } from "../src/panel/line_list";
import { kindOf, reportLines } from "../src/panel/report_lines";
import { marksOf } from "../src/view/mark_words";

const line = (text: string, id: string | null = null): Line => ({ text, id, className: "line" });
const issue = (rule: string, severity: "error" | "warning" = "error") => ({ rule, severity, ids: [], message: rule });
const nothing = { scene: { rooms: [] } as never, timing_ms: 0, moves: [], removed: [], conflicts: [], understood_as: {}, issues: [] };

test("a line is what its first characters say", () => {
  expect(kindOf("# Diagnosis")).toBe("head");
  expect(kindOf(">>     OVERLAP by 0.1 m: a and b")).toBe("wrong");
  expect(kindOf("!!     sofa (a)   [PROBLEMATIC]")).toBe("flagged");
  expect(kindOf("       sofa (a)")).toBe("plain");
  expect(kindOf("")).toBe("plain");
});

test("a mark within a name is a name", () => {
  expect(kindOf("       >> trap (!!): at [0, 0]")).toBe("plain");
  expect(kindOf("   # 3")).toBe("plain");
});

test("joined, the lines are the report again, each with its body", () => {
  const told = { text: "# a\n\n>> b\n!! c\n", lines: [null, null, "b", "c"] };
  const lines = reportLines(told);
  expect(`${lines.map(({ text }) => text).join("\n")}\n`).toBe(told.text);
  expect(lines.map(({ id }) => id)).toEqual(told.lines);
});

test("only what differs is built anew", () => {
  const before = ["a", "b", "c", "d"].map((text) => line(text));
  expect(sharedEnds(before, before)).toEqual({ start: 4, end: 0 });
  expect(sharedEnds(before, ["a", "x", "d"].map((text) => line(text)))).toEqual({ start: 1, end: 1 });
  expect(sharedEnds(before, [])).toEqual({ start: 0, end: 0 });
  expect(sharedEnds([line("a")], [line("a", "other")])).toEqual({ start: 0, end: 0 });
  expect(sharedEnds(["a", "a"].map((text) => line(text)), ["a", "a", "a"].map((text) => line(text)))).toEqual({ start: 2, end: 0 });
});

test("a repair is told with what moved, what went and what is left", () => {
  const move = { id: "a", dx: 1, dz: 0, rotation: 0 };
  expect(fixWords(nothing)).toEqual(["Nothing moved; no error is left."]);
  expect(fixWords({ ...nothing, moves: [move], issues: [issue("overlap"), issue("missing_required", "warning")] })).toEqual([
    "Moved: 1 piece; 1 error is left.",
  ]);
  const told = fixWords({
    ...nothing,
    moves: [move, move],
    removed: [{ id: "b", reason: "no floor" }],
    conflicts: [{ ids: ["c", "d"], message: "0.2 m are missing", repairs: [] }, { ids: [], message: "no door joins them", repairs: [] }],
  });
  expect(told).toEqual(["Moved: 2 pieces; no error is left.", "Left out b: no floor", "Cannot stand together: c, d. 0.2 m are missing", "No door joins them"]);
});

test("decorations that a repair moved are no pieces of furniture", () => {
  const move = (id: string) => ({ id, dx: 1, dz: 0, rotation: 0 });
  const scene = { rooms: [{ decorations: ["v", "w"].map((id) => ({ id })) }] } as never;
  const told = (...ids: string[]) => fixWords({ ...nothing, scene, moves: ids.map(move) });
  expect(told("a", "v", "b", "w")).toEqual(["Moved: 2 pieces, 2 decorations; no error is left."]);
  expect(told("w")).toEqual(["Moved: 1 decoration; no error is left."]);
});

test("issues are grouped by rule, errors first, each once", () => {
  const issues = [issue("missing_required", "warning"), issue("overlap"), issue("wall_far"), issue("overlap")];
  const groups = grouped(issues, ({ rule }) => rule);
  expect([...groups].map(([rule, of]) => [rule, of.length])).toEqual([["overlap", 2], ["wall_far", 1], ["missing_required", 1]]);
  expect(new Set([...groups.values()].flat())).toEqual(new Set(issues));
});

test("every body with an error gets its rules' words once, and a room where no body is named", () => {
  const issues = [
    { ...issue("overlap"), ids: ["a", "b"], room: "den" },
    { ...issue("overlap"), ids: ["a", "c"], room: "den" },
    { ...issue("wall_far"), ids: ["a"], room: "den" },
    { ...issue("front_blocked", "warning"), ids: ["d"], room: "den" },
    { ...issue("unreachable"), room: "den" },
    issue("unreachable"),
  ];
  expect(marksOf(issues)).toEqual([
    { id: "a", words: "OVERLAP, WALL FAR" },
    { id: "b", words: "OVERLAP" },
    { id: "c", words: "OVERLAP" },
    { id: "den", words: "UNREACHABLE" },
  ]);
});
