/** The sheet that is drawn on: a plan as SVG, in millimetres, with what is chosen and what is about to be drawn. */
import type { Room } from "../contract";
import { WIDEST_LEAF } from "../house/door_leaves";
import { drawn } from "../made";
import { boxOf, wallsOf, type Box, type Corners, type Point } from "./corners";
import type { Draft, DraftOpening, DraftRoom } from "./draft";
import { say, sayArea, sayNumber } from "../words/language";

/** How thick a wall is drawn [mm]; what is nearer than that to a line of the sheet is on it. */
const WALL = 100;
const METRE = 1000;
/** How much of the sheet a pixel shows: the nearest, and the farthest where one zooms [mm]. */
const NEAREST = 1;
const FARTHEST = 120;
const MARGIN = 1.25;
/** How large names of rooms are written [pixels], the least and the most; how wide a letter and how high a line is for its size; how many lines at most. */
const SMALLEST = 7;
const LARGEST = 13;
const LETTER = 0.77;
const LINE = 1.2;
const MOST_LINES = 3;
/** What is seen of a sheet on which nothing is drawn [mm]. */
const EMPTY_SHEET: Corners = [{ x: 0, z: 0 }, { x: 10 * METRE, z: 7 * METRE }];

export interface Picture {
  readonly url: string;
  /** Its size in its own pixels. */
  readonly width: number;
  readonly height: number;
  /** How long one of its pixels is [mm]. */
  readonly scale: number;
  readonly opacity: number;
}

/** What is shown beside the plan itself. */
export interface Marks {
  readonly room: string | null;
  readonly opening: string | null;
  readonly ghost: Box | null;
  readonly wrong: ReadonlySet<string>;
  /** Rooms as they would be furnished, while a wall of theirs is dragged. */
  readonly furnished: ReadonlyMap<string, Room>;
  readonly measured: readonly Point[];
  readonly picture: Picture | null;
  readonly names: (room: DraftRoom) => string;
  /** Clear floors [m²]. */
  readonly areas: ReadonlyMap<string, number>;
  readonly colors: (room: DraftRoom) => string;
}

export function inMetres(length: number): string {
  return sayNumber(length / METRE, 2);
}

function pathOf(corners: Corners): string {
  return `M${corners.map(({ x, z }) => `${x} ${z}`).join("L")}Z`;
}

/** Where a room's name stands, and how much room it has there: in the middle below the longest wall in the north. */
function nameAt(corners: Corners): Point & { readonly width: number; readonly depth: number } {
  const { x0, z0, x1, z1 } = boxOf(corners);
  const middle = { x: (x0 + x1) / 2, z: (z0 + z1) / 2, width: x1 - x0, depth: z1 - z0 };
  if (corners.length === 4) return middle;
  const [north] = wallsOf(corners).filter(({ axis, inward }) => axis === "x" && inward === 1).sort((a, b) => b.to - b.from - (a.to - a.from));
  if (!north) return middle;
  const below = wallsOf(corners).filter(({ axis, inward, line, from, to }) => axis === "x" && inward === -1 && line > north.line && from < north.to && north.from < to);
  const south = Math.min(...below.map(({ line }) => line));
  return { x: (north.from + north.to) / 2, z: (north.line + south) / 2, width: north.to - north.from, depth: south - north.line };
}

function longest(lines: readonly string[]): number {
  return Math.max(...lines.map((line) => line.length));
}

/** Words in so many lines at most, the longest as short as can be. */
function inLines(words: readonly string[], most: number): string[] {
  const ways = [[words.join(" ")]];
  if (most > 1) for (let count = 1; count < words.length; count += 1) ways.push([words.slice(0, count).join(" "), ...inLines(words.slice(count), most - 1)]);
  return ways.reduce((best, way) => (longest(way) < longest(best) ? way : best));
}

export class Sheet {
  readonly svg = drawn("svg", { class: "sheet", tabindex: 0, role: "application", "aria-label": say("The plan that is drawn") });
  /** The point in the middle, and how much a pixel shows [mm]. */
  #middle: Point = { x: 5 * METRE, z: 4 * METRE };
  #perPixel = 16;
  #shown: { readonly draft: Draft; readonly marks: Marks } | null = null;
  /** All is in view, and stays so whatever the window's size, until the sheet is moved. */
  #isFitted = false;

