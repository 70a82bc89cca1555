/** What home is asked for: a plain plan, a named programme, an area, or rooms counted one by one. */
import { numberOrText, outlineFrom, outlineText } from "../address";
import type { Catalog, Counts, HouseRequest } from "../contract";
import { made } from "../made";
import { asNumber } from "./number_text";
import { say, sayName } from "../words/language";
import { tellPlainly } from "../words/telling";

const PLAIN = "";
const BY_AREA = "by_area";
const OWN = "own";
const PRESET = "preset:";

/** A name of the catalogs as a person says it. */
export function inWords(name: string): string {
  const words = sayName(name);
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The words that a programme may count: those of the presets first, then what else homes are made of. */
export function wordsOf(catalog: Catalog): string[] {
  const uses = new Map<string, number>();
  for (const { rooms } of Object.values(catalog.presets ?? {})) {
    for (const word of Object.keys(rooms)) uses.set(word, (uses.get(word) ?? 0) + 1);
  }
  const homes = Object.entries(catalog.rooms ?? {}).flatMap(([type, { home }]) => (home ? [home.word ?? type] : []));
  const words = [...new Set(homes)];
  return words.sort((a, b) => (uses.get(b) ?? 0) - (uses.get(a) ?? 0) || words.indexOf(a) - words.indexOf(b));
}

export class Programme {
  /** Called when a plain plan becomes a planned home or the other way round. */
  onPlanned: (planned: boolean) => void = () => undefined;
  readonly #choice: HTMLSelectElement;
  readonly #presets: HTMLElement;
  readonly #counts: HTMLFieldSetElement;
  readonly #area: HTMLInputElement;
  readonly #outline: HTMLSelectElement;
  #catalog: Catalog | null = null;
  #last = PLAIN;

  constructor(readonly form: HTMLFormElement) {
    this.#choice = this.#within("#program");
    this.#presets = this.#within("#program_presets");
    this.#counts = this.#within("#counts");
    this.#area = this.#within("#area");
    this.#outline = this.#within("#outline");
    this.#choice.addEventListener("change", () => this.#chosen());
  }

  get planned(): boolean {
    return this.#choice.value !== PLAIN;
  }

  /** Whether the house is as large as its rooms need, or as its corners say, where nothing else is asked for. */
  get fitsItself(): boolean {
    return this.planned || this.#corners !== undefined;
  }

  get #corners(): HouseRequest["outline"] {
    const outline = outlineFrom(this.#outline.value);
    return typeof outline === "object" ? outline : undefined;
  }

  /** Fills in what the service knows; what is chosen stays chosen. */
  offer(catalog: Catalog): void {
    this.#catalog = catalog;
    for (const name of Object.keys(catalog.presets ?? {})) this.#presetOption(name);
    for (const word of wordsOf(catalog)) this.#countField(word);
    this.#arrange();
  }

  read(): Pick<HouseRequest, "program" | "area" | "outline"> {
    const choice = this.#choice.value;
    if (choice === PLAIN) return { outline: this.#corners };
    const outline = outlineFrom(this.#outline.value);
    const typed = this.#area.value.trim();
    const area = typed === "" && choice !== BY_AREA ? undefined : numberOrText(typed);
    if (choice === BY_AREA) return { area, outline };
    return { program: choice === OWN ? this.#readCounts() : choice.slice(PRESET.length), area, outline };
  }

  show({ program, area, outline }: Pick<HouseRequest, "program" | "area" | "outline">): void {
    this.#showOutline(outlineText(outline ?? "any"));
    this.#area.value = asNumber(String(area ?? ""));
    if (typeof program === "string") this.#choice.value = this.#presetOption(program).value;
    else if (program) this.#choice.value = OWN;
    else this.#choice.value = area === undefined ? PLAIN : BY_AREA;
    if (typeof program === "object") this.#showCounts(program);
    this.#arrange();
  }

  /** Corners that a link asks for can be chosen, too, as can a word that is not known, so that it can be refused in sight. */
  #showOutline(text: string): void {
    if (![...this.#outline.options].some((option) => option.value === text)) {
      this.#outline.append(new Option(typeof outlineFrom(text) === "object" ? say("With these corners") : text, text));
    }
    this.#outline.value = text;
  }

  #within<Found extends HTMLElement>(selector: string): Found {
    return this.form.querySelector<Found>(selector) as Found;
  }

  #presetOption(name: string): HTMLOptionElement {
    const options = [...this.#choice.options];
    const known = options.find((option) => option.value === PRESET + name);
    if (known) return known;
    const option = new Option(inWords(name), PRESET + name);
    this.#presets.append(option);
    return option;
  }

  /** A field for a word; one the service does not know is shown too, so that it can be refused in sight. */
  #countField(word: string): HTMLInputElement {
    const known = [...this.#counts.querySelectorAll("input")].find((input) => input.name === `program.${word}`);
    if (known) return known;
    const id = `count_${this.#counts.querySelectorAll("input").length}`;
    const label = made("label", { htmlFor: id }, inWords(word), ...(word === "garage" ? [made("span", { className: "unit" }, ` ${say("cars")}`)] : []));
    const input = made("input", { id, name: `program.${word}`, type: "number", inputMode: "numeric", placeholder: "–", "aria-describedby": `${id}_problem` });
    const problem = made("p", { id: `${id}_problem`, className: "problem", "aria-live": "polite" });
    this.#counts.append(made("div", { className: "field" }, label, input, problem));
    return input;
  }

  #readCounts(): Counts {
    const inputs = [...this.#counts.querySelectorAll("input")].filter((input) => input.value.trim() !== "");
    return Object.fromEntries(inputs.map((input) => [input.name.slice("program.".length), numberOrText(input.value)]));
  }

  #showCounts(counts: Counts): void {
    for (const input of this.#counts.querySelectorAll("input")) input.value = "";
    for (const [word, count] of Object.entries(counts)) this.#countField(word).value = asNumber(String(count));
  }

  /** One's own rooms start as those of the home chosen before. */
  #chosen(): void {
    const before = this.#catalog?.presets?.[this.#last.slice(PRESET.length)] ?? Object.values(this.#catalog?.presets ?? {})[0];
    const blank = Object.keys(this.#readCounts()).length === 0;
    if (this.#choice.value === OWN && before && (blank || this.#last.startsWith(PRESET))) this.#showCounts(before.rooms);
    this.#arrange();
    this.onPlanned(this.planned);
  }

  #arrange(): void {
    const choice = this.#choice.value;
    this.#last = choice;
    this.#counts.hidden = choice !== OWN;
    this.#within("#area_field").hidden = !this.planned;
    this.#within("#outline_field").hidden = !this.fitsItself;
    this.#within("#cuts_words").hidden = !this.planned;
    this.#within<HTMLFieldSetElement>("#cuts").disabled = this.planned;
    for (const name of ["width", "depth"]) this.#within<HTMLInputElement>(`#${name}`).placeholder = this.planned ? say("to fit") : "";
    this.#within("#program_words").textContent = this.#saidOf(choice);
  }

  #saidOf(choice: string): string {
    if (choice === PLAIN) return say("A rectangle cut into rooms.");
    if (choice === BY_AREA) return say("The service takes the programme that suits the area.");
    if (choice === OWN) return say("What is left empty is the service's choice.");
    const says = this.#catalog?.presets?.[choice.slice(PRESET.length)]?.description;
    return says ? `${inWords(tellPlainly(says))}.` : "";
  }
}
