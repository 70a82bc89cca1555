/** What the service says, in the reader's language: in English as it comes, else by the forms that it says things in; ids are called as a person calls them. */
import { capital, say, sayName, sayNumber, spoken, TOLD } from "./language";

/** A way to say something: what it looks like, what its holes are called, and how it is said in the reader's language. */
interface Form {
  readonly looks: RegExp;
  readonly holes: readonly string[];
  readonly words: string;
  readonly own: number;
}

const HOLE = /\{(\w+)\}/;
/** A hole of this name holds a number. */
const NUMBER_HOLE = /^n\d?$/;
/** A hole of this name holds sentences, with `and` between them. */
const SENTENCES_HOLE = "whys";
const NUMBER = "-?\\d+(?:,\\d{3})*(?:\\.\\d+)?(?:e[+-]?\\d+)?";
/** What somebody wrote: it is nobody's to tell otherwise. */
const QUOTED = /^(?:'[^']*'|"[^"]*")$/;
/** Nothing is nested deeper than this. */
const DEEPEST = 8;
const NUMBERED = / \d+$/;
/** A sentence has more letters of its own; no form has as many as `FAR`. */
const SENTENCE = 12;
const FAR = 1000;
const SUM = " + ";
/** As the service writes them, in ASCII. */
const SQUARE_METRES = /(?<=\d )m2\b/g;
/** An id or a name of the catalogs, alone; and those within words: parts that are joined, or letters and a number, as files of others call rooms. */
const ID = /^(?:[\p{L}\d_]+\/)?[\p{L}_][\p{L}\d_]*$/u;
const IDS = /(?<![\p{L}\d_/'"])(?:(?:[\p{L}\d_]+\/)?[\p{L}\d]+(?:_[\p{L}\d]+)+|(?<!\d )\p{L}+\d+)(?![\p{L}\d_/])/gu;

/** An id of a piece, or of what has a number: a door, a person. */
const OF_A_HOME = /\/|_\d+$/;
/** A kind that the id after it begins with, too: the door door_2. */
const KIND_BEFORE = /\bthe (\w+) (?=\1_\d+\b)/g;
/** What may be a room's id with its type. */
const TYPE_BEHIND = /(\S+) \((\w+)\)/g;

const escaped = (text: string): string => text.replace(/[\\^$.*+?()[\]{}|/]/g, "\\$&");

/** The forms: those first that begin with words of their own, of them those that say most with these. */
function formsOf(table: Readonly<Record<string, string>>): Form[] {
  const rank = (english: string): number => ownIn(english) - (/^\{(?!n\d?\})/.test(english) ? FAR : 0);
  return Object.entries(table).sort(([one], [other]) => rank(other) - rank(one)).map(([english, words]) => {
    const parts = english.split(HOLE); // text and names of holes in turn
    const looks = parts.map((part, at) => (at % 2 === 0 ? escaped(part) : NUMBER_HOLE.test(part) ? `(${NUMBER})` : "(.+?)")).join("");
    return { looks: new RegExp(`^${looks}$`, "s"), holes: parts.filter((_, at) => at % 2 === 1), words, own: ownIn(english) };
  });
}

/** How many letters of a form are its own. */
function ownIn(english: string): number {
  return english.replace(/\{\w+\}/g, "").length;
}

let forms: readonly Form[] | null = null;

/** What a piece, a room or a kind is called, by its id or name; null for what is neither. */
type Called = (id: string) => string | null;
type Rooms = readonly { readonly id: string; readonly type: string; readonly name?: string | null }[];

/** How a person calls an id: its kind, and its number where it is not the first. */
export function idWords(id: string): string {
  const name = id.split("/").at(-1) ?? id;
  const [, kind = name, number = "1"] = /^(.*?)_(\d+)$/.exec(name) ?? [];
  return number === "1" ? sayName(kind) : `${sayName(kind)} ${number}`;
}

/** Words as they stand in a sentence: what has a number goes without "the": bedroom 2; so does a name of its own. */
function withThe(words: string, isOwn = false): string {
  return TOLD || isOwn || NUMBERED.test(words) ? words : `the ${words}`;
}

/** The same within a sentence. */
export function theWords(id: string): string {
  return withThe(idWords(id));
}

/** What a room is called, by its own name, else numbered where there are several of its type; null for what is no room's id. */
function roomWords(id: string, rooms: Rooms): string | null {
  const room = rooms.find((one) => one.id === id);
  if (!room) return null;
  if (room.name) return room.name;
  const alike = rooms.filter(({ type }) => type === room.type);
  return sayName(room.type) + (alike.length > 1 ? ` ${alike.indexOf(room) + 1}` : "");
}

/** Words by the form they are in, what is in its holes told in turn; null where they are in none with so many letters of its own. */
function formed(english: string, name: Called, depth: number, least = 0): string | null {
  if (depth > DEEPEST) return null;
  for (const { looks, holes, words, own } of (forms ??= formsOf(TOLD ?? {}))) {
    const found = own >= least ? looks.exec(english) : null;
    if (!found) continue;
    const values = new Map(holes.map((hole, at) => [hole, found[at + 1] ?? ""]));
    return words.replace(/\{(\w+)\}/g, (_, hole: string) => {
      const said = values.get(hole) ?? "";
      const sentences = hole === SENTENCES_HOLE ? row(said, / and /, (one) => formed(one, name, depth + 1, SENTENCE)) : null;
      return sentences ?? part(said, name, depth + 1);
    });
  }
  return null;
}

/** Several of a kind in a row, each told by itself; null where one cannot be. */
function row(english: string, parts: RegExp, told: (one: string) => string | null): string | null {
  const said = english.split(parts).map(told);
  if (said.length < 2 || said.some((one) => one === null)) return null;
  return english.includes(SUM) ? said.join(SUM) : say("{some} and {last}", { some: said.slice(0, -1).join(", "), last: said.at(-1) ?? "" });
}

function part(english: string, name: Called, depth: number): string {
  if (QUOTED.test(english)) return english;
  const one = (words: string): string | null => formed(words, name, depth + 1) ?? spoken(words) ?? name(words);
  return (english.includes(SUM) && !english.includes(" = ") ? row(english, / \+ /, one) : null)
    ?? formed(english, name, depth) ?? spoken(english) ?? row(english, /, | and /, one) ?? name(english) ?? numbers(english);
}

function numbers(english: string): string {
  return english.replace(new RegExp(`(?<![\\w.])${NUMBER}(?![\\w.])`, "g"), (number) => sayNumber(Number(number.replaceAll(",", "")), number.split(".")[1]?.length ?? 0));
}

/** What the service says of a scene, or of none that is known. */
export function tell(said: string, { rooms }: { readonly rooms: Rooms } = { rooms: [] }): string {
  const told = formed(said, (id) => roomWords(id, rooms) ?? (ID.test(id) ? idWords(id) : null), 0);
  if (told !== null) return told;
  const untyped = said.replace(TYPE_BEHIND, (whole, id, type) => (rooms.some((one) => one.id === id && one.type === type) ? id : whole) as string);
  return untyped.replace(KIND_BEFORE, "").replace(SQUARE_METRES, "m²").replace(IDS, (id) => {
    const words = roomWords(id, rooms);
    if (words === null && !id.includes("_")) return id; // a letter and a number that no room is called
    return words === null && !OF_A_HOME.test(id) ? idWords(id) : withThe(words ?? idWords(id), rooms.some((one) => one.id === id && one.name));
  });
}

/** What the service says of a document: ids and keys stay as they are written there. */
export function tellPlainly(said: string): string {
  return spoken(said) ?? formed(said, () => null, 0) ?? said; // what the page says of its own fits many forms: none knows it as a whole
}

/** The same as `tell`, begun as a sentence begins. */
export function tellSentence(said: string, scene?: { readonly rooms: Rooms }): string {
  return capital(tell(said, scene));
}
