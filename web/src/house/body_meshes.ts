/** Draws all bodies of a house in few batches, moves them, and tells which body a ray meets. */
import { Matrix4, Quaternion, Vector3 } from "three";
import type { PlacedBody } from "./frame";
import type { AssetLibrary } from "./asset_library";
import { AssetMeshes } from "./asset_meshes";
import { HitGroup } from "./hit_group";
import type { Scene } from "../contract";
import { movedWith, type Swing } from "./fronts";
import { OpenFronts } from "./open_fronts";
import { PartBatches } from "./part_batches";
import type { Part } from "./parts";
import { ShapeBook } from "./shapes";
import { cutAll, type WallCut } from "./wall_cut";

const UP = new Vector3(0, 1, 0);

/** The place of a body in the house. */
export function bodyMatrix(body: PlacedBody): Matrix4 {
  const turn = new Quaternion().setFromAxisAngle(UP, body.turn);
  return new Matrix4().compose(new Vector3(body.x, body.y, body.z), turn, new Vector3(1, 1, 1));
}

/** Where a body is put: its footprint's centre and underside [m], its turn about +y [rad]; what is not said stays. */
export type BodyPose = Partial<Pick<PlacedBody, "x" | "y" | "z" | "turn">>;

/** The own assets that bodies are shown as, and who is told when one has come. */
export interface ShownAssets {
  readonly library: AssetLibrary;
  readonly onArrival: () => void;
}

/** The drawn bodies of a house. */
export class BodyMeshes {
  readonly root: HitGroup;
  /** In how many batches they are drawn: as many draw calls. */
  readonly batches: number;
  readonly #bodies: PlacedBody[];
  readonly #parts: readonly (readonly Part[])[];
  readonly #drawn: PartBatches;
  readonly #assets: AssetMeshes | null;
  readonly #numbers: ReadonlyMap<string, number>;
  readonly #fronts: OpenFronts;
  /** What lies on each piece, by the piece's number. */
  readonly #carried = new Map<number, number[]>();
  #cut = cutAll(Number.POSITIVE_INFINITY);

