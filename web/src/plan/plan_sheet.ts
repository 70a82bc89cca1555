/** The plan as an architect draws it, beneath a canvas that shows only what is in hand: the service's sheet, moved with the camera. */
import { Vector3 } from "three";
import type { Viewport } from "../view/viewport";
import { DrawnSheet, type DrawPlan } from "./drawn_sheet";

const MM = 1000;
/** How far the scale bar's end stays from the canvas's corner, beside its last number, and its foot above it [px]. */
const [ASIDE, ABOVE] = [34, 20];
/** Between these two places of the ground the camera's scale is measured [m]. */
const MEASURED = 10;

export class PlanSheet extends DrawnSheet {
  /** Millimetres of the house a pixel, as they were last. */
  #followed = 0;

  constructor(readonly viewport: Viewport, draw: DrawPlan, failed: (reason: unknown) => void) {
    super(draw, failed);
    viewport.canvas.before(this.host);
    viewport.onFrame(() => this.#follow());
    this.onDrawn = () => viewport.invalidate();
  }

  override pixels(): number {
    const [from, to] = this.#measured();
    return from && to ? Math.max(0, to.x - from.x) / (MEASURED * MM) : 0;
  }

  #measured() {
    return [this.viewport.project(new Vector3(0, 0, 0)), this.viewport.project(new Vector3(MEASURED, 0, 0))] as const;
  }

  /** Shows the part of the sheet that the camera sees. */
  #follow(): void {
    const drawn = this.shown;
    if (!drawn) return;
    const [from, to] = this.#measured();
    if (!from || !to || to.x <= from.x) return;
    const scale = (MEASURED * MM) / (to.x - from.x);
    if (scale !== this.#followed) {
      this.#followed = scale;
      this.resized();
    }
    const { width, height } = this.viewport.size;
    const box = [-from.x * scale, -from.y * scale, width * scale, height * scale].map((value) => value.toFixed(1)).join(" ");
    if (drawn.getAttribute("viewBox") === box) return;
    drawn.setAttribute("viewBox", box);
    const bar = drawn.querySelector<SVGGElement>(".bar");
    if (!bar) return;
    const [x, y] = [(width - from.x - ASIDE) * scale - Number(bar.dataset.wide) / 2, (height - from.y - ABOVE) * scale];
    bar.setAttribute("transform", `translate(${x.toFixed(0)} ${y.toFixed(0)})`);
    bar.style.visibility = "visible";
  }
}
