/** The pointer on the sheet: what is drawn, taken hold of or dragged by it, with the tool in hand. */
import type { OpeningKind } from "../contract";
import { boxBetween, boxOf, cornersOfBox, type Box, type Point } from "./corners";
import { OPENING_SIZES, openingMoved, reshaped, roomMoved, wallMoved, withOpening, withRoom, type Draft } from "./draft";
import type { DrawnPlan } from "./drawn_plan";
import type { Sheet } from "./sheet";
import { linesOf, snapped, snappedPoint, snappedShift } from "./snapping";
import { say } from "../words/language";

export type ToolName = "choose" | "room" | "add" | "cut" | "measure" | OpeningKind;

/** How near is on it, and how far a pointer goes before it drags [pixels]. */
const REACH = 12;
const DRAGGED = 4;

export function isOpening(tool: ToolName): tool is OpeningKind {
  return Object.hasOwn(OPENING_SIZES, tool);
}

export interface PencilWords {
  /** What is about to be drawn. */
  ghost(box: Box | null): void;
  /** The points that are measured between; `isDone`: the pen is up again. */
  measured(points: readonly Point[], isDone: boolean): void;
  /** Something cannot be drawn, and why. */
  said(words: string): void;
}

/** What is done while the pointer is down: with each place it comes to, and when it is let go. */
interface Stroke {
  move(event: PointerEvent): void;
  end(): void;
  /** Takes back what was done as the pointer went down. */
  undo?(): void;
}

/** Half way between two fingers, and how far apart they are [pixels]. */
function grip([a, b]: readonly PointerEvent[]): { readonly clientX: number; readonly clientY: number; readonly apart: number } {
  const [one, other] = [a, b ?? a] as [PointerEvent, PointerEvent];
  return {
    clientX: (one.clientX + other.clientX) / 2, clientY: (one.clientY + other.clientY) / 2,
    apart: Math.max(1, Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY)),
  };
}

export class Pencil {
  tool: ToolName = "choose";
  #stroke: Stroke | null = null;
  #measured: readonly Point[] = [];
  /** What is down on the sheet, by its id. */
  readonly #fingers = new Map<number, PointerEvent>();

  constructor(readonly sheet: Sheet, readonly plan: DrawnPlan, readonly words: PencilWords) {
    const { svg } = sheet;
    svg.addEventListener("pointerdown", (event) => this.#down(event));
    svg.addEventListener("pointermove", (event) => {
      this.#stroke?.move(event);
      if (this.#fingers.has(event.pointerId)) this.#fingers.set(event.pointerId, event);
    });
    svg.addEventListener("pointerup", (event) => this.#up(event));
    svg.addEventListener("pointercancel", () => this.cancel());
    svg.addEventListener("wheel", (event) => {
      event.preventDefault();
      sheet.zoom(Math.exp(-event.deltaY / 600), event);
    }, { passive: false });
  }

  get isBusy(): boolean {
    return this.#stroke !== null;
  }

  cancel(): void {
    this.#fingers.clear();
    this.#stroke = null;
    this.words.ghost(null);
    this.#measured = [];
    this.words.measured([], true);
    this.plan.cancel();
  }

  #up(event: PointerEvent): void {
    this.#fingers.delete(event.pointerId);
    const stroke = this.#stroke;
    this.#stroke = null;
    stroke?.end();
  }

  #down(event: PointerEvent): void {
    this.#fingers.set(event.pointerId, event);
    if (this.#stroke && this.#fingers.size !== 2) return;
    event.preventDefault();
    this.sheet.svg.focus();
    this.sheet.svg.setPointerCapture(event.pointerId);
    if (this.#fingers.size === 2) {
      this.#stroke = this.#pinch();
      return;
    }
    this.#stroke = event.button === 0 ? this.#begin(event) : event.button === 1 ? this.#pull(event) : null;
  }

  #begin(event: PointerEvent): Stroke | null {
    if (this.tool === "choose") return this.#grasp(event);
    if (this.tool === "measure") return this.#measure(event);
    return isOpening(this.tool) ? this.#put(this.tool, event) : this.#rectangle(event, this.tool);
  }

  #reach(): number {
    return REACH * this.sheet.perPixel;
  }

