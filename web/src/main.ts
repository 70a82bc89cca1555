/** The page, wired together: a request goes to the service, its answer to the canvas, the text and the status bar. */
import { anotherSeed, FIRST, queryFromRequest, requestFromQuery, unreadIn } from "./address";
import { Asking } from "./asking";
import type { HouseRequest, Scene } from "./contract";
import { drawable } from "./house/drawable";
import type { Drawn } from "./draw/board";
import { Drawing } from "./draw/drawing";
import { OtherRooms } from "./edit/others";
import { Remaking } from "./edit/remaking";
import { Workbench } from "./edit/workbench";
import { carriedIn, carriedTo, linkTo } from "./memory/carrying";
import { Entries, entry } from "./memory/entries";
import { Keeping } from "./memory/keeping";
import type { LeftHome } from "./memory/kept_homes";
import { Newest } from "./newest";
import { Controls } from "./panel/controls";
import { Diagnose } from "./panel/diagnose";
import { Files } from "./panel/files";
import { ImportReport, offeringUnits } from "./panel/imported";
import { Issues } from "./panel/issues";
import { Keys } from "./panel/keys";
import { Legend } from "./panel/legend";
import { Link } from "./panel/link";
import { Menu } from "./panel/menu";
import { Notice } from "./panel/notice";
import { foldForNarrow } from "./panel/narrow";
import { Progress } from "./panel/progress";
import { Reading } from "./panel/reading";
import { RoomPanel } from "./panel/room";
import { ShortfallPanel } from "./panel/shortfalls";
import { showShown } from "./panel/status";
import { PlanFiles } from "./plan/plan_files";
import { catalog, furnish, generate, isAbort, readFile, report, reroll, ServiceProblem, view, type GivenFile } from "./service";
import { listenToSkips } from "./panel/skips";
import { listenToPreferences } from "./panel/preferences";
import { listenToShortcuts } from "./panel/shortcuts";
import { isTyped } from "./panel/typing";
import { Tour } from "./panel/tour";
import { readSaved, type SavedHead } from "./saved/saved_calls";
import { SavedPanel } from "./saved/saved_panel";
import { Stage } from "./stage";
import { Home, type Showing, type Shown } from "./state/home";
import { CARD_LOST } from "./view/renderer";
import { say, speak } from "./words/language";
import { element } from "./element";

type History = "push" | "keep";

const FORKED = new ServiceProblem("This home is kept as one of its own from here on", "Another window has opened it, or has forgotten it: what each changes is its own.");

/** How long the next home waits for the edits of the one before. */
const LONGEST_EDIT_MS = 10_000;

