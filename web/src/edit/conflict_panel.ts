/** Why something cannot be, in the service's words, and what would help, each a button. */
import type { Repair } from "../contract";
import type { Refusal } from "./editor";
import { repairWords } from "./words";
import { button, made } from "../made";
import { putAway } from "../panel/focus";
import { say } from "../words/language";
import { tellSentence } from "../words/telling";

const MOST_REPAIRS = 6;

export class ConflictPanel {
  onTake: (refusal: Refusal, repair: Repair) => void = () => undefined;

  constructor(readonly host: HTMLElement) {}

  show(refusal: Refusal | null): void {
    if (refusal) this.host.hidden = false;
    else putAway(this.host);
    this.host.replaceChildren(...(refusal ? this.#contents(refusal) : []));
  }

  #contents(refusal: Refusal): HTMLElement[] {
    const said = refusal.conflicts.map(({ message }) => made("p", {}, tellSentence(message, refusal.sent)));
    const heading = refusal.live ? say("No place found yet: let go to look harder") : say("That cannot be, so all stays as it was");
    return [made("strong", {}, heading), ...said, ...(refusal.live ? [] : [this.#repairs(refusal)])];
  }

  #repairs(refusal: Refusal): HTMLElement {
    const offered = new Map(refusal.conflicts.flatMap(({ repairs }) => repairs).map((repair) => [`${repair.id} ${repairWords(repair)}`, repair]));
    const repairs = [...offered.values()].slice(0, MOST_REPAIRS).map((repair) => button(repairWords(repair), () => this.onTake(refusal, repair)));
    return made("div", { className: "repairs" }, ...repairs, button(say("Close"), () => this.show(null)));
  }
}
