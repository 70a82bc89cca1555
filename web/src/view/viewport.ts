/** The canvas: renderer, lights, camera. Draws a frame only when something asks for one. */
import {
  Box3, Color, DirectionalLight, HemisphereLight, NeutralToneMapping, PCFShadowMap, PerspectiveCamera, Raycaster, Scene,
  Vector2, Vector3, WebGLRenderer, type Object3D,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { blend, frame, plus, PRESETS, type Framing, type PresetName, type Vector } from "./cameras";

/** Moves something by the seconds since the last frame; false when it has arrived. */
export type Motion = (seconds: number) => boolean;

const BACKGROUND = "#10141b";
const FLIGHT_SECONDS = 0.6;
/** After a long frame things go on from where they were rather than jump [s]. */
const LONGEST_STEP = 0.25;
const SHORT_STEP = 1 / 60;
/** How fast a turned house comes to rest, by time and not by frames: slow machines must not turn for longer [1/s]. */
const DAMPING = 8;
const SUN = new Vector3(-0.55, 1, 0.5);

function calm(): boolean {
  return window.matchMedia("(prefers-reduced-motion: reduce)").matches;
}

export class Viewport {
  readonly canvas: HTMLCanvasElement;
  readonly camera = new PerspectiveCamera(30, 1, 0.1, 500);
  readonly #renderer: WebGLRenderer;
  readonly #scene = new Scene();
  readonly #controls: OrbitControls;
  readonly #sun = new DirectionalLight("#fff4e2", 2.3);
  readonly #motions = new Set<Motion>();
  readonly #afterFrame: (() => void)[] = [];
  #bounds = new Box3(new Vector3(0, 0, 0), new Vector3(20, 1, 15));
  #preset: PresetName | null = "corner";
  /** Where the last flight leads. */
  #goal: Framing | null = null;
  /** Frames drawn since the page was opened: an idle page draws none. */
  #frames = 0;
  #asked = false;
  /** Whether nothing moved before the frame under way. */
  #resting = true;
  #last = 0;

  constructor(readonly host: HTMLElement) {
    this.#renderer = new WebGLRenderer({ antialias: true, powerPreference: "low-power" });
    this.#renderer.toneMapping = NeutralToneMapping;
    this.#renderer.toneMappingExposure = 1;
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = PCFShadowMap;
    this.#renderer.shadowMap.autoUpdate = false;
    this.canvas = this.#renderer.domElement;
    host.prepend(this.canvas);
    this.#scene.background = new Color(BACKGROUND);
    this.#light();
    this.#controls = this.#orbit();
    new ResizeObserver(() => this.#resize()).observe(host);
    this.#resize();
  }

  #light(): void {
    this.#sun.castShadow = true;
    this.#sun.shadow.mapSize.set(2048, 2048);
    this.#sun.shadow.radius = 4;
    this.#sun.shadow.intensity = 0.7;
    this.#sun.shadow.normalBias = 0.03;
    this.#sun.shadow.bias = -0.0004;
    const fill = new DirectionalLight("#d5e3ff", 0.8);
    fill.position.set(1, 0.7, -0.4);
    this.#scene.add(new HemisphereLight("#f4f6ff", "#a09588", 2.3), this.#sun, this.#sun.target, fill);
  }

  #orbit(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = true;
    controls.maxPolarAngle = Math.PI * 0.49;
    controls.zoomToCursor = true;
    controls.addEventListener("change", () => this.invalidate());
    controls.addEventListener("start", () => { [this.#preset, this.#goal] = [null, null]; });
    return controls;
  }

  /** Shows something new; the shadows are cast anew. */
  add(root: Object3D, bounds: Box3): void {
    this.#scene.add(root);
    this.#bounds = bounds;
    this.#aimSun();
    this.castShadows();
  }

  /** Keeps the camera still while something is held. */
  hold(held: boolean): void {
    this.#controls.enabled = !held;
  }

  castShadows(): void {
    this.#renderer.shadowMap.needsUpdate = true;
    this.invalidate();
  }

  #aimSun(): void {
    const centre = this.#bounds.getCenter(new Vector3());
    const radius = this.#bounds.getSize(new Vector3()).length() / 2 + 1;
    this.#sun.target.position.copy(centre);
    this.#sun.position.copy(centre).addScaledVector(SUN.clone().normalize(), radius * 2);
    const camera = this.#sun.shadow.camera;
    Object.assign(camera, { left: -radius, right: radius, top: radius, bottom: -radius, near: radius * 0.5, far: radius * 3.5 });
    camera.updateProjectionMatrix();
  }

  /** Looks at the house in one of the presets, flying there unless told to jump. */
  look(preset: PresetName, jump = false): void {
    const goal = frame({ min: this.#bounds.min.toArray(), max: this.#bounds.max.toArray() }, PRESETS[preset], this.camera.aspect);
    this.#preset = preset;
    this.#fly(goal, jump);
  }

  /** Flies sideways until a point is in the middle, looking the same way from as far. */
  centre(at: Vector): void {
    const { eye, target, fov } = this.#framing;
    this.#preset = null;
    this.#fly({ eye: plus(eye, plus(at, target, -1)), target: at, fov });
  }

  get #framing(): Framing {
    return { eye: this.camera.position.toArray(), target: this.#controls.target.toArray(), fov: this.camera.fov };
  }

  /** Flies to a framing, unless another flight or the person's hand takes over. */
  #fly(goal: Framing, jump = false): void {
    const from = this.#framing;
    this.#goal = goal;
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

  /** Called after every frame: what follows the camera, such as labels. */
  onFrame(listener: () => void): void {
    this.#afterFrame.push(listener);
  }

  /** Asks for one frame. */
  invalidate(): void {
    if (this.#asked) return;
    this.#asked = true;
    requestAnimationFrame((now) => this.#draw(now));
  }

  #draw(now: number): void {
    this.#asked = false;
    const seconds = this.#resting ? SHORT_STEP : Math.min(LONGEST_STEP, Math.max(0, (now - this.#last) / 1000));
    this.#last = now;
    this.#controls.dampingFactor = 1 - Math.exp(-seconds * DAMPING);
    for (const motion of this.#motions) if (!motion(seconds)) this.#motions.delete(motion);
    this.#controls.update();
    this.#clip();
    this.#renderer.render(this.#scene, this.camera);
    this.#frames += 1;
    for (const listener of this.#afterFrame) listener();
    if (this.#motions.size > 0) this.invalidate();
    this.#resting = !this.#asked;
  }

  /** Keeps the depth range tight around the house: from far away a millimetre must still be told apart. */
  #clip(): void {
    const centre = this.#bounds.getCenter(new Vector3());
    const radius = this.#bounds.getSize(new Vector3()).length() / 2 + 4;
    const distance = this.camera.position.distanceTo(centre);
    this.camera.near = Math.max(0.1, distance - radius);
    this.camera.far = distance + radius;
    this.camera.updateProjectionMatrix();
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.host;
    if (width === 0 || height === 0) return;
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.#renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.#preset) this.look(this.#preset, true);
    this.invalidate();
  }

  /** The ray under a point of the window [CSS pixels]. */
  rayAt(clientX: number, clientY: number): Raycaster {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const at = new Vector2(((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2);
    const ray = new Raycaster();
    ray.setFromCamera(at, this.camera);
    return ray;
  }

  /** Where a point of the house is seen [CSS pixels of the host], or null behind the camera. */
  project(point: Vector3): { x: number; y: number } | null {
    const seen = point.clone().project(this.camera);
    if (seen.z > 1) return null;
    return { x: ((seen.x + 1) / 2) * this.host.clientWidth, y: ((1 - seen.y) / 2) * this.host.clientHeight };
  }

  /** Draws a frame with its shadows and one without them; returns what each costs. */
  cost() {
    const { info, shadowMap } = this.#renderer;
    const drawn = (shadows: boolean): { calls: number; triangles: number } => {
      shadowMap.needsUpdate = shadows;
      this.#renderer.render(this.#scene, this.camera);
      return { calls: info.render.calls, triangles: info.render.triangles };
    };
    const [all, shown] = [drawn(true), drawn(false)];
    return { drawCalls: shown.calls, triangles: shown.triangles, shadowCalls: all.calls - shown.calls };
  }

  /** How far north is turned clockwise from the top of the screen [rad]. */
  get heading(): number {
    return this.#controls.getAzimuthalAngle();
  }

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
    };
  }
}
