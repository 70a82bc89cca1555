/** A drag whose frames are answered in the page: scenes in, scenes out; in between the numbers of drag_core.ts. */
import type { Body, DragAnswer, Scene } from "../contract";
import { NO_ANSWER } from "./drag_core";

/** Who answers frames: a CoreThread; a DragCore in tests. */
export interface FrameSource {
  open(opening: Uint8Array, bodies: number): Promise<void>;
  frame(asked: Float64Array): Promise<Float64Array>;
}

function bytesOf(base64: string): Uint8Array {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
}

/** All that is in a scene of one room, in the order of a frame's spots. */
function bodiesOf(scene: Scene): readonly Body[] {
  return [...scene.rooms.flatMap((room) => [...room.furniture, ...room.decorations]), ...(scene.dynamic ?? [])];
}

export class LocalDrag {
  #last: Float64Array;

  private constructor(readonly source: FrameSource, readonly id: string, start: Scene) {
    this.#last = Float64Array.from(bodiesOf(start).flatMap(({ x, z }) => [x, z]));
  }

  /**
   * Takes a piece in hand.
   * Returns null where the piece cannot be dragged by itself.
   */
  static async of(source: FrameSource, prepared: DragAnswer, start: Scene, id: string): Promise<LocalDrag | null> {
    const bodies = bodiesOf(start);
    const known = prepared.bodies.length === bodies.length && bodies.every((body, at) => body.id === prepared.bodies[at]);
    if (prepared.opening === null || !known) return null;
    await source.open(bytesOf(prepared.opening), bodies.length);
    return new LocalDrag(source, id, start);
  }

  /**
   * Answers a frame: the piece in hand where it is wished, in a scene of its room alone.
   * Returns the scene with all where it goes; null where no valid place is known.
   */
  async frame(wished: Scene): Promise<Scene | null> {
    const held = bodiesOf(wished).find(({ id }) => id === this.id);
    if (!held) return null;
    const answer = await this.source.frame(Float64Array.of(held.x, held.z, ...this.#last));
    if (answer[0] === NO_ANSWER) return null;
    this.#last = answer.slice(2);
    return this.#at(wished);
  }

  #at(scene: Scene): Scene {
    let at = 0;
    const spotOf = <Of extends Body>(body: Of): Of => ({ ...body, x: this.#last[at++] ?? body.x, z: this.#last[at++] ?? body.z });
    const rooms = scene.rooms.map((room) => ({ ...room, furniture: room.furniture.map(spotOf), decorations: room.decorations.map(spotOf) }));
    return { ...scene, rooms, dynamic: (scene.dynamic ?? []).map(spotOf) };
  }
}
