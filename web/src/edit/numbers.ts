/** Numbers of what is chosen, in the house and beside it: distances, guides, a tape, handles, sizes. */
import type { Catalog, Explained, Furniture, Room, Side } from "../contract";
import { storeysOf, type PlacedBody } from "../house/frame";
import type { Stage } from "../stage";
import type { Home } from "../state/home";
import type { Acts } from "./acts";
import type { Editor } from "./editor";
import { gapLines, guideLines } from "./gap_lines";
import { GapPanel } from "./gap_panel";
import { Handles } from "./handles";
import { PiecePanel } from "./piece_panel";
import { Rulers } from "./rulers";
import { sizeRange } from "./size_range";
import { snapped, type Guide } from "./snap";
import { Tape } from "./tape";
import { whyLines } from "./why_lines";

/** A piece in hand: where it is wished, and in which room. */
export interface InHand {
  readonly piece: Furniture;
  readonly room: string;
}

const WAYS: Readonly<Record<Side, readonly [number, number]>> = { north: [0, -1], east: [1, 0], south: [0, 1], west: [-1, 0] };

export class Numbers {
  readonly tape = new Tape();
  readonly rulers: Rulers;
  readonly #gaps: GapPanel;
  readonly #panel: PiecePanel;
  readonly #handles: Handles;
  #catalog: Catalog | null = null;
  #guides: readonly Guide[] = [];

  constructor(readonly home: Home, readonly stage: Stage, readonly editor: Editor, readonly acts: Acts, hosts: { readonly gaps: HTMLElement; readonly piece: HTMLDetailsElement; readonly tape: HTMLElement }) {
    this.#handles = new Handles(stage.host, stage.viewport, {
      seen: (id) => stage.house?.bodies.find((body) => body.id === id) ?? null,
      preview: (body) => this.#preview(body),
      turn: (id, degrees) => editor.rotate(id, degrees),
      resize: (id, change, dx, dz) => acts.change(id, change, dx, dz),
    });
    this.rulers = new Rulers(stage.host, stage.viewport); // after the handles: words keep clear of them
    this.#gaps = new GapPanel(hosts.gaps);
    this.#gaps.onCloser = (side, millimetres) => this.#closer(side, millimetres);
    this.#panel = new PiecePanel(hosts.piece, {
      change: (id, change) => acts.change(id, change),
      paint: (id, color) => acts.paint(id, color),
      turnTo: (id, rotation) => editor.rotate(id, rotation - (home.find(id)?.piece.rotation ?? 0)),
      align: (how) => acts.align(how),
    });
    this.tape.onChange = (lines, words) => {
      this.rulers.show("tape", lines);
      [hosts.tape.textContent, hosts.tape.hidden] = [words, words === ""];
      this.show(null); // under a tape, distances take no click
    };
    stage.takesClick = (hit) => this.tape.click(hit);
  }

  /** Learns which sizes and colours kinds have. */
  learn(catalog: Catalog): void {
    this.#catalog = catalog;
    this.show(null);
  }

  /** Shows the numbers of what is chosen, or in hand. */
  show(held: InHand | null): void {
    const { scene, selected, chosen } = this.home;
    const found = this.home.find(selected);
    const room = held ? scene?.rooms.find(({ id }) => id === held.room) : found?.room;
    const piece = held?.piece ?? found?.piece ?? null;
    const gaps = this.#gaps.show(scene, room, piece?.id ?? null, held?.piece ?? null);
    this.rulers.show("gaps", scene && room && piece ? gapLines(gaps, room, piece, this.#ground(room), held || this.tape.isOut ? undefined : (side, to) => this.#gaps.edit(side, to)) : []);
    this.rulers.show("guides", held && room ? guideLines(this.#guides, room, this.#ground(room)) : []);
    if (held) this.#handles.show(null, null);
    else this.#showPanels(found?.piece ?? null, chosen.length);
  }

  #showPanels(piece: Furniture | null, count: number): void {
    this.#panel.show(this.#catalog, piece, this.acts.thing(this.home.selected)?.thing ?? null, count);
    const free = piece && !piece.locked && count === 1 ? piece : null;
    this.#handles.show(free?.id ?? null, free && this.#catalog ? sizeRange(this.#catalog, free) : null);
  }

  #ground(room: Room): number {
    const { scene } = this.home;
    return scene ? storeysOf(scene).get(room.level)?.elevation ?? 0 : 0;
  }

  /** Where a dragged piece comes to lie that is wished at a place of the house; `isFree`: lined up with nothing. */
  brought(id: string, at: { readonly x: number; readonly z: number }, isFree: boolean): { readonly x: number; readonly z: number } {
    const { scene } = this.home;
    const piece = this.home.settled?.scene.rooms.flatMap((room) => room.furniture).find((one) => one.id === id);
    const room = scene?.rooms.find((one) => at.x >= one.x && at.x <= one.x + one.width && at.z >= one.z && at.z <= one.z + one.depth && one.furniture.some((other) => other.id === id))
      ?? this.home.find(id)?.room;
    this.#guides = [];
    if (!scene || !piece || !room || isFree) return at;
    const standsAtWall = this.#catalog?.furniture[piece.kind ?? ""]?.stands === "wall";
    const { x, z, guides } = snapped(scene, room, { ...piece, x: at.x - room.x, z: at.z - room.z }, standsAtWall);
    this.#guides = guides;
    return { x: room.x + x, z: room.z + z };
  }

  /** The tape's end comes to lie on what is chosen. */
  chosen(id: string | null): void {
    const body = this.tape.isOut ? this.stage.house?.bodies.find((one) => one.id === id) : undefined;
    if (body) this.tape.lay([body.x, body.y, body.z]);
  }

  /** Shows what holds a piece as arrows; nothing for null. */
  explain(answer: Explained | null): void {
    const found = this.home.find(answer?.id ?? null);
    this.rulers.show("why", answer && found ? whyLines(answer, found.room, found.piece, this.#ground(found.room)) : []);
    if (!answer) return this.show(null);
    this.rulers.show("gaps", []); // one thing at a time
    this.#handles.show(null, null);
  }

  /** Lets go of a handle. Tells whether one was held. */
  cancel(): boolean {
    return this.#handles.cancel();
  }

  #preview(body: PlacedBody | null): void {
    this.stage.house?.frame("settles", body ? [body] : []);
    this.stage.viewport.invalidate();
  }

  #closer(side: Side, millimetres: number): void {
    const [x, z] = WAYS[side];
    this.acts.nudge((x * millimetres) / 1000, (z * millimetres) / 1000);
  }
}
