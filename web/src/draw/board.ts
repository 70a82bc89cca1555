/** The board on which a plan is drawn: sheet, tools, inspector and the service's verdict on each step, over the canvas. */
import type { Catalog, FixAnswer, FixRequest, GenerateAnswer, Issue, Room, Scene, ValidateAnswer } from "../contract";
import { Live } from "../edit/live";
import { Toolbar, type Tool } from "../edit/toolbar";
import { doorlessIn } from "../panel/imported";
import { inWords } from "../panel/programme";
import { pressing } from "../panel/shortcuts";
import { button, made } from "../made";
import { boxOf, type Box, type Point } from "./corners";
import { EMPTY, openingMoved, roomMoved, withoutOpening, withoutRoom, type Draft, type DraftRoom } from "./draft";
import { DrawnPlan } from "./drawn_plan";
import { group, hint, lengthField, row } from "./elements";
import { draftNames, Inspector } from "./inspector";
import { leftOutWords, lostWords } from "./lost";
import { isOpening, Pencil, type ToolName } from "./pencil";
import { PictureBeneath } from "./picture_beneath";
import { Reflow } from "./reflow";
import { UNTYPED, atOrigin, clearAreas, draftOf, sceneOf } from "./scene_draft";
import { Sheet } from "./sheet";
import { FINE, GRID } from "./snapping";
import { say, type Words } from "../words/language";
import { tellSentence } from "../words/telling";

/** A room that is not drawn with the pointer [mm]. */
const NEW_ROOM = { width: 4000, depth: 3000 } as const;
const UNSAID_COLOR = "#cfd6de";
const MISSING = "missing_required";
const UNREACHABLE = "unreachable";

export interface BoardCalls {
  catalog(): Promise<Catalog>;
  validate(scene: Scene, signal: AbortSignal): Promise<ValidateAnswer>;
  fix(request: FixRequest, signal: AbortSignal): Promise<FixAnswer>;
  furnish(scene: Scene, rooms: readonly string[], signal: AbortSignal): Promise<GenerateAnswer>;
}

/** Tells the plan as it now is, once its reshaped rooms are arranged. */
export type Drawn = () => Promise<Scene>;

export interface BoardWords {
  /** The plan, once it can be told, is to be furnished: all its rooms that stand empty. */
  furnish(drawn: Drawn): void;
  /** The drawn home is to be shown as it is. */
  show(drawn: Drawn): void;
  /** Says what failed of a step, and how that is asked again. */
  failed(reason: unknown, again?: () => void): void;
  closed(): void;
}

export class Board {
  readonly #plan = new DrawnPlan(EMPTY);
  readonly #sheet: Sheet;
  readonly #pencil: Pencil;
  readonly #inspector: Inspector;
  readonly #toolbar: Toolbar;
  readonly #picture = new PictureBeneath();
  readonly #reflow: Reflow;
  readonly #verdicts: Live<Scene, ValidateAnswer>;
  readonly #said = made("p", { className: "drawing-said", role: "status" });
  readonly #found = made("div");
  #catalog: Catalog | null = null;
  #ghost: Box | null = null;
  #issues: readonly Issue[] = [];
  #isJudged = true;
  #furnished: ReadonlyMap<string, Room> = new Map();
  /** The plan as the last step left it: what the next one is compared to. */
  #before: Draft = EMPTY;
  /** The plan of the home that the board was opened on. */
  #opened: Draft = EMPTY;
  /** The plan that was asked to be shown or furnished. */
  #told: Draft | null = null;

