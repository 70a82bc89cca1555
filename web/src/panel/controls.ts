/** The form: reads and shows a request, and says beside a field what the service says of it. */
import type { Look } from "../service";
import { anotherSeed, DEFAULTS, numberOrText, NUMBERS, OF_PLAIN_PLANS, requestFromQuery, SWITCHES, withoutGaps } from "../address";
import type { Catalog, FieldProblem, HouseRequest, Typed } from "../contract";
import { besideField, fieldOf, formWords } from "./field_words";
import { asNumber } from "./number_text";
import { readWish } from "./plain_wishes";
import { inWords, Programme } from "./programme";
import { say, sayName } from "../words/language";
import { tellPlainly } from "../words/telling";

export class Controls {
  onGenerate: (request: HouseRequest) => void = () => undefined;
  /** Called with a home to begin with, which the form does not show yet. */
  onBegin: (request: HouseRequest) => void = () => undefined;
  /** Called with a style, or whether to decorate, for the home that is shown. */
  onRestyle: (wish: Look) => void = () => undefined;
  readonly #programme: Programme;
  /** What only an address can ask for. */
  #forced: HouseRequest["force_types"];
  #catalog: Catalog | null = null;
  /** The line of plain words that the form shows already, and what it said then of the programme. */
  #asked = "";
  #askedFor = "";
  /** The style that somebody asked for. */
  #wished: string | undefined;

