/** The canvas: renderer, lights, camera. Draws a frame only when something asks for one. */
import { Box3, MOUSE, NeutralToneMapping, PerspectiveCamera, Raycaster, Scene, TOUCH, Vector2, Vector3, type Object3D, type WebGLRenderer } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { timed } from "../timing";
import { blend, frame, plus, PRESETS, windowOf, type Framing, type PresetName, type Vector } from "./cameras";
import { Daylight, GROUND_REACH } from "./daylight";
import { Orbiting, type OrbitStep } from "./orbiting";
import { Overlaid } from "./overlaid";
import { Picturing } from "./picturing";
import { Portraits, type Sitter } from "./portraits";
import { rendererForMachine } from "./renderer";
import { gazeOf, type Pose } from "./walk";

/** Moves something by the seconds since the last frame; false when it has arrived. */
export type Motion = (seconds: number) => boolean;

const FLIGHT_SECONDS = 0.6;
/** After a long frame things go on from where they were rather than jump [s]. */
const LONGEST_STEP = 0.25;
const SHORT_STEP = 1 / 60;
/** How fast a turned house comes to rest, by time and not by frames: slow machines must not turn for longer [1/s]. */
const DAMPING = 8;
/** At eye height much is near and at the sides. */
export const WALK_FOV = 65;
const WALK_NEAR = 0.05;
/** Who walks looks at what is this far ahead [m]; leaving, the camera turns about it. */
const WALK_REACH = 3;
/** How far a sheet is moved where a house would be turned [CSS pixels/rad]. */
const FLAT_STEP = 350;
/** How near the camera comes to what it turns about [m], and how far it goes, in house radii. */
const NEAREST = 0.5;
const FARTHEST = 100;

function calm(): boolean {
  return window.matchMedia("(prefers-reduced-motion: reduce)").matches;
}

export class Viewport {
  readonly canvas: HTMLCanvasElement;
  readonly camera = new PerspectiveCamera(30, 1, 0.1, 500);
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #controls: OrbitControls;
  readonly #orbiting: Orbiting;
  readonly daylight = new Daylight();
  readonly #portraits: Portraits;
  readonly picturing: Picturing;
  readonly #motions = new Set<Motion>();
  readonly #afterFrame: (() => void)[] = [];
  /** What a preset brings into view. */
  #outline: readonly Vector[] = [[0, 0, 0], [20, 1, 15]];
  #bounds = new Box3(new Vector3(0, 0, 0), new Vector3(20, 1, 15));
  #preset: PresetName | null = "corner";
  #isFlat = false;
  /** Where the last flight leads. */
  #goal: Framing | null = null;
  /** Where flights out from under a cover have led, and how it was looked before them. */
  #aside: { readonly goal: Framing; readonly preset: PresetName | null; readonly from: Framing } | null = null;
  /** Who walks; the camera is theirs. */
  #walker: Pose | null = null;
  #size = { width: 1, height: 1 };
  readonly #from = new Vector3();
  /** Of the window, when the canvas was last fitted to it. */
  #ratio = 0;
  /** Whether there has been anything to draw. */
  #isEmpty = true;
  /** Frames drawn since the page was opened: an idle page draws none. */
  #frames = 0;
  #asked = false;
  /** Whether nothing moved before the frame under way. */
  #resting = true;
  #last = 0;
  /** Whether something was added since the last frame. */
  #new = false;
  readonly overlaid = new Overlaid();

