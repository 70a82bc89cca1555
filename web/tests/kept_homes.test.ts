import { IDBFactory } from "fake-indexeddb";
import { beforeAll, describe, expect, it, vi } from "vitest";
import * as fake from "fake-indexeddb";
import type { HouseRequest, Scene } from "../src/contract";
import { aligned, changedPiece, clipped, pasted, shifted, transferred } from "../src/edit/many_edits";
import { KeptHomes, keptStep, stepsOf, type LeftHome } from "../src/memory/kept_homes";
import { Store } from "../src/memory/store";
import { Home, type Shown } from "../src/state/home";
import { drawing } from "./random_requests";
import { piece, room, scene } from "./rooms";
import { times } from "./sweeps";

beforeAll(() => { vi.stubGlobal("IDBKeyRange", fake.IDBKeyRange); });

type Draw = () => number;
/** `make targets` draws all of them. */
const SEQUENCES = times(200, 10);
const LENGTH = 25;

function house(seed: number): Scene {
  const furniture = (id: string) => Array.from({ length: 12 }, (_, k) => piece(`${id}/${k}`, { x: k / 7 }));
  return scene(["den", "hall", "bath"].map((id, k) => room(id, [0, 4 * k, 6, 4], { furniture: furniture(id) })), { seed });
}

function made(seed: number, style?: string): Shown {
  const request: HouseRequest = { seed, ...(style ? { style } : {}) };
  return JSON.parse(JSON.stringify({ scene: { ...house(seed), style: style ?? null }, issues: [], conflicts: [], timing: { total: seed + 0.25 }, made: request, file: null })) as Shown;
}

const pick = <Of>(draw: Draw, from: readonly Of[]): Of => from[Math.floor(draw() * from.length)] as Of;

/** What a person does to several pieces at once, as the page wishes for it. */
function act(scene: Scene, draw: Draw): Scene {
  const all = scene.rooms.flatMap((one) => one.furniture.map(({ id }) => id));
  const some = all.filter(() => draw() < 0.1);
  const [first] = some;
  const room = pick(draw, scene.rooms).id;
  const acts: readonly (() => Scene)[] = [
    () => shifted(scene, some, Math.round(draw() * 1000) / 1000, 0.05),
    () => aligned(scene, some, pick(draw, ["west", "east", "north", "south", "across", "along"] as const)),
    () => pasted(scene, room, clipped(scene, some), 0.1, 0).scene,
    () => (first === undefined ? scene : transferred(scene, first, room)),
    () => (first === undefined ? scene : changedPiece(scene, first, { width: 1 + Math.round(draw() * 100) / 100, color: "#123456" })),
  ];
  return JSON.parse(JSON.stringify(pick(draw, acts)())) as Scene;
}

/** Some pieces moved, one gone or come, as an answer of the service would have it: all parsed anew. */
function edit(scene: Scene, draw: Draw): Scene {
  if (draw() < 0.4) return act(scene, draw);
  const rooms = scene.rooms.map((one) => ({
    ...one, furniture: one.furniture.filter(() => draw() > 0.03).map((body) => (draw() < 0.1 ? { ...body, x: Math.round(draw() * 4000) / 1000 } : body)),
  }));
  const first = rooms[0];
  if (first && draw() < 0.2) first.furniture.push(piece(`den/new_${Math.floor(draw() * 1e9)}`));
  return JSON.parse(JSON.stringify({ ...scene, rooms })) as Scene;
}

/** What the page ought to hold, told by texts alone. */
interface Ought { texts: string[]; at: number; from: string | null; ahead: { at: number; home: string } | null }

/** A browser window: its entries, and the page that is open in it. */
class Window {
  home = new Home();
  kept: KeptHomes;
  entries: (string | null)[] = [];
  entry = -1;
  readonly oughts = new Map<string, Ought>();
  led: Promise<void> = Promise.resolve();
  #clock = 0;

  constructor(readonly factory: IDBFactory, readonly draw: Draw) {
    this.kept = this.opened();
  }