  constructor(host: HTMLElement) {
    host.prepend(this.svg);
    new ResizeObserver(() => this.again()).observe(this.svg);
    window.addEventListener("resize", () => this.#resized()); // a row of tools more is no reason to move what is being drawn
  }

  /** How many millimetres a pixel shows. */
  get perPixel(): number {
    return this.#perPixel;
  }

  /** The point of the plan under a point of the window. */
  at({ clientX, clientY }: { readonly clientX: number; readonly clientY: number }): Point {
    const { left, top, width, height } = this.svg.getBoundingClientRect();
    return { x: this.#middle.x + (clientX - left - width / 2) * this.#perPixel, z: this.#middle.z + (clientY - top - height / 2) * this.#perPixel };
  }

  /** The point of the window where a point of the plan is seen. */
  seen({ x, z }: Point): { readonly x: number; readonly y: number } {
    const { left, top, width, height } = this.svg.getBoundingClientRect();
    return { x: left + width / 2 + (x - this.#middle.x) / this.#perPixel, y: top + height / 2 + (z - this.#middle.z) / this.#perPixel };
  }

  /** Moves the sheet so that a point of the plan is under a point of the window. */
  pull(point: Point, under: { readonly clientX: number; readonly clientY: number }): void {
    this.#isFitted = false;
    const now = this.at(under);
    this.#middle = { x: this.#middle.x + point.x - now.x, z: this.#middle.z + point.z - now.z };
    this.again();
  }

  /** Comes nearer by a factor, to a point of the window. */
  zoom(factor: number, to: { readonly clientX: number; readonly clientY: number }): void {
    const held = this.at(to);
    this.#perPixel = Math.max(NEAREST, Math.min(FARTHEST, this.#perPixel / factor));
    this.pull(held, to);
  }

  /** Whether all of an outline is in view. */
  holds(corners: Corners): boolean {
    const { left, top, width, height } = this.svg.getBoundingClientRect();
    return corners.map((corner) => this.seen(corner)).every(({ x, y }) => left <= x && x <= left + width && top <= y && y <= top + height);
  }

  #resized(): void {
    if (this.#isFitted && this.#shown && this.svg.clientWidth > 0) this.fit(this.#shown.draft, this.#shown.marks.picture);
  }

  /** Shows a whole plan, or the picture to draw one over, or room for one. */
  fit({ rooms }: Draft, picture: Picture | null): void {
    const empty = picture ? [{ x: 0, z: 0 }, { x: picture.width * picture.scale, z: picture.height * picture.scale }] : EMPTY_SHEET;
    const { x0, z0, x1, z1 } = boxOf(rooms.length === 0 ? empty : rooms.flatMap(({ corners }) => corners));
    const { width, height } = this.svg.getBoundingClientRect();
    this.#middle = { x: (x0 + x1) / 2, z: (z0 + z1) / 2 };
    this.#perPixel = Math.max(NEAREST, MARGIN * Math.max((x1 - x0) / Math.max(width, 1), (z1 - z0) / Math.max(height, 1)));
    this.#isFitted = true;
    this.again();
  }

  draw(draft: Draft, marks: Marks): void {
    this.#shown = { draft, marks };
    this.again();
  }

  again(): void {
    if (!this.#shown) return;
    const { width, height } = this.svg.getBoundingClientRect();
    const [across, down] = [width * this.#perPixel, height * this.#perPixel];
    this.svg.setAttribute("viewBox", `${this.#middle.x - across / 2} ${this.#middle.z - down / 2} ${Math.max(across, 1)} ${Math.max(down, 1)}`);
    this.svg.replaceChildren(...this.#layers(this.#shown.draft, this.#shown.marks, across, down));
  }

  #layers(draft: Draft, marks: Marks, across: number, down: number): Node[] {
    const chosen = draft.rooms.find(({ id }) => id === marks.room);
    return [
      ...(marks.picture ? [this.#picture(marks.picture)] : []),
      this.#grid(across, down),
      ...draft.rooms.map((room) => this.#floor(room, marks)),
      ...draft.rooms.flatMap(({ id, from }) => this.#furniture(marks.furnished.get(id) ?? from)),
      ...draft.rooms.map((room) => drawn("path", { class: "wall", d: pathOf(room.corners), "stroke-width": WALL })),
      ...draft.openings.map((opening) => this.#opening(opening, opening.id === marks.opening)),
      ...draft.rooms.map((room) => this.#name(room, marks)),
      ...(chosen ? this.#handles(chosen) : []),
      ...(marks.ghost ? this.#ghost(marks.ghost) : []),
      ...marks.measured.map(({ x, z }) => drawn("circle", { class: "measured", cx: x, cy: z, r: 4 * this.#perPixel })),
      ...(marks.measured.length === 2 ? [this.#measure(marks.measured)] : []),
    ];
  }

  #picture({ url, width, height, scale, opacity }: Picture): SVGElement {
    return drawn("image", { class: "traced", href: url, x: 0, y: 0, width: width * scale, height: height * scale, opacity });
  }

  #measure(points: readonly Point[]): SVGElement {
    const [a, b] = points as [Point, Point];
    return drawn("line", { class: "measured", x1: a.x, y1: a.z, x2: b.x, y2: b.z, "stroke-width": 2 * this.#perPixel });
  }

  #grid(across: number, down: number): SVGElement {
    const step = this.#perPixel > 40 ? 5 * METRE : METRE;
    const [west, north] = [this.#middle.x - across / 2, this.#middle.z - down / 2];
    const lines: string[] = [];
    for (let x = Math.ceil(west / step) * step; x < west + across; x += step) lines.push(`M${x} ${north}v${down}`);
    for (let z = Math.ceil(north / step) * step; z < north + down; z += step) lines.push(`M${west} ${z}h${across}`);
    return drawn("path", { class: "grid", d: lines.join(""), "stroke-width": this.#perPixel });
  }

  #floor(room: DraftRoom, { room: chosen, wrong, colors }: Marks): SVGElement {
    const state = [chosen === room.id ? " chosen" : "", wrong.has(room.id) ? " wrong" : ""].join("");
    return drawn("path", { class: `floor${state}`, d: pathOf(room.corners), fill: colors(room), "data-room": room.id });
  }

  #furniture(room: Room | null): SVGElement[] {
    if (!room) return [];
    const { furniture, x, z } = room;
    return furniture.filter((piece) => !piece.on).map((piece) => {
      const [width, depth] = [piece.width * METRE, piece.depth * METRE];
      const middle: Point = { x: (x + piece.x) * METRE, z: (z + piece.z) * METRE };
      const turn = `translate(${middle.x} ${middle.z}) rotate(${-(piece.rotation ?? 0)})`;
      return drawn("g", { class: "piece", transform: turn },
        drawn("rect", { x: -width / 2, y: -depth / 2, width, height: depth, "stroke-width": 1.5 * this.#perPixel }, drawn("title", {}, piece.name.replaceAll("_", " "))),
        drawn("path", { d: `M${-width / 4} ${depth / 2 - Math.min(80, depth / 4)}h${width / 2}`, "stroke-width": this.#perPixel }));
    });
  }

  #opening(opening: DraftOpening, isChosen: boolean): SVGElement {
    const { id, kind, axis, line, from, to } = opening;
    const rect = axis === "x" ? { x: from, y: line - WALL / 2, width: to - from, height: WALL } : { x: line - WALL / 2, y: from, width: WALL, height: to - from };
    const reach = Math.max(0, 10 * this.#perPixel - WALL / 2);
    const grip = axis === "x" ? { x: from, y: line - WALL / 2 - reach, width: to - from, height: WALL + 2 * reach } : { x: line - WALL / 2 - reach, y: from, width: WALL + 2 * reach, height: to - from };
    return drawn("g", { class: `opening ${kind}${isChosen ? " chosen" : ""}${opening.isMainEntrance ? " entrance" : ""}`, "data-opening": id },
      drawn("rect", { class: "gap", ...rect }), ...this.#leaf(opening), drawn("rect", { class: "grip", ...grip }));
  }

  /** A door's leaf and the arc of its edge; a window's pane. */
  #leaf({ kind, axis, line, from, to, hinge, swing }: DraftOpening): SVGElement[] {
    const width = (to - from) / (to - from > 1000 * WIDEST_LEAF ? 2 : 1);
    const point = (along: number, across: number): string => (axis === "x" ? `${along} ${across}` : `${across} ${along}`);
    const stroke = { "stroke-width": 2 * this.#perPixel };
    if (kind === "window") return [drawn("path", { class: "leaf", d: `M${point(from, line)}L${point(to, line)}`, ...stroke })];
    if (kind !== "door") return [];
    const tip = line + swing * width;
    const leaf = (end: "start" | "end"): string => {
      const [pivot, far] = end === "start" ? [from, from + width] : [to, to - width];
      const isClockwise = (axis === "x") === (end === "start") === (swing === 1);
      return `M${point(pivot, line)}L${point(pivot, tip)}A${width} ${width} 0 0 ${isClockwise ? 0 : 1} ${point(far, line)}`;
    };
    const leaves = width < to - from ? leaf("start") + leaf("end") : leaf(hinge);
    return [drawn("path", { class: "leaf", d: leaves, ...stroke })];
  }

  #name(room: DraftRoom, { names, areas }: Marks): SVGElement {
    const { x, z, width, depth } = nameAt(room.corners);
    const words = names(room).split(" ");
    const ways = [...Array(MOST_LINES).keys()].map((more) => inLines(words, more + 1));
    const [smallest, largest] = [SMALLEST * this.#perPixel, LARGEST * this.#perPixel];
    const fitting = (lines: readonly string[]): number => Math.min(largest, width / (LETTER * longest(lines)), depth / (LINE * (lines.length + 1)));
    const best = ways.reduce((one, other) => (fitting(other) > fitting(one) ? other : one));
    const lines = fitting(best) >= smallest ? best : []; // else it is read beside the sheet, where each room is listed
    const down = (line: number): string => `${line === 0 ? (-LINE * lines.length) / 2 : LINE}em`;
    const area = sayArea(areas.get(room.id) ?? 0);
    return drawn("text", { class: "room-name", role: "img", "aria-label": `${names(room)}, ${area}`, x, y: z, "font-size": Math.max(smallest, fitting(best)) },
      ...lines.map((line, at) => drawn("tspan", { x, dy: down(at) }, line)), drawn("tspan", { class: "area", x, dy: down(lines.length) }, area));
  }

  /** The walls of the room that is chosen, to take hold of, with their lengths. */
  #handles({ id, corners }: DraftRoom): SVGElement[] {
    return wallsOf(corners).flatMap(({ index, axis, line, from, to, inward }) => {
      const middle = (from + to) / 2;
      const [x, z] = axis === "x" ? [middle, line] : [line, middle];
      const away = -inward * 16 * this.#perPixel;
      const ends = axis === "x" ? { x1: from, y1: line, x2: to, y2: line } : { x1: line, y1: from, x2: line, y2: to };
      const [tx, tz] = axis === "x" ? [x, z + away] : [x + away, z];
      const turn = axis === "x" ? "" : `rotate(-90 ${tx} ${tz})`;
      return [
        drawn("line", { class: `hold along-${axis}`, ...ends, "stroke-width": 12 * this.#perPixel, "data-wall": index, "data-of": id }),
        drawn("text", { class: "length", x: tx, y: tz, "font-size": 12 * this.#perPixel, transform: turn }, inMetres(to - from)),
      ];
    });
  }

  #ghost({ x0, z0, x1, z1 }: Box): SVGElement[] {
    const words = `${inMetres(x1 - x0)} × ${inMetres(z1 - z0)} m`;
    return [
      drawn("rect", { class: "ghost", x: x0, y: z0, width: x1 - x0, height: z1 - z0, "stroke-width": 2 * this.#perPixel }),
      drawn("text", { class: "length", x: (x0 + x1) / 2, y: (z0 + z1) / 2, "font-size": 13 * this.#perPixel }, words),
    ];
  }
}
