/** A home that is edited, and a service that answers when told. */
import type { Conflict, FixAnswer, FixRequest, Scene } from "../src/contract";
import { Editor, type Refusal } from "../src/edit/editor";
import type { Frames } from "../src/edit/frames";
import { Places, type AskPlaces } from "../src/edit/places";
import { Home } from "../src/state/home";
import { piece, room, scene } from "./rooms";

export const ONE = "den/one";
export const OTHER = "den/other";
export const CRATE = { key: "crate", name: "crate", category: "storage", size: [1, 1, 1], color: null } as const;
export const turn = (): Promise<void> => new Promise((resolve) => { setTimeout(resolve, 0); });

export interface Call {
  readonly request: FixRequest;
  readonly signal: AbortSignal;
  /** Answers as sent, but for what is changed. */
  answer(change?: (sent: Scene) => Scene, conflicts?: readonly Conflict[]): Promise<void>;
  lose(): Promise<void>;
  /** Ends as a call does that is withdrawn. */
  withdrawn(): void;
}

export function house(): Scene {
  const furniture = [piece(ONE, { x: 1, z: 1, width: 1, depth: 1 }), piece(OTHER, { x: 3, z: 2, width: 1, depth: 1 }), piece("den/held", { x: 5, z: 3, locked: true })];
  return scene([room("den", [0, 0, 6, 4], { furniture }), room("hall", [0, 4, 6, 2], { furniture: [piece("hall/rack", { width: 1 })] })]);
}

/** A home that is edited, a service that answers when told, and all that is said of it. */
export function bench(frames: Frames | null = null) {
  const home = new Home();
  const calls: Call[] = [];
  const said = { busy: [] as boolean[], refused: [] as (Refusal | null)[], failed: [] as unknown[], again: [] as (() => void)[], givenUp: 0, settled: 0, lifted: 0, answered: 0 };
  const editor = new Editor(home, (request, signal) => new Promise((resolve, reject) => {
    calls.push({
      request, signal: signal ?? new AbortController().signal,
      answer: async (change = (sent) => sent, conflicts = []) => {
        resolve({ scene: change(request.scene), issues: [], conflicts, moves: [], removed: [], timing_ms: 1 } as unknown as FixAnswer);
        await turn();
      },
      lose: async () => {
        reject(new Error("lost"));
        await turn();
      },
      withdrawn: () => reject(new DOMException("withdrawn", "AbortError")),
    });
  }), {
    busy: (busy) => said.busy.push(busy), failed: (reason, again) => { said.failed.push(reason); said.again.push(again); }, givenUp: () => { said.givenUp += 1; }, refused: (refusal) => said.refused.push(refusal),
    lifted: () => { said.lifted += 1; }, answered: () => { said.answered += 1; }, settled: () => { said.settled += 1; },
  }, () => Promise.resolve(frames));
  home.show({ scene: house(), issues: [], conflicts: [], timing: 1 }, "new");
  const at = (id: string): readonly number[] => { const found = home.find(id); return [found?.piece.x ?? NaN, found?.piece.z ?? NaN]; };
  const call = (number: number): Call => { const found = calls[number]; if (!found) throw new Error(`only ${calls.length} calls`); return found; };
  return { home, editor, calls, call, said, at };
}

export const pushed = (x: number) => (sent: Scene): Scene => ({
  ...sent, rooms: sent.rooms.map((one) => ({ ...one, furniture: one.furniture.map((body) => (body.id === OTHER ? { ...body, x } : body)) })),
});

/** Puts new pieces where a service says; one that finds no place unless told otherwise. */
export function placing(editor: Editor, ask: AskPlaces = () => Promise.resolve([])): Places {
  return new Places({ hidden: true } as HTMLElement, editor, ask);
}
