/** A small map of the ground floor for who walks: rooms, furniture, where one is and looks; a click goes there. */
import type { Room } from "../contract";
import { words } from "../house/frame";
import type { House } from "../house/house";
import { cornersOf } from "../house/plan";
import { roomHolding } from "../house/room_at";
import { drawn, made } from "../made";
import type { Pose } from "./walk";
import { say } from "../words/language";

/** Around the house [m]. */
const MARGIN = 0.6;
const GROUND = 0;
/** The sign of who walks: its tip ahead, to the north while unturned; so large in shares of the map's longer side. */
const ARROW = "0,-1 0.7,0.8 0,0.45 -0.7,0.8";
const SIZE = 0.035;
const UNSAID = "#8b949e";
const WAYS = ["north", "north-west", "west", "south-west", "south", "south-east", "east", "north-east"] as const;

function floorOf(room: Room): SVGElement {
  const points = cornersOf(room).map(([x, z]) => `${room.x + x},${room.z + z}`).join(" ");
  return drawn("polygon", { class: "map-room", points, fill: room.accent ?? UNSAID });
}

export class Minimap {
  /** Called with the place of the plan that was clicked [m]. */
  onPlace: (x: number, z: number) => void = () => undefined;
  readonly #svg = drawn("svg", { role: "img" });
  readonly #words = made("p", { role: "status" });
  readonly #arrow = drawn("polygon", { class: "map-walker", points: ARROW });
  #rooms: readonly Room[] = [];
  #scale = 1;

  constructor(readonly host: HTMLElement) {
    host.append(this.#svg, this.#words);
    this.#svg.addEventListener("click", ({ clientX, clientY }) => {
      const at = new DOMPoint(clientX, clientY).matrixTransform(this.#svg.getScreenCTM()?.inverse());
      this.onPlace(at.x, at.y);
    });
  }

  show(house: House): void {
    const { rooms } = house.scene;
    this.#rooms = rooms.filter((room) => room.level === GROUND);
    const { min, max } = house.bounds;
    const box = [min.x - MARGIN, min.z - MARGIN, max.x - min.x + 2 * MARGIN, max.z - min.z + 2 * MARGIN];
    this.#scale = SIZE * Math.max(max.x - min.x, max.z - min.z);
    this.#svg.setAttribute("viewBox", box.join(" "));
    const pieces = house.bodies.filter(({ kind }) => kind === "furniture").map(({ x, z, width, depth, turn }) => drawn("rect", {
      class: "map-piece", x: -width / 2, y: -depth / 2, width, height: depth, transform: `translate(${x} ${z}) rotate(${(-turn * 180) / Math.PI})`,
    }));
    const ways = house.plan.openings.filter(({ kind, level }) => kind !== "window" && level === GROUND).map(({ axis, line, from, to }) => drawn("line", {
      class: "map-door", ...(axis === "x" ? { x1: from, x2: to, y1: line, y2: line } : { x1: line, x2: line, y1: from, y2: to }),
    }));
    this.#svg.replaceChildren(...this.#rooms.map(floorOf), ...pieces, ...ways, this.#arrow);
  }

  /** Shows where somebody stands; hides the map for null. */
  follow(pose: Pose | null): void {
    if (this.host.hidden !== (pose === null)) this.host.hidden = pose === null;
    if (!pose) return;
    const [x, , z] = pose.eye;
    this.#arrow.setAttribute("transform", `translate(${x.toFixed(2)} ${z.toFixed(2)}) rotate(${((-pose.yaw * 180) / Math.PI).toFixed(1)}) scale(${this.#scale.toFixed(3)})`);
    const room = roomHolding(this.#rooms, GROUND, x, z);
    const way = WAYS[(Math.round((pose.yaw * 4) / Math.PI) % 8 + 8) % 8] ?? "north";
    const where = room ? room.name || words(room.type) : say("outside");
    if (this.#words.textContent !== where) this.#words.textContent = where;
    const told = say("Map: {where}, looking {way}", { where, way: say(way) });
    if (this.#svg.getAttribute("aria-label") !== told) this.#svg.setAttribute("aria-label", told);
  }
}
