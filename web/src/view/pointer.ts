/** Tells a click on the canvas from the start of an orbit, and what the pointer is over. */

export interface PointerWords {
  /** `adds`: with Shift, to what is chosen already. */
  click(clientX: number, clientY: number, adds: boolean): void;
  /** At most once a frame; null when the pointer has left. */
  over(at: { clientX: number; clientY: number } | null): void;
}

/** Further than this [CSS pixels] a press is a drag; fingers are less still. */
const STILL = { touch: 12, other: 5 } as const;

/** A finger that stays this long on a piece takes hold of it, and clicks nothing; before, it turns the house [ms]. */
export const LONG_PRESS = 450;

/** Whether a pointer is where it was, as far as hands keep still. */
export function isStill(from: PointerEvent, to: PointerEvent): boolean {
  const reach = Math.hypot(to.clientX - from.clientX, to.clientY - from.clientY);
  return reach <= (to.pointerType === "touch" ? STILL.touch : STILL.other);
}

function isClick(from: PointerEvent, to: PointerEvent): boolean {
  return isStill(from, to) && (to.pointerType !== "touch" || to.timeStamp - from.timeStamp < LONG_PRESS);
}

export function listenToPointer(canvas: HTMLCanvasElement, say: PointerWords): void {
  let pressed: PointerEvent | null = null;
  let latest: PointerEvent | null = null;
  // A second finger makes both of them the camera's.
  canvas.addEventListener("pointerdown", (event) => { pressed = event.isPrimary ? event : null; });
  canvas.addEventListener("pointerup", (event) => {
    const from = pressed;
    pressed = null;
    if (!from || event.button !== 0) return;
    if (isClick(from, event)) say.click(event.clientX, event.clientY, event.shiftKey);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (pressed) return;
    if (!latest) {
      requestAnimationFrame(() => {
        if (latest) say.over(latest);
        latest = null;
      });
    }
    latest = event;
  });
  canvas.addEventListener("pointerleave", () => {
    latest = null;
    say.over(null);
  });
}
