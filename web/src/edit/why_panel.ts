/** Why the chosen piece stands where it does: what holds it back from where it was wished, in the service's words. */
import type { Explained, Hold, OtherWay, Scene } from "../contract";
import { awayWords } from "./why_lines";
import { button, made } from "../made";
import { Newest } from "../newest";
import { putAway } from "../panel/focus";
import { capital, say } from "../words/language";
import { tell, theWords } from "../words/telling";

const COST = say("The numbers are the room's cost: by how much it falls short of all that is wished for in it. Less is better.");

/** Calls the pieces of a message as people do. */
type Named = (message: string) => string;
export type AskWhy = (scene: Scene, id: string, signal: AbortSignal) => Promise<Explained>;

export class WhyPanel {
  onChoose: (id: string) => void = () => undefined;
  /** Called with what is shown; null: nothing any more. */
  onShow: (answer: Explained | null) => void = () => undefined;
  /** Called with a way to stand that is pointed at, to be framed; null: none is. */
  onPreview: (way: OtherWay | null, room: string) => void = () => undefined;
  /** Called with a way that was chosen. */
  onTake: (way: OtherWay, room: string) => void = () => undefined;
  /** Called once a person has closed it. */
  onClose: () => void = () => undefined;
  readonly #pending = new Newest();

  constructor(readonly host: HTMLElement, readonly ask: AskWhy) {}

  /** Asks about a piece and shows the answer; throws what the service refuses. */
  async show(scene: Scene, id: string): Promise<void> {
    this.hide();
    const answer = await this.ask(scene, id, this.#pending.next());
    this.host.replaceChildren(...this.#contents(answer, (message) => tell(message, scene)));
    this.host.hidden = false;
    this.onShow(answer);
  }

  hide(): void {
    this.#pending.stop();
    const was = !this.host.hidden;
    putAway(this.host);
    this.host.replaceChildren();
    if (was) this.onShow(null);
  }

  close(): void {
    this.hide();
    this.onClose();
  }

  #contents(answer: Explained, named: Named): HTMLElement[] {
    const heading = made("strong", {}, say("Why {piece} stands here", { piece: theWords(answer.id) }));
    const notes = [...wishOf(answer), ...answer.notes.map(named)].map((note) => made("p", {}, `${capital(note)}.`));
    const list = made("ul", {}, ...answer.holds.map((hold) => this.#line(hold, capital(named(hold.message)))));
    const close = button(say("Close"), () => this.close(), { className: "why-close" });
    const cost = made("p", { className: "hint" }, COST);
    const hasNumbers = answer.holds.length > 0 || answer.ways.some((way) => way.cost !== null);
    const parts = [heading, ...notes, ...(hasNumbers ? [cost] : []), ...(answer.holds.length > 0 ? [list] : []), ...this.#ways(answer, named)];
    return [made("div", { tabIndex: 0 }, ...parts), close]; // scrolled by keys, too
  }

  /** How else it could stand, and what that would have cost; each can be taken. */
  #ways({ ways, room }: Explained, named: Named): HTMLElement[] {
    if (ways.length === 0) return [];
    const lines = ways.map((way) => {
      const said = capital(named(way.message));
      if (way.cost === null) return made("li", {}, said);
      const take = button(said, () => this.onTake(way, room));
      for (const event of ["pointerenter", "focus"]) take.addEventListener(event, () => this.onPreview(way, room));
      for (const event of ["pointerleave", "blur"]) take.addEventListener(event, () => this.onPreview(null, room));
      return made("li", {}, take);
    });
    return [made("strong", {}, say("How else it could stand")), made("ul", { className: "ways" }, ...lines)];
  }

  /** What holds it; a piece that does can be chosen. */
  #line({ by, what }: Hold, words: string): HTMLElement {
    const isPiece = by !== null && (what === "piece" || what === "use_side" || what === "relation");
    return made("li", {}, isPiece ? button(words, () => this.onChoose(by)) : words);
  }
}

/** How far it stands from where it was wished. */
function wishOf(answer: Explained): string[] {
  const length = awayWords(answer);
  return length ? [say("it was wished {length} from here", { length })] : [];
}