  #pull(event: PointerEvent): Stroke {
    const held = this.sheet.at(event);
    return { move: (next) => this.sheet.pull(held, next), end: () => undefined };
  }

  /** Two fingers move the sheet and come nearer; what the first one had begun is forgotten. */
  #pinch(): Stroke {
    this.#stroke?.undo?.();
    this.words.ghost(null);
    this.plan.cancel();
    return {
      move: (next) => {
        const before = grip([...this.#fingers.values()]);
        const held = this.sheet.at(before);
        this.#fingers.set(next.pointerId, next);
        const after = grip([...this.#fingers.values()]);
        this.sheet.pull(held, after);
        this.sheet.zoom(after.apart / before.apart, after);
      },
      end: () => undefined,
    };
  }

  #grasp(event: PointerEvent): Stroke {
    const target = event.target as Element;
    const wall = target.closest<SVGElement>("[data-wall]");
    const opening = target.closest<SVGElement>("[data-opening]")?.dataset.opening;
    const room = target.closest<SVGElement>("[data-room]")?.dataset.room;
    if (opening !== undefined) return this.#dragOpening(opening, event);
    if (wall) return this.#dragWall(wall.dataset.of ?? "", Number(wall.dataset.wall));
    if (room !== undefined) return this.#dragRoom(room, event);
    this.plan.choose({});
    return this.#pull(event);
  }

  /** A stroke that does nothing until the pointer has gone some way; each place then makes a plan of the one before. */
  #dragging(event: PointerEvent | null, change: (next: PointerEvent) => Draft | null): Stroke {
    let goes = event === null;
    return {
      move: (next) => {
        goes ||= event !== null && Math.hypot(next.clientX - event.clientX, next.clientY - event.clientY) >= DRAGGED;
        const moment = goes ? change(next) : null;
        if (moment) this.plan.show(moment);
      },
      end: () => this.plan.step(),
    };
  }

  #dragWall(id: string, index: number): Stroke {
    const before = this.plan.settled;
    const room = before.rooms.find((one) => one.id === id);
    const start = room?.corners[index];
    const end = room?.corners[(index + 1) % room.corners.length];
    const axis = start?.z === end?.z ? "x" : "z";
    const lines = linesOf(before, new Set([id]));
    return this.#dragging(null, (next) => {
      const at = this.sheet.at(next);
      const line = axis === "x" ? snapped(at.z, lines.z, this.#reach(), next.altKey) : snapped(at.x, lines.x, this.#reach(), next.altKey);
      return wallMoved(before, id, index, line, next.shiftKey);
    });
  }

  #dragRoom(id: string, event: PointerEvent): Stroke {
    const before = this.plan.settled;
    const [from, corners] = [this.sheet.at(event), before.rooms.find((one) => one.id === id)?.corners ?? []];
    const lines = linesOf(before, new Set([id]));
    this.plan.choose({ room: id });
    return this.#dragging(event, (next) => {
      const at = this.sheet.at(next);
      const shift = snappedShift(boxOf(corners), { x: at.x - from.x, z: at.z - from.z }, lines, this.#reach(), next.altKey);
      return roomMoved(before, id, shift.x, shift.z);
    });
  }

  #dragOpening(id: string, event: PointerEvent): Stroke {
    const before = this.plan.settled;
    this.plan.choose({ opening: id });
    return this.#dragging(event, (next) => openingMoved(before, id, this.#alongWall(next), 3 * this.#reach()));
  }

  /** The point that a pointer means in a wall: on the grid along it. */
  #alongWall(event: PointerEvent): Point {
    const at = this.sheet.at(event);
    const lines = linesOf(this.plan.settled);
    return snappedPoint(at, { x: lines.x.filter((x) => Math.abs(x - at.x) > this.#reach()), z: lines.z.filter((z) => Math.abs(z - at.z) > this.#reach()) }, 0, event.altKey);
  }

  #put(kind: OpeningKind, event: PointerEvent): Stroke | null {
    const put = withOpening(this.plan.settled, kind, this.#alongWall(event), 2 * this.#reach());
    if (!put) {
      this.words.said(say("There is no wall here that is long and free enough for it."));
      return null;
    }
    this.plan.step(put.draft);
    const { id } = put;
    const before = this.plan.settled;
    this.plan.choose({ opening: id });
    return {
      move: (next) => {
        const moment = openingMoved(before, id, this.#alongWall(next), 3 * this.#reach());
        if (moment) this.plan.show(moment);
      },
      end: () => this.plan.amend(this.plan.draft),
      undo: () => this.plan.undo(),
    };
  }

  #rectangle(event: PointerEvent, how: "room" | "add" | "cut"): Stroke {
    const lines = linesOf(this.plan.settled);
    const point = (one: PointerEvent): Point => snappedPoint(this.sheet.at(one), lines, this.#reach(), one.altKey);
    const start = point(event);
    let box: Box | null = null;
    return {
      move: (next) => {
        box = boxBetween(start, point(next));
        this.words.ghost(box);
      },
      end: () => {
        this.words.ghost(null);
        if (box && box.x0 < box.x1 && box.z0 < box.z1) this.draw(box, how);
      },
    };
  }

  /** Draws a rectangle as a room, or adds it to the chosen room, or cuts it away from it. */
  draw(box: Box, how: "room" | "add" | "cut"): void {
    const { room } = this.plan.chosen;
    if (how === "room") {
      const drawn = withRoom(this.plan.settled, cornersOfBox(box));
      if (!drawn) {
        this.words.said(say("A room is at least 0.5 m by 0.5 m and shares no floor with another: to part one, cut area from it first."));
        return;
      }
      this.plan.step(drawn.draft);
      this.plan.choose({ room: drawn.id });
      return;
    }
    const shape = room === null ? null : reshaped(this.plan.settled, room, box, how);
    if (shape) this.plan.step(shape);
    else this.words.said(room === null ? say("Choose a room first.") : say("That would leave no single floor, or meet another room."));
  }

  #measure(event: PointerEvent): Stroke {
    const before = this.#measured;
    const show = (points: readonly Point[], isDone = false): void => this.words.measured((this.#measured = points), isDone);
    const now = [...(before.length === 2 ? [] : before), this.sheet.at(event)];
    show(now);
    return { move: () => undefined, end: () => show(now, true), undo: () => show(before) };
  }
}

