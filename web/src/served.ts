/** What the service takes and answers; `python -m scripts.contract` writes it. Lengths in metres, angles in degrees. */

/** An asset that was measured. */
export interface Asset {
  readonly kinds: readonly string[];
  readonly front: "+z" | "-z" | "+x" | "-x";
  readonly size: readonly [number, number, number];
  readonly low: readonly [number, number, number];
  readonly high: readonly [number, number, number];
  readonly surfaces: readonly number[];
  readonly mass: number | null;
  readonly license: string;
  readonly source: string;
  readonly author: string;
  readonly guessed: readonly string[];
  readonly bytes: number;
  readonly triangles: number;
}

/** The door that was chosen as the main entrance of a home that had none, and its room. */
export interface ChosenEntrance {
  readonly id: string;
  readonly room: string;
  readonly message: string;
}

/** Floor at a side of a piece that is better kept free: `depth` m, all but `behind` m. */
export interface Comfort {
  readonly depth: number;
  readonly behind?: number;
  readonly cost?: number;
}

/** Bodies that cannot stand together, why, and what would help. */
export interface Conflict {
  readonly ids: readonly string[];
  readonly message: string;
  readonly repairs: readonly (Freed | Unlocked | Turned | Shrunk | LeftOut)[];
}

/** A small thing. */
export interface Decoration {
  /** made up where it is absent, alike each time */
  readonly id: string;
  /** such as pillow */
  readonly name: string;
  /** id of the body that carries it */
  readonly parent: string | null;
  /** the wall it hangs at */
  readonly mounted_on_wall: "north" | "south" | "east" | "west" | null;
  /** centre of its footprint in the room, m */
  readonly x: number;
  /** the surface it rests on, m */
  readonly y: number;
  /** centre of its footprint in the room, m */
  readonly z: number;
  /** degrees; 0 faces south, 90 east */
  readonly rotation: number;
  /** across its front, unrotated, m */
  readonly width: number;
  /** from front to back, unrotated, m */
  readonly depth: number;
  /** m */
  readonly height: number;
  /** #rrggbb */
  readonly color: string | null;
  /** the catalogs' key of what it is, as for furniture */
  readonly kind?: string | null;
  /** the own asset that it is shown as */
  readonly asset?: string | null;
}

/** The room prepared for the core (base64), and all that is in it in the order of a frame; null where /fix has to be asked instead. */
export interface DragAnswer {
  readonly opening: string | null;
  readonly bodies: readonly string[];
}

/** A person or a pet. */
export interface Dynamic {
  /** made up where it is absent, alike each time */
  readonly id: string;
  /** person, dog, cat or any word */
  readonly kind: string;
  /** the room's id */
  readonly room: string | null;
  /** centre of the footprint in that room, m */
  readonly x: number;
  /** the underside, m */
  readonly y: number;
  /** centre of the footprint in that room, m */
  readonly z: number;
  /** where they look, degrees; 0 faces south, 90 east */
  readonly rotation: number;
  /** from left to right, m */
  readonly width: number;
  /** from front to back, m */
  readonly depth: number;
  /** m; of who sits, from the seat up */
  readonly height: number;
  /** #rrggbb */
  readonly color?: string | null;
  /** id of the seat they sit on */
  readonly on?: string | null;
}

/** Why a piece stands where it does: where it was wished, what holds it back from there, and how else it could stand. */
export interface Explained {
  readonly id: string;
  readonly room: string;
  /** x, z of the footprint's centre in the room, m */
  readonly stands: readonly [number, number];
  readonly wished: readonly [number, number] | null;
  readonly holds: readonly Hold[];
  readonly notes: readonly string[];
  readonly ways: readonly OtherWay[];
}

/** A format that /export writes: what it is, and whether its library is installed here. */
export interface ExportFormat {
  readonly name: string;
  readonly words: string;
  readonly available: boolean;
}

/** The formats that /export writes. */
export interface ExportFormats {
  readonly formats: readonly ExportFormat[];
}

/** A field that is wrong: where, how, and what would be right (empty where there is nothing to say). */
export interface FieldProblem {
  readonly field: string;
  readonly problem: string;
  readonly allowed: string;
}

/** Repairs a scene. */
export interface FixBody {
  /** a scene, as GET /schema describes it */
  readonly scene: Scene;
  /** ids */
  readonly locked?: readonly string[] | null;
  /** ids */
  readonly moved?: readonly string[] | null;
  /** what becomes of what cannot stand */
  readonly on_conflict?: "report" | "remove" | null;
  /** poses of the last answer */
  readonly previous?: readonly Pose[] | null;
  /** whether this is a frame of a drag */
  readonly dragging?: boolean | null;
  /** how much work the call may do */
  readonly effort?: "quick" | "normal" | "thorough" | null;
}

