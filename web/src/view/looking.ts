/** The controls of the view: camera presets, walking, how high the walls are cut, which are lower, all names. */
import type { RoomFloor, Scene, Side } from "../contract";
import type { House } from "../house/house";
import { lightLamps } from "../house/lamps";
import { roomHolding } from "../house/room_at";
import { sidesBefore, sidesOf, type WallCut } from "../house/wall_cut";
import { Newest } from "../newest";
import { remember, remembered } from "../panel/preferences";
import { isAbort } from "../service";
import type { PresetName, Vector } from "./cameras";
import type { Labels } from "./labels";
import { Minimap } from "./minimap";
import { WALK_FOV, type Viewport } from "./viewport";
import { firstPose, turnedToSight } from "./walk";
import { WalkFloor } from "./walk_floor";
import { WalkMode } from "./walk_mode";
import { say, sayNumber } from "../words/language";
import { element } from "../element";

type Way = PresetName | "walk";

const BUTTONS: Readonly<Record<Way, string>> = { top: "camera_top", corner: "camera_corner", walk: "camera_walk", plan: "camera_plan" };

/** Says which floor of a scene is free to go on. */
export type AskWalk = (scene: Scene, signal: AbortSignal) => Promise<readonly RoomFloor[]>;

export class Looking {
  readonly #walk: WalkMode;
  readonly #cut = element<HTMLInputElement>("cut");
  readonly #lowers = element<HTMLInputElement>("lower_walls");
  readonly #hour = element<HTMLInputElement>("hour");
  /** The sides that walls were last lowered on, as bits. */
  #before = 0;
  readonly #names = element<HTMLInputElement>("all_labels");
  readonly #things = element<HTMLInputElement>("decoration_labels");
  /** Over the canvas: on a narrow screen the other buttons are far below it. */
  readonly #leave = element<HTMLButtonElement>("walk_leave");
  /** Told first how it is looked from now on. */
  onLook: (way: Way) => void = () => undefined;
  /** Told why the floor is not known: one then walks through everything. */
  onFailure: (reason: unknown) => void = () => undefined;
  readonly #map: Minimap;
  /** How high the floor of the storey that is looked at lies [m]. */
  rise = 0;
  #house: House | null = null;
  /** The scene as it was sent: the floor is asked of it. */
  #scene: Scene | null = null;
  readonly #pending = new Newest();