  constructor(
    bodies: readonly PlacedBody[], book: ShapeBook = new ShapeBook(null), style: string | null = null, assets: ShownAssets | null = null,
    scene: Scene | null = null,
  ) {
    this.#bodies = [...bodies];
    this.#numbers = new Map(bodies.map((body, i) => [body.id, i]));
    this.#parts = bodies.map((body) => book.partsOf(body, style));
    this.#drawn = new PartBatches(bodies, this.#parts);
    this.batches = this.#drawn.meshes.length;
    this.#fronts = new OpenFronts(scene?.certificate ?? null, bodies, (body) => book.frontsOf(body));
    this.root = new HitGroup(this.#drawn, this.#bodies, (number) => this.#partsShown(number), (number) => this.#swingsOf(number));
    for (const item of scene?.rooms.flatMap((room) => room.decorations) ?? []) {
      const [own, piece] = [this.#numbers.get(item.id), this.#numbers.get(item.parent ?? "")];
      if (own !== undefined && piece !== undefined && this.#fronts.has(piece)) this.#carried.set(piece, [...(this.#carried.get(piece) ?? []), own]);
    }
    this.#assets = assets && new AssetMeshes(bodies, assets.library, (numbers) => {
      for (const number of numbers) this.#write(number);
      assets.onArrival();
    });
    if (this.#assets) this.root.add(this.#assets.root);
  }

  #swingsOf(number: number): ((front: string | undefined) => Swing | undefined) | undefined {
    return this.#fronts.has(number) ? (front) => this.#fronts.swingOf(number, front) : undefined;
  }

  /** Opens or shuts a front of a body; all of the body's where none is named, all of the house where no body is. */
  toggleFronts(id: string | null, front?: string): boolean {
    if (id === null) this.#fronts.toggleAll();
    const number = id === null ? undefined : this.#numbers.get(id);
    if (id !== null && (number === undefined || !this.#fronts.has(number) || this.#assets?.shows(number))) return false;
    if (number !== undefined && front !== undefined) this.#fronts.toggle(number, front);
    else if (number !== undefined) this.#fronts.toggleAll([number]);
    return true;
  }

  /** Moves fronts by `seconds`; true while one is under way. */
  stepFronts(seconds: number): boolean {
    const moved = this.#fronts.step(seconds);
    for (const number of moved) {
      this.#write(number);
      for (const thing of this.#carried.get(number) ?? []) this.#writeCarried(thing, number);
    }
    return moved.length > 0;
  }

  #writeCarried(thing: number, number: number): void {
    const [body, piece] = [this.#bodies[thing], this.#bodies[number]];
    if (!body || !piece) return;
    this.#draw(thing, this.#fronts.carried(body, number, piece, this.#parts[number] ?? []));
  }

  /** The ids of the fronts that are open or opening. */
  get openFronts(): string[] {
    return this.#fronts.open.map(([number, front]) => `${this.#bodies[number]?.id}/${front}`);
  }

  /** Assets that come from now on are not shown. */
  dispose(): void {
    this.#assets?.dispose();
  }

  /** Hides what hangs on walls where they are cut below its middle, or lower than others: nothing hangs in the air. */
  cutAt(cut: WallCut): void {
    this.#cut = cut;
    this.#bodies.forEach((body, i) => {
      if (body.hung !== undefined) this.#write(i);
    });
  }

  /** Moves and turns a body without building anything anew; returns it in its new place, undefined where there is no such body. */
  place(id: string, pose: BodyPose): PlacedBody | undefined {
    const number = this.#numbers.get(id);
    const body = number === undefined ? undefined : this.#bodies[number];
    if (number === undefined || !body) return undefined;
    const placed = { ...body, ...pose };
    this.#bodies[number] = placed;
    this.#write(number);
    return placed;
  }

  #write(number: number): void {
    const body = this.#bodies[number];
    if (body) this.#draw(number, body);
  }

  #draw(number: number, body: PlacedBody): void {
    const [hidden, isAsset] = [this.#hidden(body), this.#assets?.shows(number) ?? false];
    this.#drawn.place(number, body, hidden || isAsset ? [] : this.#parts[number], this.#swingsOf(number));
    this.#assets?.place(number, hidden ? null : body);
  }

  #hidden(body: PlacedBody): boolean {
    return body.hung !== undefined && (body.hung > this.#cut.height || (body.outward !== undefined && this.#cut.before.has(body.outward)));
  }

  #partsShown(number: number): readonly Part[] {
    const body = this.#bodies[number];
    return !body || this.#hidden(body) ? [] : (this.#parts[number] ?? []);
  }

  /** Points of a body's parts at which it may be seen: the middles of their tops, then of the parts. */
  pointsOf(id: string): (readonly [number, number, number])[] {
    const number = this.#numbers.get(id) ?? -1;
    const body = this.#bodies[number];
    if (!body) return [];
    const place = bodyMatrix(body);
    return [0.5, 0].flatMap((up) => (this.#parts[number] ?? []).map(({ at, size }) =>
      new Vector3(at[0], at[1] + size[1] * up, at[2]).applyMatrix4(place).toArray()));
  }

  /** Points of a front, `piece/front`, at which it may be seen where it stands now: its panel's middle, then to its sides. */
  pointsOfFront(id: string): (readonly [number, number, number])[] {
    const cut = id.lastIndexOf("/");
    const number = this.#numbers.get(id.slice(0, cut)) ?? -1;
    const [body, front] = [this.#bodies[number], id.slice(cut + 1)];
    const panel = this.#parts[number]?.find((part) => part.front === front);
    if (!body || !panel) return [];
    const [{ at, size }, swing] = [panel, this.#fronts.swingOf(number, front)];
    return [0, -0.3, 0.3].flatMap((across) => [0, 0.3, -0.3].flatMap((up) => [0.5, -0.5].map((out) => {
      const point = [at[0] + size[0] * across, at[1] + size[1] * up, at[2] + size[2] * out] as const;
      return new Vector3(...(swing ? movedWith(point, swing) : point)).applyMatrix4(bodyMatrix(body)).toArray();
    })));
  }

  /** Whether a body is drawn: what hangs above the cut is not. */
  isDrawn(id: string): boolean {
    const body = this.#bodies[this.#numbers.get(id) ?? -1];
    return body !== undefined && !this.#hidden(body);
  }

  /** The body of a hit's number. */
  bodyAt(number: number | undefined): PlacedBody | undefined {
    return number === undefined ? undefined : this.#bodies[number];
  }
}
