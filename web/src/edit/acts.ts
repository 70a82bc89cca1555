/** What is done to all that is chosen: moved, turned, copied, lined up, deleted, painted; decorations as well as furniture. */
import type { Decoration, Furniture, OtherWay, Room, Scene } from "../contract";
import type { Home } from "../state/home";
import type { Editor } from "./editor";
import { aligned, changedPiece, changedThing, clipped, hungOver, laidAs, pasted, resizedIn, shifted, stoodSo, withoutThing, type Alignment, type Clip } from "./many_edits";
import { say } from "../words/language";
import { theWords } from "../words/telling";
import { without } from "./scene_edits";
import type { Draft } from "./wishes";

/** How far beside what was copied its copy is wished [m]. */
const BESIDE = 0.1;

export class Acts {
  #clips: readonly Clip[] = [];

  /** `decorated` asks for a scene with other decorations. */
  constructor(readonly home: Home, readonly editor: Editor, readonly decorated: (scene: Scene, signal: AbortSignal) => Promise<Scene>) {}

  /** A decoration and its room. */
  thing(id: string | null, scene: Scene | null = this.home.scene): { readonly room: Room; readonly thing: Decoration } | null {
    for (const room of scene?.rooms ?? []) {
      const thing = room.decorations.find((one) => one.id === id);
      if (thing) return { room, thing };
    }
    return null;
  }

  /** Whether anything chosen can be changed, once it is unlocked. */
  get canChange(): boolean {
    return this.home.chosen.some((id) => this.home.find(id) ?? this.thing(id));
  }

