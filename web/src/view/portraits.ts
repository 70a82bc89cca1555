/** Small pictures of things by themselves, drawn on the canvas just before a frame and copied from there: no second renderer. */
import { PerspectiveCamera, Scene, Vector2, type Object3D, type WebGLRenderer } from "three";
import { lampUniforms } from "../house/lamps";
import { frame, type Preset, type Vector } from "./cameras";
import type { Daylight } from "./daylight";

/** What is pictured: made when its turn comes, and given back after. */
export interface Sitter {
  readonly root: Object3D;
  /** What must be in view. */
  readonly outline: readonly Vector[];
  readonly preset: Preset;
  dispose(): void;
}

interface Wish {
  readonly make: () => Sitter | null;
  readonly into: HTMLCanvasElement;
}

/** At most so many before one frame. */
const AT_ONCE = 6;

export class Portraits {
  readonly #wishes: Wish[] = [];
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera(30, 1, 0.05, 200);

  constructor(readonly renderer: WebGLRenderer, readonly daylight: Daylight) {}

  /** Wishes for a picture, as large as a canvas. */
  want(make: () => Sitter | null, into: HTMLCanvasElement): void {
    this.#wishes.push({ make, into });
  }

  /** Whether more are wished for. */
  get waits(): boolean {
    return this.#wishes.length > 0;
  }

  /** Draws the next ones; the canvas must be drawn on anew in the same turn. */
  take(): void {
    const wishes = this.#wishes.splice(0, AT_ONCE);
    if (wishes.length === 0) return;
    const [{ renderer, daylight }, home] = [this, this.daylight.root.parent];
    const [size, casts] = [renderer.getSize(new Vector2()), renderer.shadowMap.needsUpdate];
    renderer.shadowMap.needsUpdate = false;
    const lit = lampUniforms.lampLight.value;
    lampUniforms.lampLight.value = 0; // they stand in no room
    this.#scene.add(daylight.root);
    daylight.showGround(false);
    renderer.setScissorTest(true);
    for (const wish of wishes) this.#draw(wish);
    lampUniforms.lampLight.value = lit;
    renderer.setScissorTest(false);
    renderer.setViewport(0, 0, size.x, size.y);
    daylight.showGround(true);
    home?.add(daylight.root);
    renderer.shadowMap.needsUpdate = casts;
  }

  #draw({ make, into }: Wish): void {
    const sitter = make();
    const { domElement: canvas } = this.renderer;
    const [width, height] = [Math.min(into.width, canvas.width), Math.min(into.height, canvas.height)];
    if (!sitter || width === 0 || height === 0) return;
    const ratio = this.renderer.getPixelRatio();
    const { eye, target, fov } = frame(sitter.outline, sitter.preset, { aspect: width / height });
    Object.assign(this.#camera, { fov, aspect: width / height });
    this.#camera.position.set(...eye);
    this.#camera.lookAt(...target);
    this.#camera.updateProjectionMatrix();
    this.#scene.add(sitter.root);
    this.renderer.setViewport(0, 0, width / ratio, height / ratio);
    this.renderer.setScissor(0, 0, width / ratio, height / ratio);
    this.renderer.render(this.#scene, this.#camera);
    sitter.dispose();
    const picture = into.getContext("2d");
    picture?.clearRect(0, 0, into.width, into.height);
    picture?.drawImage(canvas, 0, canvas.height - height, width, height, 0, 0, into.width, into.height);
  }
}
