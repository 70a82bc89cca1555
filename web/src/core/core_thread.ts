/** Asks the worker that runs the core; started when it is first wanted. */
import { tookSoLong } from "../timing";
import type { Question, Told } from "./core_worker";

/** A question without its number. */
type Unnumbered<Of> = Of extends Question ? Omit<Of, "number"> : never;

interface Waiting {
  resolve(answer: Float64Array | undefined): void;
  reject(reason: unknown): void;
}

export class CoreThread {
  readonly #worker: Worker;
  readonly #waiting = new Map<number, Waiting>();
  readonly #loaded: Promise<unknown>;
  #number = 0;

  /** @param url where core.wasm is. */
  constructor(url: string) {
    this.#worker = new Worker(new URL("./core_worker.ts", import.meta.url), { type: "module" });
    this.#worker.addEventListener("message", ({ data }: MessageEvent<Told>) => this.#told(data));
    this.#worker.addEventListener("error", (event) => this.#fail(new Error(event.message)));
    this.#loaded = this.#ask({ kind: "load", url });
    this.#loaded.catch(() => undefined); // whoever opens a drag is told
  }

  /** Takes a room in hand: what POST /drag answered, and how many bodies are in it. */
  async open(opening: Uint8Array, bodies: number): Promise<void> {
    await this.#loaded;
    await this.#ask({ kind: "open", opening, bodies });
  }

  /** Answers a frame, as DragCore does. */
  async frame(asked: Float64Array): Promise<Float64Array> {
    const answer = await this.#ask({ kind: "frame", asked });
    if (!answer) throw new Error("The core answered nothing");
    return answer;
  }

  #ask(question: Unnumbered<Question>): Promise<Float64Array | undefined> {
    const number = ++this.#number;
    return new Promise((resolve, reject) => {
      this.#waiting.set(number, { resolve, reject });
      this.#worker.postMessage({ ...question, number });
    });
  }

  #told({ number, answer, took, failed }: Told): void {
    if (took !== undefined) tookSoLong("frame answered", took);
    const waiting = this.#waiting.get(number);
    this.#waiting.delete(number);
    if (failed === undefined) waiting?.resolve(answer);
    else waiting?.reject(new Error(failed));
  }

  #fail(reason: unknown): void {
    for (const { reject } of this.#waiting.values()) reject(reason);
    this.#waiting.clear();
  }
}
