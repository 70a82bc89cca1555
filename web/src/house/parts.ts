/** A part of a body, as it is drawn. */
import type { PartAxis, PartForm } from "../contract";
import type { Paint } from "./paints";

/** One part [m]: `size` is width, height, depth; `at` its centre relative to the body's footprint centre and underside. */
export interface Part {
  readonly form: PartForm;
  readonly size: readonly [number, number, number];
  readonly at: readonly [number, number, number];
  readonly axis: PartAxis;
  /** The radius at the axis' far end to that at its near end; the larger fills the box. */
  readonly taper: number;
  readonly paint: Paint;
  /** The front of its body that it moves with. */
  readonly front?: string;
}

/** A part that stands straight and does not taper. */
export function part(form: PartForm, size: Part["size"], at: Part["at"], paint: Paint): Part {
  return { form, size, at, axis: "y", taper: form === "cone" ? 0 : 1, paint };
}
