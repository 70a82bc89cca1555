// @vitest-environment happy-dom
/** The page's words in other languages: every table has all that is shown, with the same values in it, and nothing else. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { KEY_LIST } from "../src/panel/key_list";
import german from "../src/words/de.json";
import { eachWords, languageOf, say, sayName } from "../src/words/language";

const SRC = join(import.meta.dirname, "../src");
/** Shown, and the same in every language: the names of the page, of its languages, of the north, units, signs and numbers. */
const OF_ALL = new Set(["Compose", "English", "Deutsch", "N", "m"]);

function shownWords(): string[] {
  const shown: string[] = [];
  for (const name of ["index", "embed"]) {
    const page = document.createElement("main");
    page.innerHTML = /<body[^>]*>(.*)<\/body>/s.exec(readFileSync(join(SRC, `../${name}.html`), "utf8"))?.[1] ?? "";
    eachWords(page, (words) => { shown.push(words); return words; });
  }
  return shown.filter((words) => /\p{L}/u.test(words) && !OF_ALL.has(words));
}

function sources(): string {
  const files = readdirSync(SRC, { recursive: true, encoding: "utf8" }).filter((name) => name.endsWith(".ts"));
  return files.map((name) => readFileSync(join(SRC, name), "utf8")).join("\n");
}

const valuesIn = (words: string): string[] => [...words.matchAll(/\{\w+\}/g)].map(([value]) => value).sort();

describe("the table of German words", () => {
  const table = Object.entries(german);

  it("has every word of the page that is shown", () => {
    const shown = shownWords();
    expect(shown.length).toBeGreaterThan(150);
    expect(shown.filter((words) => !(words in german))).toEqual([]);
  });

  it("has the same values in both languages, and words for all", () => {
    expect(table.filter(([english, words]) => words.trim() === "" || valuesIn(english).join() !== valuesIn(words).join())).toEqual([]);
  });

  it("has nothing that the page does not say", () => {
    const [shown, code] = [new Set(shownWords()), sources()];
    const isSaid = (words: string): boolean => shown.has(words) || code.includes(JSON.stringify(words)) || /^Add a\b/.test(words);
    expect(table.map(([english]) => english).filter((words) => !isSaid(words))).toEqual([]);
  });
});

/** What the regions of a page are called, dialogs by their headings. */
function regionNames(page: string): string[] {
  const shown = document.createElement("main");
  shown.innerHTML = readFileSync(join(SRC, `../${page}.html`), "utf8");
  const named = [...shown.querySelectorAll("main, nav, aside, section, form, dialog, [role]")].map((one) =>
    one.getAttribute("aria-label") ?? shown.querySelector(`#${one.getAttribute("aria-labelledby") ?? "none"}`)?.textContent ?? "");
  return named.filter((name) => name !== "");
}

describe("the regions of a page", () => {
  it.each([["index", 15], ["embed", 2]])("have names of their own in German as in English: %s", (page, least) => {
    const english = new Set(regionNames(page));
    expect(english.size).toBeGreaterThan(least);
    const words: Readonly<Record<string, string>> = german;
    expect(new Set([...english].map((name) => words[name])).size).toBe(english.size);
  });
});

describe("the language", () => {
  it("is the one that was chosen, else the browser's, else English", () => {
    expect(languageOf("de", "en-GB")).toBe("de");
    expect(languageOf("en", "de-AT")).toBe("en");
    expect(languageOf(null, "de-AT")).toBe("de");
    expect(languageOf("", "fr")).toBe("en");
    expect(languageOf("constructor", undefined)).toBe("en");
  });

  it("leaves English as it stands, with its values", () => {
    expect(say("{count} changes", { count: 3 })).toBe("3 changes");
    expect(sayName("living_room")).toBe("living room");
    expect(sayName("bedroom_master")).toBe("master bedroom");
    expect(KEY_LIST.flatMap(([, lines]) => lines).every(([, does]) => say(does) === does)).toBe(true);
  });

  it("takes values as text, however they look", () => {
    expect(say("Reading {file}", { file: "$& {file} <b>" })).toBe("Reading $& {file} <b>");
  });

  it("changes words alone: no key, no script, and the space around them stays", () => {
    document.body.innerHTML = '<button title="a">b <kbd>R</kbd></button><script>c</script><p>  d\n e </p>';
    eachWords(document.body, (words) => `${words}!`);
    expect(document.body.innerHTML).toBe('<button title="a!">b! <kbd>R</kbd></button><script>c</script><p>  d e! </p>');
  });
});
