/** The page's only way out: calls of the service that served it. */
import type { Catalog, DragAnswer, Explained, FieldProblem, FixAnswer, FloorAnswer, FixRequest, FurnishAnswer, Furniture, GenerateAnswer, HouseRequest, ImportAnswer, PlaceAnswer, ProblemDocument, Scene, ValidateAnswer, ViewAnswer } from "./contract";
import type { ExportFormat, ExportFormats } from "./served";
import { remember, remembered } from "./panel/preferences";
import { inPageWords, roomsCalled } from "./plan/plan_words";
import { say } from "./words/language";

/** What is known of a refusal beside its words. */
interface Refusal {
  readonly fields?: readonly FieldProblem[];
  /** The HTTP status; 0 where no answer came. */
  readonly status?: number | null;
  /** When to come back [s], where the service says. */
  readonly retryAfter?: number | null;
  /** What else may be asked for, in words. */
  readonly ways?: readonly (readonly [words: string, act: () => void])[];
}

/** Why a call brought no answer, in words for a person. */
export class ServiceProblem extends Error {
  readonly fields: readonly FieldProblem[];
  readonly status: number | null;
  readonly retryAfter: number | null;
  readonly ways: NonNullable<Refusal["ways"]>;

  constructor(readonly title: string, readonly detail: string, refusal: Refusal = {}) {
    super(`${title}: ${detail}`);
    this.name = "ServiceProblem";
    this.fields = refusal.fields ?? [];
    this.status = refusal.status ?? null;
    this.retryAfter = refusal.retryAfter ?? null;
    this.ways = refusal.ways ?? [];
  }

  /** Whether the same is refused whenever it is asked: not for want of a key, of time or of a turn. */
  get isFinal(): boolean {
    const status = this.status ?? 0;
    return status >= 400 && status < 500 && ![401, 408, 429].includes(status);
  }
}

export const LOST = new ServiceProblem(
  "The service does not answer",
  "It may have been stopped, or the connection is gone. What is shown stays; try again when it is back.",
  { status: 0 },
);

/** Title and detail where the refusal brings none, as one from a proxy before the service. */
const WORDS: Readonly<Record<number, readonly [string, string]>> = {
  401: ["This service wants a key", "Ask whoever runs it for one."],
  413: ["Too large", "The request is too large for this service."],
  429: ["Too many requests", "It takes no more for the moment. Wait a little, then try again."],
  502: ["The service is away", "Something before it answers in its place. Try again shortly."],
  503: ["The service is busy", "It answers others first. Try again shortly."],
  504: ["The service is slow", "No answer came in time. Try again, or ask for a smaller house."],
};

/** Turns a refusal into words; the service's own come first. */
export function problemFrom(status: number, document: ProblemDocument | null, retryAfter: number | null = null): ServiceProblem {
  const [known, why] = WORDS[status] ?? [say("The service refused ({status})", { status }), "It gave no reason."];
  const [title, detail] = [document?.title ?? known, document?.detail ?? why];
  return new ServiceProblem(title, detail, { fields: document?.errors ?? [], status, retryAfter });
}

/** Reads Retry-After, which says seconds or a date; null where it says neither. */
export function secondsOf(retryAfter: string | null, now = Date.now()): number | null {
  if (retryAfter === null || retryAfter.trim() === "") return null;
  const seconds = Number(retryAfter);
  if (Number.isFinite(seconds)) return Math.max(0, Math.ceil(seconds));
  const date = Date.parse(retryAfter);
  return Number.isNaN(date) ? null : Math.max(0, Math.ceil((date - now) / 1000));
}

function isAbort(reason: unknown): boolean {
  return reason instanceof DOMException && reason.name === "AbortError";
}

async function readProblem(response: Response): Promise<ServiceProblem> {
  const document = (await response.json().catch(() => null)) as ProblemDocument | null;
  return problemFrom(response.status, document, secondsOf(response.headers.get("Retry-After")));
}

let ownKey: string | null = null;

