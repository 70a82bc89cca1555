/** The plan to take along: as SVG, as a picture, on paper; to scale, in the service's own drawing. */
import type { Beside } from "../asking";
import type { Scene } from "../contract";
import { made } from "../made";
import { fileName, save } from "../panel/files";
import { planOf } from "../service";
import { say } from "../words/language";
import { printSheet } from "./printing";
import { element } from "../element";

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

export class PlanFiles {
  readonly #scale = element<HTMLSelectElement>("plan_scale");

  constructor(readonly scene: () => Scene | null, readonly beside: Beside) {
    const files = { plan_svg: "svg", plan_png: "png" } as const;
    for (const [id, format] of Object.entries(files)) element(id).addEventListener("click", () => this.#write(format));
    element("print_plan").addEventListener("click", () => this.#print());
    document.addEventListener("keydown", (event) => this.#key(event));
  }

  #with(what: string, act: (text: string) => void | Promise<void>): void {
    const scene = this.scene();
    if (!scene) return;
    void this.beside(what, async () => act(await planOf(scene, Number(this.#scale.value) || null)), scene);
  }

  /** The browser's own key for printing prints the plan: the page itself has no sheet. */
  #key(event: KeyboardEvent): void {
    if (event.key.toLowerCase() !== "p" || !(event.ctrlKey || event.metaKey) || event.shiftKey || event.altKey) return;
    event.preventDefault();
    if (!event.repeat) this.#print();
  }

  #write(format: "svg" | "png"): void {
    const scene = this.scene();
    if (!scene) return;
    const file = fileName(scene, format, "_plan");
    this.#with(say("Writing {file}", { file }), async (text) => {
      const content = format === "svg" ? new Blob([text], { type: "image/svg+xml" }) : await this.#png(text);
      if (content) save(content, file);
    });
  }

  async #png(text: string): Promise<Blob | null> {
    const { width, height } = sizeOf(text);
    const dots = Math.min(DOTS_PER_MM, MOST_DOTS / Math.max(width, height));
    const address = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
    try {
      const picture = new Image();
      picture.src = address;
      await picture.decode();
      const canvas = made("canvas", { width: Math.round(width * dots), height: Math.round(height * dots) });
      canvas.getContext("2d")?.drawImage(picture, 0, 0, canvas.width, canvas.height);
      return await new Promise<Blob | null>((done) => { canvas.toBlob(done, "image/png"); });
    } finally {
      URL.revokeObjectURL(address);
    }
  }

  /** Prints the plan alone, in its own millimetres; the browser makes a PDF of it where that is wished. */
  #print(): void {
    this.#with(say("Drawing the plan"), async (text) => {
      const sheet = element<HTMLImageElement>("plan_print");
      sheet.dataset.paper = paperFor(sizeOf(text));
      await printSheet(text, sheet);
    });
  }
}
