/** The canvas and what happens on it: the house shown, looked at, pointed at and clicked. */
import { Vector3 } from "three";
import type { Catalog, Issue, Scene } from "./contract";
import { AssetLibrary } from "./house/asset_library";
import { drawable } from "./house/drawable";
import { House, type Hit } from "./house/house";
import { rehearse, rehearseKinds } from "./house/rehearsal";
import { ShapeBook } from "./house/shapes";
import { showAssetCount } from "./panel/asset_count";
import { assetFile } from "./service";
import { timed } from "./timing";
import type { PresetName } from "./view/cameras";
import { doorInView } from "./view/door_in_view";
import { Labels } from "./view/labels";
import { Looking } from "./view/looking";
import { marksOf } from "./view/mark_words";
import { listenToPointer } from "./view/pointer";
import { listenToViewKeys } from "./view/view_keys";
import { Viewport } from "./view/viewport";

function within<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

export class Stage {
  /** How many rectangles of free and kept floor are drawn. */
  floorZones = 0;
  #scene: Scene | null = null;
  /** Called with the body clicked, or null for a click beside all. */
  onSelect: (id: string | null) => void = () => undefined;
  /** Called with the room whose floor was clicked, or null for a click beside all. */
  onRoom: (id: string | null) => void = () => undefined;
  readonly #viewport: Viewport;
  readonly #labels: Labels;
  readonly #looking: Looking;
  #house: House | null = null;
  #catalog: Catalog | null = null;
  #book = new ShapeBook(null);
  #library: AssetLibrary | null = null;
  #selected: string | null = null;

