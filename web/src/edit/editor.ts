/** Edits of the home: each is wished for, judged by the service, and shown as one step that can be undone. */
import type { Conflict, FixAnswer, FixRequest, Repair, Room, Scene } from "../contract";
import type { Home, Shown } from "../state/home";
import { roomHolding } from "../house/room_at";
import { isAbort } from "../service";
import { answerOf, drawn, samePlaces, type TakeInHand } from "./frames";
import { conflictsIn } from "./judging";
import { Live } from "./live";
import { shifted, transferred } from "./many_edits";
import { alone, locked, moved, posesOf, repaired, withRoom, without } from "./scene_edits";
import { within, type Draft, type Drafted, type Held, type Question, type Shift } from "./wishes";

export type Fix = (request: FixRequest, signal?: AbortSignal) => Promise<FixAnswer>;

/** How often the same wish is asked again while something is still on its way there. */
const MOST_ROUNDS = 40;

/** What a scene could not become, why, and what would help. */
export interface Refusal {
  readonly sent: Scene;
  readonly moved: readonly string[];
  readonly room: string;
  readonly conflicts: readonly Conflict[];
  /** The drag goes on: it is too early to take a repair. */
  readonly live: boolean;
}

export interface EditorWords {
  busy(busy: boolean): void;
  /** The home is as it was before the edit; `again` does that once more. */
  failed(reason: unknown, again: () => void): void;
  /** Another home is shown before what was asked for was answered: it is not done. */
  givenUp(): void;
  /** Null: nothing is in conflict. */
  refused(refusal: Refusal | null): void;
  /** The dragged piece and all it carries are seen at a wish, the rest of its room where the answer has it. */
  lifted(id: string, wished: Scene): void;
  answered(id: string, scene: Scene): void;
  /** Nothing is dragged any more. */
  settled(): void;
}

export class Editor {
  readonly #live: Live<Question, FixAnswer>;
  #held: Held | null = null;
  #dropped = false;
  /** Told when the piece that was let go is judged: what is asked meanwhile waits for that. */
  #landed: (() => void) | null = null;
  /** What was asked for and is not done, in its order: what takes it back, and what it is called where it is a wish. */
  readonly #turns = new Map<AbortController, string | null>();
  #queue: Promise<void> = Promise.resolve();
  /** What is wished for a piece and has not begun: more of the same is added up. */
  #shifted: Shift | null = null;

