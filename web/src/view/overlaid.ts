/** What is shown over the canvas for what is chosen, by who shows it: names keep clear of it. */
import type { Kept } from "./label_layout";

export class Overlaid {
  /** Told whenever something is shown elsewhere. */
  onChange: () => void = () => undefined;
  readonly #shown = new Map<string, readonly Kept[]>();

  get all(): readonly Kept[] {
    return [...this.#shown.values()].flat();
  }

  of(name: string): readonly Kept[] {
    return this.#shown.get(name) ?? [];
  }

  set(name: string, kept: readonly Kept[]): void {
    this.#shown.set(name, kept);
    this.onChange();
  }
}
