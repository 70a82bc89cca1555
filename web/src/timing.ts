/** How long the page's own steps take, told to the browser's performance tools: a mark at both ends and a measure between. */
export type Step = "house built" | "house drawn" | "text shown" | "frame answered" | "drag followed";

export function timed<Made>(step: Step, take: () => Made): Made {
  const [start, end] = [`${step}: start`, `${step}: end`];
  performance.mark(start);
  const made = take();
  performance.mark(end);
  performance.measure(step, start, end);
  return made;
}

/** The same of what was done in another thread, until now [ms]. */
export function tookSoLong(step: Step, took: number): void {
  const end = performance.now();
  performance.measure(step, { start: Math.max(0, end - took), end });
}
