/** Keeping wired to the page: every step, a picture of each home, the list of them, and a warning where nothing can be kept. */
import type { Home } from "../state/home";
import { Recent } from "../panel/recent";
import { KeptHomes } from "./kept_homes";
import { PictureClock, pictureOf } from "./pictures";
import { Store } from "./store";

/** What draws, as far as pictures need. */
export interface Drawn {
  readonly canvas: HTMLCanvasElement;
  onFrame(listener: () => void): void;
}

export class Keeping {
  /** Called with the id of the home that undo or redo leads to. */
  onLead: (id: string) => void = () => undefined;
  /** Called with the id of a home that was chosen. */
  onOpen: (id: string) => void = () => undefined;
  readonly store = new Store();
  readonly homes: KeptHomes;
  readonly #recent: Recent;
  readonly #clock = new PictureClock();

  constructor(readonly home: Home, drawn: Drawn, host: HTMLDetailsElement) {
    const tabs = typeof BroadcastChannel === "undefined" ? null : new BroadcastChannel("compose.homes");
    this.homes = new KeptHomes(home, this.store, tabs);
    this.homes.onLead = (id) => this.onLead(id);
    this.homes.onChange = () => this.#recent.changed();
    this.#recent = new Recent(host, {
      heads: () => this.store.heads(), picture: (id) => this.store.picture(id), current: () => this.homes.current,
    });
    this.#recent.onOpen = (id) => { if (id !== this.homes.current) this.onOpen(id); };
    this.#recent.onForget = (ids) => void this.homes.forget(ids);
    this.store.onLost = () => this.#warn();
    home.on("shown", (how) => { if (how !== "live") this.#clock.changed(); });
    drawn.onFrame(() => this.#picture(drawn.canvas));
  }

  /** Takes a picture of a frame that has just been drawn. */
  #picture(canvas: HTMLCanvasElement): void {
    const home = this.homes.current;
    if (!this.#clock.isDue(home, performance.now())) return;
    const picture = pictureOf(canvas);
    if (picture) void this.store.keepPicture(home, picture).then(() => this.#recent.changed());
  }

  #isWarned = false;

  /** Edits that would be lost are not left without a word. */
  #warn(): void {
    this.#recent.sayLost();
    if (this.#isWarned) return;
    this.#isWarned = true;
    window.addEventListener("beforeunload", (event) => { if (this.home.isEdited) event.preventDefault(); });
  }
}
