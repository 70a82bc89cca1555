/** Bodies drawn in batches that a ray meets by their parts, whatever the batches hold. */
import { Group, Vector3, type Intersection, type Raycaster } from "three";
import type { PlacedBody } from "./frame";
import type { PartBatches } from "./part_batches";
import { meets } from "./part_hits";
import type { Part } from "./parts";

/** A ray that meets a body is told its number as `instanceId`. */
export class HitGroup extends Group {
  /** `partsShown` are those of a body, by its number, that can be met now. */
  constructor(drawn: PartBatches, readonly bodies: readonly PlacedBody[], readonly partsShown: (number: number) => readonly Part[]) {
    super();
    for (const batch of drawn.meshes) this.add(batch);
  }

  override raycast(raycaster: Raycaster, hits: Intersection[]): void {
    const ray = { origin: raycaster.ray.origin.toArray(), direction: raycaster.ray.direction.toArray() };
    this.bodies.forEach((body, instanceId) => {
      const distance = meets(ray, body, this.partsShown(instanceId));
      if (distance !== null) hits.push({ object: this, instanceId, distance, point: raycaster.ray.at(distance, new Vector3()) });
    });
  }
}