/** The answer of fix. */
export interface Fixed {
  readonly scene: Scene;
  readonly moves: readonly Move[];
  readonly removed: readonly Removal[];
  readonly conflicts: readonly Conflict[];
  readonly issues: readonly Issue[];
  readonly timing_ms: Readonly<Record<string, number>>;
  readonly understood_as: Readonly<Record<string, string>>;
  readonly limited?: Limited | null;
}

/** The floor of rooms. */
export interface FloorAnswer {
  readonly rooms: readonly RoomFloor[];
}

/** What the floor is made of. */
export interface Flooring {
  /** a name of catalogs/floorings.yaml */
  readonly type: string;
  /** #rrggbb */
  readonly color: string;
}

/** A repair: `wall` becomes null, for the body need not stand at one; /fix then moves it. */
export interface Freed {
  /** "move" */
  readonly action: "move";
  /** of the body */
  readonly id: string;
  /** null */
  readonly wall: null;
  /** how far it then goes, m */
  readonly dx: number;
  /** how far it then goes, m */
  readonly dz: number;
  /** that it then has, degrees */
  readonly rotation: number;
}

/** The answer of furnish: the scene, what was guessed, which rooms could not be furnished and why, issues, and stage times in ms. */
export interface FurnishedPlan {
  readonly scene: Scene;
  readonly guesses: readonly RoomGuess[];
  readonly entrance: ChosenEntrance | null;
  /** by room id, why a room that was asked for was left as it was */
  readonly left: Readonly<Record<string, string>>;
  readonly issues: readonly Issue[];
  readonly timing_ms: Readonly<Record<string, number>>;
  readonly limited?: Limited | null;
}

/** A piece of furniture. */
export interface Furniture {
  /** made up where it is absent, alike each time */
  readonly id: string;
  /** such as sofa; all its sizes have this name */
  readonly name: string;
  /** such as seating */
  readonly category: string | null;
  /** centre of its footprint in the room, m */
  readonly x: number;
  /** its underside, m */
  readonly y: number;
  /** centre of its footprint in the room, m */
  readonly z: number;
  /** degrees; 0 faces south, 90 east */
  readonly rotation: number;
  /** across its front, unrotated, m */
  readonly width: number;
  /** from front to back, unrotated, m */
  readonly depth: number;
  /** m */
  readonly height: number;
  /** #rrggbb */
  readonly color: string | null;
  /** the wall it must stand at */
  readonly wall: "north" | "south" | "east" | "west" | null;
  /** id of the table it is tucked under */
  readonly under: string | null;
  /** id of the piece it stands on */
  readonly on: string | null;
  /** whether it stays where it is */
  readonly locked: boolean;
  /** the catalogs' key of what it is; without it, of the kinds called `name` the one nearest in size */
  readonly kind?: string | null;
  /** the own asset that it is shown as */
  readonly asset?: string | null;
}

/** One kind of furniture. `stands: wall` means that its back is 3 cm from a wall's face. */
export interface FurnitureSpec {
  readonly shape?: string | null;
  readonly size: readonly [number, number, number];
  /** a colour, #rrggbb in small letters */
  readonly color: string;
  readonly variants?: readonly string[];
  readonly surfaces?: readonly Surface[];
  readonly friction?: "low" | "medium" | "high";
  readonly moves?: "free" | "fixed" | null;
  readonly labels?: readonly string[];
  readonly category: "bed" | "seating" | "table" | "storage" | "appliance" | "bathroom" | "lighting" | "decor" | "electronics" | "vehicle" | "structure" | "water" | "dynamic" | "misc";
  readonly name?: string | null;
  readonly mass: number;
  readonly stands: "wall" | "free";
  readonly use?: Use | null;
  readonly comfort?: Readonly<Record<string, Comfort>>;
}

/** The answer of generate: the scene, what the validator says, and stage times in ms. */
export interface Generated {
  readonly scene: Scene;
  readonly issues: readonly Issue[];
  readonly timing_ms: Readonly<Record<string, number>>;
  readonly limited?: Limited | null;
}

/** What became of one relation: the piece's id, the relation, what it was to (None: the room), and whether it is held. */
export interface Held {
  readonly piece: string;
  readonly type: string;
  readonly of: string | null;
  readonly held: boolean;
}

