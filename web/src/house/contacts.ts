/** Soft shade where things meet the floor: along walls, and around what stands on it. One draw call, no pass over the picture. */
import { InstancedBufferAttribute, InstancedMesh, Matrix4, PlaneGeometry, Quaternion, ShaderMaterial, Vector3 } from "three";
import type { PlacedBody } from "./frame";
import type { Part } from "./parts";
import { sharedMaterial } from "./shared_materials";
import { between, type WallPlan } from "./walls";

/** Over the floor and the rugs on it [m]. */
const RISE = 0.014;
/** What is lower casts none: rugs and mats. What stands higher above its floor does not meet it [m]. */
const LOWEST = 0.06;
const FARTHEST = 0.05;
/** How far the shade of a wall reaches [m]; that of a body by its height, between these. */
const WALL_REACH = 0.32;
const REACH = { least: 0.05, share: 0.3, most: 0.26 } as const;
/** What begins higher over the floor, as the crown of a tree, casts none there [m]. */
const NEAR_FLOOR = 0.3;
/** Legs and plinths stand a little inside of what is above them [m]. */
const INSET = 0.04;
const UP = new Vector3(0, 1, 0);

/** Where shade lies: around a rectangle on the floor, turned about +y [m, rad]. */
interface Shade {
  readonly at: readonly [number, number, number];
  readonly turn: number;
  readonly half: readonly [number, number];
  readonly reach: number;
}

const VERTICES = /* glsl */ `
attribute vec3 rectangle; // half its width and depth, how far the shade reaches [m]
varying vec2 vAt;
varying vec3 vRectangle;
void main() {
  vAt = position.xy * 2.0 * (rectangle.xy + rectangle.z);
  vRectangle = rectangle;
  gl_Position = projectionMatrix * modelViewMatrix * instanceMatrix * vec4(vAt.x, 0.0, vAt.y, 1.0);
}`;

const FRAGMENTS = /* glsl */ `
varying vec2 vAt;
varying vec3 vRectangle;
void main() {
  float beyond = length(max(abs(vAt) - vRectangle.xy, 0.0)) / vRectangle.z;
  float near = max(0.0, 1.0 - beyond);
  gl_FragColor = vec4(0.05, 0.045, 0.06, 0.36 * near * near);
}`;

function shadeMaterial(): ShaderMaterial {
  return new ShaderMaterial({ vertexShader: VERTICES, fragmentShader: FRAGMENTS, transparent: true, depthWrite: false });
}

/** The shade along a house's walls: none where a door or a passage leads through. */
export function wallShades({ runs, openings, storeys }: WallPlan): Shade[] {
  return runs.filter(({ kind }) => kind === "wall").flatMap((run) => {
    const gaps = openings.filter((opening) => opening.kind !== "window" && opening.level === run.level && opening.axis === run.axis
      && Math.abs(opening.line - run.line) < run.thickness && opening.to > run.from && opening.from < run.to);
    const y = (storeys.get(run.level)?.elevation ?? 0) + RISE;
    return between(run.from, run.to, gaps).map(({ from, to }): Shade => {
      const [along, half] = [(from + to) / 2, (to - from) / 2];
      return run.axis === "x"
        ? { at: [along, y, run.line], turn: 0, half: [half, run.thickness / 2], reach: WALL_REACH }
        : { at: [run.line, y, along], turn: 0, half: [run.thickness / 2, half], reach: WALL_REACH };
    });
  });
}

/** What a body is drawn with; null where that is not known. */
export type Drawn = (body: PlacedBody) => readonly Part[] | null;

/** From where to where a body reaches along its own axis near the floor, from its middle [m]. */
function reachOf(low: readonly Part[], axis: 0 | 2, side: number): readonly [number, number] {
  const reach = (sign: 1 | -1): number => Math.min(side / 2, Math.max(...low.map(({ at, size }) => sign * at[axis] + size[axis] / 2)));
  return low.length > 0 ? [-reach(-1), reach(1)] : [-side / 2, side / 2];
}

/** The shade around what of a body is near one of these floors, at their heights [m]; null for what lies flat, hangs, or stands on others. */
export function bodyShade(body: PlacedBody, floors: readonly number[], drawn: Drawn): Shade | null {
  const floor = floors.find((one) => Math.abs(body.y - one) <= FARTHEST);
  if (floor === undefined || body.height < LOWEST) return null;
  const low = (drawn(body) ?? []).filter(({ at, size }) => at[1] - size[1] / 2 < NEAR_FLOOR);
  const [[left, right], [back, front]] = [reachOf(low, 0, body.width), reachOf(low, 2, body.depth)];
  const half = [right - left, front - back].map((side) => Math.max(side / 4, side / 2 - INSET)) as [number, number];
  const reach = Math.min(REACH.most, REACH.least + REACH.share * body.height);
  const [across, along] = [(left + right) / 2, (back + front) / 2];
  const [cos, sin] = [Math.cos(body.turn), Math.sin(body.turn)];
  return { at: [body.x + across * cos + along * sin, floor + RISE, body.z - across * sin + along * cos], turn: body.turn, half, reach };
}

/** The shades of a house; those of bodies follow them. */
export class Contacts {
  readonly root: InstancedMesh;
  readonly #floors: readonly number[];
  readonly #numbers = new Map<string, number>();

  constructor(plan: WallPlan, bodies: readonly PlacedBody[], readonly drawn: Drawn) {
    const elevations = [...plan.storeys.values()].map(({ elevation }) => elevation);
    this.#floors = elevations.length > 0 ? elevations : [0];
    const shades = wallShades(plan);
    for (const body of bodies) {
      const shade = bodyShade(body, this.#floors, drawn);
      if (shade) this.#numbers.set(body.id, shades.push(shade) - 1);
    }
    const geometry = new PlaneGeometry(1, 1);
    geometry.setIndex([0, 1, 2, 2, 1, 3]); // seen from above
    geometry.setAttribute("rectangle", new InstancedBufferAttribute(new Float32Array(shades.flatMap(({ half, reach }) => [...half, reach])), 3));
    this.root = new InstancedMesh(geometry, sharedMaterial("shade", shadeMaterial), shades.length);
    this.root.frustumCulled = false;
    shades.forEach((shade, number) => this.#write(number, shade));
  }

  /** Moves a body's shade with it. */
  place(body: PlacedBody): void {
    const number = this.#numbers.get(body.id);
    const shade = number === undefined ? null : bodyShade(body, this.#floors, this.drawn);
    if (number === undefined) return;
    this.root.instanceMatrix.needsUpdate = true;
    if (shade) this.#write(number, shade);
    else this.root.setMatrixAt(number, new Matrix4().makeScale(0, 0, 0));
  }

  #write(number: number, { at, turn }: Shade): void {
    this.root.setMatrixAt(number, new Matrix4().compose(new Vector3(...at), new Quaternion().setFromAxisAngle(UP, turn), new Vector3(1, 1, 1)));
  }
}
