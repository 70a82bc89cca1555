/** The canvas and what happens on it: the house shown, looked at, pointed at and clicked. */
import { Vector3, type Matrix4 } from "three";
import type { Catalog, Issue, Scene } from "./contract";
import { AssetLibrary } from "./house/asset_library";
import { drawable } from "./house/drawable";
import { House, type Hit } from "./house/house";
import { rehearse } from "./house/rehearsal";
import { ShapeBook } from "./house/shapes";
import { styleOf } from "./house/frame";
import { kindSitter, roomSitter, type Looks } from "./house/sitters";
import { fileName, save } from "./panel/files";
import { showAssetCount } from "./panel/asset_count";
import type { DrawPlan } from "./plan/drawn_sheet";
import { PlanBeside } from "./plan/plan_beside";
import { PlanSheet } from "./plan/plan_sheet";
import { assetFile, floor, planOf } from "./service";
import { timed } from "./timing";
import type { PresetName } from "./view/cameras";
import { doorInView } from "./view/door_in_view";
import { Labels } from "./view/labels";
import { Looking } from "./view/looking";
import { marksOf } from "./view/mark_words";
import { listenToPointer } from "./view/pointer";
import { listenToViewKeys } from "./view/view_keys";
import { Storeys } from "./view/storeys";
import { Viewport } from "./view/viewport";
import { element } from "./element";

/** A picture's width and height [pixels]. */
const PICTURE = [3840, 2160] as const;
/** Who walks opens a cupboard that is this near [m]. */
const WITHIN_REACH = 1.8;
/** So much around the middle of a piece is seen beside a panel, too [CSS pixels]. */
const AROUND = 40;

export class Stage {
  /** How many rectangles of free and kept floor are drawn. */
  floorZones = 0;
  #scene: Scene | null = null;
  #issues: readonly Issue[] = [];
  /** Called with the body clicked, or null for a click beside all. */
  onSelect: (id: string | null) => void = () => undefined;
  /** Called with the body that was clicked with Shift. */
  onAlso: (id: string) => void = () => undefined;
  /** Whether what is clicked joins what is chosen, as with Shift: fingers have none. */
  adds = false;
  /** Told of a click first; true where that is all that comes of it. */
  takesClick: (hit: Hit | null) => boolean = () => false;
  /** Called with the room whose floor was clicked, or null for a click beside all. */
  onRoom: (id: string | null) => void = () => undefined;
  readonly #viewport: Viewport;
  readonly #labels: Labels;
  /** Which storey is looked at. */
  readonly storeys = new Storeys(element("storey"));
  readonly #looking: Looking;
  /** Told when the same home is drawn anew: another storey is looked at. */
  onRedrawn: () => void = () => undefined;
  /** Told why a plan or the floor was not found, and what asks for the plan again. */
  onFailure: (reason: unknown, again?: () => void) => void = () => undefined;
  readonly sheet: PlanSheet;
  /** Null where the page has no place for it, as in a frame. */
  readonly beside: PlanBeside | null;
  #house: House | null = null;
  #catalog: Catalog | null = null;
  #book = new ShapeBook(null);
  #library: AssetLibrary | null = null;
  #selected: string | null = null;
  #isPlan = false;
  /** Where in the window the pointer is, over the canvas, and from where something was pointed at with it. */
  #pointer: { readonly clientX: number; readonly clientY: number } | null = null;
  #pointedFrom: Matrix4 | null = null;