  opened(): KeptHomes {
    const kept = new KeptHomes(this.home, new Store(this.factory), null, () => (this.#clock += 1));
    kept.onLead = (id) => { this.led = this.follow(id); };
    return kept;
  }

  get ought(): Ought {
    return this.oughts.get(this.kept.current ?? "") as Ought;
  }

  push(): void {
    this.entries = [...this.entries.slice(0, this.entry + 1), this.kept.current];
    this.entry += 1;
  }

  make(shown: Shown): void {
    const before = this.kept.current;
    this.home.show(shown, "new");
    if (this.kept.current === before) return;
    this.oughts.set(this.kept.current ?? "", { texts: [JSON.stringify(shown)], at: 0, from: before, ahead: null });
    this.push();
  }

  step(shown: Shown): void {
    const { ought } = this;
    const before = this.home.shown as Shown;
    this.home.show(shown, "step");
    if (JSON.stringify({ ...before, ...shown, timing: before.timing }) === JSON.stringify(before)) {
      expect(this.home.shown).toBe(before); // what changes nothing is no step
      return;
    }
    ought.texts = [...ought.texts.slice(0, ought.at + 1), JSON.stringify(this.home.shown)];
    expect(JSON.parse(ought.texts.at(-1) as string)).toEqual(JSON.parse(JSON.stringify({ made: null, file: null, ...this.home.shown, ...shown })));
    expect(JSON.stringify(this.home.scene)).toBe(JSON.stringify(shown.scene));
    ought.at += 1;
    ought.ahead = null;
  }

  async follow(id: string): Promise<void> {
    const kept = await this.kept.read(id);
    if (!kept) throw new Error(`${id} is lost`);
    this.kept.follow(kept);
    this.push();
  }

  async undo(): Promise<boolean> {
    const { ought, kept: { current } } = this;
    if (!this.home.canUndo) return false;
    this.home.undo();
    await this.led;
    if (ought.at > 0) ought.at -= 1;
    else this.ought.ahead = { at: this.ought.at, home: current as string };
    return true;
  }

  async redo(): Promise<void> {
    const { ought } = this;
    const isAhead = ought.ahead?.at === ought.at;
    expect(this.home.canRedo).toBe(isAhead || ought.at + 1 < ought.texts.length);
    this.home.redo();
    await this.led;
    if (isAhead) ought.ahead = null;
    else if (ought.at + 1 < ought.texts.length) ought.at += 1;
  }

  async open(id: string): Promise<void> {
    const kept = await this.kept.read(id);
    if (!kept) throw new Error(`${id} is lost`);
    this.kept.open(kept);
  }

  async travel(by: number): Promise<void> {
    const id = this.entries[this.entry + by];
    if (!id) return;
    this.entry += by;
    await this.open(id);
  }

  async reload(): Promise<void> {
    const before = this.kept.current as string;
    this.home = new Home();
    this.kept = this.opened();
    await this.open(before);
  }

  check(): void {
    const { ought } = this;
    expect([JSON.stringify(this.home.shown), this.home.at, this.home.steps.length]).toEqual([ought.texts[ought.at], ought.at, ought.texts.length]);
  }

  async act(): Promise<string> {
    const { draw, home } = this;
    const shown = home.shown as Shown;
    const what = ["edit", "edit", "edit", "edit", "undo", "undo", "redo", "style", "new", "same", "reload", "back", "forward", "recent"][Math.floor(draw() * 14)] ?? "edit";
    if (what === "edit") this.step({ scene: edit(shown.scene, draw), issues: [], conflicts: [], timing: draw() });
    if (what === "style") this.step({ ...made(shown.scene.seed, `style ${Math.floor(draw() * 6)}`), scene: { ...shown.scene, style: `s${draw()}` } });
    if (what === "new") this.make(made(Math.floor(draw() * 1e6)));
    if (what === "same") this.make(made(shown.scene.seed));
    if (what === "undo") await this.undo();
    if (what === "redo") await this.redo();
    if (what === "reload") await this.reload();
    if (what === "back") await this.travel(-1);
    if (what === "forward") await this.travel(1);
    if (what === "recent") {
      const heads = await this.kept.store.heads();
      await this.open(heads[Math.floor(draw() * heads.length)]?.id as string);
      this.push();
    }
    return what;
  }
}

describe("what is kept", () => {
  it(`is after ${SEQUENCES} random sequences what it was before, to the byte; undo walks all the way back`, async () => {
    const done = new Map<string, number>();
    for (let sequence = 0; sequence < SEQUENCES; sequence += 1) {
      const window = new Window(new IDBFactory(), drawing(1000 + sequence));
      window.make(made(sequence));
      const first = window.ought.texts[0];
      for (let i = 0; i < LENGTH; i += 1) {
        const what = await window.act();
        done.set(what, (done.get(what) ?? 0) + 1);
        window.check();
      }
      await window.reload();
      window.check();
      for (const [id, ought] of window.oughts) {
        const kept = await window.kept.read(id);
        expect(kept?.steps.map((step) => JSON.stringify(step))).toEqual(ought.texts);
        expect(kept?.head).toMatchObject({ at: ought.at, from: ought.from, ahead: ought.ahead, count: ought.texts.length });
      }
      let steps = 0;
      while (await window.undo()) {
        window.check();
        steps += 1;
        expect(steps).toBeLessThan(2000);
      }
      expect(JSON.stringify(window.home.shown)).toBe(first);
    }
    expect(Math.min(...done.values())).toBeGreaterThan(SEQUENCES);
  });

  it("costs some hundred bytes a step", () => {
    const before = made(1);
    const after = { ...before, scene: { ...before.scene, rooms: before.scene.rooms.map((one, i) => (i === 1 ? { ...one, furniture: one.furniture.map((body, k) => (k === 3 ? { ...body, x: 2 } : body)) } : one)) } };
    const kept = [keptStep("a", 0, before, null), keptStep("a", 1, after, before)];
    expect([kept[0]?.change, kept[1]?.whole]).toEqual([null, null]);
    expect(kept[1]?.change?.length).toBeLessThan(300);
    expect(JSON.stringify(stepsOf(kept)[1])).toBe(JSON.stringify(after));
  });

  it("is in the page alone where the browser keeps nothing, and that is said once", async () => {
    const denied = { open: () => { throw new DOMException("no", "SecurityError"); } } as unknown as IDBFactory;
    for (const factory of [denied, undefined]) {
      const window = new Window(factory as IDBFactory, drawing(5));
      if (!factory) window.kept = new KeptHomes((window.home = new Home()), new Store(undefined));
      const said: unknown[] = [];
      window.kept.store.onLost = (reason) => said.push(reason);
      window.kept.onLead = (id) => { window.led = window.follow(id); };
      for (let i = 0; i < 3; i += 1) {
        window.make(made(i));
        window.step({ scene: edit((window.home.shown as Shown).scene, window.draw), issues: [], conflicts: [], timing: 1 });
      }
      while (await window.undo()) window.check();
      expect([window.home.scene?.seed, said.length, window.kept.store.lasts]).toEqual([0, 1, false]);
      expect((await window.kept.store.heads()).length).toBe(3);
    }
  });

  it("goes on in the page where the browser is full, whole homes and later steps of kept ones", async () => {
    const factory = new IDBFactory();
    const window = new Window(factory, drawing(6));
    const lost: unknown[] = [];
    window.kept.store.onLost = (reason) => lost.push(reason);
    window.make(made(1));
    await window.kept.store.settled();
    expect(window.kept.store.lasts).toBe(true);
    const put = vi.spyOn(fake.IDBObjectStore.prototype, "put").mockImplementation(function full(this: IDBObjectStore) {
      this.transaction.abort();
      throw new DOMException("full", "QuotaExceededError");
    });
    for (let i = 0; i < 4; i += 1) window.step({ scene: edit((window.home.shown as Shown).scene, window.draw), issues: [], conflicts: [], timing: i });
    window.make(made(2));
    await window.kept.store.settled();
    expect([lost.length > 0, window.kept.store.lasts]).toEqual([true, false]);
    while (await window.undo()) window.check();
    expect([window.home.scene?.seed, window.home.steps.length]).toEqual([1, 5]);
    put.mockRestore();
  });

  it("is forgotten when that is wished; undo then goes on to the home before", async () => {
    const window = new Window(new IDBFactory(), drawing(7));
    for (const seed of [1, 2, 3]) window.make(made(seed));
    const [, second, third] = [...window.oughts.keys()];
    await window.kept.forget(new Set([second, third] as string[]));
    expect((await window.kept.store.heads()).map(({ title }) => title).sort()).toEqual(["seed 1", "seed 3"]);
    expect(await window.kept.read(second as string)).toBeNull();
    window.home.undo();
    await window.led;
    expect(window.home.scene?.seed).toBe(1);
  });

  it("of homes that were never edited is kept for the newest sixty", async () => {
    const window = new Window(new IDBFactory(), drawing(8));
    window.make(made(0));
    window.step({ scene: edit((window.home.shown as Shown).scene, window.draw), issues: [], conflicts: [], timing: 1 });
    for (let seed = 1; seed < 80; seed += 1) {
      window.make(made(seed));
      await window.kept.store.settled();
    }
    const seeds = async (): Promise<number[]> => (await window.kept.store.heads()).map(({ title }) => Number(title.replace("seed ", ""))).sort((a, b) => a - b);
    const newest = Array.from({ length: 61 }, (_, i) => 19 + i); // and the one that is shown
    await vi.waitUntil(async () => (await seeds()).length <= newest.length + 1, { timeout: 600_000, interval: 1 });
    expect(await seeds()).toEqual([0, ...newest]);
  });

  /** Two windows of one browser, the first with a home of two steps, the second with the same opened. */
  async function twoWindows() {
    const factory = new IDBFactory();
    const heard: ((event: { data: string }) => void)[] = [];
    const [here, there] = [0, 1].map((self) => {
      const tabs = { addEventListener: (_: string, hear: (event: { data: string }) => void) => { heard[self] = hear; }, postMessage: (id: string) => heard[1 - self]?.({ data: id }) };
      return new KeptHomes(new Home(), new Store(factory), tabs as unknown as BroadcastChannel);
    }) as [KeptHomes, KeptHomes];
    here.home.show(made(1), "new");
    here.home.show(made(1, "rustic"), "step");
    const own = here.current as string;
    there.open((await there.read(own)) as LeftHome);
    const styles = async (id: string | null) => (await new KeptHomes(new Home(), new Store(factory)).read(id as string))?.steps.map(({ made: of }) => of?.style ?? "none");
    const settled = () => Promise.all([here.store.settled(), there.store.settled()]);
    return { here, there, own, styles, settled };
  }

  it("is a home of its own where another window goes on with the same", async () => {
    const { here, there, own, styles, settled } = await twoWindows();
    here.home.show(made(1, "nordic"), "step");
    there.home.show(made(1, "modern"), "step");
    expect([here.isFork, there.isFork], "which a person is told").toEqual([true, false]);
    here.home.undo();
    here.home.redo();
    expect(here.isFork, "once").toBe(false);
    await settled();
    expect([here.current === own, there.current]).toEqual([false, own]);
    expect([await styles(own), await styles(here.current)]).toEqual([["none", "rustic", "modern"], ["none", "rustic", "nordic"]]);
  });

  it("keeps what another window made of it where this one only goes back", async () => {
    const { here, there, own, styles, settled } = await twoWindows();
    there.home.show(made(1, "modern"), "step");
    await there.store.settled();
    here.home.undo();
    there.home.show(made(1, "lavish"), "step");
    await settled();
    expect([await styles(own), await styles(here.current)]).toEqual([["none", "rustic", "modern", "lavish"], ["none", "rustic"]]);
  });

  it("keeps what another window made of it where this one leaves it for the home before, or for the one after", async () => {
    const { here, there, styles, settled } = await twoWindows();
    here.onLead = (id) => { led = here.read(id).then((kept) => here.follow(kept as LeftHome)); };
    let led = Promise.resolve();
    here.home.show(made(2), "new");
    here.home.undo();
    await led;
    await settled();
    const first = here.current as string;
    there.open((await there.read(first)) as LeftHome);
    there.home.show(made(1, "modern"), "step");
    await settled();
    here.home.redo();
    await led;
    await settled();
    expect(await styles(first)).toEqual(["none", "rustic", "modern"]);
  });

  it("is kept whole again where another window has forgotten it and this one goes on", async () => {
    const { here, there, styles, settled } = await twoWindows();
    here.home.show(made(1), "new");
    here.home.show(made(1, "rustic"), "step");
    await settled();
    await there.forget(new Set([here.current as string]));
    here.home.show(made(1, "nordic"), "step");
    await settled();
    expect(await styles(here.current)).toEqual(["none", "rustic", "nordic"]);
  });
});
