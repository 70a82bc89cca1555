/** The plan to take along: as SVG, as a picture, on paper; to scale, in the service's own drawing. */
import type { Scene } from "../contract";
import { save } from "../panel/files";
import { planOf } from "../service";
import { printSheet } from "./printing";

/** Sheets of paper upright, as a drawing has them with its frame [mm]. */
const PAPERS: readonly (readonly [string, number, number])[] = [["a4", 210, 297], ["a3", 297, 420], ["a2", 420, 594], ["a1", 594, 841], ["a0", 841, 1189]];
const DOTS_PER_MM = 300 / 25.4;
/** More a side is beyond what browsers draw at once. */
const MOST_DOTS = 8192;

/** How large a drawing is on paper [mm]. */
export function sizeOf(text: string): { width: number; height: number } {
  const [width = 0, height = 0] = ["width", "height"].map((side) => Number(new RegExp(`<svg[^>]* ${side}="([0-9.]+)mm"`).exec(text)?.[1] ?? 0));
  return { width, height };
}

/** The smallest paper that holds a drawing, `-wide` where it lies on its side; the largest where none does. */
export function paperFor({ width, height }: { width: number; height: number }): string {
  const [short, long] = [Math.min(width, height), Math.max(width, height)];
  const [name] = PAPERS.find(([, a, b]) => short <= a && long <= b) ?? ["a0"];
  return width > height ? `${name}-wide` : name;
}

function within<T extends HTMLElement>(id: string): T {
  return document.getElementById(id) as T;
}

export class PlanFiles {
  readonly #scale = within<HTMLSelectElement>("plan_scale");

  constructor(readonly scene: () => Scene | null, readonly failed: (reason: unknown) => void) {
    const acts = { plan_svg: (text: string) => this.#svg(text), plan_png: (text: string) => this.#png(text), print_plan: (text: string) => this.#print(text) };
    for (const [id, act] of Object.entries(acts)) within(id).addEventListener("click", () => void this.#with(act));
    document.addEventListener("keydown", (event) => this.#key(event));
  }

  async #with(act: (text: string) => void | Promise<void>): Promise<void> {
    const scene = this.scene();
    if (!scene) return;
    try {
      await act(await planOf(scene, Number(this.#scale.value) || null, new AbortController().signal));
    } catch (reason) {
      this.failed(reason);
    }
  }

  /** The browser's own key for printing prints the plan: the page itself has no sheet. */
  #key(event: KeyboardEvent): void {
    if (event.key.toLowerCase() !== "p" || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
    event.preventDefault();
    if (!event.repeat) void this.#with((text) => this.#print(text));
  }

  get #name(): string {
    return `compose-${this.scene()?.seed ?? "plan"}-plan`;
  }

  #svg(text: string): void {
    save(new Blob([text], { type: "image/svg+xml" }), `${this.#name}.svg`);
  }

  async #png(text: string): Promise<void> {
    const { width, height } = sizeOf(text);
    const dots = Math.min(DOTS_PER_MM, MOST_DOTS / Math.max(width, height));
    const address = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    try {
      const picture = new Image();
      picture.src = address;
      await picture.decode();
      const canvas = Object.assign(document.createElement("canvas"), { width: Math.round(width * dots), height: Math.round(height * dots) });
      canvas.getContext("2d")?.drawImage(picture, 0, 0, canvas.width, canvas.height);
      const content = await new Promise<Blob | null>((done) => { canvas.toBlob(done, "image/png"); });
      if (content) save(content, `${this.#name}.png`);
    } finally {
      URL.revokeObjectURL(address);
    }
  }

  /** Prints the plan alone, in its own millimetres; the browser makes a PDF of it where that is wished. */
  async #print(text: string): Promise<void> {
    const sheet = within<HTMLImageElement>("plan_print");
    sheet.dataset.paper = paperFor(sizeOf(text));
    await printSheet(text, sheet);
  }
}
