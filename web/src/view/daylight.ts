/** The sun with its shadows, the light of the sky, and the ground around the house: grass to who walks, else the shadows alone. */
import {
  Box3, BufferGeometry, Color, DirectionalLight, Float32BufferAttribute, Group, HemisphereLight, Matrix4, Mesh, MeshLambertMaterial, PlaneGeometry, ShadowMaterial, Vector3,
} from "three";

const GRASS = "#8a9d74";
/** The hour that a home is shown at first, and when the sun stands highest and in the south; how fast it goes round. */
export const FIRST_HOUR = 15;
const NOON = 12;
const TURN = (16 * Math.PI) / 180;
const HIGHEST = Math.sin((75 * Math.PI) / 180);
/** From noon until it sets. */
const HALF_DAY = 8;
/** Light at noon, and when the sun is about to set: what falls from it, from the sky and from the side, and how the sky is seen. */
const HIGH = { sun: new Color("#fff4e2"), strength: 2.2, sky: 2.5, side: 0.8, seen: new Color("#b9c8d6") };
const LOW = { sun: new Color("#ffae66"), strength: 1.5, sky: 1.1, side: 0.4, seen: new Color("#8a7f92") };
/** The sine of the height over the horizon from which on light is as at noon. */
const FULL = 0.7;
/** From which share of the light of noon on lamps are lit, and from which on they are as bright as they grow. */
const [DUSK, DARK] = [0.85, 0.35];
/** Across the sun's rays, from side to side and from low to high: a house is seen from up there longer than deep. */
const SHADOW_PIXELS = [2048, 1024] as const;
/** To who walks, a shadow's edge is as near as a wall. */
const NEAR_SHADOW_PIXELS = [4096, 2048] as const;
/** How far beyond the floors things stand or overhang [m]. */
const MARGIN = 0.5;
/** Under the floors: a house stands a little above its ground [m]. */
const GROUND = -0.12;
const SECTORS = 48;
/** Rings of ground in house radii, and how solid it is there: it fades into the sky. */
const RINGS: readonly (readonly [number, number])[] = [[0, 1], [1, 0.95], [1.5, 0.65], [2.2, 0.3], [3.4, 0]];
/** How far ground is seen, in house radii. */
export const GROUND_REACH = 3.4;

/** Where the sun stands at an hour: it rises in the east and sets in the west. */
export function sunAt(hour: number): Vector3 {
  const height = Math.asin(HIGHEST * Math.cos((((hour - NOON) / HALF_DAY) * Math.PI) / 2));
  const turn = (hour - NOON) * TURN;
  return new Vector3(-Math.sin(turn) * Math.cos(height), Math.sin(height), Math.cos(turn) * Math.cos(height));
}

function groundGeometry(): BufferGeometry {
  const { r, g, b } = new Color(GRASS);
  const points = RINGS.flatMap(([radius, solid]) => Array.from({ length: SECTORS }, (_, i) => {
    const angle = (i / SECTORS) * 2 * Math.PI;
    return { at: [Math.cos(angle) * radius, 0, Math.sin(angle) * radius], color: [r, g, b, solid] };
  }));
  const index = RINGS.slice(1).flatMap((_, ring) => Array.from({ length: SECTORS }, (_sector, i) => {
    const [near, next] = [ring * SECTORS + i, ring * SECTORS + ((i + 1) % SECTORS)];
    const [far, beyond] = [near + SECTORS, next + SECTORS];
    return [near, next, far, next, beyond, far];
  }).flat());
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(points.flatMap(({ at }) => at), 3));
  geometry.setAttribute("normal", new Float32BufferAttribute(points.flatMap(() => [0, 1, 0]), 3));
  geometry.setAttribute("color", new Float32BufferAttribute(points.flatMap(({ color }) => color), 4));
  geometry.setIndex(index);
  return geometry;
}

/** Black is black, however bright the rest is shown: no pixel works that out. */
function groundShade(): ShadowMaterial {
  const material = new ShadowMaterial({ opacity: 0.22, depthWrite: false, toneMapped: false });
  material.onBeforeCompile = (shader) => { shader.fragmentShader = shader.fragmentShader.replace("#include <colorspace_fragment>", ""); };
  return material;
}

/** How a house and its trees lie before the sun, which looks at the house's middle: across its rays. */
function seenBySun({ min, max }: Box3, top: number, centre: Vector3, sun: Vector3): Box3 {
  const away = new Matrix4().lookAt(sun, new Vector3(), new Vector3(0, 1, 0)).invert();
  const corners = [min.x, max.x].flatMap((x) => [min.y + GROUND, top].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z))));
  return new Box3().setFromPoints(corners.map((corner) => corner.sub(centre).applyMatrix4(away))).expandByScalar(MARGIN);
}

