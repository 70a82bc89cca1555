/** What the page takes and sends: the service's own types (served.ts), and where the page knows more than they say. */
import type * as Served from "./served";

export type { Conflict, DragAnswer, Explained, FieldProblem, FloorAnswer, Hold, Level, OtherWay, RoomFloor, Sides } from "./served";
export type { Lines as ViewAnswer, Material as CatalogMaterial } from "./served";

/** A document of which some keys are never null: the service makes it so, or `drawable` has completed it. */
type Filled<Of, Keys extends keyof Of> = Omit<Of, Keys> & { readonly [Key in Keys]: NonNullable<Of[Key]> };
/** A document that may lack what can be null, as foreign ones do, and some keys besides. */
type Open<Of, Keys extends keyof Of = never> = {
  readonly [Key in keyof Of as null extends Of[Key] ? never : Key extends Keys ? never : Key]: Of[Key];
} & { readonly [Key in keyof Of as null extends Of[Key] ? Key : Key extends Keys ? Key : never]?: Of[Key] };

export type Side = keyof Served.Sides;
export type OpeningKind = Served.Opening["kind"];
export type PartForm = Served.Solid["form"];
export type PartAxis = Served.Solid["axis"];
export type Repair = Served.Conflict["repairs"][number];
export type Pose = Filled<Served.Pose, "rotation">;
export type Issue = Open<Served.Issue, "amount">;
export type Opening = Open<Served.Opening, "main_entrance" | "render_panel">;
/** What furniture, decorations and dynamic bodies share: a box by its footprint's centre and its underside. */
export type Body = Open<Pick<Served.Furniture, "id" | "x" | "y" | "z" | "rotation" | "width" | "depth" | "height" | "color">>;
export type Furniture = Open<Served.Furniture, "locked">;
export type Decoration = Open<Served.Decoration>;
export type Dynamic = Open<Filled<Served.Dynamic, "room">>;

interface Contents {
  readonly openings: readonly Opening[];
  readonly furniture: readonly Furniture[];
  readonly decorations: readonly Decoration[];
}
export type Room = Open<Omit<Filled<Served.Room, "flooring" | "accent" | "wall_flags">, keyof Contents>> & Contents;

/** How far fronts open, by piece and front: 1 or how much of their way, and what they meet then. */
export type FrontsSaid = Named<Named<number | { readonly opens?: number; readonly meets?: string | null }>>;

/** A piece that stands nowhere, and why. */
export interface LeftOut {
  readonly piece: string;
  readonly reason: string;
}

/** What a certificate says of a room. */
interface CertifiedRoom {
  readonly proven?: boolean;
  readonly fronts?: FrontsSaid;
  readonly left_out?: readonly LeftOut[];
  readonly notes?: readonly string[];
}

/** What a certificate says of the profile of access that a home is made for. */
interface CertifiedAccess {
  readonly profile?: string;
  readonly unmet?: readonly string[];
}

/** A scene that can be drawn; of its request and its certificate the page reads the style, what was proven and what fell short. */
export interface Scene extends Pick<Served.Scene, "wall_thickness" | "levels"> {
  readonly seed: number;
  readonly style?: string | null;
  readonly request?: { readonly style?: string | null; readonly decorate?: boolean | null } | null;
  readonly size: Served.Size;
  readonly rooms: readonly Room[];
  readonly dynamic: readonly Dynamic[];
  readonly certificate?: { readonly notes?: readonly string[]; readonly rooms?: Named<CertifiedRoom>; readonly access?: CertifiedAccess } | null;
}

type About<Answer> = Omit<Answer, "scene" | "issues" | "timing_ms"> & { readonly scene: Scene };
type Made<Answer> = About<Answer> & { readonly issues: readonly Issue[]; readonly timing_ms: number | Served.Generated["timing_ms"] };
export type GenerateAnswer = Made<Served.Generated>;
export type FurnishAnswer = Made<Served.FurnishedPlan>;
export type FixAnswer = Made<Served.Fixed>;
/** One way to stand a list of pieces in a room, and who is missing. */
interface Placement {
  readonly scene: Scene;
  readonly unplaced: Served.PlaceAnswer["unplaced"];
}
export type PlaceAnswer = Placement & { readonly alternatives: readonly Placement[] };
/** What a file was read as: its home, and what was changed, guessed and left out. */
export type ImportAnswer = Omit<Served.PlanImport, "scene" | "issues"> & { readonly scene: Scene; readonly issues: readonly Issue[] };
export type FixRequest = About<Served.FixBody>;
/** The page always asks for the report. */
export type ValidateAnswer = Omit<Served.ValidateAnswer, "report" | "metrics"> & { readonly report: Served.Lines };
/** A problem document, of which a proxy's may lack anything. */
export type ProblemDocument = Partial<Served.ProblemDocument>;

/** What a person typed: a number, or a text that is none, which is sent as typed for the service to judge. */
export type Typed = number | string;
/** How many rooms of each word (cars, for garages). */
export type Counts = Readonly<Record<string, Typed>>;
type AsTyped<Value> = Value extends number ? Typed : Value extends boolean ? boolean | string : Value extends Counts ? Counts : Value extends string ? string : Value;

/** A request of the service as it is typed; what is left out is the service's own default. */
export type HouseRequest = { seed: Typed } & { -readonly [Key in Exclude<keyof Served.Request, "seed">]?: AsTyped<NonNullable<Served.Request[Key]>> | undefined };

type Named<Thing> = Readonly<Record<string, Thing>>;
export type CatalogPart = Open<Served.Solid, "axis" | "taper">;
export type CatalogKind = Partial<Pick<Served.FurnitureSpec, "name" | "category" | "color" | "variants" | "stands">> & Pick<Served.FurnitureSpec, "size"> & {
  /** Of decorations, in place of a category. */
  readonly group?: string;
};

export type CatalogAsset = Pick<Served.Asset, "kinds" | "front" | "size" | "low" | "high" | "bytes" | "triangles" | "license">;

export interface CatalogRoom {
  readonly outdoor?: boolean;
  readonly accent: string;
  readonly flooring?: string;
  readonly home?: { readonly word?: string | null } | null;
  readonly pieces?: readonly { readonly piece: string; readonly kinds: readonly { readonly kind: string }[] }[];
}

/** What the page reads of the catalog. */
export interface Catalog {
  readonly furniture: Named<CatalogKind>;
  readonly decorations: Named<CatalogKind>;
  readonly shapes?: Named<readonly CatalogPart[]>;
  readonly assets?: Named<CatalogAsset>;
  readonly materials?: Named<Served.Material>;
  readonly styles?: Named<{ readonly palette?: Named<readonly string[]>; readonly materials?: Named<Partial<Served.Material>>; readonly walls?: Named<readonly Pick<Served.WallPaint, "type">[]> }>;
  readonly rooms?: Named<CatalogRoom>;
  readonly floorings?: Named<{ readonly color: string }>;
  readonly presets?: Named<Served.Preset>;
  readonly access?: Named<{ readonly description: string }>;
  readonly synonyms?: Named<{ readonly known_as?: readonly string[] }>;
}
