/** The plan that is being drawn, its history, and what of it is chosen. */
import type { Draft } from "./draft";

export interface Chosen {
  readonly room: string | null;
  readonly opening: string | null;
}

const NOTHING: Chosen = { room: null, opening: null };
const MOST_STEPS = 500;

export class DrawnPlan {
  /** Called after each change: of the plan (`moment` while something is dragged), or of what is chosen. */
  onChange: (what: "plan" | "moment" | "chosen") => void = () => undefined;
  #draft: Draft;
  /** The plan while something is dragged. */
  #moment: Draft | null = null;
  #past: Draft[] = [];
  #future: Draft[] = [];
  #chosen: Chosen = NOTHING;

  constructor(draft: Draft) {
    this.#draft = draft;
  }

  /** The plan as it is seen. */
  get draft(): Draft {
    return this.#moment ?? this.#draft;
  }

  /** The plan as the last step left it. */
  get settled(): Draft {
    return this.#draft;
  }

  get chosen(): Chosen {
    return this.#chosen;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  choose(chosen: Partial<Chosen>): void {
    this.#chosen = { ...NOTHING, ...chosen };
    this.onChange("chosen");
  }

  /** Shows how the plan would be. */
  show(moment: Draft): void {
    this.#moment = moment;
    this.onChange("moment");
  }

  /** Begins anew with a plan; where something was drawn that nobody was shown, undo leads back to it. */
  open(draft: Draft): void {
    if (this.canUndo) return this.step(draft);
    this.#future = [];
    this.#goTo(draft);
  }

  /** Forgets the steps: what was drawn is shown as a home, which keeps its own. */
  finish(): void {
    [this.#past, this.#future] = [[], []];
  }

  /** Makes a step; what was shown last, where no plan is given. */
  step(draft: Draft | null = this.#moment): void {
    this.#moment = null;
    if (draft && draft !== this.#draft) {
      this.#past = [...this.#past, this.#draft].slice(-MOST_STEPS);
      this.#future = [];
      this.#draft = draft;
    }
    this.#goTo(this.#draft);
  }

  /** Puts in the place of the last step what has come of it. */
  amend(draft: Draft): void {
    this.#goTo(draft);
  }

  /** Forgets what is shown of a drag. */
  cancel(): void {
    if (this.#moment) this.#goTo(this.#draft);
  }

  undo(): void {
    const before = this.#past.pop();
    if (!before) return;
    this.#future.push(this.#draft);
    this.#goTo(before);
  }

  redo(): void {
    const next = this.#future.pop();
    if (!next) return;
    this.#past.push(this.#draft);
    this.#goTo(next);
  }

  #goTo(draft: Draft): void {
    this.#draft = draft;
    this.#moment = null;
    const { room, opening } = this.#chosen;
    const isThere = draft.rooms.some(({ id }) => id === room) || draft.openings.some(({ id }) => id === opening);
    if (!isThere) this.#chosen = NOTHING;
    this.onChange("plan");
  }
}
