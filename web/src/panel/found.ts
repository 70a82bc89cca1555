/** What a diagnosis found, room by room, in plain words; choosing one leads to the body it names, or to its room. */
import type { Issue, Scene } from "../contract";
import { say } from "../words/language";
import { tellSentence } from "../words/telling";
import { roomNames } from "./room";

/** What is wrong in one room, errors first; `room` is null for the home as a whole. */
export interface RoomFindings {
  readonly room: string | null;
  readonly issues: readonly Issue[];
}

/** Findings by room, rooms with errors first, else in the service's order. */
export function findingsOf(issues: readonly Issue[]): RoomFindings[] {
  const isError = ({ severity }: Issue): number => Number(severity === "error");
  const sorted = [...issues].sort((a, b) => isError(b) - isError(a));
  const rooms = new Map<string | null, Issue[]>();
  for (const issue of sorted) rooms.set(issue.room ?? null, [...(rooms.get(issue.room ?? null) ?? []), issue]);
  return [...rooms].map(([room, found]) => ({ room, issues: found }));
}

/** What to do about what was found. */
function advice(issues: readonly Issue[]): string {
  if (issues.length === 0) return say("Nothing is wrong: every rule is kept.");
  if (issues.some(({ severity }) => severity === "error")) {
    return say("Choose one to go to it, or press Fix: furniture is moved until no rule is broken, as one step. What cannot stand is left out only when you say so.");
  }
  return say("Warnings: the home works, less well. Choose one to go to it; move or delete the piece, take the step back, or take one of the room's other arrangements.");
}

function finding(issue: Issue, scene: Scene, choose: (issue: Issue) => void): HTMLElement {
  const item = document.createElement("li");
  const button = document.createElement("button");
  button.type = "button";
  button.className = `issue issue-${issue.severity === "error" ? "error" : "warning"}`;
  button.textContent = tellSentence(issue.message, scene);
  button.disabled = issue.ids.length === 0 && !issue.room;
  button.addEventListener("click", () => choose(issue));
  item.append(button);
  return item;
}

/** Shows what was found in place of what was shown. */
export function showFindings(host: HTMLElement, issues: readonly Issue[], scene: Scene, choose: (issue: Issue) => void): void {
  const names = roomNames(scene);
  const words = document.createElement("p");
  words.textContent = advice(issues);
  const rooms = findingsOf(issues).flatMap((found) => {
    const head = document.createElement("h3");
    head.textContent = (found.room !== null && names.get(found.room)) || say("The home");
    const list = document.createElement("ul");
    list.append(...found.issues.map((issue) => finding(issue, scene, choose)));
    return [head, list];
  });
  host.replaceChildren(words, ...rooms);
}
