/** Furnished rooms whose walls are dragged: pieces are kept where they can be, and what a room then lacks is furnished. */
import type { FixAnswer, FixRequest, GenerateAnswer, Room, Scene } from "../contract";
import { Live } from "../edit/live";
import { Newest } from "../newest";
import { areSame } from "./corners";
import type { Draft, DraftRoom } from "./draft";
import { draftCorners, draftOf, sceneOf } from "./scene_draft";

export interface ReflowCalls {
  fix(request: FixRequest, signal: AbortSignal): Promise<FixAnswer>;
  /** Furnishes rooms; what stands in them is kept. */
  furnish(scene: Scene, rooms: readonly string[], signal: AbortSignal): Promise<GenerateAnswer>;
}

export interface ReflowWords {
  /** The rooms as they would be, while a wall is dragged. */
  seen(rooms: ReadonlyMap<string, Room>): void;
  /** What a step of the plan has become. */
  settled(of: Draft, becomes: Draft): void;
}

interface Question {
  readonly draft: Draft;
  readonly rooms: ReadonlySet<string>;
}

/** The furnished rooms of a plan that have another shape than they were furnished in. */
export function reshapedRooms({ rooms }: Draft): ReadonlySet<string> {
  const isAsFurnished = ({ corners, from }: DraftRoom): boolean => !from || from.furniture.length === 0 || areSame(corners, draftCorners(from));
  return new Set(rooms.filter((room) => !isAsFurnished(room)).map(({ id }) => id));
}

/** The plan's rooms alone, each with its doors as ways out: what is judged the quickest. */
function roomsAlone({ draft, rooms }: Question): Scene {
  const whole = sceneOf(draft);
  const kept = whole.rooms.filter((room) => rooms.has(room.id));
  const openings = (room: Room): Room["openings"] => room.openings.map((one) => (one.kind === "window" || rooms.has(one.connects_to ?? "") ? one : { ...one, connects_to: "EXTERIOR" }));
  return { ...whole, rooms: kept.map((room) => ({ ...room, openings: openings(room) })), dynamic: whole.dynamic.filter((body) => rooms.has(body.room)) };
}

export class Reflow {
  readonly #live: Live<Question, FixAnswer>;
  readonly #round = new Newest();
  /** The plan of the step that was made last, and what comes of that. */
  #asked: { readonly draft: Draft; readonly done: Promise<void> } | null = null;

  constructor(readonly calls: ReflowCalls, readonly words: ReflowWords) {
    this.#live = new Live({
      ask: (question, signal) => calls.fix({ scene: roomsAlone(question), on_conflict: "remove" }, signal),
      answered: ({ scene }) => words.seen(new Map(scene.rooms.map((room) => [room.id, room]))),
      failed: () => words.seen(new Map()),
    });
  }

  /** Asks how the rooms would be, while a wall is dragged. */
  moment(draft: Draft): void {
    const rooms = reshapedRooms(draft);
    if (rooms.size > 0) this.#live.want({ draft, rooms });
  }

  /** Repairs and furnishes the rooms that a step has changed, and those of a step before whose answer has not come. Asked for again, it goes on waiting, unless that failed. */
  step(draft: Draft): Promise<void> {
    this.#live.stop();
    if (this.#asked?.draft === draft) return this.#asked.done;
    const signal = this.#round.next();
    const done = this.#arrange(draft, signal).catch((reason: unknown) => {
      if (signal.aborted) return;
      this.#asked = null;
      throw reason;
    });
    this.#asked = { draft, done };
    return done;
  }

  async #arrange(draft: Draft, signal: AbortSignal): Promise<void> {
    const rooms = reshapedRooms(draft);
    if (rooms.size === 0) return;
    const fixed = await this.calls.fix({ scene: sceneOf(draft), on_conflict: "remove" }, signal);
    const { scene } = await this.calls.furnish(fixed.scene, [...rooms], signal);
    const becomes = this.#with(draft, scene, rooms);
    if (!signal.aborted && reshapedRooms(becomes).size === 0) this.words.settled(draft, becomes);
  }

  /** The plan with rooms as the service has furnished them. */
  #with(draft: Draft, scene: Scene, rooms: ReadonlySet<string>): Draft {
    const made = new Map(draftOf(scene).rooms.map((room) => [room.id, room.from]));
    return { ...draft, rooms: draft.rooms.map((room) => (rooms.has(room.id) ? { ...room, from: made.get(room.id) ?? room.from } : room)) };
  }
}
