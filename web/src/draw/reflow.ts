/** Furnished rooms whose walls are dragged: pieces are kept where they can be, and what a room then lacks is furnished. */
import type { FixAnswer, FixRequest, GenerateAnswer, Room, Scene } from "../contract";
import { Live } from "../edit/live";
import type { Draft, DraftRoom } from "./draft";
import { draftOf, sceneOf } from "./scene_draft";

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
  failed(reason: unknown): void;
}

interface Question {
  readonly draft: Draft;
  readonly rooms: ReadonlySet<string>;
}

const NEVER = new AbortController().signal;

/** The furnished rooms of a plan that have another shape than before. */
export function reshapedRooms(before: Draft, after: Draft): ReadonlySet<string> {
  const shapes = new Map(before.rooms.map((room) => [room.id, room]));
  const isReshaped = ({ id, corners, from }: DraftRoom): boolean => {
    const was = shapes.get(id);
    const isMoved = was?.from !== from; // as a whole, with all that stands in it
    return !isMoved && was !== undefined && was.corners !== corners && (from?.furniture.length ?? 0) > 0;
  };
  return new Set(after.rooms.filter(isReshaped).map(({ id }) => id));
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

  constructor(readonly calls: ReflowCalls, readonly words: ReflowWords) {
    this.#live = new Live({
      ask: (question, signal) => calls.fix({ scene: roomsAlone(question), on_conflict: "remove" }, signal),
      answered: ({ scene }) => words.seen(new Map(scene.rooms.map((room) => [room.id, room]))),
      failed: () => words.seen(new Map()),
    });
  }

  /** Asks how the rooms would be, while a wall is dragged. */
  moment(before: Draft, draft: Draft): void {
    const rooms = reshapedRooms(before, draft);
    if (rooms.size > 0) this.#live.want({ draft, rooms });
  }

  /** Repairs and furnishes the rooms that a step has changed. */
  async step(before: Draft, draft: Draft): Promise<void> {
    this.#live.stop();
    const rooms = reshapedRooms(before, draft);
    if (rooms.size === 0) return;
    try {
      const fixed = await this.calls.fix({ scene: sceneOf(draft), on_conflict: "remove" }, NEVER);
      const { scene } = await this.calls.furnish(fixed.scene, [...rooms], NEVER);
      this.words.settled(draft, this.#with(draft, scene, rooms));
    } catch (reason) {
      this.words.failed(reason);
    }
  }

  /** The plan with rooms as the service has furnished them. */
  #with(draft: Draft, scene: Scene, rooms: ReadonlySet<string>): Draft {
    const made = new Map(draftOf(scene).rooms.map((room) => [room.id, room.from]));
    return { ...draft, rooms: draft.rooms.map((room) => (rooms.has(room.id) ? { ...room, from: made.get(room.id) ?? room.from } : room)) };
  }
}
