/** What the service makes of the home that is shown, as a step in turn with the edits: none made before or meanwhile is lost. */
import { withoutGaps } from "../address";
import type { Asking } from "../asking";
import type { FurnishAnswer, GenerateAnswer, Scene } from "../contract";
import { furnish, isAbort, reroll, restyle, type Look } from "../service";
import type { Home, Shown } from "../state/home";
import { say } from "../words/language";
import type { Editor } from "./editor";

export interface RemakingWords {
  /** Does what is wished in turn with the edits. */
  editor(): Pick<Editor, "wish" | "inTurn" | "landed">;
  /** Resolves once the text is there. */
  read(): Promise<void>;
  /** Rooms of this scene were furnished as what they were taken for. */
  furnished(made: FurnishAnswer, of: Scene): void;
}

type Make = (before: Shown, signal: AbortSignal) => Promise<GenerateAnswer & Pick<Shown, "made">>;

export class Remaking {
  constructor(readonly home: Home, readonly asking: Asking, readonly words: RemakingWords) {}

  /** Gives the home another style or other decorations; the furniture stays. */
  restyle(look: Look): void {
    this.#step(Object.keys(look).join(), say("Changing style and decorations"), async ({ scene, made }, signal) => {
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
    void this.words.editor().inTurn(() => {
      if (this.home.settled?.scene === before) this.home.show({ scene, issues, conflicts: [], timing }, "step");
      return Promise.resolve();
    });
  }

  /** Two wishes for the same thing are one, all others are carried out; what is refused is said once they are. */
  #step(what: string, said: string, make: Make): void {
    if (!this.home.settled) return;
    const carryOut = async (signal: AbortSignal): Promise<void> => {
      const before = this.home.settled;
      if (!before) return;
      const { scene, issues, timing_ms: timing, made = before.made ?? null } = await make(before, signal);
      if (!signal.aborted) this.home.show({ scene, issues, conflicts: [], timing, made }, "step");
    };
    void this.asking.run(said, async (signal) => {
      await this.words.editor().wish(what, carryOut, signal).catch(async (reason: unknown) => {
        if (!isAbort(reason)) await this.words.editor().landed;
        throw reason;
      });
      await this.words.read();
    }, "wish");
  }
}
