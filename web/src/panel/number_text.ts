/** Text for number fields. */

/** What a number field takes; any other text it rejects, and the browser says so on the console. */
const NUMBER = /^-?(\d+(\.\d+)?|\.\d+)(e[-+]?\d+)?$/i;

/** The text as a number field takes it: nothing where it is no number that the field can hold. */
export function asNumber(text: string): string {
  return NUMBER.test(text) && Number.isFinite(Number(text)) ? text : "";
}
