/** The wire: what the service takes and answers, in its own words. Lengths in metres, angles in degrees. */

export type Side = "north" | "south" | "east" | "west";
export type Sides = Readonly<Record<Side, boolean>>;

/** What a person typed: a number, or a text that is none, which is sent as typed for the service to judge. */
export type Typed = number | string;
/** How many rooms of each word (cars, for garages). */
export type Counts = Readonly<Record<string, Typed>>;

/** A request of the service; what is left out is the service's own default. */
export interface HouseRequest {
  seed: Typed;
  width?: Typed | undefined;
  depth?: Typed | undefined;
  min_room_size?: Typed | undefined;
  max_depth?: Typed | undefined;
  use_spine?: boolean | string | undefined;
  outdoor?: boolean | string | undefined;
  decorate?: boolean | string | undefined;
  program?: string | Counts | undefined;
  area?: Typed | undefined;
  style?: string | undefined;
  robot_width?: Typed | undefined;
  force_types?: Readonly<Record<string, string>> | undefined;
}

export type OpeningKind = "door" | "garage_door" | "passage" | "window";

export interface Opening {
  readonly id: string;
  readonly kind: OpeningKind;
  readonly wall?: Side | null;
  /** On a room with an outline: the edge from this outline point, in place of `wall`. */
  readonly edge?: number | null;
  /** The opening's centre, from the wall's west or north end. */
  readonly position: number;
  readonly width: number;
  readonly height: number;
  readonly sill: number;
  readonly connects_to?: string | null;
  readonly hinge?: "start" | "end" | null;
  readonly swing?: "in" | "out" | null;
  readonly main_entrance?: boolean;
  readonly render_panel?: boolean;
}

/** What furniture, decorations and dynamic bodies share: a box by its footprint's centre and its underside. */
export interface Body {
  readonly id: string;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly rotation: number;
  readonly width: number;
  readonly depth: number;
  readonly height: number;
  readonly color?: string | null;
}

export interface Furniture extends Body {
  readonly name: string;
  /** The catalog's key of what it is, chosen by the service: how it is drawn. */
  readonly kind?: string | null;
  readonly category?: string | null;
  /** The wall it stands at, where it must. */
  readonly wall?: Side | null;
  /** The id of the table it is tucked under, of the piece it stands on. */
  readonly under?: string | null;
  readonly on?: string | null;
  readonly locked?: boolean;
}

export interface Decoration extends Body {
  readonly name: string;
  readonly kind?: string | null;
  /** The id of what it lies on or belongs to. */
  readonly parent?: string | null;
  readonly mounted_on_wall?: string | null;
}

export interface Dynamic extends Body {
  readonly kind: string;
  readonly room: string;
  /** The id of the seat one sits on. */
  readonly on?: string | null;
}

export interface Room {
  readonly id: string;
  readonly index: number;
  readonly type: string;
  readonly level: number;
  readonly x: number;
  readonly z: number;
  readonly width: number;
  readonly depth: number;
  /** Clockwise from the north-west, room-relative, where the room is not its rectangle. */
  readonly outline?: readonly (readonly [number, number])[] | null;
  readonly outdoor: boolean;
  readonly flooring: { readonly type: string; readonly color: string };
  readonly accent: string;
  /** What its walls are finished with, on its side. */
  readonly walls?: { readonly type: string; readonly color: string } | null;
  readonly wall_flags: Sides;
  readonly openings: readonly Opening[];
  readonly furniture: readonly Furniture[];
  readonly decorations: readonly Decoration[];
}

export interface Level {
  readonly index: number;
  readonly elevation: number;
  readonly height: number;
}

export interface Scene {
  readonly seed: number;
  /** The style it was furnished in, and the request it answers, where they are known. */
  readonly style?: string | null;
  readonly request?: { readonly style?: string | null } | null;
  readonly size: { readonly width: number; readonly depth: number; readonly height: number };
  readonly wall_thickness: number;
  readonly levels: readonly Level[];
  readonly rooms: readonly Room[];
  readonly dynamic: readonly Dynamic[];
  /** What was proven of a generated scene, by room. */
  readonly certificate?: { readonly rooms?: Readonly<Record<string, { readonly proven?: boolean }>> };
}

export interface Issue {
  readonly rule: string;
  readonly severity: "error" | "warning";
  readonly room?: string | null;
  readonly ids: readonly string[];
  readonly amount?: number | null;
  readonly message: string;
}

export interface GenerateAnswer {
  readonly scene: Scene;
  readonly issues: readonly Issue[];
  readonly timing_ms: number | Readonly<Record<string, number>>;
}