  constructor(readonly host: HTMLElement, readonly calls: BoardCalls, readonly words: BoardWords) {
    const tools = made("div", { className: "tools drawing-tools", role: "toolbar", "aria-label": say("Drawing tools") });
    const inspected = made("div");
    host.replaceChildren(tools, made("div", { className: "drawing-side" }, inspected, this.#found), this.#said);
    this.#sheet = new Sheet(host);
    this.#inspector = new Inspector(inspected, this.#plan, (words) => this.#say(words));
    this.#toolbar = new Toolbar(tools, this.#tools());
    this.#pencil = new Pencil(this.#sheet, this.#plan, {
      ghost: (box) => { this.#ghost = box; this.#draw(); },
      measured: (points, isDone) => this.#measured(points, isDone),
      said: (words) => this.#say(words),
    });
    this.#reflow = new Reflow(calls, {
      seen: (rooms) => { this.#furnished = rooms; this.#draw(); },
      settled: (of, becomes) => {
        if (this.#plan.settled !== of) return;
        const said = this.#said.textContent;
        this.#plan.amend(becomes);
        this.#say(`${said} ${leftOutWords(of, becomes)}`.trim()); // what went with the wall is still gone
      },
    });
    this.#verdicts = new Live({
      ask: (scene, signal) => calls.validate(scene, signal),
      answered: ({ issues }) => { if (!this.#verdicts.waits) this.#judged(issues); },
      failed: (reason) => {
        this.#judged([], false);
        words.failed(reason, () => this.#changed("plan"));
      },
    });
    this.#plan.onChange = (what) => this.#changed(what);
    document.addEventListener("keydown", (event) => this.#key(event), { capture: true });
    window.addEventListener("beforeunload", (event) => { if (this.isOpen && this.#plan.canUndo) event.preventDefault(); });
  }

  get isOpen(): boolean {
    return !this.host.hidden;
  }

  /** Opens the board: on a home, or on an empty sheet. */
  open(scene: Scene | null): void {
    this.host.hidden = false;
    this.#opened = this.#before = scene ? draftOf(scene) : EMPTY;
    this.#plan.open(this.#before);
    this.#learn().catch((reason: unknown) => this.words.failed(reason));
    this.#use(scene ? "choose" : "room");
    if (this.#plan.canUndo) this.#say(say("Undo brings back what was drawn before."));
    this.#fit();
    this.#redraw();
    this.#sheet.svg.focus();
  }

  /** Closes the board on what is shown now, and tells what was left out of it; null: that is no longer what is drawn. */
  finish(): string | null {
    if (this.isOpen && this.#plan.settled !== this.#told) {
      this.#say(say("The plan has changed since: press it again for the plan as it now is."));
      return null;
    }
    const stay = new Set(this.#plan.settled.rooms.map(({ id }) => id));
    const left = leftOutWords({ ...this.#opened, rooms: this.#opened.rooms.filter(({ id }) => stay.has(id)) }, this.#plan.settled);
    this.#plan.finish();
    this.close();
    return left;
  }

  close(): void {
    this.#pencil.cancel();
    this.#verdicts.stop();
    this.host.hidden = true;
    this.words.closed();
  }

  /** Steps that are made meanwhile are waited for, too. */
  readonly #arranged: Drawn = async () => {
    while (this.#told !== this.#plan.settled) {
      const draft = this.#plan.settled;
      await this.#reflow.step(draft);
      if (draft === this.#plan.settled) this.#told = draft;
    }
    return atOrigin(this.scene);
  };

  async #learn(): Promise<void> {
    this.#catalog ??= await this.calls.catalog();
    this.#inspector.types = this.#catalog.rooms ?? {};
    this.#redraw();
  }

  /** The drawn home as a scene. */
  get scene(): Scene {
    return sceneOf(this.#plan.settled);
  }

  #tools(): Tool[] {
    const use = (name: ToolName, words: Words, sign: Words, keys: string): Tool => ({ name, words, sign, keys, act: () => this.#use(name) });
    return [
      use("choose", "Choose and move", "Choose", "V"), use("room", "Draw a room", "Room", "B"),
      use("add", "Add area to the chosen room", "Add area", "U"), use("cut", "Cut area from the chosen room", "Cut area", "X"),
      use("door", "Door", "Door", "D"), use("window", "Window", "Window", "W"), use("passage", "Passage without a leaf", "Passage", "P"), use("garage_door", "Door of a garage", "Garage", "G"),
      { name: "new", words: "4 × 3 m room", sign: "4 × 3 m", keys: "N", act: () => this.#addRoom() },
      { name: "undo", words: "Undo", sign: "↶", keys: "Control+Z", act: () => this.#plan.undo() },
      { name: "redo", words: "Redo", sign: "↷", keys: "Control+Shift+Z Control+Y", act: () => this.#plan.redo() },
      { name: "fit", words: "Fit all in view", sign: "Fit", keys: "F", act: () => this.#fit() },
      { name: "furnish", words: "Furnish the rooms that stand empty", sign: "Furnish", act: () => this.words.furnish(this.#arranged) },
      { name: "show", words: "Show in 3D as it is", sign: "Show", act: () => this.words.show(this.#arranged) },
      { name: "close", words: "Close the drawing", sign: "✕", act: () => this.close() },
    ];
  }

  #use(tool: ToolName): void {
    this.#pencil.cancel();
    this.#pencil.tool = tool;
    for (const name of ["choose", "room", "add", "cut", "door", "window", "passage", "garage_door"] as const) this.#toolbar.press(name, name === tool);
    this.#sheet.svg.dataset.tool = tool;
    const isTold = isOpening(tool) && !matchMedia("(pointer: coarse)").matches; // fingers have no keys, and less of the sheet
    this.#say(isTold ? say("Click a wall. Or choose a room: an arrow key puts it into the wall on that side.") : "");
  }

  #say(words: string): void {
    this.#said.textContent = words;
  }

  #changed(what: "plan" | "moment" | "chosen"): void {
    if (what === "moment") this.#reflow.moment(this.#plan.draft);
    if (what === "plan") {
      this.#furnished = new Map();
      this.#say(lostWords(this.#before, this.#plan.settled));
      this.#reflow.step(this.#plan.settled).catch((reason: unknown) => this.words.failed(reason, () => this.#changed("plan")));
      this.#before = this.#plan.settled;
      this.#found.ariaBusy = "true";
      this.#isJudged = false;
      if (this.#plan.settled.rooms.length > 0) this.#verdicts.want(this.scene);
      else this.#judged([]);
    }
    if (what === "moment") this.#draw();
    else this.#redraw();
  }

  #judged(issues: readonly Issue[], isJudged = true): void {
    this.#found.ariaBusy = "false";
    this.#isJudged = isJudged;
    const isToBeFurnished = new Set(this.#plan.settled.rooms.filter(({ from }) => (from?.furniture.length ?? 0) === 0).map(({ id }) => id));
    const isClosed = new Set(this.scene.rooms.filter(({ openings }) => openings.every(({ kind }) => kind === "window")).map(({ id }) => id));
    this.#issues = issues.filter((issue) => !(issue.rule === MISSING && isToBeFurnished.has(issue.room ?? "")))
      .map((issue) => (issue.rule === UNREACHABLE && isClosed.has(issue.room ?? "") ? { ...issue, severity: "warning" } : issue)); // its door comes next
    this.#redraw();
  }

  #redraw(): void {
    const isPlan = this.#plan.settled.rooms.length > 0;
    this.#toolbar.enable("undo", this.#plan.canUndo);
    this.#toolbar.enable("redo", this.#plan.canRedo);
    for (const name of ["furnish", "show"]) this.#toolbar.enable(name, isPlan);
    this.#inspector.show([this.#beneath()], clearAreas(this.#plan.draft));
    const { scene } = this;
    const found = [
      ...this.#issues.map(({ message, room, severity }) => ({ words: tellSentence(message, scene), room, severity })),
      ...doorlessIn(scene).filter(({ room }) => room === null || !this.#issues.some((issue) => issue.rule === UNREACHABLE && issue.room === room)).map((one) => ({ ...one, severity: "warning" })),
    ];
    const none = this.#isJudged ? say("Nothing is wrong with the plan") : say("Not judged yet");
    const head = found.length === 0 ? (isPlan ? none : say("Nothing is drawn yet")) : say("{count} to look at", { count: found.length });
    this.#found.replaceChildren(group(head, ...found.map(({ words, room, severity }) => button(words, () => this.#plan.choose({ room: room ?? null }), { className: `issue issue-${severity}` }))));
    this.#draw();
  }

  #draw(): void {
    const names = draftNames(this.#plan.draft);
    const wrong = new Set(this.#issues.filter(({ severity }) => severity === "error").map(({ room }) => room ?? ""));
    this.#sheet.draw(this.#plan.draft, {
      ...this.#plan.chosen, ghost: this.#ghost, wrong, measured: this.#picture.measured, picture: this.#picture.picture, furnished: this.#furnished,
      names: ({ id }) => inWords(names.get(id) ?? id), areas: clearAreas(this.#plan.draft), colors: (room) => this.#color(room),
    });
  }

  #color({ type }: DraftRoom): string {
    return this.#catalog?.rooms?.[type ?? UNTYPED]?.accent ?? UNSAID_COLOR;
  }

  /** The picture beneath: laid, faded, scaled, removed. */
  #beneath(): HTMLElement {
    const chooser = made("input", { type: "file", accept: "image/*", "aria-label": say("A picture to trace") });
    chooser.addEventListener("change", () => void this.lay(chooser.files?.[0]));
    if (!this.#picture.picture) return group(say("Picture beneath"), chooser, hint(say("A scan or photograph of a plan, to draw over.")));
    const fade = made("input", { type: "range", min: "0.1", max: "1", step: "0.05", value: String(this.#picture.picture.opacity), "aria-label": say("How strongly the picture is seen") });
    fade.addEventListener("input", () => { this.#picture.fade(fade.valueAsNumber); this.#draw(); });
    const isMeasured = this.#picture.measured.length === 2;
    const scale = lengthField(isMeasured ? say("That is, m") : say("Its width, m"), this.#picture.length, (length) => {
      const isSet = this.#picture.setScale(length);
      if (isSet && isMeasured) this.#use(this.#plan.settled.rooms.length > 0 ? "choose" : "room"); // what one does next
      if (isSet) this.#fit(); // it has become another size
      this.#redraw();
      if (isSet && isMeasured) this.#sheet.svg.focus();
      return isSet;
    });
    scale.classList.add("picture-length");
    return group(say("Picture beneath"), fade, row(button(say("Measure a known length"), () => { this.#use("measure"); this.#say(say("Click the two ends of a length that you know.")); })),
      scale, row(button(say("Remove the picture"), () => { this.#picture.remove(); this.#redraw(); })));
  }

  /** A length of the picture is measured: once it is, its field waits for what it is. */
  #measured(points: readonly Point[], isDone: boolean): void {
    this.#picture.measured = points;
    this.#redraw();
    if (!isDone || points.length < 2) return;
    this.#say(say("Type how long that is."));
    const field = this.host.querySelector<HTMLInputElement>(".picture-length input");
    field?.focus();
    field?.select();
  }

  /** Lays a picture beneath the plan. */
  async lay(file: File | undefined): Promise<void> {
    if (!file) return;
    try {
      await this.#picture.lay(file);
      this.#say(say("The picture lies beneath. Measure a length that you know, then draw the rooms over it."));
      if (this.#plan.draft.rooms.length === 0) this.#fit();
    } catch (reason) {
      this.#say((reason as Error).message);
    }
    this.#redraw();
  }

  #fit(): void {
    this.#sheet.fit(this.#plan.draft, this.#picture.picture);
  }

  /** A room beside the chosen one, or east of all. */
  #addRoom(): void {
    const { draft, chosen } = this.#plan;
    const beside = draft.rooms.find(({ id }) => id === chosen.room);
    const boxes = draft.rooms.map(({ corners }) => boxOf(corners));
    const all = { x: Math.max(0, ...boxes.map(({ x1 }) => x1)), z: Math.min(...boxes.map(({ z0 }) => z0), Number.POSITIVE_INFINITY) };
    const at = (x: number, z: number): Box => ({ x0: x, z0: z, x1: x + NEW_ROOM.width, z1: z + NEW_ROOM.depth });
    const count = draft.rooms.length;
    if (beside) this.#pencil.draw(at(boxOf(beside.corners).x1, boxOf(beside.corners).z0), "room");
    if (this.#plan.draft.rooms.length === count) this.#pencil.draw(at(all.x, Number.isFinite(all.z) ? all.z : 0), "room");
    const made = this.#plan.draft.rooms[count];
    if (made && (count === 0 || !this.#sheet.holds(made.corners))) this.#fit();
  }

  #key(event: KeyboardEvent): void {
    if (!this.isOpen || document.querySelector("dialog[open]")) return;
    const target = event.target instanceof Element ? event.target : null;
    const isTyping = target?.matches("input, select, textarea") === true;
    if (isTyping || event.altKey || event.key === "?") return;
    const act = pressing(event, this.host) ?? (event.ctrlKey || event.metaKey ? null : this.#act(event));
    event.stopPropagation();
    if (!act) return;
    event.preventDefault();
    act();
  }

  #act(event: KeyboardEvent): (() => void) | null {
    const keys: Readonly<Record<string, () => void>> = {
      Delete: () => this.#remove(), Backspace: () => this.#remove(), Escape: () => this.#escape(),
      ArrowUp: () => this.#arrow(0, -1, event), ArrowDown: () => this.#arrow(0, 1, event), ArrowLeft: () => this.#arrow(-1, 0, event), ArrowRight: () => this.#arrow(1, 0, event),
    };
    return keys[event.key] ?? null;
  }

  #escape(): void {
    if (this.#pencil.isBusy) this.#pencil.cancel();
    else if (this.#pencil.tool !== "choose") this.#use("choose");
    else this.#plan.choose({});
  }

  #remove(): void {
    const { room, opening } = this.#plan.chosen;
    if (room !== null) this.#plan.step(withoutRoom(this.#plan.settled, room));
    if (opening !== null) this.#plan.step(withoutOpening(this.#plan.settled, opening));
  }

  /** Puts the opening in hand into a wall of the chosen room; else moves what is chosen. */
  #arrow(across: number, along: number, event: KeyboardEvent): void {
    const room = this.#plan.settled.rooms.find(({ id }) => id === this.#plan.chosen.room);
    const { tool } = this.#pencil;
    if (!isOpening(tool) || this.#plan.chosen.opening !== null) return this.#nudge(across, along, event);
    this.#sheet.svg.focus(); // where arrows go on moving what was put
    if (room) this.#inspector.put(tool, room, { axis: across === 0 ? "x" : "z", inward: across + along > 0 ? -1 : 1 });
    else this.#say(say("Choose a room first."));
  }

  /** Moves what is chosen by a step of the grid. */
  #nudge(across: number, along: number, { shiftKey }: KeyboardEvent): void {
    const step = shiftKey ? FINE : GRID;
    const { room, opening } = this.#plan.chosen;
    const draft = this.#plan.settled;
    const one = draft.openings.find(({ id }) => id === opening);
    if (one) {
      const middle = (one.from + one.to) / 2;
      const at: Point = one.axis === "x" ? { x: middle + across * step, z: one.line } : { x: one.line, z: middle + along * step };
      this.#move(openingMoved(draft, one.id, at, GRID), say("It would leave its wall, or meet another opening."));
    } else if (room !== null) this.#move(roomMoved(draft, room, across * step, along * step), say("There it would meet another room."));
  }

  #move(draft: Draft | null, refusal: string): void {
    if (draft) this.#plan.step(draft);
    else this.#say(refusal);
  }
}
