/** What a diagnosis found, room by room, in plain words; choosing one leads to the body it names, or to its room. */
import type { Issue, Scene } from "../contract";
import { made } from "../made";
import { say } from "../words/language";
import { grouped, issueList, WARNINGS_ALONE } from "./issues";
import { roomNames } from "./room";

/** What to do about what was found. */
function advice(issues: readonly Issue[]): string {
  if (issues.length === 0) return say("Nothing is wrong: every rule is kept.");
  if (issues.some(({ severity }) => severity === "error")) {
    return say("Choose one to go to it, or press Fix: furniture is moved until no rule is broken, as one step. What cannot stand is left out only when you say so.");
  }
  return WARNINGS_ALONE;
}

/** Shows what was found in place of what was shown. */
export function showFindings(host: HTMLElement, issues: readonly Issue[], scene: Scene, choose: (issue: Issue) => void): void {
  const names = roomNames(scene);
  const rooms = [...grouped(issues, ({ room }) => room ?? "")].flatMap(([room, found]) => [
    made("h3", {}, names.get(room) ?? say("The home")), issueList(found, scene, choose),
  ]);
  host.replaceChildren(made("p", {}, advice(issues)), ...rooms);
}
