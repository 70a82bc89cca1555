/** Scrolling a region alone: the page around it stays where it is. */

export interface Extent {
  readonly top: number;
  readonly bottom: number;
}

/** How far a region scrolls down so that a stretch of it is seen: no further than it must, not at all where it is seen. */
export function scrollToSee(stretch: Extent, seen: Extent): number {
  const [above, below] = [stretch.top - seen.top, stretch.bottom - seen.bottom];
  if (above < 0 && below < 0) return Math.max(above, below);
  return above > 0 && below > 0 ? Math.min(above, below) : 0;
}

/** Brings a part of a region into the region's view. */
export function bringIntoView(region: HTMLElement, part: HTMLElement): void {
  const top = region.getBoundingClientRect().top + region.clientTop;
  const by = scrollToSee(part.getBoundingClientRect(), { top, bottom: top + region.clientHeight });
  if (by !== 0) region.scrollTop += by;
}
