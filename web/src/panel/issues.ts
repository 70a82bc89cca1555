/** The service's issues, by rule, and what to do about them; choosing one shows the body it names, and its room. */
import type { Issue, Scene } from "../contract";
import { say } from "../words/language";
import { tell, tellSentence } from "../words/telling";
import { brokenOf } from "./status";

/** Issues of one rule, in the service's order. */
export interface IssueGroup {
  readonly rule: string;
  readonly issues: readonly Issue[];
}

/** Groups issues by rule, errors before warnings, else in the service's order. */
export function groupsOf(issues: readonly Issue[]): IssueGroup[] {
  const groups = new Map<string, Issue[]>();
  for (const issue of issues) groups.set(issue.rule, [...(groups.get(issue.rule) ?? []), issue]);
  const isError = (group: IssueGroup): boolean => group.issues.some(({ severity }) => severity === "error");
  return [...groups].map(([rule, members]) => ({ rule, issues: members })).sort((a, b) => Number(isError(b)) - Number(isError(a)));
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
    if (this.#words) this.#words.textContent = isWrong ? say("Choose one to go to it. Diagnose repairs all errors as one step.") : say("Warnings: the home works, less well. Choose one to go to it; move or delete the piece, take the step back, or take one of the room's other arrangements.");
    this.#diagnose?.toggleAttribute("hidden", !isWrong);
    this.list.replaceChildren(...groupsOf(issues).map((group) => this.#group(group, scene)));
  }

  #group({ rule, issues }: IssueGroup, scene: Scene): HTMLElement {
    const item = document.createElement("li");
    const title = document.createElement("p");
    title.className = "issue-rule";
    const count = document.createElement("span");
    count.textContent = String(issues.length);
    title.append(tell(rule.replaceAll("_", " ")), " ", count);
    const list = document.createElement("ul");
    list.append(...issues.map((issue) => this.#item(issue, scene)));
    item.append(title, list);
    return item;
  }

  #item(issue: Issue, scene: Scene): HTMLElement {
    const item = document.createElement("li");
    const button = document.createElement("button");
    button.type = "button";
    button.className = `issue issue-${issue.severity === "error" ? "error" : "warning"}`;
    button.textContent = tellSentence(issue.message, scene);
    button.addEventListener("click", () => this.#choose(issue));
    item.append(button);
    return item;
  }

  #choose({ ids: [first], room }: Issue): void {
    if (first !== undefined) this.onChoose(first);
    if (room) this.onChooseRoom(room);
  }
}
