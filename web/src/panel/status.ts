/** The status bar: how much there is of what, how many issues, how long it took. */
import type { GenerateAnswer, Issue, Scene } from "../contract";
import type { Shown } from "../state/home";
import { roomNames } from "./room";
import { say, sayNumber, type Words } from "../words/language";

export interface Counts {
  readonly rooms: number;
  readonly doors: number;
  readonly windows: number;
  readonly furniture: number;
  readonly decorations: number;
  readonly issues: number;
}

/** What is counted, where there is one of it and where there are others: the page's words beside the number. */
const COUNTED: Readonly<Record<keyof Counts | "warnings", readonly [one: Words, others: Words]>> = {
  rooms: ["room", "rooms"],
  doors: ["door", "doors"],
  windows: ["window", "windows"],
  furniture: ["piece of furniture", "furniture"],
  decorations: ["decoration", "decorations"],
  issues: ["broken rule", "broken rules"],
  warnings: ["warning", "warnings"],
};

function counted(name: keyof typeof COUNTED, count: number): string {
  const [one, others] = COUNTED[name];
  return say(count === 1 ? one : others);
}

/** The rooms that nothing was put into yet, and that no rule is broken by: an empty plan lacks its furniture, it is not wrong. */
export function unfurnishedOf({ rooms, certificate }: Scene): ReadonlySet<string> {
  return new Set(rooms.filter(({ id, furniture }) => furniture.length === 0 && certificate?.rooms?.[id] === undefined).map(({ id }) => id));
}

/** The issues but for what rooms lack that are not furnished yet. */
export function brokenOf(issues: readonly Issue[], scene: Scene): readonly Issue[] {
  const unfurnished = unfurnishedOf(scene);
  return issues.filter(({ rule, room }) => rule !== "missing_required" || !unfurnished.has(room ?? ""));
}

/** How many rooms lack what they need, since they are not furnished yet, in words; empty where there is none. Rooms of no known type need nothing, until all are empty. */
export function unfurnishedWords(issues: readonly Issue[], scene: Scene): string {
  if (scene.rooms.length > 0 && unfurnishedOf(scene).size === scene.rooms.length) return say("Not furnished yet");
  const broken = new Set(brokenOf(issues, scene));
  const count = new Set(issues.filter((issue) => !broken.has(issue)).map(({ room }) => room)).size;
  if (count === 1) return say("1 room not furnished yet");
  return count > 0 ? say("{count} rooms not furnished yet", { count }) : "";
}

/** Counts a scene; a door listed by both its rooms under one id is one door, a passage is a door without a leaf. */
export function countsOf(scene: Scene, issues: readonly Issue[]): Counts {
  const openings = new Map(scene.rooms.flatMap((room) => room.openings.map((opening) => [opening.id, opening.kind] as const)));
  const kinds = [...openings.values()];
  return {
    rooms: scene.rooms.length,
    doors: kinds.filter((kind) => kind !== "window").length,
    windows: kinds.filter((kind) => kind === "window").length,
    furniture: scene.rooms.reduce((sum, room) => sum + room.furniture.length, 0),
    decorations: scene.rooms.reduce((sum, room) => sum + room.decorations.length, 0),
    issues: issues.length,
  };
}

/** The whole time of an answer [ms]: its total where it has one, else the sum of its stages. */
export function totalMs(timing: GenerateAnswer["timing_ms"]): number {
  if (typeof timing === "number") return timing;
  return timing.total ?? Object.values(timing).reduce((sum, stage) => sum + stage, 0);
}

/** Nothing where nothing was made: a file was only read. */
function timeWords(ms: number): string {
  if (ms === 0) return "";
  return ms >= 1000 ? `${sayNumber(ms / 1000, 1)} s` : `${sayNumber(ms, ms < 10 ? 1 : 0)} ms`;
}

/** What the certificate proves, in short and in full; null where it says nothing of rooms. Of rooms that were only left as they were nothing was to be proven. */
export function optimalityOf(scene: Scene): { readonly short: string; readonly full: string } | null {
  const [names, rooms] = [roomNames(scene), Object.entries(scene.certificate?.rooms ?? {})];
  const named = (found: typeof rooms): string => found.map(([id]) => names.get(id) ?? id).join(", ");
  const left = rooms.filter(([, { notes, ...more }]) => notes && Object.keys(more).length === 0);
  const placed = rooms.filter((room) => !left.includes(room));
  const [open, changed] = [false, undefined].map((wanted) => named(placed.filter(([, { proven }]) => proven === wanted)));
  const counts = { proven: placed.filter(([, room]) => room.proven).length, rooms: placed.length };
  const said: string[] = [];
  if (placed.length > 0) {
    said.push(open || changed
      ? say("No other placement of the pieces comes closer to what the room's rules want: proven for {proven} of {rooms} rooms.", counts)
      : say("No other placement of the pieces comes closer to what the room's rules want: proven for every room."));
  }
  if (open) said.push(say("The search ended at its limit in {rooms}.", { rooms: open }));
  if (changed) said.push(say("Changed since: {rooms}.", { rooms: changed }));
  if (left.length > 0) said.push(say("Left as they were: {rooms}.", { rooms: named(left) }));
  if (said.length === 0) return null;
  const short = placed.length > 0 ? say("proven optimal in {proven} of {rooms} rooms", counts)
    : left.length > 1 ? say("{count} rooms left as they were", { count: left.length }) : say("1 room left as it was");
  return { short, full: said.join(" ") };
}

function showOptimality(host: HTMLElement, scene: Scene): void {
  const place = host.querySelector<HTMLElement>("[data-count='optimality']");
  const said = optimalityOf(scene);
  if (!place) return;
  place.textContent = said?.short ?? "";
  place.title = said?.full ?? "";
}

/** Shows what is there, how good it is and how long it took. */
export function showShown(host: HTMLElement, { scene, issues, timing }: Shown): void {
  const [broken, empty] = [brokenOf(issues, scene), unfurnishedWords(issues, scene)];
  const errors = broken.filter(({ severity }) => severity === "error");
  const isWrong = errors.length > 0;
  showStatus(host, countsOf(scene, isWrong ? errors : broken), isWrong ? broken.length - errors.length : null, timing);
  const verdict = host.querySelector<HTMLElement>(".verdict");
  if (verdict) verdict.hidden = false; // of no home nothing is judged
  verdict?.classList.toggle("has-errors", isWrong);
  verdict?.classList.toggle("is-open", empty !== "");
  const place = host.querySelector<HTMLElement>(".unfurnished");
  if (place) place.hidden = empty === "";
  host.querySelector("[data-count='unfurnished']")?.replaceChildren(empty);
  showOptimality(host, scene);
}

/** `beside`: how many warnings there are beside errors; null where no rule is broken. */
function showStatus(host: HTMLElement, counts: Counts, beside: number | null, timing: GenerateAnswer["timing_ms"]): void {
  for (const [name, count] of Object.entries(counts) as [keyof Counts, number][]) {
    const place = host.querySelector<HTMLElement>(`[data-count="${name}"]`);
    if (!place) continue;
    const more = name === "issues" && beside ? `, ${beside} ${counted("warnings", beside)}` : "";
    place.textContent = String(count);
    place.nextSibling?.replaceWith(` ${counted(name === "issues" && beside === null ? "warnings" : name, count)}${more}`);
  }
  host.querySelector("[data-count='time']")?.replaceChildren(timeWords(totalMs(timing)));
  host.querySelector(".verdict")?.classList.toggle("has-issues", counts.issues > 0);
}
