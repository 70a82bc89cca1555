/** What became of a file that was read: what is to be checked, was guessed, left out and changed, each in the service's words. */
import type { FurnishAnswer, ImportAnswer, Scene } from "../contract";
import { button, made } from "../made";
import { ServiceProblem, type GivenFile } from "../service";
import { inWords } from "./programme";
import { roomNames } from "./room";
import { capital, say, sayDecimals, type Words } from "../words/language";
import { tell, tellPlainly, tellSentence } from "../words/telling";

/** What was said of a file; a plan that was drawn has nothing of it. */
type Read = Pick<ImportAnswer, "scene" | "changes" | "guesses" | "unread" | "issues">;

/** A storey that was left out, as the service calls its place in the file. */
const STOREY = /^level (-?\d+)(?: \(|$)/;
/** The units that a plan may be in, as the service calls them. */
const UNITS = { m: "metres", cm: "centimetres", mm: "millimetres", in: "inches", ft: "feet" } as const satisfies Readonly<Record<string, Words>>;
const PLAN_RULES: ReadonlySet<string> = new Set(["rooms_overlap", "opening_wrong"]);

/** Which rooms indoors nobody can come into, in words; of all at once where there is no door at all. */
export function doorlessIn({ rooms }: Pick<Scene, "rooms">): readonly { readonly room: string | null; readonly words: string }[] {
  const names = roomNames({ rooms });
  const indoors = rooms.filter(({ outdoor }) => !outdoor);
  const closed = indoors.filter(({ openings }) => openings.every(({ kind }) => kind === "window"));
  if (closed.length > 1 && closed.length === indoors.length) return [{ room: null, words: say("No room has a door") }];
  return closed.map(({ id }) => ({ room: id, words: say("{room} has no door", { room: capital(names.get(id) ?? id) }) }));
}

/** What somebody should look at in a plan, furnished or not: what breaks a rule about it, and that a room or the home has no way in. */
function toCheck(issues: Read["issues"], scene: Pick<Scene, "rooms">): string[] {
  const wrong = [...issues.filter(({ rule }) => PLAN_RULES.has(rule)).map(({ message }) => tellSentence(message, scene)), ...doorlessIn(scene).map(({ words }) => words)];
  const leadsOut = scene.rooms.some(({ openings }) => openings.some(({ kind, connects_to: to }) => kind !== "window" && (to === "EXTERIOR" || to === null)));
  const isHome = scene.rooms.filter(({ outdoor }) => !outdoor).length > 1;
  return isHome && !leadsOut ? [...wrong, say("No door leads outside: ways are judged from the largest piece of free floor")] : wrong;
}

/** The list's parts, those with nothing to say left out; `first` of what was guessed, more than the file did. */
export function importLines({ scene, changes, guesses, unread, issues }: Read, first: readonly string[] = []): { readonly title: string; readonly lines: readonly string[] }[] {
  const known = new Set(scene.rooms.flatMap((room) => [room, ...room.furniture, ...room.decorations, ...room.openings].map(({ id }) => id)));
  const isOfScene = (of: string): boolean => known.has(of) || known.has(of.split("/")[0] ?? ""); // what was left out of a room is in none
  const called = (of: string): string => (of === "plan" ? say("Plan") : isOfScene(of) ? tellSentence(of, scene) : tellPlainly(of));
  const told = (words: string): string => tell(words, scene);
  const parts = [
    { title: say("To be checked"), lines: toCheck(issues, scene) },
    { title: say("Guessed"), lines: [...first, ...guesses.map(({ of, what, taken, message }) => `${called(of)}, ${told(what)}: ${sayDecimals(told(taken))}; ${told(message)}`)] },
    { title: say("Left out"), lines: unread.map(({ place, reason }) => `${called(place)}: ${told(reason)}`) },
    { title: say("Changed"), lines: changes.map(({ of, message }) => (message.split(" ").includes(of) || of === "plan" ? tellSentence(message, scene) : `${called(of)}: ${told(message)}`)) },
  ];
  return parts.filter(({ lines }) => lines.length > 0);
}

/** What the service took the rooms of a plan for, and what told it; `plan` as it was sent. */
export function guessLines({ guesses, entrance }: Pick<FurnishAnswer, "guesses" | "entrance">, plan: Pick<Scene, "rooms">): string[] {
  const names = roomNames(plan);
  const called = (id: string): string => capital(names.get(id) ?? id);
  const why = ({ by, sent, instead }: FurnishAnswer["guesses"][number]): string => {
    if (by === "name") return say("told by its name, {name}", { name: sent });
    if (by === "pieces") return say("told by what stands in it");
    return instead === null ? say("told by its form") : say("told by its form; next best: {other}", { other: inWords(instead) });
  };
  const rooms = guesses.map((guess) => `${called(guess.room)}: ${inWords(guess.type)}, ${why(guess)}`);
  return entrance ? [...rooms, say("One comes in by {door}: {room}", { door: tellPlainly(entrance.id), room: called(entrance.room) })] : rooms;
}

/** What else to ask for of a file. */
type Asked = Pick<GivenFile, "level" | "unit">;
type Way = readonly [words: string, asked: Asked];

/** The storeys of a file that were left out, in the order in which that is told. */
function storeysLeft({ unread }: Pick<ImportAnswer, "unread">): Way[] {
  return unread.flatMap(({ place }) => STOREY.exec(place)?.[1] ?? []).map(Number).map((level) => [say("Open storey {level}", { level }), { level }]);
}

/** The units in which a file may be read, but the one it was read in. */
function unitsBut(taken: string | null): Way[] {
  return Object.entries(UNITS).filter(([unit]) => unit !== taken).map(([unit, words]) => [say("Read it in {unit}", { unit: say(words) }), { unit }]);
}

/** What else to ask for of a file that was read: another storey; another unit than was asked for or guessed. */
function waysOf(read: ImportAnswer, { unit }: Asked): Way[] {
  const taken = unit ?? read.guesses.find(({ of, what }) => of === "plan" && what === "unit")?.taken;
  return [...storeysLeft(read), ...(taken === undefined ? [] : unitsBut(taken))];
}

/** Why a file was refused, with the units it may be read in where it was for the want of one. */
export function offeringUnits(reason: unknown, open: (asked: Asked) => void): unknown {
  if (!(reason instanceof ServiceProblem) || !reason.fields.some(({ field, allowed }) => field === "unit" || allowed.includes("`unit`"))) return reason;
  return new ServiceProblem(reason.title, reason.detail, { ...reason, ways: unitsBut(null).map(([words, asked]) => [words, () => open(asked)]) });
}

export class ImportReport {
  #read: ImportAnswer | null = null;
  #ways: readonly Way[] = [];
  /** Reads the file with something else asked for. */
  #open: (asked: Asked) => void = () => undefined;

  constructor(readonly host: HTMLElement, readonly list: HTMLElement) {}

  /** Shows what there is to say of a file, of which something else may be asked for than was; null: nothing was read. */
  show(answer: ImportAnswer | null, asked: Asked = {}, open: (asked: Asked) => void = () => undefined): void {
    [this.#read, this.#ways, this.#open] = [answer, answer ? waysOf(answer, asked) : [], open];
    this.#list(say("What the file became"), answer ? importLines(answer) : []);
  }

  /** Shows what was guessed of a plan that was furnished, before what was said of its file; and what drawing it `left` out. */
  guessed(answer: Pick<FurnishAnswer, "guesses" | "entrance" | "issues">, plan: Scene, left = ""): void {
    const lines = guessLines(answer, plan);
    if (!this.#read) this.#ways = [];
    if (lines.length === 0 && left === "" && toCheck(answer.issues, plan).length === 0) return;
    const known = new Set(answer.guesses.map(({ room }) => room));
    const { guesses, ...read } = this.#read ?? { scene: plan, changes: [], guesses: [], unread: [] };
    const parts = importLines({ ...read, issues: answer.issues, guesses: guesses.filter(({ of, what }) => what !== "type" || !known.has(of)) }, lines);
    this.#list(say("What the plan became"), left === "" ? parts : [{ title: say("Left out"), lines: [left] }, ...parts]);
  }

  #list(words: string, parts: ReturnType<typeof importLines>): void {
    for (const head of this.host.querySelectorAll("h2")) head.textContent = words;
    this.list.ariaLabel = words;
    this.host.hidden = this.#ways.length + parts.length === 0;
    const others = this.#ways.map(([does, asked]) => button(does, () => this.#open(asked)));
    this.list.replaceChildren(...others, ...parts.flatMap(({ title, lines }) => [
      made("h3", {}, `${title} (${lines.length})`), made("ul", {}, ...lines.map((line) => made("li", {}, line))),
    ]));
  }
}
