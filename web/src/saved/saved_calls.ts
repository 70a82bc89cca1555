/** The service's calls about homes that it keeps. */
import type { Scene } from "../contract";
import type { HomeHead, HomeList } from "../served";
import { askFor } from "../service";

export type SavedHead = HomeHead;

/** A home with its scene, and the revision that a change of it has to name. */
export interface SavedHome {
  readonly head: SavedHead;
  readonly scene: Scene;
  readonly revision: string;
}

/** What can be said of a home when it is saved or changed. */
export interface SavedTexts {
  readonly name?: string;
  readonly tags?: readonly string[];
  readonly scene?: Scene;
}

const JSON_TYPE = { "Content-Type": "application/json", Accept: "application/json" };

function path(id: string, more = ""): string {
  return `homes/${encodeURIComponent(id)}${more}`;
}

export function listSaved(search: string, after: string | null, signal: AbortSignal): Promise<HomeList> {
  const query = new URLSearchParams({ limit: "12", ...(search ? { search } : {}), ...(after ? { after } : {}) });
  return askFor(async (response) => (await response.json()) as HomeList, `homes?${query}`, { headers: { Accept: "application/json" }, signal });
}

export function readSaved(id: string, signal?: AbortSignal): Promise<SavedHome> {
  return askFor(async (response) => {
    const { scene, ...head } = (await response.json()) as SavedHead & { readonly scene: Scene };
    return { head, scene, revision: response.headers.get("ETag") ?? "*" };
  }, path(id), { headers: { Accept: "application/json" }, signal: signal ?? null });
}

export function saveNew(texts: SavedTexts): Promise<SavedHead> {
  return askFor(async (response) => (await response.json()) as SavedHead, "homes", { method: "POST", headers: JSON_TYPE, body: JSON.stringify(texts) });
}

/** Changes a home, where nobody else has changed it since that revision. */
export function changeSaved(id: string, revision: number, texts: SavedTexts): Promise<SavedHead> {
  const headers = { ...JSON_TYPE, "If-Match": `"${revision}"` };
  return askFor(async (response) => (await response.json()) as SavedHead, path(id), { method: "PATCH", headers, body: JSON.stringify(texts) });
}

export function removeSaved(id: string, revision: number): Promise<void> {
  return askFor(async () => undefined, path(id), { method: "DELETE", headers: { "If-Match": `"${revision}"` } });
}

/** Gives a home the picture in a data URL. */
export async function pictureSaved(id: string, url: string): Promise<void> {
  const found = /^data:(image\/(?:png|jpeg|webp));base64,(.*)$/.exec(url);
  if (!found) return;
  const [, type, text] = found as unknown as [string, string, string];
  const body = new Blob([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))]);
  await askFor(async () => undefined, path(id, "/picture"), { method: "PUT", headers: { "Content-Type": type }, body });
}

/** A home's picture as a URL of this page's own, to be revoked when it is no longer shown. */
export function savedPicture(id: string): Promise<string> {
  return askFor(async (response) => URL.createObjectURL(await response.blob()), path(id, "/picture"), { headers: { Accept: "image/*" } });
}
