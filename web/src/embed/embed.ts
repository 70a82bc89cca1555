/** A home in a frame of somebody else's page: looked at and walked through, never changed, and nothing of it is kept. */
import { requestFromQuery, unreadIn } from "../address";
import type { Scene } from "../contract";
import { carriedTo } from "../memory/carrying";
import { Newest } from "../newest";
import { catalog, generate, readFile, ServiceProblem } from "../service";
import { Stage } from "../stage";
import { refusalWords } from "../panel/field_words";
import { say, sayDocument } from "../words/language";
import { framedIn, pageOf, VIEWS, type Framed } from "./embed_address";
import { element } from "../element";

/** As the service would say it, which has no views. */
const NO_VIEW = new ServiceProblem("A field is wrong", "", { fields: [{ field: "view", problem: "is not known", allowed: VIEWS.join(", ") }] });

function tell(reason: unknown): void {
  const { title, lines } = refusalWords(reason);
  element("embed_said").textContent = reason instanceof ServiceProblem ? [title, ...lines].join(". ") : say("The home cannot be shown here.");
}

class Frame {
  readonly #stage = new Stage(element("stage"));
  readonly #known = this.#learn();
  readonly #pending = new Newest();

  constructor() {
    globalThis.compose = this.#stage;
    this.#stage.onSelect = (id) => this.#stage.select(id);
    this.#stage.onFailure = (reason) => tell(reason);
    const { canvas } = this.#stage.viewport;
    const said = element("embed_said");
    let before = "";
    canvas.addEventListener("webglcontextlost", () => {
      before = said.textContent;
      said.textContent = say("The graphics card was taken away");
    });
    canvas.addEventListener("webglcontextrestored", () => { said.textContent = before; });
    window.addEventListener("hashchange", () => void this.open());
  }

  async #learn(): Promise<void> {
    // Without the catalog bodies are shown as boxes.
    await catalog().then((known) => this.#stage.learnCatalog(known), () => undefined);
  }

  /** Shows the home that the address asks for. */
  async open(): Promise<void> {
    const signal = this.#pending.next();
    const framed = framedIn(location.hash);
    element<HTMLAnchorElement>("whole").href = pageOf(framed);
    this.#stage.host.ariaBusy = "true";
    try {
      if (framed.view === null) throw NO_VIEW;
      const [{ scene, issues }] = await Promise.all([this.#made(framed, signal), this.#known]);
      if (signal.aborted) return;
      element("embed_said").textContent = "";
      delete this.#stage.host.dataset.refused;
      this.#stage.show(scene, issues);
      this.#stage.look(framed.view);
    } catch (reason) {
      if (signal.aborted) return;
      this.#stage.host.dataset.refused = "true"; // nothing is shown of the home before: it is not what was asked for
      tell(reason);
    } finally {
      if (!signal.aborted) this.#stage.host.ariaBusy = "false";
    }
  }

  async #made({ query, changes }: Framed, signal: AbortSignal) {
    const made = await generate({ ...requestFromQuery(query), ...unreadIn(query) }, signal); // what no request has, the service says
    if (changes === null) return made;
    const content = JSON.stringify(await carriedTo(changes, made.scene as Scene));
    return readFile({ name: say("The link"), content }, signal);
  }
}

sayDocument();
try {
  void new Frame().open();
} catch (reason) {
  tell(reason);
}
