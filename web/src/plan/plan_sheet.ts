/** The plan as an architect draws it, beneath a canvas that shows only what is in hand: the service's sheet, moved with the camera. */
import { Vector3 } from "three";
import type { Kept } from "../view/label_layout";
import type { Viewport } from "../view/viewport";
import { DrawnSheet, type DrawPlan } from "./drawn_sheet";

const MM = 1000;
/** How far the scale bar's end stays from the canvas's corner, beside its last number, and its foot above it [px]. */
const [ASIDE, ABOVE] = [34, 20];
/** Between these two places of the ground the camera's scale is measured [m]. */
const MEASURED = 10;
/** The rows of words in a room: its name, its area and its size. */
const ROWS = "g:has(> .name) > text";

/** Where rows of words lie on a drawing, those written upright too [mm of the house]. */
function writtenOn(drawn: SVGSVGElement): (readonly [SVGTextElement, Kept])[] {
  return [...drawn.querySelectorAll<SVGTextElement>(ROWS)].map((row) => {
    const { x, y, width, height } = row.getBBox();
    const turn = (row.parentNode as SVGGElement).transform.baseVal.consolidate()?.matrix;
    const middle = new DOMPoint(x + width / 2, y + height / 2).matrixTransform(turn);
    return [row, { x: middle.x, y: middle.y, width: turn ? height : width, height: turn ? width : height }];
  });
}

export class PlanSheet extends DrawnSheet {
  /** Millimetres of the house a pixel, as they were last. */
  #followed = 0;
  /** The drawing whose lengths were measured, and what those along x and along z cover [mm of the house]. */
  #measuredOf: SVGSVGElement | null = null;
  #reach: readonly DOMRect[] = [];
  #written: ReturnType<typeof writtenOn> = [];

  constructor(readonly viewport: Viewport, draw: DrawPlan, failed: DrawnSheet["failed"]) {
    super(draw, failed);
    viewport.canvas.before(this.host);
    viewport.onFrame(() => this.#follow());
    this.onDrawn = () => {
      this.#written = this.shown ? writtenOn(this.shown) : [];
      viewport.invalidate();
    };
  }

  override turn(isShown: boolean): void {
    super.turn(isShown);
    if (!isShown) this.viewport.overlaid.set("rooms", []);
  }

  override pixels(): number {
    const [from, to] = this.#measured();
    return from && to ? Math.max(0, to.x - from.x) / (MEASURED * MM) : 0;
  }

  #measured() {
    return [this.viewport.project(new Vector3(0, 0, 0)), this.viewport.project(new Vector3(MEASURED, 0, 0))] as const;
  }

  /** Leaves out lengths that the canvas cuts while it shows all of the house between them: those along the one axis lie as far as those along the other go. */
  #leaveOutCut(drawn: SVGSVGElement, seen: Readonly<Record<"west" | "north" | "east" | "south", number>>): void {
    const [alongX, alongZ] = ["x", "z"].map((axis) => drawn.querySelector<SVGGElement>(`.lengths[data-along=${axis}]`));
    if (!alongX || !alongZ) return;
    if (this.#measuredOf !== drawn) [this.#measuredOf, this.#reach] = [drawn, [alongX.getBBox(), alongZ.getBBox()]];
    const [across, along] = this.#reach;
    if (!across || !along) return;
    const isIn = (from: number, to: number, low: number, high: number): boolean => from >= low && to <= high;
    const [x, z] = [[seen.west, seen.east], [seen.north, seen.south]] as const;
    alongX.classList.toggle("cut", isIn(along.y, along.y + along.height, ...z) && !isIn(across.y, across.y + across.height, ...z));
    alongZ.classList.toggle("cut", isIn(across.x, across.x + across.width, ...x) && !isIn(along.x, along.x + along.width, ...x));
  }

  /** Has what is shown over the canvas keep clear of what can be read in the rooms. */
  #keepRead(scale: number, at: { readonly x: number; readonly y: number }): void {
    const read = this.#written.filter(([row]) => row.style.visibility !== "hidden" && row.getClientRects().length > 0);
    this.viewport.overlaid.set("rooms", read.map(([, { x, y, width, height }]) => (
      { x: at.x + x / scale, y: at.y + y / scale, width: width / scale, height: height / scale })));
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
    this.#keepRead(scale, from);
    const { width, height } = this.viewport.size;
    this.#leaveOutCut(drawn, { west: -from.x * scale, north: -from.y * scale, east: (width - from.x) * scale, south: (height - from.y) * scale });
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
