/** New pieces: the palette, dragged into the house or put where they belong; and other arrangements of a room. */
import type { Catalog, Scene } from "../contract";
import { bodiesOf, styleOf } from "../house/frame";
import { roomHolding } from "../house/room_at";
import { placesFor } from "../service";
import type { Stage } from "../stage";
import type { Home } from "../state/home";
import { Plane, Vector3 } from "three";
import type { Editor } from "./editor";
import { Favourites } from "./favourites";
import { Palette } from "./palette";
import { PLACES, Places } from "./places";
import { added, moved, type FurnitureKind } from "./scene_edits";

type WindowPoint = { readonly x: number; readonly y: number };

/** A house with a piece that is not there yet. */
interface Wished {
  readonly scene: Scene;
  readonly id: string;
  readonly room: string;
}

export interface AddingWords {
  /** The room that is chosen, or that of what is chosen. */
  room(): string | undefined;
  /** The room in the middle of the view. */
  inView(): string | undefined;
  failed(reason: unknown, again: () => void): void;
}

/** The rooms of the types that the catalog furnishes with a kind, the largest first. */
export function roomsFor({ key }: Pick<FurnitureKind, "key">, { rooms }: Pick<Scene, "rooms">, types: Catalog["rooms"] = {}): string[] {
  const suits = (type: string): boolean => types[type]?.pieces?.some(({ piece, kinds }) => (kinds.length > 0 ? kinds.some(({ kind }) => kind === key) : piece === key)) ?? false;
  const size = ({ width, depth }: Pick<Scene["rooms"][number], "width" | "depth">): number => width * depth;
  return rooms.filter(({ type }) => suits(type)).sort((one, other) => size(other) - size(one)).map(({ id }) => id);
}

/** A kind in the colour that pieces like it have in a home: of its style's palette for it the one that the room has already, else others of its name, else any; else the first. */
export function inStyle(kind: FurnitureKind, scene: Scene | null, catalog: Catalog | null, roomId?: string): FurnitureKind {
  const style = scene && styleOf(scene);
  const palettes = (style && catalog?.styles && Object.hasOwn(catalog.styles, style) && catalog.styles[style]?.palette) || {};
  const named = [kind.key, kind.name, kind.category].find((name) => Object.hasOwn(palettes, name)) ?? "";
  const palette = palettes[named] ?? [];
  const alike = (scene?.rooms ?? []).flatMap(({ id, furniture }) => furniture
    .filter(({ color, category }) => category === kind.category && palette.includes(color ?? ""))
    .map(({ color, name }) => ({ color, rank: 2 * Number(id === roomId) + Number(name === kind.name) })));
  const [nearest] = alike.sort((one, other) => other.rank - one.rank);
  return { ...kind, color: nearest?.color ?? palette[0] ?? kind.color };
}

export class Adding {
  readonly #palette: Palette;
  readonly #places: Places;
  #isFilled = false;
  #style: string | null = null;
  #catalog: Catalog | null = null;

  constructor(readonly home: Home, readonly stage: Stage, readonly editor: Editor, hosts: { readonly palette: HTMLElement; readonly places: HTMLElement }, readonly say: AddingWords) {
    this.#palette = new Palette(hosts.palette, {
      favourites: new Favourites(),
      portray: (kind, into) => stage.portrayKind(inStyle(kind, home.scene, this.#catalog), into),
      over: (kind, at) => this.#preview(at && this.#wishedAt(kind, at)),
      drop: (kind, at) => this.#drop(kind, at),
    });
    this.#places = new Places(hosts.places, editor, (scene, room, kind, id, signal) => placesFor(scene, room, kind, id, PLACES, signal));
    this.#palette.onChoose = (kind) => this.#choose(kind);
    home.on("shown", (how) => {
      if (how === "live") return;
      this.#places.shown(home.scene);
      this.#restyled();
    });
  }

  /** Opens or closes the palette; asked for first, it is filled. */
  toggle(coming: () => Promise<Catalog>): void {
    this.#fill(coming);
    this.#palette.open(!this.#palette.isOpen);
  }

  #fill(coming: () => Promise<Catalog>): void {
    if (this.#isFilled) return;
    this.#isFilled = true;
    const known = coming();
    known.then((catalog) => { this.#catalog = catalog; }, () => undefined); // said below
    this.#palette.await(known).catch((reason: unknown) => {
      this.#isFilled = false;
      this.say.failed(reason, () => this.#fill(coming));
    });
  }

  /** Offers no other places any more. Tells whether any were. */
  hide(): boolean {
    return this.#places.hide();
  }

  /** Pictures are of the style that is shown. */
  #restyled(): void {
    const style = this.home.scene && styleOf(this.home.scene);
    if (style !== this.#style) this.#palette.portrayAnew();
    this.#style = style;
  }

  #choose(kind: FurnitureKind): void {
    const chosen = this.say.room();
    const [first, ...others] = chosen === undefined ? this.#roomsFor(kind) : [chosen];
    this.#palette.open(false);
    if (first !== undefined) this.#places.add([first, ...others], inStyle(kind, this.home.scene, this.#catalog, first));
  }

  /** Where nothing is chosen: the rooms of the types that the catalog has such a kind in, that in view first; where there are none, the one in view. */
  #roomsFor(kind: FurnitureKind): readonly string[] {
    const [seen, scene] = [this.say.inView(), this.home.scene];
    const suited = scene ? roomsFor(kind, this.stage.storeys.planned(scene), this.#catalog?.rooms) : [];
    const any = seen ?? scene?.rooms[0]?.id;
    if (suited.length === 0) return any === undefined ? [] : [any];
    return suited.sort((one, other) => Number(other === seen) - Number(one === seen));
  }

  /** A new piece on the floor under a point of the window; null where there is none. */
  #wishedAt(kind: FurnitureKind, at: WindowPoint): Wished | null {
    const scene = this.home.settled?.scene;
    const { storeys } = this.stage;
    const floor = new Plane(new Vector3(0, 1, 0), scene ? -storeys.riseIn(scene) : 0);
    const spot = this.stage.viewport.rayAt(at.x, at.y).ray.intersectPlane(floor, new Vector3());
    const under = document.elementFromPoint(at.x, at.y);
    const room = scene && spot && under === this.stage.viewport.canvas ? roomHolding(scene.rooms, storeys.chosen, spot.x, spot.z) : undefined;
    if (!scene || !spot || !room) return null;
    const made = added(scene, room.id, inStyle(kind, scene, this.#catalog, room.id));
    return { id: made.id, room: room.id, scene: moved(made.scene, made.id, { x: spot.x - room.x, z: spot.z - room.z, rotation: 0 }) };
  }

  #preview(wished: Wished | null): void {
    this.stage.house?.frame("settles", wished ? bodiesOf(wished.scene).filter(({ id }) => id === wished.id) : []);
    this.stage.viewport.invalidate();
  }

  #drop(kind: FurnitureKind, at: WindowPoint): void {
    const wished = this.#wishedAt(kind, at);
    this.#preview(null);
    if (!wished) return;
    this.#palette.open(false);
    this.#places.hide();
    this.editor.change(() => ({ ...wished, moved: [wished.id], chosen: [wished.id] }));
  }
}