/** What keeps a piece from going on in one direction, and what a metre more room there would save. */
export interface Hold {
  readonly by: string | null;
  readonly what: "wall" | "piece" | "use_side" | "door" | "window" | "outline" | "floor" | "way" | "relation";
  readonly towards: "north" | "east" | "south" | "west";
  readonly cost_per_m: number;
  readonly message: string;
}

/** A home that is kept, without its scene; `revision` counts every change, `version` those of the scene. Times are of RFC 3339, UTC. */
export interface HomeHead {
  readonly id: string;
  readonly name: string;
  readonly notes: string;
  readonly tags: readonly string[];
  /** when it was kept first */
  readonly created: string;
  /** when it was changed last */
  readonly changed: string;
  readonly revision: number;
  readonly version: number;
  /** how many rooms it has */
  readonly rooms: number;
  /** opens it on the page, relative to the service's address */
  readonly link: string;
}

/** One page of homes, the last changed first; how many there are in all; and what asks for the next page, null on the last one. */
export interface HomeList {
  readonly homes: readonly HomeHead[];
  readonly total: number;
  readonly after: string | null;
}

/** A version of a home. */
export interface HomeVersion {
  readonly number: number;
  /** when, RFC 3339, UTC */
  readonly made: string;
}

/** The versions of a home that are kept, the last first. */
export interface HomeVersions {
  readonly versions: readonly HomeVersion[];
}

/** A home that is kept, with its scene. */
export interface HomeWithScene {
  readonly id: string;
  readonly name: string;
  readonly notes: string;
  readonly tags: readonly string[];
  /** when it was kept first */
  readonly created: string;
  /** when it was changed last */
  readonly changed: string;
  readonly revision: number;
  readonly version: number;
  /** how many rooms it has */
  readonly rooms: number;
  /** opens it on the page, relative to the service's address */
  readonly link: string;
  readonly scene: Scene;
}

/** Something that is not as it was drawn: in which step, of what (a room's or opening's id, or `plan`), by how much, m. */
export interface ImportChange {
  readonly step: string;
  readonly of: string;
  readonly amount: number;
  readonly message: string;
}

/** Something that the file does not say: of what (an id, or `plan`), which key, what was taken. */
export interface ImportGuess {
  readonly of: string;
  readonly what: string;
  readonly taken: string;
  readonly message: string;
}

/** One broken rule: its name, the room's id, the ids of the bodies, and by how much, m. */
export interface Issue {
  readonly rule: string;
  readonly severity: "error" | "warning";
  readonly room: string | null;
  readonly ids: readonly string[];
  readonly amount: number;
  readonly message: string;
}

/** A job: `done` of its `count` calls have been made, of which `refused` were refused. */
export interface JobHead {
  readonly id: string;
  readonly call: string;
  readonly state: "waiting" | "running" | "done";
  readonly count: number;
  readonly done: number;
  readonly refused: number;
  /** RFC 3339, UTC */
  readonly created: string;
  /** RFC 3339, UTC */
  readonly changed: string;
}

/** Jobs, the newest first. */
export interface JobList {
  readonly jobs: readonly JobHead[];
}

/** A repair: the scene without the body. */
export interface LeftOut {
  /** "leave_out" */
  readonly action: "leave_out";
  /** of the body */
  readonly id: string;
}

/** One storey. */
export interface Level {
  /** what a room's `level` names */
  readonly index: number;
  /** height of its floor, m */
  readonly elevation: number;
  /** of the storey, m */
  readonly height: number;
}

/** The limit of the call's work ended a search: what stands is sound, but more may be found with more work. */
export interface Limited {
  readonly effort: string;
  readonly work: number;
  readonly message: string;
}

/** Text, and for each of its lines the id of the body it speaks of, or null. */
export interface Lines {
  readonly text: string;
  readonly lines: readonly (string | null)[];
}

/** How a slot looks. `color: null` is the body's own colour; `shade` makes it darker (to -1) or lighter (to 1). */
export interface Material {
  readonly color?: string | null;
  readonly shade?: number;
  readonly roughness?: number;
  readonly metalness?: number;
  readonly opacity?: number;
  readonly glow?: number;
  readonly texture?: "wood" | "fabric" | "metal" | "tile" | "concrete" | "stone" | "grass" | "deck" | "leather" | "plaster" | "brick" | null;
}