  constructor(readonly host: HTMLElement) {
    this.#renderer = rendererForMachine();
    // Asking for a shader's log waits until it is made.
    this.#renderer.debug.checkShaderErrors = import.meta.env.DEV;
    this.#renderer.toneMapping = NeutralToneMapping;
    this.#renderer.toneMappingExposure = 1;
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.autoUpdate = false;
    this.#portraits = new Portraits(this.#renderer, this.daylight);
    this.picturing = new Picturing(this.#renderer, this.#scene, this.camera, () => {
      this.#renderer.setSize(this.#size.width, this.#size.height);
      this.invalidate();
    });
    host.prepend((this.canvas = this.#renderer.domElement));
    this.canvas.addEventListener("webglcontextrestored", () => this.castShadows()); // the card was taken away, and nothing is left on it
    this.#scene.add(this.daylight.root);
    this.camera.rotation.order = "YXZ";
    this.#controls = this.#orbit();
    this.#orbiting = new Orbiting(this.#controls);
    new ResizeObserver(() => { if (this.#resize()) this.#draw(performance.now()); }).observe(host); // in this very frame: a canvas of a new size is empty
    this.#resize();
  }

  #orbit(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = true;
    controls.maxPolarAngle = Math.PI * 0.49;
    controls.minDistance = NEAREST;
    controls.zoomToCursor = true;
    controls.addEventListener("change", () => this.invalidate());
    controls.addEventListener("start", () => this.#takeOver());
    return controls;
  }

  /** The person's hand moves the camera: what else did ends. */
  #takeOver(): void {
    [this.#preset, this.#goal] = [null, null];
    this.#orbiting.stop();
  }

  /** Turns the house, tilts it, comes nearer or looks aside by a step, on from those under way. */
  orbit(step: OrbitStep): void {
    if (this.#walker) return;
    [this.#preset, this.#goal] = [null, null];
    const { right = 0, up = 0, ...aside } = step;
    const asked = this.#isFlat ? { east: right * FLAT_STEP, north: up * FLAT_STEP, ...aside } : step;
    if (this.#orbiting.ask(asked)) this.move(this.#orbits);
  }

  /** One for all steps: a motion asked for again goes on. */
  readonly #orbits: Motion = (seconds) => this.#orbiting.step(calm() ? Number.POSITIVE_INFINITY : seconds);

  /** Looks at a sheet that lies beneath: drags move it, nothing turns, and no ground hides it. */
  flatten(isFlat: boolean): void {
    this.#isFlat = isFlat;
    this.#controls.enableRotate = !isFlat;
    this.#controls.mouseButtons.LEFT = isFlat ? MOUSE.PAN : MOUSE.ROTATE;
    this.#controls.touches.ONE = isFlat ? TOUCH.PAN : TOUCH.ROTATE;
    this.daylight.showGround(!isFlat);
    this.castShadows();
  }

  /** Shows something new, of which presets show these points, and which reaches up to `top` [m]; the shadows are cast anew. */
  add(root: Object3D, bounds: Box3, outline: readonly Vector[], top: number): void {
    this.#scene.add(root);
    this.#bounds = bounds;
    this.#outline = outline;
    this.#controls.maxDistance = FARTHEST * bounds.getSize(new Vector3()).length();
    this.daylight.around(bounds, top);
    [this.#new, this.#isEmpty] = [true, false];
    this.castShadows();
  }

  /** Has the shaders made with which something will be drawn, without waiting for them. */
  prepare(root: Object3D): void {
    this.#renderer.compile(root, this.camera, this.#scene);
  }

  /** Draws something by itself onto a small canvas, before one of the next frames. */
  portray(make: () => Sitter | null, into: HTMLCanvasElement): void {
    this.#portraits.want(make, into);
    this.invalidate();
  }

  /** Keeps the camera still while something is held. */
  hold(held: boolean): void { this.#controls.enabled = !held; }

  castShadows(): void {
    this.#renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  /** Looks at the house in one of the presets, flying there unless told to jump. */
  look(preset: PresetName, jump = false): void {
    const goal = frame(this.#outline, PRESETS[preset], windowOf(this.#size, document.querySelector<HTMLElement>(".views")));
    this.#preset = preset;
    this.#fly(goal, jump);
  }

  /** Flies sideways until a point is in the middle of what is not covered at the right [CSS pixels], looking the same way from as far. */
  centre(at: Vector, covered = 0): void {
    if (this.#walker) return;
    const { eye, target, fov } = this.#framing;
    const aside = (Math.hypot(...plus(eye, target, -1)) * Math.tan((fov * Math.PI) / 360) * covered) / this.#size.height;
    const middle = plus(at, new Vector3().setFromMatrixColumn(this.camera.matrix, 0).toArray(), aside);
    const goal = { eye: plus(eye, plus(middle, target, -1)), target: middle, fov };
    const before = this.#aside?.goal === this.#goal ? this.#aside : { preset: this.#preset, from: this.#framing };
    this.#aside = covered > 0 ? { ...before, goal } : null;
    this.#preset = null;
    this.#fly(goal);
  }

  /** Flies back to before a point came out from under what covered it, unless something else has moved the view since. */
  back(): void {
    if (!this.#aside || this.#aside.goal !== this.#goal) return;
    if (this.#aside.preset) this.look(this.#aside.preset);
    else this.#fly(this.#aside.from);
  }

  get #framing(): Framing { return { eye: this.camera.position.toArray(), target: this.#controls.target.toArray(), fov: this.camera.fov }; }

  /** Flies to a framing, unless another flight or the person's hand takes over. */
  #fly(goal: Framing, jump = false): void {
    const from = this.#framing;
    this.#orbiting.stop();
    this.#goal = goal;
    this.#surround(null);
    this.#controls.enabled = true;
    if (jump || calm()) {
      this.#aim(goal);
      return;
    }
    let flown = 0;
    this.move((seconds) => {
      if (this.#goal !== goal) return false;
      flown = Math.min(1, flown + seconds / FLIGHT_SECONDS);
      this.#aim(blend(from, goal, flown * flown * (3 - 2 * flown)));
      return flown < 1;
    });
  }

  /** Looks from where somebody stands; a preset leaves. */
  stand(pose: Pose): void {
    this.#takeOver();
    this.#surround(pose);
    this.#controls.enabled = false;
    this.camera.fov = WALK_FOV;
    this.camera.position.set(...pose.eye);
    this.camera.rotation.set(pose.pitch, pose.yaw, 0);
    this.#controls.target.copy(this.camera.position).addScaledVector(new Vector3(...gazeOf(pose)), WALK_REACH);
    this.invalidate();
  }

  /** Who walks sees sky and grass through the windows; from outside a house stands on the page. */
  #surround(walker: Pose | null): void {
    if ((walker === null) !== (this.#walker === null)) this.castShadows();
    this.#walker = walker;
    this.#scene.background = walker ? this.daylight.sky : null;
    this.daylight.sow(walker !== null);
  }

  #aim(framing: Framing): void {
    this.camera.fov = framing.fov;
    this.camera.position.set(...framing.eye);
    this.#controls.target.set(...framing.target);
    this.camera.updateProjectionMatrix();
    this.#controls.update();
    this.invalidate();
  }

  /** Runs a motion once a frame until it has arrived. */
  move(motion: Motion): void {
    this.#motions.add(motion);
    this.invalidate();
  }

  /** Runs a motion that only shows how something comes about: who wants nothing to move sees its end at once. */
  glide(motion: Motion): void { this.move((seconds) => motion(calm() ? Number.POSITIVE_INFINITY : seconds)); }

  /** Called after every frame: what follows the camera, such as labels. */
  onFrame(listener: () => void): void {
    this.#afterFrame.push(listener);
  }

  /** Asks for one frame. */
  invalidate(): void {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame((now) => { if (this.#asked) this.#draw(now); });
  }

  #draw(now: number): void {
    if (this.#new) this.#resize(); // what is said of a new home may have moved the canvas: found out after this frame, that would take another
    const seconds = this.#resting ? SHORT_STEP : Math.min(LONGEST_STEP, Math.max(0, (now - this.#last) / 1000));
    this.#last = now;
    this.#controls.dampingFactor = 1 - Math.exp(-seconds * DAMPING);
    for (const motion of this.#motions) if (!motion(seconds)) this.#motions.delete(motion);
    this.#asked = false; // what a motion asks for, this very frame shows
    if (!this.#walker) this.#controls.update();
    this.#clip();
    const isDrawnOver = this.#portraits.waits;
    this.#portraits.take();
    if (isDrawnOver || !this.#isEmpty) this.#render();
    this.#frames += 1;
    for (const listener of this.#afterFrame) listener();
    if (this.#motions.size > 0 || this.#portraits.waits) this.invalidate();
    this.#resting = !this.#asked;
  }

  #render(): void {
    const render = (): void => this.#renderer.render(this.#scene, this.camera);
    if (this.#new) timed("house drawn", render);
    else render();
    this.#new = false;
  }

  /** Keeps the depth range tight around the house: from far away a millimetre must still be told apart. */
  #clip(): void {
    const centre = this.#bounds.getCenter(new Vector3());
    const radius = this.#bounds.getSize(new Vector3()).length() / 2 + 4;
    const distance = this.camera.position.distanceTo(centre);
    // The ground before the house is nearer than the house.
    this.camera.near = this.#walker ? WALK_NEAR : Math.max(0.1, (distance - radius) / 2);
    this.camera.far = distance + radius * GROUND_REACH;
    this.camera.updateProjectionMatrix();
  }

  /** Fits the canvas to its host; tells whether it was of another size. */
  #resize(): boolean {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0 || (width === this.#size.width && height === this.#size.height && window.devicePixelRatio === this.#ratio)) return false;
    this.#size = { width, height };
    this.#ratio = window.devicePixelRatio;
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.#renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.#preset) this.look(this.#preset, true);
    return true;
  }

  /** Who walks, and looks from where; null from outside. */
  get pose(): Pose | null { return this.#walker; }

  /** Of the canvas [CSS pixels], read without asking the page for its layout. */
  get size(): { readonly width: number; readonly height: number } { return this.#size; }

  /** The ray under a point of the window [CSS pixels]. */
  rayAt(clientX: number, clientY: number): Raycaster {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return this.#rayThrough(((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2);
  }

  /** The ray in the middle of the view. */
  rayAhead(): Raycaster { return this.#rayThrough(0, 0); }

  #rayThrough(right: number, up: number): Raycaster {
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(right, up), this.camera);
    return ray;
  }

  /** Where a point of the house is seen [CSS pixels of the host], or null behind the camera. */
  project(point: Vector3): { x: number; y: number } | null {
    const seen = point.clone().project(this.camera);
    if (seen.z > 1) return null;
    return { x: ((seen.x + 1) / 2) * this.#size.width, y: ((1 - seen.y) / 2) * this.#size.height };
  }

  /** The way from what is looked at to the eye [m]. */
  get seenFrom(): Vector3 { return this.#from.subVectors(this.camera.position, this.#controls.target); }

  /** How far north is turned clockwise from the top of the screen [rad]. */
  get heading(): number { return this.#walker?.yaw ?? this.#controls.getAzimuthalAngle(); }

  /** What the canvas costs and where it looks from. */
  get state() {
    const { render, memory } = this.#renderer.info;
    return {
      frames: this.#frames,
      moving: this.#motions.size > 0 || this.#asked,
      drawCalls: render.calls,
      geometries: memory.geometries,
      eye: this.camera.position.toArray(),
      target: this.#controls.target.toArray(),
      walking: this.#walker !== null,
    };
  }
}