/** The ground on which a house and its trees lie, and where their shadows fall. */
function shadedBy(bounds: Box3, top: number, sun: Vector3): Box3 {
  const shadow = sun.clone().multiplyScalar((bounds.min.y + GROUND - top) / sun.y);
  const house = bounds.clone().expandByScalar(MARGIN);
  return house.union(house.clone().translate(shadow));
}

export class Daylight {
  readonly root = new Group();
  readonly #sun = new DirectionalLight();
  readonly #sky = new HemisphereLight("#f4f6ff", "#b8aea2");
  /** The sky, to who looks at it. */
  readonly sky = HIGH.seen.clone();
  /** How bright lamps are, from 0 on. */
  lamps = 0;
  readonly #side = new DirectionalLight("#d5e3ff", HIGH.side);
  #direction = sunAt(FIRST_HOUR);
  #lit: readonly [bounds: Box3, top: number] | null = null;
  readonly #grass = new Mesh(groundGeometry(), new MeshLambertMaterial({ vertexColors: true, transparent: true, depthWrite: false }));
  /** As large as shadows reach: every pixel of it costs. */
  readonly #shadows = new Mesh(new PlaneGeometry(1, 1).rotateX(-Math.PI / 2), groundShade());
  readonly #ground = new Group().add(this.#grass, this.#shadows);

  constructor() {
    const { shadow } = this.#sun;
    this.#sun.castShadow = true;
    Object.assign(shadow, { radius: 4, intensity: 0.7, normalBias: 0.03, bias: 0.0003 });
    this.#side.position.set(1, 0.7, -0.4);
    for (const mesh of [this.#grass, this.#shadows]) Object.assign(mesh, { receiveShadow: true, renderOrder: -1 });
    this.sow(false);
    this.turnTo(FIRST_HOUR);
    this.root.add(this.#sky, this.#sun, this.#sun.target, this.#side, this.#ground);
  }

  /** Towards the sun. */
  get direction(): Vector3 {
    return this.#direction;
  }

  /** Lights as at an hour of the day; the caller casts the shadows. */
  turnTo(hour: number): void {
    this.#direction = sunAt(hour);
    const share = Math.min(1, this.#direction.y / FULL);
    this.#sun.color.lerpColors(LOW.sun, HIGH.sun, share);
    this.#sun.intensity = LOW.strength + (HIGH.strength - LOW.strength) * share;
    this.#sky.intensity = LOW.sky + (HIGH.sky - LOW.sky) * share;
    this.#side.intensity = LOW.side + (HIGH.side - LOW.side) * share;
    this.sky.lerpColors(LOW.seen, HIGH.seen, share);
    this.lamps = Math.max(0, Math.min(1, (DUSK - share) / (DUSK - DARK)));
    if (this.#lit) this.around(...this.#lit);
  }

  /** Shows the ground, or light alone. */
  showGround(isShown: boolean): void {
    this.#ground.visible = isShown;
  }

  /** Surrounds who walks: with grass in place of only the shadows that fall there, and shadows of finer edges; the caller casts them. */
  sow(isGrass: boolean): void {
    this.#grass.visible = isGrass;
    this.#shadows.visible = !isGrass;
    const { shadow } = this.#sun;
    const [across, along] = isGrass ? NEAR_SHADOW_PIXELS : SHADOW_PIXELS;
    if (shadow.mapSize.x === across) return;
    shadow.mapSize.set(across, along);
    shadow.map?.dispose();
    shadow.map = null;
  }

  /** Lights a house and lays the ground around it, as far as shadows of what reaches up to `top` fall [m]. */
  around(bounds: Box3, top: number): void {
    this.#lit = [bounds, top];
    const centre = bounds.getCenter(new Vector3());
    const radius = bounds.getSize(new Vector3()).length() / 2 + 1;
    this.#sun.target.position.copy(centre);
    this.#sun.position.copy(centre).addScaledVector(this.#direction, radius * 2);
    const camera = this.#sun.shadow.camera;
    const seen = seenBySun(bounds, top, centre, this.#direction);
    Object.assign(camera, { left: seen.min.x, right: seen.max.x, top: seen.max.y, bottom: seen.min.y, near: radius * 0.5, far: radius * 3.5 });
    camera.updateProjectionMatrix();
    this.#grass.position.set(centre.x, bounds.min.y + GROUND, centre.z);
    this.#grass.scale.setScalar(radius);
    const shaded = shadedBy(bounds, top, this.#direction);
    shaded.getCenter(this.#shadows.position).setY(bounds.min.y + GROUND);
    shaded.getSize(this.#shadows.scale).setY(1);
  }
}
