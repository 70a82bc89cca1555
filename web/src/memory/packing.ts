/** A home's changes as the text that a link carries: JSON, deflated, in the letters of base64url; and back. */
import type { Change } from "./changes";

/** What a link carries beside the request. */
export interface Carried {
  /** The mark of the home that the request makes: of another one the changes do not speak. */
  readonly of: string;
  readonly change: Change;
}

/** What a link may unfold to [bytes]: more than any home that the service takes. */
const MOST_BYTES = 8_000_000;
/** So many bytes at a time become letters. */
const SLICE = 4096;

/** A short mark of a document's text: another text has another one, as good as always. */
export function markOf(document: unknown): string {
  let [one, other] = [0xdeadbeef, 0x41c6ce57];
  for (const letter of JSON.stringify(document)) {
    const code = letter.codePointAt(0) ?? 0;
    one = Math.imul(one ^ code, 2654435761);
    other = Math.imul(other ^ code, 1597334677);
  }
  return (4294967296 * (2097151 & other) + (one >>> 0)).toString(36);
}

async function through(bytes: Uint8Array<ArrayBuffer>, stream: GenericTransformStream): Promise<Uint8Array> {
  const reader = (new Blob([bytes]).stream().pipeThrough(stream) as ReadableStream<Uint8Array>).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  for (let next = await reader.read(); !next.done; next = await reader.read()) {
    length += next.value.length;
    if (length > MOST_BYTES) throw new RangeError("The link holds too much.");
    parts.push(next.value);
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

export async function packed(carried: Carried): Promise<string> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify(carried)), new CompressionStream("deflate-raw"));
  let letters = "";
  for (let at = 0; at < bytes.length; at += SLICE) letters += String.fromCharCode(...bytes.subarray(at, at + SLICE));
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/** Throws where the text is none that `packed` wrote. */
export async function unpacked(text: string): Promise<Carried> {
  const letters = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  const bytes = await through(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)), new DecompressionStream("deflate-raw"));
  const carried = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes)) as Partial<Carried> | null;
  if (typeof carried?.of !== "string" || typeof carried.change !== "object") throw new TypeError("The link is damaged.");
  return { of: carried.of, change: carried.change };
}