  constructor(readonly host: HTMLElement) {
    this.#viewport = new Viewport(host);
    this.#labels = new Labels(within("labels"), this.#viewport);
    this.#looking = new Looking(this.#viewport, this.#labels);
    this.#viewport.onFrame(() => this.#turnCompass());
    listenToPointer(this.#viewport.canvas, {
      click: (x, y) => this.#click(x, y),
      over: (at) => this.#point(at && this.#hitAt(at.clientX, at.clientY)),
    });
    this.#listenToKeys();
  }

  #listenToKeys(): void {
    listenToViewKeys({
      hasChosen: () => this.#selected !== null,
      orbit: (step) => this.#viewport.orbit(step),
      toggleAll: () => { this.#toggleFronts(null); },
      toggleDoor: () => this.#selected !== null && this.#toggleFronts(this.#selected) ? undefined : this.#toggleDoor(this.#house ? doorInView(this.#house, this.#viewport, (id) => this.whereIs(id) !== null) : undefined),
    });
  }

  show(shown: Scene, issues: readonly Issue[]): void {
    this.#scene = shown;
    const scene = drawable(shown, this.#catalog);
    const sameSize = this.#house?.scene.size.width === scene.size.width && this.#house.scene.size.depth === scene.size.depth;
    const house = this.#build(scene);
    house.mark("error", issues.filter((issue) => issue.severity === "error").flatMap((issue) => issue.ids));
    within("no_rooms").hidden = scene.rooms.length > 0;
    this.#labels.show(house);
    this.#labels.showMarks(marksOf(issues));
    this.#looking.show(house, !sameSize);
  }

  #build(scene: Scene): House {
    return timed("house built", () => {
      this.#house?.dispose();
      const house = (this.#house = new House(scene, this.#book, this.#shownAssets));
      this.#viewport.add(house.root, house.bounds, house.outline);
      house.cutAt(this.#looking.height);
      return house;
    });
  }

  get #shownAssets() {
    return this.#library && { library: this.#library, onArrival: () => this.#viewport.castShadows() };
  }

  /** From the first frame until there is a house, makes what that will need. */
  async rehearse(): Promise<void> {
    await new Promise<void>((drawn) => this.#viewport.onFrame(drawn));
    await rehearse((root) => this.#viewport.prepare(root), () => this.#house === null);
  }

  /** Learns how kinds look; what is shown from now on is drawn so. */
  dress(catalog: Catalog): void {
    this.#catalog = catalog;
    this.#book = new ShapeBook(catalog);
    this.#library = new AssetLibrary(catalog.assets ?? {}, assetFile);
    this.#library.onCount = (count) => showAssetCount(within("assets_shown"), count);
    if (!this.#house) rehearseKinds(catalog);
  }

  look(way: PresetName | "walk"): void {
    this.#looking.look(way);
  }

  /** The house as it is drawn. */
  get house(): House | null {
    return this.#house;
  }

  /** The scene shown; the moments of an edit under way are only in `places`. */
  get scene(): Scene | null {
    return this.#scene;
  }

  /** Where every body is drawn: across, along [m] and its turn [degrees]. */
  get places(): Readonly<Record<string, readonly number[]>> {
    const bodies = this.#house?.bodies ?? [];
    return Object.fromEntries(bodies.map(({ id, x, z, turn }) => [id, [x, z, (turn * 180) / Math.PI]]));
  }

  get viewport(): Viewport {
    return this.#viewport;
  }

  /** Names all pieces, or again only those pointed at and chosen. */
  toggleNames(): void {
    this.#looking.toggleNames();
  }

  /** Brings a body into the middle of the canvas. */
  centre(id: string): void {
    const body = this.#house?.bodies.find((one) => one.id === id);
    if (body) this.#viewport.centre([body.x, body.y, body.z]);
  }

  select(id: string | null): void {
    this.#selected = id;
    this.#house?.mark("selected", id === null ? [] : [id]);
    this.#labels.choose(id);
    this.#viewport.invalidate();
  }

  #hitAt(clientX: number, clientY: number): Hit | null {
    return this.#house?.hit(this.#viewport.rayAt(clientX, clientY)) ?? null;
  }

  #click(clientX: number, clientY: number): void {
    const hit = this.#hitAt(clientX, clientY);
    const floor = this.#house?.floorOf(hit);
    if (floor && this.#looking.goTo(floor[0], floor[2])) return;
    if (hit?.kind === "door") this.#toggleDoor(hit.index);
    else if (hit?.kind === "body" && hit.front !== undefined && hit.body.id === this.#selected) this.#toggleFronts(hit.body.id, hit.front);
    else this.onSelect(hit?.kind === "body" ? hit.body.id : null);
    if (hit === null || hit.kind === "room") this.onRoom(hit?.room.id ?? null);
  }

  #toggleDoor(index: number | undefined): void {
    const doors = this.#house?.doors;
    if (index === undefined) return;
    doors?.toggle(index);
    this.#viewport.move((seconds) => {
      this.#viewport.castShadows();
      return doors?.step(seconds) ?? false;
    });
  }

  /** Opens or shuts fronts, until they meet something. */
  #toggleFronts(id: string | null, front?: string): boolean {
    const house = this.#house;
    if (!house?.toggleFronts(id, front)) return false;
    this.#viewport.move((seconds) => {
      const moving = house === this.#house && house.stepFronts(seconds);
      this.#viewport.castShadows();
      return moving;
    });
    return true;
  }

  #point(hit: Hit | null): void {
    const body = hit?.kind === "body" ? hit.body : null;
    this.#viewport.canvas.classList.toggle("pointing", hit?.kind === "body" || hit?.kind === "door");
    if (!this.#labels.point(body)) return;
    this.#house?.mark("pointed", body ? [body.id] : []);
    this.#viewport.invalidate();
  }

  /** Where in the window a click meets a body, one of its fronts, a door or a room's floor [CSS pixels]; null where something stands before it. */
  whereIs(id: string): { x: number; y: number } | null {
    const points = this.#house?.pointsOf(id, this.#looking.height) ?? [];
    const { left, top, width, height } = this.host.getBoundingClientRect();
    for (const point of points) {
      const seen = this.#viewport.project(new Vector3(...point));
      const isOnCanvas = seen && seen.x > 0 && seen.y > 0 && seen.x < width && seen.y < height;
      const at = isOnCanvas && { x: Math.round(seen.x + left), y: Math.round(seen.y + top) };
      if (at && this.#house?.isHit(this.#hitAt(at.x, at.y), id)) return at;
    }
    return null;
  }

  /** Builds the shown house anew; returns how long the script took [ms]. */
  rebuild(): number {
    const start = performance.now();
    if (this.#house) this.#build(this.#house.scene);
    return performance.now() - start;
  }

  /** Builds the shown house anew a number of times; returns how long the script took for each [ms], and what a frame costs. */
  measure(times: number) {
    const rebuilds = Array.from({ length: this.#house ? times : 0 }, () => {
      const built = this.rebuild();
      this.#viewport.cost();
      return built;
    });
    return { rebuilds, ...this.#viewport.cost() };
  }

  /** What is shown, told to whoever looks into the page from outside. */
  get state() {
    return {
      ...this.#viewport.state,
      selected: this.#selected,
      walls: this.#looking.height,
      openDoors: this.#house?.doors.open ?? [],
      openFronts: this.#house?.openFronts ?? [],
      doors: this.#house?.doors.leaves.map((leaf) => leaf.id) ?? [],
      bodies: this.#house?.bodies.map((body) => body.id) ?? [],
      marks: this.#house?.marks ?? {},
      floorZones: this.floorZones,
      assets: this.#library?.count ?? null,
    };
  }

  #turnCompass(): void {
    within("compass").style.transform = `rotate(${this.#viewport.heading.toFixed(3)}rad)`;
  }
}
