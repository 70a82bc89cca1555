/** The user's own assets, fetched one after another when a house shows them, and kept; what does not come is shown as its kind's shape. */
import type { CatalogAsset } from "../contract";
import { readAsset, type AssetPart } from "./asset_model";

/** How much is fetched in all [bytes]; what goes beyond is left out. */
export const MOST_BYTES = 300e6;

export type AssetFetch = (name: string) => Promise<ArrayBuffer>;
type AssetReader = (content: ArrayBuffer, asset: CatalogAsset) => Promise<readonly AssetPart[]>;

/** How many assets were asked for, have come, and will not come. */
export interface AssetCount {
  readonly wanted: number;
  readonly come: number;
  readonly missing: number;
}

export class AssetLibrary {
  /** Called whenever the count changes. */
  onCount: (count: AssetCount) => void = () => undefined;
  readonly #models = new Map<string, Promise<readonly AssetPart[] | null>>();
  #count: AssetCount = { wanted: 0, come: 0, missing: 0 };
  #bytes = 0;
  /** The last of the queue. */
  #last: Promise<unknown> = Promise.resolve();

  constructor(readonly assets: Readonly<Record<string, CatalogAsset>>, readonly fetch: AssetFetch, readonly read: AssetReader = readAsset) {}

  /** An asset of the catalog; undefined where it has none of this name. */
  find(name: string | null | undefined): CatalogAsset | undefined {
    return name && Object.hasOwn(this.assets, name) ? this.assets[name] : undefined;
  }

  get count(): AssetCount {
    return this.#count;
  }

  /** The parts of an asset; null where it cannot be shown. Asked for again it is not fetched again. */
  model(name: string): Promise<readonly AssetPart[] | null> {
    const known = this.#models.get(name) ?? this.#queued(name);
    this.#models.set(name, known);
    return known;
  }

  #queued(name: string): Promise<readonly AssetPart[] | null> {
    this.#counted({ wanted: 1 });
    const coming = this.#last.then(() => this.#load(name));
    this.#last = coming;
    return coming;
  }

  async #load(name: string): Promise<readonly AssetPart[] | null> {
    const asset = this.find(name);
    try {
      if (!asset || this.#bytes + asset.bytes > MOST_BYTES) throw new Error("is not there, or is too much");
      this.#bytes += asset.bytes;
      const parts = await this.read(await this.fetch(name), asset);
      this.#counted({ come: 1 });
      return parts;
    } catch {
      this.#counted({ missing: 1 });
      return null;
    }
  }

  #counted({ wanted = 0, come = 0, missing = 0 }: Partial<AssetCount>): void {
    const { wanted: before, come: had, missing: lacked } = this.#count;
    this.#count = { wanted: before + wanted, come: had + come, missing: lacked + missing };
    this.onCount(this.#count);
  }
}
