/** A picture beneath the plan, to trace: scaled by one length that is known. */
import type { Point } from "./corners";
import type { Picture } from "./sheet";
import { say } from "../words/language";

/** How wide a plan in a picture is taken to be until its scale is set [mm]. */
const LIKELY_WIDTH = 12_000;
const OPACITY = 0.5;

export class PictureBeneath {
  #picture: Picture | null = null;
  measured: readonly Point[] = [];

  get picture(): Picture | null {
    return this.#picture;
  }

  /** Lays a file's picture beneath the plan; refuses what is none. */
  async lay(file: File): Promise<void> {
    const url = URL.createObjectURL(file);
    const image = new Image();
    image.src = url;
    try {
      await image.decode();
    } catch {
      URL.revokeObjectURL(url);
      throw new Error(say("{file} is no picture that can be shown.", { file: file.name }));
    }
    this.remove();
    this.#picture = { url, width: image.naturalWidth, height: image.naturalHeight, scale: LIKELY_WIDTH / image.naturalWidth, opacity: OPACITY };
  }

  /** The length that is to be told: that of the line between the measured points, where there is one, else the picture's width [mm]. */
  get length(): number {
    const [a, b] = this.measured;
    return a && b ? Math.hypot(a.x - b.x, a.z - b.z) : (this.#picture?.width ?? 0) * (this.#picture?.scale ?? 0);
  }

  /** Makes that as long as it is known to be [mm]; false where it is none. */
  setScale(length: number): boolean {
    const drawn = this.length;
    if (!this.#picture || drawn === 0 || !(length > 0)) return false;
    const factor = length / drawn;
    this.#picture = { ...this.#picture, scale: this.#picture.scale * factor };
    this.measured = this.measured.map(({ x, z }) => ({ x: x * factor, z: z * factor }));
    return true;
  }

  fade(opacity: number): void {
    if (this.#picture) this.#picture = { ...this.#picture, opacity };
  }

  remove(): void {
    if (this.#picture) URL.revokeObjectURL(this.#picture.url);
    this.#picture = null;
    this.measured = [];
  }
}
