/** The service's drawing of a plan, its words as the page says them: rooms, title, and numbers with the reader's point. */
import type { Scene } from "../contract";
import { capital, sayDecimals, sayName } from "../words/language";
import { tell } from "../words/telling";

const TEXT = /(<text [^>]*?)>([^<]+)(?=<\/text>)/g;

/** What the page calls the rooms of a scene, by their types. */
export function roomsCalled({ rooms }: Pick<Scene, "rooms">): Readonly<Record<string, string>> {
  return Object.fromEntries(rooms.map(({ type }) => [type, capital(sayName(type))]));
}

/** The drawing in the reader's words, but for the names of rooms, which it has already. */
export function inPageWords(svg: string): string {
  return svg.replace(TEXT, (_, start: string, written: string) => `${start}>${start.includes('class="name"') ? written : sayDecimals(tell(written))}`);
}
