/** The diagnosis: what is wrong with the shown home and what to do, the service's report of it, what to copy, what to repair. */
import type { FixRequest, Issue } from "../contract";
import { button, made } from "../made";
import { Newest } from "../newest";
import { fix, isAbort, report, ServiceProblem } from "../service";
import type { Home } from "../state/home";
import { fixWords } from "./fix_words";
import { showFindings } from "./found";
import { LineList } from "./line_list";
import { reportLines } from "./report_lines";
import { say } from "../words/language";
import { refusalWords } from "./field_words";
import { element } from "../element";

export class Diagnose {
  /** Called with the id of the body whose line was chosen, and with the room of an issue; the dialog has made way. */
  onChoose: (id: string) => void = () => undefined;
  onChooseRoom: (id: string) => void = () => undefined;
  readonly #dialog = element<HTMLDialogElement>("diagnose_dialog");
  readonly #said = element("diagnose_said");
  readonly #fix = element<HTMLButtonElement>("diagnose_fix");
  readonly #remove = element<HTMLButtonElement>("diagnose_remove");
  /** The next step where it is the plan that no furniture could mend. */
  readonly #plan = element("diagnose_plan");
  readonly #whole = element<HTMLDetailsElement>("report_whole");
  readonly #list: LineList;
  #text = "";
  readonly #asked = new Newest();
  readonly #repair = new Newest();

  constructor(readonly home: Home, readonly wish: (change: (signal: AbortSignal) => Promise<void>, withdrawn: AbortSignal) => Promise<void>) {
    this.#list = new LineList(element("report"));
    this.#list.onChoose = (id) => this.#choose(id);
    element("diagnose").addEventListener("click", () => this.open());
    element("diagnose_copy").addEventListener("click", () => void this.#copy());
    element("diagnose_close").addEventListener("click", () => this.#dialog.close());
    this.#plan.addEventListener("click", () => this.#dialog.close());
    this.#fix.addEventListener("click", () => void this.#mend("report"));
    this.#remove.addEventListener("click", () => void this.#mend("remove"));
    // Told late: by then the dialog may have been opened again.
    this.#dialog.addEventListener("close", () => { if (!this.#dialog.open) this.#withdraw(); });
    home.on("shown", (how) => { if (how !== "live") void this.#diagnose(); });
    home.on("flagged", () => void this.#diagnose());
  }

  open(): void {
    if (this.#dialog.open || !this.home.scene) return;
    this.#withdraw();
    this.#say([]);
    this.#remove.hidden = this.#plan.hidden = true;
    this.#offerFix(this.home.issues); // before the dialog opens, which gives the first of its buttons the focus
    this.#dialog.showModal();
    void this.#diagnose();
  }

  /** Asks for the report of what is shown, if anybody is looking. */
  async #diagnose(): Promise<void> {
    const scene = this.home.scene;
    if (!this.#dialog.open || !scene) return;
    const signal = this.#asked.next();
    this.#dialog.setAttribute("aria-busy", "true");
    try {
      const { report: told, issues } = await report(scene, [...this.home.flagged], signal);
      this.#text = told.text;
      showFindings(element("diagnose_found"), issues, scene, ({ ids: [id], room }) => this.#choose(id, room));
      this.#list.show(reportLines(told).map(({ text, kind, id }) => ({ text, id, className: `report-line report-${kind}` })));
      this.#offerFix(issues);
      this.#dialog.setAttribute("aria-busy", "false");
    } catch (reason) {
      this.#explain(reason, () => {
        this.#say([]);
        void this.#diagnose();
      });
    }
  }

  #offerFix(issues: readonly Issue[]): void {
    this.#fix.disabled = !issues.some(({ severity }) => severity === "error");
  }

  /** Repairs what is shown, as one step that can be undone, in turn with the edits. */
  async #mend(onConflict: NonNullable<FixRequest["on_conflict"]>): Promise<void> {
    const withdrawn = this.#repair.next();
    this.#say([say("Fixing…")]);
    this.#fix.disabled = true;
    try {
      await this.wish(async (signal) => {
        const scene = this.home.settled?.scene;
        if (!scene) return;
        const answer = await fix({ scene, on_conflict: onConflict }, signal);
        if (this.home.settled?.scene !== scene) return;
        const { issues, conflicts, timing_ms: timing } = answer;
        if (answer.moves.length + answer.removed.length > 0) this.home.show({ scene: answer.scene, issues, conflicts, timing }, "step");
        else void this.#diagnose();
        this.#say(fixWords(answer));
        this.#remove.hidden = onConflict === "remove" || conflicts.every(({ ids }) => ids.length === 0);
        this.#plan.hidden = conflicts.every(({ ids }) => ids.length > 0);
      }, withdrawn);
    } catch (reason) {
      this.#explain(reason, () => void this.#mend(onConflict));
      this.#fix.disabled = false;
    }
  }

  #choose(id: string | undefined, room: string | null = null): void {
    this.#dialog.close();
    if (id !== undefined) this.onChoose(id);
    if (room !== null) this.onChooseRoom(room);
  }

  #withdraw(): void {
    this.#asked.stop();
    this.#repair.stop();
  }

  /** Says what was refused; `again` asks once more, where that may be answered. */
  #explain(reason: unknown, again: () => void): void {
    if (isAbort(reason)) return;
    this.#dialog.setAttribute("aria-busy", "false");
    const { title, lines } = refusalWords(reason);
    this.#say([title, ...lines]);
    if (!(reason instanceof ServiceProblem && reason.isFinal)) this.#said.append(button(say("Try again"), again));
  }

  #say(words: readonly string[]): void {
    this.#said.tabIndex = words.length > 0 ? 0 : -1; // what is long is scrolled, by keys too
    this.#said.replaceChildren(...words.map((text) => made("p", {}, text)));
  }

  /** Copies the report; where the browser refuses, selects it for the person's own keys. */
  async #copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.#text);
      this.#say([say("Copied.")]);
    } catch {
      this.#whole.open = true;
      window.getSelection()?.selectAllChildren(this.#list.host);
      this.#say([say("The browser does not let the page copy. The report is selected: press Ctrl+C.")]);
    }
  }
}
