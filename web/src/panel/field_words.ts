/** What the service says of wrong fields, in the form's words: by the field's label, and what to enter. */
import type { FieldProblem } from "../contract";
import { ServiceProblem } from "../service";
import { capital, say, sayName } from "../words/language";
import { tellPlainly } from "../words/telling";

const NUMBER = /^(a (?:whole )?number(?: [^:]*)?)(?::|$)/;

/** Names of the catalogs in a row: of programmes, styles, rooms. */
const NAMES = /^[a-z]\w*(?:, [a-z]\w*)+$/;

/** What the service says of a file that is none of its formats. */
const UNKNOWN_FILE = /^(is in none of the formats|the text is not UTF-8)/;

/** What the service says of a plan without rooms, with what its walls do, its layers, or what was left out. */
const ROOMLESS = /^are none in this file(?:; its walls: (.*)|, whose layers are (.*)|; left out: (.*))?$/;

type Field = HTMLInputElement | HTMLSelectElement;

function labelOf(form: HTMLFormElement, field: Field): HTMLElement | null {
  return form.querySelector<HTMLElement>(`label[for="${CSS.escape(field.id)}"]`) ?? field.closest("label");
}

/** What a field is called in the form, and its unit where it has one. */
function calledIn(form: HTMLFormElement, field: Field): { readonly name: string; readonly unit: string } {
  const label = labelOf(form, field);
  const unit = label?.querySelector(".unit")?.textContent ?? "";
  const whole = label?.textContent ?? field.name;
  return { name: whole.replace(unit, "").trim(), unit: /^(m²?)(?![\w²])/.exec(unit.trim())?.[1] ?? "" };
}

/** What to say beside a field. */
export function fieldWords({ problem, allowed }: FieldProblem, unit = ""): string {
  const number = NUMBER.exec(allowed)?.[1];
  if (number !== undefined) return say("Enter {number}", { number: `${tellPlainly(number)}${unit ? ` ${unit}` : ""}` });
  return problemWords({ problem, allowed }, NAMES.test(allowed) ? allowed.split(", ").map(sayName).join(", ") : tellPlainly(allowed));
}

/** What is wrong with a field of what was sent, such as a file, which nobody enters here. */
function problemWords({ problem, allowed }: Pick<FieldProblem, "problem" | "allowed">, told = tellPlainly(allowed)): string {
  const said = tellPlainly(problem);
  return !allowed || problem.includes(allowed) ? said : say("{problem}; allowed: {allowed}", { problem: said, allowed: told });
}

/** The field of the form that a problem is about. */
export function fieldOf(form: HTMLFormElement, { field }: FieldProblem): Field | null {
  const fields = [...form.querySelectorAll<Field>("input[name], select[name]")];
  return fields.find(({ name }) => field === name || field === `request.${name}`) ?? null;
}

export function besideField(form: HTMLFormElement, field: Field, problem: FieldProblem): string {
  return fieldWords(problem, calledIn(form, field).unit);
}

/** All that is wrong with the form, a line a field; null where something else is wrong as well. */
export function formWords(form: HTMLFormElement, problems: readonly FieldProblem[]): readonly string[] | null {
  const lines = problems.map((problem) => {
    const field = fieldOf(form, problem);
    if (!field) return null;
    const words = besideField(form, field, problem);
    return `${calledIn(form, field).name}: ${words.charAt(0).toLowerCase()}${words.slice(1)}`;
  });
  return lines.length > 0 && lines.every((line) => line !== null) ? lines : null;
}

/** What is wrong with a file as a whole. */
function fileWords({ problem }: FieldProblem): string {
  if (UNKNOWN_FILE.test(problem)) {
    const unknown = say("It is none of the files that are read here: scenes as JSON, YAML or .glb, and plans of Sweet Home 3D, DXF, IFC, SVG, ProcTHOR, RPLAN, GeoJSON.");
    const why = problem.split("; read as a scene: ")[1];
    return why ? `${unknown} ${capital(tellPlainly(why))}.` : unknown;
  }
  if (problem.startsWith("the text is empty")) return say("It is empty.");
  return `${capital(tellPlainly(problem))}.`;
}

/** That a plan has no rooms, why its walls, its layers or what was left out tell of none, and what would. */
function roomlessWords(allowed: string, [, walls, layers, leftOut]: readonly (string | undefined)[]): string {
  const why = [
    walls && say("Its walls {why}.", { why: tellPlainly(walls) }), layers && say("Its layers are {names}.", { names: layers }),
    leftOut && say("Left out: {why}.", { why: tellPlainly(leftOut) }),
  ].map((words) => (words ? ` ${words}` : "")).join("");
  return `${say("It holds no rooms.")}${why} ${say("What is needed: {allowed}.", { allowed: tellPlainly(allowed) })}`;
}

/** What is wrong with all that was sent; null where a field is wrong, which has a name. */
function wholeWords(field: FieldProblem): string | null {
  if (field.field === "file") return fileWords(field);
  const roomless = field.field === "rooms" && ROOMLESS.exec(field.problem);
  if (roomless) return roomlessWords(field.allowed, roomless);
  const most = field.field === "body" && /^at most \d+ bytes \((\d+ MB)\)$/.exec(field.allowed)?.[1];
  return most ? say("It is larger than {most}, the most that is read here.", { most }) : null;
}

/** What a failure says, and each field that it names in a line. */
export function refusalWords(reason: unknown): { readonly title: string; readonly lines: readonly string[] } {
  if (!(reason instanceof ServiceProblem)) return { title: say("The page failed"), lines: [String(reason)] };
  const lines = reason.fields.map((field) => wholeWords(field) ?? `${tellPlainly(field.field)}: ${problemWords(field)}`);
  return { title: tellPlainly(reason.title), lines: lines.length > 0 ? lines : [tellPlainly(reason.detail)] };
}