/** How far /fix moved a body, m, and the rotation it has now, degrees. */
export interface Move {
  readonly id: string;
  readonly dx: number;
  readonly dz: number;
  readonly rotation: number;
}

/** How a piece would stand: its footprint's centre in the room, m, its rotation, degrees, and its kind, perhaps another size of it. */
export interface MovedPiece {
  readonly id: string;
  readonly kind: string;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly rotation: number;
  readonly width: number;
  readonly depth: number;
  readonly height: number;
  readonly on: string | null;
}

/** A door, garage door, passage or window in a wall. Both rooms of a door list it under one id. */
export interface Opening {
  /** made up where it is absent, alike each time */
  readonly id: string;
  /** a passage has no leaf */
  readonly kind: "door" | "garage_door" | "passage" | "window";
  /** the wall it is in */
  readonly wall: "north" | "south" | "east" | "west" | null;
  /** its centre along the wall, from the west or north end, m */
  readonly position: number;
  /** along the wall, m */
  readonly width: number;
  /** from its lower edge up, m */
  readonly height: number;
  /** height of its lower edge, m */
  readonly sill: number;
  /** the other room's id, or EXTERIOR */
  readonly connects_to: string | null;
  /** which end of it carries the leaf; start is west or north */
  readonly hinge: "start" | "end" | null;
  /** in: the leaf sweeps the floor of the room that lists it */
  readonly swing: "in" | "out" | null;
  /** whether it is the front door */
  readonly main_entrance: boolean;
  /** whether a leaf is drawn */
  readonly render_panel: boolean;
  /** in a room with an outline the line from that point to the next, in place of `wall` */
  readonly edge?: number | null;
  /** how far its leaf stands open, 0 to 1; of the two entries that of the room that draws the leaf counts */
  readonly open?: number | null;
}

/** Another way to stand: at which wall and how it is turned, and what the room would have cost more with it; null: it could not. */
export interface OtherWay {
  readonly wall: "north" | "east" | "south" | "west" | null;
  readonly rotation: number;
  readonly cost: number | null;
  readonly moves: readonly MovedPiece[];
  readonly left_out: readonly string[];
  readonly message: string;
}

/** The best placement, the others by rank, why required pieces are missing, issues, and stage times in ms. */
export interface PlaceAnswer {
  readonly scene: Scene;
  readonly relations: readonly Held[];
  readonly unplaced: readonly Unplaced[];
  readonly alternatives: readonly Placement[];
  readonly conflicts: readonly Conflict[];
  readonly issues: readonly Issue[];
  readonly timing_ms: Readonly<Record<string, number>>;
  readonly understood_as: Readonly<Record<string, string>>;
  readonly limited?: Limited | null;
}

/** One placement: the scene, which relations it holds, who is missing, what the relations it misses are worth, and issues. */
export interface Placement {
  readonly scene: Scene;
  readonly relations: readonly Held[];
  readonly unplaced: readonly Unplaced[];
  readonly cost: number;
  readonly issues: readonly Issue[];
}

/** A foreign plan as a scene; `format` is what the file was read as. */
export interface PlanImport {
  readonly scene: Scene;
  readonly format: string;
  readonly changes: readonly ImportChange[];
  readonly guesses: readonly ImportGuess[];
  readonly unread: readonly Unread[];
  readonly issues: readonly Issue[];
  readonly understood_as: Readonly<Record<string, string>>;
}

/** Where a body was in the last answer of /fix. */
export interface Pose {
  /** of the body */
  readonly id: string;
  /** its footprint's centre in its room, m */
  readonly x: number;
  /** its footprint's centre in its room, m */
  readonly z: number;
  /** degrees */
  readonly rotation?: number | null;
}

/** A named programme: how many rooms of each word (cars, for garages), and what it is, in words. */
export interface Preset {
  readonly rooms: Readonly<Record<string, number>>;
  readonly description?: string;
}

/** An RFC 9457 problem document. */
export interface ProblemDocument {
  readonly type: string;
  readonly title: string;
  readonly status: number;
  readonly detail: string;
  readonly errors: readonly FieldProblem[];
}

/** A body that was taken out, and why. */
export interface Removal {
  /** of the body */
  readonly id: string;
  /** the rule that it broke, or what keeps it from standing there, in words */
  readonly reason: string;
}

