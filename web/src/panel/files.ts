/** Files: the scene shown is saved whole, a scene or plan dropped or chosen is read by the service. */
import type { Beside } from "../asking";
import type { Scene } from "../contract";
import { exportedFile, exportFormats, type GivenFile } from "../service";
import { capital, say } from "../words/language";
import { tellPlainly } from "../words/telling";

/** What a browser shows as a picture; a drawing, as of DXF, is called an image too. */
const PICTURE = /^image\/(png|jpeg|gif|webp|avif|bmp)$/;

/** A file's name, as the service names those that it writes. */
export function fileName({ seed }: { readonly seed: number | null }, format: string, what = ""): string {
  return `house${seed === null ? "" : `_${seed}`}${what}.${format}`;
}

export function save(content: Blob, name: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 0);
}

export class Files {
  /** Called with a file to be opened. */
  onOpen: (file: GivenFile) => void = () => undefined;
  /** Called with a picture, such as a plan's scan: it holds no plan that is read, but may be drawn over. */
  onPicture: (file: File) => void = () => undefined;
  /** Called with what went wrong. */
  onFailure: (reason: unknown) => void = () => undefined;
  readonly #chooser: HTMLInputElement;
  readonly #formats: HTMLSelectElement;
  #words: ReadonlyMap<string, string> = new Map();

  /** `scene` tells the home shown, once the edits that are under way are in it. */
  constructor(readonly host: HTMLElement, readonly drop: HTMLElement, readonly scene: () => Promise<Scene | null>, readonly beside: Beside) {
    this.#chooser = host.querySelector("#file") as HTMLInputElement;
    for (const format of ["json", "yaml"] as const) {
      host.querySelector(`#download_${format}`)?.addEventListener("click", () => void this.#write(format));
    }
    this.#formats = host.querySelector("#export_format") as HTMLSelectElement;
    this.#formats.addEventListener("change", () => this.#describe());
    host.querySelector("#export")?.addEventListener("click", () => void this.#write(this.#formats.value));
    void this.#offerFormats();
    host.addEventListener("toggle", () => { if (this.#words.size === 0) void this.#offerFormats(); }); // of a service that was not there when the page came
    host.querySelector("#open_file")?.addEventListener("click", () => this.#chooser.click());
    this.#chooser.addEventListener("change", () => this.#chosen());
    window.addEventListener("dragover", (event) => this.#over(event));
    window.addEventListener("dragleave", (event) => { if (event.relatedTarget === null) drop.hidden = true; });
    window.addEventListener("drop", (event) => this.#dropped(event));
  }

  async #write(format: string): Promise<void> {
    const scene = await this.scene();
    if (!scene || !format) return;
    void this.beside(say("Writing {file}", { file: fileName(scene, format) }), async () => {
      const { name, content } = await exportedFile(scene, format);
      save(content, name ?? fileName(scene, format));
    }, scene);
  }

  /** Fills the menu with what the service can write; without an answer there is nothing to choose. */
  async #offerFormats(): Promise<void> {
    const formats = await exportFormats().catch(() => []);
    this.#words = new Map(formats.map(({ name, words }) => [name, tellPlainly(words)]));
    this.#formats.replaceChildren(...[...this.#words].map(([name, words]) => new Option(`${name}: ${words}`, name)));
    this.#describe();
    this.#formats.closest(".export")?.toggleAttribute("hidden", formats.length === 0);
  }

  /** Says whole what the chosen format is: the list, once it is shut, cuts that off. */
  #describe(): void {
    this.host.querySelector("#export_words")?.replaceChildren(capital(this.#words.get(this.#formats.value) ?? ""));
  }

  #chosen(): void {
    void this.#open(this.#chooser.files?.[0]);
    this.#chooser.value = "";
  }

  #over(event: DragEvent): void {
    if (!event.dataTransfer?.types.includes("Files")) return;
    event.preventDefault();
    event.dataTransfer.dropEffect = "copy";
    this.drop.hidden = false;
  }

  #dropped(event: DragEvent): void {
    this.drop.hidden = true;
    const file = event.dataTransfer?.files[0];
    if (!file) return;
    event.preventDefault();
    void this.#open(file);
  }

  async #open(file: File | undefined): Promise<void> {
    if (!file) return;
    if (PICTURE.test(file.type)) return this.onPicture(file);
    try {
      this.onOpen({ name: file.name, content: await file.arrayBuffer() });
    } catch (reason) {
      this.onFailure(reason);
    }
  }
}
