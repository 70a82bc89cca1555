/**
 * Frames of drags in Node, compared with what wasmtime answered: tests/core/test_drag_bytes.py.
 *
 * Not a test of its own: it runs where COMPOSE_DRAGS names a file of drags.
 */
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import { DragCore, NO_ANSWER } from "../src/core/drag_core";

interface RecordedDrag {
  readonly opening: string;
  readonly start: readonly number[];
  readonly wishes: readonly (readonly [number, number])[];
  readonly digest: string;
}

const given = process.env.COMPOSE_DRAGS;
const read = (path: string | URL): Uint8Array<ArrayBuffer> => new Uint8Array(readFileSync(path));
const DRAGS = given === undefined ? [] : (JSON.parse(new TextDecoder().decode(read(given))) as readonly RecordedDrag[]);

describe.skipIf(given === undefined)("frames in Node", () => {
  let core: DragCore;
  beforeAll(async () => {
    core = new DragCore((await WebAssembly.instantiate(read(new URL("../../solver/core/core.wasm", import.meta.url)))).instance);
  });

  it.each(DRAGS)("are answered with the bytes that wasmtime answers: $digest", ({ opening, start, wishes, digest }) => {
    core.open(new Uint8Array(Buffer.from(opening, "base64")), start.length / 2);
    const all = createHash("sha256");
    let spots = Float64Array.from(start);
    for (const wish of wishes) {
      const answer = core.frame(Float64Array.of(...wish, ...spots));
      all.update(new Uint8Array(answer.buffer));
      if (answer[0] !== NO_ANSWER) spots = answer.slice(2);
    }
    expect(all.digest("hex")).toBe(digest);
  });

  it("have as many numbers as the room has bodies, and two", () => {
    const first = DRAGS[0] as RecordedDrag;
    core.open(new Uint8Array(Buffer.from(first.opening, "base64")), first.start.length / 2);
    expect(() => core.frame(new Float64Array(3))).toThrow("numbers");
  });
});
