/** Lengths as they are read and typed. */
import { sayNumber } from "../words/language";

const UNITS: Readonly<Record<string, number>> = { "": 1000, m: 1000, cm: 10, mm: 1 };
const TYPED = /^([+-]?\d+(?:[.,]\d+)?|[+-]?[.,]\d+)\s*(m|cm|mm)?$/i;

/** A length as it is read: metres, to the millimetre where it is not of whole centimetres. */
export function lengthWords(gap: number): string {
  return `${sayNumber(gap / 1000, gap % 10 === 0 ? 2 : 3)} m`;
}

/** A length that was typed, in whole millimetres: metres where no unit is said. Null where it is none. */
export function lengthTyped(text: string): number | null {
  const [, number, unit = ""] = TYPED.exec(text.trim()) ?? [];
  if (number === undefined) return null;
  const millimetres = Math.round(Number(number.replace(",", ".")) * (UNITS[unit.toLowerCase()] ?? 1000));
  return Number.isFinite(millimetres) ? millimetres : null;
}
