/** The service's issues, by rule; choosing one shows the body it names, or else its room. */
import type { Issue, Scene } from "../contract";
import { tell, tellSentence } from "../words/telling";

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
  /** Called with a room's id, where no body is named. */
  onChooseRoom: (id: string) => void = () => undefined;

  constructor(readonly section: HTMLElement, readonly list: HTMLElement) {}

  show(issues: readonly Issue[], scene: Scene): void {
    this.section.hidden = issues.length === 0;
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
    else if (room) this.onChooseRoom(room);
  }
}
