/** A chosen decoration that is dragged: on what the pointer is over, on the floor, or along its wall. */
import type { Decoration, Room } from "../contract";
import { roomHolding } from "../house/room_at";
import type { Stage } from "../stage";
import type { Home } from "../state/home";
import type { Acts } from "./acts";

interface Held {
  readonly id: string;
  readonly room: Room;
  readonly thing: Decoration;
  to: Partial<Decoration>;
}

export class ThingDrag {
  #held: Held | null = null;

  constructor(readonly home: Home, readonly stage: Stage, readonly acts: Acts) {}

  get dragged(): string | null {
    return this.#held?.id ?? null;
  }

  lift(id: string): boolean {
    const found = this.acts.thing(id);
    if (found) this.#held = { id, ...found, to: {} };
    return found !== null;
  }

  /** Wishes for its centre somewhere in the house; `under`: the piece of furniture that the pointer is over. */
  drag(at: { readonly x: number; readonly z: number }, under: string | null): void {
    const [held, scene] = [this.#held, this.home.scene];
    if (!held || !scene) return;
    const { room, thing } = held;
    const [x, z] = [at.x - room.x, at.z - room.z].map((metres) => Math.round(metres * 1000) / 1000) as [number, number];
    const wall = thing.mounted_on_wall;
    if (wall) held.to = wall === "north" || wall === "south" ? { x } : { z };
    else if (roomHolding(scene.rooms, room.level, at.x, at.z)?.id === room.id) {
      const carrier = room.furniture.find((piece) => piece.id === under);
      const stays = carrier?.id === thing.parent;
      held.to = { x, z, ...(stays ? {} : carrier ? { parent: carrier.id, y: carrier.y + carrier.height } : { parent: null, y: 0 }) };
    }
    this.stage.house?.place(held.id, { x: room.x + (held.to.x ?? thing.x), z: room.z + (held.to.z ?? thing.z) });
    this.stage.viewport.castShadows();
  }

  drop(): void {
    const held = this.#held;
    this.#held = null;
    if (held && Object.keys(held.to).length > 0) this.acts.put(held.id, held.to);
  }

  cancel(): void {
    const held = this.#held;
    this.#held = null;
    const found = held && this.acts.thing(held.id);
    if (!found) return; // another home may be shown by now, and have one of its own
    this.stage.house?.place(held.id, { x: found.room.x + found.thing.x, z: found.room.z + found.thing.z });
    this.stage.viewport.castShadows();
  }
}