/** Keeps the service's key while this window is open; where the browser keeps nothing, until the page is left. */
export function useKey(key: string): void {
  ownKey = key;
  remember("key", key, "sessionStorage");
}

function withKey(headers: HeadersInit | undefined): Headers {
  const all = new Headers(headers);
  const key = ownKey ?? remembered("key", "sessionStorage");
  if (key) all.set("X-API-Key", key);
  return all;
}

/** What waits for the service to answer again. */
const waiting = new Set<() => void>();

/** Does something once the service has answered any call, and what that changes is shown, unless what is returned is called before. */
export function onceAnswered(act: () => void): () => void {
  waiting.add(act);
  return () => waiting.delete(act);
}

/** Asks, and reads the answer; what is refused is thrown in words. */
export async function askFor<Answer>(read: (response: Response) => Promise<Answer>, call: string, init: RequestInit): Promise<Answer> {
  let response: Response;
  try {
    response = await fetch(new URL(call, document.baseURI), { ...init, headers: withKey(init.headers) });
  } catch (reason) {
    throw isAbort(reason) ? reason : LOST;
  }
  if (!response.ok) throw await readProblem(response);
  const answer = await read(response).catch((reason: unknown) => { throw isAbort(reason) ? reason : LOST; });
  for (const act of waiting) setTimeout(act);
  waiting.clear();
  return answer;
}

function ask<Answer>(call: string, init: RequestInit): Promise<Answer> {
  return askFor(async (response) => (await response.json()) as Answer, call, init);
}

function post<Answer>(call: string, body: unknown, signal?: AbortSignal): Promise<Answer> {
  const headers = { "Content-Type": "application/json", Accept: "application/json" };
  return ask(call, { method: "POST", headers, body: JSON.stringify(body), signal: signal ?? null });
}

let known: Catalog | null = null;

/** What the service knows of every kind: how it is drawn, and of which materials; asked for until it was told. */
export async function catalog(signal?: AbortSignal): Promise<Catalog> {
  return (known ??= await ask<Catalog>("catalog", { headers: { Accept: "application/json" }, signal: signal ?? null }));
}

/** A file of the user's own assets. */
export function assetFile(name: string): Promise<ArrayBuffer> {
  return askFor((response) => response.arrayBuffer(), `asset/${encodeURIComponent(name)}`, { headers: { Accept: "model/gltf-binary" } });
}

export function generate(request: HouseRequest, signal?: AbortSignal): Promise<GenerateAnswer> {
  return post("generate", request, signal);
}

/** Furnishes rooms of a scene anew; without a seed the service draws one. */
export function reroll(scene: Scene, rooms: readonly string[], signal: AbortSignal | undefined, seed?: number): Promise<GenerateAnswer> {
  return post("generate", { scene, reroll: rooms, ...(seed === undefined ? {} : { seed }) }, signal);
}

/** Furnishes rooms of a plan, all where none are named; what stands in them is kept. */
export function furnish(scene: Scene, rooms: readonly string[], signal?: AbortSignal): Promise<FurnishAnswer> {
  return post("furnish", rooms.length > 0 ? { scene, rooms } : { scene }, signal);
}

/** Why a piece of furniture stands where it does. */
export function explain(scene: Scene, id: string, signal?: AbortSignal): Promise<Explained> {
  return post("explain", { scene, id }, signal);
}

/** What a home is to look like: a style, and whether it is decorated. */
export type Look = Pick<HouseRequest, "style" | "decorate">;

/** A home in another style, or with other decorations; its furniture stays where it stands. */
export function restyle(scene: Scene, wish: Look, signal?: AbortSignal): Promise<GenerateAnswer> {
  return post("generate", { scene, ...wish }, signal);
}

/** The formats that the service can write here. */
export async function exportFormats(signal?: AbortSignal): Promise<readonly ExportFormat[]> {
  const { formats } = await ask<ExportFormats>("export", { headers: { Accept: "application/json" }, signal: signal ?? null });
  return formats.filter(({ available }) => available);
}

