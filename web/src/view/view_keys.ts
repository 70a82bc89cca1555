/** Keys that do on the house what a drag, the wheel and a click do: turn it, come nearer, open a door or a cupboard. */
import { isTyped } from "../panel/typing";
import type { OrbitStep } from "./orbiting";

export interface ViewActs {
  /** Whether a piece is chosen: arrows move that. */
  hasChosen(): boolean;
  orbit(step: OrbitStep): void;
  /** The chosen piece's fronts, else the door in view. */
  toggleDoor(): void;
  /** All fronts of the house. */
  toggleAll(): void;
}

const TURN = Math.PI / 18;
const NEARER = 1.2;

const ARROWS: Readonly<Record<string, OrbitStep>> = {
  ArrowLeft: { right: -TURN }, ArrowRight: { right: TURN }, ArrowUp: { up: TURN }, ArrowDown: { up: -TURN },
};
/** With Shift, what is looked at. */
const ASIDE = 60;
const SHIFTED: Readonly<Record<string, OrbitStep>> = {
  ArrowLeft: { east: -ASIDE }, ArrowRight: { east: ASIDE }, ArrowUp: { north: ASIDE }, ArrowDown: { north: -ASIDE },
};
const ZOOM: Readonly<Record<string, OrbitStep>> = { "+": { nearer: NEARER }, "=": { nearer: NEARER }, "-": { nearer: 1 / NEARER } };

/** What lies over the house and scrolls by itself. */
const OVER = ".palette, .messages";

/** Whether arrows are for the house: it has the focus, or nothing has and there is nothing to scroll. */
function isOnHouse(target: Element | null): boolean {
  const { scrollHeight, clientHeight } = document.documentElement;
  if (target === document.body) return scrollHeight <= clientHeight;
  return target?.closest("#stage") != null && !target.closest(OVER);
}

function actOf(event: KeyboardEvent, acts: ViewActs): (() => void) | null {
  const target = event.target instanceof Element ? event.target : null;
  if (event.defaultPrevented || isTyped(event)) return null;
  if (event.key.toLowerCase() === "t") return event.repeat ? null : () => (event.shiftKey ? acts.toggleAll() : acts.toggleDoor());
  const arrows = event.shiftKey ? SHIFTED : ARROWS;
  const step = ZOOM[event.key] ?? (!acts.hasChosen() && isOnHouse(target) ? arrows[event.key] : undefined);
  return step ? () => acts.orbit(step) : null;
}

export function listenToViewKeys(acts: ViewActs): void {
  document.addEventListener("keydown", (event) => {
    const act = actOf(event, acts);
    if (!act) return;
    event.preventDefault();
    act();
  });
}
