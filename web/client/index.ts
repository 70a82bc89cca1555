/** A client of a Compose service: one function a call, typed as the service's OpenAPI document says. For browsers, Node, Deno and Bun. */
import type {
  Explained, FieldProblem, Fixed, FloorAnswer, FurnishedPlan, Generated, HomeHead, HomeList, HomeVersions, JobHead, JobList, HomeWithScene, Lines, PlaceAnswer, PlanImport,
  ProblemDocument, Request, Scene, ValidateAnswer,
} from "../src/served.js";

export type * from "../src/served.js";

/** What the service refused. */
export class ServiceRefusal extends Error {
  constructor(
    readonly status: number, readonly title: string, readonly detail: string, readonly errors: readonly FieldProblem[],
    /** When to come back [s], where the service says. */
    readonly retryAfter: number | null,
  ) {
    super(`${status} ${title}: ${detail}`);
    this.name = "ServiceRefusal";
  }
}

export interface ClientSettings {
  /** The caller's key, where the service wants one. */
  readonly key?: string;
  /** How often a call that is answered by 429 or 503 is tried again, after the time that the answer says (2). */
  readonly retries?: number;
  /** In place of the global one. */
  readonly fetch?: typeof fetch;
}

export interface CallSettings {
  readonly signal?: AbortSignal;
}

type Options = Readonly<Record<string, unknown>>;

const BUSY = [429, 503];
const MOST_WAIT_S = 60;

async function refusal(answer: Response): Promise<ServiceRefusal> {
  const said = (await answer.json().catch(() => ({}))) as Partial<ProblemDocument>;
  return new ServiceRefusal(answer.status, said.title ?? answer.statusText, said.detail ?? "", said.errors ?? [], secondsOf(answer));
}

function secondsOf(answer: Response): number | null {
  const said = answer.headers.get("Retry-After");
  return said !== null && /^\d+$/.test(said) ? Number(said) : null;
}

function revisionOf(head: HomeHead): Readonly<Record<string, string>> {
  return { "If-Match": `"${head.revision}"` };
}

export class Client {
  readonly #base: string;
  readonly #settings: ClientSettings;

  constructor(url: string, settings: ClientSettings = {}) {
    this.#base = url.endsWith("/") ? url : `${url}/`;
    this.#settings = settings;
  }