/** A scene's file in a format, and the name that the service gives it, if it does; `more` of how it is written. */
export function exportedFile(scene: Scene, format: string, signal?: AbortSignal, more: object = {}): Promise<{ readonly name: string | null; readonly content: Blob }> {
  const init = { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ scene, ...more }), signal: signal ?? null };
  return askFor(async (response) => {
    const named = /filename\*=UTF-8''([^;]+)/.exec(response.headers.get("Content-Disposition") ?? "")?.[1];
    return { name: named === undefined ? null : decodeURIComponent(named), content: await response.blob() };
  }, `export/${format}`, init);
}

/** The plan of a scene as SVG, at 1 to a scale; at what fits its paper where none is given. */
export async function planOf(scene: Scene, scale: number | null, signal?: AbortSignal): Promise<string> {
  const { content } = await exportedFile(scene, "svg", signal, { called: roomsCalled(scene), ...(scale === null ? {} : { scale }) });
  return inPageWords(await content.text());
}

/** A file as it was handed over: a scene, or a floor plan of another program. */
export interface GivenFile {
  readonly name: string;
  readonly content: string | ArrayBuffer;
  /** The storey of a plan that is to be read; without one the lowest is. */
  readonly level?: number;
  /** The unit it is in; without one the service tells it. */
  readonly unit?: string;
}

/** What a file holds, as the service reads it; what is wrong with the file is said with its name. */
export async function readFile({ name, content, level, unit }: GivenFile, signal?: AbortSignal): Promise<ImportAnswer> {
  const asked = new URLSearchParams({ ...(level === undefined ? {} : { level: String(level) }), ...(unit === undefined ? {} : { unit }) });
  try {
    return await ask(asked.size > 0 ? `import?${asked}` : "import", { method: "POST", headers: { "Content-Type": "application/octet-stream", Accept: "application/json" }, body: content, signal: signal ?? null });
  } catch (reason) {
    if (!(reason instanceof ServiceProblem) || reason.fields.length === 0) throw reason;
    throw new ServiceProblem(say("{name} cannot be read", { name }), reason.detail, reason);
  }
}

export function fix(request: FixRequest, signal?: AbortSignal): Promise<FixAnswer> {
  return post("fix", request, signal);
}

/** How a piece of a kind would stand in a room beside what stands there: the places that are found, the best first. */
export async function placesFor(scene: Scene, roomId: string, kind: { readonly key: string; readonly size: readonly [number, number, number] }, id: string, alternatives: number, signal?: AbortSignal): Promise<Furniture[]> {
  const room = scene.rooms.find((one) => one.id === roomId);
  const [width, depth, height] = kind.size;
  const pieces = [{ id, name: kind.key, width, depth, height }];
  const answer = await post<PlaceAnswer>("place", { room, pieces, alternatives, wall_thickness: scene.wall_thickness }, signal);
  const scenes = [answer, ...answer.alternatives].filter(({ unplaced }) => unplaced.length === 0).map((one) => one.scene);
  return scenes.flatMap((one) => one.rooms.flatMap(({ furniture }) => furniture.filter((piece) => piece.id === id)));
}

/** Prepares the room of a piece that is taken in hand. */
export function drag(scene: Scene, id: string, signal?: AbortSignal): Promise<DragAnswer> {
  return post("drag", { scene, id }, signal);
}

/** Where the service keeps the core that the page runs as well. */
export function coreUrl(): string {
  return new URL("core.wasm", document.baseURI).href;
}

/** The floor of rooms, all where none are named, as the rules see it. */
export function floor(scene: Scene, rooms: readonly string[], signal?: AbortSignal): Promise<FloorAnswer> {
  return post("floor", rooms.length > 0 ? { scene, rooms } : { scene }, signal);
}

export function view(scene: Scene, signal?: AbortSignal): Promise<ViewAnswer> {
  return post("view", { scene }, signal);
}

/** The service's verdict on a scene, with its report, in which these bodies are marked as flagged. */
export function report(scene: Scene, flagged: readonly string[], signal?: AbortSignal): Promise<ValidateAnswer> {
  return post("validate", { scene, flagged }, signal);
}

export { isAbort };
