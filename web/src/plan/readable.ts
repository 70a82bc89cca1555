/** How large a plan's words are drawn for the size at which it is seen. Pure. */

/** How high numbers are at least on the screen [px]. */
export const LEAST = 11;
/** How high numbers and names are on paper [mm]; how high names alone are at least on the screen [px]. */
const [NUMBERS, NAMES, LEAST_ALONE] = [2.1, 2.5, 13];
/** The scales that are asked for, each so much larger than the one before; and up to which one a plan has its lengths. */
const [SMALLEST, STEP, LARGEST, ROOMY] = [20, 1.1, 2000, 200];

/** A millimetre of the house is so many pixels at least where lengths are shown. */
export const SIZED = LEAST / (NUMBERS * ROOMY);

/** How a sheet is drawn that is read where a millimetre of the house is so many pixels: its scale, and whether there is room for lengths. */
export function readableAt(pixels: number): { readonly scale: number; readonly lengths: boolean } {
  const step = (least: number): number => Math.round(SMALLEST * STEP ** Math.max(0, Math.ceil(Math.log(least / SMALLEST) / Math.log(STEP))));
  const lengths = pixels >= SIZED;
  return { scale: Math.min(LARGEST, lengths ? step(LEAST / (NUMBERS * pixels)) : step(LEAST_ALONE / (NAMES * pixels))), lengths };
}
