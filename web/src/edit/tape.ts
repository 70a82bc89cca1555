/** A tape measure: two points of the house, or two pieces, and how far they are apart. */
import type { Hit } from "../house/house";
import { lengthWords } from "./lengths";
import type { RulerLine } from "./rulers";
import { say } from "../words/language";

type Spot = readonly [number, number, number];

export class Tape {
  /** Called when what it shows has changed. */
  onChange: (lines: readonly RulerLine[], words: string) => void = () => undefined;
  #isOut = false;
  #ends: Spot[] = [];

  get isOut(): boolean {
    return this.#isOut;
  }

  /** Takes it out, or puts it away. */
  toggle(isOut = !this.#isOut): void {
    this.#isOut = isOut;
    this.#ends = [];
    this.#tell();
  }

  /** Takes a click on the house: where it begins, then where it ends, then where the next begins. Tells whether it did. */
  click(hit: Hit | null): boolean {
    if (!this.#isOut) return false;
    if (hit && hit.kind !== "door") this.lay([hit.at[0], hit.at[1], hit.at[2]]);
    return true;
  }

  /** Lays an end down [m]. */
  lay(at: Spot): void {
    this.#ends = this.#ends.length === 1 ? [...this.#ends, at] : [at];
    this.#tell();
  }

  #tell(): void {
    const [from, to = from] = this.#ends;
    if (!from || !to) {
      this.onChange([], this.#isOut ? say("Tape: click where it begins, or choose a piece") : "");
      return;
    }
    const isWhole = this.#ends.length === 2;
    const [across, along] = [Math.abs(to[0] - from[0]), Math.abs(to[2] - from[2])];
    const length = Math.round(Math.hypot(across, along) * 1000);
    const lengths = { length: lengthWords(length), across: lengthWords(Math.round(across * 1000)), along: lengthWords(Math.round(along * 1000)) };
    const said = say("Tape: {length} ({across} west to east, {along} north to south)", lengths);
    this.onChange([{ look: "tape", from, to, words: isWhole ? lengthWords(length) : say("from here") }], isWhole ? said : say("Tape: click where it ends, or choose a piece"));
  }
}
