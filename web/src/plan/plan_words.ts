/** The service's drawing of a plan, its words as the page says them: rooms, title, and numbers with the reader's point. */
import type { Scene } from "../contract";
import { sayDecimals, sayName } from "../words/language";
import { tell } from "../words/telling";
import englishNames from "../words/names.en.json";

const NAMES: Readonly<Record<string, string>> = englishNames;
const TEXT = /(<text [^>]*?)>([^<]+)(?=<\/text>)/g;
const SIZE = / font-size="(\d+)"/;

const capital = (words: string): string => words.charAt(0).toUpperCase() + words.slice(1);

/** What rooms are called, by what the service may have written for their types. */
function roomsCalled({ rooms }: Pick<Scene, "rooms">): ReadonlyMap<string, string> {
  return new Map(rooms.flatMap(({ type }) => [type.replaceAll("_", " "), NAMES[type] ?? type].map((written) => [capital(written), capital(sayName(type))] as const)));
}

/** Written smaller where it has become longer: a name keeps to its place. */
function fitted(start: string, before: string, after: string): string {
  return after.length <= before.length ? start : start.replace(SIZE, (_, size: string) => ` font-size="${Math.round((Number(size) * before.length) / after.length)}"`);
}

/** The drawing of a scene in the reader's words. */
export function inPageWords(svg: string, scene: Pick<Scene, "rooms">): string {
  const called = roomsCalled(scene);
  return svg.replace(TEXT, (_, start: string, written: string) => {
    const name = start.includes('class="name"') ? called.get(written) : undefined;
    const words = name === undefined ? sayDecimals(tell(written)) : name.replaceAll("&", "&amp;").replaceAll("<", "&lt;");
    return `${name === undefined ? start : fitted(start, written, words)}>${words}`;
  });
}
