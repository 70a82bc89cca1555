/** The one copy of what is shown: the scene with the service's verdict on it, its history, and what is pointed out. */
import type { Conflict, Furniture, GenerateAnswer, HouseRequest, Issue, Room, Scene } from "../contract";
import { sharing } from "../memory/changes";
import { Steps } from "./steps";

/** Where a home comes from. */
export interface Origin {
  /** What makes it, but for what was edited; null for a file's. */
  readonly made: HouseRequest | null;
  /** The name of the file that held it, where it was one. */
  readonly file: string | null;
}

export interface Shown extends Partial<Origin> {
  readonly scene: Scene;
  readonly issues: readonly Issue[];
  readonly conflicts: readonly Conflict[];
  readonly timing: GenerateAnswer["timing_ms"];
}

/** What lies before the first step of a home, and after one of its steps: other homes. Null where there is none. */
export interface Beyond {
  readonly back: (() => void) | null;
  readonly forth: (() => void) | null;
}

/** What an answer is to the one before: another house, an edit that can be undone, or a moment of an edit under way. */
export type Showing = "new" | "step" | "live";

/** What listeners are told by: `shown` also says how. Undo and redo are steps. */
export interface Changes {
  shown: Showing;
  selected: string | null;
  room: string | null;
  flagged: ReadonlySet<string>;
  /** The bodies chosen beside the one in hand. */
  also: ReadonlySet<string>;
  /** What lies before and after the home has changed. */
  beyond: null;
}

type Listener<Change extends keyof Changes> = (how: Changes[Change]) => void;

function isSameHome(before: Shown, after: Shown): boolean {
  const origin = ({ made = null, file = null }: Shown): string => JSON.stringify([made, file]);
  return after.scene === before.scene && origin(before) === origin(after);
}

export class Home {
  #shown: Shown | null = null;
  /** Its states but for the moments of an edit, which are only shown. */
  #steps: Steps<Shown> | null = null;
  #beyond: () => Beyond = () => ({ back: null, forth: null });
  #selected: string | null = null;
  #also: ReadonlySet<string> = new Set();
  #room: string | null = null;
  #flagged: ReadonlySet<string> = new Set();
  readonly #listeners: { [Change in keyof Changes]: Listener<Change>[] } = { shown: [], selected: [], also: [], room: [], flagged: [], beyond: [] };

  /** Calls a listener after every change of a kind. */
  on<Change extends keyof Changes>(change: Change, listener: Listener<Change>): void {
    this.#listeners[change].push(listener);
  }

  get shown(): Shown | null {
    return this.#shown;
  }

  get scene(): Scene | null {
    return this.#shown?.scene ?? null;
  }

  get issues(): readonly Issue[] {
    return this.#shown?.issues ?? [];
  }

  /** The last state that is whole: what an edit under way goes back to. */
  get settled(): Shown | null {
    return this.#steps?.now ?? null;
  }

  show(shown: Shown, how: Showing): void {
    const [steps, before] = [this.#steps, this.settled];
    if (how === "step" && steps && before) {
      const after = { made: before.made ?? null, file: before.file ?? null, ...shown, scene: sharing(before.scene, shown.scene) };
      if (isSameHome(before, after)) return this.#present(before, how); // nothing that undo could take back
      this.#steps = steps.with(after);
      this.#present(after, how);
      return;
    }
    if (how !== "live") this.#steps = new Steps([shown]);
    this.#present(shown, how);
  }

  /** Shows a home with all its steps, at one of them. */
  restore(steps: readonly Shown[], at: number): void {
    this.#steps = new Steps(steps, at);
    this.#present(this.#steps.now, "new");
  }

  /** All steps of the home, from the first on. */
  get steps(): readonly Shown[] {
    return this.#steps?.all ?? [];
  }

  /** Which of the steps is shown. */
  get at(): number {
    return this.#steps?.at ?? 0;
  }

  /** Whether the home differs from what it began as. */
  get isEdited(): boolean {
    return this.#steps?.canUndo ?? false;
  }

  /** Learns of the homes before and after this one. */
  lieBetween(beyond: () => Beyond): void {
    this.#beyond = beyond;
    this.#tell("beyond", null);
  }

  #roomIds(): string {
    return (this.scene?.rooms ?? []).map(({ id }) => id).join("\n");
  }

  get canUndo(): boolean {
    return this.isEdited || this.#beyond().back !== null;
  }

  get canRedo(): boolean {
    return this.#steps?.canRedo === true || this.#beyond().forth !== null;
  }

