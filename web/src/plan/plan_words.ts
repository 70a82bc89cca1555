/** The service's drawing of a plan, its words as the page says them: rooms, title, and numbers with the reader's point. */
import type { Scene } from "../contract";
import { sayDecimals, sayName } from "../words/language";
import { tell } from "../words/telling";
import englishNames from "../words/names.en.json";

const NAMES: Readonly<Record<string, string>> = englishNames;
const TEXT = /(<text [^>]*?)>([^<]+)(?=<\/text>)/g;
/** A room's name on its light ground: the ground up to its width, its width and its height, what lies between, the size of the letters, the name. */
const NAME = /(<rect class="back" x=")(-?\d+)(" y=")(-?\d+)(" width=")(\d+)(" height=")(\d+)("[^>]*><g([^>]*)><text class="name"[^>]*? font-size=")(\d+)(">)([^<]+)/g;

const capital = (words: string): string => words.charAt(0).toUpperCase() + words.slice(1);

/** What rooms are called, by what the service may have written for their types. */
function roomsCalled({ rooms }: Pick<Scene, "rooms">): ReadonlyMap<string, string> {
  return new Map(rooms.flatMap(({ type }) => [type.replaceAll("_", " "), NAMES[type] ?? type].map((written) => [capital(written), capital(sayName(type))] as const)));
}

/** Names in other words: one that has become longer has smaller letters, and a longer ground, by as much. */
function renamed(svg: string, called: ReadonlyMap<string, string>): string {
  return svg.replace(NAME, (_, a: string, x: string, b: string, y: string, c: string, width: string, d: string, height: string, e: string, turn: string, size: string, f: string, written: string) => {
    const name = called.get(written)?.replaceAll("&", "&amp;").replaceAll("<", "&lt;") ?? written;
    const more = Math.sqrt(Math.max(1, name.length / written.length));
    const longer = (along: boolean, from: string, length: string): [number, number] => {
      const by = along ? Number(length) * (more - 1) : 0;
      return [Math.round(Number(from) - by / 2), Math.round(Number(length) + by)];
    };
    const [[left, wide], [top, high]] = [longer(turn === "", x, width), longer(turn !== "", y, height)];
    return `${a}${left}${b}${top}${c}${wide}${d}${high}${e}${Math.round(Number(size) / more)}${f}${name}`;
  });
}

/** The drawing of a scene in the reader's words. */
export function inPageWords(svg: string, scene: Pick<Scene, "rooms">): string {
  const named = renamed(svg, roomsCalled(scene));
  return named.replace(TEXT, (_, start: string, written: string) => `${start}>${start.includes('class="name"') ? written : sayDecimals(tell(written))}`);
}
