/** The plan to take along: as SVG, as a picture, on paper; to scale, in the service's own drawing. */
import type { Beside } from "../asking";
import type { Scene } from "../contract";
import { made } from "../made";
import { fileName, save } from "../panel/files";
import { planOf } from "../service";
import { say } from "../words/language";
import { element } from "../element";

/** Sheets of paper upright, as a drawing has them with its frame [mm]. */
const LARGEST = [841, 1189] as const;
const PAPERS = [[210, 297], [297, 420], [420, 594], [594, 841], LARGEST] as const;
const DOTS_PER_MM = 300 / 25.4;
/** More a side is beyond what browsers draw at once. */
const MOST_DOTS = 8192;

/** How large a drawing is on paper [mm]. */
function sizeOf(text: string): { width: number; height: number } {
  const [width = 0, height = 0] = ["width", "height"].map((side) => Number(new RegExp(`<svg[^>]* ${side}="([0-9.]+)mm"`).exec(text)?.[1] ?? 0));
  return { width, height };
}

/** The smallest paper that holds a drawing, on its side where that is wide; the largest where none does: width and height [mm]. */
function paperFor({ width, height }: { width: number; height: number }): readonly [number, number] {
  const [low, high] = [Math.min(width, height), Math.max(width, height)];
  const [short, long] = PAPERS.find(([a, b]) => low <= a && high <= b) ?? LARGEST;
  return width > height ? [long, short] : [short, long];
}

/** Has an image show a drawing while something is done with it. */
async function shown<Result>(text: string, image: HTMLImageElement, act: (image: HTMLImageElement) => Result | Promise<Result>): Promise<Result> {
  image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  try {
    await image.decode();
    image.hidden = false;
    return await act(image);
  } finally {
    image.hidden = true;
    URL.revokeObjectURL(image.src);
    image.removeAttribute("src");
  }
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
    return shown(text, new Image(), (picture) => {
      const canvas = made("canvas", { width: Math.round(width * dots), height: Math.round(height * dots) });
      canvas.getContext("2d")?.drawImage(picture, 0, 0, canvas.width, canvas.height);
      return new Promise<Blob | null>((done) => { canvas.toBlob(done, "image/png"); });
    });
  }

  /** Prints the plan alone, in its own millimetres; the browser makes a PDF of it where that is wished. */
  #print(): void {
    this.#with(say("Drawing the plan"), async (text) => {
      const [width, height] = paperFor(sizeOf(text));
      const paper = new CSSStyleSheet();
      paper.replaceSync(`@page plan { size: ${width}mm ${height}mm; margin: 0; }`);
      document.adoptedStyleSheets = [paper];
      await shown(text, element<HTMLImageElement>("plan_print"), () => window.print());
    });
  }
}