  undo(): void {
    if (!this.#steps?.canUndo) {
      this.#beyond().back?.();
      return;
    }
    this.#steps = this.#steps.undone();
    const [left, rooms] = [this.#bodyIds(), this.#roomIds()];
    this.#present(this.#steps.now, "step");
    if (this.#selected === null && this.#roomIds() === rooms) this.choose(this.#broughtBack(left));
  }

  /** What a deletion that is undone brings back: furniture, not what lies on it; else decorations. Nothing where something else went for it. */
  #broughtBack(left: ReadonlySet<string>): readonly string[] {
    const now = this.#bodyIds();
    const isAll = [...left].every((id) => now.has(id));
    const back = (kind: "furniture" | "decorations"): string[] => (this.scene?.rooms ?? []).flatMap((room) => room[kind].map(({ id }) => id)).filter((id) => !left.has(id));
    return !isAll ? [] : back("furniture").length > 0 ? back("furniture") : back("decorations");
  }

  redo(): void {
    const { forth } = this.#beyond();
    if (forth) {
      forth();
      return;
    }
    if (!this.#steps?.canRedo) return;
    this.#steps = this.#steps.redone();
    this.#present(this.#steps.now, "step");
  }

  #present(shown: Shown, how: Showing): void {
    this.#shown = shown;
    this.#tell("shown", how);
    this.#forgetMissing();
  }

  /** What is no longer there is no longer selected. */
  #forgetMissing(): void {
    if (this.#selected !== null && !this.#bodyIds().has(this.#selected)) this.select(null);
    const also = [...this.#also].filter((id) => this.#bodyIds().has(id));
    if (also.length < this.#also.size) this.#chooseAlso(new Set(also));
    if (this.#room !== null && !this.scene?.rooms.some((room) => room.id === this.#room)) this.selectRoom(null);
    const kept = [...this.#flagged].filter((id) => this.#bodyIds().has(id));
    if (kept.length < this.#flagged.size) this.#flag(new Set(kept));
  }

  #bodyIds(): ReadonlySet<string> {
    const rooms = this.scene?.rooms ?? [];
    const standing = rooms.flatMap((room) => [...room.furniture, ...room.decorations].map((body) => body.id));
    return new Set([...standing, ...(this.scene?.dynamic ?? []).map((body) => body.id)]);
  }

  /** The id of the body in hand. */
  get selected(): string | null {
    return this.#selected;
  }

  select(id: string | null): void {
    if (id !== null && !this.#bodyIds().has(id)) return;
    if (this.#also.size > 0) this.#chooseAlso(new Set());
    if (id === this.#selected) return;
    this.#selected = id;
    this.#tell("selected", id);
  }

  /** The ids of the bodies chosen beside the one in hand. */
  get also(): ReadonlySet<string> {
    return this.#also;
  }

  /** The ids of all that is chosen, the body in hand first. */
  get chosen(): readonly string[] {
    return this.#selected === null ? [] : [this.#selected, ...this.#also];
  }

  /** Chooses several bodies; the first is the one in hand. */
  choose(ids: readonly string[]): void {
    const [first = null, ...others] = ids;
    this.select(first);
    if (others.length > 0) this.#chooseAlso(new Set(others.filter((id) => id !== first && this.#bodyIds().has(id))));
  }

  /** Adds a body to those chosen, or takes it out. */
  toggleChosen(id: string): void {
    const chosen = this.chosen;
    this.choose(chosen.includes(id) ? chosen.filter((one) => one !== id) : [...chosen, id]);
  }

  #chooseAlso(ids: ReadonlySet<string>): void {
    this.#also = ids;
    this.#tell("also", ids);
  }

  /** The id of the room in hand. */
  get room(): string | null {
    return this.#room;
  }

  selectRoom(id: string | null): void {
    if (id === this.#room) return;
    this.#room = id;
    this.#tell("room", id);
  }

  /** The ids that a person marked for the report. */
  get flagged(): ReadonlySet<string> {
    return this.#flagged;
  }

  toggleFlag(id: string): void {
    if (!this.#bodyIds().has(id)) return;
    const flagged = new Set(this.#flagged);
    if (!flagged.delete(id)) flagged.add(id);
    this.#flag(flagged);
  }

  #flag(flagged: ReadonlySet<string>): void {
    this.#flagged = flagged;
    this.#tell("flagged", flagged);
  }

  /** The ids of the furniture that must not move. */
  get locked(): ReadonlySet<string> {
    const pieces = this.scene?.rooms.flatMap((room) => room.furniture) ?? [];
    return new Set(pieces.filter((piece) => piece.locked).map((piece) => piece.id));
  }

  /** A piece of furniture and its room. */
  find(id: string | null): { readonly room: Room; readonly piece: Furniture } | null {
    for (const room of this.scene?.rooms ?? []) {
      const piece = room.furniture.find((one) => one.id === id);
      if (piece) return { room, piece };
    }
    return null;
  }

  #tell<Change extends keyof Changes>(change: Change, how: Changes[Change]): void {
    for (const listener of this.#listeners[change]) listener(how);
  }
}
