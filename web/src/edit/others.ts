/** Other arrangements of a room, side by side as pictures, to choose from. */
import type { GenerateAnswer, Scene } from "../contract";
import { button, made } from "../made";
import { Newest } from "../newest";
import { putAway } from "../panel/focus";
import { isAbort } from "../service";
import { alone } from "./scene_edits";
import { say } from "../words/language";

const HOW_MANY = 3;
/** A picture's size [pixels]. */
const PICTURE = { width: 240, height: 180 } as const;

export interface OthersWords {
  /** Furnishes the room anew, by a seed. */
  ask(scene: Scene, room: string, seed: number, signal: AbortSignal): Promise<GenerateAnswer>;
  portray(scene: Scene, into: HTMLCanvasElement): void;
  take(answer: GenerateAnswer, before: Scene): void;
  failed(reason: unknown, again: () => void): void;
}

export class OtherRooms {
  readonly #pending = new Newest();
  /** The seeds go on where the last ones ended: asked again, others come. */
  #seed = 0;

  constructor(readonly host: HTMLElement, readonly say: OthersWords) {}

  /** Shows how else a room could be furnished. */
  async show(scene: Scene, room: string): Promise<void> {
    this.hide();
    const signal = this.#pending.next();
    this.#present(say("Furnishing it in other ways…"), []);
    try {
      const answers: GenerateAnswer[] = [];
      for (let i = 0; i < HOW_MANY; i += 1) answers.push(await this.say.ask(scene, room, (this.#seed += 1), signal));
      if (!signal.aborted) this.#present(say("Furnish it like this?"), this.#choices(answers, scene, room));
    } catch (reason) {
      if (isAbort(reason)) return;
      this.hide();
      this.say.failed(reason, () => void this.show(scene, room));
    }
  }

  /** Tells whether any were shown. */
  hide(): boolean {
    const was = !this.host.hidden;
    this.#pending.stop();
    putAway(this.host);
    this.host.replaceChildren();
    return was;
  }

  #present(title: string, choices: readonly HTMLElement[]): void {
    const row = choices.length > 0 ? [made("div", { className: "others-row" }, ...choices)] : [];
    this.host.replaceChildren(made("strong", {}, title), ...row, button(say("Keep it as it is"), () => this.hide()));
    this.host.hidden = false;
  }

  #choices(answers: readonly GenerateAnswer[], before: Scene, room: string): HTMLElement[] {
    return answers.map((answer, number) => {
      const pieces = answer.scene.rooms.find(({ id }) => id === room)?.furniture.length ?? 0;
      const choice = button(say("{number}: {pieces} pieces", { number: number + 1, pieces }), () => {
        this.hide();
        this.say.take(answer, before);
      });
      const picture = made("canvas", { ...PICTURE, "aria-hidden": true });
      choice.prepend(picture);
      this.say.portray(alone(answer.scene, room), picture);
      return choice;
    });
  }
}
