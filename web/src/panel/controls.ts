/** The form: reads and shows a request, and says beside a field what the service says of it. */
import { numberOrText } from "../address";
import type { FieldProblem, HouseRequest } from "../contract";

const NUMBERS = ["seed", "width", "depth", "min_room_size", "max_depth"] as const;
const SWITCHES = ["use_spine", "outdoor"] as const;

/** What to say beside a field. */
export function fieldWords({ problem, allowed }: FieldProblem): string {
  return !allowed || problem.includes(allowed) ? problem : `${problem}; allowed: ${allowed}`;
}

export class Controls {
  onGenerate: (request: HouseRequest) => void = () => undefined;

  constructor(readonly form: HTMLFormElement) {
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.onGenerate(this.read());
    });
    for (const slider of form.querySelectorAll<HTMLInputElement>("input[data-for]")) this.#tie(slider);
  }

  read(): HouseRequest {
    const request = {} as HouseRequest;
    for (const name of NUMBERS) request[name] = numberOrText(this.#input(name).value);
    for (const name of SWITCHES) request[name] = this.#input(name).checked;
    return request;
  }

  show(request: HouseRequest): void {
    for (const name of NUMBERS) this.#write(name, String(request[name]));
    for (const name of SWITCHES) this.#input(name).checked = request[name];
    this.showProblems([]);
  }

  /** Marks the fields that the service refused, each with its words. */
  showProblems(problems: readonly FieldProblem[]): void {
    for (const name of NUMBERS) {
      const problem = problems.find(({ field }) => field === name || field.endsWith(`.${name}`));
      const place = this.form.querySelector<HTMLElement>(`#${name}_problem`);
      this.#input(name).setAttribute("aria-invalid", String(problem !== undefined));
      if (place) place.textContent = problem ? fieldWords(problem) : "";
    }
  }

  #input(name: string): HTMLInputElement {
    return this.form.elements.namedItem(name) as HTMLInputElement;
  }

  #write(name: string, value: string): void {
    this.#input(name).value = value;
    const slider = this.form.querySelector<HTMLInputElement>(`input[data-for="${name}"]`);
    if (slider) slider.value = value;
  }

  /** A slider and its number say the same. */
  #tie(slider: HTMLInputElement): void {
    const number = this.#input(slider.dataset.for ?? "");
    slider.addEventListener("input", () => { number.value = slider.value; });
    number.addEventListener("input", () => { slider.value = number.value; });
  }
}
