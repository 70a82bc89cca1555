/** The page, wired together: a request goes to the service, its answer to the canvas, the text and the status bar. */
import { anotherSeed, queryFromRequest, requestFromQuery } from "./address";
import type { HouseRequest, Scene } from "./contract";
import { Controls } from "./panel/controls";
import { Diagnose } from "./panel/diagnose";
import { Issues } from "./panel/issues";
import { Notice } from "./panel/notice";
import { Reading } from "./panel/reading";
import { countsOf, showStatus } from "./panel/status";
import { catalog, generate, isAbort, ServiceProblem, view } from "./service";
import { Stage } from "./stage";
import { Home, type Showing } from "./state/home";

type History = "push" | "keep";

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) throw new Error(`The page lacks #${id}`);
  return found as T;
}

class Page {
  readonly #controls = new Controls(element<HTMLFormElement>("request"));
  readonly #reading = new Reading(element("yaml"));
  readonly #issues = new Issues(element("issues"), element("issue_list"));
  readonly #notice = new Notice(element("notice"), () => this.#ask(this.#wanted, "keep"));
  readonly #stage = new Stage(element("stage"));
  #wanted: HouseRequest = requestFromQuery(location.search);
  readonly #home = new Home();
  readonly #diagnose = new Diagnose(this.#home);
  #pending = new AbortController();
  #written = new AbortController();
  #reads: Promise<void> = Promise.resolve();
  /** Without the catalog a house is shown all the same, its bodies as boxes. */
  readonly #dressed = catalog(new AbortController().signal).then((known) => this.#stage.dress(known)).catch(() => undefined);

  constructor() {
    this.#controls.onGenerate = (request) => this.#ask(request, "push");
    this.#reading.onChoose = (id) => this.#home.select(id);
    this.#reading.onFlag = (id) => this.#home.toggleFlag(id);
    this.#issues.onChoose = (id) => this.#goTo(id);
    this.#issues.onChooseRoom = (id) => this.#home.selectRoom(id);
    this.#diagnose.onChoose = (id) => this.#goTo(id);
    this.#home.on("flagged", (ids) => this.#reading.flag(ids));
    this.#stage.onSelect = (id) => this.#home.select(id);
    this.#home.on("shown", (how) => this.#show(how));
    this.#home.on("selected", (id) => this.#select(id));
    element("random").addEventListener("click", () => this.#random());
    window.addEventListener("popstate", () => this.#openAddress());
    document.addEventListener("keydown", (event) => this.#key(event));
  }

  /** Opens the house that the address holds. */
  open(): void {
    globalThis.compose = this.#stage;
    this.#openAddress();
  }

  #openAddress(): void {
    const request = requestFromQuery(location.search);
    this.#controls.show(request);
    void this.#ask(request, "keep");
  }

  #random(): void {
    const request = { ...this.#controls.read(), seed: anotherSeed(this.#wanted.seed) };
    this.#controls.show(request);
    void this.#ask(request, "push");
  }

  #key(event: KeyboardEvent): void {
    const typing = event.target instanceof HTMLInputElement && event.target.type === "number";
    if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
    const acts: Readonly<Record<string, () => void>> = {
      r: () => this.#random(),
      d: () => this.#diagnose.open(),
      f: () => this.#reading.flagSelected(),
      2: () => this.#stage.look("top"),
      3: () => this.#stage.look("corner"),
      Escape: () => this.#home.select(null),
    };
    acts[event.key.length === 1 ? event.key.toLowerCase() : event.key]?.();
  }

  #remember(request: HouseRequest, history: History): void {
    this.#wanted = request;
    const query = queryFromRequest(request);
    if (query === location.search) return;
    if (history === "push") window.history.pushState(null, "", query);
    else window.history.replaceState(null, "", query);
  }

  /** Asks for a house; a newer question withdraws an older one. */
  async #ask(request: HouseRequest, history: History): Promise<void> {
    this.#pending.abort();
    const { signal } = (this.#pending = new AbortController());
    this.#remember(request, history);
    this.#busy(true);
    try {
      const { scene, issues, timing_ms: timing } = await generate(request, signal);
      await this.#dressed;
      this.#home.select(null);
      this.#home.show({ scene, issues, conflicts: [], timing }, "new");
      await this.#reads;
      this.#controls.showProblems([]);
      this.#notice.hide();
    } catch (reason) {
      if (isAbort(reason)) return;
      this.#controls.showProblems(reason instanceof ServiceProblem ? reason.fields : []);
      this.#notice.show(reason);
    }
    this.#busy(false);
  }

  /** Shows the home as it now is; the moments of an edit are the stage's and the text waits for the end. */
  #show(how: Showing): void {
    const shown = this.#home.shown;
    if (!shown || how === "live") return;
    this.#stage.show(shown.scene, shown.issues);
    this.#stage.select(this.#home.selected);
    this.#issues.show(shown.issues);
    showStatus(element("status"), countsOf(shown.scene, shown.issues), shown.timing);
    document.title = `Compose: house ${shown.scene.seed}`;
    this.#reads = this.#read(shown.scene);
  }

  /** Asks for the readable YAML; a newer scene withdraws an older one's. */
  async #read(scene: Scene): Promise<void> {
    this.#written.abort();
    const { signal } = (this.#written = new AbortController());
    try {
      this.#reading.show(await view(scene, signal));
      this.#reading.select(this.#home.selected);
    } catch (reason) {
      if (!isAbort(reason)) this.#notice.show(reason);
    }
  }

  #busy(busy: boolean): void {
    element("progress").hidden = !busy;
    element("stage").setAttribute("aria-busy", String(busy));
  }

  /** Selects a body and brings it into the middle. */
  #goTo(id: string): void {
    this.#home.select(id);
    this.#stage.centre(id);
  }

  #select(id: string | null): void {
    this.#stage.select(id);
    this.#reading.select(id);
  }
}

declare global {
  /** What is shown, for tests and the curious; nothing of the page reads it. */
  var compose: Pick<Stage, "state" | "whereIs" | "measure">;
}

new Page().open();
