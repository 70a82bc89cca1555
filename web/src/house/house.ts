/** A scene as it is drawn: floors, walls, doors, bodies, and what is marked on them. */
import { Box3, Group, Mesh, Vector3, type Intersection, type Raycaster } from "three";
import type { Room, Scene } from "../contract";
import { BodyMeshes, type BodyPose, type ShownAssets } from "./body_meshes";
import { Contacts } from "./contacts";
import { disposeOf } from "./dispose";
import { inwardOf } from "./entrance";
import { leavesOf } from "./door_leaves";
import { Doors } from "./doors";
import { ceilingMesh, floorMesh } from "./floors";
import { bodiesOf, storeysOf, styleOf, type PlacedBody } from "./frame";
import { outlineOf, PLOT } from "./house_outline";
import { openingsOf, type PlacedOpening } from "./openings";
import { lampsOf, type Lamp } from "./lamps";
import { outlinesOf } from "./outlines";
import { floorUnder, liesFlat } from "./room_at";
import { isInSight } from "./sight";
import { ShapeBook } from "./shapes";
import { slab, SLAB_MARGIN } from "./slab";
import type { Point } from "./wall_faces";
import { Walls } from "./wall_meshes";
import type { WallCut } from "./wall_cut";
import type { Storey, WallPlan } from "./walls";
import { runsOf, type Run } from "./wall_runs";

export type Mark = "selected" | "pointed" | "error" | "locked" | "conflict" | "settles";

export const MARK_COLORS: Readonly<Record<Mark, string>> = { selected: "#ffd166", pointed: "#d7e3f4", error: "#ff4d4f", locked: "#6cb6ff", conflict: "#ff4d4f", settles: "#7ee2a8" };

export type Hit =
  | { readonly kind: "door"; readonly index: number }
  | { readonly kind: "body"; readonly body: PlacedBody; readonly at: Point; readonly front?: string }
  | { readonly kind: "room"; readonly room: Room; readonly at: Point };

function boundsOf(scene: Scene, height: number): Box3 {
  const box = new Box3();
  for (const room of scene.rooms) {
    box.expandByPoint(new Vector3(room.x, 0, room.z));
    box.expandByPoint(new Vector3(room.x + room.width, height, room.z + room.depth));
  }
  return box.isEmpty() ? new Box3(new Vector3(0, 0, 0), new Vector3(PLOT.width, height, PLOT.depth)) : box;
}

/** Builds a scene's meshes; `dispose` gives them back. */
export class House {
  readonly root = new Group();
  /** What the house is made of; frames and marks are beside it. */
  readonly #solids = new Group();
  readonly doors: Doors;
  readonly bounds: Box3;
  readonly #bodyMeshes: BodyMeshes;
  readonly #walls: Walls;
  readonly #contacts: Contacts;
  readonly #ceiling: Mesh;
  readonly #marked = new Map<Mark, { readonly mesh: Mesh; readonly ids: readonly string[] }>();
  readonly #storeys: ReadonlyMap<number, Storey>;
  readonly #plan: WallPlan;
  #bodies: readonly PlacedBody[];
  #wallMeshes: Group | null = null;