  /** What is chosen and not locked: furniture and decorations. */
  #free(scene: Scene | null): string[] {
    return this.home.chosen.filter((id) => {
      const piece = this.#pieceIn(scene, id);
      return piece ? piece.locked !== true : this.thing(id, scene) !== null;
    });
  }

  /** Tells that all that is chosen is locked, where it is, and offers to unlock it. */
  #stays(): boolean {
    const { scene, chosen } = this.home;
    const held = chosen.flatMap((id) => this.home.find(id) ?? []).filter(({ piece }) => piece.locked);
    const room = held[0]?.room.id;
    if (!scene || room === undefined || this.#free(scene).length > 0) return false;
    const conflicts = held.map(({ piece: { id, rotation } }) => ({
      ids: [id], message: say("{piece} is locked: it stays where it is", { piece: theWords(id) }),
      repairs: [{ action: "unlock", id, dx: 0, dz: 0, rotation: rotation ?? 0 } as const],
    }));
    this.editor.words.refused({ sent: scene, moved: [], room, conflicts, live: false });
    return true;
  }

  #pieceIn(scene: Scene | null, id: string): Furniture | undefined {
    return scene?.rooms.flatMap((room) => room.furniture).find((piece) => piece.id === id);
  }

  /** Changes what is chosen now, as one step. */
  #each(make: (scene: Scene, ids: readonly string[]) => Scene, isHeld = true): void {
    const chosen = this.home.chosen;
    this.editor.change((scene) => {
      const ids = this.#free(scene).filter((id) => chosen.includes(id));
      const changed = make(scene, ids);
      return ids.length > 0 && changed !== scene ? this.#draft(scene, changed, ids, chosen, isHeld) : null;
    });
  }

  #draft(before: Scene, scene: Scene, ids: readonly string[], chosen: readonly string[], isHeld: boolean): Draft | null {
    const rooms = before.rooms.filter((room) => [...room.furniture, ...room.decorations].some(({ id }) => ids.includes(id))).map(({ id }) => id);
    const [room, ...others] = rooms;
    const moved = isHeld ? ids.filter((id) => this.#pieceIn(scene, id)) : [];
    return room === undefined ? null : { scene, id: ids[0] ?? "", room, rooms: others, moved, chosen };
  }

  get #only(): string | null {
    const [only, ...others] = this.home.chosen;
    return only !== undefined && others.length === 0 && this.home.find(only) ? only : null;
  }

  nudge(dx: number, dz: number): void {
    if (this.#stays()) return;
    if (this.#only !== null) this.editor.nudge(this.#only, dx, dz);
    else this.#each((scene, ids) => shifted(scene, ids, dx, dz));
  }

  turn(degrees: number): void {
    if (this.#stays()) return;
    for (const id of this.home.chosen) {
      const thing = this.thing(id)?.thing;
      if (thing?.mounted_on_wall) continue;
      if (thing) this.editor.change((scene) => this.#turned(scene, id, degrees));
      else this.editor.rotate(id, degrees);
    }
  }

  #turned(scene: Scene, id: string, degrees: number): Draft | null {
    const found = this.thing(id, scene);
    const rotation = (((found?.thing.rotation ?? 0) + degrees) % 360 + 360) % 360;
    return found ? { scene: changedThing(scene, id, { rotation }), id, room: found.room.id, chosen: [id] } : null;
  }

  remove(): void {
    if (this.#stays()) return;
    if (this.#only !== null) this.editor.remove(this.#only);
    else this.#each((scene, ids) => ids.reduce((left, id) => (this.#pieceIn(left, id) ? without(left, id) : withoutThing(left, id)), scene));
  }

  align(how: Alignment): void {
    this.#each((scene, ids) => aligned(scene, ids, how));
  }

  paint(id: string, color: string): void {
    this.editor.change((scene) => {
      const [found, thing] = [this.home.find(id), this.thing(id, scene)];
      if (thing) return { scene: changedThing(scene, id, { color }), id, room: thing.room.id, chosen: [id] };
      return found ? { scene: changedPiece(scene, id, { color }), id, room: found.room.id } : null;
    });
  }

  /** Gives a piece another size or kind, its centre moved by as much [m]. */
  change(id: string, change: Partial<Furniture>, dx = 0, dz = 0): void {
    this.editor.change((scene) => {
      const found = this.home.find(id);
      if (!found || found.piece.locked) return null;
      const moved = { x: found.piece.x + dx, z: found.piece.z + dz };
      const place = dx === 0 && dz === 0 ? {} : moved;
      return { scene: changedPiece(scene, id, { ...change, ...place }), id, room: found.room.id, moved: [id] };
    });
  }

  /**
   * Stands a piece in another way, the others as they would stand with it. Those of another size have laid on them what the service would;
   * what hangs at a wall over those that move hangs where the service would hang it.
   */
  stand(id: string, way: OtherWay, room: string): void {
    this.editor.change(async (before, signal) => {
      const there = stoodSo(before, way.moves, way.left_out);
      const [resized, moved] = [resizedIn(before, there), way.moves.map((move) => move.id)];
      const over = new Set(moved);
      const scene = resized.length > 0 || hungOver(there, over).length > 0 ? laidAs(there, await this.decorated(there, signal), resized, over) : there;
      return { scene, id, room, moved };
    });
  }

  /** Puts a decoration somewhere else [m in its room], on something or on nothing. */
  put(id: string, to: Partial<Decoration>): void {
    this.editor.change((scene) => {
      const found = this.thing(id, scene);
      return found ? { scene: changedThing(scene, id, to), id, room: found.room.id, moved: [], chosen: [id] } : null;
    });
  }

  /** Keeps what is chosen, to be pasted. */
  copy(): void {
    const { scene } = this.home;
    if (scene && this.home.chosen.length > 0) this.#clips = clipped(scene, this.home.chosen);
  }

  get canPaste(): boolean {
    return this.#clips.length > 0;
  }

  /** Puts what was copied into a room, among what stands there if it can. */
  paste(room: string | undefined): void {
    if (room !== undefined) this.#paste(this.#clips, room);
  }

  duplicate(): void {
    const { scene, selected } = this.home;
    const room = this.home.find(selected)?.room.id ?? this.thing(selected)?.room.id;
    if (scene && room !== undefined) this.#paste(clipped(scene, this.home.chosen), room);
  }

  #paste(clips: readonly Clip[], roomId: string): void {
    const bodies = clips.flatMap(({ furniture: [piece], decorations: [thing] }) => piece ?? thing ?? []);
    if (bodies.length === 0) return;
    const [west, east] = [Math.min(...bodies.map(({ x, width }) => x - width / 2)), Math.max(...bodies.map(({ x, width }) => x + width / 2))];
    this.editor.change((scene) => {
      const room = scene.rooms.find(({ id }) => id === roomId);
      if (!room) return null;
      const by = east - west + BESIDE;
      const dx = east + by <= room.width ? by : Math.max(-west, -by);
      const { scene: made, ids } = pasted(scene, roomId, clips, dx, 0);
      return { scene: made, id: ids[0] ?? "", room: roomId, locked: room.furniture.map(({ id }) => id), chosen: ids };
    });
  }
}
