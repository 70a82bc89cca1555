/** The address of a home in a frame: all of it stands behind the `#`, which no server is told. Pure. */
import type { PresetName } from "../view/cameras";

/** What a frame shows: the query of the home, the changes that a link carries, and how one looks first, null where that is no way to. */
export interface Framed {
  readonly query: string;
  readonly changes: string | null;
  readonly view: PresetName | "walk" | null;
}

export const VIEWS = ["corner", "plan", "top", "walk"] as const;
const VIEW = "view";
const CHANGES = "changes";

/** Reads a fragment such as `#seed=7&program=family&view=walk`. */
export function framedIn(fragment: string): Framed {
  const said = new URLSearchParams(fragment.replace(/^#?\??/, ""));
  const wished = said.get(VIEW) ?? "corner";
  const view = VIEWS.find((one) => one === wished) ?? null;
  const changes = said.get(CHANGES);
  said.delete(VIEW);
  said.delete(CHANGES);
  return { query: said.toString(), changes, view };
}

/** The page's own address of the home, to open it whole. */
export function pageOf({ query, changes }: Framed): string {
  return `./?${query}${changes === null ? "" : `#${CHANGES}=${changes}`}`;
}

/** The frame's address of a home for which a link is known. */
export function frameOf(link: string): string {
  const { origin, pathname, search, hash } = new URL(link);
  const words = [search.slice(1), hash.slice(1)].filter((part) => part !== "");
  return `${origin}${pathname.replace(/[^/]*$/, "")}embed#${words.join("&")}`;
}

/** The line of HTML that shows a home in another page. */
export function frameLine(link: string): string {
  const address = frameOf(link).replaceAll("&", "&amp;").replaceAll('"', "&quot;");
  return `<iframe src="${address}" title="A furnished home" width="800" height="500" loading="lazy" `
    + 'sandbox="allow-scripts allow-same-origin allow-popups"></iframe>';
}
