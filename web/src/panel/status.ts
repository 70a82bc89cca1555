/** The status bar: how much there is of what, how many issues, how long it took. */
import type { GenerateAnswer, Issue, Scene } from "../contract";

export interface Counts {
  readonly rooms: number;
  readonly doors: number;
  readonly windows: number;
  readonly furniture: number;
  readonly issues: number;
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
    issues: issues.length,
  };
}

/** The whole time of an answer [ms]: its total where it has one, else the sum of its stages. */
export function totalMs(timing: GenerateAnswer["timing_ms"]): number {
  if (typeof timing === "number") return timing;
  return timing.total ?? Object.values(timing).reduce((sum, stage) => sum + stage, 0);
}

function timeWords(ms: number): string {
  return ms >= 1000 ? `${(ms / 1000).toFixed(1)} s` : `${ms < 10 ? ms.toFixed(1) : ms.toFixed(0)} ms`;
}

export function showStatus(host: HTMLElement, counts: Counts, timing: GenerateAnswer["timing_ms"]): void {
  const said = { ...counts, time: timeWords(totalMs(timing)) };
  for (const [name, value] of Object.entries(said)) {
    const place = host.querySelector<HTMLElement>(`[data-count="${name}"]`);
    if (place) place.textContent = String(value);
  }
  host.querySelector("[data-count='issues']")?.parentElement?.classList.toggle("has-issues", counts.issues > 0);
}