export type Repair =
  | { readonly action: "move"; readonly id: string; readonly wall: null; readonly dx: number; readonly dz: number; readonly rotation: number }
  | { readonly action: "unlock"; readonly id: string; readonly dx: number; readonly dz: number; readonly rotation: number }
  | { readonly action: "turn"; readonly id: string; readonly rotation: number }
  | { readonly action: "shrink"; readonly id: string; readonly width: number; readonly depth: number }
  | { readonly action: "leave_out"; readonly id: string };

/** Bodies that cannot stand together, why, and what would help, cheapest first. */
export interface Conflict {
  readonly ids: readonly string[];
  readonly message: string;
  readonly repairs: readonly Repair[];
}

export interface Pose {
  readonly id: string;
  readonly x: number;
  readonly z: number;
  readonly rotation: number;
}

export interface FixRequest {
  readonly scene: Scene;
  readonly locked?: readonly string[];
  readonly moved?: readonly string[];
  readonly on_conflict?: "report" | "remove";
  /** The last answer's poses, while something is dragged. */
  readonly previous?: readonly Pose[];
}

export interface FixAnswer extends GenerateAnswer {
  readonly moves: readonly { readonly id: string; readonly dx: number; readonly dz: number; readonly rotation: number }[];
  readonly removed: readonly { readonly id: string; readonly reason: string }[];
  readonly conflicts: readonly Conflict[];
}

export type Rectangle = readonly [number, number, number, number];

/** A room's floor: what is clear of walls, kept free before doors and windows, and free to walk [x0, z0, x1, z1 in the room, m]. */
export interface RoomFloor {
  readonly room: string;
  readonly clear: Rectangle;
  readonly doors: readonly Rectangle[];
  readonly windows: readonly Rectangle[];
  readonly free: readonly Rectangle[];
}

export interface FloorAnswer {
  readonly rooms: readonly RoomFloor[];
}

/** The readable YAML and, for each of its lines, the body it speaks of. */
export interface ViewAnswer {
  readonly text: string;
  readonly lines: readonly (string | null)[];
}

export type PartForm = "box" | "rounded" | "cylinder" | "cone" | "ball" | "capsule";
export type PartAxis = "x" | "y" | "z";
export type Extent = readonly [number, number];

/** A part of a kind in shares of its box: x from the west, y from the underside, z from the back (north) at rotation 0. */
export interface CatalogPart {
  readonly form: PartForm;
  readonly x: Extent;
  readonly y: Extent;
  readonly z: Extent;
  readonly axis?: PartAxis | null;
  /** The radius at the axis' far end to that at its near end. */
  readonly taper?: number | null;
  readonly material: string;
}

/** What a slot of a shape is made of; without a colour it takes the body's own. */
export interface CatalogMaterial {
  readonly color?: string | null;
  /** Towards white (1) or black (-1). */
  readonly shade?: number | null;
  readonly roughness?: number | null;
  readonly metalness?: number | null;
  readonly opacity?: number | null;
  readonly glow?: number | null;
  readonly texture?: string | null;
}

export interface CatalogKind {
  /** What scenes call it; its key, where it has none. */
  readonly name?: string | null;
  readonly category?: string;
  readonly color?: string | null;
  readonly size: readonly [number, number, number];
}

type Named<Thing> = Readonly<Record<string, Thing>>;

export interface Catalog {
  readonly furniture: Named<CatalogKind>;
  readonly decorations: Named<CatalogKind>;
  readonly shapes?: Named<readonly CatalogPart[]>;
  readonly materials?: Named<CatalogMaterial>;
  readonly styles?: Named<{
    readonly materials?: Named<CatalogMaterial>;
    /** Finishes of walls, by the flooring that a room's type has. */
    readonly walls?: Named<readonly { readonly type: string }[]>;
  }>;
  readonly rooms?: Named<{
    readonly accent: string;
    /** What rooms of a type are in planned homes, and the word that counts them. */
    readonly home?: { readonly word?: string | null } | null;
  }>;
  readonly presets?: Named<{ readonly rooms: Readonly<Record<string, number>>; readonly says?: string }>;
}

/** The verdict on a scene; its report is text with, for each line, the body it speaks of. */
export interface ValidateAnswer {
  readonly issues: readonly Issue[];
  readonly report: ViewAnswer;
}

/** An RFC 9457 problem document, as the service writes it. */
export interface ProblemDocument {
  readonly type?: string;
  readonly title?: string;
  readonly status?: number;
  readonly detail?: string;
  readonly errors?: readonly FieldProblem[];
}

export interface FieldProblem {
  readonly field: string;
  readonly problem: string;
  /** What would be right; empty where there is nothing to say. */
  readonly allowed: string;
}