/** What to generate; all optional. Unknown keys are refused. */
export interface Request {
  /** drawn where there is none */
  readonly seed?: number | null;
  /** m, 20 unless a programme or an area chooses it */
  readonly width?: number | null;
  /** m, 15 unless a programme or an area chooses it */
  readonly depth?: number | null;
  /** m, at most the house's shorter side */
  readonly min_room_size?: number | null;
  /** how often the rectangle is split */
  readonly max_depth?: number | null;
  /** whether a rectangle that is cut has a hallway */
  readonly use_spine?: boolean | null;
  /** whether a garden or the like lies around the house */
  readonly outdoor?: boolean | null;
  /** whether surfaces, walls and floors are decorated */
  readonly decorate?: boolean | null;
  /** room types by the room's index */
  readonly force_types?: Readonly<Record<string, string>> | null;
  /** side of the square that must be able to walk everywhere, m */
  readonly robot_width?: number | null;
  /** a preset's name, or how many rooms of each word */
  readonly program?: string | Readonly<Record<string, number>> | null;
  /** wished floor of the house, m2 */
  readonly area?: number | null;
  /** the name of a style */
  readonly style?: "classic" | "industrial" | "mid_century" | "modern" | "rustic" | "scandi" | null;
  /** of a planned home, any by default; or of any home its corners, m */
  readonly outline?: "rectangle" | "L" | "T" | "U" | "any" | readonly (readonly [number, number])[] | null;
  /** a profile of access.yaml, or none */
  readonly access?: "none" | "ada" | "din_18040_2" | "din_18040_2_r" | null;
  /** whether people and pets are in it */
  readonly people?: boolean | null;
  /** of inner walls, m; 0.1 by default */
  readonly wall_thickness?: number | null;
  /** of outer walls, m; as inner ones by default */
  readonly outer_wall_thickness?: number | null;
}

/** A room: its wall lines' rectangle in the house, and everything in it, relative to its north-west corner. */
export interface Room {
  /** made up where it is absent, alike each time */
  readonly id: string;
  /** what `adjacency` and seeds call it; its place in the list by default */
  readonly index: number;
  /** a room type, or any word */
  readonly type: string;
  /** the storey it is on */
  readonly level: number;
  /** its north-west corner in the house, m */
  readonly x: number;
  /** its north-west corner in the house, m */
  readonly z: number;
  /** of its wall lines' rectangle, from west to east, m */
  readonly width: number;
  /** of its wall lines' rectangle, from north to south, m */
  readonly depth: number;
  /** its corners, m, clockwise from the north-west, where it is not that rectangle */
  readonly outline: readonly (readonly [number, number])[] | null;
  /** whether it is a garden or the like */
  readonly outdoor: boolean;
  /** material and colour of its floor */
  readonly flooring: Flooring | null;
  /** its own colour, #rrggbb */
  readonly accent: string | null;
  /** what its walls are finished with */
  readonly walls?: WallFinish | null;
  /** of its outer walls by line of the outline, north first, m; null where it is the scene's */
  readonly wall_thickness?: readonly (number | null)[] | null;
  /** which walls are outer walls, wholly or in part */
  readonly exterior_walls: Sides | null;
  /** which walls it draws; of a shared wall one room does */
  readonly wall_flags: Sides | null;
  /** doors, passages and windows */
  readonly openings: readonly Opening[];
  /** its pieces */
  readonly furniture: readonly Furniture[];
  /** small things */
  readonly decorations: readonly Decoration[];
  /** what people call it, where they do */
  readonly name?: string | null;
}

/** A room's floor: what is clear of walls, kept free before doors and windows, and free to come to. */
export interface RoomFloor {
  readonly room: string;
  /** west, north, east, south edge in the room, m */
  readonly clear: readonly [number, number, number, number];
  readonly doors: readonly (readonly [number, number, number, number])[];
  readonly windows: readonly (readonly [number, number, number, number])[];
  readonly free: readonly (readonly [number, number, number, number])[];
  readonly turning: readonly (readonly [number, number, number, number])[];
  readonly short: readonly (readonly [number, number, number, number])[];
}

/** The type that a room was given: what it was called, what told the type, and the type that would suit it next, if any. */
export interface RoomGuess {
  readonly room: string;
  readonly type: string;
  readonly by: "name" | "pieces" | "form";
  readonly sent: string;
  /** the room type that suits next best, where the room's form told the type */
  readonly instead: string | null;
  readonly message: string;
}