  constructor(readonly scene: Scene, readonly book: ShapeBook = new ShapeBook(null), assets: ShownAssets | null = null) {
    const storeys = (this.#storeys = storeysOf(scene));
    const plan: WallPlan = (this.#plan = {
      runs: runsOf(scene.rooms, scene.wall_thickness ?? 0),
      openings: openingsOf(scene.rooms, scene.wall_thickness ?? 0),
      storeys,
      rooms: scene.rooms,
    });
    this.bounds = boundsOf(scene, 1);
    this.#bodies = bodiesOf(scene);
    this.#bodyMeshes = new BodyMeshes(this.#bodies, book, styleOf(scene), assets, scene);
    this.#walls = new Walls(plan);
    this.#contacts = new Contacts(plan, this.#bodies, (body) => (body.asset ? null : book.partsOf(body, styleOf(scene))));
    this.#ceiling = ceilingMesh(scene.rooms, storeys);
    this.doors = new Doors(leavesOf(plan), book.doorPaints(styleOf(scene)));
    const ground = slab(scene.rooms, this.bounds.min.y);
    if (ground) this.#solids.add(ground);
    this.root.add(this.#solids);
    this.#solids.add(floorMesh(scene.rooms, storeys), this.#ceiling, this.#contacts.root, this.doors.root, this.#bodyMeshes.root);
  }

  get runs(): readonly Run[] {
    return this.#plan.runs;
  }

  /** Cuts walls, doors and what hangs on walls; doors stay in walls that are lower, to be opened. */
  cutAt(cut: WallCut): void {
    const { height } = cut;
    if (this.#wallMeshes) disposeOf(this.#wallMeshes);
    this.#wallMeshes = this.#walls.meshes(cut);
    this.#solids.add(this.#wallMeshes);
    this.doors.cutAt(height);
    this.#bodyMeshes.cutAt(cut);
    this.#ceiling.visible = height >= this.wallTop;
  }

  /** Its walls and openings. */
  get plan(): WallPlan {
    return this.#plan;
  }

  /** What lights its highest storey when it grows dark. */
  get lamps(): readonly Lamp[] {
    const top = Math.max(...this.scene.rooms.map(({ level }) => level));
    const storey = this.#storeys.get(top);
    const [rooms, style] = [this.scene.rooms.filter(({ level }) => level === top), styleOf(this.scene)];
    return storey ? lampsOf(rooms, storey, this.#bodies, (body) => (this.book.isLamp(body) ? this.book.partsOf(body, style) : null)) : [];
  }

  /** The main entrance and on which side of it the house is; null where there is none. */
  get entrance(): { readonly opening: PlacedOpening; readonly inward: 1 | -1 } | null {
    const opening = this.#plan.openings.find(({ mainEntrance }) => mainEntrance);
    return opening ? { opening, inward: inwardOf(this.scene.rooms, opening) } : null;
  }

  /** The middle of every door's opening on its floor, by the number of its leaf. */
  get doorways(): { readonly id: string; readonly index: number; readonly at: Point }[] {
    return this.doors.leaves.flatMap(({ id, hinge }, index) => {
      const opening = this.#plan.openings.find((one) => one.id === id); // of two leaves the first
      if (!opening) return [];
      const [along, across] = [(opening.from + opening.to) / 2, opening.line];
      return [{ id, index, at: opening.axis === "x" ? [along, hinge.y, across] : [across, hinge.y, along] }];
    });
  }

  /** The points of the house that must be in view to see all of it. */
  get outline(): readonly Point[] {
    return outlineOf(this.scene.rooms, this.#storeys, this.#bodies, SLAB_MARGIN);
  }

  /** Whether nothing of the house's walls is between two points: one sees through passages, windows and open doors. */
  sees(from: Point, to: Point): boolean {
    return isInSight(from, to, { ...this.#plan, isOpen: (id) => this.doors.open.includes(id) });
  }

  /** How high the highest wall reaches above the ground [m]. */
  get wallTop(): number {
    return Math.max(0, ...[...this.#storeys.values()].map(({ elevation, height }) => elevation + height));
  }

  /** How high walls and bodies reach above the ground [m]. */
  get top(): number {
    return Math.max(this.wallTop, ...this.#bodies.map(({ y, height }) => y + height));
  }

  /** Every body, where it is drawn now. */
  get bodies(): readonly PlacedBody[] {
    return this.#bodies;
  }

  /** Moves a body and its marks without building the house anew; the caller casts the shadows. */
  place(id: string, pose: BodyPose): void {
    const placed = this.#bodyMeshes.place(id, pose);
    if (!placed) return;
    this.#contacts.place(placed);
    this.#bodies = this.#bodies.map((body) => (body.id === id ? placed : body));
    for (const [mark, { ids }] of [...this.#marked]) if (mark !== "settles" && ids.includes(id)) this.mark(mark, ids);
  }

  /** Draws the house itself, or only what frames and marks it. */
  showSolids(isShown: boolean): void {
    this.#solids.visible = isShown;
  }

  /** Frames the bodies with these ids in the colour of a mark, in place of those framed so before. */
  mark(mark: Mark, ids: readonly string[]): void {
    this.frame(mark, this.bodies.filter((body) => ids.includes(body.id)));
  }

  /** Frames places at which bodies may stand, whether they do or not. */
  frame(mark: Mark, framed: readonly PlacedBody[]): void {
    const old = this.#marked.get(mark);
    if (old) disposeOf(old.mesh);
    this.#marked.delete(mark);
    const mesh = outlinesOf(framed, MARK_COLORS[mark]);
    if (!mesh) return;
    this.#marked.set(mark, { mesh, ids: framed.map((body) => body.id) });
    this.root.add(mesh);
  }

  /** The ids of the framed bodies by mark. */
  get marks(): Record<string, readonly string[]> {
    return Object.fromEntries([...this.#marked].map(([mark, { ids }]) => [mark, ids]));
  }

  /** What a ray meets first, if that is a door, a body or a room's floor. */
  hit(ray: Raycaster): Hit | null {
    const targets = [this.#bodyMeshes.root, this.doors.root, ...(this.#wallMeshes?.children.slice(0, 1) ?? [])];
    const [nearest] = ray.intersectObjects(targets, false);
    const floor = floorUnder(this.scene.rooms, this.#storeys, ray.ray.origin.toArray(), ray.ray.direction.toArray());
    if (floor && floor.distance < (nearest?.distance ?? Number.POSITIVE_INFINITY)) {
      return { kind: "room", room: floor.room, at: ray.ray.at(floor.distance, new Vector3()).toArray() };
    }
    return nearest ? this.#hitOf(nearest, ray) : null;
  }

  #hitOf(nearest: Intersection, ray: Raycaster): Hit | null {
    if (nearest.object === this.doors.root && nearest.instanceId !== undefined) return { kind: "door", index: nearest.instanceId };
    const body = nearest.object === this.#bodyMeshes.root ? this.#bodyMeshes.bodyAt(nearest.instanceId) : undefined;
    if (!body) return null;
    const front = this.#bodyMeshes.root.frontAt(ray, nearest.instanceId ?? -1);
    return { kind: "body", body, at: nearest.point.toArray(), ...(front === undefined ? {} : { front }) };
  }

  /** Where one may stand on what was hit: a floor, or what lies flat on it. */
  floorOf(hit: Hit | null): Point | null {
    if (hit?.kind === "body") return liesFlat(hit.body, this.#storeys) ? hit.at : null;
    return hit?.kind === "room" ? hit.at : null;
  }

  /** Opens or shuts a front of a piece, all of a piece's where none is named, all of the house for null; false where there is none. */
  toggleFronts(id: string | null, front?: string): boolean {
    return this.#bodyMeshes.toggleFronts(id, front);
  }

  /** Moves fronts by `seconds`; true while one is under way. */
  stepFronts(seconds: number): boolean {
    return this.#bodyMeshes.stepFronts(seconds);
  }

  /** The fronts that are open or opening, as `piece/front`. */
  get openFronts(): string[] {
    return this.#bodyMeshes.openFronts;
  }

  /** The id of what was hit. */
  idOf(hit: Hit | null): string | undefined {
    if (hit?.kind === "door") return this.doors.leaves[hit.index]?.opening;
    return hit?.kind === "room" ? hit.room.id : hit?.body.id;
  }

  /** Whether a hit is what an id names: a body, a door, a room, or a front as `piece/front`. */
  isHit(hit: Hit | null, id: string): boolean {
    return this.idOf(hit) === id || (hit?.kind === "body" && hit.front !== undefined && `${hit.body.id}/${hit.front}` === id);
  }

  /** Points in the house at which a body, a front, a door leaf or a room's floor may be seen, with walls cut at a height [m]. */
  pointsOf(id: string, cut: number): Point[] {
    const points = this.#bodyMeshes.pointsOf(id);
    if (points.length > 0) return points;
    const ofFront = this.#bodyMeshes.pointsOfFront(id);
    if (ofFront.length > 0) return ofFront.map((point): Point => [...point]);
    const room = this.scene.rooms.find((one) => one.id === id);
    return room ? this.#floorPoints(room) : this.#leafPoints(id, cut);
  }

  #floorPoints(room: Room): Point[] {
    const y = this.#storeys.get(room.level)?.elevation ?? 0;
    const shares = [0.5, 0.3, 0.7, 0.15, 0.85];
    return shares.flatMap((u) => shares.map((v): Point => [room.x + room.width * u, y, room.z + room.depth * v]));
  }

  #leafPoints(id: string, cut: number): Point[] {
    const index = this.doors.leaves.findIndex((one) => one.id === id);
    const leaf = this.doors.leaves[index];
    if (!leaf) return [];
    const angle = this.doors.angleOf(index);
    const [along, across] = [Math.cos(angle) * leaf.width, -Math.sin(angle) * leaf.width];
    const top = Math.min(leaf.height, cut);
    return [0.9, 0.6, 0.3].flatMap((up) => [0.5, 0.25, 0.75].map((share): Point => [
      leaf.hinge.x + along * share, leaf.hinge.y + top * up, leaf.hinge.z + across * share,
    ]));
  }

  dispose(): void {
    this.#bodyMeshes.dispose();
    disposeOf(this.root);
    this.#marked.clear();
  }
}
