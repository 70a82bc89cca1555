/** Editing wired to the canvas, the keys and the panels. */
import type { Beside } from "../asking";
import type { Catalog, OtherWay, Scene } from "../contract";
import { CoreThread } from "../core/core_thread";
import { LocalDrag } from "../core/local_drag";
import { bodiesOf, isOver, type PlacedBody } from "../house/frame";
import type { House } from "../house/house";
import { catalog, coreUrl, drag, explain, fix, floor, restyle, ServiceProblem } from "../service";
import type { Stage } from "../stage";
import { timed } from "../timing";
import type { Home, Showing } from "../state/home";
import { Acts } from "./acts";
import { Adding } from "./adding";
import { ConflictPanel } from "./conflict_panel";
import { Editor, type Refusal } from "./editor";
import { FloorZones } from "./floor";
import { Hand, type Grasp, type Point } from "./hand";
import { stoodSo } from "./many_edits";
import { Numbers, type InHand } from "./numbers";
import { carriedBy, companionsOf, keptCompanions, without } from "./scene_edits";
import { Slide, spotOf } from "./slide";
import { ThingDrag } from "./thing_drag";
import { Toolbar, type Tool } from "./toolbar";
import { WhyPanel } from "./why_panel";
import { isTyped } from "../panel/typing";
import { element } from "../element";
import { say } from "../words/language";

/** How far an arrow key moves a piece, and with Shift [m]. */
const STEP = 0.05;
const SMALL_STEP = 0.01;
const QUARTER = Math.PI / 2;
/** Where arrows go from line to line, or change what is typed or chosen. */
const ARROWED = ".yaml, input:not([type=checkbox]), select, textarea";

const GIVEN_UP = new ServiceProblem("The last change was not made", "It found no answer before the next home was shown. The home that was left is as it was before the change.");

export interface WorkbenchWords {
  busy(busy: boolean): void;
  failed(reason: unknown, again?: () => void, outcome?: string): void;
  readonly beside: Beside;
}

export class Workbench {
  readonly editor: Editor;
  readonly #hand: Hand;
  readonly #slide = new Slide((id, spot) => this.stage.house?.place(id, spot));
  readonly #conflicts = new ConflictPanel(element("conflict"));
  readonly #toolbar: Toolbar;
  readonly #floor: FloorZones;
  readonly #why: WhyPanel;
  readonly #acts: Acts;
  readonly #numbers: Numbers;
  readonly #thing: ThingDrag;
  readonly #adding: Adding;
  readonly #floorSwitch = element("show_floor") as HTMLInputElement;
  /** The house last drawn: from its places bodies slide to those of the next. */
  #drawn: House | null = null;
  #sliding = false;
  #refused: Refusal | null = null;
  /** The piece in hand, where it is wished. */
  #wished: InHand | null = null;
  #core: CoreThread | null = null;
  /** Who goes along with the piece in hand, as far as the service leaves them to it. */
  #along: ReadonlySet<string> = new Set();

