/** Pictures of what is in view, and what drawing it costs: both draw beside the frames that are seen. */
import { Color, type PerspectiveCamera, type Scene, type WebGLRenderer } from "three";

export class Picturing {
  /** `restore` makes the canvas and what lies behind the house as they were. */
  constructor(readonly renderer: WebGLRenderer, readonly scene: Scene, readonly camera: PerspectiveCamera, readonly restore: () => void) {}

  /** What is in view as a picture of its own size, PNG; what the canvas shows is all in it. */
  png(width: number, height: number, ground: string): Promise<Blob | null> {
    const { domElement: canvas } = this.renderer;
    return this.#drawn(width, height, ground, () => new Promise((done) => { canvas.toBlob(done, "image/png"); }));
  }

  /** Draws what is in view on white paper, at once: a printer does not wait. */
  printOn(paper: HTMLCanvasElement): void {
    this.#drawn(paper.width, paper.height, "white", () => paper.getContext("2d")?.drawImage(this.renderer.domElement, 0, 0));
  }

  /** Draws what is in view in another size, and takes it before the canvas is as it was. */
  #drawn<Taken>(width: number, height: number, ground: string, take: () => Taken): Taken {
    const [ratio, { aspect, fov }, { background }] = [this.renderer.getPixelRatio(), this.camera, this.scene];
    const wide = Math.max(1, (aspect * height) / width);
    this.renderer.setPixelRatio(1);
    this.renderer.setSize(width, height, false);
    this.#aim(width / height, (Math.atan(Math.tan((fov * Math.PI) / 360) * wide) * 360) / Math.PI);
    this.scene.background ??= new Color(ground);
    this.renderer.render(this.scene, this.camera);
    this.scene.background = background;
    const taken = take();
    this.renderer.setPixelRatio(ratio);
    this.#aim(aspect, fov);
    this.restore();
    return taken;
  }

  #aim(aspect: number, fov: number): void {
    Object.assign(this.camera, { aspect, fov });
    this.camera.updateProjectionMatrix();
  }

  /** Draws a frame with its shadows and one without them; returns what each costs. */
  cost(): { drawCalls: number; triangles: number; shadowCalls: number } {
    const { info, shadowMap } = this.renderer;
    const drawn = (shadows: boolean): { calls: number; triangles: number } => {
      shadowMap.needsUpdate = shadows;
      this.renderer.render(this.scene, this.camera);
      return { calls: info.render.calls, triangles: info.render.triangles };
    };
    const [all, shown] = [drawn(true), drawn(false)];
    return { drawCalls: shown.calls, triangles: shown.triangles, shadowCalls: all.calls - shown.calls };
  }
}
