/** A picture of each home as it was last seen, taken from frames that are drawn anyway. */

const WIDTH = 216;
const HEIGHT = 135;
/** A home that is edited is pictured again after so long [ms]. */
const EVERY_MS = 2000;

/** How often it is looked whether a frame is drawn [ms]. */
const LOOK_MS = 50;

/** What a canvas shows, from its foot up, once it is drawn: who reads at once waits for that, as long as a processor draws. Null where it is lost. */
async function drawn(gl: WebGL2RenderingContext): Promise<ImageData | null> {
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const [buffer, bytes] = [gl.createBuffer(), width * height * 4];
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.bufferData(gl.PIXEL_PACK_BUFFER, bytes, gl.STREAM_READ);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, 0);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  while (fence && !gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED) await new Promise((done) => setTimeout(done, LOOK_MS));
  if (!fence || gl.isContextLost()) return null;
  const pixels = new Uint8ClampedArray(bytes);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, buffer);
  gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, pixels);
  gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
  gl.deleteBuffer(buffer);
  gl.deleteSync(fence);
  return new ImageData(pixels, width, height);
}

/** The middle of a canvas as a small picture's data URL; to be asked in the same turn as the canvas was drawn in. */
export async function pictureOf(canvas: HTMLCanvasElement): Promise<string | null> {
  const gl = canvas.getContext("webgl2");
  const small = document.createElement("canvas");
  [small.width, small.height] = [WIDTH, HEIGHT];
  const drawing = small.getContext("2d");
  const seen = gl && drawing && canvas.width > 0 && canvas.height > 0 ? await drawn(gl) : null;
  if (!seen || !drawing) return null;
  const upright = await createImageBitmap(seen, { imageOrientation: "flipY" });
  const scale = Math.max(WIDTH / seen.width, HEIGHT / seen.height);
  const [width, height] = [WIDTH / scale, HEIGHT / scale];
  drawing.drawImage(upright, (seen.width - width) / 2, (seen.height - height) / 2, width, height, 0, 0, WIDTH, HEIGHT);
  upright.close();
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