  constructor(readonly home: Home, readonly stage: Stage, readonly words: WorkbenchWords) {
    this.editor = new Editor(home, fix, {
      busy: (busy) => {
        words.busy(busy);
        this.#offer(); // what is under way can be taken back
      },
      failed: (reason, again) => words.failed(reason, again, say("The home is as it was before the change.")),
      givenUp: () => words.failed(GIVEN_UP),
      refused: (refusal) => this.#refuse(refusal),
      lifted: (id, scene) => this.#carry(id, scene),
      answered: (id, scene) => this.#frameGoal(id, scene),
      settled: () => this.#settled(),
    }, (scene, id) => this.#frames(scene, id));
    this.#acts = new Acts(home, this.editor, async (scene, signal) => (await restyle(scene, { decorate: true }, signal)).scene);
    this.#thing = new ThingDrag(home, stage, this.#acts);
    const hosts = { gaps: element("gaps"), piece: element("piece") as HTMLDetailsElement, tape: element("tape") };
    this.#numbers = new Numbers(home, stage, this.editor, this.#acts, hosts);
    this.#adding = new Adding(home, stage, this.editor, { palette: element("palette"), places: element("places") }, {
      room: () => this.#roomChosen(),
      inView: () => this.#roomInView(),
      failed: (reason, again) => words.failed(reason, again),
    });
    this.#floor = new FloorZones(stage, floor, (reason) => { if (this.#floorSwitch.checked) words.failed(reason, () => this.#showFloor()); }); // for a drag nobody asked for it
    this.#why = new WhyPanel(element("why"), explain);
    this.#why.onChoose = (id) => home.select(id);
    this.#why.onShow = (answer) => {
      this.#numbers.explain(answer);
      if (answer) this.stage.uncover(answer.id, this.#why.host);
      this.#previewWay(null);
    };
    this.#why.onClose = () => this.stage.viewport.back();
    this.#why.onPreview = (way) => this.#previewWay(way);
    this.#why.onTake = (way, room) => { if (home.selected !== null) this.#acts.stand(home.selected, way, room); };
    this.#floorSwitch.addEventListener("change", () => this.#showFloor());
    this.#toolbar = new Toolbar(element("tools"), this.#tools());
    this.#hand = this.#grasping();
    this.#conflicts.onTake = (refusal, repair) => this.editor.take(refusal, repair);
    home.on("shown", (how) => this.#shown(how));
    stage.onRedrawn = () => this.#shown("live");
    home.on("beyond", () => this.#offer());
    home.on("selected", (id) => { this.#why.hide(); this.#offer(); this.#measure(); this.#numbers.chosen(id); });
    home.on("also", () => { this.#offer(); this.#measure(); });
    document.addEventListener("keydown", (event) => this.#key(event));
    this.#offer();
  }

  /** Learns what the service knows of kinds. */
  learn(known: Catalog): void {
    this.#numbers.learn(known);
  }

  #grasping(): Hand {
    return new Hand(this.stage.viewport.canvas, {
      grasp: (x, y) => this.#graspAt(x, y),
      rayAt: (x, y) => this.stage.viewport.rayAt(x, y),
      hold: (held) => this.stage.viewport.hold(held),
      lift: (id) => this.#lift(id),
      drag: (at, isFree) => this.#drag(at, isFree),
      drop: () => (this.#thing.dragged === null ? this.editor.drop() : this.#thing.drop()),
      cancel: () => (this.#thing.dragged === null ? this.editor.cancel() : this.#thing.cancel()),
    });
  }

  #drag(at: Point, isFree: boolean): void {
    const id = this.editor.dragged;
    if (id === null) this.#thing.drag(at, this.#under(at));
    else timed("drag followed", () => this.editor.drag(this.#numbers.brought(id, at, isFree)));
  }

  /** The piece of furniture over a place of the house, the highest. */
  #under({ x, z }: Point): string | null {
    const over = (this.stage.house?.bodies ?? []).filter((body) => body.kind === "furniture" && isOver(body, x, z));
    return over.sort((a, b) => b.y + b.height - a.y - a.height)[0]?.id ?? null;
  }

  /** Who answers the frames of a drag in the page; null where the service has to. */
  async #frames(scene: Scene, id: string): Promise<LocalDrag | null> {
    this.#core ??= new CoreThread(coreUrl());
    return LocalDrag.of(this.#core, await drag(scene, id), scene, id);
  }

  /** Takes a piece in hand, and shows the floor it may go to: as if it were not there. */
  #lift(id: string): void {
    if (!this.home.find(id)) {
      this.#thing.lift(id);
      return;
    }
    const others = this.home.chosen.includes(id) ? this.home.chosen.filter((one) => one !== id) : [];
    const room = this.home.find(id)?.room.id;
    const { scene } = this.home;
    if (!this.editor.lift(id, others)) return;
    this.#along = scene ? companionsOf(scene, id) : new Set();
    this.home.choose([id, ...others]);
    for (const other of scene ? others : []) this.#along = new Set([...this.#along, ...carriedBy(scene as Scene, other), ...companionsOf(scene as Scene, other)]);
    if (scene && room !== undefined) void this.#floor.show(without(scene, id), [room]);
  }

  #settled(): void {
    this.stage.house?.frame("settles", []);
    if (this.#floorSwitch.checked) this.#showFloor();
    else this.#floor.hide();
  }

  /** The floor of all rooms, where that is wished for. */
  #showFloor(): void {
    const { scene } = this.home;
    if (this.#floorSwitch.checked && scene) void this.#floor.show(scene, []);
    else this.#floor.hide();
  }

  #graspAt(x: number, y: number): Grasp | null {
    if (this.stage.viewport.state.walking) return null;
    const hit = this.stage.house?.hit(this.stage.viewport.rayAt(x, y));
    const held = hit?.kind === "body" ? this.#carrierOf(hit.body) : null;
    if (!held || this.editor.busy || this.home.locked.has(held.id)) return null;
    return { id: held.id, at: { x: held.x, z: held.z }, height: held.y + held.height / 2, isChosen: this.home.chosen.includes(held.id) };
  }

  /** The piece of furniture that a body is, or lies on. */
  #carrierOf(body: PlacedBody): PlacedBody | null {
    if (body.kind === "furniture") return body;
    if (body.kind === "decoration" && body.id === this.home.selected) return body;
    const room = this.home.scene?.rooms.find((one) => one.decorations.some((piece) => piece.id === body.id));
    if (body.kind !== "decoration" || body.hung !== undefined || !room || !this.home.scene) return null;
    const scene = this.home.scene;
    const carrier = room.furniture.find((piece) => carriedBy(scene, piece.id).has(body.id));
    return this.stage.house?.bodies.find((one) => one.id === carrier?.id) ?? null;
  }

  /** Shows what is in hand where it is wished, at once. */
  #carry(id: string, scene: Scene): void {
    const carried = this.#inHand(scene, id);
    const wished = scene.rooms.flatMap((room) => room.furniture.map((piece) => ({ piece, room: room.id }))).find(({ piece }) => piece.id === id);
    this.#wished = wished ?? null;
    this.#measure();
    for (const body of bodiesOf(scene)) if (carried.has(body.id)) this.stage.house?.place(body.id, spotOf(body));
    this.stage.viewport.castShadows();
  }

  /** What is drawn where the hand has it. */
  #inHand(scene: Scene, id: string): ReadonlySet<string> {
    return new Set([...carriedBy(scene, id), ...this.#along]);
  }

  #frameGoal(id: string, scene: Scene): void {
    const before = this.home.settled;
    if (before) this.#along = keptCompanions(before.scene, scene, id);
    this.stage.house?.frame("settles", bodiesOf(scene).filter((body) => body.id === id));
    this.stage.viewport.invalidate();
  }

  #shown(how: Showing): void {
    const [before, house] = [this.#drawn, this.stage.house];
    this.#drawn = house;
    this.#why.hide(); // it spoke of where things stood before
    if (how === "new") {
      this.editor.forget();
      this.#hand.cancel();
    }
    this.#measure();
    if (!house || !this.home.scene) return;
    house.mark("locked", [...this.home.locked]);
    if (how === "step" && this.#refused) this.#refuse(null); // it spoke of a home that is no longer shown
    this.#offer();
    if (how !== "live" && this.#floorSwitch.checked) this.#showFloor();
    else this.#floor.draw(this.home.scene);
    if (how !== "new") this.#slideFrom(before?.bodies ?? house.bodies, house, this.home.scene);
  }

  /** Lets every body that is not in hand slide to where the scene has it. */
  #slideFrom(seen: readonly PlacedBody[], house: House, scene: Scene): void {
    const dragged = this.editor.dragged;
    const carried = dragged === null ? new Set<string>() : this.#inHand(scene, dragged);
    const belongs = bodiesOf(scene).filter((body) => !carried.has(body.id));
    if (seen !== house.bodies) for (const body of seen) house.place(body.id, spotOf(body));
    if (!this.#slide.to(house.bodies, belongs) || this.#sliding) return;
    this.#sliding = true;
    this.stage.viewport.glide((seconds) => {
      this.#sliding = this.#slide.step(seconds);
      this.stage.viewport.castShadows();
      return this.#sliding;
    });
  }

  #refuse(refusal: Refusal | null): void {
    this.#refused = refusal;
    this.#conflicts.show(refusal);
    this.stage.house?.mark("conflict", refusal?.conflicts.flatMap(({ ids }) => ids) ?? []);
    this.stage.viewport.invalidate();
  }

  #tools(): Tool[] {
    const onPiece = (act: (id: string) => void) => () => { if (this.home.selected !== null) act(this.home.selected); };
    const acts = this.#acts;
    return [
      { name: "menu", words: "Menu", sign: "☰", act: () => undefined }, // panel/menu.ts opens it
      { name: "undo", words: "Undo", sign: "↶", keys: "Control+Z", act: () => this.editor.undo() },
      { name: "redo", words: "Redo", sign: "↷", keys: "Control+Shift+Z Control+Y", act: () => this.editor.redo() },
      { name: "left", words: "Turn left", sign: "⟲", keys: "Q", act: () => acts.turn(90) },
      { name: "right", words: "Turn right", sign: "⟳", keys: "E", act: () => acts.turn(-90) },
      { name: "lock", words: "Lock", sign: "Lock", keys: "K", act: onPiece((id) => this.editor.toggleLock(id)) },
      { name: "delete", words: "Delete", sign: "Delete", keys: "Delete Backspace", act: () => acts.remove() },
      { name: "duplicate", words: "Duplicate beside", sign: "Duplicate", keys: "Control+D", act: () => acts.duplicate() },
      { name: "several", words: "Choose several", sign: "Several", act: () => this.#chooseSeveral(!this.stage.adds) },
      { name: "copy", words: "Copy, to be pasted", sign: "Copy", keys: "Control+C", act: () => this.#copy() },
      { name: "paste", words: "Paste into the chosen room", sign: "Paste", keys: "Control+V", act: () => this.#acts.paste(this.#roomMeant()) },
      { name: "tape", words: "Tape measure", sign: "Tape", keys: "M", act: () => this.#measureWithTape() },
      { name: "why", words: "Why here?", sign: "Why?", keys: "H", act: () => this.#explain() },
      { name: "add", words: "Add a piece", sign: "+ Add", keys: "A", act: () => this.#openPalette() },
    ];
  }

  /** Says how far the chosen piece is from what is around it. */
  #measure(): void {
    const dragged = this.editor.dragged;
    this.#numbers.show(dragged === null ? null : this.#wished);
  }

  #openPalette(): void {
    this.#adding.toggle(() => catalog());
  }

  #measureWithTape(isOut = !this.#numbers.tape.isOut): void {
    this.#numbers.tape.toggle(isOut);
    this.#toolbar.press("tape", isOut);
  }

  /** What is clicked or tapped joins what is chosen, or takes its place again. */
  #chooseSeveral(adds: boolean): void {
    this.stage.adds = adds;
    this.#toolbar.press("several", adds);
  }

  #copy(): void {
    this.#acts.copy();
    this.#offer();
  }

  /** Offers what can be done now. */
  #offer(): void {
    const found = this.home.find(this.home.selected);
    const isLocked = found?.piece.locked === true;
    this.#toolbar.enable("undo", this.home.canUndo || this.editor.busy);
    this.#toolbar.enable("redo", this.home.canRedo);
    for (const name of ["left", "right", "delete"]) this.#toolbar.enable(name, this.#acts.canChange);
    if (this.home.selected === null) this.#chooseSeveral(false);
    for (const name of ["duplicate", "copy", "several"]) this.#toolbar.enable(name, this.home.selected !== null);
    this.#toolbar.enable("paste", this.#acts.canPaste);
    for (const name of ["lock", "why"]) this.#toolbar.enable(name, found !== null);
    this.#toolbar.press("lock", isLocked);
  }

  /** Frames where all would stand in another way. */
  #previewWay(way: OtherWay | null): void {
    const { scene } = this.home;
    const ids = new Set(way?.moves.map(({ id }) => id));
    const framed = way && scene ? bodiesOf(stoodSo(scene, way.moves, way.left_out)).filter(({ id }) => ids.has(id)) : [];
    this.stage.house?.frame("settles", framed);
    this.stage.viewport.invalidate();
  }

  /** Says why the chosen piece stands where it does. */
  #explain(): void {
    void this.words.beside(say("Finding out why"), async () => {
      const [scene, id] = [this.home.scene, this.home.selected];
      if (scene && id !== null && this.home.find(id)) await this.#why.show(scene, id);
    });
  }

  /** The room that is chosen, or that of what is chosen. */
  #roomChosen(): string | undefined {
    const { room, selected } = this.home;
    return room ?? this.home.find(selected)?.room.id ?? this.#acts.thing(selected)?.room.id;
  }

