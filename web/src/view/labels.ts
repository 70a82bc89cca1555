/** Names over the canvas: rooms always, a piece pointed at or chosen, all pieces on demand, and words of what is wrong. */
import { Vector3 } from "three";
import { words, type PlacedBody } from "../house/frame";
import type { House } from "../house/house";
import { roomHolding } from "../house/room_at";
import { hang, hide, labelElement, moveTo, type LabelElement } from "./label_elements";
import { keptInside, layOut, type LabelWish } from "./label_layout";
import { aheadBy, RANK, sizeSeen, type Asked } from "./label_wishes";
import type { MarkWords } from "./mark_words";
import { RoomLabels } from "./room_labels";
import type { Viewport } from "./viewport";
import { sayNumber } from "../words/language";

type Named = LabelElement & { readonly id: string };

/** What lies over the canvas and over labels. */
const OVERLAYS = "#tools, #walk_leave, #compass, #minimap, .views, .fold";
const TIP_LIFT = 22;
const MARK_LIFT = 12;
/** How large a mark is that says no words [CSS pixels]. */
const SHORT_MARK = { width: 16, height: 15 };
/** Who walks reads the names of the pieces this near [m]. */
const PIECES_WITHIN = 7;

function sizeWords({ width, depth, height }: PlacedBody): string {
  return [width, depth, height].map((metres) => sayNumber(metres, 3, "short")).join(" × ");
}

function wordsOf(body: PlacedBody): string {
  return `${words(body.name)}  ${sizeWords(body)} m`;
}

export class Labels {
  /** Told after each frame how many pieces are named of how many could be; null where that was not asked for. */
  onNamed: (named: { shown: number; of: number } | null) => void = () => undefined;
  readonly #tip = labelElement("body-tip", "");
  readonly #rooms: RoomLabels;
  #pieces: Named[] = [];
  #marks: Named[] = [];
  #chosen: Named | null = null;
  #pointed: string | null = null;
  #house: House | null = null;
  #all = false;
  #withDecorations = false;
  #asked = false;
  #bodies: ReadonlyMap<string, PlacedBody> = new Map();

