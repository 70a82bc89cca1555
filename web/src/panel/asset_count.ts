/** Says how many of the user's own assets are on their way, and how many will not come. */
import type { AssetCount } from "../house/asset_library";

/** Words for a count; none where there is nothing to say. */
export function wordsOf({ wanted, come, missing }: AssetCount): string {
  const left = wanted - come - missing;
  if (left > 0) return `Assets: ${come} of ${wanted} loaded…`;
  if (missing === 0) return "";
  return `${missing} of ${wanted} assets could not be loaded: plain shapes stand for them.`;
}

export function showAssetCount(host: HTMLElement, count: AssetCount): void {
  const words = wordsOf(count);
  host.textContent = words;
  host.hidden = words === "";
}
