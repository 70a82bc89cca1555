/** What the service makes of the home that is shown, as a step in turn with the edits: none made before or meanwhile is lost. */
import { withoutGaps } from "../address";
import type { Asking } from "../asking";
import type { FurnishAnswer, GenerateAnswer, Scene } from "../contract";
import { furnish, reroll, restyle, type Look } from "../service";
import type { Home, Shown } from "../state/home";
import { say } from "../words/language";

export interface RemakingWords {
  /** Does something after the edits that were asked for before. */
  inTurn(change: () => Promise<void>): Promise<void>;
  /** Resolves once the text is there. */
  read(): Promise<void>;
  /** Rooms of this scene were furnished as what they were taken for. */
  furnished(made: FurnishAnswer, of: Scene): void;
}

type Make = (before: Shown, signal: AbortSignal) => Promise<GenerateAnswer & Pick<Shown, "made">>;

export class Remaking {
  #look: Look = {};
  /** What is wished and not shown yet: a newer wish withdraws the question before it, and not what that asked for. */
  #wishes: ReadonlyMap<string, Make> = new Map();

  constructor(readonly home: Home, readonly asking: Asking, readonly words: RemakingWords) {}

  /** Gives the home another style or other decorations; the furniture stays. */
  restyle(wish: Look): void {
    if (!this.home.settled) return;
    const look = (this.#look = { ...this.#look, ...wish });
    this.#step("look", say("Changing style and decorations"), async ({ scene, made }, signal) => {
      return { ...(await restyle(scene, look, signal)), made: made ? withoutGaps({ ...made, ...look }) : null };
    });
  }

  /** Furnishes a room anew; what is locked in it stays. */
  reroll(room: string): void {
    this.#step(`room ${room}`, say("Furnishing the room anew"), ({ scene }, signal) => reroll(scene, [room], signal));
  }

  /** Furnishes the rooms that stand empty, and says what they were taken for. */
  furnish(): void {
    this.#step("empty", say("Furnishing empty rooms"), async ({ scene }, signal) => {
      const made = await furnish(scene, [], signal);
      this.words.furnished(made, scene);
      return made;
    });
  }

  /** Shows a room as it was chosen among others, unless the home has changed since. */
  take({ scene, issues, timing_ms: timing }: GenerateAnswer, before: Scene): void {
    void this.words.inTurn(() => {
      if (this.home.settled?.scene === before) this.home.show({ scene, issues, conflicts: [], timing }, "step");
      return Promise.resolve();
    });
  }

  #step(what: string, said: string, make: Make): void {
    const wishes = new Map(this.#wishes).set(what, make);
    this.#wishes = wishes;
    void this.asking.run(said, async (signal) => {
      await this.words.inTurn(async () => {
        for (const [wished, asked] of wishes) {
          const before = this.home.settled;
          if (!before || signal.aborted) return;
          const { scene, issues, timing_ms: timing, made = before.made ?? null } = await asked(before, signal);
          wishes.delete(wished);
          this.home.show({ scene, issues, conflicts: [], timing, made }, "step");
        }
      }).finally(() => { if (this.#wishes === wishes) [this.#wishes, this.#look] = [new Map(), {}]; });
      await this.words.read();
    });
  }
}
