/** Says how many of the user's own assets are on their way, and how many will not come. */
import type { AssetCount } from "../house/asset_library";
import { say } from "../words/language";

/** Words for a count; none where there is nothing to say. */
export function wordsOf({ wanted, come, missing }: AssetCount): string {
  const left = wanted - come - missing;
  if (left > 0) return say("Assets: {come} of {wanted} loaded…", { come, wanted });
  if (missing === 0) return "";
  return say("{missing} of {wanted} assets could not be loaded: plain shapes stand for them.", { missing, wanted });
}

export function showAssetCount(host: HTMLElement, count: AssetCount): void {
  const words = wordsOf(count);
  host.textContent = words;
  host.hidden = words === "";
}
