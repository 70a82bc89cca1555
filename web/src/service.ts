/** The page's only way out: calls of the service that served it. */
import type { Catalog, FieldProblem, FixAnswer, FixRequest, GenerateAnswer, HouseRequest, ProblemDocument, Scene, ValidateAnswer, ViewAnswer } from "./contract";

/** Why a call brought no answer, in words for a person. */
export class ServiceProblem extends Error {
  constructor(
    readonly title: string,
    readonly detail: string,
    readonly fields: readonly FieldProblem[] = [],
  ) {
    super(`${title}: ${detail}`);
    this.name = "ServiceProblem";
  }
}

const LOST = new ServiceProblem(
  "The service does not answer",
  "It may have been stopped, or the connection is gone. What you see is the last house; try again when it is back.",
);

const WORDS: Readonly<Record<number, string>> = {
  401: "This service wants a key.",
  413: "The request is too large for this service.",
  429: "Too many requests for the moment. Wait a little, then try again.",
  503: "The service is busy. Try again shortly.",
};

/** Turns a refusal into words; the service's own come first. */
export function problemFrom(status: number, document: ProblemDocument | null): ServiceProblem {
  const title = document?.title ?? `The service refused (${status})`;
  const detail = document?.detail ?? WORDS[status] ?? "It gave no reason.";
  return new ServiceProblem(title, detail, document?.errors ?? []);
}

function isAbort(reason: unknown): boolean {
  return reason instanceof DOMException && reason.name === "AbortError";
}

async function readProblem(response: Response): Promise<ServiceProblem> {
  const document = (await response.json().catch(() => null)) as ProblemDocument | null;
  return problemFrom(response.status, document);
}

async function ask<Answer>(call: string, init: RequestInit): Promise<Answer> {
  let response: Response;
  try {
    response = await fetch(new URL(call, document.baseURI), init);
  } catch (reason) {
    throw isAbort(reason) ? reason : LOST;
  }
  if (!response.ok) throw await readProblem(response);
  try {
    return (await response.json()) as Answer;
  } catch (reason) {
    throw isAbort(reason) ? reason : LOST;
  }
}

function post<Answer>(call: string, body: unknown, signal: AbortSignal): Promise<Answer> {
  const headers = { "Content-Type": "application/json", Accept: "application/json" };
  return ask(call, { method: "POST", headers, body: JSON.stringify(body), signal });
}

/** What the service knows of every kind: how it is drawn, and of which materials. */
export function catalog(signal: AbortSignal): Promise<Catalog> {
  return ask("catalog", { headers: { Accept: "application/json" }, signal });
}

export function generate(request: HouseRequest, signal: AbortSignal): Promise<GenerateAnswer> {
  return post("generate", request, signal);
}

export function fix(request: FixRequest, signal: AbortSignal): Promise<FixAnswer> {
  return post("fix", request, signal);
}

export function view(scene: Scene, signal: AbortSignal): Promise<ViewAnswer> {
  return post("view", { scene }, signal);
}

/** The service's verdict on a scene, with its report, in which these bodies are marked as flagged. */
export function report(scene: Scene, flagged: readonly string[], signal: AbortSignal): Promise<ValidateAnswer> {
  return post("validate", { scene, flagged }, signal);
}

export { isAbort };
