/** The core, run where this module is loaded: a drag is opened once; then a frame is poses in, poses out (docs/core.md). */

/** What core.wasm exports of it. */
interface CoreExports {
  readonly memory: WebAssembly.Memory;
  reserve(bytes: bigint): number;
  release(mark: number): void;
  open_drag(address: number, size: bigint): number;
  answer_frame(drag: number, frame: number): void;
}

/** What becomes of a frame that has no answer. */
export const NO_ANSWER = 0;
const FLOAT = 8;
/** What a frame holds before the spots: the wish; the outcome and the work. */
const HEAD = 2;

export class DragCore {
  readonly #core: CoreExports;
  #drag = 0;
  #frame = 0;
  #floats = 0;

  constructor(instance: WebAssembly.Instance) {
    this.#core = instance.exports as unknown as CoreExports;
  }

  /** Takes a room in hand, in place of the one before: what POST /drag answered, and how many bodies there are in it. */
  open(opening: Uint8Array, bodies: number): void {
    const { memory, reserve, release, open_drag: openDrag } = this.#core;
    release(0);
    const address = reserve(BigInt(opening.length));
    new Uint8Array(memory.buffer).set(opening, address);
    this.#drag = openDrag(address, BigInt(opening.length));
    this.#floats = HEAD + 2 * bodies;
    this.#frame = reserve(BigInt(FLOAT * this.#floats));
  }

  /**
   * Answers a frame: x and z of the wish, then of every body in the last frame [m].
   * Returns the outcome and the work, then x and z of every body.
   */
  frame(asked: Float64Array): Float64Array {
    if (asked.length !== this.#floats) throw new Error(`A frame of this drag has ${this.#floats} numbers, not ${asked.length}`);
    const { memory, answer_frame: answerFrame } = this.#core;
    new Float64Array(memory.buffer, this.#frame, this.#floats).set(asked);
    answerFrame(this.#drag, this.#frame);
    return new Float64Array(memory.buffer, this.#frame, this.#floats).slice(); // a view anew: the memory may have grown
  }
}
