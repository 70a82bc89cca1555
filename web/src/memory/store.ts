/** Where homes are kept: in the browser's IndexedDB; where that is denied or full, in the page for as long as it is open. */

/** What is known of a kept home without reading its steps. */
export interface Head {
  readonly id: string;
  /** The home that was shown before this one was made: undo goes on there. */
  readonly from: string | null;
  /** The home that redo goes on to from the step `at`. */
  readonly ahead: { readonly at: number; readonly home: string } | null;
  /** How many steps there are, and which of them is shown. */
  readonly count: number;
  readonly at: number;
  /** When it was last changed [ms since 1970]. */
  readonly touched: number;
  readonly title: string;
  /** In words: how large it is. */
  readonly size: string;
  /** The address' query that makes it as it began; null for a file's. */
  readonly query: string | null;
}

/** A step as it is kept: whole, or as the change from the one before; each a JSON text. */
export interface KeptStep {
  readonly home: string;
  readonly number: number;
  readonly whole: string | null;
  readonly change: string | null;
}

export interface KeptHome {
  readonly head: Head;
  readonly steps: readonly KeptStep[];
}

const NAME = "compose";
const VERSION = 2;
const STORES = ["homes", "steps", "pictures"] as const;

function asked<Result>(request: IDBRequest<Result>): Promise<Result> {
  return new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error ?? new Error("the browser keeps nothing"));
  });
}

/** All steps of a home from a number on. */
function stepsFrom(home: string, number: number): IDBKeyRange {
  return IDBKeyRange.bound([home, number], [home, Number.POSITIVE_INFINITY]);
}

function opened(factory: IDBFactory | undefined): Promise<IDBDatabase> {
  if (!factory) return Promise.reject(new Error("this browser has no IndexedDB"));
  const request = factory.open(NAME, VERSION);
  request.onupgradeneeded = () => {
    const known = request.result.objectStoreNames;
    if (!known.contains("homes")) request.result.createObjectStore("homes", { keyPath: "id" });
    if (!known.contains("steps")) request.result.createObjectStore("steps", { keyPath: ["home", "number"] });
    if (!known.contains("pictures")) request.result.createObjectStore("pictures");
  };
  return asked(request);
}

/** The browser's IndexedDB; a getter, for where pages may not even look at it. */
function factoryOf(scope: { readonly indexedDB?: IDBFactory }): IDBFactory | undefined {
  try {
    return scope.indexedDB;
  } catch {
    return undefined;
  }
}

export class Store {
  /** Called when something could not be kept beyond this page. */
  onLost: (reason: unknown) => void = () => undefined;
  readonly #ready: Promise<void>;
  #database: IDBDatabase | null = null;
  /** What waits for the database to be open. */
  #waiting: (() => void)[] | null = [];
  #writes: Promise<unknown>[] = [];
  /** What the browser would not keep. */
  readonly #heads = new Map<string, Head>();
  readonly #steps = new Map<string, Map<number, KeptStep>>();
  readonly #pictures = new Map<string, string>();