class Page {
  readonly #home = new Home();
  readonly #controls = new Controls(element<HTMLFormElement>("request"));
  readonly #reading = new Reading(element("yaml"));
  readonly #issues = new Issues(element("issues"), element("issue_list"));
  readonly #shortfalls = new ShortfallPanel(element("shortfalls"), element("shortfall_list"), element("shortfall_line"));
  readonly #rooms = new RoomPanel(element("room"), this.#home);
  readonly #legend = new Legend(element("legend_marks"), element("legend_rooms"));
  readonly #asking = new Asking(element("notice"), new Progress(element("progress"), element("stage")));
  readonly #files = new Files(element("files"), element("drop"), async () => (await this.#landed())?.scene ?? null, this.#asking.beside);
  readonly #link = new Link(element("copy_link"), element("said"), element("save_instead"), this.#asking.beside, () => this.#findLink());
  readonly #stage = new Stage(element("stage"));
  readonly #diagnose = new Diagnose(this.#home, (change, withdrawn) => this.#workbench.editor.wish("repair", change, withdrawn));
  readonly #others = new OtherRooms(element("others"), {
    ask: (scene, room, seed, signal) => reroll(scene, [room], signal, seed),
    portray: (scene, into) => this.#stage.portrayRoom(scene, into),
    take: (answer, before) => this.#remaking.take(answer, before),
    failed: (reason, again) => this.#failed(reason, again),
  });
  readonly #imported = new ImportReport(element("imported"), element("imported_list"));
  readonly #drawing: Drawing;
  readonly #entries = new Entries();
  readonly #keeping: Keeping;
  readonly #saved: SavedPanel;
  readonly #workbench: Workbench;
  readonly #remaking = new Remaking(this.#home, this.#asking, {
    editor: () => this.#workbench.editor,
    read: () => this.#reads,
    furnished: (made, of) => this.#imported.guessed(made, of),
  });
  #wanted: HouseRequest = requestFromQuery(location.search);
  #learnt = false;
  readonly #written = new Newest();
  #reads: Promise<void> = Promise.resolve();

  constructor() {
    this.#keeping = new Keeping(this.#home, this.#stage.viewport, element("recent")); // the first to hear what is shown
    this.#keeping.onLead = (id) => this.#openKept(id, "push", (kept) => this.#keeping.homes.follow(kept));
    this.#keeping.onOpen = (id) => this.#openKept(id, "push");
    this.#saved = new SavedPanel(element<HTMLDetailsElement>("saved"), {
      shown: () => this.#landed(),
      picture: async () => this.#keeping.homes.current && this.#keeping.store.picture(this.#keeping.homes.current),
    }, this.#asking.beside);
    this.#saved.onOpen = (id) => this.#openSaved(id);
    this.#home.on("shown", (how) => { if (how === "new") this.#saved.holds(null); });
    this.#saved.onFailure = this.#failed;
    this.#controls.onRestyle = (wish) => this.#remaking.restyle(wish);
    this.#controls.onGenerate = (request) => this.#ask(request, "push");
    this.#controls.onBegin = (request) => this.#submit(request);
    this.#reading.onChoose = (id, adds) => this.#chooseInText(id, adds);
    this.#reading.onFlag = (id) => this.#home.toggleFlag(id);
    this.#issues.onChoose = this.#diagnose.onChoose = (id) => this.#goTo(id);
    this.#issues.onChooseRoom = this.#diagnose.onChooseRoom = (id) => this.#home.selectRoom(id);
    this.#home.on("flagged", (ids) => this.#reading.flag(ids));
    this.#stage.onFailure = (reason, again) => { if (again) this.#asking.missed(reason, again); else this.#failed(reason); };
    const { canvas } = this.#stage.viewport;
    canvas.addEventListener("webglcontextlost", () => this.#asking.notice.show(CARD_LOST, () => location.reload(), { what: CARD_LOST }));
    canvas.addEventListener("webglcontextrestored", () => this.#asking.notice.takeBack(CARD_LOST));
    new PlanFiles(() => this.#stage.planned(this.#home.settled?.scene ?? null), this.#asking.beside);
    element("picture").addEventListener("click", () => void this.#stage.savePicture());
    this.#stage.onSelect = (id) => this.#home.select(id);
    this.#stage.onAlso = (id) => this.#home.toggleChosen(id);
    this.#stage.onRoom = (id) => this.#home.selectRoom(id);
    this.#rooms.onReroll = (id) => this.#remaking.reroll(id);
    this.#rooms.onOthers = (id) => { if (this.#home.settled) void this.#others.show(this.#home.settled.scene, id); };
    this.#home.on("shown", () => this.#others.hide());
    this.#files.onOpen = (file) => this.#openFile(file, "push");
    this.#files.onPicture = (file) => void this.#drawing.openPicture(file);
    this.#files.onFailure = this.#failed;
    this.#asking.notice.inWords = (problem) => this.#controls.inWords(problem.fields);
    this.#shortfalls.onChooseRoom = (id) => this.#home.selectRoom(id);
    this.#asking.onEnd = (reason) => this.#controls.showProblems(reason instanceof ServiceProblem ? reason.fields : []);
    this.#home.on("shown", (how) => this.#show(how));
    this.#home.on("selected", (id) => this.#select(id));
    this.#home.on("also", (also) => this.#stage.select(this.#home.selected, also));
    this.#workbench = new Workbench(this.#home, this.#stage, {
      busy: (busy) => {
        if (busy) this.#others.hide(); // they are of the home before the edit
        this.#asking.progress.turn(say("Trying the change"), busy);
      },
      beside: this.#asking.beside,
      failed: this.#failed,
    });
    new Menu(element("tools"), element("said"));
    new Keys();
    new Tour(element("tour"), element("tour_again"), (greet) => this.#home.on("shown", greet));
    this.#drawing = new Drawing(element("drawing"), [element("stage"), element("beside"), element("reading")], [element("progress"), element("notice")], this.#asking.beside, this.#failed);
    this.#asking.onBegin = () => this.#drawing.close();
    this.#drawing.onFurnish = (drawn) => this.#showDrawn(drawn, true);
    this.#drawing.onShow = (drawn) => this.#showDrawn(drawn, false);
    for (const id of ["furnish_now", "furnish_empty"]) element(id).addEventListener("click", () => this.#remaking.furnish());
    element("draw_new").addEventListener("click", () => void this.#drawing.open(null));
    element("draw_this").addEventListener("click", () => void this.#drawing.open(this.#home.settled?.scene ?? null));
    element("random").addEventListener("click", () => this.#random());
    element("decorate_now").addEventListener("click", () => this.#remaking.restyle({ decorate: true }));
    element("reset").addEventListener("click", () => this.#submit(FIRST));
    window.addEventListener("popstate", () => this.#openAddress());
    window.addEventListener("beforeunload", (event) => { if (this.#workbench.editor.busy) event.preventDefault(); }); // it would be lost
    document.addEventListener("keydown", (event) => this.#escape(event));
  }

  /** Opens the house that the address holds. */
  open(): void {
    globalThis.compose = this.#stage;
    listenToPreferences();
    foldForNarrow();
    listenToSkips();
    listenToShortcuts();
    this.#openAddress();
    void this.#stage.rehearse();
  }

  /** The home shown, once the edits that are under way are in it. */
  async #landed(): Promise<Shown | null> {
    await this.#workbench.editor.landed;
    return this.#home.settled;
  }

  /** Waits for the edits of the home that is left, unless they find no answer. */
  async #left(): Promise<void> {
    await Promise.race([this.#landed(), new Promise((resolve) => { setTimeout(resolve, LONGEST_EDIT_MS); })]);
  }

  /** Opens what the page of history holds: a home as it was left, a file's scene, else the address' request. */
  #openAddress(): void {
    const { home } = entry();
    if (home !== undefined) this.#openKept(home, "keep");
    else this.#openRequest();
  }

  #openRequest(): void {
    const { file } = entry();
    const saved = new URLSearchParams(location.search).get("home");
    const request = requestFromQuery(location.search);
    if (!file && saved !== null) return this.#openSaved(saved);
    if (!file) this.#controls.show(request);
    if (file) this.#openFile(file, "keep");
    else void this.#ask(request, "keep", carriedIn(location.hash), Object.keys(unreadIn(location.search)));
  }

  /** Shows a home that the browser keeps, as it was left; where it does not, what the address asks for. */
  #openKept(id: string, history: History, open = (kept: LeftHome): void => this.#keeping.homes.open(kept)): void {
    void this.#asking.run(say("Opening the home"), async (signal) => {
      const [kept] = await Promise.all([this.#keeping.homes.read(id), this.#learn(signal), this.#left()]);
      if (signal.aborted) return;
      this.#entries.expect(history === "push");
      this.#home.select(null);
      if (kept) open(kept);
      else this.#openRequest();
      await this.#reads;
    });
  }

  /** Says what went wrong, until it is tried again. */
  readonly #failed = (reason: unknown, again: (() => void) | null = null, outcome: string | null = null): void => {
    this.#asking.notice.show(reason, again, { outcome });
  };

  #random(): void {
    this.#submit({ ...this.#controls.readForAnother(), seed: anotherSeed(this.#wanted.seed) });
  }

  /** Asks for a house and shows in the form what is asked. */
  #submit(request: HouseRequest): void {
    this.#controls.show(request);
    void this.#ask(request, "push");
  }

  #escape(event: KeyboardEvent): void {
    if (event.defaultPrevented || event.repeat || isTyped(event)) return;
    if (event.key === "Escape" && !this.#others.hide()) this.#home.select(null);
  }

  /** Asks for a house, and shows it with the changes that a link carried; what its address says beside is told. */
  #ask(request: HouseRequest, history: History, carried: string | null = null, unread: readonly string[] = []): Promise<void> {
    this.#wanted = request;
    return this.#asking.run(say("Laying out the house"), async (signal) => {
      const [{ scene, issues, timing_ms: timing }] = await Promise.all([generate(request, signal), this.#learn(signal), this.#left()]);
      if (signal.aborted) return;
      this.#entries.expect(history === "push");
      this.#home.select(null);
      this.#home.show({ scene, issues, conflicts: [], timing, made: request, file: null }, "new");
      if (carried !== null) await this.#change(scene, carried, signal);
      if (unread.length > 0 && !this.#asking.notice.isShown) this.#asking.notice.show(new ServiceProblem("Part of the address is not known", say("{words}: the home is shown without.", { words: unread.map((word) => `'${word}'`).join(", ") })));
      await this.#reads;
    });
  }

  /** Shows the changes that a link carried, as a step of their own; the service reads them as it reads a file. */
  async #change(made: Scene, carried: string, signal: AbortSignal): Promise<void> {
    try {
      const content = JSON.stringify(await carriedTo(carried, made));
      const { scene, issues } = await readFile({ name: say("The link"), content }, signal);
      this.#home.show({ scene, issues, conflicts: [], timing: 0 }, "step");
    } catch (reason) {
      if (isAbort(reason)) throw reason;
      this.#asking.notice.show(reason);
    }
  }

  /** The link to the home shown, with what was changed in it. */
  #findLink(): ReturnType<typeof linkTo> {
    const { shown, isEdited } = this.#home;
    if (!shown?.made) return Promise.reject(new Error("no request makes a file's scene"));
    return linkTo(shown, shown.made, isEdited, location.href.replace(/#.*/, ""), generate);
  }

  /** Asks once for what the service knows; without it a house is shown all the same, its bodies as boxes. */
  async #learn(signal: AbortSignal): Promise<void> {
    if (this.#learnt) return;
    try {
      const known = await catalog(signal);
      this.#learnt = true;
      this.#stage.learnCatalog(known);
      this.#workbench.learn(known);
      this.#controls.offer(known);
    } catch (reason) {
      if (isAbort(reason)) throw reason;
    }
  }

  #openFile(file: GivenFile, history: History): void {
    void this.#asking.run(say("Reading {file}", { file: file.name }), (signal) => this.#openGiven(file, history, signal).catch((reason: unknown) => {
      throw offeringUnits(reason, (asked) => this.#openFile({ ...file, ...asked }, history));
    }));
  }

  /** Opens a home that the service keeps: what is changed of it may be saved as its next version. */
  #openSaved(id: string): void {
    void this.#asking.run(say("Opening the home"), async (signal) => {
      const { head, scene } = await readSaved(id, signal);
      await this.#openGiven({ name: head.name, content: JSON.stringify(scene) }, "push", signal, head);
    });
  }

  async #openGiven(file: GivenFile, history: History, signal: AbortSignal, saved: SavedHead | null = null): Promise<void> {
    const [read] = await Promise.all([readFile(file, signal), this.#learn(signal), this.#left()]);
    if (signal.aborted) return;
    this.#entries.expect(history === "push", file);
    this.#home.select(null);
    this.#home.show({ scene: read.scene, issues: read.issues, conflicts: [], timing: 0, made: null, file: file.name }, "new");
    this.#saved.holds(saved);
    this.#imported.show(read, file, (asked) => this.#openFile({ ...file, ...asked }, "push"));
    await this.#reads;
  }

  /** Shows a home that was drawn, as a step from what was shown before; its empty rooms furnished first, if that is wished. */
  #showDrawn(tell: Drawn, isToBeFurnished: boolean): void {
    void this.#asking.run(isToBeFurnished ? say("Furnishing the plan") : say("Looking at the plan"), async (signal) => {
      const drawn = await tell();
      const made = isToBeFurnished ? await furnish(drawn, [], signal) : { ...(await report(drawn, [], signal)), scene: drawn, timing_ms: 0, guesses: [], entrance: null };
      const left = this.#drawing.finish();
      if (left === null) return;
      this.#home.show({ scene: made.scene, issues: made.issues, conflicts: [], timing: made.timing_ms, made: null, file: null }, "step");
      this.#imported.show(null);
      this.#imported.guessed(made, drawn, left);
      await this.#reads;
    }, "drawn");
  }

  /** Shows where the home comes from: in the address, the form, the title, and what a link can hold. */
  #tellOrigin({ made = null, file = null, scene }: Shown, how: Showing): void {
    const query = made && queryFromRequest(made);
    this.#entries.show(this.#keeping.homes.current, query, this.#keeping.store.lasts);
    this.#link.opens(query);
    this.#link.edited(this.#home.isEdited);
    document.title = made && file === null ? say("Compose: house {seed}", { seed: scene.seed }) : say("Compose: {file}", { file: file ?? say("a plan of your own") });
    if (made && how === "new") this.#controls.show((this.#wanted = made));
    else this.#controls.showFurnishing(made ?? { style: scene.request?.style ?? undefined, decorate: scene.request?.decorate === true }, made !== null);
  }

  /** Shows the home as it now is; the moments of an edit are the stage's and the text waits for the end. */
  #show(how: Showing): void {
    const shown = this.#home.shown;
    if (!shown || how === "live") return;
    this.#asking.notice.hide();
    if (this.#keeping.homes.isFork) this.#failed(FORKED);
    this.#stage.show(shown.scene, shown.issues);
    this.#stage.select(this.#home.selected, this.#home.also);
    if (how === "new") this.#imported.show(null);
    element<HTMLButtonElement>("furnish_now").disabled = shown.scene.rooms.every(({ furniture }) => furniture.length > 0);
    element<HTMLButtonElement>("decorate_now").disabled = shown.scene.rooms.every(({ furniture, decorations }) => furniture.length === 0 || decorations.length > 0);
    this.#issues.show(shown.issues, shown.scene);
    this.#shortfalls.show(shown.scene);
    this.#legend.show(drawable(shown.scene));
    showShown(element("status"), shown);
    this.#tellOrigin(shown, how);
    this.#reads = this.#read(shown.scene);
  }

  /** Asks for the readable YAML; a newer scene withdraws an older one's. */
  async #read(scene: Scene): Promise<void> {
    const signal = this.#written.next();
    try {
      this.#reading.show(await view(scene, signal));
      this.#reading.select(this.#home.selected);
    } catch (reason) {
      if (!isAbort(reason)) this.#asking.missed(reason, () => { if (!signal.aborted) this.#reads = this.#read(scene); });
    }
  }

  /** What is chosen already is gone to: in the text arrows go from line to line, in the house they move the piece. */
  #chooseInText(id: string, adds: boolean): void {
    if (adds || this.#stage.adds) return this.#home.toggleChosen(id);
    if (this.#home.selected === id) element("stage").focus();
    this.#home.select(id);
  }

  #select(id: string | null): void {
    this.#stage.select(id, this.#home.also);
    this.#reading.select(id);
  }

  /** Selects a body and brings it into the middle. */
  #goTo(id: string): void {
    this.#home.select(id);
    this.#stage.centre(id);
  }
}

declare global {
  /** What is shown, for tests and the curious; nothing of the page reads it. */
  var compose: Pick<Stage, "state" | "whereIs" | "whereAt" | "measure" | "rebuild" | "scene" | "places">;
}

speak();
try {
  new Page().open();
} catch (reason) {
  element("progress").hidden = true; // nothing comes any more
  new Notice(element("notice"), () => undefined).show(reason);
  if (!(reason instanceof ServiceProblem)) throw reason;
}
