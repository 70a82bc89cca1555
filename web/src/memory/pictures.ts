/** A picture of each home as it was last seen, taken from frames that are drawn anyway. */

const WIDTH = 216;
const HEIGHT = 135;
/** A home that is edited is pictured again after so long [ms]. */
const EVERY_MS = 2000;

/** The middle of a canvas as a small picture's data URL; to be asked in the same turn as the canvas was drawn in. */
export function pictureOf(canvas: HTMLCanvasElement): string | null {
  const small = document.createElement("canvas");
  [small.width, small.height] = [WIDTH, HEIGHT];
  const scale = Math.max(WIDTH / canvas.width, HEIGHT / canvas.height);
  const [width, height] = [WIDTH / scale, HEIGHT / scale];
  const drawing = small.getContext("2d");
  if (!drawing || !(width > 0 && height > 0)) return null;
  drawing.drawImage(canvas, (canvas.width - width) / 2, (canvas.height - height) / 2, width, height, 0, 0, WIDTH, HEIGHT);
  return small.toDataURL("image/webp", 0.8);
}

/** Says of which home a picture is wanted now, so that few are taken. */
export class PictureClock {
  #last: { readonly home: string; readonly at: number } | null = null;
  #isStale = false;

  /** What is shown has changed. */
  changed(): void {
    this.#isStale = true;
  }

  /** Whether this home is to be pictured now. */
  isDue(home: string | null, now: number): home is string {
    if (home === null || !this.#isStale) return false;
    if (this.#last?.home === home && now - this.#last.at < EVERY_MS) return false;
    this.#last = { home, at: now };
    this.#isStale = false;
    return true;
  }
}