  /** That, or the one in view. */
  #roomMeant(): string | undefined {
    return this.#roomChosen() ?? this.#roomInView() ?? this.home.scene?.rooms[0]?.id;
  }

  /** The room in the middle of the view. */
  #roomInView(): string | undefined {
    const { left, top, width, height } = this.stage.viewport.canvas.getBoundingClientRect();
    const hit = this.stage.house?.hit(this.stage.viewport.rayAt(left + width / 2, top + height / 2));
    if (hit?.kind === "room") return hit.room.id;
    return hit?.kind === "body" ? this.home.find(this.#carrierOf(hit.body)?.id ?? null)?.room.id : undefined;
  }

  #key(event: KeyboardEvent): void {
    if (event.defaultPrevented || isTyped(event)) return;
    const act = event.key === "Escape" ? (event.repeat ? null : this.#escape()) : this.#arrowKey(event, event.target instanceof Element ? event.target : null);
    if (!act) return;
    event.preventDefault();
    act();
  }

  /** What Escape ends: the first that is under way. */
  #escape(): (() => void) | null {
    if (this.editor.dragged !== null) return () => { this.#hand.cancel(); this.editor.cancel(); };
    if (this.#thing.dragged !== null) return () => this.#hand.cancel();
    if (this.#numbers.cancel() || this.#adding.hide()) return () => undefined;
    if (this.#numbers.tape.isOut) return () => this.#measureWithTape(false);
    if (this.#refused) return () => this.#refuse(null);
    return this.#why.host.hidden ? null : () => this.#why.close();
  }

  /** An arrow moves the piece in hand the way it points on the screen; in the text arrows go from line to line. */
  #arrowKey(event: KeyboardEvent, target: Element | null): (() => void) | null {
    const ways: Readonly<Record<string, number>> = { ArrowUp: 0, ArrowLeft: 1, ArrowDown: 2, ArrowRight: 3 };
    const [way, id] = [ways[event.key], this.home.selected];
    if (way === undefined || id === null || target?.closest(ARROWED)) return null;
    const quarters = way + Math.round(this.stage.viewport.heading / QUARTER);
    const step = event.shiftKey ? SMALL_STEP : STEP;
    return () => this.#acts.nudge(-Math.round(Math.sin(quarters * QUARTER)) * step, -Math.round(Math.cos(quarters * QUARTER)) * step);
  }
}