  /** Sends a call; what is refused is thrown as a ServiceRefusal. */
  async #send(method: string, path: string, body: BodyInit | null, headers: Readonly<Record<string, string>>, call: CallSettings): Promise<Response> {
    const { key, retries = 2, fetch: ask = fetch } = this.#settings;
    const all = { Accept: "application/json", ...(body === null ? {} : { "Content-Type": "application/json" }), ...(key ? { "X-API-Key": key } : {}), ...headers };
    for (let tried = 0; ; tried += 1) {
      const answer = await ask(new URL(path, this.#base), { method, body, headers: all, signal: call.signal ?? null });
      if (answer.ok) return answer;
      if (!BUSY.includes(answer.status) || tried >= retries) throw await refusal(answer);
      const wait = Math.min(secondsOf(answer) ?? 1, MOST_WAIT_S);
      await new Promise((done) => setTimeout(done, wait * 1000));
    }
  }

  async #post<Answer>(path: string, document: unknown, call: CallSettings): Promise<Answer> {
    return (await (await this.#send("POST", path, JSON.stringify(document), {}, call)).json()) as Answer;
  }

  async #get<Answer>(path: string, call: CallSettings): Promise<Answer> {
    return (await (await this.#send("GET", path, null, {}, call)).json()) as Answer;
  }

  /** Makes a furnished home. */
  generate(request: Partial<Request> = {}, call: CallSettings = {}): Promise<Generated> {
    return this.#post("generate", request, call);
  }

  /** Furnishes some rooms anew. */
  reroll(scene: Scene, rooms: readonly string[], options: Options = {}, call: CallSettings = {}): Promise<Generated> {
    return this.#post("generate", { scene, reroll: rooms, ...options }, call);
  }

  /** Gives a home another `style`, or other decorations (`decorate`). */
  restyle(scene: Scene, options: Options = {}, call: CallSettings = {}): Promise<Generated> {
    return this.#post("generate", { scene, ...options }, call);
  }

  /** Furnishes the rooms of a plan. */
  furnish(scene: unknown, options: Options = {}, call: CallSettings = {}): Promise<FurnishedPlan> {
    return this.#post("furnish", { scene, ...options }, call);
  }

  /** Repairs a scene with least movement. */
  fix(scene: unknown, options: Options = {}, call: CallSettings = {}): Promise<Fixed> {
    return this.#post("fix", { scene, ...options }, call);
  }

  /** Places pieces in a room. */
  place(room: unknown, pieces: readonly unknown[], options: Options = {}, call: CallSettings = {}): Promise<PlaceAnswer> {
    return this.#post("place", { room, pieces, ...options }, call);
  }

  /** Lists which rules a scene breaks. */
  validate(scene: unknown, options: Options = {}, call: CallSettings = {}): Promise<ValidateAnswer> {
    return this.#post("validate", { scene, ...options }, call);
  }

  /** Writes a scene for people to read. */
  view(scene: unknown, call: CallSettings = {}): Promise<Lines> {
    return this.#post("view", { scene }, call);
  }

  /** Says why a piece stands where it does. */
  explain(scene: unknown, id: string, call: CallSettings = {}): Promise<Explained> {
    return this.#post("explain", { scene, id }, call);
  }

  /** Says which floor of rooms is clear, kept free, and free to come to. */
  floor(scene: unknown, rooms: readonly string[] = [], call: CallSettings = {}): Promise<FloorAnswer> {
    return this.#post("floor", { scene, rooms }, call);
  }

  /** Reads a floor plan's file of another program. */
  async importPlan(content: BodyInit, call: CallSettings = {}): Promise<PlanImport> {
    return (await (await this.#send("POST", "import", content, { "Content-Type": "application/octet-stream" }, call)).json()) as PlanImport;
  }

  /** Writes a scene as a file; a ZIP archive where the format has several. */
  async exportScene(scene: unknown, format: string, options: Options = {}, call: CallSettings = {}): Promise<Blob> {
    return (await this.#send("POST", `export/${encodeURIComponent(format)}`, JSON.stringify({ scene, ...options }), {}, call)).blob();
  }

  /** Returns all furniture, decorations, room types, styles and presets that the service knows. */
  catalog(call: CallSettings = {}): Promise<Readonly<Record<string, unknown>>> {
    return this.#get("catalog", call);
  }

  /** Keeps a home; the answer names its id. */
  saveHome(scene: unknown, texts: { readonly name?: string; readonly notes?: string; readonly tags?: readonly string[] } = {}, call: CallSettings = {}): Promise<HomeHead> {
    return this.#post("homes", { scene, ...texts }, call);
  }

  /** Lists homes, the last changed first; `after` of an answer asks for the next page. */
  listHomes(wanted: { readonly search?: string; readonly tags?: readonly string[]; readonly limit?: number; readonly after?: string } = {}, call: CallSettings = {}): Promise<HomeList> {
    const query = new URLSearchParams(wanted.tags?.map((tag) => ["tag", tag]));
    for (const name of ["search", "limit", "after"] as const) if (wanted[name]) query.set(name, String(wanted[name]));
    return this.#get(`homes?${query}`, call);
  }

  /** Returns a home with its scene. */
  home(id: string, call: CallSettings = {}): Promise<HomeWithScene> {
    return this.#get(`homes/${encodeURIComponent(id)}`, call);
  }

  /** Changes name, notes, tags or scene of a home, unless somebody has changed it since `head` was read. */
  async changeHome(head: HomeHead, changes: Options, call: CallSettings = {}): Promise<HomeHead> {
    return (await (await this.#send("PATCH", `homes/${encodeURIComponent(head.id)}`, JSON.stringify(changes), revisionOf(head), call)).json()) as HomeHead;
  }

  /** Removes a home, unless somebody has changed it since `head` was read. */
  async removeHome(head: HomeHead, call: CallSettings = {}): Promise<void> {
    await this.#send("DELETE", `homes/${encodeURIComponent(head.id)}`, null, revisionOf(head), call);
  }

  /** Takes on long work: a call with a body, or with that body once a seed; the answer names its id. */
  addJob(wanted: { readonly call: string; readonly body?: Options; readonly seeds?: readonly number[] }, call: CallSettings = {}): Promise<JobHead> {
    return this.#post("jobs", wanted, call);
  }

  /** Lists jobs, the newest first. */
  listJobs(call: CallSettings = {}): Promise<JobList> {
    return this.#get("jobs", call);
  }

  /** Says how far a job is. */
  job(id: string, call: CallSettings = {}): Promise<JobHead> {
    return this.#get(`jobs/${encodeURIComponent(id)}`, call);
  }

  /** Says how far a job is, each time that changes, until it is done or removed. */
  async *followJob(id: string, call: CallSettings = {}): AsyncGenerator<JobHead, void, undefined> {
    const { body } = await this.#send("GET", `jobs/${encodeURIComponent(id)}/events`, null, { Accept: "text/event-stream" }, call);
    if (body === null) return;
    const reader = body.pipeThrough(new TextDecoderStream()).getReader();
    let kept = "";
    try {
      for (let read = await reader.read(); !read.done; read = await reader.read()) {
        const lines = (kept + read.value).split(/\r?\n/);
        kept = lines.pop() ?? "";
        for (const line of lines) {
          const told = line.startsWith("data:") ? (JSON.parse(line.slice(5)) as Partial<JobHead>) : {};
          if (told.id !== undefined) yield told as JobHead;
        }
      }
    } finally {
      await reader.cancel().catch(() => undefined);
    }
  }

  /** Returns what one of a job's calls was answered by, from 0; the problem document where it was refused. */
  jobResult<Answer>(id: string, number: number, call: CallSettings = {}): Promise<Answer | ProblemDocument> {
    return this.#get(`jobs/${encodeURIComponent(id)}/results/${number}`, call);
  }

  /** Ends a job and removes it with its results. */
  async removeJob(id: string, call: CallSettings = {}): Promise<void> {
    await this.#send("DELETE", `jobs/${encodeURIComponent(id)}`, null, {}, call);
  }

  /** Lists the versions of a home. */
  homeVersions(id: string, call: CallSettings = {}): Promise<HomeVersions> {
    return this.#get(`homes/${encodeURIComponent(id)}/versions`, call);
  }
}
