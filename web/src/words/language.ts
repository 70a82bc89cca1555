/** The page's words in the reader's language: English stands in the code, each other language in a table keyed by the English. */
import { remember, remembered } from "../panel/preferences";
import german from "./de.json";
import germanNames from "./names.de.json";
import englishNames from "./names.en.json";
import germanTold from "./told.de.json";

/** What the page says of its own: what is missing in a table is refused when types are checked. */
export type Words = keyof typeof german;
/** What stands for a `{name}` in the words. */
export type Values = Readonly<Record<string, string | number>>;
type Table = Readonly<Record<string, string>>;

const NAME = "language";
const ENGLISH = "en";
const TABLES: Readonly<Record<string, { readonly words: Table; readonly names: Table; readonly told: Table }>> = {
  de: { words: german, names: germanNames, told: germanTold },
};
/** Names whose parts stand in another order, or are written otherwise, than one says them. */
const ENGLISH_NAMES: Table = englishNames;
const SPOKEN = ["aria-label", "title", "placeholder", "alt", "label"];
const UNSPOKEN = "script, style, kbd";

/** The language that was chosen, else the browser's first, where there is a table of it; else English. */
export function languageOf(chosen: string | null, browser: string | undefined): string {
  const wanted = [chosen ?? "", (browser ?? "").split("-")[0] ?? ""].find((one) => one === ENGLISH || Object.hasOwn(TABLES, one));
  return wanted ?? ENGLISH;
}

const language = languageOf(remembered(NAME), globalThis.navigator?.language);
const table = TABLES[language];
/** How the service's forms are said, by the English; null where they are said as they come. */
export const TOLD: Table | null = table?.told ?? null;
/** What parts whole numbers from their fractions. */
const POINT = (1.5).toLocaleString(language).charAt(1);

/** A number of so many places; `short`: of no more than it needs. */
export function sayNumber(value: number, places: number, form: "whole" | "short" = "whole"): string {
  const written = value.toFixed(places);
  return (form === "short" ? String(Number(written)) : written).replace(".", POINT);
}

/** An area [m²]: half a tenth is more, whatever a sum of parts made of its last digits. */
export function sayArea(area: number): string {
  return `${sayNumber(area + 1e-7, 1)} m²`;
}

/** Words in which numbers have the reader's point, where they are nothing but a number, with its unit or without. */
export function sayDecimals(words: string): string {
  return words.replace(/^(\d+)\.(\d+)(?=$|[ ¹²³⁴-⁹])/, `$1${POINT}$2`);
}

/** Words of the page, or of somebody else where they are known, with values for their `{names}`. */
export function sayAny(english: string, values: Values = {}): string {
  return (table?.words[english] ?? english).replace(/\{(\w+)\}/g, (whole, name: string) => String(values[name] ?? whole));
}

/** Words that the table has, in the reader's language; null for others. */
export function spoken(english: string): string | null {
  return table && Object.hasOwn(table.words, english) ? (table.words[english] ?? null) : null;
}

/** Words of the page in the reader's language. */
export function say(english: Words, values: Values = {}): string {
  return sayAny(english, values);
}

/** What a name of the catalogs is called: `living_room` is a living room, `bedroom_master` a master bedroom; one that no table has is read as it stands. */
export function sayName(name: string): string {
  const names = table?.names ?? ENGLISH_NAMES;
  return (Object.hasOwn(names, name) ? names[name] : undefined) ?? name.replaceAll("_", " ");
}

/** Words as they begin a line. */
export function capital(words: string): string {
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** All places of a document where words stand: each is told its words and given others. */
export function eachWords(root: Element, change: (english: string) => string): void {
  const within = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  for (let node = within.nextNode(); node; node = within.nextNode()) {
    const text = node.nodeValue ?? "";
    const words = text.trim().replace(/\s+/g, " ");
    if (words !== "" && !node.parentElement?.closest(UNSPOKEN)) node.nodeValue = text.replace(text.trim(), () => change(words));
  }
  for (const name of SPOKEN) {
    for (const element of root.querySelectorAll(`[${name}]`)) {
      const words = element.getAttribute(name) ?? "";
      if (words !== "") element.setAttribute(name, change(words));
    }
  }
}

/** Says in the reader's language what the document says in English. */
export function sayDocument(): void {
  document.documentElement.lang = language;
  if (table) eachWords(document.body, (english) => sayDecimals(sayAny(english)));
}

/** Does so, and lets another language be chosen: the page then begins anew, as it was left. */
export function speak(): void {
  sayDocument();
  const choice = document.getElementById(NAME) as HTMLSelectElement;
  choice.value = remembered(NAME) ?? "";
  (document.getElementById("language_words") as HTMLElement).hidden = !table;
  choice.addEventListener("change", () => {
    remember(NAME, choice.value);
    location.reload();
  });
}