/** A whole house: the document of /generate, /fix and /validate. */
export interface Scene {
  /** the only one there is */
  readonly format: "compose-scene/1";
  /** what the home was drawn from */
  readonly seed: number | null;
  /** everything it takes to make this home again */
  readonly request: Readonly<Record<string, unknown>> | null;
  /** the version of Compose and the mark of its catalogs: a seed means something with these two only */
  readonly generator: Readonly<Record<string, unknown>> | null;
  /** outer extents of the house, or of the least rectangle around it */
  readonly size: Size | null;
  /** of the walls, m */
  readonly wall_thickness: number;
  /** storeys */
  readonly levels: readonly Level[];
  /** what the house has */
  readonly rooms: readonly Room[];
  /** of homes that were cut without a hallway: for information only */
  readonly corridors: readonly (Readonly<Record<string, unknown>>)[];
  /** pairs of rooms, by index, with a common wall long enough for a door; the certificate's `unjoined` are those of them, by id, that no door or passage joins */
  readonly adjacency: readonly (readonly [number, number])[];
  /** people and pets */
  readonly dynamic: readonly Dynamic[];
  /** what was checked and proven */
  readonly certificate: Readonly<Record<string, unknown>> | null;
}

/** A repair: another size. */
export interface Shrunk {
  /** "shrink" */
  readonly action: "shrink";
  /** of the body */
  readonly id: string;
  /** across its front, m */
  readonly width: number;
  /** from its front to its back, m */
  readonly depth: number;
}

/** A yes or no for each of a room's four walls. */
export interface Sides {
  /** whether it is so of that wall */
  readonly north: boolean;
  /** whether it is so of that wall */
  readonly south: boolean;
  /** whether it is so of that wall */
  readonly east: boolean;
  /** whether it is so of that wall */
  readonly west: boolean;
}

/** Outer extents of the house, m. */
export interface Size {
  /** from west to east */
  readonly width: number;
  /** from north to south */
  readonly depth: number;
  /** of the building */
  readonly height: number;
}

/** One solid of a kind's shape: a part with its surfaces' names turned into numbers, every mirror image written out. */
export interface Solid {
  readonly form: "box" | "rounded" | "cylinder" | "cone" | "ball" | "capsule";
  readonly x: readonly [number, number];
  readonly y: readonly [number, number];
  readonly z: readonly [number, number];
  readonly axis: "x" | "y" | "z";
  readonly taper: number;
  readonly material: string;
  readonly front?: string | null;
  readonly opens?: "left" | "right" | "up" | "down" | "lid" | "drawer" | null;
  readonly range?: number;
  readonly must_open?: boolean;
  readonly board?: number | null;
}

/** A surface that carries things. */
export interface Surface {
  readonly name: string;
  readonly height: number;
  readonly inset?: number;
  readonly clearance?: number | null;
}

/** A repair: another rotation. */
export interface Turned {
  /** "turn" */
  readonly action: "turn";
  /** of the body */
  readonly id: string;
  /** the other one, degrees */
  readonly rotation: number;
}

/** A repair: the body is unlocked; /fix then moves it. */
export interface Unlocked {
  /** "unlock" */
  readonly action: "unlock";
  /** of the body */
  readonly id: string;
  /** how far it then goes, m */
  readonly dx: number;
  /** how far it then goes, m */
  readonly dz: number;
  /** that it then has, degrees */
  readonly rotation: number;
}

/** A piece that is not in the scene, and why. */
export interface Unplaced {
  readonly id: string;
  readonly reason: string;
}

/** Something that was left out: its place in the file, and why. */
export interface Unread {
  readonly place: string;
  readonly reason: string;
}

/** Who uses a piece must get to these sides: `any` one of them, or `all`. */
export interface Use {
  readonly sides: readonly ("front" | "back" | "left" | "right")[];
  readonly need?: "any" | "all";
}

/** What breaks which rule and by how much, measures, and where wanted the whole scene in words, and what a profile of access asks. */
export interface ValidateAnswer {
  readonly issues: readonly Issue[];
  readonly metrics: Readonly<Record<string, unknown>>;
  readonly understood_as: Readonly<Record<string, string>>;
  readonly report?: Lines | null;
  readonly access?: Readonly<Record<string, unknown>> | null;
  readonly misspelt?: Readonly<Record<string, string>> | null;
}

/** What a room's walls are finished with on its side. */
export interface WallFinish {
  /** such as plaster */
  readonly type: string;
  /** #rrggbb */
  readonly color: string;
}

/** The finish of a room's walls and its colour. */
export interface WallPaint {
  readonly type: "plaster" | "wallpaper" | "wood" | "brick" | "concrete" | "tile";
  /** a colour, #rrggbb in small letters */
  readonly color: string;
}
