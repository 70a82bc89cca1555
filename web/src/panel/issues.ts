/** The service's issues, by rule, and what to do about them; choosing one shows the body it names, and its room. */
import type { Issue, Scene } from "../contract";
import { button, made } from "../made";
import { say } from "../words/language";
import { tell, tellSentence } from "../words/telling";
import { brokenOf } from "./status";

/** What to do where nothing but warnings are found. */
export const WARNINGS_ALONE = say("Warnings: the home works, less well. Choose one to go to it; move or delete the piece, take the step back, or take one of the room's other arrangements.");

/** Issues by what they have in common, those groups first that hold an error, else in the service's order; errors first in each. */
export function grouped(issues: readonly Issue[], of: (issue: Issue) => string): ReadonlyMap<string, readonly Issue[]> {
  const isError = ({ severity }: Issue): number => Number(severity === "error");
  const groups = new Map<string, Issue[]>();
  for (const issue of [...issues].sort((a, b) => isError(b) - isError(a))) groups.set(of(issue), [...(groups.get(of(issue)) ?? []), issue]);
  return groups;
}

/** Issues in their own words, each to be chosen if it says where it is. */
export function issueList(issues: readonly Issue[], scene: Scene, choose: (issue: Issue) => void): HTMLElement {
  return made("ul", {}, ...issues.map((issue) => made("li", {}, button(tellSentence(issue.message, scene), () => choose(issue), {
    className: `issue issue-${issue.severity === "error" ? "error" : "warning"}`, disabled: issue.ids.length === 0 && !issue.room,
  }))));
}

export class Issues {
  /** Called with a body's id. */
  onChoose: (id: string) => void = () => undefined;
  /** Called with the room that an issue is in: its other arrangements are offered. */
  onChooseRoom: (id: string) => void = () => undefined;

  readonly #words: HTMLElement | null;
  readonly #diagnose: HTMLElement | null;

  constructor(readonly section: HTMLElement, readonly list: HTMLElement) {
    this.#words = section.querySelector("#issue_words");
    this.#diagnose = section.querySelector("#issue_diagnose");
  }

  show(found: readonly Issue[], scene: Scene): void {
    const issues = brokenOf(found, scene);
    const isWrong = issues.some(({ severity }) => severity === "error");
    this.section.hidden = issues.length === 0;
    if (this.#words) this.#words.textContent = isWrong ? say("Choose one to go to it. Diagnose repairs all errors as one step.") : WARNINGS_ALONE;
    this.#diagnose?.toggleAttribute("hidden", !isWrong);
    this.list.replaceChildren(...[...grouped(issues, ({ rule }) => rule)].map(([rule, of]) => made("li", {},
      made("p", { className: "issue-rule" }, tell(rule.replaceAll("_", " ")), " ", made("span", {}, String(of.length))),
      issueList(of, scene, (issue) => this.#choose(issue)),
    )));
  }

  #choose({ ids: [first], room }: Issue): void {
    if (first !== undefined) this.onChoose(first);
    if (room) this.onChooseRoom(room);
  }
}
