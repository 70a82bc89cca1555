/** The plan that is being drawn, its history, and what of it is chosen. */
import { Steps } from "../state/steps";
import type { Draft } from "./draft";

export interface Chosen {
  readonly room: string | null;
  readonly opening: string | null;
}

const NOTHING: Chosen = { room: null, opening: null };

export class DrawnPlan {
  /** Called after each change: of the plan (`moment` while something is dragged), or of what is chosen. */
  onChange: (what: "plan" | "moment" | "chosen") => void = () => undefined;
  #steps: Steps<Draft>;
  /** The plan while something is dragged. */
  #moment: Draft | null = null;
  #chosen: Chosen = NOTHING;

  constructor(draft: Draft) {
    this.#steps = new Steps([draft]);
  }

  /** The plan as it is seen. */
  get draft(): Draft {
    return this.#moment ?? this.settled;
  }

  /** The plan as the last step left it. */
  get settled(): Draft {
    return this.#steps.now;
  }

  get chosen(): Chosen {
    return this.#chosen;
  }

  get canUndo(): boolean {
    return this.#steps.canUndo;
  }

  get canRedo(): boolean {
    return this.#steps.canRedo;
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
    this.#steps = new Steps([draft]);
    this.#changed();
  }

  /** Forgets the steps: what was drawn is shown as a home, which keeps its own. */
  finish(): void {
    this.#steps = new Steps([this.settled]);
  }

  /** Makes a step; what was shown last, where no plan is given. */
  step(draft: Draft | null = this.#moment): void {
    if (draft && draft !== this.settled) this.#steps = this.#steps.with(draft);
    this.#changed();
  }

  /** Puts in the place of the last step what has come of it. */
  amend(draft: Draft): void {
    this.#steps = this.#steps.amended(draft);
    this.#changed();
  }

  /** Forgets what is shown of a drag. */
  cancel(): void {
    if (this.#moment) this.#changed();
  }

  undo(): void {
    this.#steps = this.#steps.undone();
    this.#changed();
  }

  redo(): void {
    this.#steps = this.#steps.redone();
    this.#changed();
  }

  /** What was shown of a drag is over, and what is no longer there no longer chosen. */
  #changed(): void {
    this.#moment = null;
    const [draft, { room, opening }] = [this.settled, this.#chosen];
    const isThere = draft.rooms.some(({ id }) => id === room) || draft.openings.some(({ id }) => id === opening);
    if (!isThere) this.#chosen = NOTHING;
    this.onChange("plan");
  }
}