  constructor(readonly layer: HTMLElement, readonly viewport: Viewport) {
    this.#rooms = new RoomLabels(layer, viewport);
    this.#tip.element.hidden = true;
    layer.append(this.#tip.element);
    viewport.onFrame(() => this.#followSoon());
    viewport.overlaid.onChange = () => this.#followSoon();
    const overlays = [...document.querySelectorAll<HTMLElement>(OVERLAYS)];
    const watch = new ResizeObserver(() => this.#keepClear(overlays));
    for (const element of [...overlays, layer]) watch.observe(element);
  }

  /** Puts the rooms' names where their walls end [m]: there they are seen over the room they belong to. */
  raiseTo(height: number): void {
    this.#rooms.raiseTo(height);
    this.viewport.invalidate();
  }

  show(house: House): void {
    this.#house = house;
    this.#rooms.show(house);
    this.#rename();
    this.point(null);
  }

  /** Names every piece of furniture, with decorations where wished, or only those pointed at and chosen. */
  nameAll(all: boolean, withDecorations = false): void {
    [this.#all, this.#withDecorations] = [all || withDecorations, withDecorations];
    this.#rename();
    this.viewport.invalidate();
  }

  #keepClear(overlays: readonly HTMLElement[]): void {
    const { left, top } = this.layer.getBoundingClientRect();
    const kept = overlays.map((element) => element.getBoundingClientRect())
      .map(({ x, y, width, height }) => ({ x: x - left + width / 2, y: y - top + height / 2, width, height }))
      .filter(({ width }) => width > 0);
    this.viewport.overlaid.set("tools", kept);
    this.#follow(); // the house behind them need not be drawn again
  }

  #rename(): void {
    const named = this.#all ? (this.#house?.bodies.filter(({ kind }) => kind === "furniture" || (this.#withDecorations && kind === "decoration")) ?? []) : [];
    this.#pieces = this.#exchange(this.#pieces, named.map((body) => ({ id: body.id, words: words(body.name) })), "piece-label");
    const categories = new Map(this.#house?.scene.rooms.flatMap((room) => room.furniture.map((piece) => [piece.id, piece.category] as const)));
    for (const { id, element } of this.#pieces) element.dataset.category = categories.get(id) ?? (categories.has(id) ? "misc" : "decoration");
  }

  /** Labels for these in place of the old; those that say the same are kept. */
  #exchange(old: readonly Named[], wanted: readonly MarkWords[], look: string): Named[] {
    const keyOf = (id: string, said: string | null): string => `${id}\n${said ?? ""}`;
    const kept = new Map(old.map((label) => [keyOf(label.id, label.element.textContent), label]));
    const made: Named[] = [];
    const labels = wanted.map(({ id, words: said }) => {
      const same = kept.get(keyOf(id, said));
      if (same) return same;
      const label = Object.assign(labelElement(look, said), { id });
      made.push(label);
      return label;
    });
    const used = new Set(labels);
    for (const label of old) if (!used.has(label)) label.element.remove();
    hang(this.layer, made);
    return labels;
  }

  /** Sets red words at bodies, in place of those before. */
  showMarks(marks: readonly MarkWords[]): void {
    this.#marks = this.#exchange(this.#marks, marks, "mark-label");
    this.viewport.invalidate();
  }

  /** Names the body chosen for as long as it is. */
  choose(id: string | null): void {
    const body = this.#house?.bodies.find((one) => one.id === id);
    const wanted = body ? [{ id: body.id, words: wordsOf(body) }] : [];
    this.#chosen = this.#exchange(this.#chosen ? [this.#chosen] : [], wanted, "piece-label chosen")[0] ?? null;
    this.viewport.invalidate();
  }

  /** Names the body pointed at; tells whether that is another than before. */
  point(body: PlacedBody | null): boolean {
    if ((body?.id ?? null) === this.#pointed) return false;
    this.#pointed = body?.id ?? null;
    const [name] = this.#tip.element.children;
    if (body && name) {
      name.textContent = wordsOf(body);
      this.#tip.element.hidden = false;
      [this.#tip.width, this.#tip.height] = [this.#tip.element.offsetWidth, this.#tip.element.offsetHeight];
    }
    this.viewport.invalidate();
    return true;
  }

  /** Once all is where it is shown, and before any of it is seen. */
  #followSoon(): void {
    if (this.#asked) return;
    this.#asked = true;
    queueMicrotask(() => this.#follow());
  }

  #follow(): void {
    this.#asked = false;
    this.#bodies = new Map(this.#house?.bodies.map((body) => [body.id, body]));
    const pieces = this.#askedPieces();
    const asked = [...this.#rooms.asked(), ...this.#askedMarks(), ...this.#askedChosen(), ...this.#askedTip(), ...pieces]
      .filter((wish) => this.#onCanvas(wish))
      .map((wish) => ({ ...wish, ...keptInside(wish, this.viewport.size) }));
    const named = asked.filter(({ isDot }) => !isDot);
    const found = layOut(named, this.viewport.overlaid.all, this.viewport.size);
    const places = new Map(named.map((wish, i) => [wish, found[i] ?? null]));
    const shown = new Set<LabelElement>();
    for (const wish of asked) {
      const at = places.get(wish);
      const place = at ?? (wish.keepsDot || wish.stays ? wish : null);
      wish.label.element.classList.toggle("crowded-out", !at && wish.keepsDot === true);
      if (!place) continue;
      moveTo(wish.label, place.x, place.y);
      shown.add(wish.label);
    }
    for (const label of this.#labels()) if (!shown.has(label)) hide(label);
    this.onNamed(this.#all ? { shown: this.#pieces.filter((label) => shown.has(label)).length, of: this.#pieces.length } : null);
  }

  #labels(): LabelElement[] {
    return [this.#tip, ...this.#rooms.all, ...this.#pieces, ...this.#marks, ...(this.#chosen ? [this.#chosen] : [])];
  }

  #onCanvas({ x, y }: LabelWish): boolean {
    const { width, height } = this.viewport.size;
    return x > 0 && y > 0 && x < width && y < height;
  }

  #overBody(body: PlacedBody): { x: number; y: number } | null {
    return this.viewport.project(new Vector3(body.x, body.y + body.height, body.z));
  }

  #askedAt(labels: readonly Named[], lift: number, importance: number): Asked[] {
    return labels.flatMap((label) => {
      const body = this.#bodies.get(label.id);
      const seen = body ? this.#overBody(body) : this.#rooms.middleOf(label.id);
      return seen ? [{ label, x: seen.x, y: seen.y - lift, width: label.width, height: label.height, importance }] : [];
    });
  }

  /** Words of what is wrong: of a room that is seen narrower than these, a mark alone; they would hide those of its neighbours. */
  #askedMarks(): Asked[] {
    return this.#marks.flatMap((mark) => {
      const isShort = mark.width > this.#rooms.widthOf(mark.id);
      mark.element.classList.toggle("short", isShort);
      return this.#askedAt([mark], MARK_LIFT, RANK.mark).map((wish) => (isShort ? { ...wish, ...SHORT_MARK } : wish));
    });
  }

  #askedChosen(): Asked[] {
    const asked = this.#chosen && this.#chosen.id !== this.#pointed ? this.#askedAt([this.#chosen], TIP_LIFT, RANK.chosen) : [];
    return asked.map((wish) => ({ ...wish, stays: true }));
  }

  /** The pieces' names: all of them, or to who walks those of the room walked in; large and near before small and far. */
  #askedPieces(): Asked[] {
    const eye = this.viewport.camera.position;
    return this.#pieces.flatMap((label) => {
      const body = this.#bodies.get(label.id);
      const told = label.id === this.#pointed || label.id === this.#chosen?.id;
      if (!body || told || !this.#isNear(body)) return [];
      const distance = eye.distanceTo(new Vector3(body.x, body.y, body.z));
      return this.#askedAt([label], 0, RANK.piece + sizeSeen(body, distance));
    });
  }

  #isNear(body: PlacedBody): boolean {
    const { pose } = this.viewport;
    const rooms = this.#house?.scene.rooms ?? [];
    if (!pose) return true;
    const distance = aheadBy(pose, [body.x, body.y, body.z]);
    const here = roomHolding(rooms, 0, pose.eye[0], pose.eye[2]);
    return distance !== null && distance < PIECES_WITHIN && here === roomHolding(rooms, 0, body.x, body.z);
  }

  #askedTip(): Asked[] {
    const body = this.#pointed === null ? undefined : this.#bodies.get(this.#pointed);
    const at = body ? this.#overBody(body) : null;
    const { width, height } = this.#tip;
    return at ? [{ label: this.#tip, x: at.x, y: at.y - TIP_LIFT, width, height, importance: RANK.tip, stays: true }] : [];
  }
}