  constructor(readonly host: HTMLElement) {
    this.#viewport = new Viewport(host);
    this.#labels = new Labels(element("labels"), this.#viewport);
    this.#looking = new Looking(this.#viewport, this.#labels, async (scene, signal) => (await floor(scene, [], signal)).rooms);
    this.#looking.onFailure = (reason) => this.onFailure(reason);
    const draw: DrawPlan = (scene, scale, signal) => planOf(this.storeys.planned(scene), scale, signal);
    this.sheet = new PlanSheet(this.#viewport, draw, (reason, again) => this.onFailure(reason, again));
    const place = document.getElementById("beside");
    this.beside = place && new PlanBeside(place, element("camera_split"), draw, (reason, again) => this.onFailure(reason, again));
    if (this.beside) {
      this.beside.onSelect = (id) => { if (this.adds && id !== null) this.onAlso(id); else this.onSelect(id); };
      this.beside.onAlso = (id) => this.onAlso(id);
      this.beside.onWished = () => { if (this.#isPlan) this.look("corner"); }; // not two plans
    }
    this.#looking.onLook = (way) => {
      this.#turnPlan(way === "plan");
      if (way === "walk") this.onSelect(null); // what is said of a piece would hide the way
    };
    this.#viewport.onFrame(() => { this.#turnCompass(); this.#placeSheets(); this.#pointAnew(); });
    listenToPointer(this.#viewport.canvas, {
      click: (x, y, adds) => this.#click(x, y, adds),
      over: (at) => { this.#pointer = at; this.#point(this.#underPointer); },
    });
    this.storeys.onChoose = () => this.#changeStorey();
    window.addEventListener("beforeprint", () => this.#print());
    this.#listenToKeys();
  }

  #redraw(): void {
    if (this.#scene) this.show(this.#scene, this.#issues);
    this.onRedrawn();
  }

  #changeStorey(): void {
    this.#redraw();
    this.onSelect(null);
  }

  /** Moves on the sheets what an edit under way moves. */
  #placeSheets(): void {
    for (const sheet of [this.sheet, this.beside]) sheet?.place(this.#house?.bodies ?? []);
  }

  #listenToKeys(): void {
    listenToViewKeys({
      hasChosen: () => this.#selected !== null,
      orbit: (step) => this.#viewport.orbit(step),
      toggleAll: () => { this.#toggleFronts(null); },
      toggleDoor: () => this.#toggleAhead(),
    });
  }

  /** Opens or shuts the fronts of the chosen piece, to who walks what is looked at within reach, else the door in view. */
  #toggleAhead(): void {
    const { pose } = this.#viewport;
    if (this.#selected !== null && this.#toggleFronts(this.#selected)) return;
    const hit = pose ? this.#house?.hit(this.#viewport.rayAhead()) : null;
    const isNear = pose && hit?.kind === "body" && Math.hypot(hit.at[0] - pose.eye[0], hit.at[2] - pose.eye[2]) < WITHIN_REACH;
    if (isNear && this.#toggleFronts(hit.body.id)) return;
    this.#toggleDoor(this.#house ? doorInView(this.#house, this.#viewport, (id) => this.whereIs(id) !== null) : undefined);
  }

  show(shown: Scene, issues: readonly Issue[]): void {
    [this.#scene, this.#issues] = [shown, issues];
    const whole = drawable(shown, this.#catalog);
    this.storeys.learn(whole);
    const scene = this.storeys.drawn(whole);
    this.#looking.rise = this.storeys.riseIn(whole);
    const sameSize = this.#house?.scene.size.width === scene.size.width && this.#house.scene.size.depth === scene.size.depth;
    const house = this.#build(scene);
    house.mark("error", issues.filter((issue) => issue.severity === "error").flatMap((issue) => issue.ids));
    element("no_rooms").hidden = scene.rooms.length > 0;
    this.#labels.show(house);
    this.#labels.showMarks(marksOf(issues));
    this.#looking.show(house, shown, !sameSize);
    this.sheet.show(shown);
    this.beside?.show(shown);
  }

  #turnPlan(isPlan: boolean): void {
    this.#isPlan = isPlan;
    this.sheet.turn(isPlan);
    this.#house?.showSolids(!isPlan);
    this.#viewport.invalidate();
  }

  #build(scene: Scene): House {
    return timed("house built", () => {
      this.#house?.dispose();
      const house = (this.#house = new House(scene, this.#book, this.#shownAssets));
      this.#viewport.add(house.root, house.bounds, house.outline, house.top);
      house.cutAt(this.#looking.cut);
      house.showSolids(!this.#isPlan);
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
  learnCatalog(catalog: Catalog): void {
    this.#catalog = catalog;
    this.#book = new ShapeBook(catalog);
    this.#library = new AssetLibrary(catalog.assets ?? {}, assetFile);
    this.#library.onCount = (count) => showAssetCount(element("assets_shown"), count);
  }

  /** Draws a kind onto a small canvas, as it looks in the style of the house shown. */
  portrayKind(kind: Looks, into: HTMLCanvasElement): void {
    this.#viewport.portray(() => kindSitter(kind, this.#book, this.#scene ? styleOf(this.#scene) : null), into);
  }

  /** Draws a scene of one room onto a small canvas. */
  portrayRoom(scene: Scene, into: HTMLCanvasElement): void {
    this.#viewport.portray(() => roomSitter(drawable(scene, this.#catalog), this.#book), into);
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

  /** Saves what is in view as a 4K picture; of the plan, the plan at its scale. */
  async savePicture(): Promise<void> {
    if (this.#isPlan) {
      element("plan_png").click();
      return;
    }
    const made = await this.#viewport.picturing.png(...PICTURE, getComputedStyle(this.host).backgroundColor);
    if (made && this.#scene) save(made, fileName(this.#scene, "png"));
  }

  /** Draws the view for the browser's own print; the plan is a sheet already. */
  #print(): void {
    const paper = document.querySelector<HTMLCanvasElement>("#view_print");
    if (paper && !this.#isPlan && this.#scene) this.#viewport.picturing.printOn(paper);
  }

  /** Brings a body into the middle of the canvas. */
  centre(id: string): void {
    const body = this.#house?.bodies.find((one) => one.id === id);
    if (body) this.#viewport.centre([body.x, body.y, body.z]);
  }

  /** Brings a body out from under a panel at the right, if it lies there. */
  uncover(id: string, panel: HTMLElement): void {
    const body = this.#house?.bodies.find((one) => one.id === id);
    const seen = body && this.#viewport.project(new Vector3(body.x, body.y + body.height / 2, body.z));
    const [over, { left, top, right }] = [panel.getBoundingClientRect(), this.host.getBoundingClientRect()];
    if (!body || !seen || left + seen.x < over.left - AROUND || Math.abs(top + seen.y - (over.top + over.bottom) / 2) > over.height / 2 + AROUND) return;
    this.#viewport.centre([body.x, body.y, body.z], right - over.left);
  }

  /** Shows what is chosen: the body in hand, and others beside it. */
  select(id: string | null, also: ReadonlySet<string> = new Set()): void {
    this.#selected = id;
    if (id !== null) this.#comeTo(id);
    this.#house?.mark("selected", id === null ? [] : [id, ...also]);
    this.beside?.select(id === null ? [] : [id, ...also]);
    this.#labels.choose(id);
    this.#viewport.invalidate();
  }

  /** What a plan of a scene shows: the storey that is looked at. */
  planned(scene: Scene | null): Scene | null {
    return scene && this.storeys.planned(scene);
  }

  /** Looks at the storey that a body is on. */
  #comeTo(id: string): void {
    const room = this.#scene?.rooms.find(({ furniture, decorations }) => [...furniture, ...decorations].some((one) => one.id === id));
    if (room && this.storeys.goTo(room.level ?? 0)) this.#redraw();
  }

  #hitAt(clientX: number, clientY: number): Hit | null {
    return this.#house?.hit(this.#viewport.rayAt(clientX, clientY)) ?? null;
  }

  #click(clientX: number, clientY: number, adds: boolean): void {
    const hit = this.#hitAt(clientX, clientY);
    if (this.takesClick(hit)) return;
    if (adds || this.adds) {
      if (hit?.kind === "body") this.onAlso(hit.body.id);
      return;
    }
    const ground = this.#house?.floorOf(hit);
    if (ground && this.#looking.goTo(ground[0], ground[2])) return;
    if (hit?.kind === "door") this.#toggleDoor(hit.index);
    else if (this.#viewport.pose && hit?.kind === "body" && hit.front !== undefined) this.#toggleFronts(hit.body.id, hit.front);
    else if (hit?.kind === "body" && hit.front !== undefined && hit.body.id === this.#selected) this.#toggleFronts(hit.body.id, hit.front);
    else this.onSelect(hit?.kind === "body" ? hit.body.id : null);
    if (hit === null || hit.kind === "room") this.onRoom(hit?.room.id ?? null);
  }

  #toggleDoor(index: number | undefined): void {
    const doors = this.#house?.doors;
    if (index === undefined) return;
    doors?.toggle(index);
    this.#viewport.glide((seconds) => {
      this.#viewport.castShadows();
      return doors?.step(seconds) ?? false;
    });
  }

  /** Opens or shuts fronts, until they meet something. */
  #toggleFronts(id: string | null, front?: string): boolean {
    const house = this.#house;
    if (!house?.toggleFronts(id, front)) return false;
    this.#viewport.glide((seconds) => {
      const moving = house === this.#house && house.stepFronts(seconds);
      this.#viewport.castShadows();
      return moving;
    });
    return true;
  }

  get #underPointer(): Hit | null {
    return this.#pointer && this.#hitAt(this.#pointer.clientX, this.#pointer.clientY);
  }

  /** What is pointed at from elsewhere by now may be another thing. */
  #pointAnew(): void {
    if (this.#pointedFrom && !this.#viewport.camera.matrixWorld.equals(this.#pointedFrom)) this.#point(this.#underPointer);
  }

  #point(hit: Hit | null): void {
    const body = hit?.kind === "body" ? hit.body : null;
    const isThing = hit?.kind === "body" || hit?.kind === "door";
    this.#pointedFrom = isThing ? this.#viewport.camera.matrixWorld.clone() : null;
    this.#viewport.canvas.classList.toggle("pointing", isThing);
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

  /** Where in the window a place of the ground floor is seen [CSS pixels]. */
  whereAt(x: number, z: number): { x: number; y: number } | null {
    const seen = this.#viewport.project(new Vector3(x, 0, z));
    const { left, top } = this.host.getBoundingClientRect();
    return seen && { x: seen.x + left, y: seen.y + top };
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
      this.#viewport.picturing.cost();
      return built;
    });
    return { rebuilds, ...this.#viewport.picturing.cost() };
  }

  /** What is shown, told to whoever looks into the page from outside. */
  get state() {
    return {
      ...this.#viewport.state,
      selected: this.#selected,
      walls: this.#looking.height,
      lowered: this.#looking.lowered,
      sun: this.#viewport.daylight.direction.toArray(),
      knowsFloor: this.#looking.knowsFloor,
      openDoors: this.#house?.doors.open ?? [],
      openFronts: this.#house?.openFronts ?? [],
      doors: this.#house?.doors.ids ?? [],
      bodies: this.#house?.bodies.map((body) => body.id) ?? [],
      marks: this.#house?.marks ?? {},
      floorZones: this.floorZones,
      assets: this.#library?.count ?? null,
    };
  }

  #turnCompass(): void {
    element("compass").style.setProperty("--heading", `${this.#viewport.heading.toFixed(3)}rad`);
  }
}
