/** Files: the scene shown is saved whole, a scene or plan dropped or chosen is read by the service. */
import type { Scene } from "../contract";
import { exported, exportedFile, exportFormats, type FileFormat, type GivenFile } from "../service";
import { tellPlainly } from "../words/telling";

/** What a browser shows as a picture; a drawing, as of DXF, is called an image too. */
const PICTURE = /^image\/(png|jpeg|gif|webp|avif|bmp)$/;

export function fileName(scene: Scene, format: FileFormat): string {
  return `compose-${scene.seed}.${format}`;
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
  /** Called with what went wrong, and how to do it again where that can help. */
  onFailure: (reason: unknown, again: (() => void) | null) => void = () => undefined;
  onSaved: () => void = () => undefined;
  readonly #chooser: HTMLInputElement;
  readonly #formats: HTMLSelectElement;

  constructor(readonly host: HTMLElement, readonly drop: HTMLElement, readonly scene: () => Scene | null) {
    this.#chooser = host.querySelector("#file") as HTMLInputElement;
    for (const format of ["json", "yaml"] as const) {
      host.querySelector(`#download_${format}`)?.addEventListener("click", () => void this.#download(format));
    }
    this.#formats = host.querySelector("#export_format") as HTMLSelectElement;
    host.querySelector("#export")?.addEventListener("click", () => void this.#export());
    void this.#offerFormats();
    host.querySelector("#open_file")?.addEventListener("click", () => this.#chooser.click());
    this.#chooser.addEventListener("change", () => this.#chosen());
    window.addEventListener("dragover", (event) => this.#over(event));
    window.addEventListener("dragleave", (event) => { if (event.relatedTarget === null) drop.hidden = true; });
    window.addEventListener("drop", (event) => this.#dropped(event));
  }

  async #download(format: FileFormat): Promise<void> {
    const scene = this.scene();
    if (!scene) return;
    const again = (): void => void this.#download(format);
    try {
      save(new Blob([await exported(scene, format, new AbortController().signal)]), fileName(scene, format));
      this.onSaved();
    } catch (reason) {
      this.onFailure(reason, again);
    }
  }

  /** Fills the menu with what the service can write; without an answer there is nothing to choose. */
  async #offerFormats(): Promise<void> {
    const formats = await exportFormats(new AbortController().signal).catch(() => []);
    this.#formats.replaceChildren(...formats.map(({ name, words }) => new Option(`${name}: ${tellPlainly(words)}`, name)));
    this.#formats.closest(".export")?.toggleAttribute("hidden", formats.length === 0);
  }

  async #export(): Promise<void> {
    const scene = this.scene();
    if (!scene || !this.#formats.value) return;
    try {
      const { name, content } = await exportedFile(scene, this.#formats.value, new AbortController().signal);
      save(content, name);
      this.onSaved();
    } catch (reason) {
      this.onFailure(reason, () => void this.#export());
    }
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
      this.onFailure(reason, null);
    }
  }
}
