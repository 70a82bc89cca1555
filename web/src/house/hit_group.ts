/** Bodies drawn in batches that a ray meets by their parts, whatever the batches hold. */
import { Group, Vector3, type Intersection, type Raycaster } from "three";
import type { PlacedBody } from "./frame";
import type { PartBatches } from "./part_batches";
import type { Swing } from "./fronts";
import { meets, meetsOpen } from "./part_hits";
import type { Part } from "./parts";

/** Of a body whose fronts may stand open: how its fronts are moved; undefined where all are shut. */
export type SwingsOf = (number: number) => ((front: string | undefined) => Swing | undefined) | undefined;

/** A ray that meets a body is told its number as `instanceId`. */
export class HitGroup extends Group {
  /** `partsShown` are those of a body, by its number, that can be met now. */
  constructor(
    drawn: PartBatches, readonly bodies: readonly PlacedBody[], readonly partsShown: (number: number) => readonly Part[],
    readonly swingsOf: SwingsOf = () => undefined,
  ) {
    super();
    for (const batch of drawn.meshes) this.add(batch);
  }

  /** The front of a body that a ray meets first; undefined where what it meets belongs to none. */
  frontAt(raycaster: Raycaster, number: number): string | undefined {
    const ray = { origin: raycaster.ray.origin.toArray(), direction: raycaster.ray.direction.toArray() };
    const body = this.bodies[number];
    return body && meetsOpen(ray, body, this.partsShown(number), this.swingsOf(number) ?? (() => undefined))?.front;
  }

  override raycast(raycaster: Raycaster, hits: Intersection[]): void {
    const ray = { origin: raycaster.ray.origin.toArray(), direction: raycaster.ray.direction.toArray() };
    this.bodies.forEach((body, instanceId) => {
      const swings = this.swingsOf(instanceId);
      const parts = this.partsShown(instanceId);
      const distance = swings ? (meetsOpen(ray, body, parts, swings)?.distance ?? null) : meets(ray, body, parts);
      if (distance !== null) hits.push({ object: this, instanceId, distance, point: raycaster.ray.at(distance, new Vector3()) });
    });
  }
}
