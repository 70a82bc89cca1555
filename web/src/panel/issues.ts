/** The service's issues in its own words; choosing one selects the body it names. */
import type { Issue } from "../contract";

export class Issues {
  onChoose: (id: string) => void = () => undefined;

  constructor(readonly section: HTMLElement, readonly list: HTMLElement) {}

  show(issues: readonly Issue[]): void {
    this.section.hidden = issues.length === 0;
    this.list.replaceChildren(...issues.map((issue) => this.#item(issue)));
  }

  #item(issue: Issue): HTMLElement {
    const item = document.createElement("li");
    const button = document.createElement("button");
    button.type = "button";
    button.className = `issue issue-${issue.severity === "error" ? "error" : "warning"}`;
    const rule = document.createElement("strong");
    rule.textContent = issue.rule.replaceAll("_", " ");
    button.append(rule, ` ${issue.message}`);
    const [first] = issue.ids;
    if (first !== undefined) button.addEventListener("click", () => this.onChoose(first));
    item.append(button);
    return item;
  }
}