  constructor(readonly form: HTMLFormElement) {
    this.#programme = new Programme(form);
    this.#programme.onPlanned = (planned) => this.#fitOutline(planned);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      if (this.#takeAsked()) this.onGenerate(this.read());
    });
    this.#input("style").addEventListener("change", () => this.#chooseStyle());
    this.#input("decorate").addEventListener("change", () => this.onRestyle({ decorate: this.#input("decorate").checked }));
    this.#find("#asked").addEventListener("change", () => this.#takeAsked());
    for (const link of form.querySelectorAll<HTMLAnchorElement>("#starts a")) {
      link.addEventListener("click", (event) => {
        event.preventDefault();
        this.onBegin(requestFromQuery(link.search));
      });
    }
    for (const slider of form.querySelectorAll<HTMLInputElement>("input[data-for]")) this.#tie(slider);
  }

  /** Fills in what the service knows. */
  offer(catalog: Catalog): void {
    this.#catalog = catalog;
    this.#programme.offer(catalog);
    for (const name of Object.keys(catalog.styles ?? {})) this.#offerStyle(name);
    for (const [name, { description }] of Object.entries(catalog.access ?? {})) this.#offerAccess(name, tellPlainly(description));
    this.#sayStyle();
  }

  read(): HouseRequest {
    const planned = this.#programme.planned;
    const request: HouseRequest = { seed: this.#readSeed() };
    for (const name of NUMBERS) if (name !== "area" && name !== "seed") request[name] = this.#readNumber(name);
    for (const name of SWITCHES) request[name] = this.#input(name).checked;
    if (planned) for (const name of OF_PLAIN_PLANS) delete request[name];
    const forced = planned ? undefined : this.#forced;
    return withoutGaps({ ...request, ...this.#programme.read(), ...this.#readFurnishing(), force_types: forced });
  }

  /** The same for another home: of a home that no request made the style is shown, but nobody has wished for it. */
  readForAnother(): HouseRequest {
    const { style, ...request } = this.read();
    return withoutGaps({ ...request, style: style === this.#wished ? style : undefined });
  }

  show(request: HouseRequest): void {
    this.#wished = request.style;
    this.#programme.show(request);
    if (this.#plan() !== this.#askedFor) this.#find<HTMLInputElement>("#asked").value = this.#asked = "";
    const shown = { ...DEFAULTS, width: undefined, depth: undefined, ...request };
    for (const name of NUMBERS) this.#write(name, String(shown[name] ?? ""));
    for (const name of SWITCHES) this.#input(name).checked = (shown[name] ?? name === "people") === true;
    if (request.style !== undefined) this.#offerStyle(request.style);
    this.#input("style").value = request.style ?? "";
    if (typeof request.access === "string") this.#offerAccess(request.access, inWords(request.access));
    this.#input("access").value = request.access ?? "";
    this.#forced = request.force_types;
    this.#sayStyle();
    this.showProblems([]);
  }

  /** Shows the style and the decorations of the home that is shown, which a request made or not; what else is typed stays. */
  showFurnishing({ style, decorate }: Look, isMade: boolean): void {
    if (isMade) this.#wished = style;
    if (style !== undefined) this.#offerStyle(style);
    this.#input("style").value = style ?? "";
    this.#input("decorate").checked = decorate === true;
    this.#sayStyle();
  }

  /** Marks the fields that the service refused, each with its words, and goes to the first. */
  showProblems(problems: readonly FieldProblem[]): void {
    let first: { readonly field: HTMLElement; readonly place: HTMLElement } | null = null;
    for (const field of this.form.querySelectorAll<HTMLInputElement>("input[name], select[name]")) {
      const problem = problems.find((one) => fieldOf(this.form, one) === field);
      const place = this.form.querySelector<HTMLElement>(`#${field.id}_problem`);
      if (!place) continue;
      field.setAttribute("aria-invalid", String(problem !== undefined));
      place.textContent = problem ? besideField(this.form, field, problem) : "";
      if (problem) first ??= { field, place };
    }
    if (!first) return;
    first.field.closest("details")?.setAttribute("open", "");
    first.field.focus();
    first.place.scrollIntoView({ block: "nearest" });
  }

  /** All that is wrong in the form's own words, a line a field; null where it is not of the form alone. */
  inWords(problems: readonly FieldProblem[]): readonly string[] | null {
    return formWords(this.form, problems);
  }

  /** Shows in the form what the line of plain words asks for; false where it cannot be read. */
  #takeAsked(): boolean {
    const field = this.#find<HTMLInputElement>("#asked");
    const text = field.value.trim();
    const read = this.#catalog && text !== this.#asked && text !== "" ? readWish(text, this.#catalog) : null;
    const unread = read && "unread" in read ? read.unread : null;
    field.setAttribute("aria-invalid", String(unread !== null));
    this.#find("#asked_problem").textContent = unread === null ? "" : say("\"{words}\" is neither an area nor rooms that are known. Say for example: 3 bedrooms, 2 bathrooms, 120 m².", { words: unread });
    if (unread !== null) field.focus();
    if (!read || "unread" in read) return unread === null;
    this.#asked = text;
    this.#programme.show(read.wish);
    this.#askedFor = this.#plan();
    if (read.wish.area === undefined) this.#fitOutline(true);
    else for (const name of ["width", "depth"] as const) this.#write(name, ""); // what stood there says another area
    return true;
  }

  /** What the form says of the programme, to compare. */
  #plan(): string {
    return JSON.stringify(this.#programme.read());
  }

  #find<Found extends HTMLElement>(selector: string): Found {
    return this.form.querySelector<Found>(selector) as Found;
  }

  /** A home that is planned chooses its own outline; a plain plan needs one. */
  #fitOutline(planned: boolean): void {
    for (const name of ["width", "depth"] as const) {
      const typed = this.#input(name).value;
      if (planned && typed === String(DEFAULTS[name])) this.#write(name, "");
      if (!planned && typed === "") this.#write(name, String(DEFAULTS[name]));
    }
  }

  /** A seed that is left empty is drawn. */
  #readSeed(): Typed {
    const seed = this.#input("seed");
    if (seed.value.trim() === "") seed.value = String(anotherSeed(-1));
    return numberOrText(seed.value);
  }

  #readNumber(name: Exclude<(typeof NUMBERS)[number], "area" | "seed">): Typed | undefined {
    const typed = this.#input(name).value.trim();
    if (typed !== "") return numberOrText(typed);
    return this.#programme.fitsItself ? undefined : DEFAULTS[name];
  }

  #offerStyle(name: string): void {
    const style = this.form.querySelector<HTMLSelectElement>("#style");
    if (style && ![...style.options].some((option) => option.value === name)) style.append(new Option(inWords(name), name));
  }

  #readFurnishing(): Pick<HouseRequest, "style" | "access"> {
    return { style: this.#input("style").value || undefined, access: this.#input("access").value || undefined };
  }

  /** A standard of access in the words of its profile; one that the service does not know is shown too, so that it can be refused in sight. */
  #offerAccess(name: string, description: string): void {
    const choice = this.form.querySelector<HTMLSelectElement>("#access");
    const known = choice && [...choice.options].find((option) => option.value === name);
    if (known) known.text = description;
    else choice?.append(new Option(description, name));
  }

  /** The home that is shown takes a style that is named; the seed's own is for the next one. */
  #chooseStyle(): void {
    this.#sayStyle();
    const style = this.#input("style").value;
    this.#wished = style || undefined;
    if (style) this.onRestyle({ style });
  }

  #sayStyle(): void {
    const style = this.#catalog?.styles?.[this.#input("style").value];
    const place = this.form.querySelector<HTMLElement>("#style_words");
    const walls = new Set(Object.values(style?.walls ?? {}).flatMap((finishes) => finishes.map(({ type }) => type)));
    if (place) place.textContent = walls.size > 0 ? say("Walls of {walls}; colours, floors and decorations to match.", { walls: [...walls].map(sayName).join(", ") }) : "";
  }

  #input(name: string): HTMLInputElement {
    return this.form.elements.namedItem(name) as HTMLInputElement;
  }

  #write(name: string, text: string): void {
    const value = asNumber(text);
    this.#input(name).value = value;
    const slider = this.form.querySelector<HTMLInputElement>(`input[data-for="${name}"]`);
    if (slider && value !== "") slider.value = value;
  }

  /** A slider and its number say the same. */
  #tie(slider: HTMLInputElement): void {
    const number = this.#input(slider.dataset.for ?? "");
    slider.addEventListener("input", () => { number.value = slider.value; });
    number.addEventListener("input", () => { if (number.value !== "") slider.value = number.value; });
  }
}
