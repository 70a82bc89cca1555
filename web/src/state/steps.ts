/** The steps of what is edited, and at which of them it is: what undo and redo go through. */
export class Steps<State> {
  /** `all`: from the first on. */
  constructor(readonly all: readonly State[], readonly at = 0) {
    if (!(at in all)) throw new RangeError(`step ${at} of ${all.length}`);
  }

  get now(): State {
    return this.all[this.at] as State;
  }

  get canUndo(): boolean {
    return this.at > 0;
  }

  get canRedo(): boolean {
    return this.at + 1 < this.all.length;
  }

  /** One more step; those that were undone are forgotten. */
  with(state: State): Steps<State> {
    return new Steps([...this.all.slice(0, this.at + 1), state], this.at + 1);
  }

  /** In the place of this step what has come of it. */
  amended(state: State): Steps<State> {
    return new Steps(this.all.map((one, at) => (at === this.at ? state : one)), this.at);
  }

  undone(): Steps<State> {
    return this.canUndo ? new Steps(this.all, this.at - 1) : this;
  }

  redone(): Steps<State> {
    return this.canRedo ? new Steps(this.all, this.at + 1) : this;
  }
}