  constructor(readonly viewport: Viewport, readonly labels: Labels, readonly askFloor: AskWalk) {
    this.#map = new Minimap(element("minimap"));
    this.#map.onPlace = (x, z) => { this.goTo(x, z); };
    viewport.onFrame(() => { this.#map.follow(this.#walk.pose); this.#followView(); });
    this.#walk = new WalkMode(viewport);
    this.#walk.onLeave = () => this.look("corner");
    this.#cut.addEventListener("input", () => this.cutWalls());
    this.#lightUp(remembered("hour"));
    this.#hour.addEventListener("input", () => this.#lightUp(this.#hour.value));
    this.#lowers.checked = remembered("lower_walls") !== "no";
    this.#lowers.addEventListener("change", () => {
      remember("lower_walls", this.#lowers.checked ? "yes" : "no");
      this.cutWalls();
    });
    for (const names of [this.#names, this.#things]) names.addEventListener("change", () => this.#nameAll());
    for (const way of Object.keys(BUTTONS) as Way[]) element(BUTTONS[way]).addEventListener("click", () => this.look(way));
    this.#leave.addEventListener("click", () => this.look("corner"));
    labels.onNamed = (named) => this.#tellNamed(named);
    this.#cutWords();
  }

  /** Another house: `jump` looks at it anew, else one looks on from where one was. */
  show(house: House, scene: Scene, jump: boolean): void {
    [this.#house, this.#scene] = [house, scene];
    lightLamps(house.lamps, this.viewport.daylight.lamps);
    this.labels.raiseTo(this.height);
    this.#map.show(house);
    if (this.#walk.pose && jump) this.#enter();
    else if (this.#walk.pose) void this.#learnFloor();
    else if (jump) this.look("corner", true);
    this.#followView();
  }

  /** Walks to a place of the plan [m]; tells whether one walks at all. */
  goTo(x: number, z: number): boolean {
    if (this.#walk.pose) this.#walk.goTo([x, z]);
    return this.#walk.pose !== null;
  }

  look(way: Way, jump = false): void {
    this.viewport.flatten(way === "plan");
    this.onLook(way);
    this.viewport.host.dataset.view = way;
    if (way === "walk") this.#enter();
    else this.#leaveFor(way, jump);
    for (const [name, id] of Object.entries(BUTTONS)) element(id).setAttribute("aria-pressed", String(name === way));
    element("walk_hint").hidden = way !== "walk";
    this.#offerLeaving(this.#walk.pose !== null);
  }

  #offerLeaving(walks: boolean): void {
    if (!walks && document.activeElement === this.#leave) this.viewport.host.focus({ preventScroll: true });
    this.#leave.hidden = !walks;
  }

  #isSeenIndoors(from: Vector, [x, y, z]: Vector): boolean {
    const room = roomHolding(this.#scene?.rooms ?? [], 0, x, z);
    return room !== undefined && !room.outdoor && this.#house?.sees(from, [x, y, z]) === true;
  }

  #enter(): void {
    if (!this.#house) return;
    const { entrance, bounds } = this.#house;
    const area = { min: bounds.min.toArray(), max: bounds.max.toArray() };
    const first = firstPose(entrance, area);
    const { width, height } = this.viewport.size;
    const aside = Math.atan((Math.tan((WALK_FOV * Math.PI) / 360) * width) / height);
    this.#walk.start(turnedToSight(first, (place) => this.#isSeenIndoors(first.eye, place), aside), area);
    this.cutWalls();
    void this.#learnFloor();
  }

  /** Asks what may be walked on; one stands still until that is known. */
  async #learnFloor(): Promise<void> {
    const signal = this.#pending.next();
    const [house, scene] = [this.#house, this.#scene];
    if (!house || !scene) return;
    this.#walk.walkOn("awaited");
    try {
      const floors = await this.askFloor(scene, signal);
      this.#walk.walkOn(new WalkFloor(scene, floors, house.plan, (id) => house.doors.open.includes(id)));
    } catch (reason) {
      if (isAbort(reason)) return;
      this.#walk.walkOn(null);
      this.onFailure(reason);
    }
  }

  #leaveFor(preset: PresetName, jump: boolean): void {
    const walked = this.#walk.pose !== null;
    this.#pending.stop();
    this.#walk.stop();
    this.viewport.look(preset, jump);
    if (walked) this.cutWalls();
  }

  /** Whether it is known what one may walk on. */
  get knowsFloor(): boolean {
    return this.#walk.knowsFloor;
  }

  /** How high the walls are drawn [m]: all of them to who walks. */
  get height(): number {
    const whole = this.#house?.wallTop ?? Number(this.#cut.max);
    return this.#walk.pose ? whole : this.rise + Number(this.#cut.value);
  }

  /** How the walls are drawn: those before the viewer lower, unless one walks or wants them whole. */
  get cut(): WallCut {
    this.#before = this.#sidesBefore();
    return { height: this.height, before: sidesOf(this.#before) };
  }

  /** The sides whose walls are lower. */
  get lowered(): readonly Side[] {
    return [...sidesOf(this.#before)];
  }

  #sidesBefore(): number {
    return this.#walk.pose || !this.#lowers.checked ? 0 : sidesBefore(this.viewport.seenFrom);
  }

  /** Lowers other walls once the view has turned. */
  #followView(): void {
    if (this.#house && this.#sidesBefore() !== this.#before) this.cutWalls();
  }

  cutWalls(): void {
    this.#cutWords();
    this.#house?.cutAt(this.cut);
    this.labels.raiseTo(this.height);
    this.viewport.castShadows();
  }

  /** Lights the house as at an hour, which is remembered. */
  #lightUp(hour: string | null): void {
    if (hour !== null) {
      this.#hour.value = hour; // held within its ends
      remember("hour", this.#hour.value);
      this.viewport.daylight.turnTo(Number(this.#hour.value));
      this.viewport.host.style.setProperty("--dusk", `${Math.round(this.viewport.daylight.lamps * 100)}%`);
      lightLamps(this.#house?.lamps ?? [], this.viewport.daylight.lamps);
      this.viewport.castShadows();
    }
    const minutes = Math.round(Number(this.#hour.value) * 60);
    element("hour_words").textContent = `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, "0")}`;
  }

  #cutWords(): void {
    element("cut_words").textContent = `${sayNumber(Number(this.#cut.value), 1)} m`;
  }

  #nameAll(): void {
    this.labels.nameAll(this.#names.checked, this.#things.checked);
  }

  #tellNamed(named: { shown: number; of: number } | null): void {
    const words = named && named.shown < named.of ? say("{shown} of {of} fit", named) : "";
    const told = element("labels_words");
    if (told.textContent !== words) told.textContent = words;
  }
}
