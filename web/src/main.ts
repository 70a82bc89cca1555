/** The page, wired together: a request goes to the service, its answer to the canvas, the text and the status bar. */
import { anotherSeed, queryFromRequest, requestFromQuery } from "./address";
import type { GenerateAnswer, HouseRequest } from "./contract";
import { Controls } from "./panel/controls";
import { Issues } from "./panel/issues";
import { Notice } from "./panel/notice";
import { Reading } from "./panel/reading";
import { countsOf, showStatus } from "./panel/status";
import { generate, isAbort, ServiceProblem, view } from "./service";
import { Stage } from "./stage";

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
  #pending = new AbortController();

  constructor() {
    this.#controls.onGenerate = (request) => this.#ask(request, "push");
    this.#reading.onChoose = (id) => this.#select(id);
    this.#issues.onChoose = (id) => this.#select(id);
    this.#stage.onSelect = (id) => this.#select(id);
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
      2: () => this.#stage.look("top"),
      3: () => this.#stage.look("corner"),
      Escape: () => this.#select(null),
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
      await this.#show(await generate(request, signal), signal);
      this.#controls.showProblems([]);
      this.#notice.hide();
    } catch (reason) {
      if (isAbort(reason)) return;
      this.#controls.showProblems(reason instanceof ServiceProblem ? reason.fields : []);
      this.#notice.show(reason);
    }
    this.#busy(false);
  }

  async #show(answer: GenerateAnswer, signal: AbortSignal): Promise<void> {
    const reading = await view(answer.scene, signal);
    this.#stage.show(answer.scene, answer.issues);
    this.#reading.show(reading);
    this.#issues.show(answer.issues);
    showStatus(element("status"), countsOf(answer.scene, answer.issues), answer.timing_ms);
    document.title = `Compose: house ${answer.scene.seed}`;
  }

  #busy(busy: boolean): void {
    element("progress").hidden = !busy;
    element("stage").setAttribute("aria-busy", String(busy));
  }

  #select(id: string | null): void {
    this.#stage.select(id);
    this.#reading.select(id);
  }
}

declare global {
  /** What is shown, for tests and the curious; nothing of the page reads it. */
  var compose: Pick<Stage, "state" | "whereIs">;
}

new Page().open();
