/** Links that hold a home's changes, and homes from such links. */
import { queryFromRequest } from "../address";
import type { GenerateAnswer, HouseRequest, Scene } from "../contract";
import { ServiceProblem } from "../service";
import type { Shown } from "../state/home";
import { changeBetween, changed } from "./changes";
import { markOf, packed, unpacked } from "./packing";

/** Longer links are cut by mail and chat programs. Our choice. */
export const LONGEST_LINK = 8000;
const KEY = "#changes=";

export type Make = (request: HouseRequest) => Promise<Pick<GenerateAnswer, "scene">>;

/** A link, and how long one that held all would be; `isWhole`: what is shown opens from it, changes and all. */
export interface Found {
  readonly link: string;
  readonly isWhole: boolean;
  readonly length: number;
}

/** The link to a home; one that was changed is compared with what its request makes. */
export async function linkTo(shown: Shown, made: HouseRequest, isEdited: boolean, base: string, make: Make): Promise<Found> {
  const plain = new URL(queryFromRequest(made), base).href;
  if (!isEdited) return { link: plain, isWhole: true, length: plain.length };
  const { scene } = await make(made);
  const change = changeBetween(scene, shown.scene);
  const link = change ? `${plain}${KEY}${await packed({ of: markOf(scene), change })}` : plain;
  const isWhole = link.length <= LONGEST_LINK;
  return { link: isWhole ? link : plain, isWhole, length: link.length };
}

/** What a link's fragment carries; null where it carries no changes. */
export function carriedIn(fragment: string): string | null {
  return fragment.startsWith(KEY) ? fragment.slice(KEY.length) : null;
}

/** The scene that a link's changes make of the home of its request, for the service to read. Throws a ServiceProblem. */
export async function carriedTo(text: string, made: Scene): Promise<unknown> {
  const said = await unpacked(text).catch(() => null);
  if (!said) throw new ServiceProblem("The link is damaged", "The home is shown as it was made, without the changes that the link was to bring. Ask for it again, or for a file.");
  if (said.of !== markOf(made)) {
    throw new ServiceProblem("The link is of another version", "The service makes this home otherwise than when the link was made. It is shown without the changes: ask for a file of it.");
  }
  try {
    return changed(made, said.change);
  } catch {
    throw new ServiceProblem("The link is damaged", "Its changes are not of this home, which is shown without them.");
  }
}