  constructor(readonly home: Home, readonly fix: Fix, readonly words: EditorWords, readonly takeInHand: TakeInHand = () => Promise.resolve(null)) {
    this.#live = new Live({
      ask: (question, signal) => this.#ask(question, signal),
      answered: (answer, question) => this.#answered(answer, question),
      failed: (reason) => this.#lost(reason),
    });
  }

  /** Whether an edit waits for its answer, or a piece is in hand. */
  get busy(): boolean {
    return this.#turns.size > 0 || this.#held !== null;
  }

  /** Resolves once the edits that were asked for until now are judged. */
  get landed(): Promise<void> {
    return this.#queue;
  }

  get dragged(): string | null {
    return this.#held?.id ?? null;
  }

  /** Whether a piece is held that was not let go yet. */
  get #inHand(): boolean {
    return this.#held !== null && !this.#dropped;
  }

  /** Takes a piece in hand, and others that go along; what is locked stays. */
  lift(id: string, others: readonly string[] = []): boolean {
    const found = this.home.find(id);
    const before = this.home.settled;
    if (!found || !before || this.busy || found.piece.locked) return false;
    const { room, piece } = found;
    const going = others.flatMap((one) => { const other = this.home.find(one); return other && one !== id && !other.piece.locked ? [other] : []; });
    const group = going.map((other) => other.piece.id);
    const wish = { x: piece.x, z: piece.z, rotation: piece.rotation ?? 0 };
    const held: Held = {
      id, room, group, rooms: [...new Set([room.id, ...going.map((other) => other.room.id)])], whole: before.scene,
      base: group.length > 0 ? before.scene : alone(before.scene, room.id), wish, previous: posesOf(before.scene, room.id), frames: null,
    };
    this.#held = held;
    this.#dropped = false;
    if (group.length === 0) this.#prepare(held);
    this.words.refused(null);
    return true;
  }

  #prepare(held: Held): void {
    const { base } = held;
    this.takeInHand(moved(base, held.id, held.wish), held.id).then((frames) => { if (held.base === base) held.frames = frames; }, () => undefined); // the service is asked instead
  }

  /** Wishes for the held piece's centre somewhere in the house; dragged into another room of its storey it belongs there. */
  drag(at: { readonly x: number; readonly z: number }): void {
    const [held, before] = [this.#held, this.home.settled];
    if (!held || !before || this.#dropped) return;
    const there = roomHolding(before.scene.rooms, held.room.level, at.x, at.z);
    if (there && there.id !== held.room.id && held.group.length === 0) this.#enter(held, transferred(before.scene, held.id, there.id), there.id);
    const { room, wish: { rotation } } = held;
    const piece = room.furniture.find((one) => one.id === held.id);
    if (!piece) return;
    const [across, along] = rotation % 180 === 0 ? [piece.width, piece.depth] : [piece.depth, piece.width];
    held.wish = { rotation, x: within(at.x - room.x, across, room.width), z: within(at.z - room.z, along, room.depth) };
    const scene = this.#wishedIn(held, held.base);
    this.words.lifted(held.id, scene);
    if (held.group.length === 0) this.#live.want({ held, last: false, round: 0, request: this.#wishFor(held, scene) });
  }

  /** The held piece has come into another room. */
  #enter(held: Held, whole: Scene, roomId: string): void {
    const room = whole.rooms.find((one) => one.id === roomId);
    if (!room) return;
    this.#live.stop();
    Object.assign(held, { whole, room, base: alone(whole, roomId), previous: posesOf(whole, roomId), frames: null } satisfies Partial<Held>);
    this.#prepare(held);
  }

  /** A scene with what is held where it is wished. */
  #wishedIn({ id, group, room, wish }: Held, scene: Scene): Scene {
    const piece = room.furniture.find((one) => one.id === id);
    return group.length > 0 && piece ? shifted(scene, [id, ...group], wish.x - piece.x, wish.z - piece.z) : moved(scene, id, wish);
  }

  /** Asks the core in the page for a frame, the service where there is none, and for what a piece let go becomes. */
  async #ask({ held, request, last, round }: Question, signal: AbortSignal): Promise<FixAnswer> {
    if (last) return this.fix(request, signal);
    if (round > 0) await drawn();
    try {
      if (held.frames) return answerOf(await held.frames.frame(request.scene), held.id, request.scene);
    } catch {
      held.frames = null; // it failed: the service goes on
    }
    return this.fix({ ...request, dragging: true }, signal);
  }

  #wishFor(held: Held, scene: Scene): FixRequest {
    return { scene, moved: [held.id, ...held.group], on_conflict: "report", previous: held.previous };
  }

  /** Lets the held piece go: the whole house is judged, and what stands is one step. */
  drop(): void {
    const [held, before] = [this.#held, this.home.settled];
    if (!held || !before) return;
    this.#dropped = true;
    void this.#enqueue(() => (this.#held ? new Promise((landed) => { this.#landed = landed; }) : Promise.resolve()));
    this.#live.want({ held, last: true, round: 0, request: this.#wishFor(held, this.#wishedIn(held, held.whole)) });
  }

  /** Puts the held piece back. */
  cancel(): void {
    if (!this.#held) return;
    this.#live.stop();
    this.#goBack();
    this.words.refused(null);
  }

  /** Another house is shown: what was under way is about none of it, and nothing waits for it. */
  forget(): void {
    const isUnderWay = this.#turns.size > 0;
    for (const turn of [...this.#turns.keys()]) this.#leave(turn);
    this.#queue = Promise.resolve();
    this.#shifted = null;
    this.#live.stop();
    if (this.#held) this.#end();
    this.words.busy(false);
    this.words.refused(null);
    if (isUnderWay) this.words.givenUp();
  }

  #goBack(): void {
    const before = this.home.settled;
    this.#end();
    if (before) this.home.show(before, "live");
  }

  #end(): void {
    this.#held = null;
    this.#landed?.();
    this.#landed = null;
    this.words.busy(this.#turns.size > 0);
    this.words.settled();
  }

  #answered(answer: FixAnswer, question: Question): void {
    const { held, request, last } = question;
    const before = this.home.settled;
    if (held !== this.#held || !before) return;
    const conflicts = conflictsIn(answer, [held.room.id, ...held.rooms], before);
    const refusal: Refusal = { sent: request.scene, moved: [held.id, ...held.group], room: held.room.id, conflicts, live: !last };
    this.words.refused(conflicts.length > 0 ? refusal : null);
    if (last) {
      if (conflicts.length > 0) this.#goBack();
      else this.#settle(answer);
    } else if (conflicts.length === 0) {
      const poses = posesOf(answer.scene, held.room.id);
      const goesOn = held.frames !== null && question.round < MOST_ROUNDS && !samePlaces(held.previous, poses);
      held.previous = poses;
      this.words.answered(held.id, answer.scene);
      this.home.show({ ...before, scene: withRoom(held.whole, answer.scene) }, "live");
      if (goesOn && !this.#live.waits && !this.#dropped) this.#live.want({ ...question, round: question.round + 1 });
    }
  }

  #settle(answer: FixAnswer): void {
    this.#end();
    this.#show(answer);
  }

  #show({ scene, issues, conflicts, timing_ms: timing }: FixAnswer): void {
    this.home.show({ scene, issues, conflicts, timing }, "step");
  }

  #lost(reason: unknown): void {
    if (this.#inHand) return; // a frame: the hand goes on, and what is asked once it lets go tells
    const [held, before] = [this.#held, this.home.settled];
    this.#goBack();
    this.words.refused(null);
    if (!held) return;
    const { id, room, rooms, group, whole } = held;
    const draft = { scene: this.#wishedIn(held, whole), id, room: room.id, rooms, moved: [id, ...group] };
    this.words.failed(reason, () => this.#edit(() => (this.home.settled === before ? draft : null)));
  }

  /** Turns a piece by an angle, counter-clockwise seen from above [degrees]. */
  rotate(id: string, degrees: number): void {
    this.#shift({ id, dx: 0, dz: 0, degrees });
  }

  /** Moves a piece [m]. */
  nudge(id: string, dx: number, dz: number): void {
    this.#shift({ id, dx, dz, degrees: 0 });
  }

  /** Moves and turns a piece; what is asked while an edit is under way is added up. */
  #shift(more: Shift): void {
    const waiting = this.#shifted;
    if (this.#inHand) return;
    if (waiting?.id === more.id) {
      waiting.dx += more.dx;
      waiting.dz += more.dz;
      waiting.degrees += more.degrees;
      return;
    }
    this.#edit(() => {
      if (this.#shifted === more) this.#shifted = null;
      return this.#draft(more.id, (scene, room, piece) => {
        const rotation = (((piece.rotation ?? 0) + more.degrees) % 360 + 360) % 360;
        const wish = { x: piece.x + more.dx, z: piece.z + more.dz, rotation };
        return { scene: moved(scene, more.id, wish), id: more.id, room: room.id, moved: [more.id] };
      });
    });
    this.#shifted = more;
  }

  /** Makes any other change, in turn with the others, what it has to ask first included; null: none is wished. */
  change(make: (scene: Scene, signal: AbortSignal) => Drafted): void {
    this.#edit((signal) => (this.home.settled ? make(this.home.settled.scene, signal) : null));
  }

  toggleLock(id: string): void {
    this.#edit(() => {
      const found = this.home.find(id);
      const scene = this.home.settled?.scene;
      return found && scene ? { scene: locked(scene, id, !found.piece.locked), id, room: found.room.id } : null;
    });
  }

  remove(id: string): void {
    this.#edit(() => this.#draft(id, (scene, room) => ({ scene: without(scene, id), id, room: room.id })));
  }

  /** Takes a repair that was offered; to leave out what is not there yet is to let it be. */
  take(refusal: Refusal, repair: Repair): void {
    if (repair.action === "leave_out" && !this.home.find(repair.id)) {
      this.words.refused(null);
      return;
    }
    this.#edit(() => ({
      scene: repaired(refusal.sent, repair), id: refusal.moved[0] ?? repair.id, room: refusal.room,
      moved: repair.action === "leave_out" ? [] : refusal.moved,
    }));
  }

  /** Takes back what was done last, or wished, if that is not done yet. */
  undo(): void {
    const [last, wish = null] = [...this.#turns].at(-1) ?? [];
    if (last && wish !== null) this.#leave(last);
    else this.#travel(() => this.home.undo());
  }

  redo(): void {
    this.#travel(() => this.home.redo());
  }

  /** Goes back or forth, after the edits that were asked for before. */
  #travel(go: () => void): void {
    if (this.#inHand) return;
    const act = (): void => {
      this.words.refused(null);
      go();
    };
    this.#shifted = null;
    if (this.busy) void this.inTurn(() => Promise.resolve(act()));
    else act();
  }

  #draft(id: string, make: (scene: Scene, room: Room, piece: Room["furniture"][number]) => Draft): Draft | null {
    const found = this.home.find(id);
    const scene = this.home.settled?.scene;
    return found && scene && !found.piece.locked ? make(scene, found.room, found.piece) : null;
  }

  #edit(make: (signal: AbortSignal) => Drafted): void {
    if (this.#inHand) return;
    this.#shifted = null;
    this.inTurn((signal) => this.#carryOut(make, signal)).catch((reason: unknown) => {
      if (!isAbort(reason)) this.words.failed(reason, () => this.#edit(make));
    });
  }

  /** Changes the home in turn: one change after the other, each on what the one before left, none of another house. */
  inTurn(change: (signal: AbortSignal) => Promise<void>): Promise<void> {
    if (this.#inHand) this.cancel();
    return this.#enqueue(change);
  }

  /** Does in turn what is wished of the home, in place of what was wished by this name and is not done yet; `withdrawn` takes it back. */
  wish(name: string, change: (signal: AbortSignal) => Promise<void>, withdrawn: AbortSignal): Promise<void> {
    if (this.#inHand) this.cancel();
    for (const [turn, other] of [...this.#turns]) if (other === name) this.#leave(turn);
    const turn = new AbortController();
    withdrawn.addEventListener("abort", () => this.#leave(turn), { once: true });
    return this.#enqueue(change, name, turn);
  }

  #enqueue(change: (signal: AbortSignal) => Promise<void>, wish: string | null = null, turn = new AbortController()): Promise<void> {
    this.#turns.set(turn, wish);
    this.words.busy(true);
    const done = this.#queue.then(() => (this.#turns.has(turn) ? change(turn.signal) : undefined)).finally(() => this.#leave(turn));
    this.#queue = done.catch(() => undefined);
    return done;
  }

  /** It is done, or is not to be done any more. */
  #leave(turn: AbortController): void {
    if (!this.#turns.delete(turn)) return;
    turn.abort();
    if (this.#turns.size === 0) this.words.busy(false);
  }

  async #carryOut(make: (signal: AbortSignal) => Drafted, signal: AbortSignal): Promise<void> {
    const before = this.home.settled;
    const draft = await make(signal);
    if (!draft || !before || this.home.settled !== before) return;
    const answer = await this.#judge(draft, before, signal);
    const conflicts = conflictsIn(answer, [draft.room, ...(draft.rooms ?? [])], before);
    if (this.home.settled !== before) return;
    const { scene: sent, room, id } = draft;
    this.words.refused(conflicts.length > 0 ? { sent, room, conflicts, moved: draft.moved?.length ? draft.moved : [id], live: false } : null);
    if (conflicts.length > 0) return;
    this.#show(answer);
    if (draft.chosen) this.home.choose(draft.chosen);
    else if (this.home.find(id) && !this.home.chosen.includes(id)) this.home.select(id);
  }

  /** Asks with the draft's own locks first, then without. */
  async #judge({ scene, moved: ids = [], locked: held, room }: Draft, before: Shown, signal: AbortSignal): Promise<FixAnswer> {
    const request: FixRequest = { scene, moved: ids, on_conflict: "report", previous: posesOf(before.scene, room) };
    if (held) {
      const answer = await this.fix({ ...request, locked: held }, signal);
      if (conflictsIn(answer, [room], before).length === 0) return answer;
    }
    return this.fix(request, signal);
  }
}
