/** The core in a thread of its own, so that a frame never waits for what is drawn. Asked by core_thread.ts. */
import { DragCore } from "./drag_core";

/** What the worker is asked; every answer names the question's number. */
export type Question =
  | { readonly number: number; readonly kind: "load"; readonly url: string }
  | { readonly number: number; readonly kind: "open"; readonly opening: Uint8Array; readonly bodies: number }
  | { readonly number: number; readonly kind: "frame"; readonly asked: Float64Array };

export interface Told {
  readonly number: number;
  /** The answer to a frame, and how long it took here [ms]. */
  readonly answer?: Float64Array;
  readonly took?: number;
  /** Why there is none. */
  readonly failed?: string;
}

let module: WebAssembly.Module | null = null;
let core: DragCore | null = null;

async function answerTo(question: Question): Promise<Float64Array | undefined> {
  if (question.kind === "load") {
    module = await WebAssembly.compileStreaming(fetch(question.url));
  } else if (question.kind === "open") {
    if (!module) throw new Error("The core is not loaded");
    core ??= new DragCore(await WebAssembly.instantiate(module));
    core.open(question.opening, question.bodies);
  } else {
    if (!core) throw new Error("Nothing is in hand");
    return core.frame(question.asked);
  }
  return undefined;
}

addEventListener("message", ({ data }: MessageEvent<Question>) => {
  const tell = (told: Omit<Told, "number">): void => postMessage({ number: data.number, ...told } satisfies Told);
  const start = performance.now();
  answerTo(data).then(
    (answer) => tell(answer ? { answer, took: performance.now() - start } : {}),
    (reason: unknown) => {
      core = null; // an instance that trapped is of no further use
      tell({ failed: String(reason) });
    },
  );
});
