/** The controls of the view: camera presets, walking, how high the walls are cut, all names. */
import type { House } from "../house/house";
import type { PresetName } from "./cameras";
import type { Labels } from "./labels";
import type { Viewport } from "./viewport";
import { firstPose } from "./walk";
import { WalkMode } from "./walk_mode";

function within<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

type Way = PresetName | "walk";

const BUTTONS: Readonly<Record<Way, string>> = { top: "camera_top", corner: "camera_corner", walk: "camera_walk" };

export class Looking {
  readonly #walk: WalkMode;
  readonly #cut = within<HTMLInputElement>("cut");
  readonly #names = within<HTMLInputElement>("all_labels");
  /** Over the canvas: on a narrow screen the other buttons are far below it. */
  readonly #leave = within<HTMLButtonElement>("walk_leave");
  #house: House | null = null;

  constructor(readonly viewport: Viewport, readonly labels: Labels) {
    this.#walk = new WalkMode(viewport);
    this.#walk.onLeave = () => this.look("corner");
    this.#cut.addEventListener("input", () => this.cutWalls());
    this.#names.addEventListener("change", () => this.#nameAll());
    for (const way of Object.keys(BUTTONS) as Way[]) within(BUTTONS[way]).addEventListener("click", () => this.look(way));
    this.#leave.addEventListener("click", () => this.look("corner"));
    labels.onNamed = (named) => this.#tellNamed(named);
    this.#cutWords();
  }

  /** Another house: `jump` looks at it anew, else one looks on from where one was. */
  show(house: House, jump: boolean): void {
    this.#house = house;
    this.labels.raiseTo(this.height);
    if (this.#walk.pose && jump) this.#enter();
    else if (jump) this.look("corner", true);
  }

  /** Walks to a place of the plan [m]; tells whether one walks at all. */
  goTo(x: number, z: number): boolean {
    if (this.#walk.pose) this.#walk.goTo([x, z]);
    return this.#walk.pose !== null;
  }

  look(way: Way, jump = false): void {
    if (way === "walk") this.#enter();
    else this.#leaveFor(way, jump);
    for (const [name, id] of Object.entries(BUTTONS)) within(id).setAttribute("aria-pressed", String(name === way));
    within("walk_hint").hidden = way !== "walk";
    this.#offerLeaving(this.#walk.pose !== null);
  }

  #offerLeaving(walks: boolean): void {
    if (!walks && document.activeElement === this.#leave) this.viewport.host.focus({ preventScroll: true });
    this.#leave.hidden = !walks;
  }

  #enter(): void {
    if (!this.#house) return;
    const { entrance, bounds } = this.#house;
    const area = { min: bounds.min.toArray(), max: bounds.max.toArray() };
    this.#walk.start(firstPose(entrance, area), area);
    this.cutWalls();
  }

  #leaveFor(preset: PresetName, jump: boolean): void {
    const walked = this.#walk.pose !== null;
    this.#walk.stop();
    this.viewport.look(preset, jump);
    if (walked) this.cutWalls();
  }

  /** How high the walls are drawn [m]: all of them to who walks. */
  get height(): number {
    const whole = this.#house?.wallTop ?? Number(this.#cut.max);
    return this.#walk.pose ? whole : Number(this.#cut.value);
  }

  cutWalls(): void {
    this.#cutWords();
    this.#house?.cutAt(this.height);
    this.labels.raiseTo(this.height);
    this.viewport.castShadows();
  }

  #cutWords(): void {
    within("cut_words").textContent = `${Number(this.#cut.value).toFixed(1)} m`;
  }

  toggleNames(): void {
    this.#names.checked = !this.#names.checked;
    this.#nameAll();
  }

  #nameAll(): void {
    this.labels.nameAll(this.#names.checked);
  }

  #tellNamed(named: { shown: number; of: number } | null): void {
    const words = named && named.shown < named.of ? `${named.shown} of ${named.of} fit` : "";
    const told = within("labels_words");
    if (told.textContent !== words) told.textContent = words;
  }
}
