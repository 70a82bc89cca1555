/** Tells a click on the canvas from the start of an orbit, and what the pointer is over. */

export interface PointerWords {
  click(clientX: number, clientY: number): void;
  /** At most once a frame; null when the pointer has left. */
  over(at: { clientX: number; clientY: number } | null): void;
}

/** Further than this [CSS pixels] a press is a drag; fingers are less still. */
const STILL = { touch: 12, other: 5 } as const;

function isStill(from: PointerEvent, to: PointerEvent): boolean {
  const reach = Math.hypot(to.clientX - from.clientX, to.clientY - from.clientY);
  return reach <= (to.pointerType === "touch" ? STILL.touch : STILL.other);
}

export function listenToPointer(canvas: HTMLCanvasElement, say: PointerWords): void {
  let pressed: PointerEvent | null = null;
  let latest: PointerEvent | null = null;
  canvas.addEventListener("pointerdown", (event) => { pressed = event; });
  canvas.addEventListener("pointerup", (event) => {
    const from = pressed;
    pressed = null;
    if (!from || event.button !== 0) return;
    if (isStill(from, event)) say.click(event.clientX, event.clientY);
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