  constructor(factory: IDBFactory | undefined = factoryOf(globalThis)) {
    const open = Promise.resolve().then(() => opened(factory)).then((database) => {
      this.#database = database;
      database.onversionchange = () => this.#close();
      database.onclose = () => this.#close();
    });
    this.#ready = open.catch((reason: unknown) => this.onLost(reason)).then(() => {
      const waiting = this.#waiting ?? [];
      this.#waiting = null;
      for (const act of waiting) act();
    });
  }

  #close(): void {
    this.#database?.close();
    this.#database = null;
  }

  /** Whether what is kept outlasts this page. */
  get lasts(): boolean {
    return this.#database !== null && this.#heads.size === 0;
  }

  /** Writes a home's head and some of its steps, all or nothing, and drops those after its last. The order of calls is kept. */
  write(head: Head, steps: readonly KeptStep[]): void {
    const act = (): void => {
      if (!this.#database || this.#heads.has(head.id)) this.#overlay(head, steps);
      else this.#writes.push(this.#transact(head, steps).catch((reason: unknown) => { this.#overlay(head, steps); this.onLost(reason); }));
    };
    if (this.#waiting) this.#waiting.push(act);
    else act();
  }

  /** Asked for at once and committed at once: a page that is left in the next moment has kept it. */
  #transact(head: Head, steps: readonly KeptStep[]): Promise<void> {
    return new Promise((resolve, reject) => {
      const work = (this.#database as IDBDatabase).transaction(["homes", "steps"], "readwrite");
      work.oncomplete = () => resolve();
      work.onabort = () => reject(work.error ?? new Error("the browser kept nothing"));
      work.objectStore("steps").delete(stepsFrom(head.id, head.count));
      for (const step of steps) work.objectStore("steps").put(step);
      work.objectStore("homes").put(head);
      work.commit?.();
    });
  }

  #overlay(head: Head, steps: readonly KeptStep[]): void {
    this.#heads.set(head.id, head);
    const own = this.#steps.get(head.id) ?? new Map<number, KeptStep>();
    for (const step of steps) own.set(step.number, step);
    this.#steps.set(head.id, own);
  }

  /** Reads a home with all its steps; null where none is kept under that id, or not whole. */
  async read(id: string): Promise<KeptHome | null> {
    await this.settled();
    const work = this.#database?.transaction(["homes", "steps"]);
    const [kept, steps] = work
      ? await Promise.all([asked<Head | undefined>(work.objectStore("homes").get(id)), asked<KeptStep[]>(work.objectStore("steps").getAll(stepsFrom(id, 0)))])
      : [undefined, []];
    const head = this.#heads.get(id) ?? kept;
    if (!head) return null;
    const all = new Map([...steps.map((step) => [step.number, step] as const), ...(this.#steps.get(id) ?? [])]);
    const found = Array.from({ length: head.count }, (_, number) => all.get(number));
    return found.every((step) => step !== undefined) ? { head, steps: found } : null;
  }

  /** The heads of all homes, those changed last first. */
  async heads(): Promise<Head[]> {
    await this.settled();
    const kept = this.#database ? await asked<Head[]>(this.#database.transaction("homes").objectStore("homes").getAll()) : [];
    const all = new Map([...kept.map((head) => [head.id, head] as const), ...this.#heads]);
    return [...all.values()].sort((a, b) => b.touched - a.touched || (a.id < b.id ? -1 : 1));
  }

  /** Keeps what a home looks like: a picture's data URL. One that cannot be kept is none. */
  async keepPicture(id: string, picture: string): Promise<void> {
    await this.settled();
    this.#pictures.set(id, picture);
    if (!this.#database || this.#heads.has(id)) return;
    await asked(this.#database.transaction("pictures", "readwrite").objectStore("pictures").put(picture, id)).catch(() => undefined);
  }

  async picture(id: string): Promise<string | null> {
    await this.settled();
    const kept = this.#pictures.get(id);
    if (kept !== undefined || !this.#database) return kept ?? null;
    return (await asked<string | undefined>(this.#database.transaction("pictures").objectStore("pictures").get(id))) ?? null;
  }

  /** Forgets homes; undo of one that came from them goes on to where they came from. */
  async forget(ids: ReadonlySet<string>): Promise<void> {
    const heads = new Map((await this.heads()).map((head) => [head.id, head]));
    const past = (id: string | null): string | null => { while (id !== null && ids.has(id)) id = heads.get(id)?.from ?? null; return id; };
    for (const head of heads.values()) {
      if (ids.has(head.id)) continue;
      const ahead = head.ahead && !ids.has(head.ahead.home) ? head.ahead : null;
      if (past(head.from) !== head.from || ahead !== head.ahead) this.write({ ...head, from: past(head.from), ahead }, []);
    }
    await this.settled();
    for (const id of ids) for (const kept of [this.#heads, this.#steps, this.#pictures]) kept.delete(id);
    const work = this.#database?.transaction(STORES, "readwrite");
    for (const id of work ? ids : []) {
      work?.objectStore("homes").delete(id);
      work?.objectStore("steps").delete(stepsFrom(id, 0));
      work?.objectStore("pictures").delete(id);
    }
    await new Promise<void>((resolve) => { if (work) work.oncomplete = work.onabort = () => resolve(); else resolve(); });
  }

  /** Waits until all that was written is kept, or known not to be. */
  async settled(): Promise<void> {
    await this.#ready;
    const writes = this.#writes;
    this.#writes = [];
    await Promise.all(writes);
  }
}
