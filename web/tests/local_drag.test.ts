import { describe, expect, it } from "vitest";
import { LocalDrag, type FrameSource } from "../src/core/local_drag";
import { piece, room, scene } from "./rooms";

/** Says what it was asked; answers as told. */
class Source implements FrameSource {
  readonly opened: (readonly [number, number])[] = [];
  readonly asked: number[][] = [];
  constructor(readonly answers: (readonly number[])[]) {}

  open(opening: Uint8Array, bodies: number): Promise<void> {
    this.opened.push([opening.length, bodies]);
    return Promise.resolve();
  }

  frame(asked: Float64Array): Promise<Float64Array> {
    this.asked.push([...asked]);
    return Promise.resolve(Float64Array.from(this.answers.shift() ?? []));
  }
}

const den = (x = 1) => scene([room("den", [0, 0, 6, 4], { furniture: [piece("den/one", { x, z: 1 }), piece("den/other", { x: 3, z: 2 })] })]);
const prepared = { opening: btoa("abc"), bodies: ["den/one", "den/other"] };
const placesOf = (answer: ReturnType<typeof den> | null) => answer?.rooms[0]?.furniture.map(({ x, z }) => [x, z]);

describe("a drag in the page", () => {
  it("asks each frame from the answer of the last", async () => {
    const source = new Source([[1, 5, 1.5, 1, 3.1, 2], [1, 4, 1.6, 1, 3.2, 2]]);
    const drag = await LocalDrag.of(source, prepared, den(), "den/one");
    expect(source.opened).toEqual([[3, 2]]);
    expect(placesOf(await drag?.frame(den(1.5)) ?? null)).toEqual([[1.5, 1], [3.1, 2]]);
    expect(placesOf(await drag?.frame(den(1.6)) ?? null)).toEqual([[1.6, 1], [3.2, 2]]);
    expect(source.asked).toEqual([[1.5, 1, 1, 1, 3, 2], [1.6, 1, 1.5, 1, 3.1, 2]]);
  });

  it("forgets an answer that is none", async () => {
    const source = new Source([[0, 5, 9, 9, 9, 9], [1, 4, 1.6, 1, 3.2, 2]]);
    const drag = await LocalDrag.of(source, prepared, den(), "den/one");
    expect(await drag?.frame(den(1.5))).toBeNull();
    await drag?.frame(den(1.6));
    expect(source.asked[1]).toEqual([1.6, 1, 1, 1, 3, 2]);
  });

  it("is left to the service where the piece cannot be dragged by itself, or the room is another", async () => {
    const source = new Source([]);
    expect(await LocalDrag.of(source, { ...prepared, opening: null }, den(), "den/one")).toBeNull();
    expect(await LocalDrag.of(source, { ...prepared, bodies: ["den/one"] }, den(), "den/one")).toBeNull();
    expect(await LocalDrag.of(source, { ...prepared, bodies: ["den/other", "den/one"] }, den(), "den/one")).toBeNull();
    expect(source.opened).toEqual([]);
  });
});
